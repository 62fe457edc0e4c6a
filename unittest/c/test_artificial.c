/* Artificial terms: symmetry of the viscosity, frame indifference of the artificial stress. */
#include "tm_artificial.h"
#include "ut.h"

static void check_viscosity(void)
{
  int approaching = 0;
  for (int k = 0; k < 4000; k++) {
    tm_vec3 x[2], v[2];
    double c[2], rho[2];
    for (int i = 0; i < 2; i++) {
      x[i] = tm_vec(ut_random(-1, 1), ut_random(-1, 1), ut_random(-1, 1));
      v[i] = tm_vec(ut_random(-9, 9), ut_random(-9, 9), ut_random(-9, 9));
      c[i] = ut_random(1, 10);
      rho[i] = ut_random(1, 10);
    }
    double pi[2], inv_r, inv_rho_sum;
    for (int i = 0; i < 2; i++) {
      const int j = 1 - i;
      const tm_vec3 dx = tm_vec_sub(x[i], x[j]), dv = tm_vec_sub(v[i], v[j]);
      pi[i] = tm_viscosity_pair(2.1, 0.7, tm_vec_dot(dv, dx), tm_vec_dot(dx, dx), tm_vec_norm(dx),
                                1.2 * 0.5 * (c[i] + c[j]), rho[i] + rho[j], &inv_r, &inv_rho_sum);
    }
    UT_TRUE(pi[0] == pi[1]);
    const tm_vec3 dx = tm_vec_sub(x[0], x[1]), dv = tm_vec_sub(v[0], v[1]);
    const double vx = tm_vec_dot(dv, dx), mu = 0.7 * vx / (tm_vec_dot(dx, dx) + 0.0049);
    const double cm = 0.5 * (c[0] + c[1]), rm = 0.5 * (rho[0] + rho[1]);
    UT_WITHIN(pi[0], vx < 0 ? (-1.2 * cm * mu + 2.1 * mu * mu) / rm : 0, 1e-13 * (1 + mu * mu));
    UT_NEAR(inv_r, 1 / tm_vec_norm(dx), 1e-14);
    UT_NEAR(inv_rho_sum, 1 / (2 * rm), 1e-14);
    UT_TRUE(vx < 0 ? pi[0] > 0 : pi[0] == 0);
    approaching += vx < 0;
  }
  UT_TRUE(approaching > 1000 && approaching < 3000);
}

static tm_sym3 random_sym(void)
{
  return tm_sym(ut_random(-1, 1), ut_random(-1, 1), ut_random(-1, 1), ut_random(-1, 1),
                ut_random(-1, 1), ut_random(-1, 1));
}
static tm_mat3 rotation(int dim3)
{
  tm_mat3 q = tm_mat_identity();
  if (!dim3) {
    const double a = ut_random(0, 2 * TM_PI);
    q.xx = q.yy = cos(a);
    q.xy = -sin(a);
    q.yx = sin(a);
    return q;
  }
  const tm_eigen e = tm_sym_eigen(random_sym());
  q.xx = e.vector[0].x; q.xy = e.vector[0].y; q.xz = e.vector[0].z;
  q.yx = e.vector[1].x; q.yy = e.vector[1].y; q.yz = e.vector[1].z;
  q.zx = e.vector[2].x; q.zy = e.vector[2].y; q.zz = e.vector[2].z;
  return q;
}
/* Q s Q^T */
static tm_sym3 turned(tm_sym3 s, tm_mat3 q)
{
  tm_mat3 m, t = q;
  m.xx = s.xx; m.xy = m.yx = s.xy; m.xz = m.zx = s.xz;
  m.yy = s.yy; m.yz = m.zy = s.yz; m.zz = s.zz;
  t.xy = q.yx; t.xz = q.zx; t.yx = q.xy; t.yz = q.zy; t.zx = q.xz; t.zy = q.yz;
  return tm_mat_symmetric(tm_mat_mul(tm_mat_mul(q, m), t));
}
static double distance(tm_sym3 a, tm_sym3 b)
{
  const tm_sym3 d = tm_sym_axpy(a, -1, b);
  return sqrt(tm_sym_ddot(d, d));
}

