/* SPH-TM: contact between particle bodies that do not share a continuum.

   The law of tm_contact_law.h, F15 (9)-(14), between two particles instead of a particle and a triangle: penetration
   delta = dp - r of two spheres of diameter dp (one particle spacing; the mean of the two where
   particles have a size of their own), normal along the line of centers. Damping is critical at DFAC = 1 for the
   reduced mass of the pair. Heat of friction is shared by effusivity sqrt(k rho c_p). Forces of the two sides are
   equal and opposite, and central but for friction. */
#ifndef TM_BODY_CONTACT_H
#define TM_BODY_CONTACT_H

#include "tm_contact_law.h"
#include "tm_rates.h"

typedef struct {
  tm_real friction; /* Coulomb coefficient, >= 0 */
  tm_real penalty;  /* PFAC, > 0 */
  tm_real damping;  /* DFAC, share of critical, >= 0 */
} tm_body_law;

typedef struct {
  const tm_body_law *law;    /* per type pair, index i * (ntypes + 1) + j */
  const int *contact;        /* nonzero where a type pair meets by contact */
  const tm_real *young;      /* per type */
  const tm_real *effusivity; /* per type, sqrt(k rho c_p) at the reference temperature */
  tm_real spacing;           /* dp of the pair style */
  tm_real dt;
  tm_real *source; /* heat power of particle i, added to, or NULL */
} tm_body_contact_args;

typedef struct {
  tm_real spring; /* elastic energy, half of each pair */
  tm_real damping_power, friction_power;
  tm_real heat_power; /* friction heat into the particle */
  tm_real work_power; /* of the contact force on the particle */
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

/* One pair in contact. */
typedef struct {
  tm_vec3 n, vt;           /* unit vector from j to i; sliding of i against j, F15 (14) */
  tm_real delta, vn;       /* penetration, F15 (9), and its rate of opening */
  tm_real stiffness, mass; /* F15 (10), reduced mass */
  tm_real fn, ft, speed;   /* normal force, friction, |vt| */
} tm_body_pair;

/* Edge of particle i. */
TM_FN tm_real tm_body_edge(int i, const tm_rates_args *a, const tm_body_contact_args *b)
{
  return a->rec.size ? a->rec.size[(ptrdiff_t) i * TM_REC_SIZE + TM_SIZE_DP] : b->spacing;
}

/* Geometry and normal force, F15 (9)-(12), of i at ri with velocity vi and j; 0: they do not touch. */
TM_FN int tm_body_contact_normal(int i, int j, tm_vec3 vi, const tm_rates_args *a, const tm_body_contact_args *b,
                                 int dim3, tm_body_pair *c)
{
  const tm_real *ri = tm_main_record(&a->rec, i), *rj = tm_main_record(&a->rec, j);
  const tm_vec3 d = tm_vec(ri[0] - rj[0], ri[1] - rj[1], dim3 ? ri[tm_part(2)] - rj[tm_part(2)] : 0.0);
  const tm_real r2 = tm_vec_dot(d, d);
  const int pair = a->type[i] * (a->ntypes + 1) + a->type[j];
  const tm_real si = tm_body_edge(i, a, b), sj = tm_body_edge(j, a, b), dp = 0.5 * (si + sj);
  if (r2 >= dp * dp || r2 == 0.0 || !b->contact[pair]) return 0;
  const tm_body_law *law = b->law + pair;
  const tm_real r = sqrt(r2), mi = ri[tm_part(TM_REC_M)], mj = rj[tm_part(TM_REC_M)];
  const tm_vec3 v = tm_vec_sub(vi, tm_vec_from_record(rj, TM_REC_V, dim3));
  c->delta = dp - r;
  c->n = tm_vec_scale(1.0 / r, d);
  c->mass = mi * mj / (mi + mj);
  c->stiffness =
      tm_contact_stiffness(law->penalty, b->young[a->type[i]], b->young[a->type[j]], b->spacing, tm_min(si, sj), dim3);
  c->vn = tm_vec_dot(v, c->n);
  c->vt = tm_contact_tangential(v, c->n);
  c->speed = tm_vec_norm(c->vt);
  c->fn = tm_contact_normal(c->stiffness, c->delta, tm_contact_damping(law->damping, c->stiffness, c->mass), -c->vn, 0);
  /* F15 (13); several pairs may act on one particle: each takes a quarter of what would stop it */
  c->ft = tm_min(law->friction * c->fn, 0.25 * c->mass * c->speed / b->dt);
  return 1;
}

/* Energy and powers of the pair for the side of i, which has half of each. */
TM_FN void tm_body_contact_tally(const tm_body_pair *c, tm_body_contact_result *out)
{
  out->spring += 0.25 * c->stiffness * c->delta * c->delta;
  out->damping_power += 0.5 * (c->stiffness * c->delta - c->fn) * c->vn;
  out->friction_power += 0.5 * c->ft * c->speed;
}

/* Heat of friction into a particle of effusivity bi from its contact with one of effusivity bj. */
TM_FN tm_real tm_body_contact_heat(const tm_body_pair *c, tm_real bi, tm_real bj)
{
  return bi + bj > 0.0 ? c->ft * c->speed * bi / (bi + bj) : 0.5 * c->ft * c->speed;
}

TM_FN tm_body_contact_result tm_body_contact(int i, const tm_rates_args *a, const tm_body_contact_args *b,
                                             unsigned effects)
{
  const int dim3 = (effects & TM_FX_3D) != 0;
  const ptrdiff_t begin = (ptrdiff_t) a->rows.mechanical[i] + a->rows.thermal[i];
  const ptrdiff_t end = begin + a->rows.contact[i];
  const int *row = a->rows.index + a->rows.first[i];
  const tm_vec3 vi = tm_vec_from_record(tm_main_record(&a->rec, i), TM_REC_V, dim3);
  tm_vec3 force = tm_vec(0, 0, 0);
  tm_body_contact_result out = tm_body_contact_nothing();

  for (ptrdiff_t k = begin; k < end; k++) {
    const int j = row[k * a->rows.stride];
    tm_body_pair c;
    if (!tm_body_contact_normal(i, j, vi, a, b, dim3, &c)) continue;
    force = tm_vec_axpy(force, c.fn, c.n);
    if (c.speed > 0.0) force = tm_vec_axpy(force, -c.ft / c.speed, c.vt);
    tm_body_contact_tally(&c, &out);
    if (b->source) out.heat_power += tm_body_contact_heat(&c, b->effusivity[a->type[i]], b->effusivity[a->type[j]]);
  }
  a->force[3 * (ptrdiff_t) i] += a->force_unit * force.x;
  a->force[3 * (ptrdiff_t) i + 1] += a->force_unit * force.y;
  a->force[3 * (ptrdiff_t) i + 2] += a->force_unit * force.z;
  if (b->source) b->source[i] += out.heat_power;
  out.work_power = tm_vec_dot(force, vi);
  return out;
}

#endif
