/* SPH-TM: fix sph/tm/drive. See doc/fix_sph_tm_drive.rst.

   The force is replaced by the one with which the step of fix sph/tm ends at the prescribed velocity,
     v(n+1) = v(n) + dt f/m = V(t(n+1)),
   so that positions, history and energy balance follow as for any other particle. */
#include "fix_sph_tm_drive.h"

#include "heat_loops.h"
#include "restart_block.h"

#include "atom.h"
#include "atom_masks.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "group.h"
#include "modify.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

using namespace LAMMPS_NS;
using namespace SPHTM_NS;
using namespace FixConst;

FixSPHTMDrive::FixSPHTMDrive(LAMMPS *lmp, int narg, char **arg) : Fix(lmp, narg, arg), scene(Scene::of(lmp))
{
  scalar_flag = 1;
  vector_flag = 1;
  size_vector = 6;
  global_freq = 1;
  extscalar = 0;
  extvector = 0;
  restart_global = 1;
  dynamic_group_allow = 1;
  datamask_read = X_MASK | V_MASK | F_MASK | TYPE_MASK | MASK_MASK | RMASS_MASK;    // with Kokkos
  datamask_modify = F_MASK;

  const bool keyword = narg > 6 && strcmp(arg[6], "rotate") == 0;
  if (narg > 6 && !keyword && !utils::is_double(arg[6]) && strcmp(arg[6], "NULL") != 0 && strncmp(arg[6], "v_", 2) != 0)
    error->all(FLERR, "Fix sph/tm/drive: unknown keyword {}; after the velocities there can be rotate", arg[6]);
  if (narg < 6 || (narg > 6 && !keyword))
    error->all(FLERR,
               "Fix sph/tm/drive needs three velocities vx vy vz, each a number, v_name or NULL; got "
               "{} value{}",
               narg - 3, narg == 4 ? "" : "s");
  bool any = false;
  for (int k = 0; k < 3; k++) {
    if (strcmp(arg[3 + k], "NULL") == 0) continue;
    velocity[k].set(lmp, fmt::format("Fix sph/tm/drive v{}", "xyz"[k]), arg[3 + k]);
    given[k] = k < domain->dimension;
    any = any || given[k];
  }
  if (!any) error->all(FLERR, "Fix sph/tm/drive: no velocity is given, all are NULL");
  if (keyword) turn.set(lmp, "Fix sph/tm/drive", narg - 7, arg + 7, given);
}

bool FixSPHTMDrive::moves()
{
  for (int k = 0; k < 3; k++)
    if (given[k] && (velocity[k].varies() || velocity[k].now() != 0.0)) return true;
  return turn.turns() && (turn.varies() || turn.now() != 0.0);
}

int FixSPHTMDrive::setmask() { return POST_FORCE; }

void FixSPHTMDrive::init()
{
  state = &scene->state("Fix sph/tm/drive");
  for (auto &v : velocity) v.init();
  turn.init();
}

void FixSPHTMDrive::setup(int)
{
  check_group();
  warn_of_later_forces();
  const double rest[3] = {0.0, 0.0, 0.0};
  drive(rest, turn.at_start(), false);
  double target[3], omega;
  now(target, omega);
  if (turn.turns()) radius = turn.radius(groupbit);
  limit_time_step(target, omega);
}

// a particle that is not integrated would not move
void FixSPHTMDrive::check_group()
{
  const int *mask = atom->mask;
  bigint mine[2] = {0, 0}, all[2];
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(mask[i] & groupbit)) continue;
    mine[0]++;
    mine[1] += !(mask[i] & state->group_bit());
  }
  MPI_Allreduce(mine, all, 2, MPI_LMP_BIGINT, MPI_SUM, world);
  if (all[1])
    error->all(FLERR,
               "Fix sph/tm/drive: {} particles of group {} are not in the group of fix sph/tm {}, which "
               "moves them; give fix sph/tm the group all",
               all[1], group->names[igroup], state->id());
  if (!all[0] && comm->me == 0)
    error->warning(FLERR, "Fix sph/tm/drive {}: there are no particles in group {}; it drives nothing", id,
                   group->names[igroup]);
}

