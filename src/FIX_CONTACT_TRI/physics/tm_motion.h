/* SPH-TM: rigid motion of a tool, with the meaning of LAMMPS's fix move.

     linear    X(t) = X0 + V t
     wiggle    X(t) = X0 + A sin(2 pi t/period)
     rotate    X(t) = P + R(2 pi t/period) (X0 - P)         right-handed about the axis through P
     transrot  X(t) = P + V t + R(2 pi t/period) (X0 - P)

   X0 is the position when the motion was given, t the time since. A soft start lets the velocity
   grow over a time r by the factor s(t) = 3 u^2 - 2 u^3, u = t/r, then stay: t above becomes
   the integral S(t) = r (u^3 - u^4/2), after the start t - r/2; so position is the exact integral
   of velocity for every motion. */
#ifndef TM_MOTION_H
#define TM_MOTION_H

#include "tm_tensor.h"

/* Where the tool is and how it moves: world = turn local + shift; the velocity of the material
   point at X is velocity + omega x (X - center). */
typedef struct {
  tm_mat3 turn;
  tm_vec3 shift, velocity, omega, center;
} tm_pose;

enum tm_motion_kind { TM_MOTION_NONE = 0, TM_MOTION_LINEAR, TM_MOTION_WIGGLE, TM_MOTION_ROTATE, TM_MOTION_TRANSROT };

typedef struct {
  int kind;            /* enum tm_motion_kind */
  tm_vec3 v;           /* velocity (length/time); wiggle: amplitude (length) */
  tm_vec3 point, axis; /* a point of the axis of rotation, its direction (any length > 0) */
  tm_real period;      /* of wiggle and rotation (time), not 0; negative turns the other way */
  tm_real ramp;        /* duration of the soft start (time), 0: none */
} tm_motion;

/* transposed m times a: the inverse of a rotation */
TM_FN tm_vec3 tm_mat_tmul_vec(tm_mat3 m, tm_vec3 a)
{
  return tm_vec(m.xx * a.x + m.yx * a.y + m.zx * a.z, m.xy * a.x + m.yy * a.y + m.zy * a.z,
                m.xz * a.x + m.yz * a.y + m.zz * a.z);
}

TM_FN tm_pose tm_pose_rest(void)
{
  tm_pose p;
  p.turn = tm_mat_identity();
  p.shift = p.velocity = p.omega = p.center = tm_vec(0, 0, 0);
  return p;
}
TM_FN tm_vec3 tm_pose_to_world(const tm_pose *p, tm_vec3 local)
{
  return tm_vec_add(tm_mat_mul_vec(p->turn, local), p->shift);
}
TM_FN tm_vec3 tm_pose_to_local(const tm_pose *p, tm_vec3 world)
{
  return tm_mat_tmul_vec(p->turn, tm_vec_sub(world, p->shift));
}
TM_FN tm_vec3 tm_pose_velocity_at(const tm_pose *p, tm_vec3 world)
{
  return tm_vec_add(p->velocity, tm_vec_cross(p->omega, tm_vec_sub(world, p->center)));
}

/* Rotation by an angle (radians) about an axis of any length: Rodrigues' formula. */
TM_FN tm_mat3 tm_rotation_about(tm_vec3 axis, tm_real angle)
{
  const tm_vec3 u = tm_vec_scale(1.0 / tm_vec_norm(axis), axis);
  const tm_real c = cos(angle), s = sin(angle), half = sin(0.5 * angle);
  const tm_real d = 2.0 * half * half; /* 1 - cos, without cancellation */
  tm_mat3 m;
  /* clang-format off */
  m.xx = c + d * u.x * u.x; m.xy = d * u.x * u.y - s * u.z; m.xz = d * u.x * u.z + s * u.y;
  m.yx = d * u.x * u.y + s * u.z; m.yy = c + d * u.y * u.y; m.yz = d * u.y * u.z - s * u.x;
  m.zx = d * u.x * u.z - s * u.y; m.zy = d * u.y * u.z + s * u.x; m.zz = c + d * u.z * u.z;
  /* clang-format on */
  return m;
}

/* Factor on the velocity at time t after the start, and its integral. */
TM_FN tm_real tm_ramp_factor(tm_real t, tm_real ramp)
{
  if (!(t < ramp)) return 1.0;
  const tm_real u = tm_max(t, 0.0) / ramp;
  return u * u * (3.0 - 2.0 * u);
}
TM_FN tm_real tm_ramp_time(tm_real t, tm_real ramp)
{
  if (!(t < ramp)) return t - 0.5 * ramp;
  const tm_real u = tm_max(t, 0.0) / ramp;
  return ramp * u * u * u * (1.0 - 0.5 * u);
}

/* Pose at time t after the motion was given, when the tool stood at `base`. */
TM_FN tm_pose tm_motion_pose(const tm_motion *m, const tm_pose *base, tm_real t)
{
  tm_pose p = *base;
  p.velocity = p.omega = p.center = tm_vec(0, 0, 0);
  if (m->kind == TM_MOTION_NONE) return p;
  const tm_real time = tm_ramp_time(t, m->ramp), rate = tm_ramp_factor(t, m->ramp);
  tm_vec3 moved = tm_vec(0, 0, 0);
  if (m->kind == TM_MOTION_LINEAR || m->kind == TM_MOTION_TRANSROT) {
    moved = tm_vec_scale(time, m->v);
    p.velocity = tm_vec_scale(rate, m->v);
  }
  if (m->kind == TM_MOTION_WIGGLE) {
    const tm_real w = 2.0 * TM_PI / m->period;
    moved = tm_vec_scale(sin(w * time), m->v);
    p.velocity = tm_vec_scale(rate * w * cos(w * time), m->v);
  }
  if (m->kind == TM_MOTION_ROTATE || m->kind == TM_MOTION_TRANSROT) {
    const tm_real w = 2.0 * TM_PI / m->period;
    const tm_mat3 r = tm_rotation_about(m->axis, w * time);
    p.turn = tm_mat_mul(r, base->turn);
    p.shift = tm_vec_add(m->point, tm_mat_mul_vec(r, tm_vec_sub(base->shift, m->point)));
    p.omega = tm_vec_scale(w * rate / tm_vec_norm(m->axis), m->axis);
    p.center = tm_vec_add(m->point, moved);
  }
  p.shift = tm_vec_add(p.shift, moved);
  return p;
}

#endif
