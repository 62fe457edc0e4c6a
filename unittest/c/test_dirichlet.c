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

int main(void)
{
  temperature();
  velocity();
  return ut_summary();
}
