/* SPH-TM: closest point of a triangle.

   The query point is inside the prism over the triangle when it lies on the inner side of the three
   planes through the edges that hold the face normal; then its projection is the answer. Else the
   answer lies on an edge, and each edge is a segment with one clamped parameter. Nothing is divided
   by a quantity that vanishes with the area, so needles of aspect 1e4 lose no more digits than
   their normal has. */
#ifndef TM_CLOSEST_H
#define TM_CLOSEST_H

#include "tm_tri_view.h"

/* Feature codes: the face, edge k from vertex k to k + 1, vertex k. */
enum tm_feature {
  TM_FACE = 0,
  TM_EDGE_0 = 1,
  TM_EDGE_1 = 2,
  TM_EDGE_2 = 3,
  TM_VERTEX_0 = 4,
  TM_VERTEX_1 = 5,
  TM_VERTEX_2 = 6
};

typedef struct {
  tm_vec3 point; /* closest point */
  tm_real dist2; /* squared distance */
  int feature;   /* enum tm_feature */
} tm_closest;

/* Closest point of the edge from a (vertex k) to b, as a candidate of its triangle. */
TM_FN tm_closest tm_closest_on_edge(tm_vec3 p, tm_vec3 a, tm_vec3 b, int k)
{
  const tm_vec3 e = tm_vec_sub(b, a);
  const tm_real s = tm_vec_dot(tm_vec_sub(p, a), e), ee = tm_vec_dot(e, e);
  tm_closest c;
  if (!(s > 0.0)) {
    c.point = a;
    c.feature = TM_VERTEX_0 + k;
  } else if (s >= ee) {
    c.point = b;
    c.feature = TM_VERTEX_0 + (k == 2 ? 0 : k + 1);
  } else {
    /* from the nearer end: exact where it matters on long edges */
    const tm_real t = s / ee;
    c.point = t < 0.5 ? tm_vec_axpy(a, t, e) : tm_vec_axpy(b, t - 1.0, e);
    c.feature = TM_EDGE_0 + k;
  }
  const tm_vec3 d = tm_vec_sub(p, c.point);
  c.dist2 = tm_vec_dot(d, d);
  return c;
}

/* Triangle abc with unit normal n. */
TM_FN tm_closest tm_closest_on_triangle(tm_vec3 p, tm_vec3 a, tm_vec3 b, tm_vec3 c, tm_vec3 n)
{
  const tm_vec3 pa = tm_vec_sub(p, a), pb = tm_vec_sub(p, b), pc = tm_vec_sub(p, c);
  /* side of each edge, times its length */
  const tm_real ab = tm_vec_dot(n, tm_vec_cross(tm_vec_sub(b, a), pa));
  const tm_real bc = tm_vec_dot(n, tm_vec_cross(tm_vec_sub(c, b), pb));
  const tm_real ca = tm_vec_dot(n, tm_vec_cross(tm_vec_sub(a, c), pc));
  tm_closest best;
  if (ab > 0.0 && bc > 0.0 && ca > 0.0) {
    const tm_real h = tm_vec_dot(n, pa);
    best.point = tm_vec_axpy(p, -h, n);
    best.dist2 = h * h;
    best.feature = TM_FACE;
    return best;
  }
  best = tm_closest_on_edge(p, a, b, 0);
  const tm_closest on_bc = tm_closest_on_edge(p, b, c, 1);
  if (on_bc.dist2 < best.dist2) best = on_bc;
  const tm_closest on_ca = tm_closest_on_edge(p, c, a, 2);
  if (on_ca.dist2 < best.dist2) best = on_ca;
  return best;
}

/* Triangle t of a mesh. */
TM_FN tm_closest tm_closest_on_facet(tm_vec3 p, const tm_tri_view *m, int t)
{
  const double *c = m->corner + 9 * (ptrdiff_t) t;
  return tm_closest_on_triangle(p, tm_load3(c), tm_load3(c + 3), tm_load3(c + 6),
                                tm_load3(m->normal + 3 * (ptrdiff_t) t));
}

#endif
