/* SPH-TM: the half spacing between the particles of a body and its surface, where another body of particles touches it.

   As at tools (tm_contact_layer.h) the half spacing e_i of a particle strains with it, e_i = edge_i/2 + u_i, along the normal of the
   other body's surface, grad psi_i. Both layers of a contact are in its penetration:

     delta_i = s D(psi_i) + u_i + U_i,   U_i = sum_j w_ij u_j/psi_i

   so that by virtual work the force f_i of delta_i acts on the pairs as - f_i ((s D' + (u_j - U_i)/psi_i) dw_ij/dx_ij), on the layer of i
   as f_i and on those of its neighbors j as f_i w_ij/psi_i; what acts on a layer is the stress T of tm_contact_layer.h. The
   surface itself strains on both sides then, and energy and momentum are as exact as without. A particle has one layer, towards the
   first body or tool that it meets. Own construction. */
#ifndef TM_BODY_LAYER_H
#define TM_BODY_LAYER_H

#include "tm_body_pair.h"
#include "tm_contact_layer.h"

/* psi below which no surface is near: D is -0.4 there. */
#define TM_BODY_FAINT 0.35

/* Change of the thickness of the layer of particle i towards its side, 0 where it has none there; and the rate of it. */
TM_FN tm_real tm_body_thinner(int i, int side, const tm_body_contact_args *b)
{
  if (!b->thin) return 0.0;
  const tm_real *t = b->thin + (ptrdiff_t) i * TM_THIN;
  return t[TM_THIN_SIDE] == side + 1.0 ? t[TM_THIN_BY] : 0.0;
}
TM_FN tm_real tm_body_thinning(int i, int side, const tm_body_contact_args *b)
{
  if (!b->thin) return 0.0;
  const tm_real *t = b->thin + (ptrdiff_t) i * TM_THIN;
  return t[TM_THIN_SIDE] == side + 1.0 ? t[TM_THIN_RATE] : 0.0;
}

/* A layer at the force point. */
typedef struct {
  tm_real strain, rate, arm, thickness; /* of n.L n, dthickness/dstrain */
} tm_body_strain;

TM_FN tm_body_strain tm_body_strain_of(int i, tm_vec3 normal, const tm_rates_args *a, const tm_body_contact_args *b)
{
  const tm_real *row = b->layer + tm_row(i, TM_L_COLUMNS);
  const tm_vec3 n = tm_vec_scale(1.0 / tm_vec_norm(normal), normal);
  const tm_mat3 L = tm_mat_from_row(a->gradient + tm_row(i, 9));
  tm_body_strain s;
  s.rate = tm_sym_ddot(tm_mat_symmetric(tm_mat_outer(n, n)), tm_mat_symmetric(L));
  s.thickness = tm_layer_advance(row[tm_column(TM_L_NEAR)] > 0.0 ? row[tm_column(TM_L_STRAIN)] : 0.0,
                                 0.5 * tm_body_edge(i, a, b), b->layer_dt, &s.rate, &s.strain, &s.arm);
  return s;
}

/* psi_i towards a side, and - grad psi_i. */
TM_FN tm_real tm_body_psi(int i, int side, const tm_rates_args *a, const tm_body_contact_args *b, int dim3,
                          tm_vec3 *normal)
{
  const ptrdiff_t begin = (ptrdiff_t) a->rows.mechanical[i] + a->rows.thermal[i];
  const ptrdiff_t end = begin + a->rows.contact[i];
  const int *row = a->rows.index + a->rows.first[i];
  tm_real psi = 0.0;
  *normal = tm_vec(0, 0, 0);
  for (ptrdiff_t m = begin; m < end; m++) {
    tm_body_pair p;
    if (!tm_body_meet(i, row[m * a->rows.stride], a, b, dim3, &p) || p.side != side) continue;
    psi += p.aj * p.area * p.k;
    *normal = tm_vec_axpy(*normal, p.aj * p.area * p.fall, p.d);
  }
  return psi;
}

/* Pass over particles: the layer of each at the force point. */
TM_FN void tm_body_thin(int i, const tm_rates_args *a, const tm_body_contact_args *b, unsigned effects)
{
  tm_real *to = b->thin + (ptrdiff_t) i * TM_THIN;
  to[TM_THIN_BY] = to[TM_THIN_RATE] = to[TM_THIN_SIDE] = 0.0;
  if (!a->rows.contact[i]) return;
  const tm_real *row = b->layer + tm_row(i, TM_L_COLUMNS);
  const tm_real owner = row[tm_column(TM_L_NEAR)] > 0.0 ? fabs(row[tm_column(TM_L_TOOL)]) : 0.0;
  if (owner > 0.0 && owner < TM_LAYER_OF_BODIES) return; /* a tool has it */
  tm_vec3 normal = tm_vec(0, 0, 0);
  tm_real psi = 0.0;
  int side = -1;
  for (int k = 0; k < b->sides; k++) {
    if (!b->strains[a->type[i] * b->sides + k] || (owner > 0.0 && owner != TM_LAYER_OF_BODIES + k)) continue;
    tm_vec3 n;
    const tm_real found = tm_body_psi(i, k, a, b, (effects & TM_FX_3D) != 0, &n);
    if (!(found > psi)) continue;
    psi = found;
    normal = n;
    side = k;
  }
  if (!(psi > 0.0 && tm_vec_norm(normal) > 0.0)) return;
  /* it begins at touch, without strain, and lasts as long as the other body is about: what others find of it does not jump */
  if (owner == 0.0 && !(psi > 1.0)) return;
  const tm_body_strain s = tm_body_strain_of(i, normal, a, b);
  to[TM_THIN_BY] = s.thickness - 0.5 * tm_body_edge(i, a, b);
  to[TM_THIN_RATE] = s.arm * s.rate;
  to[TM_THIN_SIDE] = side + 1.0;
}

/* The layer of particle i towards a side at the end of the step, with the force on it at this force point and the next. */
TM_FN void tm_body_store_layer(int i, int side, tm_vec3 normal, tm_real load, tm_real next, const tm_rates_args *a,
                               const tm_body_contact_args *b)
{
  const tm_body_strain s = tm_body_strain_of(i, normal, a, b);
  const tm_real *r = tm_main_record(&a->rec, i);
  const tm_real per_force = s.arm * r[tm_part(TM_REC_RHO)] / r[tm_part(TM_REC_M)];
  const tm_vec3 n = tm_vec_scale(1.0 / tm_vec_norm(normal), normal);
  tm_layer_store(b->layer + tm_row(i, TM_L_COLUMNS), load * per_force, next * per_force,
                 tm_mat_symmetric(tm_mat_outer(n, n)), s.strain + 0.5 * b->layer_dt * s.rate,
                 tm_layer_side(n) * (TM_LAYER_OF_BODIES + side));
}

#endif
