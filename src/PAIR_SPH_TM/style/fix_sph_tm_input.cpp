/* SPH-TM: fix sph/tm, its keywords and fix_modify. See doc/fix_sph_tm.rst. */
#include "fix_sph_tm.h"

#include "accuracy_meter.h"
#include "argument.h"
#include "effect_plan.h"

#include "error.h"
#include "group.h"
#include "utils.h"

#include <cstring>

using namespace LAMMPS_NS;
using namespace SPHTM_NS;

// what fix_modify can change too
bool FixSPHTM::read_setting(Keywords &k)
{
  if (k.is("courant")) courant = k.within(0.0, 1.0);
  else if (k.is("dt")) fixed_dt = k.take("auto") ? 0.0 : k.positive();
  else if (k.is("dt/max")) dt_max = k.positive();
  else if (k.is("lost")) stop_on_lost = !k.second("error", "ignore");
  else if (k.is("temperature/max")) hottest_given = k.positive();
  else if (k.is("density/max")) {
    densest = k.positive();
    if (densest <= 1.0) error->all(FLERR, "{} must be above 1, got {}", k.what(), k.given());
  } else if (k.is("energy/drift")) drift_allowed = k.take("none") ? 1e300 : k.positive();
  else return false;
  return true;
}

void FixSPHTM::read_keywords(int narg, char **arg)
{
  Keywords k(lmp, "Fix sph/tm", narg, arg);
  while (k.next()) {
    if (k.is("temperature")) {
      temperature0 = k.positive();
      temperature_given = true;
    } else if (read_setting(k)) continue;
    else if (k.is("state")) begin_anew = k.second("keep", "new");
    else if (k.is("energy")) {
      if (k.yes()) forced_on |= TM_FX_LEDGER;
    }
    else if (k.is("table")) {
      const bool wait = k.take("wait");
      want_table = wait || k.yes();
      run_clock.waits = wait ? &backend : nullptr;
    } else if (k.is("audit")) read_audit(k);
    else if (k.is("effects")) read_effect(k);
    else
      k.unknown("temperature, temperature/max, density/max, courant, dt, dt/max, energy, "
                "energy/drift, lost, state, table, "
                "audit, effects");
  }
  if (forced_on & forced_off)
    error->all(FLERR, "Fix sph/tm: effect {} is forced both on and off",
               effect_name(forced_on & forced_off));
}

// yes, no, or N M
void FixSPHTM::read_audit(Keywords &k)
{
  k.need(1);
  if (utils::is_integer(k.ahead(0)) || (k.ahead(1) && utils::is_integer(k.ahead(1)))) {
    k.need(2);
    const int every = k.integer(1, 1000000000, "N"), sample = k.integer(1, 1000000, "M");
    meter.reset(new AccuracyMeter(*this, every, sample));
  } else
    meter.reset(k.yes() ? new AccuracyMeter(*this, AccuracyMeter::EVERY, AccuracyMeter::SAMPLE) : nullptr);
  size_vector = VECTOR_SIZE + (meter ? AccuracyMeter::CAUSES + 1 : 0);
}

// auto, or an effect and on or off
void FixSPHTM::read_effect(Keywords &k)
{
  k.need(1);
  if (k.take("auto")) return;
  k.need(2);
  const char *name = k.value();
  const unsigned bit = effect_by_name(name);
  if (!bit) error->all(FLERR, "Unknown fix sph/tm effect {}: known are {}", name, effect_names());
  (k.yes(name) ? forced_on : forced_off) |= bit;
}

int FixSPHTM::modify_param(int narg, char **arg)
{
  if (strcmp(arg[0], "temperature") == 0) {
    if (narg < 3)
      error->all(FLERR, "Fix_modify temperature of fix sph/tm needs a group and a temperature");
    const int igroup2 = group->find(arg[1]);
    if (igroup2 < 0) error->all(FLERR, "Fix_modify temperature of fix sph/tm: no group {}", arg[1]);
    const double T = positive(lmp, "Fix_modify temperature of fix sph/tm", arg[2]);
    preset.push_back({group->bitmask[igroup2], T});
    temperature_set = true;
    need(TM_FX_HEAT, fmt::format("temperature of group {} is set", arg[1]));
    return 3;
  }
  Keywords k(lmp, "Fix_modify of fix sph/tm", narg, arg);
  return k.next() && read_setting(k) ? narg - k.rest() : 0;
}
