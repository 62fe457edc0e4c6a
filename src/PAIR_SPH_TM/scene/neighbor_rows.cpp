#include "neighbor_rows.h"

#include "model.h"
#include "particle_state.h"
#include "row_search.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "force.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "pair.h"
#include "utils.h"

#include <algorithm>
#include <memory>
#include <numeric>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

NeighborRows::NeighborRows(LAMMPS *lmp, Pair *p, Backend &loops, Model &m) :
    Pointers(lmp), backend(loops), model(m), pair(p)
{
  for (auto *a : {&row_index, &row_mechanical, &row_thermal, &row_contact}) a->live_in(loops);
  row_first.live_in(loops);
  meets.live_in(loops);
  for (auto *a : {&row_index, &row_mechanical, &row_thermal, &row_contact}) a->call("rows of neighbors");
  row_first.call("rows of neighbors");
}

void NeighborRows::init(const ParticleState &state, RowSource *source)
{
  row_source = source;
  sizes_differ = state.has(TM_FX_SMOOTHING);
  check_list_size(model.smallest_spacing());
}

void NeighborRows::make_room()
{
  const size_t n = (size_t) atom->nlocal + 1;
  row_first.make_room(true, n);
  for (auto *a : {&row_mechanical, &row_thermal, &row_contact}) a->make_room(true, n);
}

tm_rows NeighborRows::loop_rows()
{
  return {row_index.loop_read(),
          row_first.loop_read(),
          row_mechanical.loop_read(),
          row_thermal.loop_read(),
          row_contact.loop_read(),
          row_stride,
          nullptr,
          0};
}

tm_rows NeighborRows::host_rows()
{
  if (row_source) return row_source->host_mechanical();
  return {row_index.host_read(),
          row_first.host_read(),
          row_mechanical.host_read(),
          row_thermal.host_read(),
          row_contact.host_read(),
          row_stride,
          nullptr,
          0};
}

const int *NeighborRows::loop_tags() { return (const int *) atom->tag; }

double NeighborRows::bytes() const
{
  double sum = row_index.bytes() + row_first.bytes();
  for (auto *a : {&row_mechanical, &row_thermal, &row_contact}) sum += a->bytes();
  return sum;
}

/* ---------------------------------------------------------------------- LAMMPS's lists */

// room for the neighbors of a body compressed to a third: LAMMPS's own is meant for molecules
void NeighborRows::check_list_size(double dp)
{
  // smoothing lengths may double during a run
  const double h = (sizes_differ ? 2.0 : 1.0) * model.covered_h();
  const double cut = (tm_kernel_support(model.settings_in_use().kernel) * h + neighbor->skin) / dp;
  const double inside = domain->dimension == 3 ? 4.0 / 3.0 * TM_PI * cut * cut * cut : TM_PI * cut * cut;
  const int need = (int) std::min(1e7, 3.0 * inside);
  if (neighbor->oneatom >= need) return;
  neighbor->oneatom = need;
  neighbor->pgsize = std::max(neighbor->pgsize, 10 * need);
  if (comm->me == 0)
    utils::logmesg(lmp, "sph/tm: neigh_modify one {} page {}, for the reach of the kernel\n", need, neighbor->pgsize);
}

void NeighborRows::make_room_for(double share) { check_list_size(share * model.smallest_spacing()); }

void NeighborRows::cover_sizes(double h, double dp)
{
  model.cover_sizes(h, dp);
  sizes_differ = true;
  const double cut = pair->cutforce = tm_kernel_support(model.settings_in_use().kernel) * h;
  Pair *whole = force->pair;    // a hybrid style, or the same
  for (int i = 1; i <= model.types(); i++)
    for (int j = 1; j <= model.types(); j++) {
      pair->cutsq[i][j] = cut * cut;
      if (whole != pair) whole->cutsq[i][j] = std::max(whole->cutsq[i][j], pair->cutsq[i][j]);
    }
  if (whole != pair) whole->cutforce = std::max(whole->cutforce, cut);
  check_list_size(dp);
}

/* ----------------------------------------------------------------------
   rows: mechanical neighbors, heat-only ones, contact candidates; each
   segment in order of tag, so that sums do not depend on the order in memory.
   No row is sorted: the pairs are put into columns, one per particle, and the
   columns, walked in order of tag, deal their particle out to the rows
------------------------------------------------------------------------- */

