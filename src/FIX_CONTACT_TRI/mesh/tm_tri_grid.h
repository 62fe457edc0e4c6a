/* SPH-TM: broad phase. Which triangles can lie within a search radius of a point?

   Cubic cells in the mesh's own frame; each cell lists every triangle within that radius of any of its
   points, so one look-up answers a query and triangles far away cost nothing. Cells are kept in
   blocks of 4^3, and only blocks that some triangle comes near exist: a dense table of block
   numbers (-1: empty), then cells, then the lists. The list of a cell is cut into segments, one per
   smooth patch, and each segment is sorted by distance from the center of the cell: once that
   distance, less the way from the center to the query point, exceeds the best found, the rest of
   the segment is out. So a finely tessellated patch costs little more than a coarse one. Built
   once; rigid motion moves the query point into the mesh's frame. All arrays are plain and can be
   copied to a device as they are. */
#ifndef TM_TRI_GRID_H
#define TM_TRI_GRID_H

#include "tm_mesh.h"

#define TM_GRID_SHIFT 2 /* cells per block edge: 4 */
#define TM_GRID_EDGE (1 << TM_GRID_SHIFT)
#define TM_GRID_CELLS (TM_GRID_EDGE * TM_GRID_EDGE * TM_GRID_EDGE)

typedef struct {
  tm_real lo[3];          /* corner of the grid */
  tm_real cell, inv_cell; /* cell edge, 1 / cell edge */
  tm_real radius;         /* lists are complete up to this distance */
  int blocks[3];          /* extent in blocks */
  const int *block;       /* number of an existing block, or -1 */
  const int *first;       /* TM_GRID_CELLS per block, + 1: where the segments of a cell begin */
  const int *segment;     /* where the list of a segment begins, + 1 */
  const int *list;        /* triangle indices */
  const float *near;      /* of each, a lower bound of its distance from the center of the cell */
} tm_grid_view;

/* Cell that holds p, or -1 where no triangle is near; *away: distance of p from its center. */
TM_FN ptrdiff_t tm_grid_cell(const tm_grid_view *g, tm_vec3 p, tm_real *away)
{
  const tm_real s[3] = {(p.x - g->lo[0]) * g->inv_cell, (p.y - g->lo[1]) * g->inv_cell, (p.z - g->lo[2]) * g->inv_cell};
  *away = 0.0;
  for (int d = 0; d < 3; d++) /* written so that NaN is outside */
    if (!(s[d] >= 0.0 && s[d] < (tm_real) (g->blocks[d] * TM_GRID_EDGE))) return -1;
  const int i = (int) s[0], j = (int) s[1], k = (int) s[2];
  const int b = g->block[((ptrdiff_t) (k >> TM_GRID_SHIFT) * g->blocks[1] + (j >> TM_GRID_SHIFT)) * g->blocks[0] +
                         (i >> TM_GRID_SHIFT)];
  if (b < 0) return -1;
  const tm_vec3 d = tm_vec(s[0] - i - 0.5, s[1] - j - 0.5, s[2] - k - 0.5);
  *away = g->cell * tm_vec_norm(d);
  const int m = TM_GRID_EDGE - 1;
  return (ptrdiff_t) b * TM_GRID_CELLS + ((((k & m) << TM_GRID_SHIFT) + (j & m)) << TM_GRID_SHIFT) + (i & m);
}

/* The whole list of the cell that holds p: *n triangles, indices returned; n = 0 far away. */
TM_FN const int *tm_grid_query(const tm_grid_view *g, tm_vec3 p, int *n)
{
  tm_real away;
  const ptrdiff_t c = tm_grid_cell(g, p, &away);
  *n = 0;
  if (c < 0) return g->list;
  const int begin = g->segment[g->first[c]];
  *n = g->segment[g->first[c + 1]] - begin;
  return g->list + begin;
}

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
  tm_grid_view view; /* points into the arrays below */
  int *block, *first, *segment, *list;
  float *near;
  double cell;       /* cell edge: the search radius, or more where memory would exceed the budget */
  int nblocks;       /* existing blocks */
  ptrdiff_t entries; /* triangles in all lists */
} tm_tri_grid;

/* Most list entries (and half as many blocks' cells) before cells are made larger. */
#define TM_GRID_BUDGET 8000000.0

/* 0, or TM_MESH_TOO_LARGE without memory. */
int tm_tri_grid_build(tm_tri_grid *grid, const tm_mesh *mesh, double radius, double budget);
void tm_tri_grid_free(tm_tri_grid *grid);

#ifdef __cplusplus
}
#endif

#endif
