/* Eigenvalues, tensile part and guarded inverse, on random and degenerate tensors. */
#include "tm_eigen.h"
#include "ut.h"

static tm_sym3 random_sym(double size)
{
  return tm_sym(ut_random(-size, size), ut_random(-size, size), ut_random(-size, size),
                ut_random(-size, size), ut_random(-size, size), ut_random(-size, size));
}
/* Q diag(a,b,c) Q^T with a random rotation Q */
static tm_sym3 with_eigenvalues(double a, double b, double c)
{
  const tm_eigen e = tm_sym_eigen(random_sym(1));
  tm_sym3 s = tm_sym(0, 0, 0, 0, 0, 0);
  s = tm_sym_add_dyad(s, a, e.vector[0]);
  s = tm_sym_add_dyad(s, b, e.vector[1]);
  return tm_sym_add_dyad(s, c, e.vector[2]);
}
static double distance(tm_sym3 a, tm_sym3 b)
{
  const tm_sym3 d = tm_sym_axpy(a, -1, b);
  return sqrt(tm_sym_ddot(d, d));
}

/* A v = lambda v, vectors orthonormal, A recomposed */
static void check(tm_sym3 a, double size)
{
  const tm_eigen e = tm_sym_eigen(a);
  tm_sym3 sum = tm_sym(0, 0, 0, 0, 0, 0);
  for (int i = 0; i < 3; i++) {
    const tm_vec3 v = e.vector[i];
    const tm_vec3 r = tm_vec_axpy(tm_sym_mul_vec(a, v), -e.value[i], v);
    UT_WITHIN(tm_vec_norm(r), 0, 1e-14 * size);
    for (int j = 0; j <= i; j++) UT_WITHIN(tm_vec_dot(v, e.vector[j]), i == j, 1e-14);
    sum = tm_sym_add_dyad(sum, e.value[i], v);
  }
  UT_WITHIN(distance(sum, a), 0, 1e-14 * size);
}

static tm_sym3 positive_part_by_vectors(tm_sym3 a)
{
  const tm_eigen e = tm_sym_eigen(a);
  tm_sym3 p = tm_sym(0, 0, 0, 0, 0, 0);
  for (int k = 0; k < 3; k++) p = tm_sym_add_dyad(p, tm_max(e.value[k], 0), e.vector[k]);
  return p;
}

/* P >= 0, P - A >= 0, and P (P - A) = 0 hold for the positive part and for nothing else */
static void check_positive_part(tm_sym3 a, double size)
{
  const tm_sym3 p = tm_sym_positive_part(a), n = tm_sym_axpy(p, -1, a);
  const tm_eigen ep = tm_sym_eigen(p), en = tm_sym_eigen(n);
  for (int k = 0; k < 3; k++) {
    UT_TRUE(ep.value[k] >= -2e-14 * size);
    UT_TRUE(en.value[k] >= -2e-14 * size);
  }
  UT_WITHIN(tm_sym_ddot(p, n), 0, 1e-13 * size * size);
  UT_WITHIN(distance(p, positive_part_by_vectors(a)), 0, 2e-14 * size);
}

/* a K = 1 where no eigenvalue is below low; those below count as low, and nothing jumps there */
static void check_inverse(int dim3, double low)
{
  tm_sym3 a = with_eigenvalues(pow(10, ut_random(-1, 1)), pow(10, ut_random(-1, 1)),
                               pow(10, ut_random(-1, 1)));
  if (!dim3) {
    const double p = ut_random(0, 7), l1 = pow(10, ut_random(-1, 1)), l2 = pow(10, ut_random(-1, 1));
    a = tm_sym_add_dyad(tm_sym(0, 0, 7, 0, 5, 6), l1, tm_vec(cos(p), sin(p), 0));
    a = tm_sym_add_dyad(a, l2, tm_vec(-sin(p), cos(p), 0));
  }
  const tm_sym3 k = tm_sym_inverse_bounded(a, dim3, low);
  if (!dim3) {
    UT_TRUE(k.zz == 1 && k.xz == 0 && k.yz == 0);
    a.zz = 1;
    a.xz = a.yz = 0;
  }
  tm_eigen e = tm_sym_eigen(a);
  tm_sym3 b = tm_sym(0, 0, 0, 0, 0, 0);
  for (int n = 0; n < 3; n++) b = tm_sym_add_dyad(b, tm_max(e.value[n], low), e.vector[n]);
  const tm_mat3 c = tm_sym_mul(b, k);
  const tm_real v[9] = {c.xx - 1, c.xy, c.xz, c.yx, c.yy - 1, c.yz, c.zx, c.zy, c.zz - 1};
  for (int n = 0; n < 9; n++) UT_WITHIN(v[n], 0, 1e-12);
}

