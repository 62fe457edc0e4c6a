/* Rows: what is in them and in which order, whichever way they are filled; what they tell of distances. */
#include "tm_neighbors.h"
#include "ut_state.h"

enum { N = 40, ALL = 60, LONGEST = 59, BITS = 0x3fffffff }; /* owned, with ghosts, longest list */

static int list[N * LONGEST], length[N], type[ALL], tag[ALL];
static int count[TM_SEGMENTS][N], index_[N * 3 * LONGEST * 32];
static ptrdiff_t first[N];
static unsigned char meets[9];
static double x[3 * ALL];

static tm_row_args args(void)
{
  tm_row_args a;
  a.list = list;
  a.length = length;
  a.row_step = LONGEST;
  a.step = 1;
  a.bits = BITS;
  a.meets = meets;
  a.type = type;
  a.tag = tag;
  a.ntypes = 2;
  a.index = index_;
  for (int s = 0; s < TM_SEGMENTS; s++) a.count[s] = count[s];
  a.first = first;
  a.stride = TM_ROW_SLICE;
  a.in_place = 0;
  return a;
}
static int entry(int i, int k) { return index_[first[i] + (ptrdiff_t) k * TM_ROW_SLICE]; }

/* random lists; some entries have bits above the index, ghosts have tags of owned particles */
static void make(void)
{
  for (int j = 0; j < ALL; j++) {
    type[j] = 1 + (ut_random(0, 1) < 0.4);
    tag[j] = j < N ? 1000 - 7 * j : tag[j - N];
    for (int d = 0; d < 3; d++) x[3 * j + d] = ut_random(0, 4);
  }
  meets[1 * 3 + 1] = TM_MEETS_MECHANICAL;
  meets[1 * 3 + 2] = meets[2 * 3 + 1] = TM_MEETS_THERMAL | TM_MEETS_CONTACT;
  meets[2 * 3 + 2] = TM_MEETS_MECHANICAL | TM_MEETS_THERMAL;
  for (int i = 0; i < N; i++) {
    length[i] = 0;
    for (int j = ALL - 1; j >= 0; j--)
      if (j != i && ut_random(0, 1) < (i == 3 ? 1.0 : 0.5)) list[i * LONGEST + length[i]++] = j | (j % 5 ? 0 : 1 << 30);
  }
  length[5] = 0;
}

static void place(const tm_row_args *a)
{
  ptrdiff_t at = 0;
  for (int i = 0; i < N; i++) {
    const int sum = tm_row_count(i, a);
    UT_TRUE(sum == count[0][i] + count[1][i] + count[2][i]);
  }
  for (int s = 0; s * TM_ROW_SLICE < N; s++) {
    int longest = 0;
    for (int i = s * TM_ROW_SLICE; i < N && i < (s + 1) * TM_ROW_SLICE; i++) {
      const int sum = count[0][i] + count[1][i] + count[2][i];
      first[i] = at + i % TM_ROW_SLICE;
      if (sum > longest) longest = sum;
    }
    UT_TRUE(tm_row_slice_size(s, N, a) == (ptrdiff_t) longest * TM_ROW_SLICE);
    at += tm_row_slice_size(s, N, a);
  }
}

static int is_in_list(int i, int j)
{
  for (int k = 0; k < length[i]; k++)
    if ((list[i * LONGEST + k] & BITS) == j) return 1;
  return 0;
}

static void check_rows(void)
{
  for (int i = 0; i < N; i++) {
    int at = 0;
    for (int s = 0; s < TM_SEGMENTS; s++) {
      int expected = 0;
      for (int j = 0; j < ALL; j++) expected += is_in_list(i, j) && (meets[type[i] * 3 + type[j]] >> s & 1);
      UT_TRUE(count[s][i] == expected);
      for (int k = 0; k < count[s][i]; k++) {
        const int j = entry(i, at + k), before = k ? entry(i, at + k - 1) : -1;
        UT_TRUE(j >= 0 && j < ALL && is_in_list(i, j) && (meets[type[i] * 3 + type[j]] >> s & 1));
        if (k) UT_TRUE(tag[before] < tag[j] || (tag[before] == tag[j] && before < j));
      }
      at += count[s][i];
    }
  }
}

