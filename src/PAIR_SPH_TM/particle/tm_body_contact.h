/* SPH-TM: contact between particle bodies that do not share a continuum.

   The law of tm_contact_law.h, F15 (9)-(14), between each particle and the smooth surface of the other body
   (tm_body_surface.h), from both sides, each with half of the stiffness F15 (10) per area.

     penetration F15 (9)    delta_i = s D(psi_i) + u_i + sum_j w_ij u_j/psi_i,  psi_i = sum_j w_ij,
                            w_ij = edge_j^(d-1)/(C s_ij^(d-1)) k(r^2/s_ij^2), u of the layers (tm_body_layer.h)
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

   Four passes, since a particle needs of its neighbors in contact what they have found: tm_body_ahead() writes what
   friction needs, tm_body_thin() the layers, tm_body_touch() the side of each particle, tm_body_contact() adds up the pairs;
   ghosts get the first three. A particle has a side for each body that it may touch. */
#ifndef TM_BODY_CONTACT_H
#define TM_BODY_CONTACT_H

#include "tm_body_layer.h"

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

/* What a particle finds of another body: sums over its particles, weighted by w_ij. */
typedef struct {
  tm_real psi, rate;            /* psi_i and its rate */
  tm_vec3 normal;               /* - grad psi_i */
  tm_vec3 v, end;               /* velocity, and that at the end of the step */
  tm_real mass, apart, T;       /* mass, s_ij, temperature */
  tm_real stiffness, bj, yield; /* F15 (10), effusivity, flow stress */
  tm_real change, change_rate;  /* of the layers, their mean and its rate */
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
  o.change = o.change_rate = 0.0;
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
    const tm_real growth = -fall * tm_vec_dot(p.d, tm_vec_sub(vi, vj)), change = tm_body_thinner(j, p.other, b);
    o.rate += growth;
    if (b->thin) {
      o.change += w * change;
      o.change_rate += growth * change + w * tm_body_thinning(j, p.other, b);
    }
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
    o.change *= one;
    o.change_rate = one * (o.change_rate - o.change * o.rate);
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
  if (o.psi > 0.0) { /* it may be of the surface that one beneath it touches: then springs would move with it */
    if (a->uneven) tm_vec_to_row(a->uneven + tm_row(i, 3), tm_vec(0, 0, 0));
    if (a->xsph_v) tm_store3(a->xsph_v + 3 * (ptrdiff_t) i, tm_vec(0, 0, 0));
  }
  if (!(o.psi > (b->thin ? TM_BODY_FAINT : 1.0))) return;
  tm_real per_psi;
  const tm_real own = tm_body_thinner(i, side, b);
  const tm_real delta = o.apart * tm_body_signed_depth(&b->surface, o.psi, &per_psi) + own + o.change;
  if (!(delta > 0.0)) return;
  out->depth = tm_max(out->depth, delta / o.apart);
  const tm_body_law *law = b->law + o.law;
  const tm_real mi = tm_main_record(&a->rec, i)[tm_part(TM_REC_M)], mass = mi * o.mass / (mi + o.mass);
  const tm_real slope = o.apart * per_psi;
  const tm_real closing = slope * o.rate + tm_body_thinning(i, side, b) + o.change_rate;
  const tm_real c = tm_contact_damping(law->damping, o.stiffness, mass);
  const tm_real f = 0.5 * tm_contact_normal(o.stiffness, delta, c, closing, 0); /* F15 (12) */
  const tm_real left = tm_max(delta + b->after * closing, 0.0);
  out->spring += 0.25 * o.stiffness * left * left;
  out->damping_power += (f - 0.5 * o.stiffness * delta) * closing;

  tm_real *mine = b->sides_of + ((ptrdiff_t) i * b->sides + side) * TM_BODY_SIDE;
  mine[TM_SIDE_NORMAL] = f * slope;
  mine[TM_SIDE_LOAD] = f / o.psi;
  mine[TM_SIDE_MEAN] = o.change;
  if (f > 0.0)
    mine[TM_SIDE_NEXT] = 0.5 * tm_contact_normal(o.stiffness, delta + b->layer_dt * closing, c, closing, 0) / o.psi;
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
  tm_vec3 force = tm_vec(0, 0, 0), normal = tm_vec(0, 0, 0);
  tm_real load = 0.0, next = 0.0; /* on the layer */
  const int layer = b->thin ? (int) b->thin[(ptrdiff_t) i * TM_THIN + TM_THIN_SIDE] - 1 : -1;
  tm_body_contact_result out = tm_body_contact_nothing();

  for (ptrdiff_t m = begin; m < end; m++) {
    const int j = row[m * a->rows.stride];
    tm_body_pair p;
    if (!tm_body_meet(i, j, a, b, dim3, &p)) continue;
    const tm_real *own = b->sides_of + ((ptrdiff_t) i * b->sides + p.side) * TM_BODY_SIDE;
    const tm_real *his = b->sides_of + ((ptrdiff_t) j * b->sides + p.other) * TM_BODY_SIDE;
    const tm_real wi = p.aj * p.area * p.k, wj = p.ai * p.area * p.k; /* w_ij, w_ji */
    tm_real mine_of_it = own[TM_SIDE_NORMAL], his_of_it = his[TM_SIDE_NORMAL];
    if (b->thin) {
      mine_of_it += own[TM_SIDE_LOAD] * (tm_body_thinner(j, p.other, b) - own[TM_SIDE_MEAN]);
      his_of_it += his[TM_SIDE_LOAD] * (tm_body_thinner(i, p.side, b) - his[TM_SIDE_MEAN]);
    }
    force = tm_vec_axpy(force, p.area * p.fall * (p.aj * mine_of_it + p.ai * his_of_it), p.d);
    if (p.side == layer) {
      normal = tm_vec_axpy(normal, p.aj * p.area * p.fall, p.d);
      load += wi * own[TM_SIDE_LOAD] + wj * his[TM_SIDE_LOAD];
      next += wi * own[TM_SIDE_NEXT] + wj * his[TM_SIDE_NEXT];
    }
    force = tm_vec_add(force, tm_vec_sub(tm_vec_scale(wi, tm_vec(own[1], own[2], own[3])),
                                         tm_vec_scale(wj, tm_vec(his[1], his[2], his[3]))));
    out.heat_power += wj * his[TM_SIDE_HEAT];
  }
  a->force[3 * (ptrdiff_t) i] += a->force_unit * force.x;
  a->force[3 * (ptrdiff_t) i + 1] += a->force_unit * force.y;
  a->force[3 * (ptrdiff_t) i + 2] += a->force_unit * force.z;
  if (layer >= 0 && b->layer_dt > 0.0) tm_body_store_layer(i, layer, normal, load, next, a, b);
  if (b->source) b->source[i] += out.heat_power;
  out.work_power = tm_vec_dot(force, vi);
  return out;
}

#endif
