/* SPH-TM: particles sorted into the cells of a grid, for the search of neighbours.

   Cells are cubes at least as wide as the largest reach, x fastest, so that the neighbours of a
   particle stand in 9 (2D: 3) runs of three cells. Particles beyond the grid count to its outermost
   cells: that brings nobody further from each other. */
#ifndef TM_CELLS_H
#define TM_CELLS_H

#include "tm_lanes.h"

typedef struct {
  tm_real lo[3], inv_width[3];
  int cells[3];
  int n;                    /* particles, owned and ghost */
  const double *x;          /* 3 of each */
  const tm_real *reach;     /* of each, or NULL: all the same */
  /* results */
  int *cell;                /* of each particle */
  int *begin;               /* of each cell, and the end of the last */
  int *index;               /* particles in order of cells, TM_COLUMN more entries than n */
  int *marked;              /* how many before each entry of the order are marked; or NULL */
  tm_real *column[4];       /* x y z of these, and their reach where each has its own; as long */
} tm_cells;

TM_FN int tm_cells_of_axis(const tm_cells *c, int axis, double x)
{
  const tm_real k = (x - c->lo[axis]) * c->inv_width[axis];
  return (int) tm_clamp(k, 0.0, c->cells[axis] - 1);    /* not a number: 0 */
}
TM_FN int tm_cells_number(const tm_cells *c) { return c->cells[0] * c->cells[1] * c->cells[2]; }
TM_FN int tm_cells_of(const tm_cells *c, const double *x)
{
  return (tm_cells_of_axis(c, 2, x[2]) * c->cells[1] + tm_cells_of_axis(c, 1, x[1])) * c->cells[0]
       + tm_cells_of_axis(c, 0, x[0]);
}

/* Particle i into place k of the order. */
TM_FN void tm_cells_put(const tm_cells *c, int i, int k)
{
  c->index[k] = i;
  for (int d = 0; d < 3; d++) c->column[d][k] = c->x[3 * (ptrdiff_t) i + d];
  if (c->reach) c->column[3][k] = c->reach[i];
}

typedef struct {
  tm_real lo[3], hi[3];
} tm_bounds;

TM_FN tm_bounds tm_bounds_nothing(void)
{
  tm_bounds b;
  for (int d = 0; d < 3; d++) {
    b.lo[d] = 1e300;
    b.hi[d] = -1e300;
  }
  return b;
}
TM_FN tm_bounds tm_bounds_of(const double *x)
{
  tm_bounds b;
  for (int d = 0; d < 3; d++) b.lo[d] = b.hi[d] = x[d];
  return b;
}
TM_FN void tm_bounds_sum(tm_bounds *sum, const tm_bounds *b)
{
  for (int d = 0; d < 3; d++) {
    sum->lo[d] = tm_min(sum->lo[d], b->lo[d]);
    sum->hi[d] = tm_max(sum->hi[d], b->hi[d]);
  }
}

/* The grid of b for the given reach, at most `most` cells, which are made wider for that. */
TM_FN void tm_cells_make(tm_cells *c, tm_bounds b, tm_real reach, int dim3, int most)
{
  for (tm_real width = reach;; width *= 1.26) {
    double number = 1.0;
    for (int d = 0; d < 3; d++) {
      const tm_real side = b.hi[d] > b.lo[d] ? b.hi[d] - b.lo[d] : 0.0;
      const tm_real k = tm_clamp(d == 2 && !dim3 ? 1.0 : side / width, 1.0, 1e6);
      c->cells[d] = (int) k;
      c->lo[d] = b.hi[d] > b.lo[d] ? b.lo[d] : 0.0;
      c->inv_width[d] = side > 0.0 ? c->cells[d] / tm_max(side, width * c->cells[d]) : 0.0;
      number *= c->cells[d];
    }
    if (number <= most || !(width < 1e300)) return;
  }
}

#endif
