/* The rate pass with gradient correction and hourglass control in it: against the passes of their own, and what it makes
   for the next step against sums written out pair by pair. */
#include "tm_hourglass.h"
#include "tm_lattice.h"
#include "tm_moment.h"
#include "tm_rates.h"
#include "ut.h"

#include <string.h>

enum { MOST = 400, ROOM = 300 };

static int n, dim, faces, row[MOST * ROOM], length[MOST];
static ptrdiff_t first[MOST];
static tm_real TM_ALIGNED main_[MOST * TM_REC], stab[MOST * TM_REC_STAB], hourglass[MOST * TM_REC_HOURGLASS];
static tm_real PK[MOST * TM_REC_CORRECTION], K[6 * MOST], turn[3 * MOST], TM_ALIGNED heat[MOST * TM_REC_HEAT];
typedef struct {
  double force[3 * MOST], gradient[9 * MOST], artificial[MOST], rate[3 * MOST], moment[TM_MOMENT_COLUMNS * MOST],
      face[TM_FACE_COLUMNS * MOST], heat[MOST], xsph[3 * MOST], surface[3 * MOST];
} results;
static results one, apart;
static double uneven[3 * MOST];
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
        for (int k = 0; k < 6; k++)
          rec(n)[TM_REC_P + k] = dim == 3 || k == 0 || k == 1 || k == 3 ? ut_random(-1, 1) : 0;
        tm_real *s = stab + n * TM_REC_STAB, *g = hourglass + n * TM_REC_HOURGLASS;
        for (int d = 0; d < 3; d++) g[d] = s[TM_STAB_W + d] = d < dim ? ut_random(-0.1, 0.1) : 0.0;
        g[TM_HOURGLASS_K] = s[TM_STAB_K] = ut_random(1, 3);
        s[TM_STAB_C] = 0.5 * (rec(n)[TM_REC_C] = sqrt(s[TM_STAB_K] / rho));
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
  args.turn = turn;
  args.rec.faces = faces;
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
  args.uneven = uneven;
  args.face_next = r->face;
  args.heat = r->heat;
  args.xsph_v = r->xsph;
  args.surface = r->surface;
}

