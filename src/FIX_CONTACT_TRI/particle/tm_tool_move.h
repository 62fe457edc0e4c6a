/* SPH-TM: particles inside a rigid tool move with it, exactly; their velocity stays zero, so that
   nothing else moves them. */
#ifndef TM_TOOL_MOVE_H
#define TM_TOOL_MOVE_H

#include "tm_motion.h"
#include "tm_state.h"

typedef struct {
  tm_state state;
  int group, body_type; /* particles of this group and type */
  int dim3;
  tm_pose from, to; /* of the tool */
} tm_tool_move_args;

TM_FN void tm_tool_move(int i, const tm_tool_move_args *a)
{
  const tm_state *s = &a->state;
  if (s->type[i] != a->body_type || !(s->mask[i] & a->group)) return;
  double *x = s->x + 3 * (ptrdiff_t) i, *v = s->v + 3 * (ptrdiff_t) i;
  const tm_vec3 local = tm_pose_to_local(&a->from, tm_vec(x[0], x[1], x[2]));
  const tm_vec3 w = tm_pose_to_world(&a->to, local);
  x[0] = w.x;
  x[1] = w.y;
  if (a->dim3) x[2] = w.z;
  v[0] = v[1] = v[2] = 0.0;
}

#endif
