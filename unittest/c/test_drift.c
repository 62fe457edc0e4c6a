/* First half of a step: x = x0 + t (v + u) to the last bit, who is moved, who is lost. */
#include "tm_drift.h"
#include "ut_state.h"

static ut_particles p;
static tm_drift_args a;

static void start(void)
{
  ut_particles_make(&p);
  memset(&a, 0, sizeof a);
  a.state = p.state;
  a.group = 1;
  a.half = 0.5;
  for (int d = 0; d < 3; d++) {
    a.lo[d] = -1.0;
    a.hi[d] = 1.0;
    p.x[d] = 0.125 * (d + 1);
    p.v[d] = 0.5 - 0.25 * d;
    p.field[TM_F_XSPH][d] = 0.0625 * (d + 1);
  }
}

static void expect(double x, double y, double z)
{
  UT_TRUE(p.x[0] == x && p.x[1] == y && p.x[2] == z);
}

int main(void)
{
  start();
  UT_TRUE(!tm_drift(0, &a, TM_FX_3D));
  expect(0.125 + 0.25, 0.25 + 0.125, 0.375 + 0.0);
  start();
  p.v[2] = 9.0;
  UT_TRUE(!tm_drift(0, &a, 0));                        /* in two dimensions z stays */
  expect(0.375, 0.375, 0.375);
  start();
  UT_TRUE(!tm_drift(0, &a, TM_FX_3D | TM_FX_XSPH));
  expect(0.375 + 0.03125, 0.375 + 0.0625, 0.375 + 0.09375);
  start();
  p.mask[0] = 2;                                       /* not of the group: stays, but can be lost */
  UT_TRUE(!tm_drift(0, &a, TM_FX_3D));
  expect(0.125, 0.25, 0.375);

  /* lost: only beyond a closed face, also particles of no group, and not on the face itself */
  for (int d = 0; d < 3; d++)
    for (int side = 0; side < 2; side++) {
      const double face = side ? 1.0 : -1.0;
      start();
      p.v[0] = p.v[1] = p.v[2] = 0.0;
      p.x[d] = face;
      a.closed[d][0] = a.closed[d][1] = 1;
      UT_TRUE(!tm_drift(0, &a, TM_FX_3D));
      p.x[d] = face * 1.0000001;
      UT_TRUE(tm_drift(0, &a, TM_FX_3D));
      UT_TRUE(!tm_drift(0, &a, 0) == (d == 2));        /* z does not count in two dimensions */
      p.mask[0] = 2;
      UT_TRUE(tm_drift(0, &a, TM_FX_3D));
      a.closed[d][side] = 0;
      UT_TRUE(!tm_drift(0, &a, TM_FX_3D));
    }
  /* it is looked for where it arrives */
  start();
  a.closed[0][1] = 1;
  p.x[0] = 0.9;
  UT_TRUE(tm_drift(0, &a, TM_FX_3D));
  /* the second particle's rows */
  start();
  p.x[3] = p.x[4] = p.x[5] = 0.0;
  p.v[3] = 1.0; p.v[4] = -1.0; p.v[5] = 0.5;
  UT_TRUE(!tm_drift(1, &a, TM_FX_3D));
  UT_TRUE(p.x[3] == 0.5 && p.x[4] == -0.5 && p.x[5] == 0.25 && p.x[0] == 0.125);
  return ut_summary();
}
