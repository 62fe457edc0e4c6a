/* Rows from the cells against all pairs: two and three dimensions, one reach and one each, types, rows that are full, cells
   as wide as the largest search radius and, where each has its own, narrower; how far a particle has to look;
   which rows one that has moved is near to; rows with a margin where each has its own reach, which grows. */
#include "tm_candidates.h"
#include "ut.h"

#include <string.h>

enum { N = 600, OWN = 500, TYPES = 3, ROOM = 400 };

static double x[N][3];
static tm_real radius[N];
static int type[N], tag[N], cell[N], order[N + TM_COLUMN], begin[100000], marked[N + 1];
static tm_real column[4][N + TM_COLUMN], look[2][100000];
static int row[N * ROOM], count[TM_SEGMENTS][N];
static ptrdiff_t first[N];
static unsigned char meets[(TYPES + 1) * (TYPES + 1)], moved[N], marks[N], dirty[N];
static double was_at[N][3];

static void sort(tm_cells *c, int dim3, tm_real widest, tm_real width)
{
  tm_bounds b = tm_bounds_nothing();
  for (int i = 0; i < N; i++) {
    const tm_bounds one = tm_bounds_of(x[i]);
    tm_bounds_sum(&b, &one);
  }
  c->n = N;
  c->x = x[0];
  tm_cells_make(c, b, widest, width, dim3, 99000);
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
  for (int d = 0; d < 2; d++) c->look[d] = look[d];
  if (!c->radius) return;
  for (int q = 0; q < cells; q++) look[1][q] = tm_cells_radius(c, q);
  for (int axis = 0; axis < 3; axis++)
    for (int q = 0; q < cells; q++) look[axis % 2][q] = tm_cells_look(c, q, axis, look[1 - axis % 2]);
}

