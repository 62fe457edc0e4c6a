/* SPH-TM: Dirichlet conditions: particles of prescribed temperature or velocity. */
#ifndef TM_DIRICHLET_H
#define TM_DIRICHLET_H

#include "tm_heat.h"
#include "tm_state.h"

typedef struct {
  tm_state state;
  int group; /* of LAMMPS's group bits */
  tm_real temperature;
} tm_dirichlet_args;

/* Gives particle i its temperature; returns the heat this takes. */
TM_FN tm_real tm_dirichlet(int i, const tm_dirichlet_args *a)
{
  const tm_state *s = &a->state;
  if (!(s->mask[i] & a->group)) return 0.0;
  tm_real *t = tm_field_row(s, TM_F_TEMP, i);
  const tm_real rise = a->temperature - t[0];
  const tm_real cp = tm_capacity(s->material + s->type[i], 0.5 * (t[0] + a->temperature));
  t[0] = a->temperature;
  t[tm_column(1)] = t[tm_column(2)] = 0.0;
  if (s->field[TM_F_ENERGY]) *tm_field_row(s, TM_F_ENERGY, i) += cp * rise;
  return tm_particle_mass(s, i) * cp * rise;
}

/* A turn about an axis that moves with the velocity of the drive. */
typedef struct {
  int turns;         /* 0: none, and the rest is not read */
  tm_vec3 point;     /* of the axis, at the end of the step */
  tm_vec3 axis;      /* unit vector */
  tm_real rate;      /* at the end of the step, radians per time */
  tm_real period[3]; /* length of the box where it is periodic, or 0 */
} tm_drive_turn;

typedef struct {
  tm_state state;
  int group;
  int given[3];        /* nonzero: this component is driven */
  int act;             /* 0: only sum */
  tm_real velocity[3]; /* at the end of the step */
  tm_drive_turn turn;
  tm_real dt;
  tm_real accel_unit; /* force of the unit style / mass -> acceleration */
} tm_drive_args;

typedef struct {
  tm_real force[3]; /* on the particle, by all others, in the driven directions */
  tm_real work;     /* of the drive in this step, force unit times length */
  tm_real torque;   /* of that force about the axis of the turn, force unit times length */
} tm_drive_result;

TM_FN tm_drive_result tm_drive_nothing(void)
{
  tm_drive_result r;
  r.force[0] = r.force[1] = r.force[2] = r.work = r.torque = 0.0;
  return r;
}

/* From the axis to particle i, at the end of the step: y of x(n+1) = x(n+1/2) + dt/2 V(n+1) with V = U + w a x y, U the velocity
   of the axis,

     y - dt/2 w a x y = x(n+1/2) - P(n+1) + dt/2 U

   so that the distance from the axis stays to the order of (w dt)^2, without drift, and a step turns by 2 atan(w dt/2). */
TM_FN tm_vec3 tm_drive_arm(int i, const tm_drive_args *a)
{
  const tm_drive_turn *t = &a->turn;
  const double *x = a->state.x + 3 * (ptrdiff_t) i;
  const tm_real half = 0.5 * a->dt, w = half * t->rate;
  const tm_real from[3] = {x[0] - t->point.x + half * a->velocity[0], x[1] - t->point.y + half * a->velocity[1],
                           x[2] - t->point.z + half * a->velocity[2]};
  tm_real near[3];
  for (int k = 0; k < 3; k++)
    near[k] = t->period[k] > 0.0 ? from[k] - t->period[k] * floor(from[k] / t->period[k] + 0.5) : from[k];
  const tm_vec3 b = tm_vec(near[0], near[1], near[2]);
  const tm_vec3 across = tm_vec_axpy(b, w, tm_vec_cross(t->axis, b));
  return tm_vec_scale(1.0 / (1.0 + w * w), tm_vec_axpy(across, w * w * tm_vec_dot(t->axis, b), t->axis));
}

/* Replaces the force on particle i by the one with which the step ends at the velocity,
   v + dt f/m = V, and that of the turn, U + w a x y. */
TM_FN tm_drive_result tm_drive(int i, const tm_drive_args *a)
{
  const tm_state *s = &a->state;
  tm_drive_result r = tm_drive_nothing();
  if (!(s->mask[i] & a->group)) return r;
  double *f = s->force + 3 * (ptrdiff_t) i;
  const double *v = s->v + 3 * (ptrdiff_t) i;
  const tm_real per_acc = tm_particle_mass(s, i) / a->accel_unit;
  tm_real end[3] = {a->velocity[0], a->velocity[1], a->velocity[2]};
  tm_vec3 arm = tm_vec(0, 0, 0);
  if (a->turn.turns) {
    arm = tm_drive_arm(i, a);
    const tm_vec3 u = tm_vec_cross(a->turn.axis, arm);
    end[0] += a->turn.rate * u.x;
    end[1] += a->turn.rate * u.y;
    end[2] += a->turn.rate * u.z;
  }
  for (int k = 0; k < 3; k++) {
    if (!a->given[k]) continue;
    r.force[k] = f[k];
    if (!a->act) continue;
    const tm_real needed = per_acc * (end[k] - v[k]) / a->dt;
    r.work += (needed - f[k]) * 0.5 * (end[k] + v[k]) * a->dt;
    f[k] = needed;
  }
  if (a->turn.turns) r.torque = tm_vec_dot(a->turn.axis, tm_vec_cross(arm, tm_vec(r.force[0], r.force[1], r.force[2])));
  return r;
}

TM_FN void tm_drive_sum(tm_drive_result *sum, const tm_drive_result *r)
{
  for (int k = 0; k < 3; k++) sum->force[k] += r->force[k];
  sum->work += r->work;
  sum->torque += r->torque;
}

#endif