/* R(Q s Q^T) = Q R(s) Q^T in principal axes, and not per component */
static void check_frame(int dim3)
{
  double worst = 0;
  for (int k = 0; k < 1000; k++) {
    tm_sym3 s = random_sym();
    if (!dim3) s.zz = s.xz = s.yz = 0;
    const tm_mat3 q = rotation(dim3);
    const tm_sym3 a = tm_artificial_stress_principal(turned(s, q), 0.3, 2, dim3);
    const tm_sym3 b = turned(tm_artificial_stress_principal(s, 0.3, 2, dim3), q);
    UT_WITHIN(distance(a, b), 0, 1e-13);
    const tm_sym3 c = tm_artificial_stress_component(turned(s, q), 0.3, 2, dim3);
    const tm_sym3 d = turned(tm_artificial_stress_component(s, 0.3, 2, dim3), q);
    worst = tm_max(worst, distance(c, d));
  }
  UT_TRUE(worst > 0.3);
}

static void check_stress(void)
{
  /* -eps sigma/rho^2 along tensile axes, nothing along compressive ones */
  const tm_sym3 s = tm_artificial_stress_principal(tm_sym(4, -3, 2, 0, 0, 0), 0.3, 0.5, 1);
  UT_WITHIN(distance(s, tm_sym(-0.6, 0, -0.3, 0, 0, 0)), 0, 1e-15);
  const tm_sym3 plane = tm_artificial_stress_principal(tm_sym(4, -3, 2, 0, 7, 7), 0.3, 0.5, 0);
  UT_WITHIN(distance(plane, tm_sym(-0.6, 0, 0, 0, 0, 0)), 0, 1e-15);
  /* pure shear: tension along the diagonal only */
  const tm_sym3 shear = tm_artificial_stress_principal(tm_sym(0, 0, 0, 1, 0, 0), 0.3, 1, 0);
  UT_WITHIN(distance(shear, tm_sym(-0.15, -0.15, 0, -0.15, 0, 0)), 0, 1e-15);
  const tm_sym3 none = tm_artificial_stress_principal(tm_sym(-1, -1, -1, 0, 0, 0), 0.3, 1, 1);
  UT_TRUE(tm_sym_ddot(none, none) == 0);
  const tm_sym3 c = tm_artificial_stress_component(tm_sym(4, -3, 2, 1, -1, 5), 0.3, 0.5, 1);
  UT_WITHIN(distance(c, tm_sym(-0.6, 0, -0.3, -0.15, 0, -0.75)), 0, 1e-15);
  const tm_sym3 c2 = tm_artificial_stress_component(tm_sym(4, -3, 2, 1, -1, 5), 0.3, 0.5, 0);
  UT_WITHIN(distance(c2, tm_sym(-0.6, 0, 0, -0.15, 0, 0)), 0, 1e-15);
}

int main(void)
{
  check_viscosity();
  check_frame(0);
  check_frame(1);
  check_stress();
  for (int n = 0; n <= 15; n++)
    for (int k = 0; k < 20; k++) {
      const double f = ut_random(0, 1.7);
      UT_NEAR(tm_power_int(f, n), pow(f, n), 1e-14);
    }
  UT_NEAR(tm_balsara(-2, 0, 5, 0.01), 1 / (1 + 0.025), 1e-14);
  UT_TRUE(tm_balsara(0, 3, 5, 0.01) == 0);
  UT_NEAR(tm_balsara(1, -3, 0, 0.01), 0.25, 1e-14);
  UT_TRUE(tm_balsara(0, 0, 5, 0.01) == 0);
  /* m_j/rho_mean W is symmetric for equal masses */
  UT_NEAR(tm_xsph_pair(2, 1.0 / 8, 0.5), 0.25, 1e-15);
  return ut_summary();
}
