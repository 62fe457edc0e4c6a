/* SPH-TM: fix sph/tm, the time step and what limits it. See doc/fix_sph_tm.rst. */
#include "fix_sph_tm.h"

#include "pair_sph_tm.h"

#include "atom.h"
#include "comm.h"
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

// with the fix that set it
std::string FixSPHTM::dt_cause_in_words(int cause) const
{
  static const char *const words[TM_DT_CAUSES] = {"the sound speed", "an acceleration", "heat conduction",
                                                  "the contact stiffness and damping", "the motion of a tool or drive",
                                                  "dt/max"};
  const Fix *by = limited_by[cause];
  return by ? fmt::format("{} (fix {} {})", words[cause], by->id, by->style) : words[cause];
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

// a time step of the user's against all that limits the automatic one, of this rank
void FixSPHTM::check_fixed_dt(const double *limit)
{
  // a lattice of random velocities without viscosity: 0.6 h/c stays bounded, 0.7 does not; the limit of conduction is
  // 4/3 of the automatic step, see tm_heat_time_step, that of a contact spring 1.1 times (0.78 over 0.70); at 1.0 the
  // acceleration moves a particle by half of h in a step, at 2.5 a tool by half of the spacing
  static const double stable[TM_DT_CAUSES] = {0.65, 1.0, 4.0 / 3.0, 1.1, 2.5, 1e300};
  for (int cause = 0; cause < TM_DT_CAUSES; cause++) {
    const double allowed = stable[cause] * limit[cause];
    if (fixed_dt <= allowed) continue;
    const std::string text = fmt::format("Fix sph/tm dt {:.6g} is not stable: {} allows {:.6g}; use 'dt auto' or a "
                                         "smaller value", fixed_dt, dt_cause_in_words(cause), allowed);
    if (update->setupflag) error->all(FLERR, text);
    error->one(FLERR, "Fix sph/tm stops at step {}: {}", update->ntimestep, text);
  }
}

// of the run so far; beyond it a step stops the run
static constexpr double LEAST_SHARE = 1e-4;

// a step that has become so small that the run would never end
void FixSPHTM::check_stall(const double *all)
{
  const double now = update->atime + (update->ntimestep - update->atimestep) * update->dt;
  const bool of_tool = dt_cause == TM_DT_CONTACT || dt_cause == TM_DT_MOTION;
  const double sound = all[TM_DT_SOUND] < 1e299 ? all[TM_DT_SOUND] : 0.0;    // none where there is no solid particle
  const double largest = of_tool ? std::max(dt_largest, sound) : dt_largest;
  const bool small = dt_cause != TM_DT_MAXIMUM && dt_next < LEAST_SHARE * largest, still = now + dt_next == now;
  if (!small && !still) return;
  const std::string text = fmt::format(
      "Fix sph/tm stops at step {}: the time step has fallen to {:.6g}, {}; it is limited by {}",
      update->ntimestep, dt_next,
      still && !small ? fmt::format("too small to change the time {:.6g}", now)
                      : fmt::format("{:.3g} of what it was or of what the sound speed allows",
                                    dt_next / largest),
      dt_cause_in_words(dt_cause));
  // where, by the rank that has it
  const double mine[TM_DT_CAUSES] = {courant * dt_limits[0], courant * dt_limits[1], dt_limits[2], dt_limits[3],
                                     dt_limits[4], 1e300};
  int rank = mine[dt_cause] <= all[dt_cause] ? comm->me : comm->nprocs, first;
  MPI_Allreduce(&rank, &first, 1, MPI_INT, MPI_MIN, world);
  if (first == comm->me || first == comm->nprocs) error->one(FLERR, "{}{}", text, limiting_particle());
  MPI_Barrier(world);
}

// the owned particle with the smallest step, in words
std::string FixSPHTM::limiting_particle()
{
  if (dt_cause > TM_DT_CONDUCTION || limited_by[dt_cause]) return "";
  atoms_to_host();
  const double h0 = pair_sph->settings_in_use().h, *size = field(TM_F_SIZE);
  int worst = -1;
  double least = 1e300;
  for (int i = 0; i < atom->nlocal; i++) {
    const double h = size ? size[(size_t) i * tm_field_table[TM_F_SIZE].columns + TM_S_H] : h0, *f = atom->f[i];
    const double mass = atom->rmass_flag ? atom->rmass[i] : atom->mass[atom->type[i]];
    const double a = pair_sph->units().force / mass * sqrt(f[0] * f[0] + f[1] * f[1] + f[2] * f[2]);
    const double limit = dt_cause == TM_DT_FORCE ? tm_force_time_step(h, a) : dt_of_size(i, h);
    if (limit >= least) continue;
    least = limit;
    worst = i;
  }
  if (worst < 0) return "";
  const double *x = atom->x[worst];
  return fmt::format(" at particle {} (type {}) at {:.6g} {:.6g} {:.6g}", atom->tag[worst],
                     atom->type[worst], x[0], x[1], x[2]);
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

void FixSPHTM::limit_by_bodies()
{
  if (!pair_sph->has_contact_pairs()) return;
  for (int t = 1; t <= atom->ntypes; t++) {
    // two particles on their common spring: a fifth of what one pair alone allows, as a particle has several
    limit_dt(0.2 * pair_sph->contact_time_step(t), TM_DT_CONTACT);
  }
}

// of the particles
void FixSPHTM::limit_dt_by(const tm_real *limits)
{
  for (int k = 0; k < 3; k++) limit_dt(limits[k], k);
}

void FixSPHTM::reduce_dt()
{
  limit_by_bodies();
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
  check_stall(all);
  dt_largest = std::max(dt_largest, dt_next);
  std::fill(dt_limits, dt_limits + TM_DT_CAUSES, 1e300);
}

double FixSPHTM::dt_of_size(int i, double h)
{
  const tm_material *m = pair_sph->materials() + atom->type[i];
  const double rho = field(TM_F_RHO)[i], *e = field(TM_F_ENERGY);
  double limit = courant * tm_sound_time_step(h, tm_eos_sound_speed(m, rho, e ? e[i] : 0.0),
                                              pair_sph->settings_in_use().visc_alpha,
                                              pair_sph->settings_in_use().hourglass, fx);
  if (has(TM_FX_CONDUCTION))
    limit = std::min(limit, tm_conduction_time_step(m, rho, temperature(i), h, pair_sph->largest_conductivity(),
                                                    pair_sph->fastest_heat_rate()));
  return limit;
}

void FixSPHTM::lower_next_dt(double limit)
{
  if (fixed_dt > 0.0 || limit >= dt_next) return;
  dt_next = limit;
  dt_cause = TM_DT_SOUND;
}