void NeighborRows::build(NeighList *list, bool conduction)
{
  const int nlocal = atom->nlocal, nall = nlocal + atom->nghost, *type = atom->type;
  const int n1 = model.types() + 1;
  const tagint *tag = atom->tag;
  const std::vector<unsigned char> segments = model.pair_laws().segments(model.materials(), conduction);

  // images of one particle in order of memory
  std::vector<int> by_tag(nall);
  std::iota(by_tag.begin(), by_tag.end(), 0);
  std::sort(by_tag.begin(), by_tag.end(), [tag](int a, int b) { return tag[a] != tag[b] ? tag[a] < tag[b] : a < b; });
  struct Particle {
    int rank, type;
  };
  std::vector<Particle> particle(nall);
  for (int r = 0; r < nall; r++) particle[by_tag[r]] = {r, type[by_tag[r]]};

  make_room();
  int *mechanicals = row_mechanical.host_write(), *thermals = row_thermal.host_write();
  int *contacts = row_contact.host_write();
  ptrdiff_t *first = row_first.host_write();
  std::vector<ptrdiff_t> column_end(nall + 1, 0);
  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii], *jlist = list->firstneigh[i], jnum = list->numneigh[i];
    const unsigned char *with = segments.data() + (ptrdiff_t) type[i] * n1;
    int mechanical = 0, thermal = 0, contact = 0;
    for (int jj = 0; jj < jnum; jj++) {
      const Particle p = particle[jlist[jj] & NEIGHMASK];
      const int s = with[p.type];
      mechanical += (s & TM_MEETS_MECHANICAL) != 0;
      thermal += (s & TM_MEETS_THERMAL) != 0;
      contact += (s & TM_MEETS_CONTACT) != 0;
      column_end[p.rank + 1] += s != 0;
    }
    mechanicals[i] = mechanical;
    thermals[i] = thermal;
    contacts[i] = contact;
  }
  // starts, which the next pass moves to the ends
  std::partial_sum(column_end.begin(), column_end.end(), column_end.begin());
  std::unique_ptr<unsigned[]> column(new unsigned[column_end[nall] + 1]);
  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii], *jlist = list->firstneigh[i], jnum = list->numneigh[i];
    const unsigned char *with = segments.data() + (ptrdiff_t) type[i] * n1;
    for (int jj = 0; jj < jnum; jj++) {
      const Particle p = particle[jlist[jj] & NEIGHMASK];
      const unsigned s = with[p.type];
      if (s) column[column_end[p.rank]++] = ((unsigned) i << TM_SEGMENTS) | s;
    }
  }

  std::vector<ptrdiff_t> next[3];
  for (auto &n : next) n.resize(nlocal);
  ptrdiff_t total = 0;
  for (int i = 0; i < nlocal; i++) {
    first[i] = next[0][i] = total;
    next[1][i] = next[0][i] + mechanicals[i];
    next[2][i] = next[1][i] + thermals[i];
    total = next[2][i] + contacts[i];
  }
  row_index.make_room(true, total + 1);
  int *index = row_index.host_write();
  ptrdiff_t k = 0;
  for (int r = 0; r < nall; r++)
    for (; k < column_end[r]; k++) {
      const unsigned i = column[k] >> TM_SEGMENTS;
      if (column[k] & TM_MEETS_MECHANICAL) index[next[0][i]++] = by_tag[r];
      if (column[k] & TM_MEETS_THERMAL) index[next[1][i]++] = by_tag[r];
      if (column[k] & TM_MEETS_CONTACT) index[next[2][i]++] = by_tag[r];
    }
}

/* ---------------------------------------------------------------------- rows of some particles */

void NeighborRows::build(RowSearch &finder, const int *which, int n, bool conduction)
{
  const std::vector<unsigned char> segments = model.pair_laws().segments(model.materials(), conduction);
  const int n1 = model.types() + 1;
  bool alike = true;
  for (int t = 1; t < n1; t++)
    for (int u = 1; u < n1; u++) alike = alike && segments[t * n1 + u] == TM_MEETS_MECHANICAL;
  meets.assign(segments.data(), segments.size());
  row_stride = finder.stride();
  finder.search(
      {alike ? nullptr : meets.loop_read(), &row_index, {&row_mechanical, &row_thermal, &row_contact}, &row_first},
      which, n, model.settings_in_use().spacing, loop_tags());
}

}    // namespace SPHTM_NS
