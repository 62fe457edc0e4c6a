/* The rate pass in single against the one in double, on the random clouds of test_rates.c.

   Bound: with u = 2^-24, every factor of a pair's term is off by at most u per operation on its way, and
   a sum of n terms in at least four lanes by u (n/4 + 2) of the sum of their sizes. The size of a term
   is that of its parts before anything cancels (|v_i| + |v_j| for v_i - v_j), and |y| + |x y'| for a
   function y(x) of the distance, whose argument is rounded too. Operations on the longest way: 24. */
#define UT_MAIN rates_main
int rates_main(void);
#include "test_rates.c"

#include "single_rates.h"
#include "tm_single.h"

static float single_main[MOST * TM_REC], single_more[MOST * TM_MORE], single_correction[MOST * TM_REC_CORRECTION];
static rates size; /* of the terms */
static single_rates *in_single;

static void to_single(unsigned fx, double length)
{
  tm_single_args a;
  memset(&a, 0, sizeof(a));
  args.single.main = single_main;
  args.single.more = single_more;
  args.single.correction = single_correction;
  args.single.length = length;
  args.single.volume = pow(length, c.dim);
  args.single.position = (float) tm_single_position_unit(sqrt(args.support_radius2) + 0.3 * length, length);
  args.single.visc_alpha = (float) args.visc_alpha;
  args.single.visc_beta = (float) args.visc_beta;
  a.rec = args.rec;
  a.single = args.single;
  for (int i = 0; i < c.n; i++) tm_single(i, &a, fx);
}

/* the sums in double into want, in single into got */
static void run_both(int kernel, double h, unsigned fx, double length)
{
  run(kernel, h, fx, 1);
  want = got;
  to_single(fx, length);
  memset(got.force, 0, sizeof(got.force));
  args.rows.mechanical = c.length;
  in_single(kernel, c.dim == 3, c.n, &args);
}

static double apart(const double *a, const double *b, int k) { return fabs(a[k]) + fabs(b[k]); }

/* sizes of all terms of particle i */
static void sizes(int i, int kernel, double h, unsigned fx)
{
  const double reach = tm_kernel_support(kernel) * h, norm = tm_kernel_norm(kernel, c.dim, h), e = 1e-6;
  const double *a = rec(i), mi = a[TM_REC_M], rhoi = a[TM_REC_RHO];
  double force = 0, L = 0, heat = 0, art = 0, u = 0, s = 0;
  for (int k = 0; k < c.length[i]; k++) {
    const int j = c.row[i][k];
    const double *b = rec(j), r = sqrt(distance2(i, j)), q = r / h, mj = b[TM_REC_M], rhoj = b[TM_REC_RHO];
    if (r >= reach) continue;
    const double slope = fabs(tm_kernel_slope(kernel, q)), shape = tm_kernel_shape(kernel, q);
    const double bend = fabs(tm_kernel_slope(kernel, q + e) - tm_kernel_slope(kernel, q)) / e;
    const double g = 0.97 * norm / h * (slope + q * bend), W = norm * (shape + q * slope);
    const double f = shape * args.art_inv_w, n = args.art_n;
    const double weight = pow(f, n) + n * pow(f, n - 1) * q * slope * args.art_inv_w;
    double v = 0, P = 0, R = 0;
    for (int d = 0; d < 3; d++) v += apart(a + 4, b + 4, d);
    for (int d = 0; d < 6; d++) P += apart(a + TM_REC_P, b + TM_REC_P, d);
    if (fx & TM_FX_CORRECTION)
      for (int d = 0; d < 9; d++) P = (d ? P : 0) + apart(c.correction + 9 * i, c.correction + 9 * j, d);
    if (fx & TM_FX_FORM_F14) P /= rhoi * rhoj;
    for (int d = 0; d < 6; d++) R += apart(c.stress + 6 * i, c.stress + 6 * j, d);
    const double mu = h * v * r / (r * r + 0.01 * h * h);
    const double c_mean = 0.5 * apart(a, b, TM_REC_C), rho_mean = 0.5 * (rhoi + rhoj);
    const double Pi = (args.visc_alpha * c_mean + args.visc_beta * mu) * mu / rho_mean;
    const double extra = ((fx & TM_FX_ARTSTRESS) ? weight * R : 0) + ((fx & TM_FX_VISCOSITY) ? Pi : 0);
    force += mi * mj * g * (P + extra);
    L += mj / ((fx & TM_FX_FORM_F14) ? rhoj : rhoi) * v * g;
    art += 0.5 * mi * mj * g * extra * v;
    u += args.xsph * 2 * mj / (rhoi + rhoj) * v * W;
    s += mj / rhoj * g;
    const double *ti = c.heat + 2 * i, *tj = c.heat + 2 * j;
    heat += mj / rhoj * 4 * ti[1] * tj[1] / (ti[1] + tj[1]) * apart(ti, tj, 0) * g / r;
  }
  double K = 1; /* rows of K mix the columns of L */
  if (fx & TM_FX_CORRECTION)
    for (int d = 0; d < 6; d++) K += fabs(got.correction[6 * i + d]);
  for (int d = 0; d < 9; d++) size.gradient[9 * i + d] = K * L;
  for (int d = 0; d < 3; d++) {
    size.force[3 * i + d] = force;
    size.xsph[3 * i + d] = u;
    size.surface[3 * i + d] = s;
  }
  size.heat[i] = heat;
  size.artificial[i] = art;
}

