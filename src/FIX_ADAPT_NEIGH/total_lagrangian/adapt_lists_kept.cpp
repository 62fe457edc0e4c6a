/* SPH-TM: adaptive neighbor lists, the steps of rows that are kept. See adapt_lists_moves.cpp for their way with the
   particles. */
#include "adapt_lists.h"

#include "fix_adapt_neigh.h"
#include "fix_sph_tm.h"
#include "pair_loops.h"
#include "pair_sph_tm.h"

#include "atom.h"
#include "error.h"
#include "lammps.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

static constexpr double EARLY = 0.25;
// steps after which it is decided again who is searched, G is measured, particles may come to rest
static constexpr int LOOK_EVERY = 10, MEASURE_EVERY = 50, SETTLE_EVERY = 100;
static_assert(MEASURE_EVERY % LOOK_EVERY == 0 && SETTLE_EVERY % LOOK_EVERY == 0, "both are done when it is looked");

int AdaptLists::own() const { return fix.host()->atom->nlocal; }
int AdaptLists::all() const { return fix.host()->atom->nlocal + fix.host()->atom->nghost; }

void AdaptLists::make_room(int n)
{
  if (room != quiet.capacity) kept.clear();
  table.make_room(n, room);
  quiet.make_room(n, room);
  kept.resize(quiet.particles);
  ul_first.resize(quiet.particles);
  weight.resize(quiet.slots() * TM_WEIGHTS);
  history.resize((size_t) quiet.particles * TM_TL_HISTORY);
}

// Rows of particles, packed, where they must go to a table of another shape; then into it
std::vector<std::vector<double>> AdaptLists::take_rows()
{
  const int stride = fix.body().loops().shared() ? 1 : TM_ROW_SLICE_GPU;
  const bool same = room == quiet.capacity && stride == quiet.stride;
  std::vector<std::vector<double>> rows_of(same || quiet.capacity == 0 ? 0 : std::min(own(), (int) kept.size()));
  std::vector<int> entry(by_tag ? n_names : all());
  std::iota(entry.begin(), entry.end(), 0);
  for (size_t i = 0; i < rows_of.size(); i++) {
    const tm_tl_store s = kept_store(true);
    if (s.rows.tl[i] > room) stop_on_long_row(room, s.rows.tl[i]);
    rows_of[i].resize(tm_tl_packed(s.rows.tl[i]));
    tm_tl_pack((int) i, &s, entry.data(), rows_of[i].data());
  }
  return rows_of;
}

void AdaptLists::put_rows(const std::vector<std::vector<double>> &rows_of)
{
  std::vector<int> entry(room);
  for (size_t i = 0; i < rows_of.size(); i++) {
    const tm_tl_store s = kept_store(true);
    tm_tl_unpack((int) i, &s, rows_of[i].data(), 0, entry.data());
    int *row = s.rows.index + s.rows.first[i];
    for (int e = 0; e < s.rows.tl[i]; e++) row[e * s.rows.stride] = entry[e];
  }
}

// kept gradients are those of one kernel and one h
void AdaptLists::check_kernel()
{
  const PairSPHTM::Settings &set = fix.pair().settings_in_use();
  const bool kept_before = quiet.capacity > 0 && kept_kernel >= 0;
  if (kept_before && (kept_kernel != set.kernel || std::fabs(kept_h - set.h) > 1e-9 * set.h))
    fix.host()->error->all(FLERR, "Fix adapt/neigh threshold {}: rows were kept with the {} kernel and the smoothing "
                                  "length {:.6g}, pair_style sph/tm now has {} and {:.6g}; write the same, or remove "
                                  "the fix and write it again: then all is searched again", threshold,
                           PairSPHTM::kernel_name(kept_kernel), kept_h, PairSPHTM::kernel_name(set.kernel), set.h);
  kept_kernel = set.kernel;
  kept_h = set.h;
}

