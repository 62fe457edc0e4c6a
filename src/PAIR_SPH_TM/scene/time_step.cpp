#include "time_step.h"

#include "model.h"
#include "particle_state.h"
#include "tm_rkl.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fix.h"
#include "force.h"
#include "modify.h"
#include "output.h"
#include "pair.h"
#include "update.h"
#include "utils.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

static const char *const CAUSES[TM_DT_CAUSES] = {"sound speed",       "acceleration", "heat conduction",
                                                 "contact stiffness", "tool motion",  "dt/max"};

TimeStep::TimeStep(LAMMPS *lmp, ParticleState &s) : Pointers(lmp), state(s) { clear(); }

void TimeStep::clear()
{
  std::fill(limits, limits + TM_DT_CAUSES, 1e300);
  my_conduction = 1e300;
}

void TimeStep::init()
{
  clear();
  std::fill(limited_by, limited_by + TM_DT_CAUSES, nullptr);
}

void TimeStep::restore(double now, double next, int cause)
{
  dt = now;
  dt_next = next;
  dt_cause = cause;
  update->update_time();    // the file has the time of an earlier step, which init would take for now
}

/* ---------------------------------------------------------------------- limits */

// the longest step of conduction over that of one evaluation, which is half the one by the decay rate: see tm_rkl.h
static double stages_bear(bool stages)
{
  constexpr int MOST_STAGES = 999;
  return stages ? 2.0 * tm_rkl_range(MOST_STAGES) : 1.0;
}

void TimeStep::limit(double value, int cause, const Fix *by)
{
  if (value >= limits[cause]) return;
  limits[cause] = value;
  limited_by[cause] = by;
}

void TimeStep::limit(const tm_real *of_particles)
{
  for (int k = 0; k < 3; k++) limit((k == TM_DT_CONDUCTION ? stages_bear(has_stages()) : 1.0) * of_particles[k], k);
  if (has_stages()) my_conduction = std::min(my_conduction, (double) of_particles[TM_DT_CONDUCTION]);
}

void TimeStep::limit_by_bodies()
{
  const Model &model = state.model();
  if (!model.pair_laws().has_contact()) return;
  // two particles on their common spring: a fifth of what one pair alone allows, as a particle has several
  for (int t = 1; t <= atom->ntypes; t++) limit(0.2 * model.contact_time_step(t), TM_DT_CONTACT);
}

// the first step's limit, from the sound speed alone; the rates are not known yet
double TimeStep::of_sound_speed()
{
  double least = 1e300;
  const double h = state.sizes().smallest_h;
  const Settings &set = state.model().settings_in_use();
  for (int t = 1; t <= atom->ntypes; t++) {
    const tm_material &m = state.model().materials()[t];
    if (m.body != TM_BODY_SOLID) continue;
    least = std::min(least, tm_sound_time_step(tm_step_length(h, set.ratio), tm_eos_sound_speed(&m, m.rho0, 0.0),
                                               set.visc_alpha, set.hourglass, state.effects()));
  }
  const double value = least < 1e300 ? courant * least : update->dt;
  return most > 0.0 ? std::min(value, most) : value;
}

double TimeStep::of_size(int i, double h)
{
  const Model &model = state.model();
  const tm_material *m = model.materials() + atom->type[i];
  const double rho = state.field(TM_F_RHO)[i], *e = state.field(TM_F_ENERGY), T = state.temperature(i);
  const Settings &set = model.settings_in_use();
  double value = courant * tm_sound_time_step(tm_step_length(h, set.ratio),
                                              tm_eos_sound_speed(m, rho, e ? e[3 * (size_t) i] : 0.0), set.visc_alpha,
                                              set.hourglass, state.effects());
  if (state.has(TM_FX_CONDUCTION))
    value =
        std::min(value, stages_bear(has_stages()) * tm_conduction_time_step(m, rho, T, h, model.largest_conductivity(),
                                                                            model.fastest_heat_rate()));
  return value;
}

