#include "total_lagrangian.h"

#include "all_ranks.h"
#include "pair_loops.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "lammps.h"
#include "output.h"
#include "thermo.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

// steps after which the kinds of particles are decided again, G is summed from the positions, pairs may be frozen
static constexpr int DECIDE_EVERY = 10, MEASURE_EVERY = 50, FREEZE_EVERY = 100;
static_assert(MEASURE_EVERY % DECIDE_EVERY == 0 && FREEZE_EVERY % DECIDE_EVERY == 0, "both in steps of decision");

void TotalLagrangian::init(double of_plastic, double stretch, double of_radius)
{
  threshold = of_plastic;
  strain = stretch >= 0.0 ? stretch : std::isinf(threshold) ? INFINITY : 0.2;
  approach = of_radius >= 0.0 ? of_radius : std::isinf(threshold) ? INFINITY : 0.01;
  tl_pairs.check_kernel(threshold);
  backend = &parts.state().loops();
  loops = &ListLoops::of(*backend);
  tl_pairs.reshape(*backend);
  for (auto *a : {&which, &which_interface}) a->move_to(*backend);
  for (auto *a : {&exported, &pull_back, &next_ul, &correction}) a->move_to(*backend);
  for (auto *a : {&was_ul, &is_ul}) a->move_to(*backend);
}

// what total-Lagrangian pairs do not have
void TotalLagrangian::check_effects() const
{
  Error *error = parts.host()->error;
  const ParticleState &state = parts.state();
  const struct {
    unsigned effect;
    const char *what;
  } without[] = {{TM_FX_FORM_F14, "pair_style form f14; use form f15"},
                 {TM_FX_XSPH, "pair_style xsph; use xsph 0"},
                 {TM_FX_BALSARA, "pair_style balsara yes; use balsara no"},
                 {TM_FX_SURFACE, "the surface of particles (fix sph/tm/heat, surface/area)"},
                 {TM_FX_SMOOTHING, "particles with a smoothing length of their own"},
                 {TM_FX_MIXED, "pair_style precision mixed; use precision double"}};
  for (const auto &w : without)
    if (state.has(w.effect))
      error->all(FLERR, "Fix adapt/neigh threshold {}: total-Lagrangian pairs do not support {}; or use threshold 0",
                 threshold, w.what);
  if (parts.model().settings_in_use().art_balanced && state.has(TM_FX_ARTSTRESS))
    error->all(FLERR,
               "Fix adapt/neigh threshold {}: pair_style artstress balanced needs threshold 0: "
               "total-Lagrangian pairs have no artificial stress; leave balanced away",
               threshold);
}

// a total-Lagrangian particle stays so, and there is no proximity check
bool TotalLagrangian::permanent() const { return std::isinf(threshold) && std::isinf(approach); }

// rows that may hold pairs of both kinds have corrections of their own, tm_tl_correction.h
bool TotalLagrangian::corrects() const { return parts.state().has(TM_FX_CORRECTION) && !permanent(); }

/* ---------------------------------------------------------------------- rows */

tm_interface_args TotalLagrangian::interface_args()
{
  tm_interface_args a = {};
  a.rows = tl_pairs.rows();
  a.candidates = candidates.rows();
  a.next_ul = next_ul.loop_read();
  a.was_ul = was_ul.loop_write();
  a.is_ul = is_ul.loop_write();
  a.dirty = candidates.changed().loop_write();
  a.own = parts.owned();
  a.ghosts = parts.owned_and_ghosts() - parts.owned();
  return a;
}

void TotalLagrangian::renew(bool renumbered)
{
  const int owned = parts.owned();
  if (renumbered) find_particles();
  if (any_changed) active = loops->of_kind(*backend, owned, {interface_args(), 1}, which.loop_write());
  if (!active && permanent()) candidates.none(owned);
  else if (candidates.search_moved(!candidates.are_good())) any_changed = true;
  if (stepping && std::isfinite(approach) && time >= next_check) proximity_check();
  if (!any_changed) return;
  const tm_interface_args a = interface_args();
  loops->interface_rows(*backend, owned, a, 0u);
  at_interface = loops->of_kind(*backend, owned, {a, 0}, which_interface.loop_write());
  any_changed = false;
}

