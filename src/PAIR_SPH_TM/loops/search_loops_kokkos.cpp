#ifdef LMP_KOKKOS
#include "loop_table_kokkos.h"
#include "search_loops.h"

#include <algorithm>

namespace SPHTM_NS {

namespace {

// begin[k + 1] goes from the start of cell k to its end
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
struct CellRadius {
  tm_cells c;
  KOKKOS_FUNCTION void operator()(int cell) const { c.look[1][cell] = tm_cells_radius(&c, cell); }
};
struct CellLook {
  tm_cells c;
  int axis;
  const tm_real *from;
  tm_real *to;
  KOKKOS_FUNCTION void operator()(int cell) const { to[cell] = tm_cells_look(&c, cell, axis, from); }
};

void sort_into_cells(Backend &backend, const tm_cells &c)
{
  const int cells = tm_cells_number(&c);
  backend.zero(c.begin, (cells + 1) * sizeof(int));
  kokkos_each("sph/tm count in cells", c.n, CountCell{c, cells});
  Kokkos::parallel_scan("sph/tm place cells", Kokkos::RangePolicy<LMPDeviceType>(0, cells + 1), PlaceCells{c});
  kokkos_each("sph/tm put in cells", c.n, PutInCell{c});
  if (!c.radius) return;
  kokkos_each("sph/tm radius of cells", cells, CellRadius{c});
  for (int axis = 0; axis < 3; axis++)
    kokkos_each("sph/tm look from cells", cells, CellLook{c, axis, c.look[1 - axis % 2], c.look[axis % 2]});
}

struct CountMarked {
  tm_cells c;
  const unsigned char *marks;
  KOKKOS_FUNCTION void operator()(int k, int &sum, bool last) const
  {
    if (last) c.marked[k] = sum;
    if (k < c.n) sum += marks[c.index[k]];
  }
};
void count_marked(Backend &, const tm_cells &c, const unsigned char *marks)
{
  Kokkos::parallel_scan("sph/tm count marked", Kokkos::RangePolicy<LMPDeviceType>(0, c.n + 1), CountMarked{c, marks});
}

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
    const tm_real radius = a.cells.radius ? a.cells.radius[i] : a.radius;
    int *row = a.index + a.first[i], total = 0;
    for (int s = 0; s < TM_SEGMENTS; s++) {
      if (!(a.segments >> s & 1)) continue;
      Kokkos::single(Kokkos::PerThread(team), [&] { *found_of_all = 0; });
      const int room = a.capacity - total;
      tm_around around = tm_cells_around(&a.cells, x);
      int begin, end;
      while (tm_around_next(&around, &a.cells, &begin, &end)) {
        Kokkos::parallel_for(Kokkos::ThreadVectorRange(team, begin, end), [&](int k) {
          if (!tm_search_takes(i, k, s, x, radius, &a)) return;
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
int search(Backend &, int n, const tm_search_args &a, unsigned) { return Search{a, n, 1}.run(); }

SEARCH_LOOPS(SPHTM_KOKKOS_LOOP)

const SearchLoops kernels = {SEARCH_LOOPS(SPHTM_LOOP_NAME)};
[[maybe_unused]] const bool known = (SearchLoops::kokkos = &kernels, true);

}    // namespace

}    // namespace SPHTM_NS
#endif