void TimeStep::lower_next(double value)
{
  if (fixed > 0.0 || value >= dt_next) return;
  dt_next = value;
  dt_cause = TM_DT_SOUND;
}

/* ---------------------------------------------------------------------- set-up and steps */

void TimeStep::begin_setup()
{
  in_stages = false;
  dt_ahead = 0.0;
  dt = fixed > 0.0 ? fixed : (dt_next > 0.0 ? dt_next : 0.0);
  if (dt == 0.0) dt = of_sound_speed();
}

void TimeStep::end_setup(bool first)
{
  if (fixed > 0.0) {
    limit_by_bodies();
    double all[TM_DT_CAUSES];
    MPI_Allreduce(limits, all, TM_DT_CAUSES, MPI_DOUBLE, MPI_MIN, world);
    check_fixed(all);
  }
  dt_largest = first ? 0.0 : dt_next;
  MPI_Allreduce(&my_conduction, &of_conduction, 1, MPI_DOUBLE, MPI_MIN, world);
  if (first || dt_next <= 0.0) {
    reduce();
    if (fixed <= 0.0 && dt_next > 1e200 && atom->natoms > 0)
      error->all(
          FLERR,
          "Fix sph/tm: nothing limits the time step: no solid moves, and no material conducts heat; give 'dt' or "
          "'dt/max'");
    if (first && comm->me == 0) {
      utils::logmesg(lmp,
                     "sph/tm: {} particles begin without stress and strain, at {:.6g} K where no "
                     "other temperature is set\n",
                     atom->natoms, state.start_temperatures().of_all());
      utils::logmesg(lmp, "sph/tm: time step {:.6g}, limited by {}; rate loops: {}\n", fixed > 0.0 ? fixed : dt_next,
                     CAUSES[dt_cause], state.loops().name());
      if (fixed <= 0.0 && has_stages() && dt_cause == TM_DT_CONDUCTION && !limited_by[dt_cause])
        utils::logmesg(lmp, "sph/tm: without mechanics the time step grows with the time: end the run at a time "
                            "(fix halt), or give 'dt'\n");
    }
  } else {    // a run that goes on keeps its step, unless a tool became stiffer or faster
    dt_next = std::min({dt_next, limits[TM_DT_CONTACT], limits[TM_DT_MOTION]});
  }
  dt = fixed > 0.0 ? fixed : dt_next;
  apply(dt, update->ntimestep);
  first_of_run = true;
}

void TimeStep::begin_step()
{
  if (first_of_run && fixed <= 0.0) {
    // What fixes behind fix sph/tm have said in their set-up, and dt/max: heat that begins to go through a surface, a drive. A
    // flux that goes on has the limit that the last step found, but for what its temperatures have changed in half a step:
    // then the step stays
    constexpr double CHANGED = 0.9;
    const double flux = limited_by[TM_DT_CONDUCTION] ? limits[TM_DT_CONDUCTION] : 1e300;
    const double mine[2] = {flux, limits[TM_DT_MOTION]};
    double all[2];
    MPI_Allreduce(mine, all, 2, MPI_DOUBLE, MPI_MIN, world);
    const auto lower = [this](double value, int cause) {
      if (value >= dt_next) return;
      dt_next = value;
      dt_cause = cause;
    };
    if (all[0] < CHANGED * dt_next) lower(all[0], TM_DT_CONDUCTION);
    lower(all[1], TM_DT_MOTION);
    if (most > 0.0) lower(most, TM_DT_MAXIMUM);
  }
  first_of_run = false;
  dt = fixed > 0.0 ? fixed : dt_next;
  apply(dt, update->ntimestep - 1);    // this step is counted already
  clear();                             // those of the set-up are in use
  dt_ahead = 0.5 * dt;
  in_stages = has_stages() && dt > (1.0 + 1e-9) * of_conduction;
}

