/* Rows from the cells against all pairs: two and three dimensions, one reach and one each, types, rows that are full;
   which rows one that has moved is near to. */
#include "tm_border.h"
#include "ut.h"

#include <string.h>

enum { N = 600, OWN = 500, TYPES = 3, ROOM = 400 };

static double x[N][3];
static tm_real reach[N];
static int type[N], tag[N], cell[N], order[N + TM_COLUMN], begin[100000], marked[N + 1];
static tm_real column[4][N + TM_COLUMN];
static int row[N * ROOM], count[TM_SEGMENTS][N];
static ptrdiff_t first[N];
static unsigned char meets[(TYPES + 1) * (TYPES + 1)], moved[N], marks[N], dirty[N];
static double was_at[N][3];

static void sort(tm_cells *c, int dim3, tm_real width)
{
  tm_bounds b = tm_bounds_nothing();
  for (int i = 0; i < N; i++) {
    const tm_bounds one = tm_bounds_of(x[i]);
    tm_bounds_sum(&b, &one);
  }
  c->n = N;
  c->x = x[0];
  tm_cells_make(c, b, width, dim3, 99000);
  c->cell = cell;
  c->begin = begin;
  c->index = order;
  for (int d = 0; d < 4; d++) c->column[d] = column[d];
  const int cells = tm_cells_number(c);
  int k = 0;
  for (int q = 0; q < cells; q++) {
    begin[q] = k;
    for (int i = 0; i < N; i++)
      if (tm_cells_of(c, x[i]) == q) tm_cells_put(c, i, k++);
  }
  begin[cells] = k;
  UT_TRUE(k == N);
}

/* what should be entry k of segment s of row i; -1 behind the last */
static int expected(int i, int s, int k, const tm_search_args *a)
{
  int last_tag = INT_MIN, last = -1;
  for (int n = 0;; n++) {
    int next = -1;
    for (int j = 0; j < N; j++) {
      const tm_real r = a->cells.reach ? tm_max(reach[i], reach[j]) : a->reach;
      const tm_real dx = x[i][0] - x[j][0], dy = x[i][1] - x[j][1], dz = x[i][2] - x[j][2];
      const int segments = a->meets ? meets[type[i] * (TYPES + 1) + type[j]] : 1;
      if (j == i || !(segments >> s & 1) || dx * dx + dy * dy + dz * dz >= r * r) continue;
      if (tag[j] < last_tag || (tag[j] == last_tag && j <= last)) continue;
      if (next < 0 || tag[j] < tag[next]) next = j;
    }
    if (n == k || next < 0) return next;
    last = next;
    last_tag = tag[next];
  }
}

/* as the threads of a GPU: candidates in any order, then the place of each */
static int search_by_many(int i, const tm_search_args *a)
{
  enum { THREADS = 32 };
  int found[N], tags[N], total = 0, begin, end;
  const tm_real r = a->cells.reach ? reach[i] : a->reach;
  for (int s = 0; s < TM_SEGMENTS; s++) {
    if (!(a->segments >> s & 1)) continue;
    int n = 0;
    for (int q = 8; q >= 0; q--) {
      tm_search_cells(&a->cells, x[i], q, &begin, &end);
      for (int k = end - 1; k >= begin; k--)
        if (tm_search_takes(i, k, s, x[i], r, a)) found[n++] = a->cells.index[k];
    }
    for (int k = 0; k < n; k++) tags[k] = tag[found[k]];
    for (int thread = 0; thread < THREADS; thread++)
      tm_search_place(thread, THREADS, n, found, tags, a->images, a->index + a->first[i] + total * a->stride,
                      a->stride);
    a->count[s][i] = n;
    total += n;
  }
  return total;
}

static void check(const tm_search_args *a, int by_many)
{
  for (int i = 0; i < OWN; i++) {
    const int n = by_many ? search_by_many(i, a) : tm_search(i, a);
    int total = 0;
    for (int s = 0; s < TM_SEGMENTS; s++) {
      if (!(a->segments >> s & 1)) continue;
      for (int k = 0; k <= count[s][i]; k++) {
        const int j = expected(i, s, k, a);
        UT_TRUE(k < count[s][i] ? j == row[first[i] + (total + k) * a->stride] : j == -1);
      }
      total += count[s][i];
    }
    UT_TRUE(n == total);
  }
}

