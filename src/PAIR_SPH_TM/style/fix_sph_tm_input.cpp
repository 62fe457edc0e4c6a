/* SPH-TM: fix sph/tm, its keywords and fix_modify. See doc/fix_sph_tm.rst. */
#include "fix_sph_tm.h"

#include "accuracy_meter.h"
#include "argument.h"
#include "model.h"

#include "comm.h"
#include "error.h"
#include "group.h"
#include "update.h"
#include "utils.h"

#include <cstring>

using namespace LAMMPS_NS;
using namespace SPHTM_NS;

// audit yes | no | N M; false: none
static bool read_audit(Keywords &k, int &every, int &sample)
{
  k.need(1);
  if (utils::is_integer(k.ahead(0)) || (k.ahead(1) && utils::is_integer(k.ahead(1)))) {
    k.need(2);
    every = k.integer(1, 1000000000, "N");
    sample = k.integer(1, 1000000, "M");
    return true;
  }
  every = AccuracyMeter::EVERY;
  sample = AccuracyMeter::SAMPLE;
  return k.yes();
}

// auto, or an effect and on or off
static void read_effect(LAMMPS *lmp, Keywords &k, EffectPlan &plan)
{
  k.need(1);
  if (k.take("auto")) return;
  k.need(2);
  const char *name = k.value();
  const unsigned bit = effect_by_name(name);
  if (!bit) lmp->error->all(FLERR, "Unknown fix sph/tm effect {}: known are {}", name, effect_names());
  plan.force(bit, k.on(name));
}

// what fix_modify can change too
bool FixSPHTM::read_setting(Keywords &k)
{
  TimeStep &step = state.time_step();
  if (k.is("courant")) {
    const double courant = k.within(0.0, 1.0);
    if (courant > TimeStep::COURANT_WARNED && comm->me == 0)
      error->warning(FLERR, "{}: above {} runs have become unstable", k.what(), TimeStep::COURANT_WARNED);
    step.set_courant(courant);
  } else if (k.is("dt")) step.set_fixed(k.take("auto") ? 0.0 : k.positive());
  else if (k.is("dt/max")) step.set_most(k.positive());
  else if (k.is("conduction")) {
    const bool stages = k.second("explicit", "rkl2");
    step.set_conduction(stages, stages && k.number_ahead() ? k.positive() : TimeStep::HEAT_TOLERANCE);
  } else if (k.is("lost")) stop_on_lost = !k.second("error", "ignore");
  else if (k.is("temperature/max")) stops.set_hottest(k.positive());
  else if (k.is("density/max")) {
    const double densest = k.positive();
    stops.set_densest(densest);
    if (densest <= 1.0) error->all(FLERR, "{} must be above 1, got {}", k.what(), k.given());
  } else if (k.is("energy/drift")) energies.set_drift_allowed(k.take("none") ? 1e300 : k.positive());
  else return false;
  return true;
}

void FixSPHTM::read_keywords(Keywords &&k)
{
  bool balance = false;
  while (k.next()) {
    if (k.is("temperature")) state.start_temperatures().set_all(k.positive());
    else if (read_setting(k)) continue;
    else if (k.is("time/scale")) {
      scene->set_time_scale(k.positive());
      if (scene->time_scale() != 1.0 && comm->me == 0)
        utils::logmesg(
            lmp,
            "sph/tm: time/scale {0:.6g}: the run is {0:.6g} times as fast as the process. Powers (of tools, friction, "
            "heat) and rates in its output are those of the run, {0:.6g} times those of the process; forces, "
            "energies and temperatures are the same\n",
            scene->time_scale());
    } else if (k.is("active")) state.active().read(k);
    else if (k.is("state")) begin_anew = k.second("keep", "new");
    else if (k.is("energy")) balance = k.yes();
    else if (k.is("table")) {
      const bool wait = k.take("wait");
      table.want(wait || k.yes(), wait);
    } else if (k.is("audit")) {
      int every = 0, sample = 0;
      meter.reset(read_audit(k, every, sample) ? new AccuracyMeter(lmp, state, *scene, every, sample) : nullptr);
      table.set_meter(meter.get());
      size_vector = EnergyReport::ENTRIES + (meter ? AccuracyMeter::CAUSES + 1 : 0);
    } else if (k.is("effects")) read_effect(lmp, k, state.effect_plan());
    else
      k.unknown("temperature, temperature/max, density/max, courant, dt, dt/max, conduction, energy, "
                "energy/drift, lost, state, time/scale, active, table, "
                "audit, effects");
  }
  if (balance) state.effect_plan().force(TM_FX_LEDGER, true);
  if (const unsigned both = state.effect_plan().contradicting())
    error->all(FLERR, "Fix sph/tm: effect {} is forced both on and off", effect_name(both));
}

static bool expands(const Model &model)
{
  for (int t = 1; t <= model.types(); t++) {
    const tm_table &a = model.materials()[t].expansion;
    if (a.n || a.value > 0.0) return true;
  }
  return false;
}

int FixSPHTM::modify_param(int narg, char **arg)
{
  if (strcmp(arg[0], "temperature") == 0) {
    if (narg < 3) error->all(FLERR, "Fix_modify temperature of fix sph/tm needs a group and a temperature");
    const int igroup2 = group->find(arg[1]);
    if (igroup2 < 0) error->all(FLERR, "Fix_modify temperature of fix sph/tm: no group {}", arg[1]);
    const double T = positive(lmp, "Fix_modify temperature of fix sph/tm", arg[2]);
    state.start_temperatures().set_group(group->bitmask[igroup2], T);
    stops.temperatures_were_set();
    if (update->first_update && comm->me == 0 && expands(state.model()))
      error->warning(
          FLERR,
          "Fix_modify temperature of fix sph/tm {} behind a run: the new temperature makes no thermal strain "
          "and no heat; fix sph/tm/heat temperature heats a body so that it expands",
          id);
    state.need(TM_FX_HEAT, fmt::format("temperature of group {} is set", arg[1]));
    return 3;
  }
  Keywords k(lmp, "Fix_modify of fix sph/tm", narg, arg);
  return k.next() && read_setting(k) ? narg - k.rest() : 0;
}
