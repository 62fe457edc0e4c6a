/* SPH-TM: contact between a particle and a rigid surface: the law of tm_contact_law.h, and what a surface adds to it.

   Penetration F15 (9): delta = r - d, r = dp/2 the particle's radius, d the distance of its center.
   Stiffness and damping are those against a rigid body, with the particle's own mass.
   Friction F15 (13): up to its limit it is the force that brings the sliding to rest at the end of the step.
   Heat: friction power is shared by effusivity e = sqrt(k rho c_p), the exact split between two
   half-spaces. A conductance h acts in series with the half spacing of the particle. */
#ifndef TM_CONTACT_H
#define TM_CONTACT_H

#include "tm_contact_law.h"
#include "tm_heat.h"
#include "tm_time_step.h"

/* Contact of the particles of one type. */
typedef struct {
  int active;              /* 0: this type does not touch the surface */
  tm_real radius;          /* dp/2 (length) */
  tm_real stiffness;       /* k (force/length) */
  int layer;               /* the half spacing beneath the surface takes part in the strain: tm_contact_layer.h */
  tm_real damping;         /* DFAC, share of critical damping, >= 0 */
  tm_real area;            /* area a particle shows to the surface: dp^2, in 2D dp */
  tm_table friction;       /* mu(T), >= 0 */
  tm_real shear;           /* m: friction <= m Y/sqrt(3) A; 0: no such limit */
  tm_real share;           /* of friction heat into the particle, 0..1; negative: by effusivity */
  tm_real tool_effusivity; /* of the surface, power time^(1/2)/(area temperature) */
  tm_real conductance;     /* to the surface, power/(area temperature); 0: none, negative: perfect */
} tm_contact_law;

/* The law for a particle of edge dp, where it differs from the one the law was made for: the same
   stiffness per area. */
TM_FN tm_contact_law tm_contact_law_of_size(const tm_contact_law *law, tm_real dp, int dim3)
{
  tm_contact_law own = *law;
  own.radius = 0.5 * dp;
  own.area = dim3 ? dp * dp : dp;
  own.stiffness = law->stiffness * (own.area / law->area);
  return own;
}

/* Largest friction force at normal force fn, temperature T and flow stress Y (0: not known). */
TM_FN tm_real tm_contact_friction_limit(const tm_contact_law *w, tm_real fn, tm_real T, tm_real Y)
{
  return tm_friction_limit(tm_table_at(&w->friction, T), fn, w->shear, Y, w->area);
}

/* Part of the friction heat that goes into the particle. */
TM_FN tm_real tm_contact_share(const tm_contact_law *w, tm_real effusivity)
{
  if (w->share >= 0.0) return w->share;
  const tm_real sum = effusivity + w->tool_effusivity;
  return sum > 0.0 ? effusivity / sum : 0.5;
}

/* Conductance from the surface to the center of a particle with conductivity k. */
TM_FN tm_real tm_contact_conductance(const tm_contact_law *w, tm_real k)
{
  const tm_real inside = k / w->radius;
  if (w->conductance < 0.0) return inside;
  return w->conductance > 0.0 ? w->conductance * inside / (w->conductance + inside) : 0.0;
}

/* Mean power into a particle of heat capacity m c_p over dt through conductance times area hA: the
   exact relaxation towards the surface temperature, so never past it. */
TM_FN tm_real tm_contact_heat(tm_real hA, tm_real T_surface, tm_real T, tm_real capacity, tm_real dt)
{
  return -capacity / dt * expm1(-hA * dt / capacity) * (T_surface - T);
}

#endif
