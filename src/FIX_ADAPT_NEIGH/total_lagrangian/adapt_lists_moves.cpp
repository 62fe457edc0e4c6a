/* SPH-TM: adaptive neighbor lists, the way of rows that are kept through new places in memory, migration and
   restart. */
#include "adapt_lists.h"

#include "all_ranks.h"
#include "fix_adapt_neigh.h"
#include "fix_sph_tm.h"
#include "pair_sph_tm.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "lammps.h"
#include "output.h"
#include "thermo.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

/* ---------------------------------------------------------------------- places in memory */

// room for so many more; where they begin
int AdaptLists::room_for_names(int n)
{
  const int first = by_tag ? n_names : 0;
  if (first + n > (int) names.size()) names.resize(2 * (first + n));
  n_names = first + n;
  by_tag = true;
  return first;
}

// particles are about to get new places
void AdaptLists::to_tags()
{
  if (margin == 0.0 || by_tag || table.capacity == 0) return;
  room_for_names(all());
  backend->copy(names.loop_write(), fix.pair().loop_tags(), all() * sizeof(int));
}

// the places are those they were before, of particles without images
bool AdaptLists::same_places()
{
  return by_tag && all() == own() && n_names == own() &&
      backend->equal(own(), names.loop_read(), fix.pair().loop_tags());
}

// how many entries of this rank are of particles that are nowhere near
int AdaptLists::to_indices(bool same)
{
  const bool was_by_tag = by_tag;
  by_tag = false;
  if (!keeps() || !was_by_tag || same) return 0;
  tm_tag_map_args a = {};
  a.store = kept_store();
  a.entry_tag = names.loop_read();
  a.tag = fix.pair().loop_tags();
  a.x = fix.body().state().x;
  a.largest = backend->largest(all(), a.tag);
  tag_head.make_room(true, (size_t) a.largest + 1);
  other_holder.make_room(true, (size_t) all() + 1);
  a.first = tag_head.loop_write();
  a.next = other_holder.loop_write();
  backend->zero(a.first, ((size_t) a.largest + 1) * sizeof(int));
  backend->hold_tags(all(), a);
  a.back_to_ul = std::isfinite(approach);    // deleted, or far away: not a neighbor any more
  gone.make_room(!a.back_to_ul, n_names + 1);
  a.gone = gone.loop_write();
  if (a.gone) backend->fill(a.gone, 0, n_names);
  const tm_rates_args &rates = fix.pair().rate_args();
  a.rec = rates.rec;
  a.slope_norm = rates.slope_norm;
  a.corrected = fix.body().has(TM_FX_CORRECTION) && !corrects();
  a.dim3 = fix.host()->domain->dimension == 3;
  const int lost = backend->places(own(), a);
  return a.back_to_ul ? 0 : lost;
}

// All ranks together: pairs of which this rank found so many without their other end are dropped, where that particle
// is gone for good and may be; one that is somewhere has only left the reach of the ghosts.
void AdaptLists::drop_gone(int pairs)
{
  LAMMPS *lmp = fix.host();
  std::vector<int> mine;
  if (pairs) {
    const unsigned char *is_gone = gone.host_read();
    const int *name = names.host_read();
    for (int k = 0; k < n_names; k++)
      if (is_gone[k]) mine.push_back(name[k]);
  }
  std::vector<int> tags = of_all_ranks(mine, lmp->world);
  std::sort(tags.begin(), tags.end());
  tags.erase(std::unique(tags.begin(), tags.end()), tags.end());

  LoopArray<int> owned(*backend);
  owned.resize(own() + 1);
  backend->copy(owned.loop_write(), fix.pair().loop_tags(), own() * sizeof(int));
  std::vector<int> here(tags.size(), 0), there(tags.size());
  const int *tag = owned.host_read();
  for (int i = 0; i < own(); i++) {
    const auto t = std::lower_bound(tags.begin(), tags.end(), tag[i]);
    if (t != tags.end() && *t == tag[i]) here[t - tags.begin()] = 1;
  }
  MPI_Allreduce(here.data(), there.data(), (int) tags.size(), MPI_INT, MPI_MAX, lmp->world);
  for (size_t k = 0; k < tags.size(); k++)
    if (there[k])
      lmp->error->all(FLERR, "Fix adapt/neigh threshold {}: particle {} is beyond the ghosts of others that keep it as "
                             "a neighbor; a larger neighbor skin, or 'approach 0.01'", threshold, tags[k]);
  const bigint count = own();
  bigint total;
  MPI_Allreduce(&count, &total, 1, MPI_LMP_BIGINT, MPI_SUM, lmp->world);
  if (lmp->output->thermo->lostflag == Thermo::ERROR && total != lmp->atom->natoms)
    lmp->error->all(FLERR, "Fix adapt/neigh threshold {}: particle {} is gone, that others keep as a neighbor; write "
                           "'thermo_modify lost ignore' (or warn) to go on without it", threshold, tags[0]);
  dropped += pairs;
}

