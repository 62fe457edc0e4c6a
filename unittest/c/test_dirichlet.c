/* Prescribed temperature and velocity: the state reached, the heat and the work it takes. */
#include "tm_dirichlet.h"
#include "ut_state.h"

static ut_particles p;

static void temperature(void)
{
  tm_dirichlet_args a;
  ut_particles_make(&p);
  a.state = p.state;
  a.group = 2;
  a.temperature = 500.0;
  p.mask[1] = 3;
  p.material[1].capacity.value = 4.0;
  double *t = p.field[TM_F_TEMP];
  t[0] = t[3] = 300.0;
  t[4] = 7.0; t[5] = -8.0;
  UT_TRUE(tm_dirichlet(0, &a) == 0.0 && t[0] == 300.0);            /* not of the group */
  UT_NEAR(tm_dirichlet(1, &a), 2.0 * 4.0 * 200.0, 1e-15);           /* m c dT */
  UT_NEAR(p.field[TM_F_ENERGY][3], 4.0 * 200.0, 1e-15);             /* the internal energy takes it up */
  UT_TRUE(t[3] == 500.0 && t[4] == 0.0 && t[5] == 0.0);        /* and no rate that would lead away */
  UT_TRUE(tm_dirichlet(1, &a) == 0.0);                              /* it is there already */
  /* a capacity linear in T: the integral from 500 to 300 is that of the middle */
  p.material[1].capacity.n = 2;
  p.material[1].capacity.t[0] = 200.0; p.material[1].capacity.t[1] = 600.0;
  p.material[1].capacity.y[0] = 1.0; p.material[1].capacity.y[1] = 5.0;
  a.temperature = 300.0;
  UT_NEAR(tm_dirichlet(1, &a), -2.0 * 200.0 * 3.0, 1e-15);
}

/* v + dt f/m = V, whatever else acts; work is force times mean velocity times dt */
static void velocity(void)
{
  tm_drive_args a;
  ut_particles_make(&p);
  memset(&a, 0, sizeof a);
  a.state = p.state;
  a.group = 2;
  a.act = 1;
  a.given[0] = a.given[2] = 1;
  a.velocity[0] = 3.0; a.velocity[1] = 77.0; a.velocity[2] = -1.0;
  a.dt = 0.125;
  a.accel_unit = 4.0;
  for (int k = 0; k < 3; k++) {
    p.v[k] = p.v[3 + k] = 1.0 + k;
    p.force[k] = p.force[3 + k] = 5.0 * (k + 1);
  }
  p.mask[1] = 2;
  tm_drive_result none = tm_drive(0, &a);
  UT_TRUE(none.work == 0.0 && none.force[0] == 0.0 && p.force[0] == 5.0);
  a.act = 0;                                                   /* only sum */
  tm_drive_result r = tm_drive(1, &a);
  UT_TRUE(r.force[0] == 5.0 && r.force[1] == 0.0 && r.force[2] == 15.0 && r.work == 0.0 && p.force[3] == 5.0);
  a.act = 1;
  r = tm_drive(1, &a);
  UT_TRUE(r.force[0] == 5.0 && r.force[1] == 0.0 && r.force[2] == 15.0);
  UT_NEAR(p.v[3] + a.dt * 4.0 * p.force[3] / 2.0, 3.0, 1e-15);
  UT_NEAR(p.v[5] + a.dt * 4.0 * p.force[5] / 2.0, -1.0, 1e-15);
  UT_TRUE(p.force[4] == 10.0);                                 /* y is free */
  UT_NEAR(r.work, ((8.0 - 5.0) * 2.0 + (-16.0 - 15.0) * 1.0) * 0.125, 1e-15);
  tm_drive_result sum = tm_drive_nothing();
  tm_drive_sum(&sum, &r);
  tm_drive_sum(&sum, &r);
  UT_TRUE(sum.work == 2.0 * r.work && sum.force[0] == 10.0 && sum.force[1] == 0.0 && sum.force[2] == 30.0);
}

/* y - dt/2 w a x y = x - P + dt/2 U, V = U + w a x y, along a skew axis; a box that is periodic brings the nearest image */
static void turn(void)
{
  tm_drive_args a;
  ut_particles_make(&p);
  memset(&a, 0, sizeof a);
  a.state = p.state;
  a.group = 1;
  a.act = 1;
  a.given[0] = a.given[1] = a.given[2] = 1;
  a.velocity[0] = 0.5; a.velocity[1] = -1.0; a.velocity[2] = 2.0;
  a.dt = 0.1;
  a.accel_unit = 4.0;
  a.turn.turns = 1;
  a.turn.point = tm_vec(0.3, -0.4, 0.1);
  a.turn.axis = tm_vec(2.0 / 7.0, 3.0 / 7.0, 6.0 / 7.0);
  a.turn.rate = 3.0;
  p.mask[0] = 1;
  for (int k = 0; k < 3; k++) p.x[k] = 1.0 + 0.7 * k, p.v[k] = k - 1.0, p.force[k] = 2.0 - k;
  const tm_vec3 U = tm_vec(0.5, -1.0, 2.0), f = tm_vec(2.0, 1.0, 0.0);
  const tm_vec3 y = tm_drive_arm(0, &a), cross = tm_vec_cross(a.turn.axis, y);
  const tm_vec3 left = tm_vec_axpy(y, -0.15, cross);
  const tm_vec3 right = tm_vec_axpy(tm_vec(1.0 - 0.3, 1.7 + 0.4, 2.4 - 0.1), 0.05, U);
  UT_NEAR(left.x, right.x, 1e-14);
  UT_NEAR(left.y, right.y, 1e-14);
  UT_NEAR(left.z, right.z, 1e-14);
  const tm_drive_result r = tm_drive(0, &a);
  UT_NEAR(r.torque, tm_vec_dot(a.turn.axis, tm_vec_cross(y, f)), 1e-14);
  const tm_vec3 V = tm_vec_axpy(U, 3.0, cross);
  const double mass = tm_particle_mass(&p.state, 0), end[3] = {V.x, V.y, V.z};
  for (int k = 0; k < 3; k++) UT_NEAR(p.v[k] + a.dt * 4.0 * p.force[k] / mass, end[k], 1e-14);
  /* the radius after a step of free flight with the velocity of the turn before: |y| = |y0| sqrt((1 + q^2)/(1 + q^2)) */
  a.velocity[0] = a.velocity[1] = a.velocity[2] = 0.0;
  const tm_vec3 y0 = tm_vec(0.2, 0.5, -0.4), x = tm_vec_add(a.turn.point, tm_vec_axpy(y0, 0.15, tm_vec_cross(a.turn.axis, y0)));
  p.x[0] = x.x, p.x[1] = x.y, p.x[2] = x.z;
  UT_NEAR(tm_vec_norm(tm_drive_arm(0, &a)), tm_vec_norm(y0), 1e-14);
  UT_NEAR(tm_vec_dot(tm_drive_arm(0, &a), a.turn.axis), tm_vec_dot(y0, a.turn.axis), 1e-14);
  p.x[1] += 10.0;
  a.turn.period[1] = 10.0;
  UT_NEAR(tm_vec_norm(tm_drive_arm(0, &a)), tm_vec_norm(y0), 1e-13);
  tm_drive_result sum = tm_drive_nothing();
  tm_drive_sum(&sum, &r);
  tm_drive_sum(&sum, &r);
  UT_TRUE(sum.torque == 2.0 * r.torque);
}

int main(void)
{
  temperature();
  velocity();
  turn();
  return ut_summary();
}
