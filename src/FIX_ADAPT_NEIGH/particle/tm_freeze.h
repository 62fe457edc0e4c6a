/* SPH-TM: the end of a step of adaptive lists: which particles are updated-Lagrangian in the next step, the freezing of
   pairs (their gradients are stored), and the update of B and G. F14, Adaptive Neighbor Search; see tm_tl_rates.h. */
#ifndef TM_FREEZE_H
#define TM_FREEZE_H

#include "tm_tl_rates.h"
#include "tm_state.h"

enum { TM_FREEZE_EXPORT = 9 }; /* what a particle exports before pairs are frozen: the pull-back E = D^-1, row major */

typedef struct {
  tm_tl_rows rows;
  tm_rows candidates; /* rows of all neighbors within reach */
  tm_records rec;     /* of this step's force point */
  tm_state state;
  const tm_real *gradient;             /* L */
  tm_real *history;                    /* TM_TL_HISTORY */
  tm_real *pull_back;                  /* TM_FREEZE_EXPORT, owned and ghost */
  tm_real *next_ul;                    /* 1: updated-Lagrangian in the next step, 0: not; owned and ghost */
  const unsigned char *was_ul, *is_ul; /* updated-Lagrangian in this step, in the next one; owned and ghost */
  const unsigned char *dirty; /* particles that changed kind, or with a neighbor or a row that did; NULL: none */
  const int *which;           /* the particles, or NULL: all */
  int freezes, measures;      /* in this step pairs may be frozen; G is summed from the positions */
  int corrected;              /* gradients are, and no pair returns: Q = 1 */
  int permanent;              /* pairs are frozen once, at the start */
  tm_real threshold, strain;  /* of plastic strain, of total strain since the freezing; infinite: never */
  tm_real dt, h, support_radius2, slope_norm, visc_alpha, visc_beta;
} tm_freeze_args;

/* B: 1/rho of a particle that was updated-Lagrangian in this step, else that of the next force point. */
TM_FN tm_mat3 tm_freeze_map(int i, const tm_freeze_args *a)
{
  const tm_real *k = a->history + (ptrdiff_t) i * TM_TL_HISTORY;
  if (tm_is_ul(k)) return tm_mat_scale(1.0 / tm_main_record(&a->rec, i)[tm_part(TM_REC_RHO)], tm_mat_identity());
  return tm_mat_load(k + TM_TL_B);
}

/* Is it near another body, failed, or plastically strained beyond the threshold? */
TM_FN int tm_freeze_yields(int i, const tm_freeze_args *a, unsigned effects)
{
  const tm_real *k = a->history + (ptrdiff_t) i * TM_TL_HISTORY;
  if (k[TM_TL_PROXIMITY] > 0.5) return 1;
  if ((effects & TM_FX_PLASTICITY) &&
      tm_field_row(&a->state, TM_F_PSTRAIN, i)[0] - k[TM_TL_PSTRAIN] > a->threshold) /* F14: adapt_thresh */
    return 1;
  return (a->threshold < 1e300) && (effects & TM_FX_DAMAGE) &&
         tm_field_row(&a->state, TM_F_DAMAGE, i)[tm_column(1)] > 0.5;
}

/* Has a total-Lagrangian particle yielded so far beyond the threshold that it cannot wait for the next regular step
   of decision? */
#define TM_FREEZE_URGENT 1e-3
TM_FN int tm_freeze_is_urgent(int i, const tm_freeze_args *a)
{
  const tm_real *k = a->history + (ptrdiff_t) i * TM_TL_HISTORY;
  return !a->is_ul[i] &&
         tm_field_row(&a->state, TM_F_PSTRAIN, i)[0] - k[TM_TL_PSTRAIN] > a->threshold + TM_FREEZE_URGENT;
}

/* Is the Green-Lagrange strain of its isochoric part since the freezing above the limit? E = J F^T, J = det F. */
TM_FN int tm_freeze_strained(const tm_freeze_args *a, tm_mat3 E, int dim3)
{
  if (!(a->threshold < 1e300) || !(a->strain < 1e300)) return 0;
  const tm_mat3 C = tm_mat_mul(E, tm_mat_transposed(E));
  const tm_real det = fabs(tm_mat_det(E, dim3)), J = dim3 ? sqrt(sqrt(det)) : cbrt(det), s = 1.0 / (J * J);
  const tm_real xx = s * C.xx - 1.0, yy = s * C.yy - 1.0, zz = dim3 ? s * C.zz - 1.0 : 0.0;
  const tm_real shear = C.xy * C.xy + (dim3 ? C.xz * C.xz + C.yz * C.yz : 0.0);
  const tm_real strain2 = 0.25 * (xx * xx + yy * yy + zz * zz + 2.0 * s * s * shear);
  return !(strain2 <= a->strain * a->strain);
}

