/* Total-Lagrangian pairs: a block that turns and stretches. Exact gradients of linear velocities where corrected,
   objective ones where not; forces without resultant, work conjugate to the strain rates; one end updated-Lagrangian; one
   end deleted. */
#include "tm_tag_map.h"
#include "tm_tl_interface.h"
#include "ut.h"

#include <stdlib.h>
#include <string.h>

enum { SIDE = 6, MOST = SIDE * SIDE * SIDE, ROOM = 128 };
#define DP 1e-3
#define H (1.2 * DP)

static int N, in_3d;
static double X[MOST][3], x[MOST][3], force[MOST][3];
static tm_real main_rec[MOST * TM_REC], stress_rec[MOST * TM_REC_STRESS], heat_rec[MOST * TM_REC_HEAT];
static tm_real exported[MOST * TM_TL_EXPORT], pull_back[MOST * TM_FREEZE_EXPORT], history[(MOST + 1) * TM_TL_HISTORY];
static tm_real gradient[MOST * 9], heat[MOST], artificial[MOST], next_ul[MOST];
static int row[MOST * ROOM], tl[MOST + 1], ul[MOST], candidate[MOST * ROOM], candidates_of[MOST];
static unsigned char was_ul[MOST], is_ul[MOST], dirty[MOST];
static ptrdiff_t first[MOST], ul_first[MOST];
static short *weight;

static tm_tl_rows rows(void)
{
  tm_tl_rows r = {row, tl, ul, first, ul_first, 1, ROOM, tm_tl_unit(TM_KERNEL_HYPERBOLIC), weight};
  return r;
}

/* x = A X, v = L x */
static void place(tm_mat3 A, tm_mat3 L)
{
  for (int i = 0; i < N; i++) {
    tm_real *r = main_rec + i * TM_REC;
    const double *p = X[i];
    x[i][0] = A.xx * p[0] + A.xy * p[1] + A.xz * p[2];
    x[i][1] = A.yx * p[0] + A.yy * p[1] + A.yz * p[2];
    x[i][2] = A.zx * p[0] + A.zy * p[1] + A.zz * p[2];
    const double *q = x[i];
    for (int d = 0; d < 3; d++) r[d] = q[d];
    r[4] = L.xx * q[0] + L.xy * q[1] + L.xz * q[2];
    r[5] = L.yx * q[0] + L.yy * q[1] + L.yz * q[2];
    r[6] = L.zx * q[0] + L.zy * q[1] + L.zz * q[2];
  }
}

static void search(int i)
{
  candidates_of[i] = 0;
  for (int j = 0; j < N; j++) {
    if (j == i) continue;
    const double a = x[i][0] - x[j][0], b = x[i][1] - x[j][1], c = x[i][2] - x[j][2];
    if (a * a + b * b + c * c < 4.5 * H * H) candidate[first[i] + candidates_of[i]++] = j;
  }
}

static tm_rows candidate_rows(void)
{
  tm_rows r = {candidate, first, candidates_of, NULL, NULL, 1};
  return r;
}

static tm_interface_args interface_args(void)
{
  tm_interface_args a = {rows(), candidate_rows(), next_ul, was_ul, is_ul, dirty, 0, 0};
  a.own = N;
  return a;
}

static tm_freeze_args freeze_args(int corrected)
{
  tm_freeze_args a;
  memset(&a, 0, sizeof a);
  a.rows = rows();
  a.rec.main = main_rec;
  a.gradient = gradient;
  a.candidates = candidate_rows();
  a.history = history;
  a.pull_back = pull_back;
  a.next_ul = next_ul;
  a.was_ul = was_ul;
  a.is_ul = is_ul;
  a.dirty = dirty;
  a.freezes = a.measures = 1;
  a.corrected = corrected;
  a.threshold = a.strain = INFINITY;
  a.h = H;
  a.support_radius2 = 4.0 * H * H;
  a.visc_alpha = a.visc_beta = 1.0;
  a.slope_norm = tm_kernel_norm(TM_KERNEL_HYPERBOLIC, in_3d ? 3 : 2, H) / H;
  return a;
}

