/* SPH-TM: the end of a step of adaptive lists: which particles are searched in the next one, what their
   pairs keep, and how kept gradients follow the particles. See tm_kept.h. */
#ifndef TM_SETTLE_H
#define TM_SETTLE_H

#include "tm_kept.h"
#include "tm_state.h"

enum { TM_TOLD = 9 };            /* what a particle tells before pairs are kept: E row major */

typedef struct {
  tm_kept_rows rows;
  tm_rows near;                /* all that are within reach */
  tm_records rec;              /* of this step's force point */
  tm_state state;
  const tm_real *gradient;
  tm_real *memory;             /* TM_K */
  tm_real *told;               /* TM_TOLD, owned and ghost */
  tm_real *next;               /* 1: searched in the next step, 0; owned and ghost */
  const unsigned char *was, *now;    /* searched in this step, in the next one; owned and ghost */
  const unsigned char *dirty;  /* rows whose particle or neighbours are not what they were; NULL: none */
  const int *which;            /* the particles, or NULL: all */
  int settles, measures;       /* particles may come to rest in this step; G is measured */
  int corrected;               /* gradients are: Q = 1 */
  int for_ever;                /* no pair is kept but those of the first search */
  tm_real threshold, strain;   /* of plastic strain, of any strain since the search; infinite: never */
  tm_real dt, h, reach2, slope_norm, visc_alpha, visc_beta;
} tm_settle_args;

/* B: of a particle that was searched in this step 1/rho, else that of the next force point. */
TM_FN tm_mat3 tm_settle_map(int i, const tm_settle_args *a)
{
  const tm_real *k = a->memory + (ptrdiff_t) i * TM_K;
  if (tm_is_searched(k))
    return tm_mat_scale(1.0 / tm_main_record(&a->rec, i)[tm_part(TM_REC_RHO)], tm_mat_identity());
  return tm_mat_load(k + TM_K_B);
}

/* Has it failed, or flowed beyond the threshold? */
TM_FN int tm_settle_flows(int i, const tm_settle_args *a, unsigned effects)
{
  const tm_real *k = a->memory + (ptrdiff_t) i * TM_K;
  if (k[TM_K_NEAR] > 0.5) return 1;
  if ((effects & TM_FX_PLASTICITY) &&
      tm_field_row(&a->state, TM_F_PSTRAIN, i)[0] - k[TM_K_PSTRAIN] > a->threshold)
    return 1;
  return (a->threshold < 1e300) && (effects & TM_FX_DAMAGE) &&
      tm_field_row(&a->state, TM_F_DAMAGE, i)[tm_column(1)] > 0.5;
}

/* Between looks: has a kept particle flowed so far beyond the threshold that it cannot wait for the next one? */
#define TM_SETTLE_LEAP 1e-3
TM_FN int tm_settle_leaps(int i, const tm_settle_args *a)
{
  const tm_real *k = a->memory + (ptrdiff_t) i * TM_K;
  return !a->now[i] &&
      tm_field_row(&a->state, TM_F_PSTRAIN, i)[0] - k[TM_K_PSTRAIN] > a->threshold + TM_SETTLE_LEAP;
}

/* Has it been strained since its search? E = J F^T, J = det F. */
TM_FN int tm_settle_strained(const tm_settle_args *a, tm_mat3 E, int dim3)
{
  if (!(a->threshold < 1e300) || !(a->strain < 1e300)) return 0;
  const tm_mat3 C = tm_mat_mul(E, tm_mat_transposed(E));
  const tm_real det = dim3 ? E.xx * (E.yy * E.zz - E.yz * E.zy) - E.xy * (E.yx * E.zz - E.yz * E.zx)
                                 + E.xz * (E.yx * E.zy - E.yy * E.zx)
                           : E.xx * E.yy - E.xy * E.yx;
  const tm_real J = dim3 ? sqrt(sqrt(fabs(det))) : cbrt(fabs(det)), s = 1.0 / (J * J);
  const tm_real xx = s * C.xx - 1.0, yy = s * C.yy - 1.0, zz = dim3 ? s * C.zz - 1.0 : 0.0;
  const tm_real shear = C.xy * C.xy + (dim3 ? C.xz * C.xz + C.yz * C.yz : 0.0);
  const tm_real strain2 = 0.25 * (xx * xx + yy * yy + zz * zz + 2.0 * s * s * shear);
  return !(strain2 <= a->strain * a->strain);
}