/* Would gradients, times E, exceed TM_TL_SLOPE_RANGE? */
TM_FN int tm_freeze_out_of_range(tm_mat3 E)
{
  const tm_real x2 = E.xx * E.xx + E.xy * E.xy + E.xz * E.xz, y2 = E.yx * E.yx + E.yy * E.yy + E.yz * E.yz;
  const tm_real z2 = E.zx * E.zx + E.zy * E.zy + E.zz * E.zz;
  return !(tm_max(tm_max(x2, y2), z2) <= TM_TL_SLOPE_RANGE * TM_TL_SLOPE_RANGE);
}

/* First pass: is particle i updated-Lagrangian in the next step? One that is stays so until pairs are frozen. */
TM_FN int tm_freeze_decide(int i, const tm_freeze_args *a, unsigned effects)
{
  const int dim3 = (effects & TM_FX_3D) != 0;
  const tm_real *k = a->history + (ptrdiff_t) i * TM_TL_HISTORY;
  int ul = (tm_is_ul(k) && !a->freezes) || tm_freeze_yields(i, a, effects);
  if (a->freezes) {
    const tm_real rho = tm_main_record(&a->rec, i)[tm_part(TM_REC_RHO)];
    int good;
    const tm_mat3 E = tm_mat_inverse(tm_mat_scale(rho, tm_freeze_map(i, a)), dim3, &good);
    tm_mat_store(a->pull_back + (ptrdiff_t) i * TM_FREEZE_EXPORT, E);
    ul = ul || !good || tm_freeze_strained(a, E, dim3) || (!a->permanent && tm_freeze_out_of_range(E));
  }
  a->next_ul[i] = ul;
  return ul;
}

