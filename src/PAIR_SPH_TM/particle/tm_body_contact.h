/* SPH-TM: contact between particle bodies that do not share a continuum.

   The law of tm_contact_law.h, F15 (9)-(14), between each particle and the smooth surface of the other body
   (tm_body_surface.h), from both sides, each with half of the stiffness F15 (10) per area.

     penetration F15 (9)    delta_i = s D(psi_i),  psi_i = sum_j w_ij,  w_ij = edge_j^(d-1)/(C s_ij^(d-1)) k(r^2/s_ij^2)
     normal force           f_i = (k delta_i + c ddelta_i/dt)/2 acts on each pair as - f_i ddelta_i/dx_ij, along x_ij
     friction F15 (13)      against the sliding v_i - sum_j w_ij v_j/psi_i across the normal grad psi_i that the step
                            would end with, at most min(mu(T) f_i, m Y/sqrt(3) A), divided over the pairs by w_ij/psi_i

   The spring has a potential, so its forces do no work over a closed path, whatever the lattices; with damping their
   power is - f_i ddelta_i/dt. All forces are equal and opposite pair by pair; those of springs and dampers are central, so
   that they keep the angular momentum too, and friction acts between centers, about a spacing apart, so it has a
   couple of that arm. Damping is critical at DFAC = 1 for the reduced mass of the particle and those under it.
   Up to its limit friction takes TM_BODY_STOP of the sliding of flat faces in a step, and less of sliding that differs
   from particle to particle, since it is divided over neighbors: more than 1, so that an uneven load slides at its limit
   everywhere, less than 2, where a body at rest would begin to swing. Its heat is shared by effusivity
   sqrt(k rho c_p).

   Three passes, since a particle needs of its neighbors in contact what they have found: tm_body_ahead() writes what
   friction needs, tm_body_touch() the side of each particle, tm_body_contact() adds up the pairs; ghosts get the first
   two. A particle has a side for each body that it may touch. */
#ifndef TM_BODY_CONTACT_H
#define TM_BODY_CONTACT_H

#include "tm_body_surface.h"
#include "tm_contact_law.h"
#include "tm_heat.h"
#include "tm_rates.h"
#include "tm_start_temperature.h"
#include "tm_state.h"

typedef struct {
  tm_table friction; /* mu(T), Coulomb's coefficient, >= 0 */
  tm_real shear;     /* m: friction <= m Y/sqrt(3) A; 0: no such limit */
  tm_real modulus;   /* E_i E_j/(E_i + E_j) in F15 (10), with PFAC or of the materials: tm_contact_modulus_of_two() */
  tm_real damping;   /* DFAC, share of critical, >= 0 */
} tm_body_law;

/* What friction needs of a particle: the velocity that the step would end with by the forces so far, and the flow stress
   (0: not known). */
enum { TM_AHEAD_V = 0, TM_AHEAD_YIELD = 3, TM_AHEAD = 4 };
typedef struct {
  tm_state state;
  tm_real dt, force_unit; /* mass times acceleration -> force of the unit style */
  tm_real *ahead;         /* TM_AHEAD per particle */
} tm_ahead_args;

TM_FN void tm_body_ahead(int i, const tm_ahead_args *a, unsigned effects)
{
  const tm_state *s = &a->state;
  const tm_real mass = tm_particle_mass(s, i);
  tm_real *to = a->ahead + (ptrdiff_t) i * TM_AHEAD;
  for (int k = 0; k < 3; k++)
    to[k] = s->v[3 * (ptrdiff_t) i + k] + a->dt / (mass * a->force_unit) * s->force[3 * (ptrdiff_t) i + k];
  to[TM_AHEAD_YIELD] = (effects & TM_FX_PLASTICITY)
                           ? s->field[TM_F_PSTRAIN][tm_row(i, tm_field_columns(TM_F_PSTRAIN)) + tm_column(2)]
                           : 0.0;
}

#define TM_BODY_STOP 1.5

/* Columns of a side: f ddelta/dpsi; friction over psi x y z; heat of friction for the other body over psi. */
enum { TM_SIDE_NORMAL = 0, TM_SIDE_FRICTION = 1, TM_SIDE_HEAT = 4, TM_BODY_SIDE = 5 };

typedef struct {
  const tm_body_law *law;    /* per type pair, index i * (ntypes + 1) + j */
  const int *side;           /* per type pair: which side of i meets j, from 1 on; 0: no contact */
  int sides;                 /* most that a particle has */
  const tm_real *effusivity; /* per type, sqrt(k rho c_p) at the reference temperature */
  tm_body_surface surface;
  tm_real spacing; /* dp of the pair style */
  tm_real dt;
  tm_real after;               /* from the force point to the end of the step */
  tm_real *sides_of;           /* sides * TM_BODY_SIDE per particle, owned and ghost */
  const tm_real *ahead;        /* TM_AHEAD per particle, owned and ghost; NULL: no friction */
  const int *mask;             /* groups of owned and ghost particles */
  tm_start_temperatures start; /* without the effect heat */
  tm_real *source;             /* heat power of particle i, added to, or NULL */
} tm_body_contact_args;

