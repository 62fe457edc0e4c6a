/* SPH-TM: fix sph/tm, the energy book and its output. See doc/fix_sph_tm.rst. */
#include "fix_sph_tm.h"

#include "accuracy_meter.h"
#include "pair_sph_tm.h"

#include "atom.h"
#include "error.h"
#include "update.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace SPHTM_NS;

void FixSPHTM::sum_energies()
{
  if (energy_step == update->ntimestep && update->whichflag) return;
  energy_step = update->ntimestep;
  const Ledger &l = ledger;
  double mine[VECTOR_SIZE] = {};
  mine[ENERGY_KINETIC] = backend.kinetic_energy(atom->nlocal, state());
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