void TimeStep::end_step()
{
  if (fixed <= 0.0) {
    reduce();
    return;
  }
  check_fixed(limits);
  if (has_stages() && state.has(TM_FX_CONDUCTION))
    MPI_Allreduce(&my_conduction, &of_conduction, 1, MPI_DOUBLE, MPI_MIN, world);
}

// With mechanics heat follows their step. Else the step grows from the one of a single evaluation, as long as its error
// stays below the tolerance: of second order, so the error goes with the square of the step.
double TimeStep::longest_conduction(bool mechanics) const
{
  if (mechanics || of_conduction >= 1e299) return 1e300;
  if (dt_next <= 0.0) return of_conduction;
  const double share = heat_error > 0.0 ? sqrt(heat_tolerance / heat_error) : 1e300;
  return std::max(of_conduction, std::min(1.02, share) * dt);
}

// down to 30 bits: the loops of a scene are compiled for its effects, and the last bits of what they find need not agree
static double rounded_down(double step)
{
  int exponent;
  const double part = std::frexp(step, &exponent);
  return std::ldexp(std::floor(std::ldexp(part, 30)), exponent - 30);
}

void TimeStep::reduce()
{
  limit_by_bodies();
  double mine[TM_DT_CAUSES + 1], all[TM_DT_CAUSES + 1];
  std::copy_n(limits, (int) TM_DT_CAUSES, mine);
  mine[TM_DT_CAUSES] = my_conduction;
  mine[TM_DT_SOUND] *= courant;
  mine[TM_DT_FORCE] *= courant;
  mine[TM_DT_MAXIMUM] = most > 0.0 ? most : 1e300;
  {
    const auto timed = state.clock().timed(RunClock::COMMUNICATION);
    MPI_Allreduce(mine, all, TM_DT_CAUSES + 1, MPI_DOUBLE, MPI_MIN, world);
  }
  of_conduction = all[TM_DT_CAUSES];
  if (has_stages())
    all[TM_DT_CONDUCTION] = std::min(all[TM_DT_CONDUCTION], longest_conduction(all[TM_DT_SOUND] < 1e299));
  heat_error = -1.0;
  dt_cause = (int) (std::min_element(all, all + TM_DT_CAUSES) - all);
  double next = all[dt_cause];
  if (next >= 1e300) next = update->dt;
  else if (dt_cause <= TM_DT_CONDUCTION) next = rounded_down(next);
  // grow slowly: the half-step prediction assumes steps of like size
  if (dt_next > 0.0 && next > 1.05 * dt_next) next = 1.05 * dt_next;
  dt_next = next;
  check_stall(all);
  dt_largest = std::max(dt_largest, dt_next);
  clear();
}

// the steps up to and with step number done had the old size; the time is summed step by step, so that
// a restarted run has the same bits
void TimeStep::apply(double value, bigint done)
{
  update->atime += (done - update->atimestep) * update->dt;
  update->atimestep = done;
  if (update->dt == value) return;
  update->dt = value;
  update->dt_default = 0;
  if (force->pair) force->pair->reset_dt();
  for (const auto &f : modify->get_fix_list()) f->reset_dt();
  output->reset_dt();
}

/* ---------------------------------------------------------------------- steps that stop a run */

// with the fix that set it
std::string TimeStep::cause_in_words(int cause) const
{
  static const char *const words[TM_DT_CAUSES] = {"the sound speed",
                                                  "an acceleration",
                                                  "heat conduction",
                                                  "the contact stiffness and damping",
                                                  "the motion of a tool or drive",
                                                  "dt/max"};
  const Fix *by = limited_by[cause];
  return by ? fmt::format("{} (fix {} {})", words[cause], by->id, by->style) : words[cause];
}