/* largest |got - want| over bound, of n values per particle */
static double over(const double *a, const double *b, const double *s, int n)
{
  double worst = 0;
  for (int i = 0; i < c.n * n; i++) {
    const double bound = ldexp(26 + c.length[i / n] / 4.0, -24) * s[i], d = fabs(a[i] - b[i]);
    const double x = bound > 0 ? d / bound : d;
    if (!(x <= worst)) worst = x;
  }
  return worst;
}

static double worst_of(int kernel, double h, unsigned fx)
{
  memset(&size, 0, sizeof(size));
  for (int i = 0; i < c.n; i++) sizes(i, kernel, h, fx);
  double worst = fmax(over(got.force, want.force, size.force, 3), over(got.gradient, want.gradient, size.gradient, 9));
  if (fx & TM_FX_CONDUCTION) worst = fmax(worst, over(got.heat, want.heat, size.heat, 1));
  if (fx & TM_FX_XSPH) worst = fmax(worst, over(got.xsph, want.xsph, size.xsph, 3));
  if (fx & TM_FX_SURFACE) worst = fmax(worst, over(got.surface, want.surface, size.surface, 3));
  if (fx & (TM_FX_VISCOSITY | TM_FX_ARTSTRESS))
    worst = fmax(worst, over(got.artificial, want.artificial, size.artificial, 1));
  return worst;
}

static void move(double x, double y, double z)
{
  const double by[3] = {x, y, c.dim == 3 ? z : 0};
  for (int i = 0; i < c.n; i++)
    for (int k = 0; k < 3; k++) rec(i)[k] = c.x[i][k] += by[k];
}

/* both sides of a pair to the last bit */
static void opposite(int kernel, double h, unsigned fx)
{
  for (int k = 0; k < 50; k++) {
    lattice(c.dim, 2, 0.3, fx);
    c.n = 2;
    fill_rows(5, 0);
    run_both(kernel, h, fx, 1.0);
    for (int d = 0; d < 3; d++) UT_TRUE(got.force[d] + got.force[3 + d] == 0);
    if (fx & TM_FX_CONDUCTION) {
      const double v0 = rec(0)[TM_REC_M] / rec(0)[TM_REC_RHO], v1 = rec(1)[TM_REC_M] / rec(1)[TM_REC_RHO];
      UT_NEAR(v0 * got.heat[0], -v1 * got.heat[1], 4e-7); /* volumes are rounded */
    }
    if (fx & TM_FX_VISCOSITY) UT_TRUE(got.artificial[0] == got.artificial[1]);
  }
}