static void freeze(const tm_freeze_args *a, unsigned fx)
{
  const tm_interface_args b = interface_args();
  for (int i = 0; i < N; i++) tm_freeze_decide(i, a, fx);
  for (int i = 0; i < N; i++) tm_interface_switch(i, &b);
  memset(dirty, 0, sizeof dirty);
  for (int i = 0; i < N; i++) tm_interface_mark(i, &b);
  for (int i = 0; i < N; i++) tm_freeze(i, a, fx);
  for (int i = 0; i < N; i++) tm_interface_row(i, &b);
}

static void rates(unsigned fx)
{
  tm_tl_args a;
  memset(&a, 0, sizeof a);
  a.rows = rows();
  a.rec.main = main_rec;
  a.rec.stress = stress_rec;
  a.rec.heat = heat_rec;
  a.exported = exported;
  a.history = history;
  a.h = H;
  a.slope_norm = freeze_args(0).slope_norm;
  a.force_unit = 1.0;
  a.force = force[0];
  a.gradient = gradient;
  a.heat = heat;
  a.artificial = artificial;
  memset(force, 0, sizeof force);
  for (int i = 0; i < N; i++) tm_tl_export(i, &a, exported);
  for (int i = 0; i < N; i++) tm_tl_rates(i, &a, fx);
}

static void check_conservation(unsigned fx, double scale)
{
  double f[3] = {0, 0, 0}, power = 0.0, strain = 0.0, abs = 0.0;
  for (int i = 0; i < N; i++) {
    const tm_real *r = main_rec + i * TM_REC;
    for (int d = 0; d < 3; d++) {
      f[d] += force[i][d];
      abs += fabs(force[i][d]);
      power += force[i][d] * r[4 + d];
    }
    const tm_sym3 sigma = tm_sym_scale(r[TM_REC_RHO] * r[TM_REC_RHO], tm_sym_load(r + TM_REC_P));
    const tm_sym3 D = tm_mat_symmetric(tm_mat_load(gradient + i * 9));
    strain += r[TM_REC_M] / r[TM_REC_RHO] * tm_sym_ddot(sigma, D);
    if (fx & (TM_FX_VISCOSITY | TM_FX_ARTSTRESS)) strain += artificial[i];
  }
  for (int d = 0; d < 3; d++) UT_WITHIN(f[d] / abs, 0.0, 1e-13);
  UT_WITHIN((power + strain) / (fabs(power) + scale), 0.0, 1e-11);
}

static tm_mat3 turn(double angle)
{
  tm_mat3 R = tm_mat_identity();
  R.xx = R.yy = cos(angle);
  R.yx = sin(angle);
  R.xy = -R.yx;
  return R;
}

static void start(void)
{
  N = 0;
  for (int a = 0; a < SIDE; a++)
    for (int b = 0; b < SIDE; b++)
      for (int c = 0; c < (in_3d ? SIDE : 1); c++, N++) {
        X[N][0] = DP * (a + ut_random(-0.1, 0.1));
        X[N][1] = DP * (b + ut_random(-0.1, 0.1));
        X[N][2] = in_3d ? DP * (c + ut_random(-0.1, 0.1)) : 0.0;
        tm_real *r = main_rec + N * TM_REC;
        r[TM_REC_RHO] = ut_random(2000, 3000);
        r[TM_REC_M] = ut_random(0.9, 1.1) * 2700 * DP * DP * (in_3d ? DP : 1.0);
        for (int k = 0; k < 6; k++) r[TM_REC_P + k] = (in_3d || (k != 4 && k != 5)) * ut_random(-1, 1) * 30.0;
        r[TM_REC_C] = 5000;
        for (int k = 0; k < 6; k++)
          stress_rec[N * TM_REC_STRESS + k] = in_3d || k == 0 || k == 1 || k == 3 ? ut_random(-5, 0) : 0.0;
        heat_rec[N * TM_REC_HEAT] = ut_random(300, 400);
        heat_rec[N * TM_REC_HEAT + 1] = 100;
        first[N] = (ptrdiff_t) N * ROOM;
        tl[N] = ul[N] = 0;
        is_ul[N] = 1;
        for (int k = 0; k < TM_TL_HISTORY; k++) history[N * TM_TL_HISTORY + k] = 0.0;
      }
}