// particles have other indices, ghosts are others
void TotalLagrangian::find_particles()
{
  const int all = parts.owned_and_ghosts();
  tl_pairs.make_room(parts.host()->atom->nmax);
  const bool same = all == parts.owned() && map.same_indices(parts.rows().loop_tags(), all);
  const int lost = resolve_tags(same);
  const int mine[2] = {!same || (int) is_ul.size() < all, lost > 0};
  int any[2];    // all ranks communicate and drop, or none
  MPI_Allreduce(mine, any, 2, MPI_INT, MPI_MAX, parts.host()->world);
  if (any[1]) drop_gone(lost);
  if (!any[0]) return;
  candidates.forget();
  candidates.changed().make_room(true, all + 1);
  for (auto *a : {&which, &which_interface}) a->make_room(true, parts.owned() + 1);
  for (auto *a : {&was_ul, &is_ul}) a->make_room(true, all + 1);
  pull_back.make_room(true, (size_t) all * TM_FREEZE_EXPORT + TM_FREEZE_EXPORT);
  next_ul.make_room(true, all + 1);
  loops->kinds(*backend, parts.owned(), {tl_pairs.history_read(), next_ul.loop_write()}, 0u);
  parts.communicate(next_ul, 1);
  loops->switch_kinds(*backend, all, interface_args(), 0u);
  any_changed = true;
}

// number of pairs of this rank whose other particle is not found
int TotalLagrangian::resolve_tags(bool same_indices)
{
  const bool by_tag = map.in_use();
  map.end();
  if (!by_tag || same_indices) return 0;
  tm_tag_map_args a = {};
  a.store = tl_pairs.store();
  a.tag = parts.rows().loop_tags();
  a.x = parts.state().arrays().x;
  a.back_to_ul = std::isfinite(approach);    // deleted or far away: no neighbor any more
  map.locate(a, parts.owned_and_ghosts(), !a.back_to_ul);
  const tm_rates_args &rates = parts.results().rate_args();
  a.rec = rates.rec;
  a.slope_norm = rates.slope_norm;
  a.corrected = parts.state().has(TM_FX_CORRECTION) && !corrects();
  a.dim3 = parts.host()->domain->dimension == 3;
  const int lost = loops->resolve_tags(*backend, parts.owned(), a, 0u);
  return a.back_to_ul ? 0 : lost;
}

// Collective: pairs of which this rank found so many without their other particle are dropped, if that particle is
// deleted and may be; one that exists is only beyond the ghosts.
void TotalLagrangian::drop_gone(int pairs)
{
  LAMMPS *lmp = parts.host();
  std::vector<int> tags = of_all_ranks(pairs ? map.gone_tags() : std::vector<int>(), lmp->world);
  std::sort(tags.begin(), tags.end());
  tags.erase(std::unique(tags.begin(), tags.end()), tags.end());

  const int n = parts.owned();
  LoopArray<int> owned(*backend);
  owned.resize(n + 1);
  backend->copy(owned.loop_write(), parts.rows().loop_tags(), n * sizeof(int));
  std::vector<int> here(tags.size(), 0), there(tags.size());
  const int *tag = owned.host_read();
  for (int i = 0; i < n; i++) {
    const auto t = std::lower_bound(tags.begin(), tags.end(), tag[i]);
    if (t != tags.end() && *t == tag[i]) here[t - tags.begin()] = 1;
  }
  MPI_Allreduce(here.data(), there.data(), (int) tags.size(), MPI_INT, MPI_MAX, lmp->world);
  for (size_t k = 0; k < tags.size(); k++)
    if (there[k])
      lmp->error->all(FLERR,
                      "Fix adapt/neigh threshold {}: particle {} is beyond the ghosts of others that have it as "
                      "a total-Lagrangian neighbor; a larger neighbor skin, or 'approach 0.01'",
                      threshold, tags[k]);
  const bigint count = n;
  bigint total;
  MPI_Allreduce(&count, &total, 1, MPI_LMP_BIGINT, MPI_SUM, lmp->world);
  if (lmp->output->thermo->lostflag == Thermo::ERROR && total != lmp->atom->natoms)
    lmp->error->all(FLERR,
                    "Fix adapt/neigh threshold {}: particle {} is gone, that others have as a total-Lagrangian "
                    "neighbor; write 'thermo_modify lost ignore' (or warn) to go on without it",
                    threshold, tags[0]);
  dropped += pairs;
}

