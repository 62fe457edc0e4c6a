#include "particle_state.h"

#include "scene.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "group.h"
#include "utils.h"

#include <algorithm>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

void HeatSource::grow(bool wanted, int nmax)
{
  if (wanted) resize(std::max(nmax, 1));
}

void HeatSource::set_zero(Backend &loops, bool wanted, int nmax)
{
  if (!wanted) return;
  grow(true, nmax);
  loops.zero(loop_write(), bytes());
}

// the last temperature that a group is given counts
void StartTemperatures::set_group(int bit, double T)
{
  int n = 0;
  for (int g = 0; g < start.n; g++) {
    if (start.bit[g] == bit) continue;
    start.bit[n] = start.bit[g];
    start.of[n++] = start.of[g];
  }
  start.bit[n] = bit;
  start.of[n] = T;
  start.n = n + 1;
}

int HeldTemperatures::hold(int bit, double T)
{
  if (all.n >= TM_HELD_MOST) return -1;
  all.group[all.n] = bit;
  all.temperature[all.n] = T;
  supplied[all.n] = 0.0;
  return all.n++;
}

void StartTemperatures::apply(int n, const int *mask, LoopArray<double> &field, LoopArray<double> &unstrained)
{
  if (start.n == 0) return;
  double *T = field.host_write(), *Tu = unstrained.empty() ? nullptr : unstrained.host_write();
  for (int i = 0; i < n; i++)
    for (int g = 0; g < start.n; g++)
      if (mask[i] & start.bit[g]) {
        if (Tu) Tu[i] += start.of[g] - T[3 * (size_t) i];
        T[3 * (size_t) i] = start.of[g];
      }
  start.n = 0;
}

ParticleState::ParticleState(LAMMPS *lmp, Backend &loops, std::unique_ptr<AtomArrays> arrays, StepOwner &owner,
                             const std::string &id, int group) :
    Pointers(lmp),
    fix_id(id), igroup(group), backend(loops), step_owner(owner), scene(Scene::of(lmp)),
    lammps_arrays(std::move(arrays)), values(loops), heat(loops), step(lmp, *this), run_clock(loops),
    region(lmp, *this, loops)
{
  values.enable(0, atom->nmax);
  scene->enter(this);
}

ParticleState::~ParticleState() { scene->leave(this); }

int ParticleState::group_bit() const { return lmp->group->bitmask[igroup]; }

/* ---------------------------------------------------------------------- effects */

void ParticleState::need(unsigned effect, const std::string &reason)
{
  if (plan.ask(effect, reason)) plan_changed();
}

void ParticleState::plan_changed()
{
  if (used_model && scene->has_pair() && used_model == &scene->model()) derive_effects();    // else at the next init
}

void ParticleState::init(Model &model)
{
  used_model = &model;
  derive_effects();
  step.init();
}

void ParticleState::derive_effects()
{
  const Model &m = *used_model;
  plan.derive(m, domain->dimension);
  used_model->set_compression_heat(has(TM_FX_COMPRESSION_HEAT), temperatures.of_all());
  if (plan.effects & ~TM_FX_PRESENT)
    error->all(FLERR, "Fix sph/tm: this build of the plugin has no effect {} (CMake SPHTM_MINIMAL_EFFECTS)",
               effect_name(plan.effects & ~TM_FX_PRESENT));
  if (!plan.contradiction.empty()) error->all(FLERR, "Fix sph/tm: {}", plan.contradiction);
  if (plan.effects & TM_FX_HEAT)
    for (int t = 1; t <= m.types(); t++)
      if (!m.materials()[t].heat)
        error->all(FLERR,
                   "Fix sph/tm: heat is on ({}), but type {} ({}) has no heat constants; add "
                   "'heat k cp chi' to its pair_coeff, with k 0 where it does not conduct, or "
                   "force the effect off with 'effects heat off'",
                   plan.heat_reason, t, m.material_name(t));
  // nothing is dropped before the set-up: a fix whose turn is still to come may ask for what a
  // restart file has brought
  const unsigned had = values.mask();
  values.enable_mask(had | ParticleFields::needed(plan.effects), atom->nmax);
  // a field that appears now starts from its initial value
  const unsigned fresh = values.mask() & ~had;
  if (fresh) {
    const tm_initial_args a = initial_args(host_arrays(), fresh);
    for (int i = 0; i < atom->nlocal; i++) tm_initial(i, &a);
  }
  if (has(TM_FX_SMOOTHING)) {    // lists are made for these sizes
    const tm_initial_args a = initial_args(host_arrays(), values.mask());
    for (int i = 0; i < atom->nlocal; i++) tm_initial_of_new(i, &a);
    const tm_size_range r = sizes();
    scene->rows().cover_sizes(r.largest_h, r.smallest_dp);
  }
}

void ParticleState::report_effects()
{
  if (plan.report == reported) return;
  reported = plan.report;
  if (comm->me) return;
  for (const auto &line : plan.report) utils::logmesg(lmp, "{}\n", line);
  for (const auto &w : plan.warnings) error->warning(FLERR, w);
}

/* ---------------------------------------------------------------------- particles */

tm_state ParticleState::arrays()
{
  tm_state s;
  for (int id = 0; id < TM_F_COUNT; id++) s.field[id] = values[id].loop_write();
  s.material = used_model->loop_tables().material.loop_read();
  lammps_arrays->point_to(s);
  return s;
}

tm_state ParticleState::host_arrays()
{
  tm_state s;
  for (int id = 0; id < TM_F_COUNT; id++) s.field[id] = values[id].host_write();
  s.material = used_model->materials();
  lammps_arrays->point_to_host(s);
  return s;
}

double ParticleState::temperature(int i)
{
  return has(TM_FX_HEAT) ? values[TM_F_TEMP].host_read()[3 * (size_t) i]
                         : tm_start_temperature(&temperatures.all(), atom->mask[i]);
}

tm_size_range ParticleState::sizes()
{
  const Settings &set = used_model->settings_in_use();
  if (!has(TM_FX_SMOOTHING)) return {set.h, set.h, set.spacing};
  const tm_size_range mine = PairLoops::of(backend).size_range(backend, atom->nlocal, arrays(), plan.effects);
  const double low[3] = {-mine.largest_h, mine.smallest_h, mine.smallest_dp};
  double all[3];
  MPI_Allreduce(low, all, 3, MPI_DOUBLE, MPI_MIN, world);
  if (all[0] == 0.0) return {set.h, set.h, set.spacing};    // no particles
  return {-all[0], all[1], all[2]};
}

tm_initial_args ParticleState::initial_args(const tm_state &s, unsigned mask) const
{
  tm_initial_args a;
  a.state = s;
  a.fields = mask;
  a.temperature = temperatures.of_all();
  a.ratio = used_model->settings_in_use().ratio;
  a.dim3 = domain->dimension == 3;
  return a;
}

void ParticleState::initialize_new()
{
  PairLoops::of(backend).initial_of_new(backend, atom->nlocal, initial_args(arrays(), values.mask()), plan.effects);
  if (has(TM_FX_HEAT)) temperatures.apply(atom->nlocal, atom->mask, values[TM_F_TEMP], values[TM_F_UNSTRAINED]);
}

void ParticleState::begin_setup()
{
  report_effects();
  values.enable(plan.effects, atom->nmax);
  initialize_new();
}

}    // namespace SPHTM_NS