void AdaptLists::post_run()
{
  to_tags();
  if (!keeps()) return;
  double sum;
  MPI_Allreduce(&dropped, &sum, 1, MPI_DOUBLE, MPI_SUM, fix.host()->world);
  dropped = 0.0;
  if (sum > 0.0 && fix.host()->comm->me == 0)
    fix.host()->error->warning(FLERR, "Fix adapt/neigh threshold {}: {} pairs of kept rows were dropped in this run, "
                                      "their other particles are gone", threshold, (bigint) sum);
}

void AdaptLists::grow(int nmax)
{
  if (keeps() && quiet.capacity > 0) make_room(nmax);
}

void AdaptLists::copy(int from, int to)
{
  if (!keeps() || quiet.capacity == 0) return;
  const tm_tl_store s = kept_store(true);
  tm_tl_copy(&s, from, &s, to);
}

void AdaptLists::set_new(int i)
{
  if (!keeps() || quiet.capacity == 0) return;
  kept.host_write()[i] = 0;
  std::fill_n(history.host_write() + (size_t) i * TM_TL_HISTORY, (int) TM_TL_HISTORY, 0.0);
}

int AdaptLists::most_packed() const { return keeps() ? tm_tl_packed(room ? room : quiet.capacity) : 0; }

int AdaptLists::pack(int i, double *buf)
{
  if (!keeps() || quiet.capacity == 0) return 0;
  const tm_tl_store s = kept_store(true);
  return tm_tl_pack(i, &s, by_tag ? names.host_read() : fix.host()->atom->tag, buf);
}

int AdaptLists::unpack(int i, const double *buf)
{
  if (!keeps() || quiet.capacity == 0) return 0;
  const tm_tl_store s = kept_store(true);
  const int first = room_for_names((int) buf[0]);
  return tm_tl_unpack(i, &s, buf, first, names.host_write());
}

// the row of tm_tl_pack()
int AdaptLists::look(const double *row, int n, std::string &why) const
{
  if (!keeps() || quiet.capacity == 0) return 0;
  const int most = quiet.capacity;
  if (n < tm_tl_packed(0) || !is_whole(row[0], 0, most) || n < tm_tl_packed((int) row[0])) {
    why = fmt::format("a kept row of {} entries in {} values, 0 to {} entries expected", n ? row[0] : 0.0, n, most);
    return -1;
  }
  const double *value = row + 1, *end = row + tm_tl_packed((int) row[0]);
  for (int c = 0; c < TM_TL_HISTORY; c++, value++)
    if (!std::isfinite(*value)) why = fmt::format("{} in the memory of its kept row", *value);
  for (; why.empty() && value < end; value += 1 + TM_WEIGHTS) {
    if (!is_whole(*value, 1, MAXSMALLINT)) why = fmt::format("a neighbor {} in its kept row", *value);
    for (int c = 1; c <= TM_WEIGHTS; c++)
      if (!is_whole(value[c], -32768, 32767)) why = fmt::format("a weight {} in its kept row", value[c]);
  }
  return why.empty() ? tm_tl_packed((int) row[0]) : -1;
}