static tm_mat3 velocity_gradient(void)
{
  tm_mat3 L = tm_mat_scale(0.0, tm_mat_identity());
  L.xx = 300; L.xy = -200; L.yx = 500; L.yy = -100;
  if (in_3d) { L.xz = 40; L.zx = -60; L.yz = 20; L.zy = 70; L.zz = 250; }
  return L;
}

/* the gradient of particle i is that of the field */
static void check_gradient(int i, tm_mat3 want, double within)
{
  for (int k = 0; k < 9; k++) UT_WITHIN(gradient[i * 9 + k] / 500.0, (&want.xx)[k] / 500.0, within);
}

/* turned and stretched; B follows from the positions, by way of one step */
static void turned(tm_freeze_args *a, int corrected, unsigned fx)
{
  static tm_real before[MOST * 9];
  memcpy(before, gradient, sizeof before);
  tm_mat3 A = turn(1.1);
  if (corrected) {
    tm_mat3 U = tm_mat_identity();
    U.xx = 1.3; U.xy = 0.2; U.yy = 0.8;
    if (in_3d) { U.xz = -0.1; U.zz = 1.2; }
    A = tm_mat_mul(A, U);
  }
  const tm_mat3 L = velocity_gradient(), R = turn(1.1);
  const tm_mat3 is_ul = corrected ? L : tm_mat_mul(tm_mat_mul(R, L), tm_mat_transposed(R));
  place(A, is_ul);
  rates(fx);
  a->dt = 0.0;
  freeze(a, fx);
  rates(fx);
  check_conservation(fx, 0.0);
  for (int i = 0; i < N; i++) {
    const tm_mat3 old = tm_mat_load(before + i * 9);
    const tm_mat3 want = corrected ? L : tm_mat_mul(tm_mat_mul(R, old), tm_mat_transposed(R));
    check_gradient(i, want, 1e-7 * !corrected + 1e-10);
  }
}

/* one is updated-Lagrangian: its pairs are as new, all others stay */
static void one_updated(tm_freeze_args *a, unsigned fx)
{
  for (int i = 0; i < N; i++) search(i);
  history[(N / 2) * TM_TL_HISTORY + TM_TL_PROXIMITY] = 1.0;
  freeze(a, fx);
  UT_TRUE(tl[N / 2] == 0);
  history[(N / 2) * TM_TL_HISTORY + TM_TL_PROXIMITY] = 0.0;
  int border = 0;
  for (int i = 0; i < N; i++) {
    for (int e = 0; e < tl[i]; e++) UT_TRUE(row[first[i] + e] != N / 2);
    UT_TRUE(ul[i] <= 1 && (!ul[i] || row[ul_first[i]] == N / 2));
    border += ul[i];
  }
  UT_TRUE(border == candidates_of[N / 2]);
  memset(gradient, 0, sizeof gradient);
  rates(fx);
  freeze(a, fx);
  rates(fx);
  check_conservation(fx, 0.0);
  for (int i = 0; i < N; i++) {
    UT_TRUE(ul[i] == 0);
    UT_TRUE(history[i * TM_TL_HISTORY + TM_TL_UL_STEPS] == 1.0 + (i == N / 2));
  }
}

/* of every kept pair of particle i */
static void both_ends_agree(int i)
{
  for (int e = 0; e < tl[i]; e++) {
    const int j = row[first[i] + e];
    int back = 0;
    while (back < tl[j] && row[first[j] + back] != i) back++;
    UT_TRUE(back < tl[j]);
    const tm_tl_rows r = rows();
    const short *w = tm_weight(&r, i), *v = tm_weight(&r, j);
    for (int c = 0; c < 3; c++) {
      UT_TRUE(w[tm_weight_place(&r, TM_W_OWN + c, e)] == -v[tm_weight_place(&r, TM_W_OTHER + c, back)]);
      UT_TRUE(v[tm_weight_place(&r, TM_W_OWN + c, back)] == -w[tm_weight_place(&r, TM_W_OTHER + c, e)]);
    }
    for (int c = 0; c < TM_WEIGHTS; c++)
      if (c >= TM_W_SLOPE || c == TM_W_BULK || c == TM_W_SHOCK)
        UT_TRUE(w[tm_weight_place(&r, c, e)] == v[tm_weight_place(&r, c, back)]);
  }
}

