/* The rate pass with gradient correction and hourglass control in it: against the passes of their own, and what it makes
   for the next step against sums written out pair by pair. */
#include "tm_hourglass.h"
#include "tm_moment.h"
#include "tm_rates.h"
#include "ut.h"

#include <string.h>

enum { MOST = 400, ROOM = 300 };

static int n, dim, row[MOST * ROOM], length[MOST];
static ptrdiff_t first[MOST];
static tm_real TM_ALIGNED main_[MOST * TM_REC], stab[MOST * TM_REC_STAB], hourglass[MOST * TM_REC_HOURGLASS];
static tm_real PK[MOST * TM_REC_CORRECTION], K[6 * MOST];
typedef struct {
  double force[3 * MOST], gradient[9 * MOST], artificial[MOST], rate[3 * MOST], moment[TM_MOMENT_COLUMNS * MOST];
} results;
static results one, apart;
static tm_rates_args args;

static double *rec(int i) { return main_ + (ptrdiff_t) i * TM_REC; }

/* A block of side particles per edge at unit spacing but for noise; all have one density. */
static void make(int dimension, int side, double noise)
{
  const double h = 1.2, rho = 2.0;
  dim = dimension;
  n = 0;
  for (int a = 0; a < side; a++)
    for (int b = 0; b < side; b++)
      for (int c = 0; c < (dim == 3 ? side : 1); c++, n++) {
        const int at[3] = {a, b, c};
        for (int d = 0; d < 3; d++) {
          rec(n)[d] = d < dim ? at[d] + noise * ut_random(-1, 1) : 0.0;
          rec(n)[TM_REC_V + d] = d < dim ? ut_random(-1, 1) : 0.0;
        }
        rec(n)[TM_REC_M] = ut_random(1.9, 2.1);
        rec(n)[TM_REC_RHO] = rho;
        for (int k = 0; k < 6; k++) rec(n)[TM_REC_P + k] = dim == 3 || k == 0 || k == 1 || k == 3 ? ut_random(-1, 1) : 0;
        rec(n)[TM_REC_C] = ut_random(1, 2);
        tm_real *s = stab + n * TM_REC_STAB, *g = hourglass + n * TM_REC_HOURGLASS;
        for (int d = 0; d < 3; d++) g[d] = s[TM_STAB_W + d] = d < dim ? ut_random(-0.1, 0.1) : 0.0;
        g[TM_HOURGLASS_K] = s[TM_STAB_K] = ut_random(1, 3);
        s[TM_STAB_C] = rec(n)[TM_REC_C];
      }
  memset(&args, 0, sizeof args);
  args.rec.main = main_;
  args.rec.stab = stab;
  args.rec.hourglass = hourglass;
  args.h = h;
  args.support_radius2 = 4.0 * h * h;
  args.norm = tm_kernel_norm(TM_KERNEL_HYPERBOLIC, dim, h);
  args.slope_norm = args.norm / h;
  args.visc_alpha = 0.5;
  args.visc_beta = 1.0;
  args.force_unit = 0.5;
  args.correction = K;
  for (int i = 0; i < n; i++) {
    first[i] = (ptrdiff_t) i * ROOM;
    length[i] = 0;
    for (int j = 0; j < n; j++) {
      double r2 = 0;
      for (int d = 0; d < 3; d++) r2 += (rec(i)[d] - rec(j)[d]) * (rec(i)[d] - rec(j)[d]);
      if (j != i && r2 < 1.5 * args.support_radius2 && length[i] < ROOM) row[i * ROOM + length[i]++] = j;
    }
  }
  args.rows.index = row;
  args.rows.first = first;
  args.rows.mechanical = length;
  args.rows.stride = 1;
}

static void results_of(results *r)
{
  memset(r, 0, sizeof *r);
  args.force = r->force;
  args.gradient = r->gradient;
  args.artificial = r->artificial;
  args.hourglass_rate = r->rate;
  args.moment = r->moment;
}

