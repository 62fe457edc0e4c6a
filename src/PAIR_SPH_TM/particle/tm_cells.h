/* SPH-TM: particles sorted into the cells of a grid, for the search of neighbors.

   Cells are cubes, x fastest; particles of cells that are neighbors in x follow one another in the order. Particles
   beyond the grid are put into its outermost cells, which are searched all the same.

   Where all have one search radius cells are at least as wide, and the neighbors of a particle are in 9 (2D: 3) runs of
   three cells. Where each has its own, cells may be narrower. Each cell has a search radius for its particles: the
   largest search radius of those in it, and of those in other cells that reach it. So a small particle among small ones
   searches a few small cells. */
#ifndef TM_CELLS_H
#define TM_CELLS_H

#include "tm_lanes.h"

/* Search radii over reaches: no pair is lost to rounding. */
#define TM_CELLS_SPARE (1.0 + 1e-9)

typedef struct {
  tm_real lo[3], width[3], inv_width[3];
  tm_real widest; /* the largest search radius */
  int cells[3];
  int n;                 /* particles, owned and ghost */
  const double *x;       /* 3 of each */
  const tm_real *radius; /* of each, or NULL: all the same */
  /* results */
  int *cell;          /* of each particle */
  int *begin;         /* of each cell, and the end of the last */
  int *index;         /* particles in order of cells, TM_COLUMN more entries than n */
  int *marked;        /* how many before each entry of the order are marked; or NULL */
  tm_real *column[4]; /* x y z of these, and their search radius where each has its own; as long */
  tm_real *look[2];   /* with a radius of each: search radius of the particles in a cell, and scratch */
} tm_cells;

TM_FN int tm_cells_of_axis(const tm_cells *c, int axis, double x)
{
  const tm_real k = (x - c->lo[axis]) * c->inv_width[axis];
  return (int) tm_clamp(k, 0.0, c->cells[axis] - 1); /* not a number: 0 */
}
TM_FN int tm_cells_number(const tm_cells *c) { return c->cells[0] * c->cells[1] * c->cells[2]; }
TM_FN int tm_cells_of(const tm_cells *c, const double *x)
{
  return (tm_cells_of_axis(c, 2, x[2]) * c->cells[1] + tm_cells_of_axis(c, 1, x[1])) * c->cells[0] +
         tm_cells_of_axis(c, 0, x[0]);
}

/* Particle i into place k of the order. */
TM_FN void tm_cells_put(const tm_cells *c, int i, int k)
{
  c->index[k] = i;
  for (int d = 0; d < 3; d++) c->column[d][k] = c->x[3 * (ptrdiff_t) i + d];
  if (c->radius) c->column[3][k] = c->radius[i];
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

/* The grid of b for reaches up to the given one, with cells of a width of at least `least`; at most `most` cells, which
   are made wider for that. */
TM_FN void tm_cells_make(tm_cells *c, tm_bounds b, tm_real radius, tm_real least, int dim3, int most)
{
  c->widest = TM_CELLS_SPARE * radius;
  for (tm_real width = least;; width *= 1.26) {
    double number = 1.0;
    for (int d = 0; d < 3; d++) {
      const tm_real side = b.hi[d] > b.lo[d] ? b.hi[d] - b.lo[d] : 0.0;
      const tm_real k = tm_clamp(d == 2 && !dim3 ? 1.0 : side / width, 1.0, 1e6);
      c->cells[d] = (int) k;
      c->lo[d] = b.hi[d] > b.lo[d] ? b.lo[d] : 0.0;
      c->width[d] = tm_max(side, width * c->cells[d]) / c->cells[d];
      c->inv_width[d] = side > 0.0 ? 1.0 / c->width[d] : 0.0;
      number *= c->cells[d];
    }
    if (number <= most || !(width < 1e300)) return;
  }
}

/* ---- search radii of cells */

/* The largest search radius in a cell. */
TM_FN tm_real tm_cells_radius(const tm_cells *c, int cell)
{
  tm_real most = 0.0;
  for (int k = c->begin[cell]; k < c->begin[cell + 1]; k++) most = tm_max(most, c->column[3][k]);
  return TM_CELLS_SPARE * most;
}

/* The largest of the search radii in a line of cells along an axis that reach this one. Taken along x, then y, then z it is
   the largest of all within a cube. */
TM_FN tm_real tm_cells_look(const tm_cells *c, int cell, int axis, const tm_real *radius)
{
  const int step = axis == 0 ? 1 : axis == 1 ? c->cells[0] : c->cells[0] * c->cells[1];
  const int at = cell / step % c->cells[axis];
  tm_real most = radius[cell];
  for (int k = 1; (k - 1) * c->width[axis] < c->widest && (at >= k || at + k < c->cells[axis]); k++) {
    const tm_real gap = (k - 1) * c->width[axis];
    if (at >= k && radius[cell - k * step] > gap) most = tm_max(most, radius[cell - k * step]);
    if (at + k < c->cells[axis] && radius[cell + k * step] > gap) most = tm_max(most, radius[cell + k * step]);
  }
  return most;
}

/* ---- the cells around a place, run by run */

typedef struct {
  int lo[3], hi[3]; /* cells along each axis */
  int y, z;         /* of the run that comes next */
} tm_around;

TM_FN tm_around tm_cells_around(const tm_cells *c, const double *x)
{
  tm_around a;
  int at[3];
  for (int d = 0; d < 3; d++) at[d] = tm_cells_of_axis(c, d, x[d]);
  const tm_real look = c->radius ? c->look[0][(at[2] * c->cells[1] + at[1]) * c->cells[0] + at[0]] : 0.0;
  for (int d = 0; d < 3; d++) {
    if (c->radius) {
      a.lo[d] = tm_cells_of_axis(c, d, x[d] - look);
      a.hi[d] = tm_cells_of_axis(c, d, x[d] + look);
    } else {
      a.lo[d] = at[d] > 0 ? at[d] - 1 : 0;
      a.hi[d] = at[d] + 1 < c->cells[d] ? at[d] + 1 : at[d];
    }
  }
  a.y = a.lo[1];
  a.z = a.lo[2];
  return a;
}

/* The next run: its first and last entry of the order. 0: there is none. */
TM_FN int tm_around_next(tm_around *a, const tm_cells *c, int *begin, int *end)
{
  if (a->z > a->hi[2]) return 0;
  const int row = (a->z * c->cells[1] + a->y) * c->cells[0];
  *begin = c->begin[row + a->lo[0]];
  *end = c->begin[row + a->hi[0] + 1];
  if (++a->y > a->hi[1]) {
    a->y = a->lo[1];
    a->z++;
  }
  return 1;
}

#endif
