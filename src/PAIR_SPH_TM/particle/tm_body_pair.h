/* SPH-TM: a pair of particles of two bodies in contact: its law and its weight, and what the loops of tm_body_contact.h share. */
#ifndef TM_BODY_PAIR_H
#define TM_BODY_PAIR_H

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

/* Columns of a side: f ddelta/dpsi; friction over psi x y z; heat of friction for the other body over psi; of layers, f over psi,
   that of the next force point, and the mean change of the thickness of those that it touches. */
enum {
  TM_SIDE_NORMAL = 0,
  TM_SIDE_FRICTION = 1,
  TM_SIDE_HEAT = 4,
  TM_SIDE_LOAD = 5,
  TM_SIDE_NEXT = 6,
  TM_SIDE_MEAN = 7,
  TM_BODY_SIDE = 8
};

/* Of the layer of a particle (tm_body_layer.h): what it is thicker than half a spacing, its rate, and one more than the side towards
   which it is (0: none). */
enum { TM_THIN_BY = 0, TM_THIN_RATE = 1, TM_THIN_SIDE = 2, TM_THIN = 3 };

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
  tm_real *layer;              /* rows of TM_F_LAYER, or NULL: none strains */
  const int *strains;          /* per type and side, index type * sides + side: the layer strains */
  tm_real *thin;               /* TM_THIN per particle, owned and ghost; NULL: no layers */
  tm_real layer_dt;            /* dt, 0 before the first step */
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

#endif
