/* SPH-TM: fix sph/tm. See doc/fix_sph_tm.rst. */
#include "fix_sph_tm.h"

#include "accuracy_meter.h"
#include "effect_plan.h"
#include "pair_sph_tm.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "force.h"
#include "lammps.h"
#include "modify.h"
#include "update.h"
#include "utils.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace SPHTM_NS;
using namespace FixConst;

FixSPHTM::FixSPHTM(LAMMPS *lmp, int narg, char **arg, Backend &loops) :
    Fix(lmp, narg, arg), backend(loops), particle_loops(PairLoops::of(loops)), fields(loops), source(loops)
{
  time_integrate = 1;
  create_attribute = 1;
  restart_global = 1;
  restart_peratom = 1;
  wd_header = 1;
  scalar_flag = 1;
  vector_flag = 1;
  size_vector = VECTOR_SIZE;
  array_flag = 1;
  size_array_rows = 4;
  size_array_cols = 2;
  extarray = 0;
  global_freq = 1;
  nevery = 100;    // looks at the energies
  extscalar = 0;
  extvector = 0;
  dynamic_group_allow = 0;

  read_keywords(narg - 3, arg + 3);
  std::fill(dt_limits, dt_limits + TM_DT_CAUSES, 1e300);
  std::fill(energy_now, energy_now + VECTOR_SIZE, 0.0);
  fields.enable(0, atom->nmax);
  maxexchange = fields.columns();
  lost = (int *) backend.allocate_result(sizeof(int));
  atom->add_callback(Atom::GROW);
  atom->add_callback(Atom::RESTART);
}

FixSPHTM::~FixSPHTM()
{
  if (copymode) return;
  backend.release_result(lost);
  atom->delete_callback(id, Atom::GROW);
  atom->delete_callback(id, Atom::RESTART);
}

FixSPHTM *FixSPHTM::of(LAMMPS *lmp, const std::string &who)
{
  const auto fixes = lmp->modify->get_fix_by_style("^sph/tm$");
  if (!fixes.empty()) return dynamic_cast<FixSPHTM *>(fixes[0]);
  if (!who.empty())
    lmp->error->all(FLERR, "{} needs a fix sph/tm, which owns the state of the particles; write 'fix body all sph/tm' "
                           "before it", who);
  return nullptr;
}

bool FixSPHTM::is_current() const
{
  return has_forces && pair_sph && force->pair_match("^sph/tm", 0) == pair_sph && pair_sph->belongs_to(this);
}

FixSPHTM *FixSPHTM::current(LAMMPS *lmp, const FixSPHTM *known, const std::string &who)
{
  FixSPHTM *fix = of(lmp);
  if (!fix || fix != known || !fix->is_current())
    lmp->error->all(FLERR, "{} has no current values: there was no run since {} written; use 'run 0' first", who,
                    !fix ? "fix sph/tm was removed or" : "it, fix sph/tm or pair style sph/tm was");
  return fix;
}

int FixSPHTM::setmask()
{
  return INITIAL_INTEGRATE | PRE_EXCHANGE | FINAL_INTEGRATE | POST_NEIGHBOR |
      ((forced_on & TM_FX_LEDGER) ? END_OF_STEP : 0);
}

/* ---------------------------------------------------------------------- effects */

void FixSPHTM::need(unsigned effect, const std::string &reason)
{
  if ((asked & effect) == effect) return;
  asked |= effect;
  asked_reasons.push_back({effect, reason});
  if (pair_sph) derive_effects();
}

