/* SPH-TM: rates of total-Lagrangian (stored-gradient) pairs.

   A pair stores the kernel gradient of the step in which it was frozen, w0 = grad W(x_i - x_j), pulled back to each of
   its ends:
     a_i = E_i w0,  a_j = E_j w0,  E = D^-1,  D_i = F_i^-T / det F_i
   F_i is the deformation gradient of particle i since it was last updated-Lagrangian itself. The gradient that i sees
   now is D_i a_i: it rotates and stretches with i, so a rigid rotation causes no strain rate, and there is no tensile
   instability. With B = D/rho (rho det F is constant: volumes are those of the reference configuration)
     L_i = [sum_j m_j (v_j - v_i) (x) a_i] B_i^T
     m_i dv_i/dt = m_i sum_j m_j (A_i a_i + A_j a_j),   A = rho P B,  P = sigma/rho^2      F15 (4)
   Both ends of a pair hold the same numbers with opposite sign: linear momentum is conserved. L is the work conjugate
   of the forces.

   F follows from the positions of the neighbors,
     G_i = sum_j m_j (x_j - x_i) (x) a_i,   B_i = G_i^-T Q_i
   where Q keeps B as it was when the row last changed; where gradients are corrected and no particle returns to the
   updated-Lagrangian set, Q = 1 and the gradient of a linear field is exact; otherwise see tm_tl_correction.h.
   G is summed when the row changes and every few steps; in between it is integrated with its rate, the sum with
   v_j - v_i that L is made of, at no cost.

   Viscosity and conduction take the stored W'/r and the current x_i - x_j, viscosity also the distance, densities and
   speeds of sound of the freezing step. Total-Lagrangian pairs need no artificial stress and have none. */
#ifndef TM_TL_RATES_H
#define TM_TL_RATES_H

#include "tm_eigen.h"
#include "tm_tl_rows.h"

/* What a particle exports to total-Lagrangian pairs, besides position and mass: the velocity, A_zz, and the other
   components of A row major. */
enum { TM_TL_EXPORT_V = 0, TM_TL_EXPORT_A = 4, TM_TL_EXPORT = 12 };
TM_FN int tm_tl_export_column(int c) { return c == 8 ? TM_TL_EXPORT_A - 1 : TM_TL_EXPORT_A + c; }

typedef struct {
  tm_tl_rows rows;
  tm_records rec;
  const tm_real *exported;   /* TM_TL_EXPORT, owned and ghost */
  tm_real *history;          /* TM_TL_HISTORY, owned; B and G go on to the next force point */
  tm_real dt;                /* to that */
  int lets_go;               /* stored pairs alone are without hourglass control */
  tm_real h, slope_norm;     /* as in tm_rates_args */
  const tm_real *correction; /* K, 9 in rows: see tm_tl_correction.h. NULL: K = 1 */
  tm_real force_unit;
  int force_begins; /* as in tm_rates_args */
  /* results; added to those of updated-Lagrangian pairs */
  double *force;
  tm_real *gradient; /* L, 9 in rows of tm_layout.h */
  tm_real *heat, *artificial;
} tm_tl_args;

/* G of row i at the current positions; S: its TM_TL_SUM. */
TM_FN tm_mat3 tm_tl_position_gradient(int i, const tm_tl_rows *r, const tm_records *rec, tm_real slope_norm, int dim3,
                                      tm_real *S)
{
  const tm_real *ri = tm_main_record(rec, i);
  const tm_real xi = ri[tm_part(0)], yi = ri[tm_part(1)], zi = ri[tm_part(2)];
  const int *row = r->index + r->first[i];
  const short *w = tm_weight(r, i);
  tm_sum sum[12];
  for (int c = 0; c < 12; c++) sum[c] = tm_lanes_zero();
  int jj[TM_COLUMN];
  tm_pair TM_ALIGNED col[4][TM_COLUMN];
  for (int k = 0; k < r->tl[i]; k += TM_LANES) { /* padded with weights of 0 */
    for (int l = 0; l < TM_LANES; l++) jj[tm_at(l)] = row[(k + l) * r->stride];
    if (TM_COLUMN > 1) tm_transpose_rows(rec->main, TM_REC, jj, TM_LANES, 4, col[0]);
    else tm_fetch(tm_main_record(rec, jj[0]), 4, col[0]);
    const tm_lanes m = tm_lanes_load(col[TM_REC_M]);
    const tm_lanes d[3] = {tm_lanes_load(col[0]) - xi, tm_lanes_load(col[1]) - yi, tm_lanes_load(col[2]) - zi};
    for (int c = 0; c < (dim3 ? 3 : 2); c++) {
      const tm_lanes mw = m * tm_weight_lanes(w + tm_weight_place(r, TM_W_OWN + c, k), r->stride);
      for (int e = 0; e < (dim3 ? 3 : 2); e++) sum[3 * e + c] += d[e] * mw;
      sum[9 + c] += mw;
    }
  }
  tm_real G[12];
  tm_lanes_sums(sum, 12, G);
  for (int c = 0; c < 3; c++) S[c] = G[9 + c];
  return tm_mat_scale(slope_norm * r->unit, tm_mat_load(G));
}

