/* SPH-TM: particles that sleep.

   Away from the active region a particle that is at rest, with neighbors at rest, keeps its state: the velocity
   gradient is zero, and so are all rates but the acceleration, which is what keeps it at rest in the real body. It is
   asleep: no loop of the step runs over it. Where it is within reach of one that moves it stands at the edge: it is held
   like one that is clamped, and its stress, density and temperature go on. So the work of the stress between the two
   stays exact, and the energy balance closes as with a clamped body. */
#ifndef TM_ACTIVE_H
#define TM_ACTIVE_H

#include "tm_cells.h"
#include "tm_hourglass.h"
#include "tm_state.h"

/* field active; unknown: of new particles, which move */
enum tm_activity { TM_ACTIVE_UNKNOWN = 0, TM_ACTIVE_MOVES = 1, TM_ACTIVE_EDGE = 2, TM_ACTIVE_ASLEEP = 3 };

typedef struct {
  tm_cells cells;      /* of owned and ghost particles; marked: by how many before each entry have the flag */
  const tm_real *flag; /* of owned and ghost particles */
  tm_real least;       /* those with at least this flag are looked for */
  tm_real radius;
  unsigned char *found; /* results, of owned particles */
} tm_active_args;

/* Is there another particle with the flag within the radius? */
TM_FN int tm_active_near(int i, const tm_active_args *a)
{
  const tm_cells *c = &a->cells;
  const double *x = c->x + 3 * (ptrdiff_t) i;
  const tm_real r2 = a->radius * a->radius;
  int begin, end;
  tm_around around = tm_cells_around(c, x);
  while (tm_around_next(&around, c, &begin, &end)) {
    if (c->marked[end] == c->marked[begin]) continue;
    for (int k = begin; k < end; k++) {
      const tm_real dx = x[0] - c->column[0][k], dy = x[1] - c->column[1][k], dz = x[2] - c->column[2][k];
      if (a->flag[c->index[k]] >= a->least && c->index[k] != i && dx * dx + dy * dy + dz * dz < r2) return 1;
    }
  }
  return 0;
}

/* Particle i comes to rest: without velocity and rates. Returns the kinetic energy it had. */
TM_FN tm_real tm_active_rest(int i, const tm_state *s)
{
  double *v = s->v + 3 * (ptrdiff_t) i;
  const tm_real energy = 0.5 * tm_particle_mass(s, i) * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  v[0] = v[1] = v[2] = 0.0;
  tm_real *h = tm_field_row(s, TM_F_HISTORY, i);
  for (int k = 0; k < TM_H_COLUMNS; k++) h[tm_column(k)] = 0.0;
  if (s->field[TM_F_PSTRAIN]) tm_field_row(s, TM_F_PSTRAIN, i)[tm_column(1)] = 0.0;
  for (int k = 1; k < 3; k++) {
    if (s->field[TM_F_TEMP]) tm_field_row(s, TM_F_TEMP, i)[tm_column(k)] = 0.0;
    if (s->field[TM_F_ENERGY]) tm_field_row(s, TM_F_ENERGY, i)[tm_column(k)] = 0.0;
  }
  for (int k = TM_G_RATE; s->field[TM_F_HOURGLASS] && k < TM_G_COLUMNS; k++)
    tm_field_row(s, TM_F_HOURGLASS, i)[tm_column(k)] = 0.0;
  for (int k = TM_K_SPIN; s->field[TM_F_CORRECTION] && k < TM_K_COLUMNS; k++)
    tm_field_row(s, TM_F_CORRECTION, i)[tm_column(k)] = 0.0;
  return energy;
}

#endif