/* Sums over particles. */
typedef struct {
  tm_real spring; /* elastic energy */
  tm_real damping_power, friction_power;
  tm_real heat_power; /* friction heat into the particle */
  tm_real work_power; /* of the contact force on the particle */
  tm_real depth;      /* deepest, in spacings: no sum */
} tm_body_contact_result;

TM_FN tm_body_contact_result tm_body_contact_nothing(void)
{
  tm_body_contact_result r;
  r.spring = r.damping_power = r.friction_power = r.heat_power = r.work_power = r.depth = 0.0;
  return r;
}
TM_FN void tm_body_contact_sum(tm_body_contact_result *sum, const tm_body_contact_result *r)
{
  sum->spring += r->spring;
  sum->damping_power += r->damping_power;
  sum->friction_power += r->friction_power;
  sum->heat_power += r->heat_power;
  sum->work_power += r->work_power;
  sum->depth = tm_max(sum->depth, r->depth);
}

/* Edge of particle i. */
TM_FN tm_real tm_body_edge(int i, const tm_rates_args *a, const tm_body_contact_args *b)
{
  return a->rec.size ? a->rec.size[(ptrdiff_t) i * TM_REC_SIZE + TM_SIZE_DP] : b->spacing;
}

TM_FN tm_real tm_body_temperature(int i, const tm_rates_args *a, const tm_body_contact_args *b)
{
  if (a->rec.heat) return tm_heat_record(&a->rec, i)[TM_REC_T];
  return tm_start_temperature(&b->start, b->mask ? b->mask[i] : 0);
}

/* Velocity of particle i at the end of the step, by the forces so far. */
TM_FN tm_vec3 tm_body_end(int i, const tm_body_contact_args *b, int dim3)
{
  const tm_real *v = b->ahead + (ptrdiff_t) i * TM_AHEAD;
  return tm_vec(v[0], v[1], dim3 ? v[2] : 0.0);
}

/* A pair within the reach. */
typedef struct {
  tm_vec3 d;            /* x_i - x_j */
  tm_real apart;        /* s_ij */
  tm_real area;         /* 1/(C s_ij^(d-1)) */
  tm_real k, fall;      /* k(x), -2 dk/dx / s_ij^2: grad k = -fall d */
  tm_real ai, aj;       /* edge^(d-1), with the norm of the other's layers over C */
  int law, side, other; /* index of the type pair, side of i and of j */
} tm_body_pair;

/* 0: they do not meet by contact, or are too far apart. */
TM_FN int tm_body_meet(int i, int j, const tm_rates_args *a, const tm_body_contact_args *b, int dim3, tm_body_pair *p)
{
  p->law = a->type[i] * (a->ntypes + 1) + a->type[j];
  p->side = b->side[p->law] - 1;
  if (p->side < 0) return 0;
  p->other = b->side[a->type[j] * (a->ntypes + 1) + a->type[i]] - 1;
  const tm_real *ri = tm_main_record(&a->rec, i), *rj = tm_main_record(&a->rec, j);
  p->d = tm_vec(ri[0] - rj[0], ri[1] - rj[1], dim3 ? ri[tm_part(2)] - rj[tm_part(2)] : 0.0);
  const tm_real ei = tm_body_edge(i, a, b), ej = tm_body_edge(j, a, b), s = 0.5 * (ei + ej);
  const tm_real x = tm_vec_dot(p->d, p->d) / (s * s);
  if (!(x < b->surface.reach2)) return 0;
  p->apart = s;
  p->area = 1.0 / (b->surface.norm * (dim3 ? s * s : s));
  p->ai = dim3 ? ei * ei : ei;
  p->aj = dim3 ? ej * ej : ej;
  if (ei != ej) { /* other layers than C counts */
    p->ai *= b->surface.norm / tm_body_norm(&b->surface, ei / s);
    p->aj *= b->surface.norm / tm_body_norm(&b->surface, ej / s);
  }
  p->k = tm_body_weight(&b->surface, x);
  p->fall = 2.0 * tm_body_fall(&b->surface, x) / (s * s);
  return 1;
}

