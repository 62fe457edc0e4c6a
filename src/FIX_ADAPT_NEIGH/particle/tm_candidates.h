/* SPH-TM: candidate lists: which rows of neighbors are out of date.

   Every particle has a row of all neighbors within its support radius and a skin, from its position at the last
   search of the row. The row is searched anew when a particle near it has moved by half the skin. The rates take what
   is within the search radius, so no result depends on when rows were made.

   Where particles have a size of their own, R = support h, the row of i holds all j with r < (1 + s) max(R_i, R_j), s
   the skin over R. The growth of R_i since then counts as a displacement: as long as displacement and growth of each
   are below s R/2, r + growth < (1 + s) max(R_i, R_j) for all pairs that are within the search radius now. */
#ifndef TM_CANDIDATES_H
#define TM_CANDIDATES_H

#include "tm_search.h"

typedef struct {
  const double *x;      /* owned and ghost */
  double *place;        /* at the last search of its row */
  tm_real skin;         /* skin: a distance; where particles have a size of their own: over their search radius */
  tm_real part;         /* of the skin that a particle may move; negative: all count as moved */
  unsigned char *marks; /* result: has moved; place is then set to x. NULL: place is not changed */
  /* particles with a size of their own */
  const tm_real *size; /* records of size, or NULL: all have the same radius */
  tm_real support;     /* support radius over h */
  tm_real *radius;     /* of each, skin included; set together with place */
} tm_moved_args;

TM_FN int tm_moved(int i, const tm_moved_args *a)
{
  const double *x = a->x + 3 * (ptrdiff_t) i;
  double *p = a->place + 3 * (ptrdiff_t) i;
  const tm_real dx = x[0] - p[0], dy = x[1] - p[1], dz = x[2] - p[2];
  tm_real limit = a->part * a->skin, radius = 0.0;
  if (a->size) {
    const tm_real then = a->radius[i] / (1.0 + a->skin);
    radius = a->support / a->size[(ptrdiff_t) i * TM_REC_SIZE + TM_SIZE_INV_H];
    limit = limit * then - tm_max(radius - then, 0.0);
  }
  const int moved = a->part < 0.0 || limit < 0.0 || !(dx * dx + dy * dy + dz * dz <= limit * limit);
  if (!a->marks) return moved;
  a->marks[i] = (unsigned char) moved;
  for (int d = 0; moved && d < 3; d++) p[d] = x[d];
  if (moved && a->size) a->radius[i] = (1.0 + a->skin) * radius;
  return moved;
}

typedef struct {
  tm_cells cells;       /* with the number of moved particles up to each, see tm_cells.h */
  unsigned char *dirty; /* result: 1 for rows to be searched */
} tm_near_moved_args;

/* Has a particle in the cells around i moved? */
TM_FN int tm_near_moved(int i, const tm_near_moved_args *a)
{
  tm_around around = tm_cells_around(&a->cells, a->cells.x + 3 * (ptrdiff_t) i);
  int begin, end;
  while (tm_around_next(&around, &a->cells, &begin, &end)) {
    if (a->cells.marked[begin] != a->cells.marked[end]) {
      a->dirty[i] = 1;
      return 1;
    }
  }
  return 0;
}

#endif
