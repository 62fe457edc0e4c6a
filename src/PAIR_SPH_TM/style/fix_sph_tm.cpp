/* SPH-TM: fix sph/tm. See doc/fix_sph_tm.rst. */
#include "fix_sph_tm.h"

#include "accuracy_meter.h"
#include "argument.h"
#include "step_args.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "force.h"
#include "lammps.h"
#include "modify.h"
#include "neighbor.h"
#include "pair.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace SPHTM_NS;
using namespace FixConst;

FixSPHTM::FixSPHTM(LAMMPS *lmp, int narg, char **arg) :
    FixSPHTM(lmp, narg, arg, Backend::host(), std::make_unique<AtomArrays>(lmp))
{
}

FixSPHTM::FixSPHTM(LAMMPS *lmp, int narg, char **arg, Backend &loops, std::unique_ptr<AtomArrays> arrays) :
    Fix(lmp, narg, arg), scene(Scene::of(lmp)), state(lmp, loops, std::move(arrays), *this, id, igroup),
    start(lmp, *this, state, *scene), stops(lmp, state, *scene), energies(lmp, state, *scene),
    fracture(lmp, state, *scene), table(lmp, *this, state, *scene), file(lmp, state, *scene)
{
  time_integrate = 1;
  create_attribute = 1;
  restart_global = 1;
  restart_peratom = 1;
  wd_header = 1;
  scalar_flag = 1;
  vector_flag = 1;
  size_vector = EnergyReport::ENTRIES;
  array_flag = 1;
  size_array_rows = 4;
  size_array_cols = 2;
  extarray = 0;
  global_freq = 1;
  nevery = 100;    // looks at the energies and for fracture
  extscalar = 0;
  extvector = 0;
  dynamic_group_allow = 0;

  scene->set_time_scale(1.0);
  read_keywords(Keywords(lmp, "Fix sph/tm", narg - 3, arg + 3));
  maxexchange = state.fields().columns();
  force_reneighbor = state.active().on();
  next_reneighbor = -1;
  lost = (int *) state.loops().allocate_result(sizeof(int));
  atom->add_callback(Atom::GROW);
  atom->add_callback(Atom::RESTART);
}

FixSPHTM::~FixSPHTM()
{
  if (copymode) return;
  state.loops().release_result(lost);
  atom->delete_callback(id, Atom::GROW);
  atom->delete_callback(id, Atom::RESTART);
}

int FixSPHTM::setmask() { return INITIAL_INTEGRATE | PRE_EXCHANGE | FINAL_INTEGRATE | POST_NEIGHBOR | END_OF_STEP; }

void FixSPHTM::init()
{
  const Pair *pair = force->pair_match("^sph/tm", 0);
  if (!pair || !scene->has_pair())
    error->all(FLERR, "Fix sph/tm needs pair style sph/tm; write 'pair_style sph/tm hyperbolic 1.2 spacing <dp>' "
                      "and pair_coeff before the run");
  if (modify->get_fix_by_style("^sph/tm$").size() > 1)
    error->all(FLERR, "More than one fix sph/tm: one owns the state of all particles; use unfix, or its group");
  scene->neighbor_check().end_run();    // after one that was stopped
  start.check_company(pair);
  start.check_begun(begin_anew);
  file.check_rows();
  file.check_sizes();
  start.look_at_changes();
  state.init(scene->model());
  maxexchange = state.fields().columns();
  state.active().check(*scene, meter != nullptr);
  if (meter) meter->init();
  stops.init();
}

/* ---------------------------------------------------------------------- one step */

StepAudit *FixSPHTM::audit_now()
{
  return meter && !update->setupflag && meter->due(update->ntimestep) ? meter.get() : nullptr;
}