// Done when two particles may have come nearer by a tenth of the support radius, at the latest after 50 steps: by the time of
// steps alone, so that it does not depend on ranks, skin and restarts
void TotalLagrangian::proximity_check()
{
  const Settings &set = parts.model().settings_in_use();
  tm_proximity_args a = {};
  a.rows = tl_pairs.rows();
  a.candidates = candidates.rows();
  a.rec = parts.results().rate_args().rec;
  a.history = tl_pairs.history();
  a.is_ul = is_ul.loop_read();
  a.h = set.h;
  a.support = tm_kernel_support(set.kernel);
  a.near = a.support * (1.0 - approach);
  a.change = a.support * approach;
  a.time = time - time_checked;
  const int newly = loops->proximity_check(*backend, parts.owned(), a, 0u);
  // of all ranks: the box that holds all velocities; two particles differ by its diagonal at most
  const tm_bounds v = SearchLoops::of(*backend).bounds(*backend, parts.owned(), {parts.state().arrays().v}, 0u);
  const double mine[7] = {-v.lo[0], -v.lo[1], -v.lo[2], v.hi[0], v.hi[1], v.hi[2], (double) newly};
  double most[7];
  MPI_Allreduce(mine, most, 7, MPI_DOUBLE, MPI_MAX, parts.host()->world);
  const double fastest = 0.5 * std::hypot(most[0] + most[3], most[1] + most[4], most[2] + most[5]);
  came_near = most[6] > 0.0;
  const double longest = 50.0 * parts.state().time_step().now();
  next_check = time + (fastest > 0.0 ? std::min(0.05 * candidates.radius() / fastest, longest) : longest);
  time_checked = time;
}

int TotalLagrangian::ul_particles(const int **list)
{
  *list = which.loop_read();
  return active;
}

/* ---------------------------------------------------------------------- rates */

tm_tl_args TotalLagrangian::rate_args(const tm_records &rec)
{
  const tm_rates_args &rates = parts.results().rate_args();
  tm_tl_args a = {};
  a.rows = tl_pairs.rows();
  a.rec = rec;
  a.exported = exported.loop_write();
  a.history = tl_pairs.history();
  a.dt = stepping ? parts.state().time_step().now() : 0.0;
  a.lets_go = parts.model().settings_in_use().hourglass < 0.0;    // as with threshold inf
  a.h = rates.h;
  a.slope_norm = rates.slope_norm;
  a.correction = corrects() ? correction.loop_read() : nullptr;
  a.force_unit = rates.force_unit;
  return a;
}

void TotalLagrangian::communicate(const tm_records &rec)
{
  check_effects();
  exported.make_room(true, (size_t) parts.owned_and_ghosts() * TM_TL_EXPORT + TM_TL_EXPORT);
  loops->tl_export(*backend, parts.owned(), {rate_args(rec), exported.loop_write()}, 0u);
  parts.communicate(exported, TM_TL_EXPORT);
}

void TotalLagrangian::correct(const tm_rates_args &rates, unsigned effects)
{
  if (!corrects()) return;
  correction.make_room(true, (size_t) parts.owned() * 9 + 9);
  tm_tl_correction_args a = {};
  a.ul = tl_pairs.interface_rows(rates, which_interface.loop_read());
  a.tl = tl_pairs.numbers();
  a.is_ul = is_ul.loop_read();
  a.history = tl_pairs.history_read();
  a.correction = correction.loop_write();
  loops->tl_correction(*backend, parts.owned(), a, effects);
}

