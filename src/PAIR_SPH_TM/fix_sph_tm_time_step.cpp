/* SPH-TM: fix sph/tm, the time step and what limits it. See doc/fix_sph_tm.rst. */
#include "fix_sph_tm.h"

#include "pair_sph_tm.h"

#include "atom.h"
#include "error.h"
#include "force.h"
#include "modify.h"
#include "output.h"
#include "pair.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

const char *FixSPHTM::dt_cause_name() const
{
  static const char *const names[TM_DT_CAUSES] = {"sound speed",       "acceleration",
                                                  "heat conduction",   "contact stiffness",
                                                  "tool motion",       "dt/max"};
  return names[dt_cause];
}

// the first step's limit, from the sound speed alone; the rates are not known yet
void FixSPHTM::setup_dt()
{
  double limit = 1e300;
  const double h = sizes().smallest_h;
  for (int t = 1; t <= atom->ntypes; t++) {
    const tm_material &m = pair_sph->materials()[t];
    if (m.body != TM_BODY_SOLID) continue;
    limit = std::min(limit, tm_sound_time_step(h, tm_eos_sound_speed(&m, m.rho0, 0.0),
                                               pair_sph->settings_in_use().visc_alpha,
                                              pair_sph->settings_in_use().hourglass, fx));
  }
  dt = limit < 1e300 ? courant * limit : update->dt;
  if (dt_max > 0.0) dt = std::min(dt, dt_max);
}

// a time step of the user's above the stability limit
void FixSPHTM::check_fixed_dt()
{
  double all[TM_DT_CAUSES];
  MPI_Allreduce(dt_limits, all, TM_DT_CAUSES, MPI_DOUBLE, MPI_MIN, world);
  // a lattice of random velocities without viscosity: 0.6 h/c stays bounded, 0.7 does not; the limit
  // of conduction is 4/3 of the automatic step, see tm_heat_time_step
  const double sound = 0.65 * all[TM_DT_SOUND];
  if (fixed_dt > sound)
    error->all(FLERR, "Fix sph/tm dt {:.6g} is not stable: the sound speed allows {:.6g}; use 'dt auto' or a "
                      "smaller value", fixed_dt, sound);
  const double conduction = 4.0 / 3.0 * all[TM_DT_CONDUCTION];
  if (fixed_dt > conduction)
    error->all(FLERR, "Fix sph/tm dt {:.6g} is not stable: heat conduction allows {:.6g}; use 'dt auto' or a "
                      "smaller value", fixed_dt, conduction);
}

// the steps up to and with step number done had the old size; the time is summed step by step, so that
// a restarted run has the same bits
void FixSPHTM::apply_dt(double value, bigint done)
{
  update->atime += (done - update->atimestep) * update->dt;
  update->atimestep = done;
  if (update->dt == value) return;
  update->dt = value;
  update->dt_default = 0;
  if (force->pair) force->pair->reset_dt();
  for (const auto &f : modify->get_fix_list())
    if (f != this) f->reset_dt();
  output->reset_dt();
}

void FixSPHTM::reset_dt() {}

void FixSPHTM::limit_dt(double limit, int cause, const Fix *by)
{
  if (limit >= dt_limits[cause]) return;
  dt_limits[cause] = limit;
  limited_by[cause] = by;
}

void FixSPHTM::reduce_dt()
{
  if (pair_sph->has_contact_pairs())
    for (int t = 1; t <= atom->ntypes; t++) {
      const double l = pair_sph->contact_stiffness_limit(t);
      if (l > 0.0) limit_dt(0.4 * l, TM_DT_CONTACT);
    }
  double mine[TM_DT_CAUSES], all[TM_DT_CAUSES];
  std::copy_n(dt_limits, (int) TM_DT_CAUSES, mine);
  mine[TM_DT_SOUND] *= courant;
  mine[TM_DT_FORCE] *= courant;
  mine[TM_DT_MAXIMUM] = dt_max > 0.0 ? dt_max : 1e300;
  {
    const auto timed = run_clock.timed(SPHTM_NS::RunClock::COMMUNICATION);
    MPI_Allreduce(mine, all, TM_DT_CAUSES, MPI_DOUBLE, MPI_MIN, world);
  }
  dt_cause = (int) (std::min_element(all, all + TM_DT_CAUSES) - all);
  double next = all[dt_cause];
  if (next >= 1e300) next = update->dt;
  // grow slowly: the half-step prediction assumes steps of like size
  if (dt_next > 0.0 && next > 1.05 * dt_next) next = 1.05 * dt_next;
  dt_next = next;
  std::fill(dt_limits, dt_limits + TM_DT_CAUSES, 1e300);
}

double FixSPHTM::dt_of_size(int i, double h)
{
  const tm_material *m = pair_sph->materials() + atom->type[i];
  const double rho = field(TM_F_RHO)[i], *e = field(TM_F_ENERGY);
  double limit = courant * tm_sound_time_step(h, tm_eos_sound_speed(m, rho, e ? e[i] : 0.0),
                                              pair_sph->settings_in_use().visc_alpha,
                                              pair_sph->settings_in_use().hourglass, fx);
  const double k = has(TM_FX_CONDUCTION) ? tm_conductivity(m, temperature(i)) : 0.0;
  if (k > 0.0)
    limit = std::min(limit, tm_heat_time_step(rho, tm_capacity(m, temperature(i)), h, k,
                                              pair_sph->largest_conductivity(), pair_sph->fastest_heat_rate()));
  return limit;
}

void FixSPHTM::lower_next_dt(double limit)
{
  if (fixed_dt > 0.0 || limit >= dt_next) return;
  dt_next = limit;
  dt_cause = TM_DT_SOUND;
}
