/* SPH-TM: the first half of a step moves one particle to the half step,

     x(n+1/2) = x(n) + dt/2 (v(n) + XSPH velocity),

   and tells whether it has left the box through a face that lets nothing out. */
#ifndef TM_DRIFT_H
#define TM_DRIFT_H

#include "tm_state.h"

typedef struct {
  tm_state state;
  int group;           /* x is integrated for these */
  tm_real half;        /* dt/2 */
  int closed[3][2];    /* nonzero: a particle beyond this face of the box is lost */
  double lo[3], hi[3]; /* of the box */
} tm_drift_args;

/* Nonzero: the particle is lost. */
TM_FN int tm_drift(int i, const tm_drift_args *a, unsigned effects)
{
  effects &= TM_FX_PRESENT;
  const tm_state *s = &a->state;
  const int dim = (effects & TM_FX_3D) ? 3 : 2;
  double *x = s->x + 3 * (ptrdiff_t) i;
  if (s->mask[i] & a->group) {
    const double *v = s->v + 3 * (ptrdiff_t) i;
    const tm_real *u = (effects & TM_FX_XSPH) ? tm_field_row(s, TM_F_XSPH, i) : NULL;
    for (int d = 0; d < dim; d++) x[d] += a->half * (v[d] + (u ? u[tm_column(d)] : 0.0));
  }
  int lost = 0;
  for (int d = 0; d < dim; d++) lost |= (a->closed[d][0] && x[d] < a->lo[d]) || (a->closed[d][1] && x[d] > a->hi[d]);
  return lost;
}

#endif
