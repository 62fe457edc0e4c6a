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

#include "tm_tl_rows.h"

/* What a particle exports to total-Lagrangian pairs, besides position and mass: the velocity, A_zz, and the other
   components of A row major. */
enum { TM_TL_EXPORT_V = 0, TM_TL_EXPORT_A = 4, TM_TL_EXPORT = 12 };
TM_FN int tm_tl_export_column(int c) { return c == 8 ? TM_TL_EXPORT_A - 1 : TM_TL_EXPORT_A + c; }

typedef struct {
  tm_tl_rows rows;
  tm_records rec;
  const tm_real *exported;        /* TM_TL_EXPORT, owned and ghost */
  tm_real *history;             /* TM_TL_HISTORY, owned; B and G go on to the next force point */
  tm_real dt;                  /* to that */
  tm_real h, slope_norm;       /* as in tm_rates_args */
  const tm_real *correction;   /* K, 9 in rows: see tm_tl_correction.h. NULL: K = 1 */
  tm_real force_unit;
  int force_begins;            /* as in tm_rates_args */
  /* results; added to those of updated-Lagrangian pairs */
  double *force;
  tm_real *gradient;           /* L, 9 in rows of tm_layout.h */
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
  for (int k = 0; k < r->tl[i]; k += TM_LANES) {    /* padded with weights of 0 */
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

/* What particle i exports, from its record: A = rho P B, with corrected gradients rho P K^T B. */
TM_FN void tm_tl_export(int i, const tm_tl_args *a, tm_real *exported)
{
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
    step.xx += 1.0; step.yy += 1.0; step.zz += 1.0;
    const tm_mat3 back = tm_mat_inverse(step, dim3, &good);
    if (good) B = tm_mat_mul(tm_mat_transposed(back), B);
  }
  if (!dim3) B.xz = B.yz = B.zx = B.zy = 0.0;
  tm_mat_store(history + TM_TL_B, B);
}

/* Columns of a chunk. */
enum {
  TM_TL_COL_EXPORT = 4,
  TM_TL_COL_RHO = TM_TL_COL_EXPORT + TM_TL_EXPORT,    /* with heat conduction; the one before it is not needed */
  TM_TL_COL_HEAT = TM_TL_COL_RHO + 2,
  TM_TL_COL_CONDUCTED = TM_TL_COL_HEAT + TM_REC_HEAT,
  TM_TL_COLS
};

/* Rates of particle i from its total-Lagrangian pairs; effects: TM_FX_3D, VISCOSITY, CONDUCTION. */
TM_FN void tm_tl_rates(int i, const tm_tl_args *a, unsigned effects)
{
  const int dim3 = (effects & TM_FX_3D) != 0, viscosity = (effects & TM_FX_VISCOSITY) != 0;
  const int conduction = (effects & TM_FX_CONDUCTION) != 0;
  const int n_row = a->rows.tl[i], add = a->rows.ul[i] > 0;
  const ptrdiff_t stride = TM_VECTOR >= 32 ? 1 : a->rows.stride;    /* no GPU */
  const int *row = a->rows.index + a->rows.first[i];
  const short *weight = tm_weight(&a->rows, i);
  tm_real *history = a->history + (ptrdiff_t) i * TM_TL_HISTORY;
  const int mixed = history[TM_TL_TWO_SIDED] > 0.5;
#if TM_VECTOR
  const int ahead = stride == 1 && a->rows.tl[i + 1] ? (history[TM_TL_HISTORY + TM_TL_TWO_SIDED] > 0.5 ? 2 : 1) : 0;
#endif

  const tm_real *ri = tm_main_record(&a->rec, i);
  const tm_real xi = ri[tm_part(0)], yi = ri[tm_part(1)], zi = ri[tm_part(2)], mi = ri[tm_part(TM_REC_M)];
  const tm_real vxi = ri[tm_part(4)], vyi = ri[tm_part(5)], vzi = ri[tm_part(6)];
  tm_real ti = 0, ki = 0;
  if (conduction) {
    ti = tm_heat_record(&a->rec, i)[tm_part(TM_REC_T)];
    ki = tm_heat_record(&a->rec, i)[tm_part(TM_REC_K)];
  }
  const tm_real per_r = a->slope_norm / a->h, bulk = per_r / a->h, shock = bulk / a->h;

  const tm_sum zero = tm_lanes_zero();
  tm_sum lxx = zero, lxy = zero, lxz = zero, lyx = zero, lyy = zero, lyz = zero;
  tm_sum lzx = zero, lzy = zero, lzz = zero;
  tm_sum fx = zero, fy = zero, fz = zero;
  tm_sum dxs = zero, dys = zero, dzs = zero, art = zero, heat = zero;

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
    if (TM_COLUMN > 1) {
      tm_transpose_rows(a->rec.main, TM_REC, jj, lanes, TM_TL_COL_EXPORT, col[0]);
      if (conduction) tm_transpose_rows(a->rec.main + TM_REC_RHO - 1, TM_REC, jj, lanes, 2, col[TM_TL_COL_RHO]);
      tm_transpose_rows(a->exported, TM_TL_EXPORT, jj, lanes, TM_TL_EXPORT, col[TM_TL_COL_EXPORT]);
      if (conduction) tm_transpose_rows(a->rec.heat, TM_REC_HEAT, jj, lanes, TM_REC_HEAT, col[TM_TL_COL_HEAT]);
    } else {
      const int j = jj[0];
      for (int c = 0; c < TM_TL_COL_EXPORT; c++) col[c][0] = tm_main_record(&a->rec, j)[tm_part(c)];
      const tm_real *exported = a->exported + (ptrdiff_t) j * TM_TL_EXPORT;
      for (int c = 0; c < TM_TL_EXPORT; c++) col[TM_TL_COL_EXPORT + c][0] = exported[c];
      if (conduction) col[TM_TL_COL_RHO + 1][0] = tm_main_record(&a->rec, j)[tm_part(TM_REC_RHO)];
      for (int c = 0; conduction && c < TM_REC_HEAT; c++)
        col[TM_TL_COL_HEAT + c][0] = tm_heat_record(&a->rec, j)[tm_part(c)];
    }
#define TM_TL_COL(c) col[c][tm_at(l)]
    if (conduction)
      for (int l = 0; l < lanes; l++)
        TM_TL_COL(TM_TL_COL_CONDUCTED) =
            tm_conduction_pair(ki, TM_TL_COL(TM_TL_COL_HEAT + TM_REC_K), ti, TM_TL_COL(TM_TL_COL_HEAT + TM_REC_T),
                               TM_TL_COL(TM_REC_M) / TM_TL_COL(TM_TL_COL_RHO + 1),
                               per_r * tm_weight_slope(&a->rows, weight, k + l));

#define TM_LOAD(c) tm_lanes_load(&TM_TL_COL(c))
#define TM_A(c) TM_LOAD(TM_TL_COL_EXPORT + tm_tl_export_column(c))
#define TM_V(c) TM_LOAD(TM_TL_COL_EXPORT + TM_TL_EXPORT_V + (c))
#define TM_W_AT(c) (((c) < TM_W_OTHER ? own : other) + (ptrdiff_t) ((c) % TM_W_OTHER) * 8 * stride)
#define TM_W(c) tm_weight_lanes(TM_W_AT(c), stride)
#define TM_W_UPPER(c) tm_weight_upper_lanes(TM_W_AT(c), stride)
    for (int l = 0; l < lanes; l += TM_LANES) {
      /* those of the first entry; others of the eight follow, then the next weight: tm_weight_place() */
      const int at = (k + l) / 8 * 8, in = (k + l) % 8;
      const short *own = weight + ((ptrdiff_t) at * TM_W_OTHER + in) * stride;
      const short *other = weight +
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
      const tm_lanes m = TM_LOAD(TM_REC_M);
      const tm_lanes dx = xi - TM_LOAD(0), dy = yi - TM_LOAD(1), vx = vxi - TM_V(0), vy = vyi - TM_V(1);
      const tm_lanes wx = m * TM_W(TM_W_OWN), wy = m * TM_W(TM_W_OWN + 1);
      const tm_lanes ox = mixed ? m * TM_W(TM_W_OTHER) : wx, oy = mixed ? m * TM_W(TM_W_OTHER + 1) : wy;
      tm_lanes dz = zero, vz = zero;
      lxx -= vx * wx; lxy -= vx * wy; lyx -= vy * wx; lyy -= vy * wy;
      fx += TM_A(0) * ox + TM_A(1) * oy;
      fy += TM_A(3) * ox + TM_A(4) * oy;
      if (dim3) {
        const tm_lanes wz = m * TM_W(TM_W_OWN + 2), oz = mixed ? m * TM_W(TM_W_OTHER + 2) : wz;
        dz = zi - TM_LOAD(2);
        vz = vzi - TM_V(2);
        lxz -= vx * wz; lyz -= vy * wz; lzx -= vz * wx; lzy -= vz * wy; lzz -= vz * wz;
        fx += TM_A(2) * oz;
        fy += TM_A(5) * oz;
        fz += TM_A(6) * ox + TM_A(7) * oy + TM_A(8) * oz;
      }
      if (viscosity) {
        tm_lanes closing = vx * dx + vy * dy;
        if (dim3) closing += vz * dz;
        closing = tm_lanes_negative(closing);
        const tm_lanes pi = m * closing * (shock * TM_W_UPPER(TM_W_SHOCK) * closing - bulk * TM_W_UPPER(TM_W_BULK));
        const tm_lanes ax = -pi * dx, ay = -pi * dy, az = dim3 ? -pi * dz : zero;
        dxs += ax; dys += ay; dzs += az;
        art -= ax * vx + ay * vy + az * vz;
      }
      if (conduction) heat += TM_LOAD(TM_TL_COL_CONDUCTED);
    }
#undef TM_W
#undef TM_W_AT
#undef TM_W_UPPER
#undef TM_A
#undef TM_V
#undef TM_LOAD
#undef TM_TL_COL
  }

  const tm_real w = a->slope_norm * a->rows.unit;
  tm_real *B = history + TM_TL_B;
  const tm_real *exported = a->exported + (ptrdiff_t) i * TM_TL_EXPORT;
  tm_real A[9];
  for (int c = 0; c < 9; c++) A[c] = exported[tm_tl_export_column(c)];
  const tm_sum all[16] = {lxx, lxy, lxz, lyx, lyy, lyz, lzx, lzy, lzz, fx, fy, fz, dxs, dys, dzs, art};
  tm_real l[16];
  const tm_real *S = history + TM_TL_SUM, *other_force = l + 9, *artificial_force = l + 12;
  tm_lanes_sums(all, 16, l);
  tm_real *L = a->gradient + tm_row(i, 9);
  for (int r = 0; r < 3; r++) {
    for (int c = 0; c < 3; c++)
      L[tm_column(3 * r + c)] = (add ? L[tm_column(3 * r + c)] : 0.0)
                   + w * (l[3 * r] * B[3 * c] + l[3 * r + 1] * B[3 * c + 1] + l[3 * r + 2] * B[3 * c + 2]);
    if (!a->correction) continue;
    const tm_real *K = a->correction + (ptrdiff_t) i * 9;
    const tm_real x = L[tm_column(3 * r)], y = L[tm_column(3 * r + 1)], z = L[tm_column(3 * r + 2)];
    for (int c = 0; c < 3; c++) L[tm_column(3 * r + c)] = x * K[c] + y * K[3 + c] + z * K[6 + c];
  }
  const tm_real mf = mi * a->force_unit;
  double *f = a->force + 3 * (ptrdiff_t) i;
  if (a->force_begins && !add) f[0] = f[1] = f[2] = 0.0;
  for (int c = 0; c < 3; c++)
    f[c] += mf * (w * (A[3 * c] * S[0] + A[3 * c + 1] * S[1] + A[3 * c + 2] * S[2] + other_force[c])
                  + artificial_force[c]);
  if (viscosity && a->artificial)
    a->artificial[i] = (add ? a->artificial[i] : 0.0) + 0.5 * mi * l[15];
  if (conduction) a->heat[i] = (add ? a->heat[i] : 0.0) + tm_lanes_sum(heat);

  /* to the next force point */
  tm_real *G = history + TM_TL_G;
  for (int c = 0; c < 9; c++) G[c] += a->dt * w * l[c];
  tm_tl_advance_map(history, tm_mat_from_row(L), a->dt, dim3);
}

#endif