/* What a particle finds of another body: sums over its particles, weighted by w_ij. */
typedef struct {
  tm_real psi, rate;            /* psi_i and its rate */
  tm_vec3 normal;               /* - grad psi_i */
  tm_vec3 v, end;               /* velocity, and that at the end of the step */
  tm_real mass, apart, T;       /* mass, s_ij, temperature */
  tm_real stiffness, bj, yield; /* F15 (10), effusivity, flow stress */
  tm_real heaviest;             /* the largest w_ij, */
  int law;                      /* and the law of that pair */
} tm_body_other;

TM_FN tm_body_other tm_body_find(int i, int side, tm_vec3 vi, const tm_rates_args *a, const tm_body_contact_args *b,
                                 int dim3)
{
  const ptrdiff_t begin = (ptrdiff_t) a->rows.mechanical[i] + a->rows.thermal[i];
  const ptrdiff_t end = begin + a->rows.contact[i];
  const int *row = a->rows.index + a->rows.first[i];
  const tm_real edge = tm_body_edge(i, a, b);
  tm_body_other o;
  o.psi = o.rate = o.mass = o.apart = o.T = o.stiffness = o.bj = o.yield = o.heaviest = 0.0;
  o.normal = o.v = o.end = tm_vec(0, 0, 0);
  o.law = 0;
  for (ptrdiff_t m = begin; m < end; m++) {
    const int j = row[m * a->rows.stride];
    tm_body_pair p;
    if (!tm_body_meet(i, j, a, b, dim3, &p) || p.side != side) continue;
    const tm_real *rj = tm_main_record(&a->rec, j);
    const tm_vec3 vj = tm_vec_from_record(rj, TM_REC_V, dim3);
    const tm_real w = p.aj * p.area * p.k, fall = p.aj * p.area * p.fall;
    o.psi += w;
    o.rate -= fall * tm_vec_dot(p.d, tm_vec_sub(vi, vj));
    o.normal = tm_vec_axpy(o.normal, fall, p.d);
    o.v = tm_vec_axpy(o.v, w, vj);
    o.mass += w * rj[tm_part(TM_REC_M)];
    o.apart += w * p.apart;
    o.T += w * tm_body_temperature(j, a, b);
    o.stiffness += w * tm_contact_stiffness(b->law[p.law].modulus, b->spacing, edge, dim3);
    o.bj += w * b->effusivity[a->type[j]];
    if (b->ahead) {
      o.end = tm_vec_axpy(o.end, w, tm_body_end(j, b, dim3));
      o.yield += w * b->ahead[(ptrdiff_t) j * TM_AHEAD + TM_AHEAD_YIELD];
    }
    if (w > o.heaviest) {
      o.heaviest = w;
      o.law = p.law;
    }
  }
  if (o.psi > 0.0) {
    const tm_real one = 1.0 / o.psi;
    o.v = tm_vec_scale(one, o.v);
    o.end = tm_vec_scale(one, o.end);
    o.mass *= one;
    o.apart *= one;
    o.T *= one;
    o.stiffness *= one;
    o.bj *= one;
    o.yield *= one;
  }
  return o;
}

/* Largest friction of particle i at the normal force fn: Coulomb's, and half of what the weaker material bears by
   shear on the area of the particle, since the other body's particles bear the other half. */
TM_FN tm_real tm_body_friction_limit(int i, tm_real fn, const tm_body_other *o, const tm_rates_args *a,
                                     const tm_body_contact_args *b, int dim3)
{
  const tm_body_law *law = b->law + o->law;
  const tm_real edge = tm_body_edge(i, a, b), area = 0.5 * (dim3 ? edge * edge : edge);
  const tm_real T = law->friction.n ? 0.5 * (tm_body_temperature(i, a, b) + o->T) : 0.0;
  const tm_real own = b->ahead[(ptrdiff_t) i * TM_AHEAD + TM_AHEAD_YIELD];
  const tm_real weaker = own > 0.0 && o->yield > 0.0 ? tm_min(own, o->yield) : tm_max(own, o->yield);
  return tm_friction_limit(tm_table_at(&law->friction, T), fn, law->shear, weaker, area);
}