// no pre_force(): without one LAMMPS leaves it to the pair style to clear the forces, where it runs on a GPU
void FixSPHTM::begin_forces()
{
  if (update->setupflag) {
    state.begin_setup();
    maxexchange = state.fields().columns();
    state.time_step().begin_setup();
    state.source().set_zero(state.loops(), state.has(TM_FX_HEAT), atom->nmax);
    source_of_setup = true;
  }
  if (neighbor->ago == 0) {
    scene->neighbor_check().lists_renewed();
    state.clock().lists_renewed();
  }
  if (state.loops().shared()) check_lost();    // else the update is waited for
  state.energy().begin_step();
  state.history().set_forces();
}

void FixSPHTM::setup(int)
{
  energies.forget();    // velocities and particles may have changed since the last run
  const bool first = !state.history().begun();
  tm_update_args args = update_args(state, scene->results());
  stops.limit(args);
  const tm_update_result r =
      PairLoops::of(state.loops())
          .initial_limits(state.active().stepping(), atom->nlocal, {args, first}, state.effects());
  state.time_step().limit(r.dt);
  if (first) start.check_start();
  else start.check_changes();
  state.time_step().end_setup(first);
  scene->neighbor_check().begin_run(r.speed2, state.has(TM_FX_XSPH));
  fracture.begin(force->pair_match("^sph/tm", 0));
  table.stop_clock();
  looked = false;
}

// x(n+1/2), and the prediction of the pair style
void FixSPHTM::initial_integrate(int)
{
  if (!looked) energies.look(EnergyReport::FIRST);    // tools and other fixes are set up by now
  looked = true;
  table.start_clock();
  if (state.active().due(update->ntimestep)) next_reneighbor = update->ntimestep;
  state.clock().begin_step();
  state.history().begin();
  scene->results().begin_step();
  state.time_step().begin_step();
  state.source().held.forget();
  scene->neighbor_check().before_lists(state.time_step().ahead());
  const auto timed = state.clock().timed(RunClock::DRIFT);
  if (source_of_setup) state.source().set_zero(state.loops(), state.has(TM_FX_HEAT), atom->nmax);
  source_of_setup = false;
  drifted = atom->nlocal;
  PairLoops::of(state.loops())
      .drift(state.active().stepping(), drifted, drift_args(state, *domain), state.effects(), lost);
}

// asked before LAMMPS would delete the particle, and before the forces; whether there is one that may go
// gone: time since the drift
bool FixSPHTM::check_lost(double gone)
{
  if (drifted == 0) return false;
  state.loops().wait();
  const bool some = *lost < drifted;
  if (some && stop_on_lost) stops.stop_on_lost(*lost, gone);
  drifted = 0;
  return some;
}

void FixSPHTM::pre_exchange()
{
  leaves = check_lost();
  if (!stop_on_lost) energies.before_exchange(leaves);
}

void FixSPHTM::post_neighbor()
{
  energies.after_exchange();
  state.initialize_new();
  state.source().grow(state.has(TM_FX_HEAT), atom->nmax);
}

// the state at n+1
void FixSPHTM::final_integrate()
{
  if (state.time_step().conducts_in_stages()) {
    const auto timed = state.clock().timed(RunClock::THERMAL);
    scene->conduction().advance(state);
  }
  const tm_update_result sum = [this] {
    const auto timed = state.clock().timed(RunClock::UPDATE);
    tm_update_args args = update_args(state, scene->results());
    args.held = held_groups(*modify);
    stops.limit(args);
    state.active().hold(args.state.force);
    return PairLoops::of(state.loops()).update(state.active().stepping(), atom->nlocal, args, state.effects());
  }();
  check_lost(state.time_step().ahead());
  if (sum.status != TM_OK) stops.stop_on(sum);
  if (sum.melted < INT_MAX) stops.warn_of_melting(sum.melted);
  state.time_step().limit(sum.dt);
  if (state.active().on()) state.active().moved(*scene, sum.speed2, state.time_step().now());
  if (state.has(TM_FX_LEDGER)) state.energy().add_step(sum);
  scene->neighbor_check().after_lists(sum.speed2, state.time_step().ahead());
  state.time_step().end_step();
}

