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

typedef struct {
  tm_state state;
  int group;
  int given[3];        /* nonzero: this component is driven */
  int act;             /* 0: only sum */
  tm_real velocity[3]; /* at the end of the step */
  tm_real dt;
  tm_real accel_unit; /* force of the unit style / mass -> acceleration */
} tm_drive_args;

typedef struct {
  tm_real force[3]; /* on the particle, by all others, in the driven directions */
  tm_real work;     /* of the drive in this step, force unit times length */
} tm_drive_result;

TM_FN tm_drive_result tm_drive_nothing(void)
{
  tm_drive_result r;
  r.force[0] = r.force[1] = r.force[2] = r.work = 0.0;
  return r;
}

/* Replaces the force on particle i by the one with which the step ends at the velocity,
   v + dt f/m = V. */
TM_FN tm_drive_result tm_drive(int i, const tm_drive_args *a)
{
  const tm_state *s = &a->state;
  tm_drive_result r = tm_drive_nothing();
  if (!(s->mask[i] & a->group)) return r;
  double *f = s->force + 3 * (ptrdiff_t) i;
  const double *v = s->v + 3 * (ptrdiff_t) i;
  const tm_real per_acc = tm_particle_mass(s, i) / a->accel_unit;
  for (int k = 0; k < 3; k++) {
    if (!a->given[k]) continue;
    r.force[k] = f[k];
    if (!a->act) continue;
    const tm_real needed = per_acc * (a->velocity[k] - v[k]) / a->dt;
    r.work += (needed - f[k]) * 0.5 * (a->velocity[k] + v[k]) * a->dt;
    f[k] = needed;
  }
  return r;
}

TM_FN void tm_drive_sum(tm_drive_result *sum, const tm_drive_result *r)
{
  for (int k = 0; k < 3; k++) sum->force[k] += r->force[k];
  sum->work += r->work;
}

#endif
