/* SPH-TM: area of the free surface that a particle carries.

   n = sum_j m_j/rho_j gradW points into the body, and 2 V |n| summed over the layers below a flat
   face is the area of the face, but for the lattice factor of tm_lattice.h. Disorder makes |n| of
   the interior differ from 0, so a particle counts only with a share of the |n| of a flat face's
   first layer, the threshold; what the layers left out would have carried is added to the others,
   so that a flat face is exact. Edges and corners are rounded off: with h = 1.2 spacings a cube of N
   particles a side comes out 1.7/N too small, a square 0.9/N. */
#ifndef TM_SURFACE_H
#define TM_SURFACE_H

#include "tm_lattice.h"
#include "tm_tensor.h"

/* An interior moved by a tenth of a spacing at random reaches 0.4 at h = 1.2 spacings. */
#define TM_SURFACE_THRESHOLD 0.5

typedef struct {
  tm_real least; /* |n| below which a particle is interior */
  tm_real scale; /* area = scale V |n| */
} tm_surface;

TM_FN tm_surface tm_surface_make(int kernel, int dim, tm_real spacing, tm_real h, tm_real threshold)
{
  const tm_real ratio = h / spacing, least = threshold * tm_lattice_face_normal(kernel, dim, ratio);
  const tm_real gradient = tm_lattice_sums(kernel, dim, ratio).gradient;
  tm_surface s;
  s.least = 0.5 * least / (spacing * gradient);
  s.scale = 2.0 * gradient / tm_lattice_face_sum(kernel, dim, ratio, least);
  return s;
}

TM_FN tm_real tm_surface_area(const tm_surface *s, tm_vec3 n, tm_real volume)
{
  const tm_real size = tm_vec_norm(n);
  return size >= s->least ? s->scale * volume * size : 0.0;
}

/* The part that faces the unit vector d: the area projected on the plane across d. */
TM_FN tm_real tm_surface_area_facing(const tm_surface *s, tm_vec3 n, tm_real volume, tm_vec3 d)
{
  return tm_vec_norm(n) >= s->least ? s->scale * volume * tm_max(-tm_vec_dot(n, d), 0.0) : 0.0;
}

#endif