/* Particle i against one body: its side, and the energy and powers of it. */
TM_FN void tm_body_touch_one(int i, int side, tm_vec3 vi, const tm_rates_args *a, const tm_body_contact_args *b,
                             int dim3, tm_body_contact_result *out)
{
  const tm_body_other o = tm_body_find(i, side, vi, a, b, dim3);
  tm_real per_psi;
  const tm_real depth = tm_body_depth(&b->surface, o.psi, &per_psi);
  if (o.psi > 0.0) { /* it may be of the surface that one beneath it touches: then springs would move with it */
    if (a->uneven) tm_vec_to_row(a->uneven + tm_row(i, 3), tm_vec(0, 0, 0));
    if (a->xsph_v) tm_store3(a->xsph_v + 3 * (ptrdiff_t) i, tm_vec(0, 0, 0));
  }
  if (!(o.psi > 1.0)) return;
  out->depth = tm_max(out->depth, depth);
  const tm_body_law *law = b->law + o.law;
  const tm_real mi = tm_main_record(&a->rec, i)[tm_part(TM_REC_M)], mass = mi * o.mass / (mi + o.mass);
  const tm_real delta = o.apart * depth, slope = o.apart * per_psi, closing = slope * o.rate;
  const tm_real c = tm_contact_damping(law->damping, o.stiffness, mass);
  const tm_real f = 0.5 * tm_contact_normal(o.stiffness, delta, c, closing, 0); /* F15 (12) */
  const tm_real left = tm_max(delta + b->after * closing, 0.0);
  out->spring += 0.25 * o.stiffness * left * left;
  out->damping_power += (f - 0.5 * o.stiffness * delta) * closing;

  tm_real *mine = b->sides_of + ((ptrdiff_t) i * b->sides + side) * TM_BODY_SIDE;
  mine[TM_SIDE_NORMAL] = f * slope;
  const tm_real steep = tm_vec_norm(o.normal);
  if (!(steep > 0.0) || !b->ahead) return;
  const tm_vec3 end = tm_vec_sub(tm_body_end(i, b, dim3), o.end); /* F15 (14) */
  const tm_real limit = tm_body_friction_limit(i, f * slope * steep, &o, a, b, dim3);
  const tm_vec3 friction = tm_contact_friction(tm_contact_tangential(end, tm_vec_scale(1.0 / steep, o.normal)),
                                               0.5 * TM_BODY_STOP * mass, b->dt, limit, 1.0); /* F15 (13) */
  const tm_real power = -tm_vec_dot(friction, tm_vec_sub(vi, o.v));
  mine[TM_SIDE_FRICTION] = friction.x / o.psi;
  mine[TM_SIDE_FRICTION + 1] = friction.y / o.psi;
  mine[TM_SIDE_FRICTION + 2] = friction.z / o.psi;
  out->friction_power += power;
  if (!b->source) return;
  const tm_real bi = b->effusivity[a->type[i]], share = bi + o.bj > 0.0 ? bi / (bi + o.bj) : 0.5;
  mine[TM_SIDE_HEAT] = (1.0 - share) * power / o.psi;
  b->source[i] += share * power;
  out->heat_power += share * power;
}

/* First pass. */
TM_FN tm_body_contact_result tm_body_touch(int i, const tm_rates_args *a, const tm_body_contact_args *b,
                                           unsigned effects)
{
  const int dim3 = (effects & TM_FX_3D) != 0, columns = b->sides * TM_BODY_SIDE;
  tm_body_contact_result out = tm_body_contact_nothing();
  for (int k = 0; k < columns; k++) b->sides_of[(ptrdiff_t) i * columns + k] = 0.0;
  if (!a->rows.contact[i]) return out;
  const tm_vec3 vi = tm_vec_from_record(tm_main_record(&a->rec, i), TM_REC_V, dim3);
  for (int side = 0; side < b->sides; side++) tm_body_touch_one(i, side, vi, a, b, dim3, &out);
  return out;
}

/* Second pass: forces on particle i, and heat into it from the sides of others. */
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

  for (ptrdiff_t m = begin; m < end; m++) {
    const int j = row[m * a->rows.stride];
    tm_body_pair p;
    if (!tm_body_meet(i, j, a, b, dim3, &p)) continue;
    const tm_real *own = b->sides_of + ((ptrdiff_t) i * b->sides + p.side) * TM_BODY_SIDE;
    const tm_real *his = b->sides_of + ((ptrdiff_t) j * b->sides + p.other) * TM_BODY_SIDE;
    const tm_real wi = p.aj * p.area * p.k, wj = p.ai * p.area * p.k; /* w_ij, w_ji */
    force = tm_vec_axpy(force, p.area * p.fall * (p.aj * own[TM_SIDE_NORMAL] + p.ai * his[TM_SIDE_NORMAL]), p.d);
    force = tm_vec_add(force, tm_vec_sub(tm_vec_scale(wi, tm_vec(own[1], own[2], own[3])),
                                         tm_vec_scale(wj, tm_vec(his[1], his[2], his[3]))));
    out.heat_power += wj * his[TM_SIDE_HEAT];
  }
  a->force[3 * (ptrdiff_t) i] += a->force_unit * force.x;
  a->force[3 * (ptrdiff_t) i + 1] += a->force_unit * force.y;
  a->force[3 * (ptrdiff_t) i + 2] += a->force_unit * force.z;
  if (b->source) b->source[i] += out.heat_power;
  out.work_power = tm_vec_dot(force, vi);
  return out;
}

#endif