static void rows(void)
{
  make();
  const tm_row_args a = args();
  place(&a);
  UT_TRUE(count[0][5] + count[1][5] + count[2][5] == 0);
  for (int k = 0; k < (int) (sizeof index_ / sizeof *index_); k++) index_[k] = -1;
  for (int i = 0; i < N; i++) tm_row_fill(i, &a);
  check_rows();
  /* the same by entries, in any order of k */
  for (int k = 0; k < (int) (sizeof index_ / sizeof *index_); k++) index_[k] = -1;
  for (int i = 0; i < N; i++) {
    tm_row_entry e[LONGEST];
    for (int k = 0; k < length[i]; k++) {
      e[k] = tm_row_load(i, k, &a);
      const int j = list[i * LONGEST + k] & BITS;
      UT_TRUE((int) (unsigned) e[k].key == j && (int) (e[k].key >> 32) == tag[j]);
    }
    for (int k = length[i] - 1; k >= 0; k--) tm_row_put(i, k, length[i], e, &a);
  }
  check_rows();
}

/* a list whose entries lie apart, as the host's on a GPU */
static void strided(void)
{
  static int apart[N * LONGEST];
  for (int i = 0; i < N; i++)
    for (int k = 0; k < LONGEST; k++) apart[k * N + i] = list[i * LONGEST + k];
  tm_row_args a = args();
  a.list = apart;
  a.row_step = 1;
  a.step = N;
  place(&a);
  for (int i = 0; i < N; i++) tm_row_fill(i, &a);
  check_rows();
}

/* rows in place of the list's: the segments first, what meets nothing behind them */
static void in_place(void)
{
  static int own[N * LONGEST];
  const unsigned char before[3] = {meets[1 * 3 + 2], meets[2 * 3 + 1], meets[2 * 3 + 2]};
  meets[1 * 3 + 2] = 0;
  meets[2 * 3 + 1] = TM_MEETS_CONTACT;
  meets[2 * 3 + 2] = TM_MEETS_MECHANICAL;
  for (int i = 0; i < N; i++)
    for (int k = 0; k < LONGEST; k++) own[k * N + i] = list[i * LONGEST + k] & BITS;
  tm_row_args a = args();
  a.list = a.index = own;
  a.row_step = 1;
  a.step = a.stride = N;
  a.in_place = 1;
  for (int i = 0; i < N; i++) {
    tm_row_entry e[LONGEST];
    tm_row_count(i, &a);
    UT_TRUE(first[i] == i);
    for (int k = 0; k < length[i]; k++) e[k] = tm_row_load(i, k, &a);
    for (int k = 0; k < length[i]; k++) tm_row_put(i, k, length[i], e, &a);
    long sum = 0, due = 0;
    int k = 0;
    for (int s = 0; s <= TM_SEGMENTS; s++)
      for (int c = 0, end = s < TM_SEGMENTS ? count[s][i] : length[i] - k; c < end; c++, k++) {
        const int j = own[k * N + i], m = meets[type[i] * 3 + type[j]];
        UT_TRUE(s < TM_SEGMENTS ? m >> s & 1 : m == 0);
        if (c) UT_TRUE(tm_row_before(own[(k - 1) * N + i], j, tag));
      }
    for (k = 0; k < length[i]; k++) {
      sum += own[k * N + i] + 1;
      due += (list[i * LONGEST + k] & BITS) + 1;
    }
    UT_TRUE(sum == due);
  }
  meets[1 * 3 + 2] = before[0];
  meets[2 * 3 + 1] = before[1];
  meets[2 * 3 + 2] = before[2];
}