/* The last particle is deleted: its pairs are dropped, B of the others stays and turns on with them. */
static void one_gone(tm_freeze_args *a, int corrected, unsigned fx)
{
  static int tag[MOST], with_tag[MOST + 1], image[MOST];
  static unsigned char gone[MOST];
  static tm_real before[MOST * 9];
  tm_tag_map_args p;
  memset(&p, 0, sizeof p);
  p.store.rows = rows();
  p.store.history = history;
  p.entry_tag = p.tag = tag;
  p.x = x[0];
  p.largest = N;
  p.first = with_tag;
  p.next = image;
  p.gone = gone;
  p.rec.main = main_rec;
  p.slope_norm = a->slope_norm;
  p.corrected = corrected;
  p.dim3 = in_3d;
  memset(gone, 0, sizeof gone);
  for (int i = 0; i < N; i++) {
    tag[i] = i + 1;
    with_tag[i + 1] = i < N - 1 ? i + 1 : 0;
    for (int k = 0; k < 9; k++) before[9 * i + k] = history[i * TM_TL_HISTORY + TM_TL_B + k];
  }
  int pairs = 0;
  N--;
  for (int i = 0; i < N; i++) {
    const int all = tl[i], lost = tm_tag_map_resolve(i, &p);
    pairs += lost;
    UT_TRUE(tl[i] == all - lost && lost <= 1);
    for (int e = 0; e < tm_tl_padded(tl[i]); e++) UT_TRUE(row[first[i] + e] < N);
    for (int k = 0; k < 9 && !corrected; k++)
      UT_WITHIN(history[i * TM_TL_HISTORY + TM_TL_B + k] * 2700, before[9 * i + k] * 2700, 1e-12);
  }
  UT_TRUE(pairs == tl[N] && pairs > 5);
  for (int i = 0; i < N; i++) UT_TRUE(!gone[i]);
  UT_TRUE(gone[N]);
  memset(gradient, 0, sizeof gradient);
  rates(fx);
  check_conservation(fx, 0.0);
  const tm_mat3 L = velocity_gradient(), R = turn(0.4), all = turn(1.5);
  for (int i = 0; i < N && corrected; i++) check_gradient(i, L, 1e-10);
  if (corrected) return;
  memcpy(before, gradient, sizeof before);
  place(all, tm_mat_mul(tm_mat_mul(all, L), tm_mat_transposed(all)));
  for (int i = 0; i < N; i++) search(i);
  rates(fx);
  freeze(a, fx);
  rates(fx);
  check_conservation(fx, 0.0);
  for (int i = 0; i < N; i++)
    check_gradient(i, tm_mat_mul(tm_mat_mul(R, tm_mat_load(before + i * 9)), tm_mat_transposed(R)), 1e-7);
}

static void run(int corrected, unsigned fx)
{
  in_3d = (fx & TM_FX_3D) != 0;
  start();
  const tm_mat3 L = velocity_gradient();
  place(tm_mat_identity(), L);
  for (int i = 0; i < N; i++) search(i);
  memset(gradient, 0, sizeof gradient);
  tm_freeze_args a = freeze_args(corrected);
  freeze(&a, fx);
  /* as it lies: reference */
  rates(fx);
  check_conservation(fx, 0.0);
  for (int i = 0; i < N && corrected; i++) check_gradient(i, L, 1e-11);
  turned(&a, corrected, fx);
  one_updated(&a, fx);
  for (int i = 0; i < N; i++) both_ends_agree(i);
  for (int i = 0; i < N && corrected; i++) check_gradient(i, L, 1e-10);
  one_gone(&a, corrected, fx);
}

