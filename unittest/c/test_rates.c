/* The rate pass on random clouds: against sums written out pair by pair, and what must hold whatever
   the numbers are (momentum, power, heat, linear fields, the order of a row). Also compiled for
   AVX2 and AVX-512, see test_rates_avx2.c. */
#include "tm_moment.h"
#include "tm_rates.h"
#include "tm_state.h"
#include "ut.h"

#include <stdlib.h>
#include <string.h>

#ifndef UT_MAIN
#define UT_MAIN main
#endif
#ifndef UT_NEEDS
#define UT_NEEDS 1
#endif

enum { MOST = 700, ROOM = 400 };  /* particles, entries of a row */

typedef struct {
  int n, dim;
  int row[MOST][ROOM], length[MOST];
  double x[MOST][3];
  tm_real main[MOST * TM_REC], stress[MOST * TM_REC_STRESS], heat[MOST * TM_REC_HEAT];
  tm_real correction[MOST * TM_REC_CORRECTION];
} cloud;

typedef struct {
  double force[MOST * 3], gradient[MOST * 9], heat[MOST], correction[MOST * 6], xsph[MOST * 3];
  double surface[MOST * 3], artificial[MOST];
} rates;

static cloud c;
static rates got, want;
static tm_rates_args args;
static int *rows;               /* as the rate pass wants them */
static ptrdiff_t first[MOST];

static double *rec(int i) { return c.main + (ptrdiff_t) i * TM_REC; }

/* --- a cloud --------------------------------------------------------------------------------- */

static void fill_records(int i, unsigned fx)
{
  double *r = rec(i);
  for (int k = 0; k < 3; k++) {
    r[k] = c.x[i][k];
    r[4 + k] = k < c.dim ? ut_random(-30, 30) : 0.0;
  }
  r[TM_REC_M] = ut_random(0.5, 2.0);
  r[TM_REC_RHO] = ut_random(0.7, 1.4);
  for (int k = 0; k < 6; k++) {
    const int in_plane = k < 2 || k == 3 || c.dim == 3;
    r[TM_REC_P + k] = in_plane ? ut_random(-100, 100) : 0.0;
    c.stress[i * TM_REC_STRESS + k] = in_plane ? ut_random(-30, 0) : 0.0;
  }
  r[TM_REC_C] = ut_random(40, 60);
  r[TM_REC_BALSARA] = (fx & TM_FX_BALSARA) ? ut_random(0, 1) : 1.0;
  c.heat[i * TM_REC_HEAT + TM_REC_T] = ut_random(300, 900);
  c.heat[i * TM_REC_HEAT + TM_REC_K] = ut_random(1, 40);
}

static double distance2(int i, int j)
{
  double sum = 0;
  for (int k = 0; k < c.dim; k++) sum += (c.x[i][k] - c.x[j][k]) * (c.x[i][k] - c.x[j][k]);
  return sum;
}

/* rows with neighbours up to `skin` beyond the reach, in order of number */
static void fill_rows(double reach, double skin)
{
  for (int i = 0; i < c.n; i++) {
    c.length[i] = 0;
    for (int j = 0; j < c.n; j++)
      if (j != i && distance2(i, j) < (reach + skin) * (reach + skin) && c.length[i] < ROOM)
        c.row[i][c.length[i]++] = j;
  }
}

static void lattice(int dim, int side, double noise, unsigned fx)
{
  c.dim = dim;
  c.n = 0;
  for (int a = 0; a < side; a++)
    for (int b = 0; b < side; b++)
      for (int d = 0; d < (dim == 3 ? side : 1); d++, c.n++) {
        const int at[3] = {a, b, d};
        for (int k = 0; k < 3; k++)
          c.x[c.n][k] = k < dim ? at[k] + noise * ut_random(-1, 1) : 0.0;
        fill_records(c.n, fx);
      }
}

/* --- the rate pass --------------------------------------------------------------------------- */

static void set_args(int kernel, double h, unsigned fx)
{
  memset(&args, 0, sizeof(args));
  args.rec.main = c.main;
  args.rec.stress = c.stress;
  args.rec.heat = c.heat;
  args.rec.correction = c.correction;
  args.effects = fx;
  args.h = h;
  args.support_radius2 = tm_kernel_support(kernel) * h * tm_kernel_support(kernel) * h;
  args.norm = tm_kernel_norm(kernel, c.dim, h);
  args.slope_norm = 0.97 * args.norm / h;
  args.visc_alpha = 0.7;
  args.visc_beta = 1.3;
  args.art_n = 3;
  args.art_inv_w = 1.0 / tm_kernel_shape(kernel, 1.0 / h);
  args.xsph = 0.4;
  args.force_unit = 1.0;
  args.force = got.force;
  args.gradient = got.gradient;
  args.heat = got.heat;
  args.correction = got.correction;
  args.xsph_v = got.xsph;
  args.surface = got.surface;
  args.artificial = got.artificial;
}