/* Hourglass control has no hold on a particle all of whose pairs are stored, unless it was asked for: its row is not summed. */
TM_FN void tm_tl_let_go(int i, const tm_tl_args *a)
{
  if (!a->lets_go || !a->rec.hourglass || a->rows.tl[i] == 0 || a->rows.ul[i] > 0) return;
  tm_real *hourglass = a->rec.hourglass + (ptrdiff_t) i * TM_REC_HOURGLASS;
  for (int c = 0; c < TM_REC_HOURGLASS; c++) hourglass[c] = 0.0;
}

/* What particle i exports, from its record: A = rho P B, with corrected gradients rho P K^T B. */
TM_FN void tm_tl_export(int i, const tm_tl_args *a, tm_real *exported)
{
  tm_tl_let_go(i, a);
  const tm_real *r = tm_main_record(&a->rec, i), rho = r[tm_part(TM_REC_RHO)];
  const tm_sym3 P = tm_sym_from_record(r, TM_REC_P);
  tm_mat3 map = tm_mat_load(a->history + (ptrdiff_t) i * TM_TL_HISTORY + TM_TL_B);
  if (a->correction) map = tm_mat_mul(tm_mat_transposed(tm_mat_load(a->correction + (ptrdiff_t) i * 9)), map);
  tm_real B[9], *out = exported + (ptrdiff_t) i * TM_TL_EXPORT;
  tm_mat_store(B, map);
  for (int c = 0; c < 3; c++) {
    const tm_vec3 p = tm_sym_mul_vec(P, tm_vec(B[c], B[3 + c], B[6 + c]));
    out[tm_tl_export_column(c)] = rho * p.x;
    out[tm_tl_export_column(3 + c)] = rho * p.y;
    out[tm_tl_export_column(6 + c)] = rho * p.z;
    out[TM_TL_EXPORT_V + c] = r[tm_part(TM_REC_V + c)];
  }
}

/* B of the next force point, B = G^-T Q from G there; where G is singular (few neighbors) B is integrated with L. */
TM_FN void tm_tl_advance_map(tm_real *history, tm_mat3 L, tm_real dt, int dim3)
{
  int good;
  tm_mat3 B = tm_mat_load(history + TM_TL_B);
  const tm_mat3 inverse = tm_mat_inverse(tm_mat_load(history + TM_TL_G), dim3, &good);
  if (good) B = tm_mat_mul(tm_mat_transposed(inverse), tm_mat_load(history + TM_TL_Q));
  else {
    tm_mat3 step = tm_mat_scale(dt, L);
    step.xx += 1.0;
    step.yy += 1.0;
    step.zz += 1.0;
    const tm_mat3 back = tm_mat_inverse(step, dim3, &good);
    if (good) B = tm_mat_mul(tm_mat_transposed(back), B);
  }
  if (!dim3) B.xz = B.yz = B.zx = B.zy = 0.0;
  tm_mat_store(history + TM_TL_B, B);
}

/* The speed of sound in units of the freezing, of particle i: gradients that are stretched by s, the largest stretch of
   F^-T, see waves s times as short, and the time step must follow. 0 without total-Lagrangian pairs. D = F^-T/det F,
   so det F is det D^(-1/4), in two dimensions det D^(-1/3). */