/* what should be entry k of segment s of row i; -1 behind the last */
static int expected(int i, int s, int k, const tm_search_args *a)
{
  int last_tag = INT_MIN, last = -1;
  for (int n = 0;; n++) {
    int next = -1;
    for (int j = 0; j < N; j++) {
      const tm_real r = a->cells.radius ? tm_max(radius[i], radius[j]) : a->radius;
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
  const tm_real r = a->cells.radius ? radius[i] : a->radius;
  for (int s = 0; s < TM_SEGMENTS; s++) {
    if (!(a->segments >> s & 1)) continue;
    int n = 0;
    tm_around around = tm_cells_around(&a->cells, x[i]);
    while (tm_around_next(&around, &a->cells, &begin, &end)) {
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

static void run(int dim3, int own_radii, int types, ptrdiff_t stride, tm_real width)
{
  const tm_real side = dim3 ? 8.0 : 24.0;
  for (int i = 0; i < N; i++) {
    for (int d = 0; d < 3; d++) x[i][d] = d == 2 && !dim3 ? 0.0 : ut_random(-0.3 * side, 0.7 * side);
    radius[i] = ut_random(0.5, 2.4);
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
  a.cells.radius = own_radii ? radius : NULL;
  sort(&a.cells, dim3, 2.4, width);
  for (int k = 0; k < N; k++) marked[k + 1] = marked[k] + moved[order[k]];
  a.cells.marked = marked;
  a.radius = 2.4;
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

  tm_moved_args m = {x[0], was_at[0], 0.4, 0.5, marks, NULL, 0, NULL};
  const tm_near_moved_args near = {a.cells, dirty};
  int some = 0;
  for (int i = 0; i < N; i++) {
    UT_TRUE(tm_moved(i, &m) == moved[i] && marks[i] == moved[i] && was_at[i][0] == x[i][0]);
    dirty[i] = 0;
  }
  for (int i = 0; i < OWN; i++) {
    const int is_near = tm_near_moved(i, &near);
    int neighbor = 0;
    for (int j = 0; j < N; j++) {
      const tm_real dx = x[i][0] - x[j][0], dy = x[i][1] - x[j][1], dz = x[i][2] - x[j][2];
      const tm_real r = own_radii ? tm_max(radius[i], radius[j]) : 2.4;
      neighbor |= moved[j] && dx * dx + dy * dy + dz * dz < r * r;
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

static tm_search_args search_of(int dim3, tm_real widest, tm_real width, const tm_real *radii)
{
  tm_search_args a;
  memset(&a, 0, sizeof a);
  a.cells.radius = radii;
  sort(&a.cells, dim3, widest, width);
  a.radius = widest;
  a.segments = 1;
  a.tag = tag;
  a.capacity = ROOM;
  a.stride = 1;
  a.index = row;
  a.first = first;
  for (int s = 0; s < TM_SEGMENTS; s++) a.count[s] = count[s];
  for (int i = 0; i < N; i++) {
    const int n = tm_search(i, &a);
    UT_TRUE(n == count[0][i] && n <= ROOM);
  }
  return a;
}

static int in_row(int i, int j)
{
  for (int k = 0; k < count[0][i]; k++)
    if (row[first[i] + k] == j) return 1;
  return 0;
}

/* A particle looks as far as the reach of those that reach it, and no further than that of those that reach to within two
   cells of it. */
static void check_look(int i, const tm_cells *c)
{
  const tm_real found = look[0][tm_cells_of(c, x[i])];
  tm_real least = radius[i], most = radius[i];
  for (int j = 0; j < N; j++) {
    const tm_real dx = x[i][0] - x[j][0], dy = x[i][1] - x[j][1], dz = x[i][2] - x[j][2], r = radius[j];
    if (dx * dx + dy * dy + dz * dz < r * r) least = tm_max(least, r);
    if (fabs(dx) < r + 2 * c->width[0] && fabs(dy) < r + 2 * c->width[1] && fabs(dz) < r + 2 * c->width[2])
      most = tm_max(most, r);
  }
  UT_TRUE(least <= found && found <= (1.0 + 1e-8) * most);
}

/* A third of the particles is small and lies close. Rows of the small ones hold what is near them, not what the large
   ones would want; they hold all within the search radius as long as nobody has moved and grown by half the margin in sum. */
static void own_reaches(int dim3)
{
  static tm_real size[N][TM_REC_SIZE];
  static double place[N][3];
  const tm_real support = 2.0, margin = 0.2, side = dim3 ? 8.0 : 24.0;
  tm_real mean[2] = {0, 0};
  for (int i = 0; i < N; i++) {
    const int small = i < N / 3;
    for (int d = 0; d < 3; d++) x[i][d] = d == 2 && !dim3 ? 0.0 : ut_random(0.0, side) * (small ? 0.5 : 1.0);
    x[i][0] -= small ? 0.75 * side : 0.0;
    size[i][TM_SIZE_INV_H] = 1.0 / (ut_random(1.0, 1.2) * (small ? 0.5 : 1.0));
    tag[i] = i;
    first[i] = (ptrdiff_t) i * ROOM;
  }
  tm_moved_args m = {x[0], place[0], margin, -1.0, marks, size[0], support, radius};
  for (int i = 0; i < N; i++) {
    UT_TRUE(tm_moved(i, &m) == 1 && place[i][0] == x[i][0]);
    UT_NEAR(radius[i], 1.2 * 2.0 / size[i][TM_SIZE_INV_H], 1e-15);
  }
  const tm_real widest = 1.2 * 2.0 * 1.2;
  for (int own = 0; own < 2; own++) {
    const tm_search_args a = search_of(dim3, widest, own ? 0.5 * widest : widest, own ? radius : NULL);
    for (int i = 0; i < N / 3; i++) mean[own] += count[0][i] / (N / 3.0);
    for (int i = 0; own && i < N; i++) check_look(i, &a.cells);
  }
  UT_TRUE(mean[1] < (dim3 ? 0.35 : 0.45) * mean[0]);    /* (1/2)^3 and (1/2)^2 but for those at the border of the two */

  /* all go and grow at random, up to what is allowed */
  m.part = 0.5;
  m.marks = NULL;
  int far = 0;
  for (int i = 0; i < N; i++) {
    const tm_real s = support / size[i][TM_SIZE_INV_H], room = 0.499 * margin * s, grown = ut_random(0.0, 1.0) * room;
    const tm_real angle = ut_random(0.0, 6.28318);
    x[i][0] += (room - grown) * cos(angle);
    x[i][1] += (room - grown) * sin(angle);
    size[i][TM_SIZE_INV_H] = support / (s + grown);
    UT_TRUE(tm_moved(i, &m) == 0);
  }
  for (int i = 0; i < N; i++)
    for (int j = 0; j < N; j++) {
      const tm_real r = support / tm_min(size[i][TM_SIZE_INV_H], size[j][TM_SIZE_INV_H]);
      const tm_real dx = x[i][0] - x[j][0], dy = x[i][1] - x[j][1], dz = x[i][2] - x[j][2];
      const tm_real ox = place[i][0] - place[j][0], oy = place[i][1] - place[j][1];
      if (i == j || dx * dx + dy * dy + dz * dz >= r * r) continue;
      UT_TRUE(in_row(i, j));
      far += ox * ox + oy * oy + dz * dz > r * r;
    }
  UT_TRUE(far > 20);    /* neighbours that were none at the search */

  /* either of the two alone is enough; a shrunken reach is not */
  m.marks = marks;
  for (int k = 0; k < 3; k++) {
    m.part = -1.0;
    UT_TRUE(tm_moved(k, &m) == 1);
    const tm_real s = support / size[k][TM_SIZE_INV_H];
    if (k == 0) x[k][0] += 0.501 * margin * s;
    if (k == 1) size[k][TM_SIZE_INV_H] /= 1.0 + 0.501 * margin;
    if (k == 2) size[k][TM_SIZE_INV_H] *= 2.0;
    m.part = 0.5;
    UT_TRUE(tm_moved(k, &m) == (k < 2) && marks[k] == (k < 2));
    UT_NEAR(radius[k], 1.2 * s * (k == 1 ? 1.0 + 0.501 * margin : 1.0), 1e-14 * s);
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
  for (int c = 0; c < 8; c++) run(c & 1, c >> 1 & 1, c >> 2 & 1, c == 5 ? 32 : 1, 2.4);
  for (int c = 0; c < 4; c++) run(c & 1, 1, 0, 1, c & 2 ? 1.2 : 0.7);
  own_reaches(0);
  own_reaches(1);
  return ut_summary();
}
