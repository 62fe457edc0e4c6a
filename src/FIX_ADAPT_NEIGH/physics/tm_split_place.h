/* SPH-TM: where children come to lie next to a surface.

   A pattern has corners in fixed directions. Next to a surface that is not square to them its children would
   reach farther than the parent did, and the contact, which knows particles as spheres, would do work on them
   that nothing has paid for. There the pattern is turned, by the least angle, so that one of its axes is the
   normal, and scaled along the normal so that the outermost children reach exactly as far as the parent.
   With square and cube their force on a plane and the energy of its springs are then those of the parent, see
   tm_contact.h. Places stay symmetric about the parent: momenta do not change. */
#ifndef TM_SPLIT_PLACE_H
#define TM_SPLIT_PLACE_H

#include "tm_tensor.h"

TM_FN tm_vec3 tm_split_place(const double *place, int k)
{
  return tm_vec(place[3 * k], place[3 * k + 1], place[3 * k + 2]);
}
TM_FN void tm_split_put(double *place, int k, tm_vec3 x)
{
  place[3 * k] = x.x;
  place[3 * k + 1] = x.y;
  place[3 * k + 2] = x.z;
}

/* x turned by the least rotation that takes unit vector a to unit vector b; a.b > -1. */
TM_FN tm_vec3 tm_turn_from_to(tm_vec3 x, tm_vec3 a, tm_vec3 b)
{
  const tm_vec3 axis = tm_vec_cross(a, b), first = tm_vec_cross(axis, x);
  return tm_vec_axpy(tm_vec_add(x, first), 1.0 / (1.0 + tm_vec_dot(a, b)), tm_vec_cross(axis, first));
}

/* The direction +-x, +-y, +-z nearest to n. */
TM_FN tm_vec3 tm_nearest_axis(tm_vec3 n)
{
  const tm_real x = fabs(n.x), y = fabs(n.y), z = fabs(n.z);
  if (x >= y && x >= z) return tm_vec(n.x > 0.0 ? 1.0 : -1.0, 0.0, 0.0);
  return y >= z ? tm_vec(0.0, n.y > 0.0 ? 1.0 : -1.0, 0.0) : tm_vec(0.0, 0.0, n.z > 0.0 ? 1.0 : -1.0);
}

/* Turns the n places (x, y, z each) so that an axis becomes the normal. */
TM_FN void tm_split_turn(double *place, int n, tm_vec3 normal)
{
  const tm_vec3 axis = tm_nearest_axis(normal);
  for (int k = 0; k < n; k++) tm_split_put(place, k, tm_turn_from_to(tm_split_place(place, k), axis, normal));
}

/* The factor of the places along the normal with which the outermost child, a sphere of radius[k], reaches as far as
   a sphere of the given radius, larger than theirs, in the center; 1 where all lie beside it. */
TM_FN tm_real tm_split_factor(const double *place, const double *radius, int n, tm_vec3 normal, tm_real reach)
{
  tm_real factor = 1e300;
  for (int k = 0; k < n; k++) {
    const tm_real out = fabs(tm_vec_dot(normal, tm_split_place(place, k))), room = reach - radius[k];
    if (out * factor > room) factor = room / out;
  }
  return factor < 1e300 ? factor : 1.0;
}

TM_FN void tm_split_scale(double *place, int n, tm_vec3 normal, tm_real factor)
{
  for (int k = 0; k < n; k++) {
    const tm_vec3 x = tm_split_place(place, k);
    tm_split_put(place, k, tm_vec_axpy(x, (factor - 1.0) * tm_vec_dot(normal, x), normal));
  }
}

#endif