void AdaptLists::reorder(int n, const int *order)
{
  if (!keeps() || quiet.capacity == 0) return;
  const tm_tl_store to = kept_store();
  LoopArray<int> index(*backend), lengths(*backend);
  LoopArray<short> weights(*backend);
  LoopArray<tm_real> memories(*backend);
  const auto copied = [this](auto &copy, auto &of) {
    copy.resize(of.size());
    backend->copy(copy.loop_write(), of.loop_read(), of.bytes());
    return copy.loop_write();
  };
  tm_tl_store from = to;
  from.rows.index = copied(index, quiet.index);
  from.rows.tl = copied(lengths, kept);
  from.rows.weight = copied(weights, weight);
  from.history = copied(memories, history);
  backend->reorder(n, from, order, to);
  backend->wait();
}

void AdaptLists::send(int n, const int *sent, const int *filled_by, double *buf)
{
  if (!keeps() || quiet.capacity == 0) return;
  backend->kept_send(n, {kept_store(), names.loop_write(), sent, filled_by, buf, most_packed(), 0});
}

void AdaptLists::receive(int n, const int *place_of, double *buf)
{
  if (!keeps() || quiet.capacity == 0) return;
  const int first = room_for_names(n * quiet.capacity);
  backend->kept_receive(n, {kept_store(), names.loop_write(), place_of, nullptr, buf, most_packed(), first});
}

// rows that know their neighbors by what is not so any more: all are searched as at the start
void AdaptLists::changed(bool moved, bool renamed)
{
  if (!keeps() || quiet.capacity == 0) return;
  backend->zero(kept.loop_write(), kept.bytes());
  backend->zero(history.loop_write(), history.bytes());
  for (auto *a : {&was_ul, &is_ul}) a->clear();    // all ranks tell who is searched
  first_search = true;
  time_now = time_watched = next_watch = 0.0;
  LAMMPS *lmp = fix.host();
  if (lmp->comm->me) return;
  const std::string what = !renamed ? "places" : moved ? "places and IDs" : "IDs";
  lmp->error->warning(FLERR, "Fix adapt/neigh threshold {}: particles have got other {} since the last run: all rows "
                             "are searched again, as at the start{}", threshold, what,
                      renamed ? " ('delete_atoms ... compress no' leaves the IDs as they are)" : "");
}

// of all ranks
std::vector<double> AdaptLists::state()
{
  double sum = 0.0;
  MPI_Allreduce(&sum_searched, &sum, 1, MPI_DOUBLE, MPI_SUM, fix.host()->world);
  return {(double) room, first_search ? 1.0 : 0.0, sum, time_now, time_watched, next_watch, (double) kept_kernel,
          kept_h};
}

// rows of a file have the room of that run
bool AdaptLists::restore(const double *value, size_t n)
{
  LAMMPS *lmp = fix.host();
  if (n != 8 || !is_whole(value[0] / 8.0, 0, TM_SEARCH_MOST / 8) || !is_whole(value[1], 0, 1) ||
      !is_whole(value[6], -1, TM_KERNEL_COUNT - 1))
    return false;
  first_search = value[1] > 0.5;
  sum_searched = lmp->comm->me == 0 ? value[2] : 0.0;
  time_now = value[3];
  time_watched = value[4];
  next_watch = value[5];
  kept_kernel = (int) value[6];
  kept_h = value[7];
  if (!keeps()) return true;
  room = (int) value[0];
  if (room > 0) make_room(lmp->atom->nmax);
  fix.update_packed_size();
  return true;
}

void *AdaptLists::extract(const char *what)
{
  if (strcmp(what, RowSource::NAME) == 0) return static_cast<RowSource *>(this);
  if (strcmp(what, "memory of lists") == 0) return keeps() ? (void *) history.loop_read() : nullptr;
  return nullptr;
}

}    // namespace SPHTM_NS
