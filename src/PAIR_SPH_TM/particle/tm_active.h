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

/* flags of particles and their ghosts: at rest; to be active; so fast that those within reach are active too */
enum tm_wakefulness { TM_RESTS = 0, TM_AWAKE = 1, TM_MOVING = 2 };

/* The box about a tool, which turns with it, now. */
typedef struct {
  tm_vec3 origin, axis[3]; /* of the frame of lo and hi */
  tm_real lo[3], hi[3];
  tm_real top_speed; /* of the points of the tool */
} tm_tool_box;

/* Is a point within a distance of the box? In two dimensions of its section. */
TM_FN int tm_tool_box_near(const tm_tool_box *b, const double *x, tm_real distance, int dimension)
{
  const tm_vec3 from = tm_vec_sub(tm_load3(x), b->origin);
  tm_real away2 = 0.0;
  for (int d = 0; d < dimension; d++) {
    const tm_real at = tm_vec_dot(b->axis[d], from);
    const tm_real away = tm_max(tm_max(b->lo[d] - at, at - b->hi[d]), 0.0);
    away2 += away * away;
  }
  return away2 < distance * distance;
}

typedef struct {
  tm_state state;
  /* who is active for its own sake */
  const int *inside;       /* the region, or NULL */
  const tm_tool_box *tool; /* so many */
  int tools, dimension;
  tm_real from_tool; /* distance from a tool */
  tm_real still2;    /* square of the speed from which on a particle moves */
  /* who is for that of its neighbors */
  tm_real *flag;        /* of owned and ghost particles: enum tm_wakefulness */
  tm_real least;        /* those with at least this flag are looked for */
  unsigned char *marks; /* of owned and ghost particles: has it */
  tm_cells cells;       /* of these; marked: how many before each entry */
  tm_real radius;
} tm_active_args;

/* The flag of particle i, but for its neighbors. */
TM_FN tm_real tm_active_flag(int i, const tm_active_args *a)
{
  const double *x = a->state.x + 3 * (ptrdiff_t) i, *v = a->state.v + 3 * (ptrdiff_t) i;
  if (v[0] * v[0] + v[1] * v[1] + v[2] * v[2] >= a->still2) return TM_MOVING;
  if (a->state.material[a->state.type[i]].body != TM_BODY_SOLID) return TM_AWAKE;
  if (a->inside && a->inside[i]) return TM_AWAKE;
  for (int k = 0; k < a->tools; k++)
    if (tm_tool_box_near(a->tool + k, x, a->from_tool, a->dimension)) return TM_AWAKE;
  return TM_RESTS;
}

/* Is there another particle that is marked within the radius? */
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
      if (a->marks[c->index[k]] && c->index[k] != i && dx * dx + dy * dy + dz * dz < r2) return 1;
    }
  }
  return 0;
}

/* A particle near one that moves is active; other flags stay. */
TM_FN void tm_active_wake(int i, const tm_active_args *a)
{
  if ((int) a->flag[i] < TM_AWAKE && tm_active_near(i, a)) a->flag[i] = TM_AWAKE;
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

/* The kind of particle i, where those that are active are marked. Returns the kinetic energy it loses. */
TM_FN tm_real tm_active_sort(int i, const tm_active_args *a)
{
  const double *v = a->state.v + 3 * (ptrdiff_t) i;
  tm_real *kind = tm_field_row(&a->state, TM_F_ACTIVE, i);
  const int now = (int) a->flag[i] > TM_RESTS ? TM_ACTIVE_MOVES
                  : tm_active_near(i, a)      ? TM_ACTIVE_EDGE
                                              : TM_ACTIVE_ASLEEP;
  const int before = (int) *kind;
  *kind = now;
  if (now == TM_ACTIVE_MOVES) return 0.0;
  if (now == before && v[0] == 0.0 && v[1] == 0.0 && v[2] == 0.0) return 0.0;
  return tm_active_rest(i, &a->state);
}

/* A particle at the edge stays. */
TM_FN void tm_active_hold(int i, double *force)
{
  for (int d = 0; d < 3; d++) force[3 * (ptrdiff_t) i + d] = 0.0;
}

/* No heat is conducted into a particle that sleeps. */
TM_FN void tm_active_insulate(int i, const tm_state *s, const tm_records *rec)
{
  if ((int) *tm_field_row(s, TM_F_ACTIVE, i) == TM_ACTIVE_ASLEEP) tm_heat_record(rec, i)[tm_part(TM_REC_K)] = 0.0;
}

#endif