/* Both ways; the effects are literals. */
static void run(void)
{
  const unsigned VISCOUS = TM_FX_VISCOSITY;
  for (int i = 0; i < n; i++) {
    if (dim == 3) tm_moment(i, &args, TM_FX_3D);
    else tm_moment(i, &args, 0u);
    for (int c = 0; c < 9; c++) PK[i * TM_REC_CORRECTION + c] = stab[i * TM_REC_STAB + TM_STAB_PK + c];
  }
  results_of(&one);
  args.rec.correction = NULL;
  args.effects = VISCOUS | TM_FX_ONE_PASS | TM_FX_CORRECTION | TM_FX_HOURGLASS;
  for (int i = 0; i < n; i++)
    if (dim == 3) tm_rates(i, &args, TM_FX_3D | TM_FX_VISCOSITY | TM_FX_ONE_PASS);
    else tm_rates(i, &args, TM_FX_VISCOSITY | TM_FX_ONE_PASS);
  results_of(&apart);
  args.rec.correction = PK;
  args.effects = VISCOUS | TM_FX_CORRECTION;
  for (int i = 0; i < n; i++) {
    if (dim == 3) tm_rates(i, &args, TM_FX_3D | TM_FX_VISCOSITY | TM_FX_EXTENDED);
    else tm_rates(i, &args, TM_FX_VISCOSITY | TM_FX_EXTENDED);
  }
  for (int i = 0; i < n; i++)
    if (dim == 3) tm_hourglass(i, &args, TM_FX_3D);
    else tm_hourglass(i, &args, 0u);
}

static void test_as_apart(void)
{
  for (int i = 0; i < n; i++) {
    for (int d = 0; d < 3; d++) UT_WITHIN(one.force[3 * i + d], apart.force[3 * i + d], 1e-12);
    for (int k = 0; k < 9; k++) UT_WITHIN(one.gradient[9 * i + k], apart.gradient[9 * i + k], 1e-12);
    UT_WITHIN(one.artificial[i], apart.artificial[i], 1e-12);
    for (int k = 0; k < 6; k++) UT_WITHIN(one.moment[TM_MOMENT_COLUMNS * i + k], K[6 * i + k], 1e-12);
  }
}

/* What says how a particle swings against one-sided neighbors: |K sum V_j gradW|. */
static void test_face(void)
{
  for (int i = 0; i < n; i++) {
    double s[3] = {0, 0, 0};
    for (int l = 0; l < length[i]; l++) {
      const double *ri = rec(i), *rj = rec(row[i * ROOM + l]);
      double r2 = 0;
      for (int d = 0; d < 3; d++) r2 += (ri[d] - rj[d]) * (ri[d] - rj[d]);
      const double g = args.slope_norm * tm_kernel_slope(TM_KERNEL_HYPERBOLIC, sqrt(r2) / args.h) / sqrt(r2);
      for (int d = 0; d < 3; d++) s[d] += rj[TM_REC_M] / ri[TM_REC_RHO] * g * (ri[d] - rj[d]);
    }
    const tm_vec3 want = tm_sym_mul_vec(tm_sym_load(K + 6 * i), tm_vec(s[0], s[1], s[2]));
    UT_WITHIN(one.moment[TM_MOMENT_COLUMNS * i + TM_MOMENT_FACE], tm_vec_norm(want), 1e-12);
  }
}

/* v_i minus the linear field through i with the gradient L, the mean over the neighbors with weights -m W'/r */
static void test_residual(void)
{
  for (int i = 0; i < n; i++) {
    double sum[3] = {0, 0, 0}, weights = 0;
    for (int l = 0; l < length[i]; l++) {
      const double *ri = rec(i), *rj = rec(row[i * ROOM + l]);
      double r2 = 0;
      for (int d = 0; d < 3; d++) r2 += (ri[d] - rj[d]) * (ri[d] - rj[d]);
      const double q = sqrt(r2) / args.h;
      if (q >= 2.0) continue;
      const double w = -rj[TM_REC_M] * tm_kernel_slope(TM_KERNEL_HYPERBOLIC, q) / sqrt(r2);
      weights += w;
      for (int d = 0; d < 3; d++) {
        double linear = 0;
        for (int e = 0; e < 3; e++) linear += one.gradient[9 * i + 3 * d + e] * (rj[e] - ri[e]);
        sum[d] += w * (rj[TM_REC_V + d] - ri[TM_REC_V + d] - linear);
      }
    }
    for (int d = 0; d < 3; d++) UT_WITHIN(one.rate[3 * i + d], -sum[d] / weights, 1e-12);
  }
}