void FixSPHTM::derive_effects()
{
  EffectPlan plan;
  plan.dimension = domain->dimension;
  plan.forced_on = forced_on;
  plan.forced_off = forced_off;
  plan.asked = asked_reasons;
  plan.derive(*pair_sph, atom->ntypes);
  if (plan.effects & ~TM_FX_PRESENT)
    error->all(FLERR, "Fix sph/tm: this build of the plugin has no effect {} (CMake SPHTM_MINIMAL_EFFECTS)",
               effect_name(plan.effects & ~TM_FX_PRESENT));
  if (!plan.contradiction.empty()) error->all(FLERR, "Fix sph/tm: {}", plan.contradiction);
  if (plan.effects & TM_FX_HEAT)
    for (int t = 1; t <= atom->ntypes; t++)
      if (!pair_sph->materials()[t].heat)
        error->all(FLERR, "Fix sph/tm: heat is on ({}), but type {} ({}) has no heat constants; add "
                          "'heat k cp chi' to its pair_coeff, with k 0 where it does not conduct, or "
                          "force the effect off with 'effects heat off'", plan.heat_reason, t,
                   pair_sph->material_name(t));
  fx = plan.effects;
  report = plan.report;
  warnings = plan.warnings;
  // nothing is dropped before the set-up: a fix whose turn is still to come may ask for what a
  // restart file has brought
  const unsigned had = fields.mask();
  fields.enable_mask(had | ParticleFields::needed(fx), atom->nmax);
  maxexchange = fields.columns();
  // a field that appears now starts from its initial value
  const unsigned fresh = fields.mask() & ~had;
  if (fresh) {
    const tm_initial_args a = initial_args(host_state(), fresh);
    for (int i = 0; i < atom->nlocal; i++) tm_initial(i, &a);
  }
  if (has(TM_FX_SMOOTHING)) {    // lists are made for these sizes
    const tm_initial_args a = initial_args(host_state(), fields.mask());
    for (int i = 0; i < atom->nlocal; i++) tm_initial_of_new(i, &a);
    const tm_size_range r = sizes();
    pair_sph->cover_sizes(r.largest_h, r.smallest_dp);
  }
}

// at a set-up, when all fixes have asked for what they need
void FixSPHTM::report_effects()
{
  if (report == reported) return;
  reported = report;
  if (comm->me) return;
  for (const auto &line : report) utils::logmesg(lmp, "{}\n", line);
  for (const auto &w : warnings) error->warning(FLERR, w);
}

void FixSPHTM::init()
{
  pair_sph = dynamic_cast<PairSPHTM *>(force->pair_match("^sph/tm", 0));
  if (!pair_sph)
    error->all(FLERR, "Fix sph/tm needs pair style sph/tm; write 'pair_style sph/tm hyperbolic 1.2 spacing <dp>' "
                      "and pair_coeff before the run");
  if (modify->get_fix_by_style("^sph/tm$").size() > 1)
    error->all(FLERR, "More than one fix sph/tm: one owns the state of all particles; use unfix, or its group");
  check_company();
  check_begun();
  check_restart();
  check_sizes_of_file();
  look_at_changes();
  derive_effects();
  if (meter) meter->init();
  std::fill(dt_limits, dt_limits + TM_DT_CAUSES, 1e300);
  std::fill(limited_by, limited_by + TM_DT_CAUSES, nullptr);
  hottest = find_hottest();
}

tm_initial_args FixSPHTM::initial_args(const tm_state &s, unsigned mask) const
{
  tm_initial_args a;
  a.state = s;
  a.fields = mask;
  a.temperature = temperature0;
  a.ratio = pair_sph->settings_in_use().ratio;
  a.dim3 = domain->dimension == 3;
  return a;
}

void FixSPHTM::initialise_particles()
{
  particle_loops.initial_of_new(backend, atom->nlocal, initial_args(state(), fields.mask()), fx);
  if (preset.empty()) return;
  double *T = fields[TM_F_TEMP].host_write();
  for (const auto &p : preset)
    for (int i = 0; i < atom->nlocal; i++)
      if (atom->mask[i] & p.bit) T[3 * (size_t) i] = p.temperature;
  preset.clear();
}

