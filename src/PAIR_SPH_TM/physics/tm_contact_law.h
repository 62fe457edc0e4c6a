/* SPH-TM: the law of contact F15 (10)-(14) between a particle and another body, a particle of it or a surface.

   Stiffness F15 (10): k = PFAC E_i E_j dp/(E_i + E_j), against a rigid body PFAC E_i dp (per unit
   thickness in 2D: without dp), with dp of the pair style. Finer particles, of which more meet per area, have the same
   stiffness per area: so a pressed surface that is split into finer particles is as stiff as before.
   Damping F15 (11): c = DFAC 2 sqrt(k m), m the mass that moves, so DFAC = 1 is critical. The printed factor contains
   m_i + m_j, which has no rigid limit.
   Normal force F15 (12): f = k delta + c ddelta/dt, ddelta/dt > 0 while closing (the printed minus
   would feed energy in), and never tensile. F15's approach test drops all of it while separating.
   Friction F15 (13): Coulomb's law up to the shear flow stress of the material, |f_t| <= min(mu(T) f_n, m Y/sqrt(3) A)
   (Zorev; m = 1 sticking, 0 leaves the limit out), on the tangential part of the relative velocity, F15 (14). It
   brings the sliding to rest at most, and never reverses it; where other forces turn the sliding round within the step, it
   brakes by so much less that it does no work. F15 prints mu(sigma_y, T) without a form; this one has
   the same arguments. */
#ifndef TM_CONTACT_LAW_H
#define TM_CONTACT_LAW_H

#include "tm_tensor.h"

/* What takes the place of E in F15 (10): PFAC E, or 2 M (penalty material). A force acts on the center of a
   particle, half a spacing inside its surface, and that half is rigid; in an elastic body it gives way by p (dp/2)/M, with M
   the modulus of a layer that is confined sideways. The spring of 2 M dp has just that compliance, so a contact is as stiff as
   the bodies are; that of PFAC = 1 is 2.7 times as soft (nu = 0.3). What is used if nothing is said: 2 M for a material that
   is elastic, where the stiffness of the contact counts, and PFAC = 1 for all others. */
#define TM_PENALTY_MATERIAL 0.0 /* in place of PFAC > 0 */
#define TM_PENALTY_USUAL -1.0
TM_FN tm_real tm_contact_half_layer(tm_real M) { return 2.0 * M; }
TM_FN tm_real tm_contact_modulus(tm_real pfac, tm_real E, tm_real half_layer, int elastic)
{
  if (pfac > 0.0) return pfac * E;
  return pfac == TM_PENALTY_MATERIAL || elastic ? half_layer : E;
}

/* Of two bodies that give way one behind the other, with E or what takes its place. */
TM_FN tm_real tm_contact_modulus_of_two(tm_real Ei, tm_real Ej) { return Ei * Ej / (Ei + Ej); }

/* Elastic contact so many times as soft as half a spacing of the material is worth a word. */
#define TM_SOFT_CONTACT 1.2

/* F15 (10) for a particle of edge dp in a scene of the given spacing; modulus: that of the particle against a rigid body, of
   two bodies tm_contact_modulus_of_two(). */
TM_FN tm_real tm_contact_stiffness(tm_real modulus, tm_real spacing, tm_real dp, int dim3)
{
  const tm_real finer = dp / spacing;
  return modulus * (dim3 ? spacing * finer * finer : finer);
}

/* F15 (11), corrected. */
TM_FN tm_real tm_contact_damping(tm_real dfac, tm_real k, tm_real mass) { return dfac * 2.0 * sqrt(k * mass); }

/* F15 (12), corrected; `closing` is ddelta/dt. */
TM_FN tm_real tm_contact_normal(tm_real k, tm_real delta, tm_real c, tm_real closing, int approach)
{
  if (approach && !(closing > 0.0)) return 0.0;
  return tm_max(k * delta + c * closing, 0.0);
}

/* F15 (13): largest friction at the normal force fn, coefficient mu, m, flow stress Y (0: not known) and area. */
TM_FN tm_real tm_friction_limit(tm_real mu, tm_real fn, tm_real m, tm_real Y, tm_real area)
{
  return m > 0.0 && Y > 0.0 ? tm_min(mu * fn, m * Y * area * 0.57735026918962576) : mu * fn;
}

/* F15 (14): the part of v across the unit normal n. */
TM_FN tm_vec3 tm_contact_tangential(tm_vec3 v, tm_vec3 n) { return tm_vec_axpy(v, -tm_vec_dot(v, n), n); }

/* The share of what stops a particle up to which friction takes energy from its sliding, <= 1, where the sliding at the
   start of a step is v_start and, if nothing held it, v_end at the end: with a share f the mean is (v_start + (1 - f) v_end)/2,
   which has no part along v_end at f = 1 + v_start.v_end/v_end^2; a little less, so that round-off makes no work. */
TM_FN tm_real tm_contact_most_braking(tm_vec3 v_start, tm_vec3 v_end)
{
  const tm_real turned = tm_vec_dot(v_start, v_end);
  return turned < 0.0 ? tm_max((1.0 - 1e-12) + turned / tm_vec_dot(v_end, v_end), 0.0) : 1.0;
}

/* Friction on a particle that would slide at v_end relative to the surface (tangential) at the end
   of the step if nothing held it: a share of what stops it, at most `limit`. */
TM_FN tm_vec3 tm_contact_friction(tm_vec3 v_end, tm_real mass, tm_real dt, tm_real limit, tm_real share)
{
  const tm_real stop = mass / dt * tm_vec_norm(v_end);
  const tm_real part = stop > limit ? tm_min(limit / stop, share) : share;
  return tm_vec_scale(-part * mass / dt, v_end);
}

#endif