#define RUN(KERNEL)                                                                             \
  case TM_KERNEL_##KERNEL:                                                                      \
    for (int i = 0; i < c.n && (fx & TM_FX_CORRECTION); i++) {                                  \
      const unsigned k = (unsigned) TM_KERNEL_##KERNEL << TM_FX_KERNEL_SHIFT;                   \
      if (c.dim == 3) tm_moment(i, &args, k | (unsigned) TM_FX_3D);                             \
      else tm_moment(i, &args, k);                                                              \
    }                                                                                           \
    for (int i = 0; i < c.n; i++) {                                                             \
      const unsigned k = (unsigned) TM_KERNEL_##KERNEL << TM_FX_KERNEL_SHIFT;                   \
      if (c.dim == 3) tm_rates(i, &args, k | (unsigned) TM_FX_3D | (unsigned) TM_FX_EXTENDED);  \
      else tm_rates(i, &args, k | (unsigned) TM_FX_EXTENDED);                                   \
    }                                                                                           \
    break

static void run(int kernel, double h, unsigned fx, int stride)
{
  int mechanical[MOST];
  ptrdiff_t at = 0;
  for (int i = 0; i < c.n; i++) {
    first[i] = at;
    mechanical[i] = c.length[i];
    for (int k = 0; k < c.length[i]; k++) rows[at + k * stride] = c.row[i][k];
    at += c.length[i] * stride;
  }
  memset(&got, 0, sizeof(got));
  set_args(kernel, h, fx);
  args.rows.index = rows;
  args.rows.first = first;
  args.rows.mechanical = mechanical;
  args.rows.stride = stride;
  switch (kernel) {
    RUN(HYPERBOLIC);
    RUN(CUBIC);
    RUN(QUINTIC);
    RUN(WENDLAND_C2);
    RUN(WENDLAND_C4);
  }
}

/* --- the same sums, as the papers print them ------------------------------------------------- */

/* K of all particles, and P K */
static double PK[MOST][9];
static int loose; /* particles whose K is reduced */
static void reference_correction(int kernel, double h)
{
  const double reach = tm_kernel_support(kernel) * h, norm = tm_kernel_norm(kernel, c.dim, h);
  for (int i = 0; i < c.n; i++) {
    long double M[6] = {0}, S[3] = {0};
    for (int e = 0; e < c.length[i]; e++) {
      const int j = c.row[i][e];
      const double r = sqrt(distance2(i, j));
      if (r >= reach) continue;
      const long double g = -0.97 * norm / h * tm_kernel_slope(kernel, r / h) / r * rec(j)[TM_REC_M]
                          / rec(i)[TM_REC_RHO];
      const double d[3] = {c.x[i][0] - c.x[j][0], c.x[i][1] - c.x[j][1], c.x[i][2] - c.x[j][2]};
      static const int a[] = {0, 1, 2, 0, 0, 1}, b[] = {0, 1, 2, 1, 2, 2};
      for (int k = 0; k < 6; k++) M[k] += g * d[a[k]] * d[b[k]];
      for (int k = 0; k < 3; k++) S[k] += g * d[k];
    }
    tm_sym3 K = tm_sym_inverse_bounded(tm_sym((double) M[0], (double) M[1], (double) M[2],
        (double) M[3], (double) M[4], (double) M[5]), c.dim == 3, TM_MOMENT_LOW);
    /* a particle that hangs loose */
    const double face = h * tm_vec_norm(tm_sym_mul_vec(K, tm_vec((double) S[0], (double) S[1], (double) S[2])));
    if (face > 1.9) K = tm_sym_scale(1.9 / face, K);
    loose += face > 1.9;
    tm_sym_store(want.correction + 6 * i, K);
    tm_mat_store(PK[i], tm_sym_mul(tm_sym_load(rec(i) + TM_REC_P), K));
  }
}