void FixSPHTM::end_of_step()
{
  energies.look(EnergyReport::REGULAR);
  fracture.look(force->pair_match("^sph/tm", 0));
}

void FixSPHTM::post_run()
{
  start.remember_particles();
  if (looked) energies.look(table.steps() >= nevery ? EnergyReport::LAST : EnergyReport::GLANCE);
  table.print(energies.watch(), fracture.in_words(), fracture.failed_in_words());
  scene->neighbor_check().end_run();
}

/* ---------------------------------------------------------------------- output */

double FixSPHTM::compute_scalar()
{
  scene->check_current(&state, fmt::format("Fix sph/tm {}", id));
  return energies.value(EnergyReport::SUM);
}

double FixSPHTM::compute_vector(int n)
{
  scene->check_current(&state, fmt::format("Fix sph/tm {}", id));
  if (n < 0 || n >= size_vector)
    error->all(FLERR, "Fix sph/tm output {} is not among its {} values", n + 1, size_vector);
  if (EnergyReport::is_of_balance(n) && n != EnergyReport::KINETIC && !state.has(TM_FX_LEDGER))
    error->all(FLERR, "Fix sph/tm output {} needs the keyword 'energy yes'", n + 1);
  if (n == EnergyReport::TORN && !state.has(TM_FX_FRACTURE))
    error->all(FLERR, "Fix sph/tm output {} needs the effect fracture", n + 1);
  if (n == EnergyReport::TORN) return fracture.torn();
  if (n < EnergyReport::ENTRIES) return energies.value(n);
  // the differences of the last audit by cause, then the share of the time of this run that audits took
  n -= EnergyReport::ENTRIES;
  if (n < AccuracyMeter::CAUSES) return meter->now(n);
  double mine[2] = {state.clock().of((const StepAudit *) meter.get()), state.clock().total()}, sum[2];
  MPI_Allreduce(mine, sum, 2, MPI_DOUBLE, MPI_SUM, world);
  return table.is_timing() ? sum[0] / sum[1] : 0.0;
}

double FixSPHTM::compute_array(int row, int column)
{
  scene->check_current(&state, fmt::format("Fix sph/tm {}", id));
  return table.value(row, column);
}

double FixSPHTM::memory_usage() { return state.fields().bytes() + state.source().bytes(); }

/* ---------------------------------------------------------------------- values of particles, restart */

void FixSPHTM::grow_arrays(int nmax) { state.fields().grow(nmax); }
void FixSPHTM::copy_arrays(int i, int j, int) { state.fields().copy(i, j); }
void FixSPHTM::set_arrays(int i) { state.fields().zero(i); }
int FixSPHTM::pack_exchange(int i, double *buf) { return state.fields().pack(i, buf); }
int FixSPHTM::unpack_exchange(int nlocal, double *buf) { return state.fields().unpack(nlocal, buf); }

int FixSPHTM::pack_restart(int i, double *buf) { return file.pack(i, buf); }
void FixSPHTM::unpack_restart(int nlocal, int nth) { file.unpack(nlocal, nth); }
int FixSPHTM::size_restart(int) { return file.size(); }
int FixSPHTM::maxsize_restart() { return file.size(); }
void FixSPHTM::write_restart(FILE *fp) { file.write(fp, energies.watch()); }
void FixSPHTM::restart(char *buf)
{
  file.read(buf, energies.watch());
  maxexchange = state.fields().columns();
}

// called by write_data on the first rank
void FixSPHTM::write_data_header(FILE *, int)
{
  if (!state.history().begun() || data_warned) return;
  data_warned = true;
  error->warning(FLERR,
                 "Fix sph/tm {}: write_data writes positions and velocities, not the state of the particles "
                 "(stress, "
                 "density, plastic strain, temperature): what reads the file starts from an unstressed body; "
                 "write_restart writes all",
                 id);
}
