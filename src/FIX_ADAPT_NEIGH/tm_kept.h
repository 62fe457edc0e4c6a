/* SPH-TM: rows that are kept from one step to the next, and the rates of their pairs.

   A pair keeps the gradient of the kernel at its last search, w0 = grad W(x_i - x_j), pulled back to
   each of its ends:
     a_i = E_i w0,  a_j = E_j w0,  E = D^-1,  D_i = F_i^-T / det F_i
   F_i is the deformation of particle i since it was searched itself. The gradient that i sees now is
   D_i a_i: it turns and stretches with i, so a rigid rotation makes no strain rate, and there is no
   tensile instability. With B = D/rho (rho det F stays: total-Lagrangian volumes follow from it)
     L_i = [sum_j m_j (v_j - v_i) (x) a_i] B_i^T
     m_i a_i = m_i sum_j m_j (A_i a_i + A_j a_j),   A = rho P B,  P = sigma/rho^2      F15 (4)
   Both ends of a pair hold the same numbers with opposite sign: linear momentum stays. L is the work
   conjugate of the forces.

   F is not integrated, which would drift. From the positions of each step
     G_i = sum_j m_j (x_j - x_i) (x) a_i,   B_i = G_i^-T Q_i
   where Q holds B as it was when the row last changed; with corrected gradients Q = 1 and the gradient
   of a linear field is exact. B is predicted by one step, with L.

   Viscosity and conduction take the frozen W'/r and the current x_i - x_j. Artificial stress acts on
   pairs that have been searched since the start, with the f^n of then.

   Weights are in single precision, without units: slope(q) x/r in place of grad W, slope(q)/q in place
   of W'/r. The products are in double: what both ends hold is the same, so nothing is lost. */
#ifndef TM_KEPT_H
#define TM_KEPT_H

#include "tm_rates.h"

enum {
  TM_W_OWN = 0,        /* a_i */
  TM_W_OTHER = 3,      /* a_j */
  TM_W_SLOPE = 6,      /* slope(q)/q */
  TM_W_TENSILE,        /* f^n */
  TM_W_DISTANCE,       /* q = r/h at the search */
  TM_WEIGHTS
};

/* Entry k of row i is index[first[i] + k stride]; kept ones come first, then those searched in this
   step. Weight c of it: see tm_weight(). */
typedef struct {
  int *index, *kept, *fresh;
  const ptrdiff_t *first;
  ptrdiff_t *fresh_first;      /* where those searched in this step begin */
  ptrdiff_t stride;
  int capacity;
  float *weight;
} tm_kept_rows;

/* Weight 0 of entry 0 of row i; that of entry k is k stride further on, weight c c capacity stride. */
TM_FN float *tm_weight(const tm_kept_rows *r, int i)
{
  const ptrdiff_t lane = i % r->stride;
  return r->weight + (r->first[i] - lane) * TM_WEIGHTS + lane;
}

/* Rows that the ordinary rates are for: those with pairs searched in this step, and empty ones. */
TM_FN int tm_kept_active(int i, const tm_kept_rows *r) { return r->fresh[i] > 0 || r->kept[i] == 0; }

/* What a particle shows of itself to kept pairs: A row major and the sound speed. */
enum { TM_KEPT_C = 9, TM_KEPT = 10 };

enum { TM_NEAR_HOLD = 10 };

/* Memory of a particle. */
enum {
  TM_K_B = 0,          /* B at the next force point */
  TM_K_Q = 9,
  TM_K_PSTRAIN = 18,   /* plastic strain when it was searched last */
  TM_K_SEARCHED = 19,  /* to be searched in the coming step: 1 */
  TM_K_MARK = 20,      /* was searched in the last step: 1 */
  TM_K_SEARCHES = 21,  /* how often */
  TM_K_NEAR = 22,      /* above 0: something came near, slid or went; for how long to go on searching */
  TM_K = 23
};

