#include "energy_report.h"

#include "scene.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fix.h"
#include "modify.h"
#include "update.h"
#include "utils.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

EnergyReport::EnergyReport(LAMMPS *lmp, ParticleState &s, const Scene &sc) : Pointers(lmp), state(s), scene(sc) {}

// what needs no sum over particles takes none
double EnergyReport::value(int entry)
{
  if (entry == DT) return state.time_step().now();
  if (entry == CAUSE) return state.time_step().cause();
  if (entry == NEIGHBORS) return neighbors();
  sum();
  return now[entry];
}

double EnergyReport::neighbors()
{
  if (counted_at == update->ntimestep && update->whichflag) return near;
  counted_at = update->ntimestep;
  const double mine = scene.results().neighbors();
  MPI_Allreduce(&mine, &near, 1, MPI_DOUBLE, MPI_SUM, world);
  near /= std::max((double) atom->natoms, 1.0);
  return near;
}

void EnergyReport::sum()
{
  if (summed_at == update->ntimestep && update->whichflag) return;
  summed_at = update->ntimestep;
  using E = EnergyBalance;
  const E &b = state.energy();
  double mine[SUMS] = {};
  const tm_energies e =
      PairLoops::of(state.loops()).energy_sums(state.loops(), atom->nlocal, state.arrays(), state.effects());
  mine[KINETIC] = e.kinetic;
  mine[ELASTIC] = e.stored + b.of(E::THERMAL_PRESSURE) - b.of(E::COMPRESSION);
  mine[PLASTIC] = b.of(E::PLASTIC) - b.of(E::PLASTIC_HEAT) + b.of(E::FAILURE);
  mine[FAILURE] = b.of(E::FAILURE);
  mine[UNEXPLAINED] = b.of(E::STRESS_WORK) - b.of(E::PLASTIC) - b.of(E::FAILURE) - e.stored -
                      b.of(E::THERMAL_PRESSURE) - b.of(E::LEFT_STORED);
  mine[HEAT] = b.of(E::HEAT) - b.of(E::HEAT_EXCHANGED);
  mine[CONTACT] = b.spring() + b.of(E::CONTACT_DAMPING);
  mine[FRICTION] = b.of(E::FRICTION);
  mine[ARTIFICIAL] = b.of(E::ARTIFICIAL);
  mine[LEFT] = b.of(E::LEFT_KINETIC) + b.of(E::LEFT_STORED);
  mine[EXTERNAL] =
      mine[LEFT] - (b.of(E::KINETIC_WORK) - b.of(E::INTERNAL_WORK) - b.of(E::CONTACT_WORK) + b.of(E::TOOL_WORK));
  mine[EXCHANGED] = state.has(TM_FX_EXPANSION) ? b.of(E::HEAT_EXCHANGED) : 0.0;
  mine[SHOCK] = b.of(E::SHOCK);
  MPI_Allreduce(mine, now, SUMS, MPI_DOUBLE, MPI_SUM, world);
  const double unit = state.model().units().energy;
  double total = 0.0;
  for (int k = 0; k < SUM; k++) {
    now[k] /= unit;
    total += now[k];
  }
  now[SUM] = total;
  now[FAILURE] /= unit;
  now[EXCHANGED] /= unit;
  now[SHOCK] /= unit;
  now[LEFT] /= unit;
  unstored = now[UNEXPLAINED] / unit;
  now[UNEXPLAINED] = energy_watch.unexplained(unstored);
}

// of a body strained by 1e-7: of less nothing can be said
double EnergyReport::least_energy()
{
  constexpr double LEAST = 1e-14;
  double mine = 0.0, all;
  for (int i = 0; i < atom->nlocal; i++) {
    const tm_material &m = state.model().materials()[atom->type[i]];
    if (m.body != TM_BODY_SOLID) continue;
    const double mass = atom->rmass_flag ? atom->rmass[i] : atom->mass[atom->type[i]];
    mine += mass * m.bulk / m.rho0;
  }
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return LEAST * all / state.model().units().energy;
}

// what leaves the box takes its energies along: the difference of the sums, whatever goes to other ranks besides
void EnergyReport::before_exchange(bool some)
{
  if (!state.has(TM_FX_LEDGER)) return;
  const int mine = some;
  int any = 0;
  MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, world);
  leaving = any != 0;
  if (leaving) count_leaving(1.0);
}

void EnergyReport::after_exchange()
{
  if (leaving) count_leaving(-1.0);
  leaving = false;
}

void EnergyReport::count_leaving(double sign)
{
  const tm_energies e =
      PairLoops::of(state.loops()).energy_sums(state.loops(), atom->nlocal, state.arrays(), state.effects());
  state.energy().add(EnergyBalance::LEFT_KINETIC, sign * e.kinetic);
  state.energy().add(EnergyBalance::LEFT_STORED, sign * e.stored);
}

void EnergyReport::look(Look when)
{
  if (!state.has(TM_FX_LEDGER)) return;
  sum();
  forget();    // fixes whose turn is still to come may add to it
  const double outside = std::fabs(now[EXTERNAL] - now[LEFT]) + std::fabs(now[EXCHANGED]);
  const EnergyWatch::Energies energies = {now[KINETIC], now[ARTIFICIAL], now[SHOCK], outside,
                                          now[LEFT],    now[SUM],        unstored};
  if (when == FIRST) {
    energy_watch.begin(energies, least_energy());
    return;
  }
  energy_watch.look(energies);
  if (when == GLANCE) return;
  energy_watch.count(when == LAST);
  for (std::string text = energy_watch.warning(); !text.empty(); text = energy_watch.warning())
    if (comm->me == 0) error->warning(FLERR, "Fix sph/tm {}: at step {} {}", state.id(), update->ntimestep, text);
  if (energy_watch.stops(drift_allowed))
    error->all(FLERR,
               "Fix sph/tm {} stops at step {}: the sum of the energies has drifted by {:+.3g} % "
               "of the {:.6g} that "
               "went in, more than the {:.3g} % of energy/drift: the results are not to be "
               "trusted. Likely cause: {}",
               state.id(), update->ntimestep, 100.0 * energy_watch.drift(), energy_watch.went_in(),
               100.0 * drift_allowed, likely_cause());
}

std::string EnergyReport::likely_cause() const
{
  for (const Fix *f : modify->get_fix_list())
    for (const char *style : {"^momentum", "^temp/", "^move", "^rigid"})
      if (utils::strmatch(f->style, style))
        return fmt::format(
            "fix {} {}, which sets velocities or positions: its work is in no sum; fix sph/tm/drive drives a body with "
            "its work, or go on without 'energy yes'",
            f->id, f->style);
  return state.time_step().is_fixed() ? "the constant dt"
                                      : "a body that tears apart or clumps numerically, or a courant too large";
}

}    // namespace SPHTM_NS