// updated-Lagrangian pairs at the interface first
void TotalLagrangian::rates(const tm_rates_args &rates, unsigned effects)
{
  const tm_rates_args of_interface = tl_pairs.interface_rows(rates, which_interface.loop_read());
  PairLoops::of(*backend).rates(*backend, at_interface, of_interface, effects);
  tm_tl_args a = rate_args(rates.rec);
  a.force = rates.force;
  a.force_begins = rates.force_begins;
  a.gradient = rates.gradient;
  a.heat = rates.heat;
  a.artificial = rates.artificial;
  loops->tl_rates(*backend, parts.owned(), a, effects);
  limit_time_step(a, effects);
}

// of waves in gradients that are stretched; where B has the correction in it (Q = 1), a free corner counts as stretched by
// 2.1, which the step of corrected gradients allows for
void TotalLagrangian::limit_time_step(const tm_tl_args &a, unsigned effects)
{
  const bool corrected = parts.state().has(TM_FX_CORRECTION) && !corrects();
  const double fastest = loops->tl_fastest(*backend, parts.owned(), a, effects) / (corrected ? 2.1 : 1.0);
  if (fastest <= 0.0) return;
  const Settings &set = parts.model().settings_in_use();
  parts.state().time_step().limit(tm_sound_time_step(tm_step_length(set.h, set.ratio), fastest, set.visc_alpha,
                                                     set.hourglass, effects),
                                  TM_DT_SOUND);
}

/* ---------------------------------------------------------------------- end of a step */

tm_freeze_args TotalLagrangian::freeze_args()
{
  const bigint step = parts.host()->update->ntimestep;
  const tm_rates_args &rates = parts.results().rate_args();
  tm_freeze_args a = {};
  a.rows = tl_pairs.rows();
  a.candidates = candidates.rows();
  a.rec = rates.rec;
  a.state = parts.state().arrays();
  a.gradient = rates.gradient;
  a.history = tl_pairs.history();
  a.pull_back = pull_back.loop_write();
  a.next_ul = next_ul.loop_write();
  a.was_ul = a.is_ul = is_ul.loop_read();
  a.freezes = first_step || step % FREEZE_EVERY == 0;
  a.measures = step % MEASURE_EVERY == 0;
  a.corrected = parts.state().has(TM_FX_CORRECTION) && !corrects();
  a.permanent = permanent();
  a.threshold = threshold;
  a.strain = strain;
  a.dt = parts.state().time_step().now();
  a.h = rates.h;
  a.support_radius2 = rates.support_radius2;
  a.slope_norm = rates.slope_norm;
  a.visc_alpha = rates.visc_alpha;
  a.visc_beta = rates.visc_beta;
  return a;
}

// on any rank
bool TotalLagrangian::is_urgent(const tm_freeze_args &a)
{
  if (!parts.state().has(TM_FX_PLASTICITY) || std::isinf(threshold)) return false;
  const int mine = loops->urgent(*backend, parts.owned(), a, 0u);
  int sum;
  MPI_Allreduce(&mine, &sum, 1, MPI_INT, MPI_MAX, parts.host()->world);
  return sum > 0;
}

