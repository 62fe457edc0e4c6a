/* SPH-TM: the row of one particle from the cells, in order of tag.

   Particles i and j are neighbors within the larger of their search radiuses, so that both are in each
   other's row. A row has room for `capacity` entries; a longer one is reported, never cut silently. */
#ifndef TM_SEARCH_H
#define TM_SEARCH_H

#include "tm_cells.h"
#include "tm_neighbors.h"

#include <limits.h>

enum { TM_SEARCH_MOST = 2048 }; /* entries a row can have */

typedef struct {
  tm_cells cells;
  tm_real radius;             /* where particles have none of their own */
  const unsigned char *meets; /* per type pair: segments, or NULL: all are mechanical neighbors */
  int segments;               /* those wanted, bits of TM_MEETS_... */
  const int *type, *tag;
  int ntypes;
  int images;       /* there are ghosts: several particles can have the same tag */
  const int *which; /* the particles to search for, or NULL: all */
  int capacity;
  ptrdiff_t stride;
  int *index;
  const ptrdiff_t *first;  /* where the row of each particle begins */
  int *count[TM_SEGMENTS]; /* results: lengths of the segments wanted */
} tm_search_args;

/* Is entry j one of row i? The segments it stands in. */
TM_FN int tm_search_meets(int i, int j, const tm_search_args *a)
{
  if (j == i) return 0;
  if (!a->meets) return a->segments & TM_MEETS_MECHANICAL;
  return a->segments & a->meets[(ptrdiff_t) a->type[i] * (a->ntypes + 1) + a->type[j]];
}

/* Entries k of the order, begin <= k < end, within the search radius of x: appended to found; returns the new n,
   more than most as soon as they are too many. found has room for TM_COLUMN more than most. */
TM_FN int tm_search_run(const tm_search_args *a, int begin, int end, const double *x, tm_real radius, int n, int most,
                        int *found)
{
  const tm_cells *c = &a->cells;
  const tm_real r2i = radius * radius;
#if TM_VECTOR >= 32 && !TM_SINGLE
  for (int k = begin; k < end && n <= most; k += TM_LANES) {
    const int left = end - k;
    const unsigned mask = left < TM_LANES ? (1u << left) - 1u : 255u;
    const tm_lanes dx = x[0] - tm_lanes_load_any(c->column[0] + k), dy = x[1] - tm_lanes_load_any(c->column[1] + k);
    const tm_lanes dz = x[2] - tm_lanes_load_any(c->column[2] + k);
    const tm_lanes r2 = dx * dx + dy * dy + dz * dz;
    unsigned inside = tm_lanes_below(r2, r2i, mask);
    if (c->radius) {
      const tm_lanes rj = tm_lanes_load_any(c->column[3] + k);
      inside |= tm_lanes_below(r2 - rj * rj, 0.0, mask);
    }
    n += tm_compress(c->index + k, inside, found + n);
  }
#else
  for (int k = begin; k < end && n <= most; k++) {
    const tm_real dx = x[0] - c->column[0][k], dy = x[1] - c->column[1][k], dz = x[2] - c->column[2][k];
    const tm_real rj = c->radius ? c->column[3][k] : radius, r2j = rj * rj;
    found[n] = c->index[k];
    n += dx * dx + dy * dy + dz * dz < (r2i > r2j ? r2i : r2j);
  }
#endif
  return n;
}

/* ---- by threads of the host, whole rows */

/* Places of the n entries in order of tag, then of memory, by counting those before each. */
TM_HOST_FN void tm_search_order(const int *found, int n, const int *tag, int *place)
{
  enum { TURN = 16 };
  int TM_ALIGNED key[TM_SEARCH_MOST + TM_COLUMN];
  const int turns = (n + TURN - 1) / TURN * TURN;
  int sum = 0;
  for (int k = 0; k < n; k++) key[k] = tag[found[k]];
  for (int k = n; k < turns; k++) key[k] = INT_MAX;
#if TM_VECTOR
  typedef int tm_ints __attribute__((vector_size(4 * TURN), may_alias));
  typedef int tm_ints_mem __attribute__((vector_size(4 * TURN), aligned(4), may_alias));
  for (int k = 0; k < turns; k += TURN) {
    const tm_ints mine = *(const tm_ints *) (key + k);
    tm_ints before = {0};
    for (int l = 0; l < n; l++) before -= mine > key[l];
    *(tm_ints_mem *) (place + k) = before;
  }
#else
  for (int k = 0; k < n; k++) {
    place[k] = 0;
    for (int l = 0; l < n; l++) place[k] += key[l] < key[k];
  }
#endif
  for (int k = 0; k < n; k++) sum += place[k];
  if (sum == n * (n - 1) / 2) return;
  for (int k = 0; k < n; k++) /* images of one particle */
    for (int l = 0; l < n; l++) place[k] += key[l] == key[k] && found[l] < found[k];
}