static void run(int dim3, int own_reach, int types, ptrdiff_t stride)
{
  const tm_real side = dim3 ? 8.0 : 24.0;
  for (int i = 0; i < N; i++) {
    for (int d = 0; d < 3; d++) x[i][d] = d == 2 && !dim3 ? 0.0 : ut_random(-0.3 * side, 0.7 * side);
    reach[i] = ut_random(0.5, 2.4);
    type[i] = 1 + (int) ut_random(0.0, TYPES);
    tag[i] = i < 550 ? (i * 7919) % 1009 : tag[i - 550];    /* ghosts: images of others */
    moved[i] = x[i][0] < -0.25 * side;
    was_at[i][0] = x[i][0] + 0.3 * moved[i];
    was_at[i][1] = x[i][1];
    was_at[i][2] = x[i][2];
    first[i] = i / stride * stride * ROOM + i % stride;
  }
  for (int t = 1; t <= TYPES; t++)
    for (int u = t; u <= TYPES; u++)
      meets[t * (TYPES + 1) + u] = meets[u * (TYPES + 1) + t] = (unsigned char) (t == u ? 1 : 2 * t % 8);
  tm_search_args a;
  memset(&a, 0, sizeof a);
  a.cells.reach = own_reach ? reach : NULL;
  sort(&a.cells, dim3, 2.4);
  for (int k = 0; k < N; k++) marked[k + 1] = marked[k] + moved[order[k]];
  a.cells.marked = marked;
  a.reach = 2.4;
  a.meets = types ? meets : NULL;
  a.segments = types ? 7 : 1;
  a.type = type;
  a.tag = tag;
  a.ntypes = TYPES;
  a.capacity = ROOM;
  a.stride = stride;
  a.index = row;
  a.first = first;
  for (int s = 0; s < TM_SEGMENTS; s++) a.count[s] = count[s];
  a.images = 1;
  check(&a, 0);
  memset(row, 0, sizeof row);
  check(&a, 1);

  tm_moved_args m = {x[0], was_at[0], 0.04, marks};
  tm_select_args near;
  memset(&near, 0, sizeof near);
  near.kind = TM_SELECT_NEAR;
  near.cells = a.cells;
  near.border.dirty = dirty;
  int some = 0;
  for (int i = 0; i < N; i++) {
    UT_TRUE(tm_moved(i, &m) == moved[i] && marks[i] == moved[i] && was_at[i][0] == x[i][0]);
    dirty[i] = 0;
  }
  for (int i = 0; i < OWN; i++) {
    const int is_near = tm_selected(i, &near);
    int neighbor = 0;
    for (int j = 0; j < N; j++) {
      const tm_real dx = x[i][0] - x[j][0], dy = x[i][1] - x[j][1], dz = x[i][2] - x[j][2];
      neighbor |= moved[j] && dx * dx + dy * dy + dz * dz < 2.4 * 2.4;
    }
    UT_TRUE(is_near >= neighbor && dirty[i] == is_near);
    some += is_near;
  }
  UT_TRUE(some > 0 && some < OWN);

  /* a row that is too short says how long it would be, and writes nothing beyond its end */
  a.capacity = 3;
  a.segments = 1;
  for (int i = 0; i < OWN; i++) {
    for (int k = 0; k < ROOM; k++) row[first[i] + k * stride] = -7;
    const int n = tm_search(i, &a);
    if (n > 3) UT_TRUE(row[first[i] + 3 * stride] == -7);
    a.capacity = ROOM;
    UT_TRUE(n == tm_search(i, &a));
    a.capacity = 3;
  }
}

#ifndef UT_NEEDS
#define UT_NEEDS 1
#endif

int main(void)
{
  if (!(UT_NEEDS)) {
    printf("this processor cannot run these loops: skipped\n");
    return 77;
  }
  for (int c = 0; c < 8; c++) run(c & 1, c >> 1 & 1, c >> 2 & 1, c == 5 ? 32 : 1);
  return ut_summary();
}