// the kinds of particles in the next step, freezing of pairs, B and G at the next force point
void TotalLagrangian::end_of_step()
{
  tm_freeze_args a = freeze_args();
  const unsigned effects = parts.state().effects();
  const int owned = parts.owned();
  sum_ul += active;
  last_ul = active;
  time += a.dt;
  if (!a.freezes && !came_near && parts.host()->update->ntimestep % DECIDE_EVERY != 0 && !is_urgent(a)) {
    // the kinds stay; in the first such step all histories are brought up to date
    a.dirty = nullptr;
    if (!decided) {
      a.which = which.loop_read();
      loops->freeze(*backend, active, a, effects);
      a.which = which_interface.loop_read();
    }
    loops->freeze(*backend, decided ? owned : at_interface, a, effects);
    decided = false;
    return;
  }
  first_step = came_near = false;
  decided = true;
  loops->decide(*backend, owned, a, effects);
  parts.communicate(next_ul, 1);
  if (a.freezes) {
    parts.communicate(pull_back, TM_FREEZE_EXPORT);
    a.pull_back = pull_back.loop_write();
  }
  const tm_interface_args at = interface_args();
  any_changed = loops->switch_kinds(*backend, parts.owned_and_ghosts(), at, 0u) > 0;
  backend->fill(at.dirty, 0, owned);
  if (any_changed) loops->mark_interface(*backend, owned, at, 0u);
  a.was_ul = at.was_ul;
  a.is_ul = at.is_ul;
  a.dirty = at.dirty;
  loops->freeze(*backend, owned, a, effects);
}

void TotalLagrangian::post_run()
{
  LAMMPS *lmp = parts.host();
  double sum;
  MPI_Allreduce(&dropped, &sum, 1, MPI_DOUBLE, MPI_SUM, lmp->world);
  dropped = 0.0;
  if (sum > 0.0 && lmp->comm->me == 0)
    lmp->error->warning(FLERR,
                        "Fix adapt/neigh threshold {}: {} total-Lagrangian pairs were dropped in this run, "
                        "their other particles are gone",
                        threshold, (bigint) sum);
}

/* ---------------------------------------------------------------------- between runs */

// pairs refer to particles that are not the same any more: all are updated-Lagrangian, as at the start
void TotalLagrangian::changed(bool moved, bool renamed)
{
  if (!tl_pairs.exist()) return;
  tl_pairs.forget();
  for (auto *a : {&was_ul, &is_ul}) a->clear();    // all ranks communicate the kinds
  first_step = true;
  time = time_checked = next_check = 0.0;
  LAMMPS *lmp = parts.host();
  if (lmp->comm->me) return;
  const std::string what = !renamed ? "places" : moved ? "places and IDs" : "IDs";
  lmp->error->warning(FLERR,
                      "Fix adapt/neigh threshold {}: particles have got other {} since the last run: all pairs "
                      "are updated-Lagrangian at first, as at the start{}",
                      threshold, what, renamed ? " ('delete_atoms ... compress no' leaves the IDs as they are)" : "");
}

// of all ranks
std::vector<double> TotalLagrangian::state()
{
  double sum = 0.0;
  MPI_Allreduce(&sum_ul, &sum, 1, MPI_DOUBLE, MPI_SUM, parts.host()->world);
  // clang-format off
  return {(double) candidates.room(), first_step ? 1.0 : 0.0, sum, time, time_checked, next_check,
          (double) tl_pairs.kernel(), tl_pairs.h()};
  // clang-format on
}

// rows of a file have the room of that run; a part without total-Lagrangian pairs has none of its own
bool TotalLagrangian::restore(const double *value, size_t n)
{
  if (n != 8 || !is_whole(value[0] / 8.0, 0, TM_SEARCH_MOST / 8) || !is_whole(value[1], 0, 1) ||
      !is_whole(value[6], -1, TM_KERNEL_COUNT - 1))
    return false;
  first_step = value[1] > 0.5;
  sum_ul = parts.host()->comm->me == 0 ? value[2] : 0.0;
  time = value[3];
  time_checked = value[4];
  next_check = value[5];
  tl_pairs.restore((int) value[6], value[7]);
  return true;
}

double TotalLagrangian::bytes() const
{
  double sum = tl_pairs.bytes();
  for (const auto *a : {&which, &which_interface}) sum += a->bytes();
  for (const auto *a : {&exported, &pull_back, &next_ul, &correction}) sum += a->bytes();
  for (const auto *a : {&was_ul, &is_ul}) sum += a->bytes();
  return sum;
}

}    // namespace SPHTM_NS