// where the loops run, or on the host
tm_tl_rows AdaptLists::kept_rows(bool on_host)
{
  const auto write = [on_host](auto &a) { return on_host ? a.host_write() : a.loop_write(); };
  tm_tl_rows r;
  r.index = write(quiet.index);
  r.tl = write(kept);
  r.ul = write(quiet.count[0]);
  r.first = on_host ? quiet.first.host_read() : quiet.first.loop_read();
  r.ul_first = write(ul_first);
  r.stride = quiet.stride;
  r.capacity = quiet.capacity;
  r.unit = weight_unit;
  r.weight = write(weight);
  return r;
}

// total-Lagrangian: who is not searched stays so, and nobody looks for others
bool AdaptLists::blind() const { return std::isinf(threshold) && std::isinf(approach); }

// rows that may hold both kept and searched pairs have corrections of their own
bool AdaptLists::corrects() const { return fix.body().has(TM_FX_CORRECTION) && !blind(); }

/* ---------------------------------------------------------------------- one step */

tm_tl_store AdaptLists::kept_store(bool on_host)
{
  return {kept_rows(on_host), on_host ? history.host_write() : history.loop_write()};
}

tm_tl_args AdaptLists::kept_args(const tm_records &rec)
{
  const tm_rates_args &rates = fix.pair().rate_args();
  tm_tl_args a = {};
  a.rows = kept_rows();
  a.rec = rec;
  a.exported = exported.loop_write();
  a.history = history.loop_write();
  a.dt = stepping ? fix.body().step_dt() : 0.0;
  a.h = rates.h;
  a.slope_norm = rates.slope_norm;
  a.correction = corrects() ? correction.loop_read() : nullptr;
  a.force_unit = rates.force_unit;
  return a;
}

tm_interface_args AdaptLists::border_args()
{
  tm_interface_args a = {};
  a.rows = kept_rows();
  a.candidates = table.loop_rows();
  a.next_ul = next_ul.loop_read();
  a.was_ul = was_ul.loop_write();
  a.is_ul = is_ul.loop_write();
  a.dirty = dirty.loop_write();
  a.own = own();
  a.ghosts = all() - own();
  return a;
}

void AdaptLists::show(const tm_records &rec)
{
  if (!keeps()) return;
  check_effects();
  exported.make_room(true, (size_t) all() * TM_TL_EXPORT + TM_TL_EXPORT);
  const tm_tl_args a = kept_args(rec);
  backend->kept_show(own(), a, exported.loop_write());
  fix.pair().forward(exported, TM_TL_EXPORT);
}

// the ghosts have new places: who is searched
void AdaptLists::tell_searched()
{
  next_ul.make_room(true, all() + 1);
  backend->searched(own(), history.loop_read(), next_ul.loop_write());
  fix.pair().forward(next_ul, 1);
}

void AdaptLists::search_again(bool renumbered)
{
  if (renumbered) {
    make_room(fix.host()->atom->nmax);
    const bool same = same_places();
    const int lost = to_indices(same);
    const int mine[2] = {!same || (int) is_ul.size() < all(), lost > 0};
    int any[2];    // all ranks tell and drop, or none
    MPI_Allreduce(mine, any, 2, MPI_INT, MPI_MAX, fix.host()->world);
    if (any[1]) drop_gone(lost);
    if (any[0]) {
      rows_good = false;
      dirty.make_room(true, all() + 1);
      for (auto *a : {&which, &which_border}) a->make_room(true, own() + 1);
      for (auto *a : {&was_ul, &is_ul}) a->make_room(true, all() + 1);
      pull_back.make_room(true, (size_t) all() * TM_FREEZE_EXPORT + TM_FREEZE_EXPORT);
      tell_searched();
      backend->border_change(all(), border_args());
      any_dirty = true;
    }
  }
  if (any_dirty) active = backend->of_kind(own(), {border_args(), 1}, which.loop_write());
  {
  }
  if (active || !blind()) search_moved(!rows_good);
  else backend->zero(table.count[0].loop_write(), own() * sizeof(int));
  if (stepping && std::isfinite(approach) && time_now >= next_watch) watch();
  if (!any_dirty) return;
  const tm_interface_args border = border_args();
  backend->border(own(), border);
  at_border = backend->of_kind(own(), {border, 0}, which_border.loop_write());
  any_dirty = false;
}

