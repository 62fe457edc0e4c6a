/* SPH-TM: adaptive neighbor lists, the way of rows that are kept through new places in memory, migration and
   restart. */
#include "adapt_lists.h"

#include "fix_adapt_neigh.h"
#include "fix_sph_tm.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "lammps.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

/* ---------------------------------------------------------------------- places in memory */

// particles are about to get new places: until then entries of kept rows are places in a list of tags
void AdaptLists::to_tags()
{
  if (margin == 0.0 || by_tag || table.capacity == 0) return;
  fix.body().host_particles();
  const tagint *tag = fix.host()->atom->tag;
  names.assign(tag, tag + all());
  by_tag = true;
}

// the places are those they were before, of particles without images
bool AdaptLists::same_places()
{
  if (!by_tag) return false;
  fix.body().host_particles();
  const tagint *tag = fix.host()->atom->tag;
  return all() == own() && (int) names.size() == own() && std::equal(names.begin(), names.end(), tag);
}

// entry k of row i; tags: those of its entries
void AdaptLists::drop(int i, int k)
{
  const int last = --kept.host_write()[i];
  const tm_kept_rows r = kept_rows(true);
  const ptrdiff_t stride = r.stride;
  float *w = tm_weight(&r, i);
  int *index = r.index + r.first[i];
  index[k * stride] = index[last * stride];
  for (int c = 0; c < TM_WEIGHTS; c++) {
    w[tm_weight_place(&r, c, k)] = w[tm_weight_place(&r, c, last)];
    w[tm_weight_place(&r, c, last)] = 0.0f;
  }
}

// of the images of a particle the closest is meant
void AdaptLists::to_indices()
{
  if (!by_tag) return;
  by_tag = false;
  if (!keeps()) return;
  fix.body().host_particles();
  const tagint *tag = fix.host()->atom->tag;
  if (all() == own() && (int) names.size() == own() && std::equal(names.begin(), names.end(), tag)) return;
  double **x = fix.host()->atom->x;
  const int n_all = all();
  std::vector<std::pair<int, int>> places(n_all);
  for (int j = 0; j < n_all; j++) places[j] = {(int) tag[j], j};
  std::sort(places.begin(), places.end());
  // where each name is first in that order
  std::vector<int> found(names.size());
  for (size_t p = 0; p < names.size(); p++)
    found[p] = (int) (std::lower_bound(places.begin(), places.end(), std::make_pair(names[p], -1)) - places.begin());
  int *index = quiet.index.host_write(), *n = kept.host_write();
  tm_real *remembered = memory.host_write();
  const ptrdiff_t *first = quiet.first.host_read();
  for (int i = 0; i < own(); i++) {
    for (int k = 0; k < n[i]; k++) {
      int &entry = index[first[i] + k * quiet.stride];
      const int name = names[entry];
      double least = 1e300;
      for (size_t p = found[entry]; p < places.size() && places[p].first == name; p++) {
        const double *y = x[places[p].second];
        double r2 = 0.0;
        for (int d = 0; d < 3; d++) r2 += (x[i][d] - y[d]) * (x[i][d] - y[d]);
        if (r2 >= least || places[p].second == i) continue;
        least = r2;
        entry = places[p].second;
      }
      if (least < 1e300) continue;
      if (std::isinf(approach))
        fix.host()->error->one(FLERR, "Fix adapt/neigh threshold {}: the neighbor {} that particle {} keeps is gone or "
                                      "beyond the ghosts; a larger neighbor skin, or 'approach 0.01'", threshold, name,
                               tag[i]);
      // deleted, or far away: not a neighbor any more
      drop(i, k--);
      remembered[(size_t) i * TM_K + TM_K_NEAR] = TM_NEAR_HOLD;
    }
    for (int k = n[i]; k < tm_kept_places(n[i]); k++) index[first[i] + k * quiet.stride] = i;
  }
}

void AdaptLists::grow(int nmax)
{
  if (keeps() && quiet.capacity > 0) make_room(nmax);
}

