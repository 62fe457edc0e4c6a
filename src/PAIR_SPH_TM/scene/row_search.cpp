#include "row_search.h"

#include "atom.h"
#include "domain.h"
#include "error.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

RowSearch::RowSearch(LAMMPS *lmp, Backend &where) : Pointers(lmp), loops(where)
{
  for (auto *a : {&cell, &begin, &index, &marked}) a->live_in(where);
  for (auto &c : column) c.live_in(where);
}

void RowSearch::sort(double r, const tm_state &s)
{
  const SearchLoops &of = SearchLoops::of(loops);
  const size_t n = (size_t) atom->nlocal + atom->nghost;
  radius = r;
  type = s.type;
  grid = {};
  grid.n = (int) n;
  grid.x = s.x;
  const tm_bounds box = of.bounds(loops, grid.n, {grid.x}, 0u);
  tm_cells_make(&grid, box, radius, TM_CELLS_SPARE * radius, domain->dimension == 3, 4 * grid.n + 4096);
  cell.make_room(true, n + 1);
  begin.make_room(true, tm_cells_number(&grid) + 1);
  index.make_room(true, n + TM_COLUMN_MOST);
  marked.make_room(true, n + 1);
  for (auto &c : column) c.make_room(true, n + TM_COLUMN_MOST);
  grid.cell = cell.loop_write();
  grid.begin = begin.loop_write();
  grid.index = index.loop_write();
  for (int d = 0; d < 3; d++) grid.column[d] = column[d].loop_write();
  of.sort_into_cells(loops, grid);
}

const tm_cells &RowSearch::cells_with(const unsigned char *marks)
{
  grid.marked = marked.loop_write();
  SearchLoops::of(loops).count_marked(loops, grid, marks);
  return grid;
}

void RowSearch::search(const Rows &rows, const int *which, int n, double spacing, const int *tag)
{
  const SearchLoops &of = SearchLoops::of(loops);
  const double reach = radius / spacing;
  const double lattice = domain->dimension == 3 ? 4.0 / 3.0 * TM_PI * reach * reach * reach : TM_PI * reach * reach;
  const size_t own = atom->nlocal, slice = stride();
  tm_search_args a = {};
  a.cells = grid;
  a.radius = radius;
  a.meets = rows.meets;
  a.segments = rows.meets ? TM_MEETS_MECHANICAL | TM_MEETS_THERMAL : TM_MEETS_MECHANICAL;
  a.type = type;
  a.tag = tag;
  a.ntypes = atom->ntypes;
  a.images = atom->nghost > 0;
  a.which = which;
  a.stride = (ptrdiff_t) slice;
  for (int s = 0; s < TM_SEGMENTS; s++) {
    rows.count[s]->make_room(true, own + 1);
    a.count[s] = rows.count[s]->loop_write();
    loops.zero(a.count[s], own * sizeof(int));
  }
  rows.first->make_room(true, own + 1);
  ptrdiff_t *first = rows.first->loop_write();
  loops.zero(first, own * sizeof(ptrdiff_t));
  a.first = first;
  for (int capacity = 8 * (int) ceil(1.3 * lattice / 8.0 + 1.0);;) {
    capacity = std::min(capacity, (int) TM_SEARCH_MOST);
    rows.index->make_room(true, (n + slice - 1) / slice * slice * capacity + TM_COLUMN_MOST);
    of.place_rows(loops, n, {which, capacity, a.stride, first}, 0u);
    a.capacity = capacity;
    a.index = rows.index->loop_write();
    const int longest = of.search(loops, n, a, 0u);
    if (longest <= capacity) return;
    if (longest > TM_SEARCH_MOST)
      error->one(FLERR, "Fix sph/tm active: at step {} a particle has at least {} neighbors", update->ntimestep,
                 longest);
    capacity = 8 * (int) ceil(1.25 * longest / 8.0);
  }
}

double RowSearch::bytes() const
{
  double sum = 0.0;
  for (const auto *a : {&cell, &begin, &index, &marked}) sum += a->bytes();
  for (const auto &c : column) sum += c.bytes();
  return sum;
}

}    // namespace SPHTM_NS
