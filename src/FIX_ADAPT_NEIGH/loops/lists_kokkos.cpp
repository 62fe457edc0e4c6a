#ifdef LMP_KOKKOS
#include "lists_kokkos.h"

#include "backend_kokkos.h"
#include "list_loops.h"

#include <algorithm>
#include <utility>

namespace SPHTM_NS {

namespace {

struct Bounds {
  const double *x;
  KOKKOS_FUNCTION tm_bounds operator()(int i) const { return tm_bounds_of(x + 3 * (ptrdiff_t) i); }
};
struct SumBounds {
  KOKKOS_FUNCTION void operator()(tm_bounds *sum, const tm_bounds *b) const { tm_bounds_sum(sum, b); }
};
// begin[k + 1] walks from the start of cell k to its end
struct CountCell {
  tm_cells c;
  int last;
  KOKKOS_FUNCTION void operator()(int i) const
  {
    const int cell = tm_cells_of(&c, c.x + 3 * (ptrdiff_t) i);
    c.cell[i] = cell;
    if (cell + 2 <= last) Kokkos::atomic_inc(c.begin + cell + 2);
  }
};
struct PlaceCells {
  tm_cells c;
  KOKKOS_FUNCTION void operator()(int k, int &sum, bool last) const
  {
    sum += c.begin[k];
    if (last) c.begin[k] = sum;
  }
};
struct PutInCell {
  tm_cells c;
  KOKKOS_FUNCTION void operator()(int i) const
  {
    tm_cells_put(&c, i, Kokkos::atomic_fetch_add(c.begin + c.cell[i] + 1, 1));
  }
};
struct CellReach {
  tm_cells c;
  KOKKOS_FUNCTION void operator()(int cell) const { c.look[1][cell] = tm_cells_reach(&c, cell); }
};
struct CellLook {
  tm_cells c;
  int axis;
  const tm_real *from;
  tm_real *to;
  KOKKOS_FUNCTION void operator()(int cell) const { to[cell] = tm_cells_look(&c, cell, axis, from); }
};
// the threads of a warp search for one particle; what they find stands in their scratch memory
struct Search {
  using Team = Kokkos::TeamPolicy<LMPDeviceType>;
  using Ints = Kokkos::View<int *, LMPDeviceType::scratch_memory_space, Kokkos::MemoryTraits<Kokkos::Unmanaged>>;
  tm_search_args a;
  int n, rows;    // particles; those of a team