void AdaptLists::copy(int from, int to)
{
  if (!keeps() || quiet.capacity == 0) return;
  const tm_kept_rows r = kept_rows(true);
  tm_real *k = memory.host_write();
  r.kept[to] = r.kept[from];
  std::copy_n(k + (size_t) from * TM_K, (int) TM_K, k + (size_t) to * TM_K);
  const float *source = tm_weight(&r, from);
  float *target = tm_weight(&r, to);
  for (int e = 0; e < tm_kept_places(r.kept[to]); e++) {
    r.index[r.first[to] + e * r.stride] = r.index[r.first[from] + e * r.stride];
    for (int c = 0; c < TM_WEIGHTS; c++) target[tm_weight_place(&r, c, e)] = source[tm_weight_place(&r, c, e)];
  }
}

void AdaptLists::set_new(int i)
{
  if (!keeps() || quiet.capacity == 0) return;
  kept.host_write()[i] = 0;
  std::fill_n(memory.host_write() + (size_t) i * TM_K, (int) TM_K, 0.0);
}

int AdaptLists::most_packed() const
{
  return keeps() ? 1 + TM_K + (room ? room : quiet.capacity) * (1 + TM_WEIGHTS) : 0;
}

int AdaptLists::pack(int i, double *buf)
{
  if (!keeps() || quiet.capacity == 0) return 0;
  const tm_kept_rows r = kept_rows(true);
  const int n = r.kept[i], *index = r.index + r.first[i];
  const ptrdiff_t stride = r.stride;
  const float *w = tm_weight(&r, i);
  double *start = buf;
  *buf++ = n;
  buf = std::copy_n(memory.host_read() + (size_t) i * TM_K, (int) TM_K, buf);
  for (int k = 0; k < n; k++) {
    *buf++ = by_tag ? names[index[k * stride]] : (int) fix.host()->atom->tag[index[k * stride]];
    for (int c = 0; c < TM_WEIGHTS; c++) *buf++ = w[tm_weight_place(&r, c, k)];
  }
  return (int) (buf - start);
}

int AdaptLists::unpack(int i, const double *buf)
{
  if (!keeps() || quiet.capacity == 0) return 0;
  const double *start = buf;
  const int n = (int) *buf++;
  const tm_kept_rows r = kept_rows(true);
  int *index = r.index + r.first[i];
  const ptrdiff_t stride = r.stride;
  float *w = tm_weight(&r, i);
  if (!by_tag) names.clear();
  by_tag = true;
  r.kept[i] = n;
  std::copy_n(buf, (int) TM_K, memory.host_write() + (size_t) i * TM_K);
  buf += TM_K;
  for (int k = 0; k < tm_kept_places(n); k++) {
    index[k * stride] = k < n ? (int) names.size() : 0;
    if (k < n) names.push_back((int) *buf++);
    for (int c = 0; c < TM_WEIGHTS; c++) w[tm_weight_place(&r, c, k)] = k < n ? (float) *buf++ : 0.0f;
  }
  return (int) (buf - start);
}

// of all ranks
std::vector<double> AdaptLists::state()
{
  double sum = 0.0;
  MPI_Allreduce(&sum_searched, &sum, 1, MPI_DOUBLE, MPI_SUM, fix.host()->world);
  return {(double) room, first_search ? 1.0 : 0.0, sum, time_now, time_watched, next_watch};
}

// rows of a file have the room of that run
void AdaptLists::restore(const double *value, size_t n)
{
  LAMMPS *lmp = fix.host();
  if (n != 6) lmp->error->all(FLERR, "Fix adapt/neigh: the restart file was written with other keywords");
  first_search = value[1] > 0.5;
  sum_searched = lmp->comm->me == 0 ? value[2] : 0.0;
  time_now = value[3];
  time_watched = value[4];
  next_watch = value[5];
  if (!keeps()) return;
  room = (int) value[0];
  if (room > 0) make_room(lmp->atom->nmax);
  fix.update_packed_size();
}

void *AdaptLists::extract(const char *what)
{
  if (strcmp(what, RowSource::NAME) == 0) return static_cast<RowSource *>(this);
  if (strcmp(what, "memory of lists") == 0) return keeps() ? (void *) memory.loop_read() : nullptr;
  return nullptr;
}

}    // namespace SPHTM_NS