typedef struct {
  tm_kept_rows rows;
  tm_records rec;
  const tm_real *shown;        /* TM_KEPT, owned and ghost */
  const tm_real *memory;       /* TM_K, owned */
  tm_real h, slope_norm;       /* as in tm_rates_args */
  tm_real visc_alpha, visc_beta, force_unit;
  int force_begins;            /* as in tm_rates_args */
  /* results; added to those of the pairs searched in this step */
  double *force;
  tm_real *gradient;           /* L, 9 in rows of tm_layout.h */
  tm_real *heat, *artificial;
  tm_real *stretch;            /* G, 9 */
} tm_kept_args;

/* A symmetric tensor from columns c on of a record. */
TM_FN tm_sym3 tm_kept_sym(const tm_real *r, int c)
{
  return tm_sym(r[tm_part(c)], r[tm_part(c + 1)], r[tm_part(c + 2)], r[tm_part(c + 3)], r[tm_part(c + 4)],
                r[tm_part(c + 5)]);
}

/* What particle i shows, from its record. */
TM_FN void tm_kept_show(int i, const tm_kept_args *a, tm_real *shown)
{
  const tm_real *r = tm_main_record(&a->rec, i), rho = r[tm_part(TM_REC_RHO)];
  const tm_sym3 P = tm_kept_sym(r, TM_REC_P);
  const tm_real *B = a->memory + (ptrdiff_t) i * TM_K + TM_K_B;
  tm_real *out = shown + (ptrdiff_t) i * TM_KEPT;
  for (int c = 0; c < 3; c++) {
    const tm_vec3 p = tm_sym_mul_vec(P, tm_vec(B[c], B[3 + c], B[6 + c]));
    out[c] = rho * p.x;
    out[3 + c] = rho * p.y;
    out[6 + c] = rho * p.z;
  }
  out[TM_KEPT_C] = r[tm_part(TM_REC_C)];
}

/* Columns of a chunk. */
enum {
  TM_KCOL_SHOWN = 8,
  TM_KCOL_STRESS = TM_KCOL_SHOWN + TM_KEPT,
  TM_KCOL_HEAT = TM_KCOL_STRESS + TM_REC_STRESS,
  TM_KCOL_WEIGHT = TM_KCOL_HEAT + TM_REC_HEAT,
  TM_KCOL_VISCOUS = TM_KCOL_WEIGHT + TM_WEIGHTS, /* m_j Pi W'/r */
  TM_KCOL_CONDUCTED,
  TM_KCOLS
};