/* distances, against all pairs */
static void near(void)
{
  double each[N], main[ALL * TM_REC], size[ALL * TM_REC_SIZE];
  tm_near_args a;
  memset(&a, 0, sizeof a);
  a.rows.index = index_;
  a.rows.first = first;
  a.rows.stride = TM_ROW_SLICE;
  a.rows.mechanical = count[0];
  a.rows.thermal = count[1];
  a.rows.contact = count[2];
  for (int i = 0; i < ALL; i++)
    for (int d = 0; d < 3; d++) main[TM_REC * i + d] = x[3 * i + d];
  a.main = main;
  a.support_radius2 = 2.25;
  a.count = each;
  a.dim = 3;
  tm_nearest all = tm_nearest_nothing();
  double closest = 1e300, sum = 0.0, dense = 0.0;
  int have = 0, who = -1, whom = -1;
  for (int i = 0; i < N; i++) {
    int within = 0;
    double mine = 1e300, density = 0.0;
    for (int k = 0; k < count[0][i]; k++) {
      const int j = entry(i, k);
      double r2 = 0.0;
      for (int d = 0; d < 3; d++) r2 += (x[3 * i + d] - x[3 * j + d]) * (x[3 * i + d] - x[3 * j + d]);
      within += r2 < 2.25;
      density += r2 < 2.25 ? (1.0 - r2 / 2.25) * (1.0 - r2 / 2.25) : 0.0;
      mine = fmin(mine, sqrt(r2));
      if (sqrt(r2) < closest) {
        closest = sqrt(r2);
        who = i;
        whom = j;
      }
    }
    UT_TRUE(tm_near_count(i, &a) == within && each[i] == within);
    const tm_nearest c = tm_nearest_neighbor(i, &a);
    if (count[0][i]) {
      UT_NEAR(c.distance, mine, 1e-15);
      UT_TRUE(c.i == i && c.count == 1.0 && c.sum == c.distance);
      UT_NEAR(c.density, density, 1e-14 * (1.0 + density));
      sum += mine;
      dense += density;
      have++;
    } else UT_TRUE(c.i == -1 && c.count == 0.0 && c.sum == 0.0);
    tm_nearest_sum(&all, &c);
  }
  UT_NEAR(all.distance, closest, 1e-15);
  UT_NEAR(all.sum, sum, 1e-13);
  UT_NEAR(all.density, dense, 1e-12);
  UT_TRUE(all.i == who && all.j == whom && all.count == have && have < N);
  a.count = NULL;
  UT_TRUE(tm_near_count(0, &a) == each[0]);
  /* with an h of each particle's own: below 1.5 sqrt(h_i h_j) */
  for (int i = 0; i < ALL; i++) size[TM_REC_SIZE * i + TM_SIZE_INV_H] = 1.0 / (0.5 + 0.01 * i);
  a.size = size;
  for (int i = 0; i < N; i++) {
    int within = 0;
    for (int k = 0; k < count[0][i]; k++) {
      const int j = entry(i, k);
      double r2 = 0.0;
      for (int d = 0; d < 3; d++) r2 += (x[3 * i + d] - x[3 * j + d]) * (x[3 * i + d] - x[3 * j + d]);
      within += r2 < 2.25 * (0.5 + 0.01 * i) * (0.5 + 0.01 * j);
    }
    UT_TRUE(tm_near_count(i, &a) == within);
    UT_TRUE((tm_nearest_neighbor(i, &a).density > 0.0) == (within > 0));
  }

  /* rows and layers are flat in any direction, what has two of them is not */
  for (int k = 0; k < 200; k++) {
    const tm_vec3 u = tm_vec(ut_random(-1, 1), ut_random(-1, 1), ut_random(-1, 1)),
                  w = tm_vec(ut_random(-1, 1), ut_random(-1, 1), ut_random(-1, 1));
    const tm_vec3 z = tm_vec_cross(u, w);
    const tm_sym3 row = tm_mat_symmetric(tm_mat_outer(u, u)),
                  layer = tm_sym_axpy(row, 1.0, tm_mat_symmetric(tm_mat_outer(w, w)));
    UT_TRUE(tm_near_is_flat(row, 3) && tm_near_is_flat(layer, 3));
    UT_TRUE(!tm_near_is_flat(tm_sym_axpy(layer, 1.0, tm_mat_symmetric(tm_mat_outer(z, z))), 3) ||
            tm_vec_norm(z) < 1e-2);
    const tm_vec3 p = tm_vec(u.x, u.y, 0), q = tm_vec(-u.y, u.x, 0);
    const tm_sym3 line = tm_mat_symmetric(tm_mat_outer(p, p));
    UT_TRUE(tm_near_is_flat(line, 2) &&
            !tm_near_is_flat(tm_sym_axpy(line, 0.1, tm_mat_symmetric(tm_mat_outer(q, q))), 2));
  }

  tm_nearest one = tm_nearest_nothing(), two = one; /* of equal distances the lower number */
  one.distance = two.distance = 1.0;
  one.i = 4;
  two.i = 2;
  tm_nearest_sum(&one, &two);
  UT_TRUE(one.i == 2);
  two.i = 9;
  tm_nearest_sum(&one, &two);
  UT_TRUE(one.i == 2);
}

int main(void)
{
  rows();
  strided();
  in_place();
  near();
  return ut_summary();
}
