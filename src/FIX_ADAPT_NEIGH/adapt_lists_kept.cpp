/* SPH-TM: adaptive neighbor lists, rows that are kept: their steps, and their way through migration and restart. */
#include "adapt_lists.h"

#include "fix_adapt_neigh.h"
#include "fix_sph_tm.h"
#include "pair_sph_tm.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "lammps.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

int AdaptLists::own() const { return fix.host()->atom->nlocal; }
int AdaptLists::all() const { return fix.host()->atom->nlocal + fix.host()->atom->nghost; }

void AdaptLists::make_room(int n)
{
  if (room != table.capacity) kept.clear();
  table.make_room(n, room);
  kept.resize(table.particles);
  fresh_first.resize(table.particles);
  weight.resize(table.slots() * TM_WEIGHTS);
  memory.resize((size_t) table.particles * TM_K);
}

tm_kept_rows AdaptLists::kept_rows()
{
  tm_kept_rows r;
  r.index = table.index.loop_write();
  r.kept = kept.loop_write();
  r.fresh = table.count[0].loop_write();
  r.first = table.first.loop_read();
  r.fresh_first = fresh_first.loop_write();
  r.stride = table.stride;
  r.capacity = table.capacity;
  r.weight = weight.loop_write();
  return r;
}

/* ---------------------------------------------------------------------- one step */

tm_kept_args AdaptLists::kept_args(const tm_records &rec)
{
  const tm_rates_args &rates = fix.pair().rate_args();
  tm_kept_args a = {};
  a.rows = kept_rows();
  a.rec = rec;
  a.shown = shown.loop_write();
  a.memory = memory.loop_read();
  a.h = rates.h;
  a.slope_norm = rates.slope_norm;
  a.visc_alpha = rates.visc_alpha;
  a.visc_beta = rates.visc_beta;
  a.force_unit = rates.force_unit;
  return a;
}

void AdaptLists::show(const tm_records &rec)
{
  if (!keeps()) return;
  check_effects();
  shown.make_room(true, (size_t) all() * TM_KEPT + TM_KEPT);
  const tm_kept_args a = kept_args(rec);
  backend->kept_show(own(), a, shown.loop_write());
  fix.pair().forward(shown, TM_KEPT);
}

// the ghosts have new places: who is searched
void AdaptLists::tell_searched()
{
  told.make_room(true, (size_t) all() * TM_TOLD + TM_TOLD);
  tm_real *t = told.host_write();
  const tm_real *k = memory.host_read();
  for (int i = 0; i < own(); i++)
    t[(size_t) i * TM_TOLD + TM_TOLD_SEARCHED] = tm_is_searched(k + (size_t) i * TM_K);
  fix.pair().forward(told, TM_TOLD);
}

void AdaptLists::search_again(bool renumbered)
{
  if (renumbered) {
    make_room(fix.host()->atom->nmax);
    to_indices();
    tell_searched();
    whole.make_room(true, own() + 1);
    which.make_room(true, own() + 1);
    marks.make_room(true, all() + 1);
  }
  const int searched = backend->flag(all(), told.loop_read(), marks.loop_write());
  backend->zero(table.count[0].loop_write(), own() * sizeof(int));
  if (stepping && std::isfinite(approach) && time_now >= next_watch) {
    watch();
    renumbered = true;
  }
  if (renumbered) make_grid(reach);
  if (searched) {
    sort_into_cells();
    backend->mark(cells.grid, marks.loop_read());
    search(table, TM_MEETS_MECHANICAL, reach);
  }
  active = backend->active(own(), kept_rows(), whole.loop_write(), which.loop_write());
}

// Looked at when a pair may have moved by a tenth of the reach, at the latest after 50 steps: by the time of
// steps alone, so that it does not depend on ranks, skin and restarts
void AdaptLists::watch()
{
  LAMMPS *lmp = fix.host();
  make_grid(1.1 * reach);
  sort_into_cells();
  tm_watch_args w = {};
  w.search = search_args(TM_MEETS_MECHANICAL, reach);
  w.rows = kept_rows();
  w.rec = fix.pair().rate_args().rec;
  w.memory = memory.loop_write();
  w.searched = marks.loop_read();
  w.h = fix.pair().settings_in_use().h;
  const double support = tm_kernel_support(fix.pair().settings_in_use().kernel);
  w.near = support * (1.0 - approach);
  w.change = support * approach;
  w.time = time_now - time_watched;
  backend->watch(own(), w);
  const double mine = backend->fastest(own(), fix.body().state());
  double fastest;
  MPI_Allreduce(&mine, &fastest, 1, MPI_DOUBLE, MPI_MAX, lmp->world);
  const double longest = 50.0 * fix.body().step_dt();
  next_watch = time_now + (fastest > 0.0 ? std::min(0.05 * reach / fastest, longest) : longest);
  time_watched = time_now;
}