int main(void)
{
  for (int k = 0; k < 2000; k++) {
    const double size = pow(10, ut_random(-12, 12));
    check(random_sym(size), size * 3);
    check_positive_part(random_sym(size), size * 3);
    tm_sym3 flat = random_sym(size);
    flat.xz = flat.yz = 0;
    check(flat, size * 3);
    flat.zz = 0;
    check_positive_part(flat, size * 3);
    const tm_sym3 plane = tm_sym_positive_part_2d(flat);
    UT_WITHIN(distance(tm_sym_positive_part(flat), plane), 0, 2e-14 * size);
    const double r = ut_random(0, 1);
    UT_WITHIN(tm_cos_third(r), cos(acos(r) / 3), 4e-16);
    check_inverse(0, ut_random(0.01, 0.5));
    check_inverse(1, ut_random(0.01, 0.5));
  }
  for (int k = 0; k < 200; k++) {
    const double gap = pow(10, ut_random(-18, 0));
    check(with_eigenvalues(1, 1 + gap, -2), 2);
    check_positive_part(with_eigenvalues(1, 1 + gap, -2), 2);
    check_positive_part(with_eigenvalues(gap, -gap, -2), 2);
    check_positive_part(with_eigenvalues(3, gap, -gap), 3);
    check_positive_part(with_eigenvalues(3, 3 + gap, -1), 3);
    check_positive_part(with_eigenvalues(-3, 1, 1 + gap), 3);
    check_positive_part(with_eigenvalues(2, -1, -1), 2);
    check_positive_part(with_eigenvalues(gap, gap, gap), gap);
    check(with_eigenvalues(1, 1, 1), 1);
    check(with_eigenvalues(0, 0, 1), 1);
    check(tm_sym_axpy(tm_sym(1, 1, 1, 0, 0, 0), gap, random_sym(1)), 2);
  }
  check(tm_sym(0, 0, 0, 0, 0, 0), 0);
  check(tm_sym(0, 0, 0, 1, 1, 1), 2);
  check(tm_sym(1, 2, 3, 0, 0, 0), 3);
  check(tm_sym(0, 0, 0, 0, 0, 5), 5);

  /* known values: 2 -1 0 / -1 2 -1 / 0 -1 2 has 2, 2 +- sqrt 2 */
  const tm_eigen e = tm_sym_eigen(tm_sym(2, 2, 2, -1, 0, -1));
  const double sum = e.value[0] + e.value[1] + e.value[2];
  const double low = tm_min(e.value[0], tm_min(e.value[1], e.value[2]));
  UT_NEAR(sum, 6, 1e-14);
  UT_NEAR(low, 2 - sqrt(2.0), 1e-14);
  UT_NEAR(tm_sym_positive_part(tm_sym(-1, -2, -3, 0, 0, 0)).xx + 1, 1, 0);

  const tm_sym3 none = tm_sym_inverse_bounded(tm_sym(0, 0, 0, 0, 0, 0), 1, 0.1);
  UT_TRUE(none.xx == 10 && none.yy == 10 && none.zz == 10 && none.xy == 0);
  const tm_sym3 half = tm_sym_inverse_bounded(tm_sym(2, 2, 0, 0, 0, 0), 0, 0.1);
  UT_TRUE(half.xx == 0.5 && half.yy == 0.5 && half.zz == 1);
  UT_TRUE(tm_sym_inverse_bounded(tm_sym(NAN, 1, 1, 0, 0, 0), 1, 0.1).yy != 1);
  return ut_summary();
}
