#include "row_search.h"

#include "atom.h"
#include "domain.h"
#include "error.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

RowSearch::RowSearch(LAMMPS *lmp, Backend &where) : Pointers(lmp), loops(where) {}

void RowSearch::sort(double r)
{
  const SearchLoops &of = SearchLoops::of(loops);
  const int n = atom->nlocal + atom->nghost;
  radius = r;
  grid = {};
  grid.n = n;
  grid.x = n ? atom->x[0] : nullptr;
  const tm_bounds box = of.bounds(loops, n, {grid.x}, 0u);
  tm_cells_make(&grid, box, radius, TM_CELLS_SPARE * radius, domain->dimension == 3, 4 * n + 4096);
  cell.resize(n + 1);
  begin.resize(tm_cells_number(&grid) + 1);
  index.resize(n + TM_COLUMN_MOST);
  for (auto &c : column) c.resize(n + TM_COLUMN_MOST);
  grid.cell = cell.data();
  grid.begin = begin.data();
  grid.index = index.data();
  for (int d = 0; d < 3; d++) grid.column[d] = column[d].data();
  of.sort_into_cells(loops, grid);
}

const tm_cells &RowSearch::cells_with(const tm_real *flag, tm_real least)
{
  marked.resize(grid.n + 1);
  marked[0] = 0;
  for (int k = 0; k < grid.n; k++) marked[k + 1] = marked[k] + (flag[grid.index[k]] >= least);
  grid.marked = marked.data();
  return grid;
}

void RowSearch::search(const Rows &rows, const std::vector<int> &which, double spacing, const int *tag)
{
  const double reach = radius / spacing;
  const double lattice = domain->dimension == 3 ? 4.0 / 3.0 * TM_PI * reach * reach * reach : TM_PI * reach * reach;
  const size_t own = (size_t) atom->nlocal + 1;
  tm_search_args a = {};
  a.cells = grid;
  a.radius = radius;
  a.meets = rows.meets.empty() ? nullptr : rows.meets.data();
  a.segments = rows.meets.empty() ? TM_MEETS_MECHANICAL : TM_MEETS_MECHANICAL | TM_MEETS_THERMAL;
  a.type = atom->type;
  a.tag = tag;
  a.ntypes = atom->ntypes;
  a.images = atom->nghost > 0;
  a.which = which.data();
  a.stride = 1;
  for (int s = 0; s < TM_SEGMENTS; s++) {
    rows.count[s]->make_room(true, own);
    a.count[s] = rows.count[s]->loop_write();
    std::fill_n(a.count[s], atom->nlocal, 0);
  }
  rows.first->make_room(true, own);
  ptrdiff_t *first = rows.first->loop_write();
  std::fill_n(first, atom->nlocal, 0);
  for (int capacity = 8 * (int) ceil(1.3 * lattice / 8.0 + 1.0);;) {
    capacity = std::min(capacity, (int) TM_SEARCH_MOST);
    for (size_t k = 0; k < which.size(); k++) first[which[k]] = (ptrdiff_t) k * capacity;
    rows.index->make_room(true, which.size() * capacity + TM_COLUMN_MOST);
    a.capacity = capacity;
    a.index = rows.index->loop_write();
    a.first = first;
    const int longest = SearchLoops::of(loops).search(loops, (int) which.size(), a, 0u);
    if (longest <= capacity) return;
    if (longest > TM_SEARCH_MOST)
      error->one(FLERR, "Fix sph/tm active: at step {} a particle has at least {} neighbors", update->ntimestep,
                 longest);
    capacity = 8 * (int) ceil(1.25 * longest / 8.0);
  }
}

double RowSearch::bytes() const
{
  return sizeof(int) * (double) (cell.size() + begin.size() + index.size() + marked.size()) +
         3.0 * sizeof(tm_real) * column[0].size();
}

}    // namespace SPHTM_NS