void FixSPHTMDrive::warn_of_later_forces()
{
  bool later = false;
  for (int k = 0; k < modify->nfix; k++) {
    const Fix *f = modify->fix[k];
    if (f == this) later = true;
    if (!later || f == this || !(modify->fmask[k] & POST_FORCE) || utils::strmatch(f->style, "^sph/tm/heat")) continue;
    bigint mine = 0, all = 0;
    for (int i = 0; i < atom->nlocal; i++) mine += (atom->mask[i] & groupbit) && (atom->mask[i] & f->groupbit);
    MPI_Allreduce(&mine, &all, 1, MPI_LMP_BIGINT, MPI_SUM, world);
    if (all && comm->me == 0)
      error->warning(FLERR,
                     "Fix {} ({}) acts on forces after fix sph/tm/drive {}: the velocity will not be the "
                     "prescribed one; move the drive to the end of the script",
                     f->id, f->style, id);
  }
}

/* ---------------------------------------------------------------------- */

// sums what the rest of the body exerts on the group, in the directions that are driven, and drives it
void FixSPHTMDrive::drive(const double *target, const tm_drive_turn &about, bool act)
{
  tm_drive_args a;
  a.state = state->arrays();
  a.group = groupbit;
  for (int k = 0; k < 3; k++) {
    a.given[k] = given[k];
    a.velocity[k] = target[k];
  }
  a.turn = about;
  a.act = act;
  a.dt = state->time_step().now();
  a.accel_unit = scene->model().units().force;
  const tm_drive_result r = HeatLoops::of(state->loops()).drive(state->active().stepping(), atom->nlocal, a, 0);
  std::copy_n(r.force, 3, sum);
  sum[3] += r.work;
  sum[4] = r.torque;
}

// at the end of the step: its time is current in post_force(); 0 along directions that are not driven
void FixSPHTMDrive::now(double *target, double &omega)
{
  const bool varies = velocity[0].varies() || velocity[1].varies() || velocity[2].varies() || turn.varies();
  if (varies) modify->clearstep_compute();
  for (int k = 0; k < 3; k++) target[k] = given[k] ? velocity[k].now() : 0.0;
  omega = turn.now();
  if (varies) modify->addstep_compute(update->ntimestep + 1);
}

void FixSPHTMDrive::post_force(int)
{
  const auto timed = state->clock().timed(this);
  double target[3], omega;
  now(target, omega);
  drive(target, turn.step(state->time_step().now(), target, omega), true);
  limit_time_step(target, omega);
}

// bodies without mechanics have no other limit on how far they move in a step
void FixSPHTMDrive::limit_time_step(const double *target, double omega)
{
  const double speed =
      sqrt(target[0] * target[0] + target[1] * target[1] + target[2] * target[2]) + fabs(omega) * radius;
  if (speed > 0.0) state->time_step().limit(0.1 * scene->model().settings_in_use().spacing / speed, TM_DT_MOTION, this);
}

/* ---------------------------------------------------------------------- output and restart */

double FixSPHTMDrive::compute_scalar() { return compute_vector(3); }

double FixSPHTMDrive::compute_vector(int n)
{
  scene->check_current(state, fmt::format("Fix sph/tm/drive {}", id));
  if (n == 5) return turn.angle();
  double all = 0.0;
  MPI_Allreduce(&sum[n], &all, 1, MPI_DOUBLE, MPI_SUM, world);
  // force, work and torque were summed in the force unit; work and torque want the energy unit
  const UnitScale &u = scene->model().units();
  return n >= 3 ? all * u.force / u.energy : all;
}

void FixSPHTMDrive::write_restart(FILE *fp)
{
  double work = 0.0;
  MPI_Reduce(&sum[3], &work, 1, MPI_DOUBLE, MPI_SUM, 0, world);
  std::vector<double> values = {work};
  if (turn.turns()) turn.append_to(values);
  if (comm->me == 0) write_restart_block(fp, values);
}

void FixSPHTMDrive::restart(char *buf)
{
  const std::string who = fmt::format("Fix sph/tm/drive {}", id);
  const auto values = read_restart_block(lmp, who, buf, 1, 1 + DriveTurn::NUMBERS);
  if (comm->me == 0) sum[3] = values[0];
  if (turn.turns() != (values.size() > 1))
    error->all(FLERR, "{}: in the restart file it {}; give it the same keywords, or another name", who,
               values.size() > 1 ? "turns (rotate)" : "does not turn");
  if (turn.turns()) turn.take_from(values.data() + 1);
}