static void reference(int kernel, double h, unsigned fx)
{
  memset(&want, 0, sizeof(want));
  if (fx & TM_FX_CORRECTION) reference_correction(kernel, h);
  const double reach = tm_kernel_support(kernel) * h, norm = tm_kernel_norm(kernel, c.dim, h);
  for (int i = 0; i < c.n; i++) {
    const double *a = rec(i);
    long double f[3] = {0}, L[9] = {0}, u[3] = {0}, s[3] = {0}, heat = 0, art = 0;
    for (int e = 0; e < c.length[i]; e++) {
      const int j = c.row[i][e];
      const double *b = rec(j), r2 = distance2(i, j), r = sqrt(r2), q = r / h;
      if (r >= reach) continue;
      const double mj = b[TM_REC_M], rhoi = a[TM_REC_RHO], rhoj = b[TM_REC_RHO];
      const double W = norm * tm_kernel_shape(kernel, q), dW = 0.97 * norm / h * tm_kernel_slope(kernel, q);
      long double d[3], v[3], g[3], acc[3] = {0}, extra[3] = {0}, vx = 0;
      for (int k = 0; k < 3; k++) {
        d[k] = a[k] - b[k];
        v[k] = a[4 + k] - b[4 + k];
        g[k] = dW * d[k] / r;
        vx += v[k] * d[k];
      }
      const long double per = (fx & TM_FX_FORM_F14) ? mj / rhoj : mj / rhoi;
      const tm_sym3 Pi = tm_sym_load(a + TM_REC_P), Pj = tm_sym_load(b + TM_REC_P);
      const tm_sym3 Ri = tm_sym_load(c.stress + i * TM_REC_STRESS);
      const tm_sym3 Rj = tm_sym_load(c.stress + j * TM_REC_STRESS);
      const tm_sym3 P = tm_sym_axpy(Pi, 1, Pj), R = tm_sym_axpy(Ri, 1, Rj);
      const double p[9] = {P.xx, P.xy, P.xz, P.xy, P.yy, P.yz, P.xz, P.yz, P.zz};
      const double q9[9] = {R.xx, R.xy, R.xz, R.xy, R.yy, R.yz, R.xz, R.yz, R.zz};
      const double weight = pow(tm_kernel_shape(kernel, q) * args.art_inv_w, args.art_n);
      double Pi_ij = 0;
      if ((fx & TM_FX_VISCOSITY) && vx < 0) {
        const double mu = h * (double) vx / (r2 + 0.01 * h * h);
        Pi_ij = (-args.visc_alpha * 0.5 * (a[TM_REC_C] + b[TM_REC_C]) * mu + args.visc_beta * mu * mu)
              / (0.5 * (rhoi + rhoj)) * 0.5 * (a[TM_REC_BALSARA] + b[TM_REC_BALSARA]);
      }
      for (int k = 0; k < 3; k++) {
        for (int l = 0; l < 3; l++) {
          long double t = p[3 * k + l];
          if (fx & TM_FX_CORRECTION)
            t = PK[i][3 * k + l] + PK[j][3 * k + l];
          if (fx & TM_FX_FORM_F14) t /= rhoi * rhoj;
          acc[k] += t * g[l];
          if (fx & TM_FX_ARTSTRESS) extra[k] += weight * q9[3 * k + l] * g[l];
          L[3 * k + l] -= per * v[k] * g[l];
        }
        extra[k] -= Pi_ij * g[k];
        f[k] += mj * (acc[k] + extra[k]);
        art -= mj * extra[k] * v[k];
        u[k] -= 2 * mj / (rhoi + rhoj) * v[k] * W;
        s[k] += mj / rhoj * g[k];
      }
      const double *ti = c.heat + i * TM_REC_HEAT, *tj = c.heat + j * TM_REC_HEAT;
      heat += mj / rhoj * 4 * ti[1] * tj[1] / (ti[1] + tj[1]) * (ti[0] - tj[0]) * dW / r;
    }
    for (int k = 0; k < 3; k++) {
      want.force[3 * i + k] = (double) (a[TM_REC_M] * f[k]);
      want.xsph[3 * i + k] = (double) (args.xsph * u[k]);
      want.surface[3 * i + k] = (double) s[k];
    }
    const tm_sym3 K = tm_sym_load(want.correction + 6 * i);
    for (int k = 0; k < 9; k += 3) {
      const tm_vec3 raw = tm_vec((double) L[k], (double) L[k + 1], (double) L[k + 2]);
      const tm_vec3 l = (fx & TM_FX_CORRECTION) ? tm_sym_mul_vec(K, raw) : raw;
      want.gradient[9 * i + k] = l.x;
      want.gradient[9 * i + k + 1] = l.y;
      want.gradient[9 * i + k + 2] = l.z;
    }
    want.heat[i] = (double) heat;
    want.artificial[i] = (double) (0.5 * a[TM_REC_M] * art);
  }
}