TM_FN tm_real tm_tl_fastest(int i, const tm_tl_args *a, unsigned effects)
{
  const int dim3 = (effects & TM_FX_3D) != 0;
  if (a->rows.tl[i] == 0) return 0.0;
  const tm_real *r = tm_main_record(&a->rec, i), c = r[tm_part(TM_REC_C)];
  tm_mat3 D = tm_mat_scale(r[tm_part(TM_REC_RHO)], tm_mat_load(a->history + (ptrdiff_t) i * TM_TL_HISTORY + TM_TL_B));
  if (!dim3) {
    D.xz = D.yz = D.zx = D.zy = 0.0;
    D.zz = 1.0;
  }
  const tm_real det = fabs(tm_mat_det(D, dim3)); /* D.zz = 1 in two dimensions */
  if (!(det > 0.0)) return c;
  const tm_real J = dim3 ? 1.0 / sqrt(sqrt(det)) : 1.0 / cbrt(det);
  const tm_mat3 C = tm_mat_scale(J * J, tm_mat_mul(D, tm_mat_transposed(D)));
  const tm_eigen e = tm_sym_eigen(tm_sym(C.xx, C.yy, dim3 ? C.zz : 1.0, C.xy, C.xz, C.yz));
  return c * sqrt(tm_max(tm_max(e.value[0], e.value[1]), tm_max(e.value[2], 1.0)));
}

/* Columns of a chunk. */
enum {
  TM_TL_COL_EXPORT = 4,
  TM_TL_COL_RHO = TM_TL_COL_EXPORT + TM_TL_EXPORT, /* with heat conduction; the one before it is not needed */
  TM_TL_COL_HEAT = TM_TL_COL_RHO + 2,
  TM_TL_COL_CONDUCTED = TM_TL_COL_HEAT + TM_REC_HEAT,
  TM_TL_COLS
};

/* Three weights that follow each other, for TM_LANES entries. */
TM_FN tm_lanes_vec tm_weight_vec(const short *w, ptrdiff_t stride)
{
  const tm_lanes_vec v = {tm_weight_lanes(w, stride), tm_weight_lanes(w + 8 * stride, stride),
                          tm_weight_lanes(w + 16 * stride, stride)};
  return v;
}

/* Sums over the pairs of a row, in units of the weights; their order is that of tm_tl_results(). */
typedef struct {
  tm_sum_mat gradient;
  tm_sum_vec force, artificial_force;
  tm_sum artificial, heat;
} tm_tl_sums;

/* Columns of the neighbors jj, as many as `lanes`. */
TM_FN void tm_tl_fetch(const tm_tl_args *a, const int *jj, int lanes, int conduction, tm_values *col)
{
  tm_fetch_records(a->rec.main, TM_REC, 0, TM_TL_COL_EXPORT, jj, lanes, col[0]);
  if (conduction) tm_fetch_records(a->rec.main, TM_REC, TM_REC_RHO - 1, 2, jj, lanes, col[TM_TL_COL_RHO]);
  tm_fetch_rows(a->exported, TM_TL_EXPORT, jj, lanes, col[TM_TL_COL_EXPORT]);
  if (conduction) tm_fetch_records(a->rec.heat, TM_REC_HEAT, 0, TM_REC_HEAT, jj, lanes, col[TM_TL_COL_HEAT]);
}

/* Sums of particle i into the results: L = gradient B^T, times K of tm_tl_correction.h; the force F15 (4) of its own A,
   whose sum over a_i is stored, and of its neighbors' A. B and G go on to the next force point. */
