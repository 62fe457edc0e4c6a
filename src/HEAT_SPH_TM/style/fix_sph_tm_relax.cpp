/* SPH-TM: fix sph/tm/relax. See doc/fix_sph_tm_relax.rst. The physics is in tm_relax.h. */
#include "fix_sph_tm_relax.h"

#include "argument.h"
#include "contact_probe.h"
#include "fix_sph_tm_drive.h"
#include "heat_loops.h"
#include "restart_block.h"

#include "atom.h"
#include "atom_masks.h"
#include "comm.h"
#include "error.h"
#include "modify.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace SPHTM_NS;
using namespace FixConst;

FixSPHTMRelax::FixSPHTMRelax(LAMMPS *lmp, int narg, char **arg) : Fix(lmp, narg, arg), scene(Scene::of(lmp))
{
  scalar_flag = 1;
  vector_flag = 1;
  size_vector = 6;
  global_freq = 1;
  extscalar = 0;
  extvector = 0;
  restart_global = 1;
  dynamic_group_allow = 1;
  datamask_read = V_MASK | F_MASK | TYPE_MASK | MASK_MASK | RMASS_MASK;    // with Kokkos
  datamask_modify = F_MASK;

  Keywords k(lmp, "Fix sph/tm/relax", narg - 3, arg + 3);
  while (k.next()) {
    if (!k.is("damping")) k.unknown("damping");
    adapts = k.take("auto");
    if (adapts) continue;
    k.need(1);
    const std::string what = k.what();
    given.set(lmp, what, k.value());
    if (!given.varies() && given.now() < 0.0) error->all(FLERR, "{} must be >= 0 or auto, got {}", what, given.now());
  }
}

int FixSPHTMRelax::setmask() { return POST_FORCE; }

void FixSPHTMRelax::init()
{
  state = &scene->state("Fix sph/tm/relax");
  if (!adapts) given.init();
  // what is driven has no equilibrium of its own, and damping would change its velocity unseen by the energy balance
  std::fill_n(driven, 3, 0);
  drives.clear();
  for (Fix *f : modify->get_fix_list())
    if (auto *drive = dynamic_cast<FixSPHTMDrive *>(f)) {
      drives.push_back(drive);
      for (int k = 0; k < 3; k++)
        if (drive->drives(k)) driven[k] |= drive->groupbit;
    }
}

// forces that come later are neither damped nor in the measure of the equilibrium
void FixSPHTMRelax::setup(int)
{
  bool later = false;
  for (int k = 0; k < modify->nfix; k++) {
    const Fix *f = modify->fix[k];
    if (f == this) later = true;
    const std::string style = f->style;
    if (!later || f == this || !(modify->fmask[k] & POST_FORCE) || style.find("sph/tm/") == 0) continue;
    if (comm->me == 0)
      error->warning(
          FLERR,
          "Fix {} ({}) acts on forces after fix sph/tm/relax {}, which then comes to rest out of balance with it: write "
          "the relaxation behind it",
          f->id, f->style, id);
  }
  sum(false);
}

/* ---------------------------------------------------------------------- */

void FixSPHTMRelax::sum(bool act)
{
  tm_relax_args a;
  a.state = state->arrays();
  a.rec = scene->results().rate_args().rec;
  a.group = groupbit;
  std::copy_n(driven, 3, a.driven);
  a.act = act;
  a.damping = damping;
  a.dt = state->time_step().now();
  a.accel_unit = scene->model().units().force;
  const tm_relax_result r =
      HeatLoops::of(state->loops()).relax(state->active().stepping(), atom->nlocal, a, state->effects());
  const double mine[3] = {r.power, r.force2, r.momentum2}, most[2] = {r.unbalanced, r.carried};
  double all[3], largest[2];
  MPI_Allreduce(mine, all, 3, MPI_DOUBLE, MPI_SUM, world);
  MPI_Allreduce(most, largest, 2, MPI_DOUBLE, MPI_MAX, world);
  sums = {all[0], all[1], all[2], largest[0], largest[1]};
}

// forces on what moves, and the flow it causes, contain the damping
void FixSPHTMRelax::warn_of_motion()
{
  if (warned_motion || damping == 0.0) return;
  std::string mover;
  for (const ContactProbe *p : scene->contact_probes())
    if (p->box().top_speed > 0.0) mover = "fix contact/tri " + p->tool_name;
  for (FixSPHTMDrive *drive : drives)
    if (drive->moves()) mover = fmt::format("what fix {} drives", drive->id);
  if (mover.empty()) return;
  warned_motion = true;
  if (comm->me == 0)
    error->warning(
        FLERR,
        "Fix sph/tm/relax {} damps while {} moves: forces on it, and plastic strain, contain the damping (2.3 "
        "times the force in a bend at 20 m/s). Begin the relaxation when it stands, or compare with a run "
        "without",
        id, mover);
}

void FixSPHTMRelax::post_force(int)
{
  const auto timed = state->clock().timed(this);
  warn_of_motion();
  if (!adapts) {
    if (given.varies()) modify->clearstep_compute();
    damping = given.now();
    if (given.varies()) modify->addstep_compute(update->ntimestep + 1);
    if (damping < 0.0) error->all(FLERR, "Fix sph/tm/relax damping must be >= 0, the variable gave {}", damping);
  }
  sum(true);
  const double dt = state->time_step().now();
  taken += dt * damping * sums.momentum2;
  if (adapts) damping = tm_relax_damping(&mode, &sums, damping, dt);
}

/* ---------------------------------------------------------------------- output and restart */

// of all particles, in mass length^2/time^2
double FixSPHTMRelax::elastic_energy()
{
  const tm_rates_args &rates = scene->results().rate_args();
  tm_tally_args a;
  a.rec = rates.rec;
  a.state = state->arrays();
  a.to_energy = 1.0;
  a.per_particle = nullptr;
  const double mine = PairLoops::of(state->loops()).tally(state->loops(), atom->nlocal, a, state->effects()).value[0];
  double all;
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return all;
}

double FixSPHTMRelax::compute_scalar() { return std::max(compute_vector(2), compute_vector(3)); }

double FixSPHTMRelax::compute_vector(int n)
{
  scene->check_current(state, fmt::format("Fix sph/tm/relax {}", id));
  const UnitScale &u = scene->model().units();
  // 1 where something moves or pulls, but nothing carries
  auto over = [](double part, double whole) {
    return part > 0.0 ? (whole > 0.0 ? std::min(part / whole, 1.0) : 1.0) : 0.0;
  };
  switch (n) {
    case 0: return damping;
    case 1: return taken / u.energy;
    case 2: return sqrt(over(0.5 * sums.momentum2, elastic_energy()));
    case 3: return over(sums.unbalanced, sums.carried);
    case 4: return sums.unbalanced / u.force;
    default: return elastic_energy() / u.energy;
  }
}

void FixSPHTMRelax::write_restart(FILE *fp)
{
  if (comm->me == 0)
    write_restart_block(fp, {damping, taken, mode.stiffness, mode.mass, mode.power, mode.rest, mode.dt});
}

void FixSPHTMRelax::restart(char *buf)
{
  const std::vector<double> v = read_restart_block(lmp, "Fix sph/tm/relax " + std::string(id), buf, 7, 7);
  damping = v[0];
  taken = v[1];
  mode = {v[2], v[3], v[4], v[5], v[6]};
}