tm_rows AdaptLists::mechanical()
{
  tm_rows r = table.loop_rows();
  if (keeps()) r.mechanical = whole.loop_read();
  return r;
}

int AdaptLists::searched(tm_rates_args &a)
{
  a.rows = table.loop_rows();
  if (!keeps()) return own();
  a.rows.first = fresh_first.loop_read();
  a.which = which.loop_read();
  return active;
}

void AdaptLists::kept_rates(const tm_rates_args &rates, unsigned effects)
{
  if (!keeps()) return;
  stretch.make_room(true, (size_t) own() * 9 + 9);
  tm_kept_args a = kept_args(rates.rec);
  a.force = rates.force;
  a.force_begins = rates.force_begins;
  a.gradient = rates.gradient;
  a.heat = rates.heat;
  a.artificial = rates.artificial;
  a.stretch = stretch.loop_write();
  backend->kept_rates(own(), a, effects);
}

// who is searched next; what pairs searched in this step keep; kept gradients go with the particles
void AdaptLists::end_of_step()
{
  if (!keeps()) return;
  PairSPHTM &pair = fix.pair();
  const tm_rates_args &rates = pair.rate_args();
  tm_settle_args a = {};
  a.rows = kept_rows();
  a.rec = rates.rec;
  a.state = fix.body().state();
  a.gradient = rates.gradient;
  a.stretch = stretch.loop_read();
  a.memory = memory.loop_write();
  a.told = told.loop_write();
  a.corrected = fix.body().has(TM_FX_CORRECTION);
  a.threshold = threshold;
  a.strain = strain;
  a.dt = fix.body().step_dt();
  a.h = rates.h;
  a.slope_norm = rates.slope_norm;
  a.art_inv_w = rates.art_inv_w;
  a.art_n = rates.art_n;
  a.first = first_search;
  const unsigned fx = fix.body().effects();
  const int next = backend->settle_tell(own(), a, fx);
  pair.forward(told, TM_TOLD);
  a.told = told.loop_write();
  backend->settle(own(), a, fx);
  sum_searched += first_search ? own() : 0;
  first_search = false;
  sum_searched += last_searched = next;
  time_now += a.dt;
}

double AdaptLists::output(int k)
{
  LAMMPS *lmp = fix.host();
  if (!keeps()) return k == 0 ? 1.0 : 0.0;
  const double mine = k == 0 ? last_searched : sum_searched;
  double sum;
  MPI_Allreduce(&mine, &sum, 1, MPI_DOUBLE, MPI_SUM, lmp->world);
  return sum / std::max((double) lmp->atom->natoms, 1.0);
}

/* ---------------------------------------------------------------------- places in memory */

// particles are about to get new places: kept entries are known by tag until then
void AdaptLists::to_tags()
{
  if (!keeps() || by_tag || table.capacity == 0 || !backend) return;
  const int *index = table.index.host_read(), *n = kept.host_read();
  const ptrdiff_t *first = table.first.host_read();
  tags.assign(table.slots(), 0);
  const tagint *tag = fix.host()->atom->tag;
  for (int i = 0; i < own(); i++)
    for (int k = 0; k < n[i]; k++) tags[first[i] + k * table.stride] = tag[index[first[i] + k * table.stride]];
  by_tag = true;
}

// entry k of row i
void AdaptLists::drop(int i, int k)
{
  const int last = --kept.host_write()[i];
  const ptrdiff_t first = table.first.host_read()[i], stride = table.stride, next = table.capacity * stride;
  float *w = weight.host_write() + (first - i % stride) * TM_WEIGHTS + i % stride;
  tags[first + k * stride] = tags[first + last * stride];
  for (int c = 0; c < TM_WEIGHTS; c++) w[c * next + k * stride] = w[c * next + last * stride];
}