tm_state FixSPHTM::state()
{
  tm_state s;
  for (int id = 0; id < TM_F_COUNT; id++) s.field[id] = fields[id].loop_write();
  s.material = pair_sph->loop_materials();
  point_to_atoms(s);
  return s;
}

tm_state FixSPHTM::host_state()
{
  tm_state s;
  for (int id = 0; id < TM_F_COUNT; id++) s.field[id] = fields[id].host_write();
  s.material = pair_sph->materials();
  FixSPHTM::point_to_atoms(s);
  return s;
}

void FixSPHTM::point_to_atoms(tm_state &s)
{
  s.x = atom->nmax ? &atom->x[0][0] : nullptr;
  s.v = atom->nmax ? &atom->v[0][0] : nullptr;
  s.force = atom->nmax ? &atom->f[0][0] : nullptr;
  s.type = atom->type;
  s.mask = atom->mask;
  s.mass = atom->mass;
  s.rmass = atom->rmass_flag ? atom->rmass : nullptr;
}

tm_size_range FixSPHTM::sizes()
{
  const PairSPHTM::Settings &set = pair_sph->settings_in_use();
  if (!has(TM_FX_SMOOTHING)) return {set.h, set.h, set.spacing};
  const tm_size_range mine = particle_loops.size_range(backend, atom->nlocal, state(), fx);
  const double low[3] = {-mine.largest_h, mine.smallest_h, mine.smallest_dp};
  double all[3];
  MPI_Allreduce(low, all, 3, MPI_DOUBLE, MPI_MIN, world);
  if (all[0] == 0.0) return {set.h, set.h, set.spacing};    // no particles
  return {-all[0], all[1], all[2]};
}

double FixSPHTM::temperature(int i)
{
  return has(TM_FX_HEAT) ? fields[TM_F_TEMP].host_read()[3 * (size_t) i] : temperature0;
}

/* ---------------------------------------------------------------------- one step */

AccuracyMeter *FixSPHTM::audit_now()
{
  return meter && !update->setupflag && meter->due(update->ntimestep) ? meter.get() : nullptr;
}

// no pre_force(): without one LAMMPS leaves it to the pair style to clear the forces, where it runs on a GPU
void FixSPHTM::begin_forces()
{
  if (update->setupflag) {
    report_effects();
    fields.enable(fx, atom->nmax);
    maxexchange = fields.columns();
    initialise_particles();
    dt_ahead = 0.0;
    dt = fixed_dt > 0.0 ? fixed_dt : (dt_next > 0.0 ? dt_next : 0.0);
    if (dt == 0.0) setup_dt();
    empty_source();
    source_of_setup = true;
  }
  check_lost();
  contact_spring = 0.0;
  has_forces = true;
}

void FixSPHTM::empty_source()
{
  if (!has(TM_FX_HEAT)) return;
  source.resize(std::max(atom->nmax, 1));
  backend.zero(source.loop_write(), source.bytes());
}

void FixSPHTM::setup(int)
{
  energy_step = -1;    // velocities and particles may have changed since the last run
  const tm_update_result r = particle_loops.initial_limits(backend, atom->nlocal, {update_args(), !started}, fx);
  limit_dt_by(r.dt);
  if (!started) check_start();
  else check_changes();
  if (fixed_dt > 0.0) {
    limit_by_bodies();
    double all[TM_DT_CAUSES];
    MPI_Allreduce(dt_limits, all, TM_DT_CAUSES, MPI_DOUBLE, MPI_MIN, world);
    check_fixed_dt(all);
  }
  dt_largest = started ? dt_next : 0.0;
  if (!started || dt_next <= 0.0) {
    reduce_dt();
    if (!started && comm->me == 0) {
      utils::logmesg(lmp,
                     "sph/tm: {} particles begin without stress and strain, at {:.6g} K where no "
                     "other temperature is set\n",
                     atom->natoms, temperature0);
      utils::logmesg(lmp, "sph/tm: time step {:.6g}, limited by {}; rate loops: {}\n",
                     fixed_dt > 0.0 ? fixed_dt : dt_next, dt_cause_name(), backend.name());
    }
  } else {    // a run that goes on keeps its step, unless a tool became stiffer or faster
    dt_next = std::min({dt_next, dt_limits[TM_DT_CONTACT], dt_limits[TM_DT_MOTION]});
  }
  dt = fixed_dt > 0.0 ? fixed_dt : dt_next;
  apply_dt(dt, update->ntimestep);
  timing = looked = false;    // the run's time begins with its first step
}