/* What 16 bits keep: gradients to half a unit, alike on both sides; halves of floats to 2^-9; slopes all. */
static void weights(void)
{
  for (int kernel = 0; kernel < TM_KERNEL_COUNT; kernel++) {
    double steepest = 0.0;
    for (double q = 0.0; q < 3.0; q += 1.0 / 4096) steepest = fmax(steepest, fabs(tm_kernel_slope(kernel, q)));
    UT_WITHIN(tm_tl_unit(kernel) * 32767.0 / (TM_TL_SLOPE_RANGE * steepest), 1.0, 1e-4);
  }
  for (int k = 0; k < 1000; k++) {
    const double v = ut_random(-32767.0, 32767.0), u = ut_random(-1, 1) * pow(10.0, ut_random(-6, 6));
    UT_WITHIN(tm_weight_whole(v), v, 0.5);
    UT_TRUE(tm_weight_whole(-v) == -tm_weight_whole(v));
    UT_WITHIN(tm_weight_float((unsigned) (unsigned short) tm_weight_upper(u) << 16) / u, 1.0, 1.0 / 256.0);
    short TM_ALIGNED some[16];
    for (int l = 0; l < 16; l++) some[l] = tm_weight_upper(u);
    UT_WITHIN(tm_lanes_sum(tm_weight_upper_lanes(some, 1)) / (TM_LANES * u), 1.0, 1.0 / 256.0);
    for (int l = 0; l < 16; l++) some[l] = tm_weight_whole(v);
    UT_TRUE(tm_lanes_sum(tm_weight_lanes(some, 1)) == TM_LANES * (double) some[0]);
  }
}

/* A particle whose gradients would not fit is updated-Lagrangian; one that is turned and a little less stretched is not. */
static void too_large(unsigned fx)
{
  for (int large = 0; large < 2; large++) {
    in_3d = (fx & TM_FX_3D) != 0;
    start();
    const tm_mat3 still = tm_mat_scale(0.0, tm_mat_identity());
    place(tm_mat_identity(), still);
    for (int i = 0; i < N; i++) search(i);
    tm_freeze_args a = freeze_args(0);
    freeze(&a, fx);
    tm_mat3 U = tm_mat_identity();
    U.xx = large ? 2.01 : 1.99;    /* the density stays: E = F^T */
    place(tm_mat_mul(turn(0.7), U), still);
    rates(fx);
    freeze(&a, fx);                       /* B follows */
    rates(fx);
    freeze(&a, fx);
    for (int i = 0; i < N; i++) UT_TRUE(is_ul[i] == large);
  }
}

/* Gradients of a particle turned and stretched: waves are as much faster as its most compressed direction is short. */
static void fastest(unsigned fx)
{
  in_3d = (fx & TM_FX_3D) != 0;
  start();
  tm_tl_args a;
  memset(&a, 0, sizeof(a));
  a.rows = rows();
  a.rec.main = main_rec;
  a.history = history;
  main_rec[TM_REC_C] = 3.0;
  tl[0] = 1;
  const double stretch[4][3] = {{1, 1, 1}, {2, 1.5, 1}, {0.2, 1.7, 1}, {0.5, 1.3, 0.4}};
  for (int k = 0; k < 4; k++) {
    tm_mat3 U = tm_mat_identity();
    int good;
    U.xx = stretch[k][0];
    U.yy = stretch[k][1];
    if (in_3d) U.zz = stretch[k][2];
    const double J = U.xx * U.yy * U.zz, least = fmin(fmin(U.xx, U.yy), fmin(U.zz, 1.0));
    const tm_mat3 F = tm_mat_mul(turn(0.7), U), D = tm_mat_scale(1.0 / J, tm_mat_transposed(tm_mat_inverse(F, in_3d, &good)));
    tm_mat_store(history + TM_TL_B, tm_mat_scale(1.0 / main_rec[TM_REC_RHO], D));
    UT_NEAR(tm_tl_fastest(0, &a, fx), 3.0 / least, 1e-12);
  }
  tl[0] = 0;
  UT_TRUE(tm_tl_fastest(0, &a, fx) == 0.0);
}

int main(void)
{
  weight = (short *) calloc((size_t) MOST * ROOM * TM_WEIGHTS + 16, sizeof(short));
  if (!weight) return 1;
  for (int corrected = 0; corrected < 2; corrected++)
    for (int d = 0; d < 2; d++) {
      const unsigned fx = d ? (unsigned) TM_FX_3D : 0u;
      run(corrected, fx);
      run(corrected, fx | TM_FX_VISCOSITY | TM_FX_ARTSTRESS | TM_FX_CONDUCTION);
    }
  weights();
  too_large(0u);
  too_large(TM_FX_3D);
  fastest(0u);
  fastest(TM_FX_3D);
  free(weight);
  return ut_summary();
}
