/* SPH-TM: what the contact loop sees of a triangle mesh: raw pointers, host or device.

   Half-edge h = 3 t + k runs from vertex k to vertex (k+1) % 3 of triangle t. Triangles that share
   an edge form a ring through `twin`: one other half-edge on a manifold edge, -1 on an open one,
   a cycle of three or more where sheets meet. */
#ifndef TM_TRI_VIEW_H
#define TM_TRI_VIEW_H

#include "tm_tensor.h"

typedef struct {
  int nv, nt, npatch;
  const double *vertex;        /* 3 nv */
  const double *corner;        /* 9 nt: the three vertices of each triangle once more */
  const double *normal;        /* 3 nt: unit face normals, outward */
  const double *ball;          /* 4 nt: center and radius of a sphere around each triangle */
  const int *tri;              /* 3 nt: vertex indices */
  const int *twin;             /* 3 nt: next half-edge of the ring, or -1 */
  const int *patch;            /* nt: smooth patch of the triangle */
  const double *edge_normal;   /* 9 nt: pseudo-normal of each half-edge, zero on open edges */
  const double *vertex_normal; /* 3 nv: angle-weighted pseudo-normal, zero on open rims */
  const int *spoke_first;      /* nv + 1: edges that leave a vertex where patches meet ... */
  const int *spoke;            /* ... as the vertices at their other ends */
} tm_tri_view;

#endif