// rows near those that have moved by half the margin; without a margin all, which are then those of this step
void AdaptLists::search_moved(bool all_of_them)
{
  place.make_room(true, (size_t) all() * 3 + 3);
  which_near.make_room(true, own() + 1);
  for (auto *a : {&marks, &dirty}) a->make_room(true, all() + 1);
  tm_moved_args m = {};
  m.x = fix.body().state().x;
  m.place = place.loop_write();
  m.skin = margin;
  m.part = 0.5;
  if (own_reach()) {
    reaches.make_room(true, all() + 1);
    m.size = fix.pair().rate_args().rec.size;
    m.skin = margin / reach;
    m.support = tm_kernel_support(fix.pair().settings_in_use().kernel) * spare();
    m.reach = reaches.loop_write();
  }
  if (!all_of_them && !backend->moved(all(), m)) return;
  // those that will have moved so far soon come with them
  m.part = all_of_them ? -1.0 : 0.5 * EARLY;
  m.marks = marks.loop_write();
  backend->moved(all(), m);
  make_grid(reach + margin, m.place, m.reach);
  sort_into_cells(m.place);
  int n = own();
  if (!all_of_them) {
    backend->mark(cells.grid, m.marks);
    n = backend->near_moved(own(), {cells.grid, dirty.loop_write()}, which_near.loop_write());
  } else
    backend->fill(dirty.loop_write(), 1, own());
  search(table, TM_MEETS_MECHANICAL, reach + margin, n, all_of_them ? nullptr : which_near.loop_read());
  any_dirty = rows_good = true;
}

// Looked at when two particles may have come nearer by a tenth of the reach, at the latest after 50 steps: by the time of
// steps alone, so that it does not depend on ranks, skin and restarts
void AdaptLists::watch()
{
  LAMMPS *lmp = fix.host();
  tm_proximity_args w = {};
  w.rows = kept_rows();
  w.candidates = table.loop_rows();
  w.rec = fix.pair().rate_args().rec;
  w.history = history.loop_write();
  w.is_ul = is_ul.loop_read();
  w.h = fix.pair().settings_in_use().h;
  w.support = tm_kernel_support(fix.pair().settings_in_use().kernel);
  w.near = w.support * (1.0 - approach);
  w.change = w.support * approach;
  w.time = time_now - time_watched;
  const int newly = backend->watch(own(), w);
  // of all ranks: the box that holds all velocities; two particles differ by its diagonal at most
  const tm_bounds v = backend->bounds(own(), fix.body().state().v);
  const double mine[7] = {-v.lo[0], -v.lo[1], -v.lo[2], v.hi[0], v.hi[1], v.hi[2], (double) newly};
  double most[7];
  MPI_Allreduce(mine, most, 7, MPI_DOUBLE, MPI_MAX, lmp->world);
  const double fastest = 0.5 * std::hypot(most[0] + most[3], most[1] + most[4], most[2] + most[5]);
  came_near = most[6] > 0.0;
  const double longest = 50.0 * fix.body().step_dt();
  next_watch = time_now + (fastest > 0.0 ? std::min(0.05 * reach / fastest, longest) : longest);
  time_watched = time_now;
}

tm_rows AdaptLists::mechanical()
{
  if (!keeps() || active || !blind()) return table.loop_rows();
  tm_rows r = quiet.loop_rows();
  r.mechanical = kept.loop_read();
  return r;
}

int AdaptLists::searched(tm_rates_args &a)
{
  a.rows = table.loop_rows();
  if (!keeps()) return own();
  a.which = which.loop_read();
  return active;
}

// pairs of those that are not searched whose other end is
tm_rates_args AdaptLists::border_rates(const tm_rates_args &rates)
{
  tm_rates_args border = rates;
  border.rows = quiet.loop_rows();
  border.rows.first = ul_first.loop_read();
  border.which = which_border.loop_read();
  return border;
}

void AdaptLists::kept_moments(const tm_rates_args &rates, unsigned effects)
{
  if (!keeps() || !corrects()) return;
  correction.make_room(true, (size_t) own() * 9 + 9);
  tm_tl_correction_args a = {};
  a.ul = border_rates(rates);
  a.tl = kept.loop_read();
  a.is_ul = is_ul.loop_read();
  a.history = history.loop_read();
  a.correction = correction.loop_write();
  backend->kept_moments(own(), a, effects);
}