/* Pair forces are opposite, and with the correction of these positions the stress of a particle makes no torque. */
static void test_momentum(void)
{
  double p[3] = {0, 0, 0}, l[3] = {0, 0, 0}, power = 0, received = 0;
  for (int i = 0; i < n; i++) {
    const double *x = rec(i), *f = one.force + 3 * i, rho = x[TM_REC_RHO];
    for (int d = 0; d < 3; d++) {
      p[d] += f[d];
      l[d] += x[(d + 1) % 3] * f[(d + 2) % 3] - x[(d + 2) % 3] * f[(d + 1) % 3];
      power += f[d] * x[TM_REC_V + d];
    }
    const tm_sym3 D = tm_mat_symmetric(tm_mat_load(one.gradient + 9 * i));
    received += x[TM_REC_M] * rho * tm_sym_ddot(tm_sym_load(x + TM_REC_P), D) + one.artificial[i];
  }
  for (int d = 0; d < 3; d++) {
    UT_WITHIN(p[d], 0, 1e-11);
    UT_WITHIN(l[d], 0, 1e-10);
  }
  UT_NEAR(power, -0.5 * received, 1e-10); /* force_unit */
}

/* A linear field, and so a rigid rotation: its gradient is exact, at faces and corners too, and nothing is off it. */
static void test_linear(void)
{
  double B[9] = {0}, a[3];
  for (int k = 0; k < 9; k++) B[k] = dim == 3 || (k / 3 < 2 && k % 3 < 2) ? ut_random(-1, 1) : 0.0;
  for (int k = 0; k < 3; k++) a[k] = k < dim ? ut_random(-5, 5) : 0.0;
  for (int i = 0; i < n; i++)
    for (int d = 0; d < dim; d++) {
      rec(i)[TM_REC_V + d] = a[d];
      for (int e = 0; e < dim; e++) rec(i)[TM_REC_V + d] += B[3 * d + e] * rec(i)[e];
    }
  run();
  for (int i = 0; i < n; i++) {
    for (int k = 0; k < 9; k++) UT_WITHIN(one.gradient[9 * i + k], B[k], 1e-11);
    for (int d = 0; d < 3; d++) UT_WITHIN(one.rate[3 * i + d], 0, 1e-11);
  }
}

/* What alternates is off by more than its amplitude, and no gradient sees it. */
static void test_alternating(void)
{
  const int side = 15, middle = side / 2 * side + side / 2;
  make(2, side, 0.0);
  for (int i = 0; i < n; i++) {
    rec(i)[TM_REC_M] = 2.0;
    rec(i)[TM_REC_V] = (i / side + i % side) % 2 ? 1.0 : -1.0;
    rec(i)[TM_REC_V + 1] = 0.0;
  }
  run();
  UT_TRUE(one.rate[3 * middle] * rec(middle)[TM_REC_V] > 1.0);
  for (int k = 0; k < 9; k++) UT_WITHIN(one.gradient[9 * middle + k], 0, 1e-12);
}

int main(void)
{
  UT_TRUE(tm_residual_velocity(0.0, tm_vec(1, 1, 1), tm_vec(1, 1, 1), tm_mat_identity()).x == 0.0);
  for (int d = 2; d <= 3; d++) {
    make(d, d == 2 ? 16 : 6, 0.15);
    run();
    test_as_apart();
    test_residual();
    test_face();
    test_momentum();
    test_linear();
  }
  test_alternating();
  return ut_summary();
}
