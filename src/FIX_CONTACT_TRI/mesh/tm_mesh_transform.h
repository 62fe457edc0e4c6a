/* SPH-TM: placing a mesh before it is built: scale, move and rotate in the order they are written,
   about the origin (LIGGGHTS's rule: `move 1 0 0 scale 2` ends 2 away). A mirroring scale (an odd
   number of negative factors) turns the facets round so that normals stay outward. */
#ifndef TM_MESH_TRANSFORM_H
#define TM_MESH_TRANSFORM_H

#include "tm_mesh.h"
#include "tm_motion.h"

TM_FN void tm_soup_scale(tm_soup *soup, tm_real sx, tm_real sy, tm_real sz)
{
  const tm_real s[3] = {sx, sy, sz};
  for (ptrdiff_t i = 0; i < 9 * (ptrdiff_t) soup->n; i++) soup->corner[i] *= s[i % 3];
  if (soup->normal) /* normals go with the inverse; only their direction is used */
    for (ptrdiff_t i = 0; i < 3 * (ptrdiff_t) soup->n; i++) soup->normal[i] /= s[i % 3];
  if (sx * sy * sz < 0.0)
    for (ptrdiff_t t = 0; t < soup->n; t++)
      for (int d = 0; d < 3; d++) {
        double *b = soup->corner + 9 * t + 3 + d;
        const double x = b[0];
        b[0] = b[3];
        b[3] = x;
      }
}

TM_FN void tm_soup_move(tm_soup *soup, tm_vec3 by)
{
  for (ptrdiff_t c = 0; c < 3 * (ptrdiff_t) soup->n; c++) {
    soup->corner[3 * c] += by.x;
    soup->corner[3 * c + 1] += by.y;
    soup->corner[3 * c + 2] += by.z;
  }
}

/* Right-handed, about the axis through the origin. */
TM_FN void tm_soup_rotate(tm_soup *soup, tm_vec3 axis, tm_real degrees)
{
  const tm_mat3 r = tm_rotation_about(axis, degrees * TM_PI / 180.0);
  for (ptrdiff_t c = 0; c < (soup->normal ? 4 : 3) * (ptrdiff_t) soup->n; c++) {
    double *p = c < 3 * (ptrdiff_t) soup->n ? soup->corner + 3 * c : soup->normal + 3 * (c - 3 * (ptrdiff_t) soup->n);
    const tm_vec3 q = tm_mat_mul_vec(r, tm_load3(p));
    p[0] = q.x;
    p[1] = q.y;
    p[2] = q.z;
  }
}

#endif
