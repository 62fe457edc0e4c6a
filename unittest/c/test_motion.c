/* Rigid motion against LAMMPS's formulas written out, and position against integrated velocity. */
#include "tm_motion.h"
#include "ut.h"

static tm_motion motion(int kind)
{
  tm_motion m;
  m.kind = kind;
  m.v = tm_vec(0.3, -0.2, 0.7);
  m.point = tm_vec(0.1, 0.4, -0.3);
  m.axis = tm_vec(1.0, 2.0, -0.5);
  m.period = 2.5;
  m.ramp = 0.0;
  return m;
}

static void same(tm_vec3 a, tm_vec3 b, double tolerance)
{
  UT_WITHIN(a.x, b.x, tolerance);
  UT_WITHIN(a.y, b.y, tolerance);
  UT_WITHIN(a.z, b.z, tolerance);
}

/* fix move's rotation: X = P + c + a cos(w t) + b sin(w t), a = d - c, b = R x d */
static tm_vec3 lammps_rotate(const tm_motion *m, tm_vec3 x0, double t)
{
  const tm_vec3 r = tm_vec_scale(1.0 / tm_vec_norm(m->axis), m->axis);
  const tm_vec3 d = tm_vec_sub(x0, m->point), c = tm_vec_scale(tm_vec_dot(d, r), r);
  const tm_vec3 a = tm_vec_sub(d, c), b = tm_vec_cross(r, d);
  const double w = 2.0 * TM_PI / m->period;
  return tm_vec_add(tm_vec_add(m->point, c),
                    tm_vec_add(tm_vec_scale(cos(w * t), a), tm_vec_scale(sin(w * t), b)));
}

static tm_pose some_base(void)
{
  tm_pose b = tm_pose_rest();
  b.turn = tm_rotation_about(tm_vec(0.2, -1, 0.4), 1.1);
  b.shift = tm_vec(2, -1, 0.5);
  return b;
}

static void against_formulas(void)
{
  const tm_pose base = some_base();
  const tm_vec3 local = tm_vec(0.7, 0.1, -0.9), x0 = tm_pose_to_world(&base, local);
  for (int k = 0; k < 40; k++) {
    const double t = 0.17 * k;
    tm_motion m = motion(TM_MOTION_LINEAR);
    tm_pose p = tm_motion_pose(&m, &base, t);
    same(tm_pose_to_world(&p, local), tm_vec_axpy(x0, t, m.v), 1e-14);
    m.kind = TM_MOTION_WIGGLE;
    p = tm_motion_pose(&m, &base, t);
    same(tm_pose_to_world(&p, local), tm_vec_axpy(x0, sin(2 * TM_PI / m.period * t), m.v), 1e-14);
    m.kind = TM_MOTION_ROTATE;
    p = tm_motion_pose(&m, &base, t);
    same(tm_pose_to_world(&p, local), lammps_rotate(&m, x0, t), 1e-13);
    m.kind = TM_MOTION_TRANSROT;
    p = tm_motion_pose(&m, &base, t);
    same(tm_pose_to_world(&p, local), tm_vec_axpy(lammps_rotate(&m, x0, t), t, m.v), 1e-13);
    same(tm_pose_to_local(&p, tm_pose_to_world(&p, local)), local, 1e-13);
    m.kind = TM_MOTION_NONE;
    p = tm_motion_pose(&m, &base, t);
    same(tm_pose_to_world(&p, local), x0, 0.0);
  }
}

/* Velocity is the derivative of position, with and without a soft start. */
static void velocity_is_derivative(void)
{
  const tm_pose base = some_base();
  const tm_vec3 local = tm_vec(0.7, 0.1, -0.9);
  for (int kind = TM_MOTION_LINEAR; kind <= TM_MOTION_TRANSROT; kind++)
    for (int k = 0; k < 60; k++) {
      tm_motion m = motion(kind);
      m.ramp = k % 2 ? 1.3 : 0.0;
      const double t = 0.05 + 0.05 * k, e = 1e-5;
      const tm_pose p = tm_motion_pose(&m, &base, t);
      const tm_pose a = tm_motion_pose(&m, &base, t - e), b = tm_motion_pose(&m, &base, t + e);
      const tm_vec3 xa = tm_pose_to_world(&a, local), xb = tm_pose_to_world(&b, local);
      const tm_vec3 v = tm_pose_velocity_at(&p, tm_pose_to_world(&p, local));
      same(v, tm_vec_scale(0.5 / e, tm_vec_sub(xb, xa)), 1e-8);
    }
}

/* Soft start: the distance is the integral of the velocity, found by Simpson's rule. */
static void ramp_integral(void)
{
  for (int k = 1; k < 30; k++) {
    const double ramp = 0.8, end = 0.06 * k;
    double sum = 0.0;
    const int n = 2000;
    for (int i = 0; i < n; i++) {
      const double a = end * i / n, b = end * (i + 1) / n;
      sum += (b - a) / 6.0 * (tm_ramp_factor(a, ramp) + 4.0 * tm_ramp_factor(0.5 * (a + b), ramp)
                              + tm_ramp_factor(b, ramp));
    }
    UT_NEAR(tm_ramp_time(end, ramp), sum, 1e-9);
  }
  UT_TRUE(tm_ramp_factor(0.0, 1.0) == 0.0 && tm_ramp_factor(1.0, 1.0) == 1.0);
  UT_TRUE(tm_ramp_factor(0.0, 0.0) == 1.0 && tm_ramp_time(0.3, 0.0) == 0.3);
  UT_TRUE(tm_ramp_time(0.0, 1.0) == 0.0);
}

int main(void)
{
  against_formulas();
  velocity_is_derivative();
  ramp_integral();
  const tm_mat3 r = tm_rotation_about(tm_vec(0, 0, 3), TM_PI / 2);   /* right-handed: x to y */
  same(tm_mat_mul_vec(r, tm_vec(1, 0, 0)), tm_vec(0, 1, 0), 1e-15);
  return ut_summary();
}