/* Would gradients, times E, not fit into their weights? */
TM_FN int tm_settle_is_large(tm_mat3 E)
{
  const tm_real x2 = E.xx * E.xx + E.xy * E.xy + E.xz * E.xz, y2 = E.yx * E.yx + E.yy * E.yy + E.yz * E.yz;
  const tm_real z2 = E.zx * E.zx + E.zy * E.zy + E.zz * E.zz;
  return !(tm_max(tm_max(x2, y2), z2) <= TM_KEPT_MOST * TM_KEPT_MOST);
}

/* First pass: is particle i searched in the next step? One that is stays so until particles settle. */
TM_FN int tm_settle_tell(int i, const tm_settle_args *a, unsigned effects)
{
  const int dim3 = (effects & TM_FX_3D) != 0;
  const tm_real *k = a->memory + (ptrdiff_t) i * TM_K;
  int searched = (tm_is_searched(k) && !a->settles) || tm_settle_flows(i, a, effects);
  if (a->settles) {
    const tm_real rho = tm_main_record(&a->rec, i)[tm_part(TM_REC_RHO)];
    int good;
    const tm_mat3 E = tm_mat_inverse(tm_mat_scale(rho, tm_settle_map(i, a)), dim3, &good);
    tm_mat_store(a->told + (ptrdiff_t) i * TM_TOLD, E);
    searched = searched || !good || tm_settle_strained(a, E, dim3) || (!a->for_ever && tm_settle_is_large(E));
  }
  a->next[i] = searched;
  return searched;
}

/* Weights of the pair as it is now into entry `to` of the row; returns whether its ends differ: TM_K_MIXED. */
TM_FN int tm_settle_pair(int i, int j, int to, const tm_settle_args *a, int kernel, int dim3)
{
  const tm_real *ri = tm_main_record(&a->rec, i), *rj = tm_main_record(&a->rec, j);
  const tm_vec3 d = tm_vec(ri[tm_part(0)] - rj[tm_part(0)], ri[tm_part(1)] - rj[tm_part(1)],
                           dim3 ? ri[tm_part(2)] - rj[tm_part(2)] : 0.0);
  const tm_real r = tm_vec_norm(d), q = r / a->h, slope = tm_kernel_slope(kernel, q), g = slope / q;
  const tm_vec3 w = tm_vec_scale(slope / r, d);
  const tm_real *ei = a->told + (ptrdiff_t) i * TM_TOLD, *ej = a->told + (ptrdiff_t) j * TM_TOLD;
  short *out = tm_weight(&a->rows, i);
#define TM_OUT(c) out[tm_weight_place(&a->rows, c, to)]
  const tm_real per_unit = 1.0 / a->rows.unit;
  const unsigned bits = tm_weight_bits((float) tm_conduction_slope(kernel, q, g));
  int mixed = 0;
  for (int c = 0; c < 3; c++) {
    const short own = tm_weight_whole(per_unit * (ei[3 * c] * w.x + ei[3 * c + 1] * w.y + ei[3 * c + 2] * w.z));
    const short other = tm_weight_whole(per_unit * (ej[3 * c] * w.x + ej[3 * c + 1] * w.y + ej[3 * c + 2] * w.z));
    TM_OUT(TM_W_OWN + c) = own;
    TM_OUT(TM_W_OTHER + c) = other;
    mixed |= own != other;
  }
  tm_real bulk, shock;
  tm_viscosity_factors(a->visc_alpha, a->visc_beta, q, g, 0.5 * (ri[tm_part(TM_REC_C)] + rj[tm_part(TM_REC_C)]),
                       ri[tm_part(TM_REC_RHO)] + rj[tm_part(TM_REC_RHO)], &bulk, &shock);
  TM_OUT(TM_W_BULK) = tm_weight_upper(bulk);
  TM_OUT(TM_W_SHOCK) = tm_weight_upper(shock);
  TM_OUT(TM_W_SLOPE) = (short) (bits >> 16);
  TM_OUT(TM_W_SLOPE + 1) = (short) (bits & 0xffffu);
  TM_OUT(TM_W_DISTANCE) = tm_weight_whole(q / TM_DISTANCE_UNIT);
#undef TM_OUT
  return mixed;
}

/* The row of particle i, which is not searched next: out go pairs of those that are, in come those of which
   one end has come to rest. Returns whether anything did. */
