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

using namespace LAMMPS_NS;

namespace SPHTM_NS {

/* ---------------------------------------------------------------------- input */

bool AdaptLists::keyword(Keywords &k)
{
  if (k.is("threshold")) threshold = k.take("inf") ? INFINITY : k.not_negative();
  else if (k.is("stretch")) strain = k.take("inf") ? INFINITY : k.positive();
  else if (k.is("approach")) approach = k.take("inf") ? INFINITY : k.within(0.0, 0.5);
  else if (k.is("margin")) wide = k.within(0.0, 1.0);
  else if (k.is("rows")) rows = k.integer(1, TM_SEARCH_MOST);
  else return false;
  return true;
}

void AdaptLists::init()
{
  LAMMPS *lmp = fix.host();
  if (sizeof(tagint) != sizeof(int))
    lmp->error->all(FLERR, "Fix adapt/neigh threshold: rows sort by tags of 32 bits; build LAMMPS with SMALLBIG");
  const Neighbor *lists = lmp->neighbor;
  if (lists->nex_type || lists->nex_group || lists->nex_mol)
    lmp->error->all(FLERR, "Fix adapt/neigh threshold: its rows know nothing of 'neigh_modify exclude'; leave that out, and "
                           "say with 'pair_coeff i j none' which types do not meet");
  PairSPHTM &pair = fix.pair();
  const PairSPHTM::Settings &set = pair.settings_in_use();
  const int dim = lmp->domain->dimension;
  if (strain < 0.0) strain = std::isinf(threshold) ? INFINITY : 0.2;
  if (approach < 0.0) approach = std::isinf(threshold) ? INFINITY : 0.01;
  cover_reach();
  const double cut = (reach + margin) / set.spacing;
  const double lattice = dim == 3 ? 4.0 / 3.0 * TM_PI * cut * cut * cut : TM_PI * cut * cut;
  const double more = margin > 0.0 ? 1.5 : 2.0;    // than in the lattice
  room = rows ? 8 * ((rows + 7) / 8) : std::min((int) TM_SEARCH_MOST, 8 * (int) ceil(more * lattice / 8.0 + 1.0));
  if (keeps()) check_kernel();
  const std::vector<std::vector<double>> rows_of = take_rows();
  move_to(fix.body().loops());
  if (keeps()) make_room(lmp->atom->nmax);
  put_rows(rows_of);
  weight_unit = tm_tl_unit(set.kernel);
  fix.update_packed_size();
}

// arrays live where the loops run
void AdaptLists::move_to(Backend &loops)
{
  backend = &loops;
  for (auto *t : {&table, &quiet, &other}) t->move_to(*backend);
  for (auto *a : {&cells.cell, &cells.begin, &cells.index, &cells.marked, &kept, &which, &which_border, &which_near,
                  &names, &tag_head, &other_holder})
    a->move_to(*backend);
  for (auto &a : cells.column) a.move_to(*backend);
  for (auto &a : cells.look) a.move_to(*backend);
  for (auto *a : {&history, &exported, &pull_back, &next_ul, &correction}) a->move_to(*backend);
  for (auto *a : {&meets, &marks, &was_ul, &is_ul, &dirty, &gone}) a->move_to(*backend);
  ul_first.move_to(*backend);
  weight.move_to(*backend);
  place.move_to(*backend);
  reaches.move_to(*backend);
}

bool AdaptLists::own_reach() const { return fix.body().has(TM_FX_SMOOTHING); }

// Rows reach a little further than the rates take: which pairs are within reach they decide. Refinement looks at rows
// at the end of the step, half a step and perhaps a change of h later
double AdaptLists::spare() const { return fix.uses("refine") ? 1.02 : 1.0 + 1e-9; }

// the largest
void AdaptLists::cover_reach()
{
  const PairSPHTM::Settings &set = fix.pair().settings_in_use();
  const double now_covered = tm_kernel_support(set.kernel) * std::max(set.h, fix.pair().covered_h()) * spare();
  rows_good = rows_good && now_covered == reach;
  reach = now_covered;
  margin = (wide >= 0.0 ? wide : keeps() ? 0.15 : 0.0) * reach;
}

// what rows that are kept know nothing of
void AdaptLists::check_effects()
{
  Error *error = fix.host()->error;
  const FixSPHTM &body = fix.body();
  const struct { unsigned effect; const char *what; } without[] = {
      {TM_FX_FORM_F14, "pair_style form f14; use form f15"},
      {TM_FX_XSPH, "pair_style xsph; use xsph 0"},
      {TM_FX_BALSARA, "pair_style balsara yes; use balsara no"},
      {TM_FX_SURFACE, "the surface of particles (fix sph/tm/heat, surface/area)"},
      {TM_FX_SMOOTHING, "particles with a smoothing length of their own"},
      {TM_FX_MIXED, "pair_style precision mixed; use precision double"}};
  for (const auto &w : without)
    if (body.has(w.effect))
      error->all(FLERR, "Fix adapt/neigh threshold {}: rows that are kept do not support {}; or use threshold 0",
                 threshold, w.what);
  if (fix.pair().settings_in_use().art_balanced && body.has(TM_FX_ARTSTRESS))
    error->all(FLERR, "Fix adapt/neigh threshold {}: pair_style artstress balanced needs threshold 0: kept rows have "
                      "no artificial stress; leave balanced away", threshold);
}

/* ---------------------------------------------------------------------- search */

void AdaptLists::renew(bool renumbered)
{
  if (renumbered || table.particles < own()) {
    Atom *atom = fix.host()->atom;
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
    cover_reach();
    if (!keeps()) table.make_room(own(), room);
    other.make_room(own(), others ? room : 0);
    if (others) search_others();
    if (margin == 0.0 && !own_reach()) make_grid(reach, fix.body().state().x);
    renumbered = true;
  }
  if (keeps()) {
    search_again(renumbered);
    return;
  }
  if (margin > 0.0 || own_reach()) {
    const bool same = !renumbered || same_places();
    by_tag = false;
    search_moved(!same || !rows_good || margin == 0.0);
    return;
  }
  sort_into_cells(fix.body().state().x);
  search(table, TM_MEETS_MECHANICAL, reach, own());
}

// those that may come within reach before the particles are renumbered
void AdaptLists::search_others()
{
  const double within = reach + fix.host()->neighbor->skin;
  const double *x = fix.body().state().x;
  make_grid(within, x);
  sort_into_cells(x);
  search(other, TM_MEETS_THERMAL | TM_MEETS_CONTACT, within, own());
}

// reaches: of each particle; or nullptr: all `widest`
void AdaptLists::make_grid(double widest, const double *x, const double *reaches)
{
  LAMMPS *lmp = fix.host();
  const int n = lmp->atom->nlocal + lmp->atom->nghost;
  tm_cells &g = cells.grid;
  g.n = n;
  g.x = x;
  g.reach = reaches;
  const double width = reaches ? 0.5 * widest : widest;
  tm_cells_make(&g, backend->bounds(n, g.x), widest, width, lmp->domain->dimension == 3, 4 * n + 4096);
  cells.cell.make_room(true, n + 1);
  cells.begin.make_room(true, tm_cells_number(&g) + 1);
  cells.index.make_room(true, n + TM_COLUMN_MOST);
  cells.marked.make_room(margin > 0.0, n + 1);
  for (int d = 0; d < 4; d++) cells.column[d].make_room(d < 3 || reaches, n + TM_COLUMN_MOST);
  for (auto &a : cells.look) a.make_room(reaches, tm_cells_number(&g));
}

void AdaptLists::sort_into_cells(const double *x)
{
  tm_cells &g = cells.grid;
  g.x = x;
  g.cell = cells.cell.loop_write();
  g.begin = cells.begin.loop_write();
  g.index = cells.index.loop_write();
  g.marked = cells.marked.loop_write();
  for (int d = 0; d < 4; d++) g.column[d] = cells.column[d].loop_write();
  for (int k = 0; k < 2; k++) g.look[k] = cells.look[k].loop_write();
  backend->bin(g);
}

tm_search_args AdaptLists::search_args(int segments, double within)
{
  tm_search_args a = {};
  a.cells = cells.grid;
  a.reach = within;
  a.meets = all_mechanical ? nullptr : meets.loop_read();
  a.segments = segments;
  a.type = fix.body().state().type;
  a.tag = fix.pair().loop_tags();
  a.ntypes = fix.host()->atom->ntypes;
  a.images = all() > own();
  return a;
}

// of so many particles: those listed, or the first
void AdaptLists::search(RowTable &t, int segments, double within, int n, const int *of)
{
  tm_search_args a = search_args(segments, within);
  a.which = of;
  a.capacity = t.capacity;
  a.stride = t.stride;
  a.index = t.index.loop_write();
  a.first = t.first.loop_read();
  for (int s = 0; s < TM_SEGMENTS; s++) a.count[s] = t.count[s].loop_write();
  const int longest = backend->search(n, a);
  if (longest <= t.capacity) return;
  if (rows || keeps() || longest > TM_SEARCH_MOST) stop_on_long_row(t.capacity, longest);
  room = std::min((int) TM_SEARCH_MOST, 8 * (int) ceil(1.25 * longest / 8.0));
  t.make_room(own(), room);
  search(t, segments, within, own());
}

void AdaptLists::stop_on_long_row(int capacity, int longest)
{
  fix.host()->error->one(FLERR, "Fix adapt/neigh: at step {} a particle has {}{} neighbors, its row has room for {}; "
                                "write 'rows {}'", fix.host()->update->ntimestep,
                         longest > TM_SEARCH_MOST ? "at least " : "", longest, capacity,
                         8 * (int) ceil(1.5 * longest / 8.0));
}

// in all rows of this rank
double AdaptLists::entries()
{
  double sum = 0.0;
  const int *n = table.particles < own() ? nullptr : table.count[0].host_read();
  for (int i = 0; n && i < own(); i++) sum += n[i];
  return sum;
}

double AdaptLists::bytes() const
{
  double sum = table.bytes() + quiet.bytes() + other.bytes() + ul_first.bytes() + weight.bytes() + place.bytes() +
      reaches.bytes();
  for (const auto *a : {&cells.cell, &cells.begin, &cells.index, &cells.marked, &kept, &which, &which_border,
                        &which_near, &names, &tag_head, &other_holder})
    sum += a->bytes();
  for (const auto &c : cells.column) sum += c.bytes();
  for (const auto &c : cells.look) sum += c.bytes();
  for (const auto *a : {&history, &exported, &pull_back, &next_ul, &correction}) sum += a->bytes();
  for (const auto *a : {&meets, &marks, &was_ul, &is_ul, &dirty, &gone}) sum += a->bytes();
  return sum;
}

}    // namespace SPHTM_NS