  KOKKOS_FUNCTION void operator()(const Team::member_type &team, int &longest) const
  {
    const int m = team.league_rank() * rows + team.team_rank();
    if (m >= n) return;
    const int i = a.which ? a.which[m] : m;
    const Ints found_view(team.thread_scratch(0), a.capacity), tag_view(team.thread_scratch(0), a.capacity);
    const Ints number(team.thread_scratch(0), 1);
    int *found = found_view.data(), *tag = tag_view.data(), *found_of_all = number.data();
    const double *x = a.cells.x + 3 * (ptrdiff_t) i;
    const tm_real reach = a.cells.reach ? a.cells.reach[i] : a.reach;
    int *row = a.index + a.first[i], total = 0;
    for (int s = 0; s < TM_SEGMENTS; s++) {
      if (!(a.segments >> s & 1)) continue;
      Kokkos::single(Kokkos::PerThread(team), [&] { *found_of_all = 0; });
      const int room = a.capacity - total;
      tm_around around = tm_cells_around(&a.cells, x);
      int begin, end;
      while (tm_around_next(&around, &a.cells, &begin, &end)) {
        Kokkos::parallel_for(Kokkos::ThreadVectorRange(team, begin, end), [&](int k) {
          if (!tm_search_takes(i, k, s, x, reach, &a)) return;
          const int at = Kokkos::atomic_fetch_add(found_of_all, 1);
          if (at >= room) return;
          found[at] = a.cells.index[k];
          tag[at] = a.tag[found[at]];
        });
      }
      const int m = *found_of_all;
      if (m <= room)
        Kokkos::parallel_for(Kokkos::ThreadVectorRange(team, WARP), [&](int thread) {
          tm_search_place(thread, WARP, m, found, tag, a.images, row, a.stride);
        });
      Kokkos::single(Kokkos::PerThread(team), [&] { a.count[s][i] = m; });
      total += m;
      row += m * a.stride;
      if (total > a.capacity) break;
    }
    Kokkos::single(Kokkos::PerThread(team), [&] { longest = total > longest ? total : longest; });
  }
  int run()
  {
    int longest = 0;
    if (n == 0) return 0;
    const size_t scratch = 2 * Ints::shmem_size(a.capacity) + Ints::shmem_size(1);
    rows = std::max(1, std::min(MAX_ROWS, (int) (MEMORY / scratch)));
    Kokkos::parallel_reduce("sph/tm search",
                            Team((n + rows - 1) / rows, rows, WARP).set_scratch_size(0, Kokkos::PerThread(scratch)),
                            *this, Kokkos::Max<int>(longest));
    return longest;
  }
  static constexpr int WARP = 32;
  static constexpr size_t MEMORY = 32000;    // bytes of a team, which every GPU has
  static_assert(2 * TM_SEARCH_MOST * sizeof(int) + 64 <= MEMORY, "the longest row fits");
#if defined(LMP_KOKKOS_GPU)
  static constexpr int MAX_ROWS = 4;
#else
  static constexpr int MAX_ROWS = 1;
#endif
};
struct Differs {
  const int *a, *b;
  KOKKOS_FUNCTION int operator()(int i) const { return a[i] != b[i]; }
};
struct Mark {
  tm_cells c;
  const unsigned char *marks;
  KOKKOS_FUNCTION void operator()(int k, int &sum, bool last) const
  {
    if (last) c.marked[k] = sum;
    if (k < c.n) sum += marks[c.index[k]];
  }
};
struct SumInt {
  KOKKOS_FUNCTION void operator()(int *sum, const int *k) const { *sum += *k; }
};
struct Moved {
  tm_moved_args a;
  KOKKOS_FUNCTION int operator()(int i) const { return tm_moved(i, &a); }
};
struct NearMoved {
  tm_near_moved_args a;
  int *which;
  KOKKOS_FUNCTION void operator()(int i, int &m, bool last) const
  {
    if (!tm_near_moved(i, &a)) return;
    if (last) which[m] = i;
    m++;
  }
};
struct OfKind {
  tm_kind_args a;
  int *which;
  KOKKOS_FUNCTION void operator()(int i, int &m, bool last) const
  {
    if (!tm_is_of_kind(i, &a)) return;
    if (last) which[m] = i;
    m++;
  }
};
struct BorderChange {
  tm_interface_args a;
  KOKKOS_FUNCTION int operator()(int i) const { return tm_interface_switch(i, &a); }
};
struct BorderTouch {
  tm_interface_args a;
  KOKKOS_FUNCTION void operator()(int i) const { tm_interface_mark(i, &a); }
};
struct Border {
  tm_interface_args a;
  KOKKOS_FUNCTION void operator()(int i) const { tm_interface_row(i, &a); }
};
struct KeptMoment {
  tm_tl_correction_args a;
  unsigned fx;
  KOKKOS_FUNCTION void operator()(int i) const { tm_tl_correction(i, &a, fx); }
};
struct KeptShow {
  tm_tl_args a;
  tm_real *shown;
  KOKKOS_FUNCTION void operator()(int i) const { tm_tl_export(i, &a, shown); }
};
template <unsigned EFFECTS> struct KeptRates {
  tm_tl_args a;
  KOKKOS_FUNCTION void operator()(int i) const
  {
    if (a.rows.tl[i]) tm_tl_rates(i, &a, EFFECTS);
  }
};
typedef void (*device_kept_loop_t)(int, const tm_tl_args &);
template <unsigned EFFECTS> void run_kept(int n, const tm_tl_args &a)
{
  kokkos_each("sph/tm kept rates", n, KeptRates<EFFECTS>{a});
}
template <int... INDEX>
device_kept_loop_t find_kept(int index, std::integer_sequence<int, INDEX...>)
{
  static const device_kept_loop_t table[] = {run_kept<kept_loop_effects(INDEX)>...};
  return table[index];
}
struct SettleLeaps {
  tm_freeze_args a;
  KOKKOS_FUNCTION int operator()(int i) const { return tm_freeze_is_urgent(i, &a); }
};
struct SettleTell {
  tm_freeze_args a;
  unsigned fx;
  KOKKOS_FUNCTION void operator()(int i) const { tm_freeze_decide(i, &a, fx); }
};
struct Settle {
  tm_freeze_args a;
  unsigned fx;
  KOKKOS_FUNCTION void operator()(int k) const { tm_freeze(a.which ? a.which[k] : k, &a, fx); }
};
struct Watch {
  tm_proximity_args a;
  KOKKOS_FUNCTION int operator()(int i) const { return tm_proximity_check(i, &a); }
};
struct Int {
  const int *v;
  KOKKOS_FUNCTION int operator()(int i) const { return v[i]; }
};
struct Larger {
  KOKKOS_FUNCTION void operator()(int *most, const int *v) const { *most = *v > *most ? *v : *most; }
};
struct HoldTags {
  tm_tag_map_args a;
  KOKKOS_FUNCTION void operator()(int j) const { a.next[j] = Kokkos::atomic_exchange(a.first + a.tag[j], j + 1); }
};
struct Searched {
  const tm_real *history;
  tm_real *next_ul;
  KOKKOS_FUNCTION void operator()(int i) const { next_ul[i] = tm_is_ul(history + (ptrdiff_t) i * TM_TL_HISTORY); }
};
struct Places {
  tm_tag_map_args a;
  KOKKOS_FUNCTION int operator()(int i) const { return tm_tag_map_resolve(i, &a); }
};
struct Reorder {
  tm_tl_store from, to;
  const int *order;
  KOKKOS_FUNCTION void operator()(int i) const { tm_tl_copy(&from, order[i], &to, i); }
};
struct KeptSend {
  tm_tl_migration_args a;
  KOKKOS_FUNCTION void operator()(int k) const { tm_tl_send(k, &a); }
};
struct KeptReceive {
  tm_tl_migration_args a;
  KOKKOS_FUNCTION void operator()(int k) const { tm_tl_receive(k, &a); }
};

}    // namespace

/* ---------------------------------------------------------------------- cells and search */

tm_bounds KokkosLists::bounds(int n, const double *x)
{
  return kokkos_sum("sph/tm bounds", n, tm_bounds_nothing(), Bounds{x}, SumBounds());
}
void KokkosLists::bin(const tm_cells &c)
{
  const int cells = tm_cells_number(&c);
  zero(c.begin, (cells + 1) * sizeof(int));
  kokkos_each("sph/tm count in cells", c.n, CountCell{c, cells});
  Kokkos::parallel_scan("sph/tm place cells", Kokkos::RangePolicy<LMPDeviceType>(0, cells + 1), PlaceCells{c});
  kokkos_each("sph/tm put in cells", c.n, PutInCell{c});
  if (!c.reach) return;
  kokkos_each("sph/tm reach of cells", cells, CellReach{c});
  for (int axis = 0; axis < 3; axis++)
    kokkos_each("sph/tm look from cells", cells, CellLook{c, axis, c.look[1 - axis % 2], c.look[axis % 2]});
}
int KokkosLists::search(int n, const tm_search_args &a)
{
  return Search{a, n, 1}.run();
}

/* ---------------------------------------------------------------------- which rows */

bool KokkosLists::equal(int n, const int *a, const int *b)
{
  return kokkos_sum("sph/tm same", n, 0, Differs{a, b}, SumInt()) == 0;
}
int KokkosLists::mark(const tm_cells &c, const unsigned char *marks)
{
  int sum = 0;
  Kokkos::parallel_scan("sph/tm mark", Kokkos::RangePolicy<LMPDeviceType>(0, c.n + 1), Mark{c, marks}, sum);
  return sum;
}
int KokkosLists::moved(int n, const tm_moved_args &a)
{
  return kokkos_sum("sph/tm moved", n, 0, Moved{a}, SumInt());
}
int KokkosLists::near_moved(int n, const tm_near_moved_args &a, int *which)
{
  int m = 0;
  Kokkos::parallel_scan("sph/tm near moved", Kokkos::RangePolicy<LMPDeviceType>(0, n), NearMoved{a, which}, m);
  return m;
}
int KokkosLists::of_kind(int n, const tm_kind_args &a, int *which)
{
  int m = 0;
  Kokkos::parallel_scan("sph/tm of kind", Kokkos::RangePolicy<LMPDeviceType>(0, n), OfKind{a, which}, m);
  return m;
}
int KokkosLists::border_change(int n, const tm_interface_args &a)
{
  return kokkos_sum("sph/tm border change", n, 0, BorderChange{a}, SumInt());
}
void KokkosLists::border_touch(int n, const tm_interface_args &a)
{
  kokkos_each("sph/tm border touch", n, BorderTouch{a});
}
void KokkosLists::border(int n, const tm_interface_args &a)
{
  kokkos_each("sph/tm border", n, Border{a});
}

/* ---------------------------------------------------------------------- rows that are kept */

void KokkosLists::kept_moments(int n, const tm_tl_correction_args &a, unsigned fx)
{
  kokkos_each("sph/tm kept moments", n, KeptMoment{a, fx});
}
void KokkosLists::kept_show(int n, const tm_tl_args &a, tm_real *shown)
{
  kokkos_each("sph/tm kept show", n, KeptShow{a, shown});
}
void KokkosLists::kept_rates(int n, const tm_tl_args &a, unsigned fx)
{
  find_kept(kept_loop_index(fx), std::make_integer_sequence<int, KEPT_LOOPS>())(n, a);
}
int KokkosLists::settle_leaps(int n, const tm_freeze_args &a)
{
  return kokkos_sum("sph/tm settle leaps", n, 0, SettleLeaps{a}, SumInt());
}
void KokkosLists::settle_tell(int n, const tm_freeze_args &a, unsigned fx)
{
  kokkos_each("sph/tm settle tell", n, SettleTell{a, fx});
}
void KokkosLists::settle(int n, const tm_freeze_args &a, unsigned fx)
{
  kokkos_each("sph/tm settle", n, Settle{a, fx});
}
int KokkosLists::watch(int n, const tm_proximity_args &a)
{
  return kokkos_sum("sph/tm watch", n, 0, Watch{a}, SumInt());
}

/* ---------------------------------------------------------------------- kept rows of particles with new places */

int KokkosLists::largest(int n, const int *v)
{
  return kokkos_sum("sph/tm largest", n, 0, Int{v}, Larger());
}
void KokkosLists::hold_tags(int n, const tm_tag_map_args &a)
{
  kokkos_each("sph/tm hold tags", n, HoldTags{a});
}
void KokkosLists::searched(int n, const tm_real *history, tm_real *next_ul)
{
  kokkos_each("sph/tm searched", n, Searched{history, next_ul});
}
int KokkosLists::places(int n, const tm_tag_map_args &a)
{
  return kokkos_sum("sph/tm places", n, 0, Places{a}, SumInt());
}
void KokkosLists::reorder(int n, const tm_tl_store &from, const int *order, const tm_tl_store &to)
{
  kokkos_each("sph/tm reorder", n, Reorder{from, to, order});
}
void KokkosLists::kept_send(int n, const tm_tl_migration_args &a)
{
  kokkos_each("sph/tm send rows", n, KeptSend{a});
}
void KokkosLists::kept_receive(int n, const tm_tl_migration_args &a)
{
  kokkos_each("sph/tm receive rows", n, KeptReceive{a});
}

}    // namespace SPHTM_NS
#endif
