/* SPH-TM: is a point inside a closed mesh, however deep?

   The winding number is the solid angle under which the mesh is seen, over 4 pi: 1 inside and 0
   outside of a closed mesh with normals outward, whatever the triangles are like. The solid angle
   of one triangle is that of van Oosterom and Strackee (1983). It takes every triangle: for checks
   at the start, not for the loop. */
#ifndef TM_WINDING_H
#define TM_WINDING_H

#include "tm_tri_view.h"

/* Solid angle of the triangle with these corners (9) from p. */
TM_FN tm_real tm_winding_angle(const double *q, tm_vec3 p)
{
  const tm_vec3 a = tm_vec_sub(tm_load3(q), p), b = tm_vec_sub(tm_load3(q + 3), p);
  const tm_vec3 c = tm_vec_sub(tm_load3(q + 6), p);
  const tm_real la = tm_vec_norm(a), lb = tm_vec_norm(b), lc = tm_vec_norm(c);
  return 2.0 * atan2(tm_vec_dot(a, tm_vec_cross(b, c)),
                     la * lb * lc + tm_vec_dot(a, b) * lc + tm_vec_dot(b, c) * la + tm_vec_dot(c, a) * lb);
}

TM_FN tm_real tm_winding_number(const tm_tri_view *m, tm_vec3 p)
{
  tm_real sum = 0.0;
  for (ptrdiff_t t = 0; t < m->nt; t++) sum += tm_winding_angle(m->corner + 9 * t, p);
  return sum / (4.0 * TM_PI);
}

/* In the solid of a closed mesh; one with its normals inward is solid outside. */
TM_FN int tm_winding_inside(const tm_tri_view *m, tm_real volume, tm_vec3 p)
{
  return tm_winding_number(m, p) + (volume < 0.0 ? 1.0 : 0.0) > 0.5;
}

#endif