/* largest difference over largest value */
static double off(const double *a, const double *b, int n)
{
  double d = 0, top = 1e-300;
  for (int i = 0; i < n; i++) {
    if (!(fabs(a[i] - b[i]) <= d)) d = fabs(a[i] - b[i]);
    if (fabs(b[i]) > top) top = fabs(b[i]);
  }
  return d / top;
}

static void compare(unsigned fx)
{
  UT_WITHIN(off(got.force, want.force, 3 * c.n), 0, 1e-13);
  UT_WITHIN(off(got.gradient, want.gradient, 9 * c.n), 0, 1e-13);
  if (fx & TM_FX_CORRECTION) UT_WITHIN(off(got.correction, want.correction, 6 * c.n), 0, 1e-12);
  if (fx & TM_FX_CONDUCTION) UT_WITHIN(off(got.heat, want.heat, c.n), 0, 1e-13);
  if (fx & TM_FX_XSPH) UT_WITHIN(off(got.xsph, want.xsph, 3 * c.n), 0, 1e-13);
  if (fx & TM_FX_SURFACE) UT_WITHIN(off(got.surface, want.surface, 3 * c.n), 0, 1e-13);
  if (fx & (TM_FX_VISCOSITY | TM_FX_ARTSTRESS))
    UT_WITHIN(off(got.artificial, want.artificial, c.n), 0, 1e-13);
}

/* --- what must hold -------------------------------------------------------------------------- */

