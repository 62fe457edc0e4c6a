/* SPH-TM: fix sph/tm, the energy book and its output. See doc/fix_sph_tm.rst. */
#include "fix_sph_tm.h"

#include "accuracy_meter.h"
#include "pair_sph_tm.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace SPHTM_NS;

void FixSPHTM::sum_energies()
{
  if (energy_step == update->ntimestep && update->whichflag) return;
  energy_step = update->ntimestep;
  const Ledger &l = ledger;
  double mine[VECTOR_SIZE] = {};
  mine[ENERGY_KINETIC] = particle_loops.kinetic_energy(backend, atom->nlocal, state(), fx);
  mine[ENERGY_ELASTIC] = l.elastic;
  mine[ENERGY_PLASTIC] = l.plastic - l.plastic_heat;
  mine[ENERGY_HEAT] = l.heat - l.heat_exchanged;
  mine[ENERGY_CONTACT] = contact_spring + l.contact_damping;
  mine[ENERGY_FRICTION] = l.friction;
  mine[ENERGY_ARTIFICIAL] = l.artificial;
  mine[ENERGY_EXTERNAL] = -(l.kinetic_work - l.internal_work - l.contact_work + l.tool_work);
  mine[VECTOR_NEIGHBORS] = pair_sph->neighbors();
  MPI_Allreduce(mine, energy_now, VECTOR_SIZE, MPI_DOUBLE, MPI_SUM, world);
  const double unit = pair_sph->units().energy;
  double sum = 0.0;
  for (int k = 0; k < ENERGY_SUM; k++) {
    energy_now[k] /= unit;
    sum += energy_now[k];
  }
  energy_now[ENERGY_SUM] = sum;
  energy_now[VECTOR_DT] = dt;
  energy_now[VECTOR_CAUSE] = dt_cause;
  energy_now[VECTOR_NEIGHBORS] /= std::max((double) atom->natoms, 1.0);
}

// every so many steps, and at the ends of runs
void FixSPHTM::watch_energy(Look when)
{
  if (!has(TM_FX_LEDGER)) return;
  sum_energies();
  energy_step = -1;    // fixes whose turn is still to come may add to it
  const EnergyWatch::Energies now = {energy_now[ENERGY_KINETIC], energy_now[ENERGY_ARTIFICIAL],
                                     energy_now[ENERGY_EXTERNAL], energy_now[ENERGY_SUM]};
  if (when == FIRST_LOOK) {
    // of a body strained by 1e-7
    constexpr double LEAST = 1e-14;
    double mine = 0.0, all;
    for (int i = 0; i < atom->nlocal; i++) {
      const tm_material &m = pair_sph->materials()[atom->type[i]];
      if (m.body != TM_BODY_SOLID) continue;
      const double mass = atom->rmass_flag ? atom->rmass[i] : atom->mass[atom->type[i]];
      mine += mass * m.bulk / m.rho0;
    }
    MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, world);
    energy_watch.begin(now, LEAST * all / pair_sph->units().energy);
    return;
  }
  energy_watch.look(now);
  if (when == GLANCE) return;
  energy_watch.count(when == LAST_LOOK);
  for (std::string text = energy_watch.warning(); !text.empty(); text = energy_watch.warning())
    if (comm->me == 0)
      error->warning(FLERR, "Fix sph/tm {}: at step {} {}", id, update->ntimestep, text);
  if (energy_watch.stops(drift_allowed) && stop_on_lost)    // lost particles take theirs with them
    error->all(FLERR,
               "Fix sph/tm {} stops at step {}: the sum of the energies has drifted by {:+.3g} % "
               "of the {:.6g} that "
               "went in, more than the {:.3g} % of energy/drift: the results are not to be "
               "trusted. Likely cause: {}",
               id, update->ntimestep, 100.0 * energy_watch.drift(), energy_watch.went_in(),
               100.0 * drift_allowed,
               fixed_dt > 0.0
                   ? "the constant dt"
                   : "a body that tears apart or clumps numerically, or a courant too large");
}

void FixSPHTM::end_of_step() { watch_energy(LOOK); }

// The sum of the book stays: what the motion and the stress lose is artificial or heat.
void FixSPHTM::book_remap(double kinetic, double elastic, double heat)
{
  if (!has(TM_FX_LEDGER)) return;
  ledger.elastic += elastic;
  ledger.heat += heat;
  ledger.artificial -= kinetic + elastic + heat;
}

double FixSPHTM::compute_scalar()
{
  current(lmp, this, fmt::format("Fix sph/tm {}", id));
  sum_energies();
  return energy_now[ENERGY_SUM];
}

double FixSPHTM::compute_vector(int n)
{
  current(lmp, this, fmt::format("Fix sph/tm {}", id));
  if (n < 0 || n >= size_vector) error->all(FLERR, "Fix sph/tm output {} is not among its {} values", n + 1, size_vector);
  if (n <= ENERGY_SUM && n != ENERGY_KINETIC && !has(TM_FX_LEDGER))
    error->all(FLERR, "Fix sph/tm output {} needs the keyword 'energy yes'", n + 1);
  if (n >= VECTOR_SIZE) return audit_output(n - VECTOR_SIZE);
  sum_energies();
  return energy_now[n];
}

// the differences of the last audit by cause, then the share of the time of this run that audits took
double FixSPHTM::audit_output(int n)
{
  if (n < AccuracyMeter::CAUSES) return meter->now(n);
  double mine[2] = {run_clock.of(meter.get()), run_clock.total()}, sum[2];
  MPI_Allreduce(mine, sum, 2, MPI_DOUBLE, MPI_SUM, world);
  return timing ? sum[0] / sum[1] : 0.0;
}