TM_FN int tm_settle_row(int i, const tm_settle_args *a, int kernel, int dim3)
{
  const tm_kept_rows *r = &a->rows;
  const ptrdiff_t stride = r->stride;
  int *row = r->index + r->first[i], n = 0, changed = 0;
  short *w = tm_weight(r, i);
  tm_real *k = a->memory + (ptrdiff_t) i * TM_K;
  int mixed = !a->was[i] && k[TM_K_MIXED] > 0.5;
  for (int e = 0; e < r->kept[i]; e++) {
    const int j = row[e * stride];
    if (a->now[j]) continue;
    if (n < e) {
      row[n * stride] = j;
      for (int c = 0; c < TM_WEIGHTS; c++) w[tm_weight_place(r, c, n)] = w[tm_weight_place(r, c, e)];
    }
    n++;
  }
  changed = n < r->kept[i];
  if (a->settles) {
    const tm_real *ri = tm_main_record(&a->rec, i);
    const int *near = a->near.index + a->near.first[i];
    for (int e = 0; e < a->near.mechanical[i]; e++) {
      const int j = near[e * a->near.stride];
      if (a->now[j] || !(a->was[i] || a->was[j])) continue;
      const tm_real *rj = tm_main_record(&a->rec, j);
      const tm_real dx = ri[tm_part(0)] - rj[tm_part(0)], dy = ri[tm_part(1)] - rj[tm_part(1)];
      const tm_real dz = dim3 ? ri[tm_part(2)] - rj[tm_part(2)] : 0.0;
      if (!(dx * dx + dy * dy + dz * dz < a->reach2)) continue;
      row[n * stride] = j;
      mixed |= tm_settle_pair(i, j, n++, a, kernel, dim3);
      changed = 1;
    }
  }
  r->kept[i] = n;
  for (int e = n; e < tm_kept_places(n); e++) {
    row[e * stride] = i;
    for (int c = 0; c < TM_WEIGHTS; c++) w[tm_weight_place(r, c, e)] = 0;
  }
  k[TM_K_MIXED] = mixed;
  return changed;
}

/* Second pass, when the ghosts have been told: the row and the memory of particle i. */
TM_FN void tm_settle(int i, const tm_settle_args *a, unsigned effects)
{
  const int kernel = tm_fx_kernel(effects), dim3 = (effects & TM_FX_3D) != 0;
  tm_real *k = a->memory + (ptrdiff_t) i * TM_K;
  const int was = a->was[i], will = a->now[i], dirty = a->dirty && a->dirty[i];
  const tm_real plastic = (effects & TM_FX_PLASTICITY) ? tm_field_row(&a->state, TM_F_PSTRAIN, i)[0] : 0.0;
  k[TM_K_MARK] = was;
  k[TM_K_SEARCHES] += was;
  k[TM_K_SEARCHED] = will;
  if (will) {
    a->rows.kept[i] = 0;
    /* who begins is not asked before he has flowed for as long as the others */
    if (!was) k[TM_K_PSTRAIN] = plastic - 2.0 * (a->threshold < 1e300 ? a->threshold : 0.0) - 1e-300;
    else if (a->settles) k[TM_K_PSTRAIN] = plastic;
    return;
  }
  if (!was && !dirty && !a->measures && a->rows.kept[i] > 0) return;
  const tm_mat3 L = tm_mat_from_row(a->gradient + tm_row(i, 9));
  if (was) {
    k[TM_K_PSTRAIN] = plastic;
    tm_mat_store(k + TM_K_B, tm_mat_scale(1.0 / tm_main_record(&a->rec, i)[tm_part(TM_REC_RHO)], tm_mat_identity()));
  }
  const int changed = (was || dirty) && tm_settle_row(i, a, kernel, dim3);
  if (changed || a->measures) {
    /* G of these positions, and as the next ones will have it */
    const tm_mat3 G = tm_kept_stretch(i, &a->rows, &a->rec, a->slope_norm, dim3, k + TM_K_SUM);
    const tm_mat3 ahead = tm_mat_add(G, tm_mat_scale(a->dt, tm_mat_mul(L, G)));
    if (changed && !a->corrected)
      tm_mat_store(k + TM_K_Q, tm_mat_mul(tm_mat_transposed(was ? G : ahead), tm_mat_load(k + TM_K_B)));
    else if (changed) tm_mat_store(k + TM_K_Q, tm_mat_identity());
    tm_mat_store(k + TM_K_G, ahead);
  } else if (was || a->rows.kept[i] == 0) {    /* without pairs: B follows L */
    tm_mat_store(k + TM_K_G, tm_mat_scale(0.0, L));
    tm_kept_turn(k, L, a->dt, dim3);
    return;
  }
  tm_kept_turn(k, L, 0.0, dim3);
}

#endif