static double dot3(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/* power of the pair forces + sum V sigma : L + artificial heating = 0, sigma = rho^2 P or P */
static void balances(unsigned fx)
{
  double sum[3] = {0}, size = 0, power = 0, stress = 0, artificial = 0, scale = 0, heat = 0, top = 0;
  for (int i = 0; i < c.n; i++) {
    const double *r = rec(i), volume = r[TM_REC_M] / r[TM_REC_RHO];
    for (int k = 0; k < 3; k++) {
      sum[k] += got.force[3 * i + k];
      size += fabs(got.force[3 * i + k]);
    }
    const tm_mat3 L = tm_mat_load(got.gradient + 9 * i);
    const double rho2 = (fx & TM_FX_FORM_F14) ? 1.0 : r[TM_REC_RHO] * r[TM_REC_RHO];
    const double one = dot3(got.force + 3 * i, r + 4);
    power += one;
    scale += fabs(one);
    stress += volume * rho2 * tm_sym_ddot(tm_sym_load(r + TM_REC_P), tm_mat_symmetric(L));
    if (fx & (TM_FX_VISCOSITY | TM_FX_ARTSTRESS)) artificial += got.artificial[i];
    heat += volume * got.heat[i];
    top += fabs(volume * got.heat[i]);
  }
  for (int k = 0; k < 3; k++) UT_WITHIN(sum[k] / size, 0, 1e-15 * sqrt(c.n));
  UT_WITHIN((power + stress + artificial) / scale, 0, 1e-12);
  if (fx & TM_FX_CONDUCTION) UT_WITHIN(heat / top, 0, 1e-14);
}

/* v = A x gives L = A also at the rim, and stress no torque: sum x_i (x) f_i = -sum V sigma */
static void linear_field(int kernel, double h)
{
  double A[9];
  for (int k = 0; k < 9; k++) A[k] = c.dim == 3 || (k % 3 < 2 && k / 3 < 2) ? ut_random(-2, 2) : 0.0;
  lattice(c.dim, c.dim == 3 ? 7 : 20, 0.1, TM_FX_CORRECTION);
  fill_rows(tm_kernel_support(kernel) * h, 0.3);
  for (int i = 0; i < c.n; i++) {
    rec(i)[TM_REC_M] = 1.2;  /* no moment so small that it is bounded */
    for (int k = 0; k < 3; k++) rec(i)[4 + k] = dot3(A + 3 * k, c.x[i]);
  }
  run(kernel, h, TM_FX_CORRECTION, 1);
  double worst = 0, sum[9] = {0}, size = 0;
  for (int i = 0; i < c.n; i++) {
    const double *r = rec(i), volume = r[TM_REC_M] / r[TM_REC_RHO];
    const tm_sym3 P = tm_sym_load(r + TM_REC_P);
    const double p[9] = {P.xx, P.xy, P.xz, P.xy, P.yy, P.yz, P.xz, P.yz, P.zz};
    for (int k = 0; k < 9; k++) {
      worst = fmax(worst, fabs(got.gradient[9 * i + k] - A[k]));
      const double one = volume * r[TM_REC_RHO] * r[TM_REC_RHO] * p[k];
      if (k / 3 < c.dim && k % 3 < c.dim) sum[k] += c.x[i][k % 3] * got.force[3 * i + k / 3] + one;
      size += fabs(one);
    }
  }
  UT_WITHIN(worst, 0, 1e-11);
  for (int k = 0; k < 9; k++) UT_WITHIN(sum[k] / size, 0, 1e-13);
}

/* --- rows ------------------------------------------------------------------------------------ */

/* particle 0 with `count` neighbours within reach and `far` beyond, shuffled */
static void star(int count, int beyond, double reach, unsigned fx)
{
  c.dim = 3;
  c.n = 1 + count + beyond;
  for (int i = 0; i < c.n; i++) {
    const double r = i == 0 ? 0.0 : i <= count ? ut_random(0.2, 0.999) * reach
                                               : ut_random(1.0, 1.2) * reach;
    const double z = ut_random(-1, 1), phi = ut_random(0, 6.2831853);
    c.x[i][0] = r * sqrt(1 - z * z) * cos(phi);
    c.x[i][1] = r * sqrt(1 - z * z) * sin(phi);
    c.x[i][2] = r * z;
    fill_records(i, fx);
    c.length[i] = 0;
  }
  c.length[0] = c.n - 1;
  for (int k = 0; k < c.n - 1; k++) c.row[0][k] = k + 1;
  for (int k = c.n - 2; k > 0; k--) {
    const int l = (int) ut_random(0, k + 1), t = c.row[0][k];
    c.row[0][k] = c.row[0][l];
    c.row[0][l] = t;
  }
}

/* from the row of particle 0 */
static void drop_beyond_reach(void)
{
  int n = 0;
  for (int e = 0; e < c.length[0]; e++)
    if (distance2(0, c.row[0][e]) < args.support_radius2) c.row[0][n++] = c.row[0][e];
  c.length[0] = n;
}

static void row_lengths(void)
{
  static const int counts[] = {0,  1,  2,  3,  7,   8,   9,   15,  16,  17,  31,  55,  56, 57,
                               88, 89, 95, 96, 97, 103, 104, 105, 191, 192, 193, 208, 300};
  const double h = 1.3, reach = 2 * h;
  const unsigned fx = TM_FX_VISCOSITY | TM_FX_ARTSTRESS | TM_FX_CONDUCTION | TM_FX_CORRECTION | TM_FX_XSPH;
  static rates all;
  for (size_t k = 0; k < sizeof(counts) / sizeof(counts[0]); k++)
    for (int beyond = 0; beyond <= 97; beyond += beyond == 0 ? 1 : 48) {
      star(counts[k], beyond, reach, fx);
      run(TM_KERNEL_CUBIC, h, fx, 1);
      reference(TM_KERNEL_CUBIC, h, fx);
      compare(fx);
      all = got;
      run(TM_KERNEL_CUBIC, h, fx, 3);
      UT_TRUE(!memcmp(&all, &got, sizeof(all)));
      /* neighbours out of reach leave no trace, not even in the last bit */
      drop_beyond_reach();
      UT_TRUE(c.length[0] == counts[k]);
      run(TM_KERNEL_CUBIC, h, fx, 1);
      UT_TRUE(!memcmp(&all, &got, sizeof(all)));
    }
}

/* Pairs that came together: what they conduct is bounded, and what leaves one arrives at the other. */
static void clumps(int dim, int kernel)
{
  const unsigned fx = TM_FX_VISCOSITY | TM_FX_CONDUCTION;
  const double h = kernel == TM_KERNEL_QUINTIC ? 1.0 : 1.3;
  lattice(dim, dim == 3 ? 7 : 20, 0.25, fx);
  double most = 0;
  for (int i = 0; i + 1 < c.n; i += 10) {
    c.x[i + 1][0] = c.x[i][0] + pow(10, ut_random(-6, -1));
    for (int k = 1; k < dim; k++) c.x[i + 1][k] = c.x[i][k];
    for (int k = 0; k < dim; k++) rec(i + 1)[k] = c.x[i + 1][k];
  }
  fill_rows(tm_kernel_support(kernel) * h, 0.3);
  run(kernel, h, fx, 1);
  reference(kernel, h, fx);
  UT_WITHIN(off(got.heat, want.heat, c.n), 0, 1e-9);    /* r is a difference of positions: 1e-16/r */
  double heat = 0;
  for (int i = 0; i < c.n; i++) {
    const double *r = rec(i), one = r[TM_REC_M] / r[TM_REC_RHO] * got.heat[i];
    heat += one;
    most = fmax(most, fabs(one));
  }
  UT_WITHIN(heat / (most * c.n), 0, 1e-14);
  UT_TRUE(most < 2e6);    /* W'/r of 1e-6: 1e10 */
}

#define ARTIFICIAL (TM_FX_VISCOSITY | TM_FX_ARTSTRESS)
static const unsigned SETS[] = {
    0, ARTIFICIAL, TM_FX_FORM_F14, TM_FX_CORRECTION, TM_FX_FORM_F14 | ARTIFICIAL | TM_FX_BALSARA,
    TM_FX_CORRECTION | ARTIFICIAL | TM_FX_BALSARA | TM_FX_CONDUCTION | TM_FX_XSPH | TM_FX_SURFACE,
    TM_FX_FORM_F14 | ARTIFICIAL | TM_FX_CONDUCTION | TM_FX_XSPH | TM_FX_SURFACE};
enum { N_SETS = sizeof(SETS) / sizeof(SETS[0]) };

/* the literal instantiations agree with the extended one */
static void literal_effects(void)
{
  static rates all;
  const unsigned sets[] = {0, TM_FX_VISCOSITY, TM_FX_ARTSTRESS, TM_FX_CONDUCTION,
                           TM_FX_VISCOSITY | TM_FX_ARTSTRESS | TM_FX_CONDUCTION};
  lattice(3, 7, 0.2, 0);
  fill_rows(2.4, 0.2);
#define LITERAL(K, FX)                                                                          \
  case K:                                                                                       \
    for (int i = 0; i < c.n; i++)                                                               \
      tm_rates(i, &args, (unsigned) (FX) | (unsigned) TM_FX_3D |                                \
                             ((unsigned) TM_KERNEL_HYPERBOLIC << TM_FX_KERNEL_SHIFT));          \
    break
  for (int k = 0; k < 5; k++) {
    run(TM_KERNEL_HYPERBOLIC, 1.2, sets[k], 1);
    all = got;
    memset(&got, 0, sizeof(got));
    switch (k) {
      LITERAL(0, 0);
      LITERAL(1, TM_FX_VISCOSITY);
      LITERAL(2, TM_FX_ARTSTRESS);
      LITERAL(3, TM_FX_CONDUCTION);
      LITERAL(4, TM_FX_VISCOSITY | TM_FX_ARTSTRESS | TM_FX_CONDUCTION);
    }
    UT_WITHIN(off(got.force, all.force, 3 * c.n), 0, 1e-14);
    UT_WITHIN(off(got.gradient, all.gradient, 9 * c.n), 0, 1e-14);
    UT_WITHIN(off(got.heat, all.heat, c.n), 0, 1e-14);
    UT_WITHIN(off(got.artificial, all.artificial, c.n), 0, 1e-14);
  }
}

int UT_MAIN(void)
{
  if (!(UT_NEEDS)) {
    printf("skipped: not a processor for this\n");
    return 77;
  }
  printf("%d lanes\n", TM_LANES);
  rows = (int *) calloc((size_t) MOST * ROOM * 3 + 8, sizeof(int));
  if (!rows) return 1;
  for (int dim = 2; dim <= 3; dim++)
    for (int kernel = 0; kernel < TM_KERNEL_COUNT; kernel++) {
      const double h = kernel == TM_KERNEL_QUINTIC ? 1.0 : 1.3, reach = tm_kernel_support(kernel) * h;
      for (int k = 0; k < N_SETS; k++) {
        lattice(dim, dim == 3 ? 7 : 20, 0.25, SETS[k]);
        fill_rows(reach, 0.3);
        run(kernel, h, SETS[k], 1);
        reference(kernel, h, SETS[k]);
        compare(SETS[k]);
        balances(SETS[k]);
      }
      linear_field(kernel, h);
      clumps(dim, kernel);
    }
  row_lengths();
  literal_effects();
  free(rows);
  UT_TRUE(loose > 0);
  return ut_summary();
}