// a time step of the user's against all that limits the automatic one, of this rank
void TimeStep::check_fixed(const double *of_causes)
{
  // a lattice of random velocities without viscosity: 0.6 h/c stays bounded, 0.7 does not; the limit of conduction is
  // 4/3 of the automatic step, see tm_heat_time_step, that of a contact spring 1.1 times (0.78 over 0.70); at 1.0 the
  // acceleration moves a particle by half of h in a step, at 2.5 a tool by half of the spacing
  static const double stable[TM_DT_CAUSES] = {0.65, 1.0, 4.0 / 3.0, 1.1, 2.5, 1e300};
  for (int cause = 0; cause < TM_DT_CAUSES; cause++) {
    const double allowed = stable[cause] * of_causes[cause];
    if (fixed <= allowed) continue;
    const std::string text = fmt::format("Fix sph/tm dt {:.6g} is not stable: {} allows {:.6g}; use 'dt auto' or a "
                                         "smaller value",
                                         fixed, cause_in_words(cause), allowed);
    if (update->setupflag) error->all(FLERR, text);
    error->one(FLERR, "Fix sph/tm stops at step {}: {}", update->ntimestep, text);
  }
}

// of the run so far; beyond it a step stops the run
static constexpr double LEAST_SHARE = 1e-4;

// a step that has become so small that the run would never end
void TimeStep::check_stall(const double *all)
{
  const double now = update->atime + (update->ntimestep - update->atimestep) * update->dt;
  const bool of_tool = dt_cause == TM_DT_CONTACT || dt_cause == TM_DT_MOTION;
  const double sound = all[TM_DT_SOUND] < 1e299 ? all[TM_DT_SOUND] : 0.0;    // none where there is no solid particle
  const double largest = of_tool ? std::max(dt_largest, sound) : dt_largest;
  const bool small = dt_cause != TM_DT_MAXIMUM && dt_next < LEAST_SHARE * largest, still = now + dt_next == now;
  if (!small && !still) return;
  const std::string text =
      fmt::format("Fix sph/tm stops at step {}: the time step has fallen to {:.6g}, {}; it is limited by {}",
                  update->ntimestep, dt_next,
                  still && !small
                      ? fmt::format("too small to change the time {:.6g}", now)
                      : fmt::format("{:.3g} of what it was or of what the sound speed allows", dt_next / largest),
                  cause_in_words(dt_cause));
  // where, by the rank that has it
  const double mine[TM_DT_CAUSES] = {courant * limits[0], courant * limits[1], limits[2], limits[3], limits[4], 1e300};
  int rank = mine[dt_cause] <= all[dt_cause] ? comm->me : comm->nprocs, first;
  MPI_Allreduce(&rank, &first, 1, MPI_INT, MPI_MIN, world);
  if (first == comm->me || first == comm->nprocs) error->one(FLERR, "{}{}", text, limiting_particle());
  MPI_Barrier(world);
}

// the owned particle with the smallest step, in words
std::string TimeStep::limiting_particle()
{
  if (dt_cause > TM_DT_CONDUCTION || limited_by[dt_cause]) return "";
  state.atoms().to_host_in_step();
  const Model &model = state.model();
  const double h0 = model.settings_in_use().h, *size = state.field(TM_F_SIZE);
  int worst = -1;
  double least = 1e300;
  for (int i = 0; i < atom->nlocal; i++) {
    const double h = size ? size[(size_t) i * tm_field_table[TM_F_SIZE].columns + TM_S_H] : h0, *f = atom->f[i];
    const double mass = atom->rmass_flag ? atom->rmass[i] : atom->mass[atom->type[i]];
    const double a = model.units().force / mass * sqrt(f[0] * f[0] + f[1] * f[1] + f[2] * f[2]);
    const double value = dt_cause == TM_DT_FORCE ? tm_force_time_step(h, a) : of_size(i, h);
    if (value >= least) continue;
    least = value;
    worst = i;
  }
  if (worst < 0) return "";
  const double *x = atom->x[worst];
  return fmt::format(" at particle {} (type {}) at {:.6g} {:.6g} {:.6g}", atom->tag[worst], atom->type[worst], x[0],
                     x[1], x[2]);
}

}    // namespace SPHTM_NS