/* Weights of pair ij at the current positions into entry `to` of row i; returns whether a_i and a_j differ. */
TM_FN int tm_freeze_pair(int i, int j, int to, const tm_freeze_args *a, int kernel, int dim3)
{
  const tm_real *ri = tm_main_record(&a->rec, i), *rj = tm_main_record(&a->rec, j);
  const tm_vec3 d = tm_vec(ri[tm_part(0)] - rj[tm_part(0)], ri[tm_part(1)] - rj[tm_part(1)],
                           dim3 ? ri[tm_part(2)] - rj[tm_part(2)] : 0.0);
  const tm_real r = tm_vec_norm(d), q = r / a->h, slope = tm_kernel_slope(kernel, q), g = slope / q;
  const tm_vec3 w = tm_vec_scale(slope / r, d);
  const tm_real *ei = a->pull_back + (ptrdiff_t) i * TM_FREEZE_EXPORT;
  const tm_real *ej = a->pull_back + (ptrdiff_t) j * TM_FREEZE_EXPORT;
  short *out = tm_weight(&a->rows, i);
#define TM_OUT(c) out[tm_weight_place(&a->rows, c, to)]
  const tm_real per_unit = 1.0 / a->rows.unit;
  const unsigned bits = tm_weight_bits((float) g);
  int two_sided = 0;
  for (int c = 0; c < 3; c++) {
    const short own = tm_weight_whole(per_unit * (ei[3 * c] * w.x + ei[3 * c + 1] * w.y + ei[3 * c + 2] * w.z));
    const short other = tm_weight_whole(per_unit * (ej[3 * c] * w.x + ej[3 * c + 1] * w.y + ej[3 * c + 2] * w.z));
    TM_OUT(TM_W_OWN + c) = own;
    TM_OUT(TM_W_OTHER + c) = other;
    two_sided |= own != other;
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
  return two_sided;
}

/* The row of particle i, which is total-Lagrangian next: pairs whose other end is updated-Lagrangian are removed, those
   of which one end was so are frozen. Returns whether the row changed. */
TM_FN int tm_freeze_row(int i, const tm_freeze_args *a, int kernel, int dim3)
{
  const tm_tl_rows *r = &a->rows;
  const ptrdiff_t stride = r->stride;
  int *row = r->index + r->first[i], n = 0, changed = 0;
  short *w = tm_weight(r, i);
  tm_real *k = a->history + (ptrdiff_t) i * TM_TL_HISTORY;
  int two_sided = !a->was_ul[i] && k[TM_TL_TWO_SIDED] > 0.5;
  for (int e = 0; e < r->tl[i]; e++) {
    const int j = row[e * stride];
    if (a->is_ul[j]) continue;
    if (n < e) {
      row[n * stride] = j;
      for (int c = 0; c < TM_WEIGHTS; c++) w[tm_weight_place(r, c, n)] = w[tm_weight_place(r, c, e)];
    }
    n++;
  }
  changed = n < r->tl[i];
  if (a->freezes) {
    const tm_real *ri = tm_main_record(&a->rec, i);
    const int *candidate = a->candidates.index + a->candidates.first[i];
    for (int e = 0; e < a->candidates.mechanical[i]; e++) {
      const int j = candidate[e * a->candidates.stride];
      if (a->is_ul[j] || !(a->was_ul[i] || a->was_ul[j])) continue;
      const tm_real *rj = tm_main_record(&a->rec, j);
      const tm_real dx = ri[tm_part(0)] - rj[tm_part(0)], dy = ri[tm_part(1)] - rj[tm_part(1)];
      const tm_real dz = dim3 ? ri[tm_part(2)] - rj[tm_part(2)] : 0.0;
      if (!(dx * dx + dy * dy + dz * dz < a->support_radius2)) continue;
      row[n * stride] = j;
      two_sided |= tm_freeze_pair(i, j, n++, a, kernel, dim3);
      changed = 1;
    }
  }
  r->tl[i] = n;
  for (int e = n; e < tm_tl_padded(n); e++) {
    row[e * stride] = i;
    for (int c = 0; c < TM_WEIGHTS; c++) w[tm_weight_place(r, c, e)] = 0;
  }
  k[TM_TL_TWO_SIDED] = two_sided;
  return changed;
}

/* Second pass, after communication to the ghosts: row and history of particle i. */
TM_FN void tm_freeze(int i, const tm_freeze_args *a, unsigned effects)
{
  const int kernel = tm_fx_kernel(effects), dim3 = (effects & TM_FX_3D) != 0;
  tm_real *k = a->history + (ptrdiff_t) i * TM_TL_HISTORY;
  const int was_ul = a->was_ul[i], will = a->is_ul[i], dirty = a->dirty && a->dirty[i];
  const tm_real plastic = (effects & TM_FX_PLASTICITY) ? tm_field_row(&a->state, TM_F_PSTRAIN, i)[0] : 0.0;
  k[TM_TL_WAS_UL] = was_ul;
  k[TM_TL_UL_STEPS] += was_ul;
  k[TM_TL_IS_UL] = will;
  if (will) {
    a->rows.tl[i] = 0;
    /* a particle that has just yielded may be frozen after as much plastic strain as the others */
    if (!was_ul) k[TM_TL_PSTRAIN] = plastic - 2.0 * (a->threshold < 1e300 ? a->threshold : 0.0) - 1e-300;
    else if (a->freezes) k[TM_TL_PSTRAIN] = plastic;
    return;
  }
  if (!was_ul && !dirty && !a->measures && a->rows.tl[i] > 0) return;
  const tm_mat3 L = tm_mat_from_row(a->gradient + tm_row(i, 9));
  if (was_ul) {
    k[TM_TL_PSTRAIN] = plastic;
    tm_mat_store(k + TM_TL_B, tm_mat_scale(1.0 / tm_main_record(&a->rec, i)[tm_part(TM_REC_RHO)], tm_mat_identity()));
  }
  const int changed = (was_ul || dirty) && tm_freeze_row(i, a, kernel, dim3);
  if (changed || a->measures) {
    /* G at these positions, and extrapolated to the next force point */
    const tm_mat3 G = tm_tl_position_gradient(i, &a->rows, &a->rec, a->slope_norm, dim3, k + TM_TL_SUM);
    const tm_mat3 ahead = tm_mat_add(G, tm_mat_scale(a->dt, tm_mat_mul(L, G)));
    if (changed && !a->corrected)
      tm_mat_store(k + TM_TL_Q, tm_mat_mul(tm_mat_transposed(was_ul ? G : ahead), tm_mat_load(k + TM_TL_B)));
    else if (changed) tm_mat_store(k + TM_TL_Q, tm_mat_identity());
    tm_mat_store(k + TM_TL_G, ahead);
  } else if (was_ul || a->rows.tl[i] == 0) { /* without pairs: B is integrated with L */
    tm_mat_store(k + TM_TL_G, tm_mat_scale(0.0, L));
    tm_tl_advance_map(k, L, a->dt, dim3);
    return;
  }
  tm_tl_advance_map(k, L, 0.0, dim3);
}

#endif