/* Rates of particle i from its kept pairs; effects: TM_FX_3D, VISCOSITY, ARTSTRESS, CONDUCTION. */
TM_FN void tm_kept_rates(int i, const tm_kept_args *a, unsigned effects)
{
  const int dim3 = (effects & TM_FX_3D) != 0, viscosity = (effects & TM_FX_VISCOSITY) != 0;
  const int conduction = (effects & TM_FX_CONDUCTION) != 0;
  const int n_row = a->rows.kept[i], add = a->rows.fresh[i] > 0;
  const ptrdiff_t stride = a->rows.stride, next = a->rows.capacity * stride;
  const int *row = a->rows.index + a->rows.first[i];
  const float *weight = tm_weight(&a->rows, i);

  const tm_real *ri = tm_main_record(&a->rec, i);
  const tm_real xi = ri[tm_part(0)], yi = ri[tm_part(1)], zi = ri[tm_part(2)], mi = ri[tm_part(TM_REC_M)];
  const tm_real vxi = ri[tm_part(4)], vyi = ri[tm_part(5)], vzi = ri[tm_part(6)];
  const tm_real rhoi = ri[tm_part(TM_REC_RHO)], ci = ri[tm_part(TM_REC_C)];
  tm_sym3 qi = tm_sym(0, 0, 0, 0, 0, 0);
  tm_real ti = 0, ki = 0;
  if (effects & TM_FX_ARTSTRESS) qi = tm_kept_sym(tm_stress_record(&a->rec, i), 0);
  if (conduction) {
    ti = tm_heat_record(&a->rec, i)[tm_part(TM_REC_T)];
    ki = tm_heat_record(&a->rec, i)[tm_part(TM_REC_K)];
  }
  const tm_real h = a->h, per_r = a->slope_norm / h, alpha = a->visc_alpha, beta = a->visc_beta;

  const tm_sum zero = tm_lanes_zero();
  tm_sum lxx = zero, lxy = zero, lxz = zero, lyx = zero, lyy = zero, lyz = zero;
  tm_sum lzx = zero, lzy = zero, lzz = zero;
  tm_sum gxx = zero, gxy = zero, gxz = zero, gyx = zero, gyy = zero, gyz = zero;
  tm_sum gzx = zero, gzy = zero, gzz = zero;
  tm_sum sx = zero, sy = zero, sz = zero, fx = zero, fy = zero, fz = zero;
  tm_sum dxs = zero, dys = zero, dzs = zero, art = zero, heat = zero;

  int jj[TM_COLUMN + 16];
  tm_pair TM_ALIGNED col[TM_KCOLS][TM_COLUMN];
  for (int k = 0; k < n_row; k += TM_CHUNK) {
    const int n = n_row - k < TM_CHUNK ? n_row - k : TM_CHUNK;
    const int lanes = TM_COLUMN == 1 ? 1 : (n + TM_LANES - 1) / TM_LANES * TM_LANES;
    const int *entry = row + k * stride;
    int tense = 0;
    if (TM_COLUMN > 1 && stride == 1) {
      for (int l = 0; l < n; l++) jj[tm_at(l)] = entry[l];
      for (int c = 0; c < TM_W_DISTANCE; c++) {
        const float *w = weight + c * next + k;
#pragma omp simd
        for (int l = 0; l < n; l++) col[TM_KCOL_WEIGHT + c][tm_at(l)] = w[l];
      }
#pragma omp simd reduction(+ : tense)
      for (int l = 0; l < n; l++) tense += weight[TM_W_TENSILE * next + k + l] > 0.0f;
    } else {
      for (int l = 0; l < n; l++) jj[tm_at(l)] = entry[l * stride];
      for (int c = 0; c < TM_W_DISTANCE; c++)
        for (int l = 0; l < n; l++) col[TM_KCOL_WEIGHT + c][tm_at(l)] = weight[c * next + (k + l) * stride];
      for (int l = 0; l < n; l++) tense += col[TM_KCOL_WEIGHT + TM_W_TENSILE][tm_at(l)] > 0;
    }
    for (int l = n; l < lanes; l++) {
      jj[tm_at(l)] = i;
      for (int c = 0; c < TM_W_DISTANCE; c++) col[TM_KCOL_WEIGHT + c][tm_at(l)] = 0;
    }
    /* artificial stress acts on few rows */
    const int artstress = (effects & TM_FX_ARTSTRESS) && tense > 0;
    if (TM_COLUMN > 1) {
      tm_transpose_rows(a->rec.main, TM_REC, jj, lanes, TM_KCOL_SHOWN, col[0]);
      tm_transpose_rows(a->shown, TM_KEPT, jj, lanes, TM_KEPT, col[TM_KCOL_SHOWN]);
      if (artstress)
        tm_transpose_rows(a->rec.stress, TM_REC_STRESS, jj, lanes, TM_REC_STRESS, col[TM_KCOL_STRESS]);
      if (conduction) tm_transpose_rows(a->rec.heat, TM_REC_HEAT, jj, lanes, TM_REC_HEAT, col[TM_KCOL_HEAT]);
    } else {
      const int j = jj[0];
      for (int c = 0; c < TM_KCOL_SHOWN; c++) col[c][0] = tm_main_record(&a->rec, j)[tm_part(c)];
      for (int c = 0; c < TM_KEPT; c++) col[TM_KCOL_SHOWN + c][0] = a->shown[(ptrdiff_t) j * TM_KEPT + c];
      for (int c = 0; artstress && c < TM_REC_STRESS; c++)
        col[TM_KCOL_STRESS + c][0] = tm_stress_record(&a->rec, j)[tm_part(c)];
      for (int c = 0; conduction && c < TM_REC_HEAT; c++)
        col[TM_KCOL_HEAT + c][0] = tm_heat_record(&a->rec, j)[tm_part(c)];
    }
#define TM_KCOL(c) col[c][tm_at(l)]

    if (viscosity || conduction) {
#if !defined(__CUDACC__)
#pragma omp simd
#endif
      for (int l = 0; l < lanes; l++) {
        const tm_real m = TM_KCOL(TM_REC_M), rhoj = TM_KCOL(TM_REC_RHO);
        const tm_real g = per_r * TM_KCOL(TM_KCOL_WEIGHT + TM_W_SLOPE);
        if (viscosity) {
          const tm_real dx = xi - TM_KCOL(0), dy = yi - TM_KCOL(1), dz = dim3 ? zi - TM_KCOL(2) : 0.0;
          const tm_real vx = vxi - TM_KCOL(4), vy = vyi - TM_KCOL(5), vz = dim3 ? vzi - TM_KCOL(6) : 0.0;
          const tm_real rho2 = rhoi + rhoj, soft2 = tm_viscosity_soft2(h, dx * dx + dy * dy + dz * dz);
          const tm_real inv = 1.0 / (soft2 * rho2);
          const tm_real mu = tm_viscosity_mu(h, vx * dx + vy * dy + vz * dz, rho2 * inv);
          TM_KCOL(TM_KCOL_VISCOUS) =
              m * g * tm_viscosity_pi(alpha, beta, mu, 0.5 * (ci + TM_KCOL(TM_KCOL_SHOWN + TM_KEPT_C)),
                                      2.0 * soft2 * inv);
        }
        if (conduction)
          TM_KCOL(TM_KCOL_CONDUCTED) =
              tm_conduction_pair(ki, TM_KCOL(TM_KCOL_HEAT + TM_REC_K), ti,
                                 TM_KCOL(TM_KCOL_HEAT + TM_REC_T), m / rhoj, g);
      }
    }

#define TM_LOAD(c) tm_lanes_load(&TM_KCOL(c))
#define TM_A(c) TM_LOAD(TM_KCOL_SHOWN + (c))
#define TM_W(c) TM_LOAD(TM_KCOL_WEIGHT + (c))
    for (int l = 0; l < lanes; l += TM_LANES) {
      const tm_lanes m = TM_LOAD(TM_REC_M);
      const tm_lanes dx = xi - TM_LOAD(0), dy = yi - TM_LOAD(1), vx = vxi - TM_LOAD(4), vy = vyi - TM_LOAD(5);
      const tm_lanes wx = m * TM_W(0), wy = m * TM_W(1), ox = m * TM_W(3), oy = m * TM_W(4);
      tm_lanes dz = zero, vz = zero;
      lxx -= vx * wx; lxy -= vx * wy; lyx -= vy * wx; lyy -= vy * wy;
      gxx -= dx * wx; gxy -= dx * wy; gyx -= dy * wx; gyy -= dy * wy;
      sx += wx; sy += wy;
      fx += TM_A(0) * ox + TM_A(1) * oy;
      fy += TM_A(3) * ox + TM_A(4) * oy;
      if (dim3) {
        const tm_lanes wz = m * TM_W(2), oz = m * TM_W(5);
        dz = zi - TM_LOAD(2);
        vz = vzi - TM_LOAD(6);
        lxz -= vx * wz; lyz -= vy * wz; lzx -= vz * wx; lzy -= vz * wy; lzz -= vz * wz;
        gxz -= dx * wz; gyz -= dy * wz; gzx -= dz * wx; gzy -= dz * wy; gzz -= dz * wz;
        sz += wz;
        fx += TM_A(2) * oz;
        fy += TM_A(5) * oz;
        fz += TM_A(6) * ox + TM_A(7) * oy + TM_A(8) * oz;
      }
      if (viscosity || artstress) {
        tm_lanes ax = zero, ay = zero, az = zero;
        if (viscosity) {
          const tm_lanes pi = TM_LOAD(TM_KCOL_VISCOUS);
          ax -= pi * dx; ay -= pi * dy;
          if (dim3) az -= pi * dz;
        }
        if (artstress) {
          const tm_lanes f = per_r * m * TM_W(TM_W_SLOPE) * TM_W(TM_W_TENSILE);
          const int q = TM_KCOL_STRESS;
          ax += f * ((qi.xx + TM_LOAD(q)) * dx + (qi.xy + TM_LOAD(q + 3)) * dy);
          ay += f * ((qi.xy + TM_LOAD(q + 3)) * dx + (qi.yy + TM_LOAD(q + 1)) * dy);
          if (dim3) {
            const tm_lanes qxz = qi.xz + TM_LOAD(q + 4), qyz = qi.yz + TM_LOAD(q + 5);
            ax += f * qxz * dz;
            ay += f * qyz * dz;
            az += f * (qxz * dx + qyz * dy + (qi.zz + TM_LOAD(q + 2)) * dz);
          }
        }
        dxs += ax; dys += ay; dzs += az;
        art -= ax * vx + ay * vy + az * vz;
      }
      if (conduction) heat += TM_LOAD(TM_KCOL_CONDUCTED);
    }
#undef TM_W
#undef TM_A
#undef TM_LOAD
#undef TM_KCOL
  }

  const tm_real w = a->slope_norm;
  const tm_real *B = a->memory + (ptrdiff_t) i * TM_K + TM_K_B, *A = a->shown + (ptrdiff_t) i * TM_KEPT;
  const tm_real l[9] = {tm_lanes_sum(lxx), tm_lanes_sum(lxy), tm_lanes_sum(lxz),
                        tm_lanes_sum(lyx), tm_lanes_sum(lyy), tm_lanes_sum(lyz),
                        tm_lanes_sum(lzx), tm_lanes_sum(lzy), tm_lanes_sum(lzz)};
  tm_real *L = a->gradient + tm_row(i, 9);
  for (int r = 0; r < 3; r++)
    for (int c = 0; c < 3; c++)
      L[tm_column(3 * r + c)] = (add ? L[tm_column(3 * r + c)] : 0.0)
                   + w * (l[3 * r] * B[3 * c] + l[3 * r + 1] * B[3 * c + 1] + l[3 * r + 2] * B[3 * c + 2]);
  tm_real *G = a->stretch + (ptrdiff_t) i * 9;
  G[0] = w * tm_lanes_sum(gxx); G[1] = w * tm_lanes_sum(gxy); G[2] = w * tm_lanes_sum(gxz);
  G[3] = w * tm_lanes_sum(gyx); G[4] = w * tm_lanes_sum(gyy); G[5] = w * tm_lanes_sum(gyz);
  G[6] = w * tm_lanes_sum(gzx); G[7] = w * tm_lanes_sum(gzy); G[8] = w * tm_lanes_sum(gzz);
  const tm_real ux = tm_lanes_sum(sx), uy = tm_lanes_sum(sy), uz = tm_lanes_sum(sz), mf = mi * a->force_unit;
  double *f = a->force + 3 * (ptrdiff_t) i;
  if (a->force_begins && !add) f[0] = f[1] = f[2] = 0.0;
  f[0] += mf * (w * (A[0] * ux + A[1] * uy + A[2] * uz + tm_lanes_sum(fx)) + tm_lanes_sum(dxs));
  f[1] += mf * (w * (A[3] * ux + A[4] * uy + A[5] * uz + tm_lanes_sum(fy)) + tm_lanes_sum(dys));
  f[2] += mf * (w * (A[6] * ux + A[7] * uy + A[8] * uz + tm_lanes_sum(fz)) + tm_lanes_sum(dzs));
  if ((effects & (TM_FX_VISCOSITY | TM_FX_ARTSTRESS)) && a->artificial)
    a->artificial[i] = (add ? a->artificial[i] : 0.0) + 0.5 * mi * tm_lanes_sum(art);
  if (conduction) a->heat[i] = (add ? a->heat[i] : 0.0) + tm_lanes_sum(heat);
}

#endif