TM_FN void tm_tl_results(int i, const tm_tl_args *a, const tm_tl_sums *s, int viscosity, int conduction, int dim3)
{
  const int add = a->rows.ul[i] > 0;
  const tm_real w = a->slope_norm * a->rows.unit, mi = tm_main_record(&a->rec, i)[tm_part(TM_REC_M)];
  tm_real *history = a->history + (ptrdiff_t) i * TM_TL_HISTORY, *B = history + TM_TL_B, *G = history + TM_TL_G;
  const tm_real *S = history + TM_TL_SUM, *exported = a->exported + (ptrdiff_t) i * TM_TL_EXPORT;
  tm_real A[9], l[16];
  for (int c = 0; c < 9; c++) A[c] = exported[tm_tl_export_column(c)];
  const tm_sum_mat *g = &s->gradient;
  /* clang-format off */
  const tm_sum all[16] = {g->xx, g->xy, g->xz, g->yx, g->yy, g->yz, g->zx, g->zy, g->zz,
                          s->force.x, s->force.y, s->force.z, s->artificial_force.x, s->artificial_force.y,
                          s->artificial_force.z, s->artificial};
  /* clang-format on */
  const tm_real *other_force = l + 9, *artificial_force = l + 12;
  tm_lanes_sums(all, 16, l);
  tm_real *L = a->gradient + tm_row(i, 9);
  for (int r = 0; r < 3; r++) {
    for (int c = 0; c < 3; c++)
      L[tm_column(3 * r + c)] = (add ? L[tm_column(3 * r + c)] : 0.0) +
                                w * (l[3 * r] * B[3 * c] + l[3 * r + 1] * B[3 * c + 1] + l[3 * r + 2] * B[3 * c + 2]);
    if (!a->correction) continue;
    const tm_real *K = a->correction + (ptrdiff_t) i * 9;
    const tm_real x = L[tm_column(3 * r)], y = L[tm_column(3 * r + 1)], z = L[tm_column(3 * r + 2)];
    for (int c = 0; c < 3; c++) L[tm_column(3 * r + c)] = x * K[c] + y * K[3 + c] + z * K[6 + c];
  }
  const tm_real mf = mi * a->force_unit;
  double *f = a->force + 3 * (ptrdiff_t) i;
  if (a->force_begins && !add) f[0] = f[1] = f[2] = 0.0;
  for (int c = 0; c < 3; c++)
    f[c] +=
        mf * (w * (A[3 * c] * S[0] + A[3 * c + 1] * S[1] + A[3 * c + 2] * S[2] + other_force[c]) + artificial_force[c]);
  if (viscosity && a->artificial) a->artificial[i] = (add ? a->artificial[i] : 0.0) + 0.5 * mi * l[15];
  if (conduction) a->heat[i] = (add ? a->heat[i] : 0.0) + tm_lanes_sum(s->heat);
  for (int c = 0; c < 9; c++) G[c] += a->dt * w * l[c];
  tm_tl_advance_map(history, tm_mat_from_row(L), a->dt, dim3);
}