void FixSPHTM::initial_integrate(int)
{
  if (!looked) watch_energy(FIRST_LOOK);    // tools and other fixes are set up by now
  looked = true;
  if (!timing) {
    timing = true;
    clock_step = update->ntimestep - 1;
    run_clock.restart();
    if (meter) meter->restart();
  }
  started = true;
  pair_sph->steps();
  dt = fixed_dt > 0.0 ? fixed_dt : dt_next;
  apply_dt(dt, update->ntimestep - 1);    // this step is counted already
  std::fill(dt_limits, dt_limits + TM_DT_CAUSES, 1e300);    // those of the set-up are in use
  dt_ahead = 0.5 * dt;
  const auto timed = run_clock.timed(RunClock::DRIFT);
  if (source_of_setup) empty_source();
  source_of_setup = false;
  drifted = atom->nlocal;
  particle_loops.drift(backend, drifted, drift_args(), fx, lost);
}

void FixSPHTM::pre_exchange()
{
  if (check_lost()) delete_lost();
}

void FixSPHTM::post_neighbor()
{
  initialise_particles();
  if (has(TM_FX_HEAT)) source.resize(std::max(atom->nmax, 1));
}

tm_update_args FixSPHTM::update_args()
{
  tm_update_args a;
  a.state = state();
  const tm_rates_args &rates = pair_sph->rate_args();
  a.rec = rates.rec;
  a.gradient = rates.gradient;
  a.heat = rates.heat;
  a.xsph_v = rates.xsph_v;
  a.hourglass_rate = rates.hourglass_rate;
  a.artificial = rates.artificial;
  a.share = pair_sph->tensile_shares();
  a.ratio = pair_sph->settings_in_use().ratio;
  a.force_internal = pair_sph->internal_force();
  a.source = heat_source();
  a.group = groupbit;
  a.dt = dt;
  a.h = pair_sph->settings_in_use().h;
  a.visc_alpha = pair_sph->settings_in_use().visc_alpha;
  a.hourglass = pair_sph->settings_in_use().hourglass;
  a.accel_unit = pair_sph->units().force;
  a.temperature = temperature0;
  a.heat_rate = pair_sph->fastest_heat_rate();
  a.k_max = pair_sph->largest_conductivity();
  a.hottest = hottest;
  a.densest = densest;
  a.watch_melt = has(TM_FX_HEAT) && !melt_reported;
  return a;
}

void FixSPHTM::final_integrate()
{
  const tm_update_result sum = [this] {
    const auto timed = run_clock.timed(RunClock::UPDATE);
    return particle_loops.update(backend, atom->nlocal, update_args(), fx);
  }();
  if (sum.status != TM_OK) stop_on(sum.particle, sum);
  if (sum.melted < INT_MAX) report_melting(sum.melted);
  limit_dt_by(sum.dt);
  if (has(TM_FX_LEDGER)) {
    ledger.elastic += sum.elastic;
    ledger.plastic += sum.plastic;
    ledger.plastic_heat += sum.plastic_heat;
    ledger.artificial += sum.artificial;
    ledger.kinetic_work += sum.kinetic_work;
    ledger.internal_work += sum.internal_work;
    ledger.heat += sum.heat;
  }
  if (fixed_dt <= 0.0) reduce_dt();
  else check_fixed_dt(dt_limits);
}