// those at the border first
void AdaptLists::kept_rates(const tm_rates_args &rates, unsigned effects)
{
  if (!keeps()) return;
  PairLoops::of(*backend).rates(*backend, at_border, border_rates(rates), effects);
  tm_tl_args a = kept_args(rates.rec);
  a.force = rates.force;
  a.force_begins = rates.force_begins;
  a.gradient = rates.gradient;
  a.heat = rates.heat;
  a.artificial = rates.artificial;
  backend->kept_rates(own(), a, effects);
}

// on any rank
bool AdaptLists::leaps(const tm_freeze_args &a)
{
  if (!fix.body().has(TM_FX_PLASTICITY) || std::isinf(threshold)) return false;
  const int mine = backend->settle_leaps(own(), a);
  int sum;
  MPI_Allreduce(&mine, &sum, 1, MPI_INT, MPI_MAX, fix.host()->world);
  return sum > 0;
}

// who is searched next; what pairs that come to rest keep; kept gradients go with the particles
void AdaptLists::end_of_step()
{
  if (!keeps()) return;
  PairSPHTM &pair = fix.pair();
  const tm_rates_args &rates = pair.rate_args();
  tm_freeze_args a = {};
  a.rows = kept_rows();
  a.candidates = table.loop_rows();
  a.rec = rates.rec;
  a.state = fix.body().state();
  a.gradient = rates.gradient;
  a.history = history.loop_write();
  a.pull_back = pull_back.loop_write();
  a.next_ul = next_ul.loop_write();
  a.freezes = first_search || fix.host()->update->ntimestep % SETTLE_EVERY == 0;
  a.measures = fix.host()->update->ntimestep % MEASURE_EVERY == 0;
  a.corrected = fix.body().has(TM_FX_CORRECTION) && !corrects();
  a.permanent = blind();
  a.threshold = threshold;
  a.strain = strain;
  a.dt = fix.body().step_dt();
  a.h = rates.h;
  a.reach2 = rates.reach2;
  a.slope_norm = rates.slope_norm;
  a.visc_alpha = rates.visc_alpha;
  a.visc_beta = rates.visc_beta;
  const unsigned fx = fix.body().effects();
  sum_searched += active;
  last_searched = active;
  time_now += a.dt;
  a.was_ul = a.is_ul = is_ul.loop_read();
  if (!a.freezes && !came_near && fix.host()->update->ntimestep % LOOK_EVERY != 0 && !leaps(a)) {
    // as it was; the first time all are told
    a.dirty = nullptr;
    if (!looked) {
      a.which = which.loop_read();
      backend->settle(active, a, fx);
      a.which = which_border.loop_read();
    }
    backend->settle(looked ? own() : at_border, a, fx);
    looked = false;
    return;
  }
  first_search = came_near = false;
  looked = true;
  backend->settle_tell(own(), a, fx);
  pair.forward(next_ul, 1);
  if (a.freezes) {
    pair.forward(pull_back, TM_FREEZE_EXPORT);
    a.pull_back = pull_back.loop_write();
  }
  const tm_interface_args border = border_args();
  any_dirty = backend->border_change(all(), border) > 0;
  backend->fill(border.dirty, 0, own());
  if (any_dirty) backend->border_touch(own(), border);
  a.was_ul = border.was_ul;
  a.is_ul = border.is_ul;
  a.dirty = border.dirty;
  backend->settle(own(), a, fx);
}

double AdaptLists::output(int k)
{
  LAMMPS *lmp = fix.host();
  if (!keeps() && k < 2) return k == 0 ? 1.0 : 0.0;
  const double mine = k == 0 ? last_searched : k == 1 ? sum_searched : entries();
  double sum;
  MPI_Allreduce(&mine, &sum, 1, MPI_DOUBLE, MPI_SUM, lmp->world);
  return sum / std::max((double) lmp->atom->natoms, 1.0);
}

}    // namespace SPHTM_NS