/* Rates of particle i from its total-Lagrangian pairs; effects: TM_FX_3D, VISCOSITY, CONDUCTION. */
TM_FN void tm_tl_rates(int i, const tm_tl_args *a, unsigned effects)
{
  const int dim3 = (effects & TM_FX_3D) != 0, viscosity = (effects & TM_FX_VISCOSITY) != 0;
  const int conduction = (effects & TM_FX_CONDUCTION) != 0, n_row = a->rows.tl[i];
  const ptrdiff_t stride = TM_VECTOR >= 32 ? 1 : a->rows.stride; /* no GPU */
  const int *row = a->rows.index + a->rows.first[i];
  const short *weight = tm_weight(&a->rows, i);
  const tm_real *history = a->history + (ptrdiff_t) i * TM_TL_HISTORY;
  const int mixed = history[TM_TL_TWO_SIDED] > 0.5;
#if TM_VECTOR
  const int ahead = stride == 1 && a->rows.tl[i + 1] ? (history[TM_TL_HISTORY + TM_TL_TWO_SIDED] > 0.5 ? 2 : 1) : 0;
#endif

  const tm_real *ri = tm_main_record(&a->rec, i);
  const tm_real x[3] = {ri[tm_part(0)], ri[tm_part(1)], ri[tm_part(2)]};
  const tm_real vi[3] = {ri[tm_part(4)], ri[tm_part(5)], ri[tm_part(6)]};
  const tm_real ti = conduction ? tm_heat_record(&a->rec, i)[tm_part(TM_REC_T)] : 0.0;
  const tm_real ki = conduction ? tm_heat_record(&a->rec, i)[tm_part(TM_REC_K)] : 0.0;
  /* units of the frozen W'/r, and of the factors of tm_viscosity_factors() */
  const tm_real per_r = a->slope_norm / a->h, bulk = per_r / a->h, shock = bulk / a->h;
  tm_tl_sums s;
  s.gradient = tm_sum_mat_zero();
  s.force = s.artificial_force = tm_sum_vec_zero();
  s.artificial = s.heat = tm_lanes_zero();

  int some[TM_COLUMN];
  tm_pair TM_ALIGNED col[TM_TL_COLS][TM_COLUMN];
  for (int k = 0; k < n_row; k += TM_CHUNK) {
    const int n = n_row - k < TM_CHUNK ? n_row - k : TM_CHUNK;
    const int lanes = TM_COLUMN == 1 ? 1 : (n + TM_LANES - 1) / TM_LANES * TM_LANES;
    const int *entry = row + k * stride, *jj = entry;
    if (stride != 1) {
      for (int l = 0; l < lanes; l++) some[tm_at(l)] = entry[l * stride];
      jj = some;
    }
    tm_tl_fetch(a, jj, lanes, conduction, col);
    if (conduction) /* F15 (6) */
      for (int l = 0; l < lanes; l++) {
        const int m = tm_at(l);
        col[TM_TL_COL_CONDUCTED][m] =
            tm_conduction_pair(ki, col[(int) TM_TL_COL_HEAT + TM_REC_K][m], ti, col[(int) TM_TL_COL_HEAT + TM_REC_T][m],
                               col[TM_REC_M][m], col[TM_TL_COL_RHO + 1][m],
                               per_r * tm_weight_slope(&a->rows, weight, k + l));
      }

    for (int l = 0; l < lanes; l += TM_LANES) {
      /* those of the first entry; others of the eight follow, then the next weight: tm_weight_place() */
      const int at = (k + l) / 8 * 8, in = (k + l) % 8;
      const short *own = weight + ((ptrdiff_t) at * TM_W_OTHER + in) * stride;
      const short *other =
          weight +
          ((ptrdiff_t) TM_W_OTHER * a->rows.capacity + (ptrdiff_t) at * (TM_W_SLOPE - TM_W_OTHER) + in) * stride;
#if TM_VECTOR
      /* the next row lies far away, and memory is slow: it is asked for in good time, a part at a time */
      if (ahead && l % 8 == 0) {
        const short *w = own + a->rows.capacity * TM_WEIGHTS;
        __builtin_prefetch(w);
        __builtin_prefetch(w + 32);
        if (l % 16 == 0) __builtin_prefetch(row + a->rows.capacity + k + l);
        if (ahead > 1) __builtin_prefetch(other + a->rows.capacity * TM_WEIGHTS);
      }
#endif
      const tm_lanes m = tm_values_load(col[TM_REC_M], l);
      const tm_lanes_vec d = tm_pair_difference(x, col, l, dim3);                                      /* x_i - x_j */
      const tm_lanes_vec v = tm_pair_difference(vi, col + TM_TL_COL_EXPORT + TM_TL_EXPORT_V, l, dim3); /* v_i - v_j */
      const tm_lanes_vec ai = tm_lanes_scale(m, tm_weight_vec(own, stride));                           /* m_j a_i */
      const tm_lanes_vec aj = mixed ? tm_lanes_scale(m, tm_weight_vec(other, stride)) : ai;            /* m_j a_j */
#define TM_A(c) tm_values_load(col[TM_TL_COL_EXPORT + tm_tl_export_column(c)], l)
      const tm_lanes_mat A = {TM_A(0), TM_A(1), TM_A(2), TM_A(3), TM_A(4), TM_A(5), TM_A(6), TM_A(7), TM_A(8)};
#undef TM_A
      tm_pair_gradient(&s.gradient, v, ai, dim3); /* sum of m_j (v_j - v_i) (x) a_i */
      tm_pair_momentum(&s.force, A, aj, dim3);    /* F15 (4): sum of m_j A_j a_j */
      if (viscosity) {                            /* F14 (15) */
        const tm_lanes pi = tm_pair_viscosity_frozen(m, tm_lanes_dot(v, d, dim3), shock,
                                                     tm_weight_upper_lanes(own + TM_W_SHOCK * 8 * stride, stride), bulk,
                                                     tm_weight_upper_lanes(own + TM_W_BULK * 8 * stride, stride));
        const tm_lanes_vec f = {-pi * d.x, -pi * d.y,
                                -pi * d.z}; /* not scaled by a -pi: the products round as before */
        tm_pair_artificial(&s.artificial_force, &s.artificial, f, v);
      }
      if (conduction) s.heat += tm_values_load(col[TM_TL_COL_CONDUCTED], l);
    }
  }
  tm_tl_results(i, a, &s, viscosity, conduction, dim3);
}

#endif