/* Row i by one thread; returns the entries it has then, which may be more than its room: nothing is stored beyond. */
TM_HOST_FN int tm_search(int i, const tm_search_args *a)
{
  const double *x = a->cells.x + 3 * (ptrdiff_t) i;
  const tm_real radius = a->cells.radius ? a->cells.radius[i] : a->radius;
  const int room = a->capacity;
  int *row = a->index + a->first[i];
  int begin, end, total = 0;
  int found[TM_SEARCH_MOST + TM_COLUMN], place[TM_SEARCH_MOST + TM_COLUMN], n = 0, taken = 0;
  tm_around around = tm_cells_around(&a->cells, x);
  while (n <= TM_SEARCH_MOST && tm_around_next(&around, &a->cells, &begin, &end))
    n = tm_search_run(a, begin, end, x, radius, n, TM_SEARCH_MOST, found);
  if (n > TM_SEARCH_MOST) return n;
  for (int k = 0; k < n; k++) {
    found[taken] = found[k];
    taken += tm_search_meets(i, found[k], a) != 0;
  }
  n = taken;
  tm_search_order(found, n, a->tag, place);
  for (int s = 0; s < TM_SEGMENTS; s++) {
    if (!(a->segments >> s & 1)) continue;
    int m = 0;
    if (!a->meets || a->segments == 1 << s) { /* all stand in it */
      m = n;
      if (total + m <= room)
        for (int k = 0; k < n; k++) row[place[k] * a->stride] = found[k];
    } else {
      int sorted[TM_SEARCH_MOST];
      for (int k = 0; k < n; k++) sorted[place[k]] = found[k];
      for (int k = 0; k < n; k++) {
        if (!(tm_search_meets(i, sorted[k], a) >> s & 1)) continue;
        if (total + m < room) row[m * a->stride] = sorted[k];
        m++;
      }
    }
    a->count[s][i] = m;
    total += m;
    row += m * a->stride;
  }
  return total;
}
/* ---- the same by many threads for one row: they find the entries of a segment in any order, and their places in it.
   The threads of a GPU do this; a thread of the host takes whole rows. */

/* Does entry k of the order stand in segment s of row i? */
TM_FN int tm_search_takes(int i, int k, int s, const double *x, tm_real radius, const tm_search_args *a)
{
  int found[1 + TM_COLUMN];
  return tm_search_run(a, k, k + 1, x, radius, 0, 1, found) && (tm_search_meets(i, a->cells.index[k], a) >> s & 1);
}

/* Those of n entries that belong to one of the threads, into the segment at `row`; tag: of each; images as above. */
TM_FN void tm_search_place(int thread, int threads, int n, const int *found, const int *tag, int images, int *row,
                           ptrdiff_t stride)
{
  enum { TOGETHER = 4 };
  for (int k = thread; k < n; k += TOGETHER * threads) {
    int mine[TOGETHER], before[TOGETHER];
    for (int q = 0; q < TOGETHER; q++) {
      const int entry = k + q * threads;
      mine[q] = tag[entry < n ? entry : k];
      before[q] = 0;
    }
    for (int l = 0; l < n; l++) /* tags are positive: the sign of the difference */
      for (int q = 0; q < TOGETHER; q++) before[q] += (int) ((unsigned) (tag[l] - mine[q]) >> 31);
    for (int q = 0; q < TOGETHER; q++) {
      const int entry = k + q * threads;
      if (entry >= n) continue;
      for (int l = 0; images && l < n; l++) before[q] += tag[l] == mine[q] && found[l] < found[entry];
      row[before[q] * stride] = found[entry];
    }
  }
}

#endif
