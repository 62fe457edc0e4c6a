#include "cell_search.h"

#include "atom.h"
#include "domain.h"
#include "lammps.h"

using namespace LAMMPS_NS;

namespace SPHTM_NS {

void CellSearch::move_to(Backend &b)
{
  backend = &b;
  loops = &SearchLoops::of(b);
  meets.move_to(b);
  for (auto *a : {&cell, &begin, &index, &marked}) a->move_to(b);
  for (auto &a : column) a.move_to(b);
  for (auto &a : look) a.move_to(b);
}

bool CellSearch::take_types()
{
  const std::vector<unsigned char> with =
      parts.model().pair_laws().segments(parts.model().materials(), parts.state().has(TM_FX_CONDUCTION));
  meets.assign(with.data(), with.size());
  const int n1 = parts.host()->atom->ntypes + 1;
  bool others = false;
  all_mechanical = true;
  for (int t = 1; t < n1; t++)
    for (int u = 1; u < n1; u++) {
      const int s = with[t * n1 + u];
      all_mechanical = all_mechanical && s == TM_MEETS_MECHANICAL;
      others = others || (s & ~TM_MEETS_MECHANICAL);
    }
  return others;
}

void CellSearch::make_grid(double widest, const double *x, const double *radii, bool marks)
{
  const int n = parts.owned_and_ghosts();
  cells.n = n;
  cells.x = x;
  cells.radius = radii;
  const double width = radii ? 0.5 * widest : widest;
  const tm_bounds box = loops->bounds(*backend, n, {x}, 0u);
  tm_cells_make(&cells, box, widest, width, parts.host()->domain->dimension == 3, 4 * n + 4096);
  cell.make_room(true, n + 1);
  begin.make_room(true, tm_cells_number(&cells) + 1);
  index.make_room(true, n + TM_COLUMN_MOST);
  marked.make_room(marks, n + 1);
  for (int d = 0; d < 4; d++) column[d].make_room(d < 3 || radii, n + TM_COLUMN_MOST);
  for (auto &a : look) a.make_room(radii, tm_cells_number(&cells));
}

void CellSearch::sort_into_cells(const double *x)
{
  cells.x = x;
  cells.cell = cell.loop_write();
  cells.begin = begin.loop_write();
  cells.index = index.loop_write();
  cells.marked = marked.loop_write();
  for (int d = 0; d < 4; d++) cells.column[d] = column[d].loop_write();
  for (int k = 0; k < 2; k++) cells.look[k] = look[k].loop_write();
  loops->sort_into_cells(*backend, cells);
}

int CellSearch::search(RowTable &t, int segments, double radius, int n, const int *which)
{
  tm_search_args a = {};
  a.cells = cells;
  a.radius = radius;
  a.meets = all_mechanical ? nullptr : meets.loop_read();
  a.segments = segments;
  a.type = parts.state().arrays().type;
  a.tag = parts.rows().loop_tags();
  a.ntypes = parts.host()->atom->ntypes;
  a.images = parts.owned_and_ghosts() > parts.owned();
  a.which = which;
  a.capacity = t.capacity;
  a.stride = t.stride;
  a.index = t.index.loop_write();
  a.first = t.first.loop_read();
  for (int s = 0; s < TM_SEGMENTS; s++) a.count[s] = t.count[s].loop_write();
  return loops->search(*backend, n, a, 0u);
}

double CellSearch::bytes() const
{
  double sum = meets.bytes();
  for (const auto *a : {&cell, &begin, &index, &marked}) sum += a->bytes();
  for (const auto &c : column) sum += c.bytes();
  for (const auto &c : look) sum += c.bytes();
  return sum;
}

}    // namespace SPHTM_NS