// of the images of a particle the closest is meant
void AdaptLists::to_indices()
{
  if (!by_tag) return;
  Atom *atom = fix.host()->atom;
  const int n_all = all();
  std::vector<std::pair<int, int>> places(n_all);
  for (int j = 0; j < n_all; j++) places[j] = {(int) atom->tag[j], j};
  std::sort(places.begin(), places.end());
  int *index = table.index.host_write(), *n = kept.host_write();
  tm_real *remembered = memory.host_write();
  const ptrdiff_t *first = table.first.host_read();
  ptrdiff_t *behind = fresh_first.host_write();
  for (int i = 0; i < own(); i++) {
    const double *x = atom->x[i];
    for (int k = 0; k < n[i]; k++) {
      const ptrdiff_t slot = first[i] + k * table.stride;
      const int tag = tags[slot];
      double least = 1e300;
      for (auto p = std::lower_bound(places.begin(), places.end(), std::make_pair(tag, -1));
           p != places.end() && p->first == tag; ++p) {
        const double *y = atom->x[p->second];
        const double r2 = (x[0] - y[0]) * (x[0] - y[0]) + (x[1] - y[1]) * (x[1] - y[1]) + (x[2] - y[2]) * (x[2] - y[2]);
        if (r2 >= least || p->second == i) continue;
        least = r2;
        index[slot] = p->second;
      }
      if (least < 1e300) continue;
      if (std::isinf(approach))
        fix.host()->error->one(FLERR, "Fix adapt/neigh threshold {}: the neighbor {} that particle {} keeps is gone or "
                                      "beyond the ghosts; a larger neighbor skin, or 'approach 0.01'", threshold, tag,
                               atom->tag[i]);
      // deleted, or far away: not a neighbor any more
      drop(i, k--);
      remembered[(size_t) i * TM_K + TM_K_NEAR] = TM_NEAR_HOLD;
    }
    behind[i] = first[i] + n[i] * table.stride;
  }
  by_tag = false;
}

void AdaptLists::grow(int nmax)
{
  if (!keeps() || table.capacity == 0) return;
  make_room(nmax);
  if (by_tag) tags.resize(table.slots());
}

void AdaptLists::copy(int from, int to)
{
  if (!keeps() || table.capacity == 0) return;
  std::vector<double> buf(most_packed());
  pack(from, buf.data());
  unpack(to, buf.data());
}

void AdaptLists::set_new(int i)
{
  if (!keeps() || table.capacity == 0) return;
  kept.host_write()[i] = 0;
  std::fill_n(memory.host_write() + (size_t) i * TM_K, (int) TM_K, 0.0);
}

int AdaptLists::most_packed() const
{
  return keeps() ? 1 + TM_K + (room ? room : table.capacity) * (1 + TM_WEIGHTS) : 0;
}

int AdaptLists::pack(int i, double *buf)
{
  if (!keeps() || table.capacity == 0) return 0;
  const int n = kept.host_read()[i];
  const ptrdiff_t first = table.first.host_read()[i], stride = table.stride, next = table.capacity * stride;
  const float *w = weight.host_read() + (first - i % stride) * TM_WEIGHTS + i % stride;
  const int *index = table.index.host_read();
  double *start = buf;
  *buf++ = n;
  buf = std::copy_n(memory.host_read() + (size_t) i * TM_K, (int) TM_K, buf);
  for (int k = 0; k < n; k++) {
    *buf++ = by_tag ? tags[first + k * stride] : (int) fix.host()->atom->tag[index[first + k * stride]];
    for (int c = 0; c < TM_WEIGHTS; c++) *buf++ = w[c * next + k * stride];
  }
  return (int) (buf - start);
}

int AdaptLists::unpack(int i, const double *buf)
{
  if (!keeps() || table.capacity == 0) return 0;
  const double *start = buf;
  const int n = (int) *buf++;
  const ptrdiff_t first = table.first.host_read()[i], stride = table.stride, next = table.capacity * stride;
  float *w = weight.host_write() + (first - i % stride) * TM_WEIGHTS + i % stride;
  if (tags.size() < (size_t) table.slots()) tags.resize(table.slots());
  by_tag = true;
  kept.host_write()[i] = n;
  std::copy_n(buf, (int) TM_K, memory.host_write() + (size_t) i * TM_K);
  buf += TM_K;
  for (int k = 0; k < n; k++) {
    tags[first + k * stride] = (int) *buf++;
    for (int c = 0; c < TM_WEIGHTS; c++) w[c * next + k * stride] = (float) *buf++;
  }
  return (int) (buf - start);
}

// of all ranks
std::vector<double> AdaptLists::state()
{
  double sum = 0.0;
  MPI_Allreduce(&sum_searched, &sum, 1, MPI_DOUBLE, MPI_SUM, fix.host()->world);
  return {(double) table.capacity, first_search ? 1.0 : 0.0, sum, time_now, time_watched, next_watch};
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
