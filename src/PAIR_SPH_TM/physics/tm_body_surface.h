/* SPH-TM: the smooth surface of a body of particles.

   At a place outside the body, with x = r^2/s^2 of its particles j, s the distance at which two particles touch (one
   spacing), d the dimension and edge_j^(d-1) the area that a particle shows,

     psi = sum_j edge_j^(d-1)/(C s^(d-1)) k(x),   k(x) = exp(-x/b) - exp(-X/b) (1 + (X - x)/b), 0 beyond X

   Over a plane of particles the Gaussian is the product of one along and one across the plane; its sum over a square
   lattice is constant to 2 exp(-pi^2 b) = 5e-4 per direction, at whatever offset. C makes psi = 1 where a particle
   touches a flat face, at g = s from the centers of its first layer; then psi = exp((1 - g^2/s^2)/b'), so that

     penetration delta = s - g = s (1 - sqrt(1 - b' ln psi))

   b' is b but for what the cut at X and the second layer change: it makes |grad delta| = 1 at touch. The surface is
   smooth, its normal is that of psi, and an edge or corner is rounded off by about half a spacing.

   Where the other body has another spacing, s is the mean of both, its layers are edge_j/s apart in place of 1, and
   tm_body_norm() takes the place of C. */
#ifndef TM_BODY_SURFACE_H
#define TM_BODY_SURFACE_H

#include "tm_real.h"

#define TM_BODY_WIDTH 0.845 /* b: a standard deviation of 0.65 spacings, the smoothest surface within the reach */
#define TM_BODY_REACH 2.4   /* sqrt(X), where the support radius of the kernel is not smaller */
#define TM_BODY_DEEP 0.16   /* (g/s)^2 below which delta goes on linearly in psi */

#define TM_BODY_NORMS 32 /* intervals of a table, even */

typedef struct {
  tm_real reach2;                   /* X */
  tm_real edge;                     /* exp(-X/b) */
  tm_real norm;                     /* C */
  tm_real bend;                     /* b' */
  tm_real norms[TM_BODY_NORMS + 1]; /* y C(y), of layers y apart, y = 0 to 2 */
} tm_body_surface;

/* k(x) and -dk/dx. */
TM_FN tm_real tm_body_weight(const tm_body_surface *s, tm_real x)
{
  if (!(x < s->reach2)) return 0.0;
  return exp(-x / TM_BODY_WIDTH) - s->edge * (1.0 + (s->reach2 - x) / TM_BODY_WIDTH);
}
TM_FN tm_real tm_body_fall(const tm_body_surface *s, tm_real x)
{
  if (!(x < s->reach2)) return 0.0;
  return (exp(-x / TM_BODY_WIDTH) - s->edge) / TM_BODY_WIDTH;
}

/* Integrals over a plane at distance g (in s) of k and of -dk/dg. */
TM_FN void tm_body_plane(const tm_body_surface *s, tm_real g, int dim, tm_real *weight, tm_real *fall)
{
  const tm_real b = TM_BODY_WIDTH, y = s->reach2 - g * g, e = exp(-g * g / b);
  *weight = *fall = 0.0;
  if (y <= 0.0) return;
  if (dim == 3) {
    *weight = TM_PI * (b * (e - s->edge) - s->edge * (y + 0.5 * y * y / b));
    *fall = 2.0 * g / b * TM_PI * (b * (e - s->edge) - s->edge * y);
  } else {
    const tm_real r = sqrt(y), line = sqrt(TM_PI * b) * e * erf(sqrt(y / b));
    *weight = line - s->edge * (2.0 * r + 4.0 * r * y / (3.0 * b));
    *fall = 2.0 * g / b * (line - 2.0 * r * s->edge);
  }
}

/* y times the sum over layers at 1, 1 + y, 1 + 2 y ...; of y = 0 the integral. */
TM_FN tm_real tm_body_layers(const tm_body_surface *s, tm_real y, int dim)
{
  const tm_real reach = sqrt(s->reach2), step = y > 0.0 ? y : (reach - 1.0) / 400.0;
  tm_real sum = 0.0, weight, fall;
  for (tm_real g = y > 0.0 ? 1.0 : 1.0 + 0.5 * step; g < reach; g += step) {
    tm_body_plane(s, g, dim, &weight, &fall);
    sum += weight;
  }
  return step * sum;
}

/* For kernels whose support radius is `support` spacings. */
TM_FN tm_body_surface tm_body_surface_make(int dim, tm_real support)
{
  tm_body_surface s;
  const tm_real reach = tm_min(support, TM_BODY_REACH);
  tm_real slope = 0.0;
  s.reach2 = reach * reach;
  s.edge = exp(-s.reach2 / TM_BODY_WIDTH);
  s.norm = 0.0;
  for (int layer = 1; layer < 3; layer++) {
    tm_real weight, fall;
    tm_body_plane(&s, layer, dim, &weight, &fall);
    s.norm += weight;
    slope += fall;
  }
  s.bend = 2.0 * s.norm / slope;
  for (int k = 0; k <= TM_BODY_NORMS; k++) s.norms[k] = tm_body_layers(&s, 2.0 * k / TM_BODY_NORMS, dim);
  return s;
}

/* C for a face of layers y apart, y in (0, 2): the share of s that an edge of the face's body is. */
TM_FN tm_real tm_body_norm(const tm_body_surface *s, tm_real y)
{
  const tm_real at = 0.5 * TM_BODY_NORMS * y;
  const int k = at < TM_BODY_NORMS - 1 ? (int) at : TM_BODY_NORMS - 1;
  return (s->norms[k] + (at - k) * (s->norms[k + 1] - s->norms[k])) / y;
}

/* delta/s and its derivative with respect to psi, negative where psi < 1; psi > 0. */
TM_FN tm_real tm_body_signed_depth(const tm_body_surface *s, tm_real psi, tm_real *rate)
{
  const tm_real q = 1.0 - s->bend * log(psi), deep = TM_BODY_DEEP;
  if (q > deep) {
    *rate = 0.5 * s->bend / (psi * sqrt(q));
    return 1.0 - sqrt(q);
  }
  const tm_real at = exp((1.0 - deep) / s->bend);
  *rate = 0.5 * s->bend / (at * sqrt(deep));
  return 1.0 - sqrt(deep) + *rate * (psi - at);
}

/* The same; 0 without contact. */
TM_FN tm_real tm_body_depth(const tm_body_surface *s, tm_real psi, tm_real *rate)
{
  *rate = 0.0;
  return psi > 1.0 ? tm_body_signed_depth(s, psi, rate) : 0.0;
}

#endif
