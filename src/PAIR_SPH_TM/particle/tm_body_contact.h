/* SPH-TM: contact between particle bodies that do not share a continuum.

   The law of F15 (9)-(16) between two particles instead of a particle and a triangle: penetration
   delta = dp - r of two spheres of diameter dp (one particle spacing; the mean of the two where
   particles have a size of their own), normal along the line of centres, stiffness F15 (10)
   k = PFAC E_i E_j dp/(E_i + E_j)  (per unit thickness in 2D: without dp) with dp of the pair style;
   finer particles, of which more meet per area, have the same stiffness per area of the finer one.
   Damping F15 (11) with DFAC = 1 critical for the pair, 2 sqrt(k m_eff); the damping adds to
   the spring while closing and the sum is never tensile. Coulomb friction acts on
   v_T = v_ij - (v_ij.n) n and may not reverse the sliding of the pair within one step. Its heat
   is shared by effusivity sqrt(k rho c_p). Forces of the two sides are equal and opposite, and
   central but for friction. */
#ifndef TM_BODY_CONTACT_H
#define TM_BODY_CONTACT_H

#include "tm_rates.h"

typedef struct {
  tm_real friction;    /* Coulomb coefficient, >= 0 */
  tm_real penalty;     /* PFAC, > 0 */
  tm_real damping;     /* DFAC, share of critical, >= 0 */
} tm_body_law;

typedef struct {
  const tm_body_law *law;   /* per type pair, index i * (ntypes + 1) + j */
  const int *contact;       /* nonzero where a type pair meets by contact */
  const tm_real *young;     /* per type */
  const tm_real *effusivity;/* per type, sqrt(k rho c_p) at the reference temperature */
  tm_real spacing;          /* dp of the pair style */
  tm_real dt;
  tm_real *source;          /* heat power of particle i, added to, or NULL */
} tm_body_contact_args;

typedef struct {
  tm_real spring;           /* elastic energy, half of each pair */
  tm_real damping_power, friction_power;
  tm_real heat_power;       /* friction heat into the particle */
  tm_real work_power;       /* of the contact force on the particle */
} tm_body_contact_result;

TM_FN tm_body_contact_result tm_body_contact_nothing(void)
{
  tm_body_contact_result r;
  r.spring = r.damping_power = r.friction_power = r.heat_power = r.work_power = 0.0;
  return r;
}
TM_FN void tm_body_contact_sum(tm_body_contact_result *sum, const tm_body_contact_result *r)
{
  sum->spring += r->spring;
  sum->damping_power += r->damping_power;
  sum->friction_power += r->friction_power;
  sum->heat_power += r->heat_power;
  sum->work_power += r->work_power;
}

/* F15 (10) for a pair whose smaller particle has edge dp. */
TM_FN tm_real tm_body_contact_stiffness(tm_real pfac, tm_real Ei, tm_real Ej, tm_real spacing, tm_real dp, int dim3)
{
  const tm_real finer = dp / spacing;
  return pfac * Ei * Ej / (Ei + Ej) * (dim3 ? spacing * finer * finer : finer);
}

TM_FN tm_body_contact_result tm_body_contact(int i, const tm_rates_args *a,
                                             const tm_body_contact_args *b, unsigned effects)
{
  const int dim3 = (effects & TM_FX_3D) != 0;
  const ptrdiff_t begin = (ptrdiff_t) a->rows.mechanical[i] + a->rows.thermal[i];
  const ptrdiff_t end = begin + a->rows.contact[i];
  const int *row = a->rows.index + a->rows.first[i];
  const tm_real *ri = tm_main_record(&a->rec, i);
  const tm_vec3 vi = tm_vec_from_record(ri, TM_REC_V, dim3);
  tm_vec3 force = tm_vec(0, 0, 0);
  tm_body_contact_result out = tm_body_contact_nothing();

  for (ptrdiff_t k = begin; k < end; k++) {
    const int j = row[k * a->rows.stride];
    const tm_real *rj = tm_main_record(&a->rec, j);
    const tm_vec3 d = tm_vec(ri[0] - rj[0], ri[1] - rj[1], dim3 ? ri[tm_part(2)] - rj[tm_part(2)] : 0.0);
    const tm_real r2 = tm_vec_dot(d, d);
    const int pair = a->type[i] * (a->ntypes + 1) + a->type[j];
    const tm_real si = a->rec.size ? a->rec.size[(ptrdiff_t) i * TM_REC_SIZE + TM_SIZE_DP] : b->spacing;
    const tm_real sj = a->rec.size ? a->rec.size[j * TM_REC_SIZE + TM_SIZE_DP] : b->spacing;
    const tm_real dp = 0.5 * (si + sj);
    if (r2 >= dp * dp || r2 == 0.0 || !b->contact[pair]) continue;
    const tm_body_law *law = b->law + pair;
    const tm_real r = sqrt(r2), delta = dp - r;
    const tm_vec3 n = tm_vec_scale(1.0 / r, d);
    const tm_real ei = b->young[a->type[i]], ej = b->young[a->type[j]];
    const tm_real mi = ri[tm_part(TM_REC_M)], mj = rj[tm_part(TM_REC_M)], meff = mi * mj / (mi + mj);
    const tm_real stiff = tm_body_contact_stiffness(law->penalty, ei, ej, b->spacing, tm_min(si, sj), dim3);
    const tm_vec3 v = tm_vec_sub(vi, tm_vec_from_record(rj, TM_REC_V, dim3));
    const tm_real vn = tm_vec_dot(v, n);
    const tm_real spring = stiff * delta;
    const tm_real fn = tm_max(spring - law->damping * 2.0 * sqrt(stiff * meff) * vn, 0.0);
    const tm_vec3 vt = tm_vec_axpy(v, -vn, n);
    const tm_real speed = tm_vec_norm(vt);
    /* several pairs may act on one particle: each takes a quarter of what would stop it */
    const tm_real ft = tm_min(law->friction * fn, 0.25 * meff * speed / b->dt);
    force = tm_vec_axpy(force, fn, n);
    if (speed > 0.0) force = tm_vec_axpy(force, -ft / speed, vt);
    out.spring += 0.25 * stiff * delta * delta;
    out.damping_power += 0.5 * (spring - fn) * vn;
    out.friction_power += 0.5 * ft * speed;
    if (b->source) {
      const tm_real bi = b->effusivity[a->type[i]], bj = b->effusivity[a->type[j]];
      out.heat_power += bi + bj > 0.0 ? ft * speed * bi / (bi + bj) : 0.5 * ft * speed;
    }
  }
  a->force[3 * (ptrdiff_t) i] += a->force_unit * force.x;
  a->force[3 * (ptrdiff_t) i + 1] += a->force_unit * force.y;
  a->force[3 * (ptrdiff_t) i + 2] += a->force_unit * force.z;
  if (b->source) b->source[i] += out.heat_power;
  out.work_power = tm_vec_dot(force, vi);
  return out;
}

#endif
