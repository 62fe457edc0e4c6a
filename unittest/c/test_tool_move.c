/* Particles of a tool keep their place in it, whatever way it goes; others stay. */
#include "tm_tool_move.h"
#include "ut_state.h"

static ut_particles p;

int main(void)
{
  tm_tool_move_args a;
  ut_particles_make(&p);
  a.state = p.state;
  a.group = 1;
  a.body_type = 2;
  a.dim3 = 1;
  a.from = a.to = tm_pose_rest();
  a.to.turn = tm_rotation_about(tm_vec(0, 0, 1), 0.5 * TM_PI);
  a.to.shift = tm_vec(10.0, 20.0, 30.0);
  p.type[1] = p.type[2] = 2;
  p.mask[2] = 4;
  for (int i = 0; i < 3; i++)
    for (int d = 0; d < 3; d++) {
      p.x[3 * i + d] = 1.0 + d;
      p.v[3 * i + d] = 5.0;
    }
  for (int i = 0; i < 3; i++) tm_tool_move(i, &a);
  UT_TRUE(p.x[0] == 1.0 && p.x[1] == 2.0 && p.x[2] == 3.0 && p.v[0] == 5.0);   /* of another type */
  UT_TRUE(p.x[6] == 1.0 && p.x[7] == 2.0 && p.x[8] == 3.0 && p.v[6] == 5.0);   /* of another group */
  UT_NEAR(p.x[3], 10.0 - 2.0, 1e-15);                                           /* (x y z) -> (-y x z) + shift */
  UT_NEAR(p.x[4], 20.0 + 1.0, 1e-15);
  UT_NEAR(p.x[5], 30.0 + 3.0, 1e-15);
  UT_TRUE(p.v[3] == 0.0 && p.v[4] == 0.0 && p.v[5] == 0.0);

  /* a long way in many steps of rotation and translation: the place in the tool stays */
  ut_particles_make(&p);
  tm_motion move;
  move.kind = TM_MOTION_TRANSROT;
  move.v = tm_vec(3.0, -2.0, 1.0);
  move.point = tm_vec(0.5, 0.25, -1.0);
  move.axis = tm_vec(1.0, 2.0, 3.0);
  move.period = 0.7;
  move.ramp = 0.3;
  const tm_pose rest = tm_pose_rest();
  const tm_vec3 start = tm_vec(1.5, -0.75, 2.0);
  p.type[0] = 2;
  p.x[0] = start.x; p.x[1] = start.y; p.x[2] = start.z;
  a.from = rest;
  for (int step = 1; step <= 1000; step++) {
    a.to = tm_motion_pose(&move, &rest, 1e-3 * step);
    tm_tool_move(0, &a);
    a.from = a.to;
  }
  const tm_vec3 at = tm_pose_to_world(&a.to, start);
  UT_WITHIN(p.x[0], at.x, 1e-12);
  UT_WITHIN(p.x[1], at.y, 1e-12);
  UT_WITHIN(p.x[2], at.z, 1e-12);
  UT_TRUE(fabs(at.x - start.x) > 0.1);

  p.x[2] = 9.0;                                      /* in two dimensions z stays */
  a.dim3 = 0;
  a.to.shift.z += 1.0;
  tm_tool_move(0, &a);
  UT_TRUE(p.x[2] == 9.0);
  return ut_summary();
}