static void all_sets(void)
{
  double worst = 0, least_far = 1e300;
  for (int dim = 2; dim <= 3; dim++)
    for (int kernel = 0; kernel < TM_KERNEL_COUNT; kernel++) {
      const double h = kernel == TM_KERNEL_QUINTIC ? 1.0 : 1.3, reach = tm_kernel_support(kernel) * h;
      for (int k = 0; k < N_SETS; k++) {
        lattice(dim, dim == 3 ? 7 : 20, 0.25, SETS[k]);
        fill_rows(reach, 0.3);
        run_both(kernel, h, SETS[k], 0.9);
        worst = fmax(worst, worst_of(kernel, h, SETS[k]));
        if (kernel) continue;
        /* across the seam where whole numbers start over, and far away */
        const double seam = 0.9 * ldexp(args.single.position, 31) - 3;
        move(seam, -seam - 6, 3 * seam + 6);
        run_both(kernel, h, SETS[k], 0.9);
        worst = fmax(worst, worst_of(kernel, h, SETS[k]));
        move(1048576.0, -77777.0, 32768.0);
        run_both(kernel, h, SETS[k], 0.9);
        worst = fmax(worst, worst_of(kernel, h, SETS[k]));
        /* the same with positions in single there: beyond the bound */
        for (int i = 0; i < c.n; i++)
          for (int d = 0; d < 3; d++) rec(i)[d] = (float) rec(i)[d];
        to_single(SETS[k], 0.9);
        memset(got.force, 0, sizeof(got.force));
        in_single(kernel, c.dim == 3, c.n, &args);
        least_far = fmin(least_far, worst_of(kernel, h, SETS[k]));
      }
      for (int k = 0; k < N_SETS; k++)
        if (!(SETS[k] & TM_FX_FORM_F14)) opposite(kernel, h, SETS[k]);
    }
  printf("error over bound: %.3f; with positions in single %.0f\n", worst, least_far);
  UT_WITHIN(worst, 0, 1);
  UT_TRUE(worst > 0.01); /* the bound is not empty */
  UT_TRUE(least_far > 10);
}

/* every length of a row, whatever lies beyond the reach leaves no trace */
static void rows_in_single(void)
{
  const double h = 1.3;
  const unsigned fx = TM_FX_VISCOSITY | TM_FX_ARTSTRESS | TM_FX_CONDUCTION | TM_FX_XSPH;
  static rates all;
  for (int count = 0; count < 300; count += count < 40 ? 1 : 13)
    for (int beyond = 0; beyond <= 97; beyond += 97) {
      star(count, beyond, 2 * h, fx);
      run_both(TM_KERNEL_HYPERBOLIC, h, fx, 1.1);
      UT_WITHIN(worst_of(TM_KERNEL_HYPERBOLIC, h, fx), 0, 1);
      all = got;
      drop_beyond_reach();
      run_both(TM_KERNEL_HYPERBOLIC, h, fx, 1.1);
      UT_TRUE(!memcmp(all.force, got.force, sizeof(got.force)) && !memcmp(all.heat, got.heat, sizeof(got.heat)));
    }
}

/* units whose powers of a length single cannot hold */
static void small_lengths(void)
{
  const double scale = 1e-9, h = 1.3 * scale;
  const unsigned fx = TM_FX_VISCOSITY | TM_FX_ARTSTRESS | TM_FX_CONDUCTION | TM_FX_XSPH | TM_FX_SURFACE;
  lattice(3, 7, 0.25, fx);
  fill_rows(2.6, 0.3);
  for (int i = 0; i < c.n; i++) {
    for (int k = 0; k < 3; k++) rec(i)[k] = c.x[i][k] *= scale;
    rec(i)[TM_REC_M] *= scale * scale * scale;
  }
  run_both(TM_KERNEL_HYPERBOLIC, h, fx, scale);
  UT_WITHIN(worst_of(TM_KERNEL_HYPERBOLIC, h, fx), 0, 1);
}

int main(void)
{
  rows = (int *) calloc((size_t) MOST * ROOM * 3 + 8, sizeof(int));
  if (!rows) return 1;
  static const struct {
    const char *name;
    single_rates *loop;
  } isa[] = {{"default", single_rates_default}, {"avx2", single_rates_avx2}, {"avx512", single_rates_avx512}};
  for (int k = 0; k < 3; k++) {
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
    if (k == 1 && !(__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))) continue;
    if (k == 2 && !(__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                    __builtin_cpu_supports("avx512vl")))
      continue;
#endif
    printf("%s: ", isa[k].name);
    in_single = isa[k].loop;
    all_sets();
    rows_in_single();
    small_lengths();
  }
  free(rows);
  return ut_summary();
}
