#include "adapt_lists.h"

#include "argument.h"
#include "fix_adapt_neigh.h"
#include "fix_sph_tm.h"
#include "pair_sph_tm.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "lammps.h"
#include "neighbor.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

/* ---------------------------------------------------------------------- rows */

void RowTable::live_in(Backend &b)
{
  index.live_in(b);
  first.live_in(b);
  for (auto &c : count) c.live_in(b);
  capacity = particles = 0;
  stride = b.shared() ? 1 : TM_ROW_SLICE_GPU;
}

void RowTable::make_room(int n, int room)
{
  if (n <= particles && room == capacity) return;
  particles = n + n / 8 + 1;
  capacity = room;
  const ptrdiff_t slices = (particles + stride - 1) / stride;
  index.make_room(true, slices * stride * capacity + TM_COLUMN_MOST);
  std::vector<ptrdiff_t> begin(particles);
  for (ptrdiff_t i = 0; i < particles; i++) begin[i] = i / stride * stride * capacity + i % stride;
  first.assign(begin.data(), begin.size());
  for (auto &c : count) {
    c.clear();
    c.resize(particles);
  }
}

tm_rows RowTable::loop_rows()
{
  return {index.loop_read(),    first.loop_read(),    count[0].loop_read(),
          count[1].loop_read(), count[2].loop_read(), stride};
}

tm_rows RowTable::host_rows()
{
  return {index.host_read(),    first.host_read(),    count[0].host_read(),
          count[1].host_read(), count[2].host_read(), stride};
}

double RowTable::bytes() const
{
  double sum = index.bytes() + first.bytes();
  for (const auto &c : count) sum += c.bytes();
  return sum;
}

/* ---------------------------------------------------------------------- input */

int AdaptLists::keyword(int narg, char **arg)
{
  LAMMPS *lmp = fix.host();
  const std::string key = arg[0], what = "Fix adapt/neigh " + key;
  if (key != "threshold" && key != "rows") return 0;
  if (narg < 2) lmp->error->all(FLERR, "{} needs 1 value", what);
  if (key == "threshold")
    threshold = number_within(lmp, what, arg[1], -1e-300, 0.0);
  else if (key == "rows")
    rows = integer_within(lmp, what, arg[1], 1, TM_SEARCH_MOST);
  return 2;
}

void AdaptLists::init()
{
  LAMMPS *lmp = fix.host();
  if (sizeof(tagint) != sizeof(int))
    lmp->error->all(FLERR, "Fix adapt/neigh threshold: rows sort by tags of 32 bits; build LAMMPS with SMALLBIG");
  PairSPHTM &pair = fix.pair();
  const PairSPHTM::Settings &set = pair.settings_in_use();
  const int dim = lmp->domain->dimension;
  if (backend != &fix.body().loops()) {
    backend = &fix.body().loops();
    mechanicals.live_in(*backend);
    other.live_in(*backend);
    for (auto *a : {&cells.cell, &cells.begin, &cells.index}) a->live_in(*backend);
    for (auto &a : cells.column) a.live_in(*backend);
    meets.live_in(*backend);
  }
  // a little more than the rates take: which pairs are within reach they decide
  reach = tm_kernel_support(set.kernel) * set.h * (1.0 + 1e-9);
  const double cut = reach / set.spacing;
  const double lattice = dim == 3 ? 4.0 / 3.0 * TM_PI * cut * cut * cut : TM_PI * cut * cut;
  room = rows ? rows : std::min((int) TM_SEARCH_MOST, 8 * (int) ceil(2.0 * lattice / 8.0 + 1.0));
}

void *AdaptLists::extract(const char *what)
{
  return strcmp(what, RowSource::NAME) == 0 ? static_cast<RowSource *>(this) : nullptr;
}

/* ---------------------------------------------------------------------- search */

void AdaptLists::renew(bool renumbered)
{
  Atom *atom = fix.host()->atom;
  if (renumbered || mechanicals.particles < atom->nlocal) {
    const std::vector<unsigned char> with = fix.pair().segments_of_types();
    meets.assign(with.data(), with.size());
    const int n1 = atom->ntypes + 1;
    all_mechanical = true;
    bool others = false;
    for (int t = 1; t < n1; t++)
      for (int u = 1; u < n1; u++) {
        const int s = with[t * n1 + u];
        all_mechanical = all_mechanical && s == TM_MEETS_MECHANICAL;
        others = others || (s & ~TM_MEETS_MECHANICAL);
      }
    mechanicals.make_room(atom->nlocal, room);
    other.make_room(atom->nlocal, others ? room : 0);
    if (others) search_others();
    make_grid(reach);
  }
  sort_into_cells();
  search(mechanicals, TM_MEETS_MECHANICAL, reach);
}

// those that may come within reach before the particles are renumbered
void AdaptLists::search_others()
{
  const double within = reach + fix.host()->neighbor->skin;
  make_grid(within);
  sort_into_cells();
  search(other, TM_MEETS_THERMAL | TM_MEETS_CONTACT, within);
}

void AdaptLists::make_grid(double width)
{
  LAMMPS *lmp = fix.host();
  const int n = lmp->atom->nlocal + lmp->atom->nghost;
  tm_cells &g = cells.grid;
  g.n = n;
  g.x = fix.body().state().x;
  g.reach = nullptr;
  tm_cells_make(&g, backend->bounds(n, g.x), width, lmp->domain->dimension == 3, 4 * n + 4096);
  cells.cell.make_room(true, n + 1);
  cells.begin.make_room(true, tm_cells_number(&g) + 1);
  cells.index.make_room(true, n + TM_COLUMN_MOST);
  for (int d = 0; d < 3; d++) cells.column[d].make_room(true, n + TM_COLUMN_MOST);
}

void AdaptLists::sort_into_cells()
{
  tm_cells &g = cells.grid;
  g.x = fix.body().state().x;
  g.cell = cells.cell.loop_write();
  g.begin = cells.begin.loop_write();
  g.index = cells.index.loop_write();
  for (int d = 0; d < 4; d++) g.column[d] = cells.column[d].loop_write();
  backend->bin(g);
}

void AdaptLists::search(RowTable &table, int segments, double within)
{
  Atom *atom = fix.host()->atom;
  tm_search_args a = {};
  a.cells = cells.grid;
  a.reach = within;
  a.meets = all_mechanical ? nullptr : meets.loop_read();
  a.segments = segments;
  a.type = fix.body().state().type;
  a.tag = fix.pair().loop_tags();
  a.ntypes = atom->ntypes;
  a.capacity = table.capacity;
  a.stride = table.stride;
  a.index = table.index.loop_write();
  a.first = table.first.loop_read();
  for (int s = 0; s < TM_SEGMENTS; s++) a.count[s] = table.count[s].loop_write();
  const int longest = backend->search(atom->nlocal, a);
  if (longest > table.capacity) stop_on_long_row(table, longest);
}

void AdaptLists::stop_on_long_row(const RowTable &table, int longest)
{
  fix.host()->error->one(FLERR, "Fix adapt/neigh: at step {} a particle has {}{} neighbors, its row has room for {}; "
                                "write 'rows {}'", fix.host()->update->ntimestep,
                         longest > TM_SEARCH_MOST ? "at least " : "", longest, table.capacity,
                         8 * (int) ceil(1.5 * longest / 8.0));
}

double AdaptLists::bytes() const
{
  double sum = mechanicals.bytes() + other.bytes() + cells.cell.bytes() + cells.begin.bytes() + cells.index.bytes();
  for (const auto &c : cells.column) sum += c.bytes();
  return sum;
}

}    // namespace SPHTM_NS
