/* SPH-TM: the state of a few particles with every field, for the tests. All values 0, type 1, group bit 1, mass 2. */
#ifndef UT_STATE_H
#define UT_STATE_H

#include "tm_state.h"
#include "ut.h"

#include <string.h>

enum { UT_ROOM = 64 };

typedef struct {
  tm_state state;
  double x[3 * UT_ROOM], v[3 * UT_ROOM], force[3 * UT_ROOM];
  double field[TM_F_COUNT][TM_H_COLUMNS * UT_ROOM];
  int type[UT_ROOM], mask[UT_ROOM];
  double mass[4];
  tm_material material[4];
} ut_particles;

static inline void ut_particles_make(ut_particles *p)
{
  memset(p, 0, sizeof *p);
  for (int i = 0; i < UT_ROOM; i++) p->type[i] = p->mask[i] = 1;
  for (int t = 0; t < 4; t++) {
    p->mass[t] = 2.0 * t;
    p->material[t].rho0 = 10.0 * t;
  }
  for (int id = 0; id < TM_F_COUNT; id++) p->state.field[id] = p->field[id];
  p->state.x = p->x;
  p->state.v = p->v;
  p->state.force = p->force;
  p->state.type = p->type;
  p->state.mask = p->mask;
  p->state.material = p->material;
  p->state.mass = p->mass;
}

#endif
