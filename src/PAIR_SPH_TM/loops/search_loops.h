/* SPH-TM: the loops that search neighbors in cells, and the smoothing lengths that follow them. See loop_table.h. */
#ifndef SPHTM_SEARCH_LOOPS_H
#define SPHTM_SEARCH_LOOPS_H

#include "loop_table.h"
#include "tm_search.h"
#include "tm_smoothing.h"

namespace SPHTM_NS {

struct PointsLoop {
  const double *x;
};
// rows of a list of particles, one behind the other, in slices of `stride` that are interleaved
struct PlaceRowsLoop {
  const int *which;
  ptrdiff_t capacity, stride;
  ptrdiff_t *first;
};

// a family of sums: the largest number, at least 0
TM_FN int tm_largest_nothing(void) { return 0; }
TM_FN void tm_largest_sum(int *most, const int *n) { *most = *n > *most ? *n : *most; }

// the box of points; particles in order of cells; rows, of which the longest is returned
#define SEARCH_LOOPS(LOOP)                                                                                         \
  LOOP(SUM, bounds, PointsLoop, tm_bounds, tm_bounds, tm_bounds_of(a.x + 3 * (ptrdiff_t) i))                       \
  LOOP(OWN, sort_into_cells, void, const tm_cells &)                                                               \
  /* how many before each entry of the order are marked */                                                         \
  LOOP(OWN, count_marked, void, const tm_cells &, const unsigned char *marks)                                      \
  LOOP(EACH, place_rows, PlaceRowsLoop, a.first[a.which[i]] = i / a.stride * a.stride * a.capacity + i % a.stride) \
  LOOP(RANGE_SUM, search, tm_search_args, int, tm_largest)                                                         \
  LOOP(SUM, smoothing, tm_smoothing_args, tm_size_range, tm_size, tm_smoothing(i, &a, effects))

struct SearchLoops {
  SPHTM_LOOP_POINTERS(SEARCH_LOOPS)

  static const SearchLoops &of(const Backend &);
  static const SearchLoops *kokkos;    // where this build has them
};

struct SearchRanges {
  SPHTM_RANGE_POINTERS(SEARCH_LOOPS)
};

}    // namespace SPHTM_NS

#endif
