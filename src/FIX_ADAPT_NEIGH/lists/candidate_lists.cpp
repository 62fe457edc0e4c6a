#include "candidate_lists.h"

#include "domain.h"
#include "error.h"
#include "lammps.h"
#include "neighbor.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

// rows near particles that have moved by this part of the limit are searched with those that must be
static constexpr double EARLY = 0.25;

void CandidateLists::init(bool with_total_lagrangian)
{
  const Settings &set = parts.model().settings_in_use();
  const int dim = parts.host()->domain->dimension;
  total_lagrangian = with_total_lagrangian;
  fixed_room = given_room || total_lagrangian;
  cover_radius();
  const double cut = (widest + skin) / set.spacing;
  const double lattice = dim == 3 ? 4.0 / 3.0 * TM_PI * cut * cut * cut : TM_PI * cut * cut;
  const double more = skin > 0.0 ? 1.5 : 2.0;    // than in the lattice
  room_of_row = given_room ? 8 * ((given_room + 7) / 8)
                           : std::min((int) TM_SEARCH_MOST, 8 * (int) ceil(more * lattice / 8.0 + 1.0));
  room_of_other = room_of_row;
}

// arrays live where the loops run
void CandidateLists::move_to(Backend &b)
{
  backend = &b;
  loops = &ListLoops::of(b);
  cells.move_to(b);
  for (auto *t : {&table, &other}) t->move_to(b);
  for (auto *a : {&place, &radii}) a->move_to(b);
  for (auto *a : {&marks, &dirty}) a->move_to(b);
  which.move_to(b);
}

bool CandidateLists::own_radii() const { return parts.state().has(TM_FX_SMOOTHING); }

// Rows reach a little further than the rates take, which decide which pairs are within the search radius. Refinement reads rows at
// the end of the step, half a step and perhaps a change of h later
double CandidateLists::spare() const { return parts.uses("refine") ? 1.02 : 1.0 + 1e-9; }

void CandidateLists::cover_radius()
{
  const Settings &set = parts.model().settings_in_use();
  const double covered = tm_kernel_support(set.kernel) * std::max(set.h, parts.model().covered_h()) * spare();
  good = good && covered == widest;
  widest = covered;
  skin = (skin_over_radius >= 0.0 ? skin_over_radius : total_lagrangian ? 0.15 : 0.0) * widest;
}

/* ---------------------------------------------------------------------- search */

void CandidateLists::renumbered()
{
  const int n = parts.owned();
  const bool others = cells.take_types();
  cover_radius();
  if (!total_lagrangian) make_room(n);
  other.make_room(n, others ? room_of_other : 0);
  const double *x = parts.state().arrays().x;
  if (others) {    // those that may come within the search radius before the particles are renumbered
    const double within = widest + parts.host()->neighbor->skin;
    cells.make_grid(within, x, nullptr, skin > 0.0);
    cells.sort_into_cells(x);
    search(other, room_of_other, TM_MEETS_THERMAL | TM_MEETS_CONTACT, within, n);
  }
  if (!may_remain()) cells.make_grid(widest, x);
}

void CandidateLists::search_all()
{
  cells.sort_into_cells(parts.state().arrays().x);
  search(table, room_of_row, TM_MEETS_MECHANICAL, widest, parts.owned());
}

bool CandidateLists::search_moved(bool all_rows)
{
  const int owned = parts.owned(), all = parts.owned_and_ghosts();
  place.make_room(true, (size_t) all * 3 + 3);
  which.make_room(true, owned + 1);
  for (auto *a : {&marks, &dirty}) a->make_room(true, all + 1);
  tm_moved_args m = {};
  m.x = parts.state().arrays().x;
  m.place = place.loop_write();
  m.skin = skin;
  m.part = 0.5;
  if (own_radii()) {
    radii.make_room(true, all + 1);
    m.size = parts.results().rate_args().rec.size;
    m.skin = skin / widest;
    m.support = tm_kernel_support(parts.model().settings_in_use().kernel) * spare();
    m.radius = radii.loop_write();
  }
  if (!all_rows && !loops->moved(*backend, all, m, 0u)) return false;
  m.part = all_rows ? -1.0 : 0.5 * EARLY;
  m.marks = marks.loop_write();
  loops->moved(*backend, all, m, 0u);
  cells.make_grid(widest + skin, m.place, m.radius, skin > 0.0);
  cells.sort_into_cells(m.place);
  int n = owned;
  if (!all_rows) {
    SearchLoops::of(*backend).count_marked(*backend, cells.grid(), m.marks);
    n = loops->near_moved(*backend, owned, {cells.grid(), dirty.loop_write()}, which.loop_write());
  } else backend->fill(dirty.loop_write(), 1, owned);
  search(table, room_of_row, TM_MEETS_MECHANICAL, widest + skin, n, all_rows ? nullptr : which.loop_read());
  good = true;
  return true;
}

// room: of a row of the table
void CandidateLists::search(RowTable &t, int &room, int segments, double radius, int n, const int *of)
{
  const int longest = cells.search(t, segments, radius, n, of);
  if (longest <= t.capacity) return;
  if (fixed_room || longest > TM_SEARCH_MOST) stop_on_long_row(t.capacity, longest);
  room = std::min((int) TM_SEARCH_MOST, 8 * (int) ceil(1.25 * longest / 8.0));
  t.make_room(parts.owned(), room);
  search(t, room, segments, radius, parts.owned());
}

void CandidateLists::stop_on_long_row(int capacity, int longest) const
{
  parts.host()->error->one(FLERR,
                           "Fix adapt/neigh: at step {} a particle has {}{} neighbors, its row has room for {}; "
                           "write 'rows {}'",
                           parts.host()->update->ntimestep, longest > TM_SEARCH_MOST ? "at least " : "", longest,
                           capacity, 8 * (int) ceil(1.5 * longest / 8.0));
}

double CandidateLists::entries()
{
  double sum = 0.0;
  const int owned = parts.owned();
  const int *n = table.particles < owned ? nullptr : table.count[0].host_read();
  for (int i = 0; n && i < owned; i++) sum += n[i];
  return sum;
}

double CandidateLists::bytes() const
{
  return table.bytes() + other.bytes() + cells.bytes() + place.bytes() + radii.bytes() + marks.bytes() + dirty.bytes() +
         which.bytes();
}

}    // namespace SPHTM_NS