/* Particles at free faces and all others in calls of their own, as a GPU has them; effects and whose are literals. */
static void run_faces_apart(void)
{
  const tm_group alone = tm_group_alone();
  for (int i = 0; i < n; i++) {
    const double *b = stab + i * TM_REC_STAB + TM_STAB_FACE;
    const int at_face = b[0] != 0 || b[1] != 0 || (dim == 3 && b[2] != 0);
    if (dim == 3)
      tm_rates_of(i, alone, &args, TM_FX_3D | TM_FX_VISCOSITY | TM_FX_ONE_PASS | TM_FX_FACES, TM_RATES_INSIDE);
    else tm_rates_of(i, alone, &args, TM_FX_VISCOSITY | TM_FX_ONE_PASS | TM_FX_FACES, TM_RATES_INSIDE);
    if (!at_face) continue;
    if (dim == 3)
      tm_rates_of(i, alone, &args, TM_FX_3D | TM_FX_VISCOSITY | TM_FX_ONE_PASS | TM_FX_FACES, TM_RATES_AT_FACE);
    else tm_rates_of(i, alone, &args, TM_FX_VISCOSITY | TM_FX_ONE_PASS | TM_FX_FACES, TM_RATES_AT_FACE);
  }
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
  args.effects = VISCOUS | TM_FX_ONE_PASS | TM_FX_CORRECTION | TM_FX_HOURGLASS | (faces ? TM_FX_FACES : 0u);
  for (int i = 0; i < n; i++)
    if (faces && dim == 3) tm_rates(i, &args, TM_FX_3D | TM_FX_VISCOSITY | TM_FX_ONE_PASS | TM_FX_EXTENDED);
    else if (faces) tm_rates(i, &args, TM_FX_VISCOSITY | TM_FX_ONE_PASS | TM_FX_EXTENDED);
    else if (dim == 3) tm_rates(i, &args, TM_FX_3D | TM_FX_VISCOSITY | TM_FX_ONE_PASS);
    else tm_rates(i, &args, TM_FX_VISCOSITY | TM_FX_ONE_PASS);
  results_of(&apart);
  if (faces) {
    run_faces_apart();
    return;
  }
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

/* In calls of their own, to the bit. */
static void test_faces_apart(void)
{
  int at_face = 0;
  for (int i = 0; i < n; i++) at_face += stab[i * TM_REC_STAB + TM_STAB_FACE] != 0;
  UT_TRUE(at_face > n / 10 && at_face < n);
  UT_TRUE(!memcmp(&one, &apart, sizeof one));
}

/* The normal of a face from the sum of gradW, written out; K and L with it from sums over D as in tm_face.h. */
static void test_normal(void)
{
  int some = 0, inside = 0;
  for (int i = 0; i < n; i++) {
    const double *b = stab + i * TM_REC_STAB + TM_STAB_FACE, kappa = TM_FACE_TILT / args.h, *ri = rec(i);
    double sum[3] = {0, 0, 0}, M[9] = {0}, S[9] = {0}, trace = 0, got[9], product[9];
    for (int l = 0; l < length[i]; l++) {
      const double *rj = rec(row[i * ROOM + l]), b2 = b[0] * b[0] + b[1] * b[1] + b[2] * b[2] + 1e-30;
      double e[3], D[3], r2 = 0, s = 0;
      for (int d = 0; d < 3; d++) e[d] = rj[d] - ri[d], r2 += e[d] * e[d], s += b[d] * e[d];
      const double g = args.slope_norm * tm_kernel_slope(TM_KERNEL_HYPERBOLIC, sqrt(r2) / args.h) / sqrt(r2);
      const double w = -rj[TM_REC_M] / ri[TM_REC_RHO] * g;
      for (int d = 0; d < 3; d++) D[d] = (1 - kappa * s) * e[d] + kappa * s * s * b[d] / b2, sum[d] += w * e[d];
      trace += w * r2;
      for (int d = 0; d < 3; d++)
        for (int k = 0; k < 3; k++) {
          M[3 * d + k] += w * e[d] * D[k];
          S[3 * d + k] += w * (rj[TM_REC_V + d] - ri[TM_REC_V + d]) * D[k];
        }
    }
    for (int k = 0; k < 3; k++) UT_WITHIN(uneven[3 * i + k], sum[k], 1e-12);
    const tm_vec3 want = tm_face_normal(tm_vec(sum[0], sum[1], sum[2]), args.h, dim - trace);
    UT_WITHIN(b[0], want.x, 1e-12);
    UT_WITHIN(b[1], want.y, 1e-12);
    UT_WITHIN(b[2], want.z, 1e-12);
    const tm_mat3 k = tm_face_matrix(tm_sym_load(K + 6 * i), tm_load3(turn + 3 * i));
    tm_mat_store(got, tm_mat_mul(tm_mat_load(S), k));
    tm_mat_store(product, tm_mat_mul(tm_mat_load(M), k));
    for (int c = 0; c < 9; c++) {
      if (dim == 2 && (c / 3 == 2 || c % 3 == 2)) continue;
      UT_WITHIN(one.gradient[9 * i + c], got[c], 1e-11);
      UT_WITHIN(product[c], c % 4 == 0, 1e-11);
    }
    /* what the rate pass makes of the same positions for the next step */
    for (int c = 0; c < 6; c++) UT_WITHIN(one.moment[TM_MOMENT_COLUMNS * i + c], K[6 * i + c], 1e-11);
    for (int c = 0; c < 3; c++) {
      UT_WITHIN(one.face[TM_FACE_COLUMNS * i + TM_FACE_NORMAL + c], b[c], 1e-12);
      UT_WITHIN(one.face[TM_FACE_COLUMNS * i + TM_FACE_TURN + c], turn[3 * i + c], 1e-11);
    }
    some += want.x != 0;
    inside += want.x == 0;
  }
  UT_TRUE(inside > 0 && some > 0);
}

/* A field of second order, u_x = x y, beside a face across y: the derivative along the face is that of the place of the
   particle, and with plain corrected gradients that of a place a quarter of a spacing deeper. */
static void test_second_order(void)
{
  const int side = 12, middle = side / 2 * side; /* x = 6, y = 0 */
  for (faces = 0; faces < 2; faces++) {
    make(2, side, 0.0);
    args.slope_norm /= tm_lattice_gradient(TM_KERNEL_HYPERBOLIC, 2, 1.2);
    for (int i = 0; i < n; i++) {
      rec(i)[TM_REC_M] = 2.0;
      rec(i)[TM_REC_V] = rec(i)[0] * rec(i)[1];
      rec(i)[TM_REC_V + 1] = 0.0;
    }
    run();
    const double off = one.gradient[9 * middle] - rec(middle)[1];
    if (faces) UT_WITHIN(off, 0.0, 0.025);
    else UT_WITHIN(off, 0.26, 0.01);
    UT_WITHIN(one.gradient[9 * middle + 1], rec(middle)[0], 1e-12);
    UT_WITHIN(one.gradient[9 * (middle + 1)] - rec(middle + 1)[1], 0.0, 0.01);
  }
  faces = 0;
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

/* Balsara's switch and XSPH by the loop that has them as literals, as by the one that tests all effects at run time; the
   surface as one of the sums there anyway, as summed over pairs where the densities are one. */
static void test_switches(unsigned on)
{
  args.effects = TM_FX_VISCOSITY | TM_FX_ONE_PASS | TM_FX_CORRECTION | TM_FX_HOURGLASS | TM_FX_CONDUCTION | on;
  args.rec.heat = heat;
  args.xsph = 0.1;
  for (int i = 0; i < n; i++) {
    rec(i)[TM_REC_BALSARA] = (on & TM_FX_BALSARA) ? ut_random(0, 1) : 1.0;
    heat[i * TM_REC_HEAT + TM_REC_T] = ut_random(300, 900);
    heat[i * TM_REC_HEAT + TM_REC_K] = ut_random(10, 30);
  }
  results_of(&one);
  args.surface_of_pass = 1;
  for (int i = 0; i < n; i++)
    if (dim == 3 && on & TM_FX_XSPH)
      tm_rates(i, &args, TM_FX_3D | TM_FX_VISCOSITY | TM_FX_ONE_PASS | TM_FX_CONDUCTION | TM_FX_BALSARA | TM_FX_XSPH);
    else if (dim == 3)
      tm_rates(i, &args, TM_FX_3D | TM_FX_VISCOSITY | TM_FX_ONE_PASS | TM_FX_CONDUCTION | TM_FX_BALSARA);
    else if (on & TM_FX_XSPH)
      tm_rates(i, &args, TM_FX_VISCOSITY | TM_FX_ONE_PASS | TM_FX_CONDUCTION | TM_FX_BALSARA | TM_FX_XSPH);
    else tm_rates(i, &args, TM_FX_VISCOSITY | TM_FX_ONE_PASS | TM_FX_CONDUCTION | TM_FX_BALSARA);
  results_of(&apart);
  args.surface_of_pass = 0;
  args.effects |= TM_FX_SURFACE;
  for (int i = 0; i < n; i++)
    if (dim == 3) tm_rates(i, &args, TM_FX_3D | TM_FX_ONE_PASS | TM_FX_EXTENDED);
    else tm_rates(i, &args, TM_FX_ONE_PASS | TM_FX_EXTENDED);
  double largest[3] = {0, 0, 0};
  for (int i = 0; i < n; i++) {
    largest[0] = fmax(largest[0], fabs(apart.heat[i]));
    largest[1] = fmax(largest[1], fabs(apart.xsph[3 * i]));
    largest[2] = fmax(largest[2], fabs(apart.surface[3 * i]));
  }
  UT_TRUE(largest[0] > 0 && largest[2] > 0 && (largest[1] > 0) == !!(on & TM_FX_XSPH));
  const double *a = (const double *) &one, *b = (const double *) &apart;
  for (size_t k = 0; k < sizeof one / sizeof *a; k++) UT_WITHIN(a[k], b[k], 1e-12 * fmax(fabs(b[k]), 1.0));
}

int main(void)
{
  UT_TRUE(tm_residual_velocity(0.0, tm_vec(1, 1, 1), tm_vec(1, 1, 1), tm_mat_identity()).x == 0.0);
  for (int d = 2; d <= 3; d++) {
    for (faces = 0; faces < 2; faces++) {
      make(d, d == 2 ? 16 : 6, 0.15);
      run();
      if (faces) test_faces_apart();
      else test_as_apart();
      test_residual();
      if (faces) test_normal();
      test_momentum();
      test_linear();
    }
    faces = 0;
    make(d, d == 2 ? 16 : 6, 0.15);
    run();
    test_switches(TM_FX_BALSARA);
    test_switches(TM_FX_XSPH);
    test_switches(TM_FX_BALSARA | TM_FX_XSPH);
  }
  test_second_order();
  test_alternating();
  return ut_summary();
}
