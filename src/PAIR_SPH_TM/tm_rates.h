/* SPH-TM: all rates of one particle in one pass over its neighbours.

   velocity gradient   L_i  = 1/rho_i  sum_j m_j (v_j - v_i) (x) gradW        conjugate of F15 (4)
                       L_i  = sum_j m_j/rho_j (v_j - v_i) (x) gradW           conjugate of F14 (6)
   density             drho_i/dt = -rho_i tr L_i                              F15 (2), F14 (4)
   acceleration        a_i = sum_j m_j (P_i + P_j + f^n (R_i + R_j) - Pi I) gradW   F15 (4), F14 (15)
   heat                rho c_p dT_i/dt = sum_j m_j/rho_j 4 k_i k_j/(k_i + k_j) (T_i - T_j) W'/r
                                                                              F15 (6)
   XSPH                dx_i = eps sum_j m_j/rho_mean (v_j - v_i) W
   surface             n_i = sum_j m_j/rho_j gradW; area of the surface = 2 V_i |n_i|

   With gradient correction (F15 form only) gradW is gradW K_i in L and in the term of P_i, and
   gradW K_j in that of P_j; K comes from tm_moment.h.

   Each velocity gradient is the work conjugate of its momentum form: the power of the pair forces
   equals minus sum V sigma:L minus the artificial heating, to round-off.

   The row is walked in chunks. Neighbours within reach are compacted in row order and their
   records transposed into columns (tm_lanes.h); a loop over columns makes the coefficients of each
   pair; a second one, without a branch or a function call, sums. Neighbour number n of those within
   reach always goes to lane n mod TM_LANES, and rows are sorted by tag: so the sum does not depend
   on where a particle sits in memory, on the skin, the size of a chunk or the number of ranks. On a
   GPU a chunk is one neighbour. */
#ifndef TM_RATES_H
#define TM_RATES_H

#include "tm_artificial.h"
#include "tm_heat.h"
#include "tm_kernel.h"
#include "tm_lanes.h"
#include "tm_record.h"
#include "tm_tensor.h"

/* Neighbour rows: entry k of particle i is index[first[i] + k * stride]. Mechanical neighbours
   come first, then those that only exchange heat, then those of other bodies in contact. */
typedef struct {
  const int *index;
  const ptrdiff_t *first;
  const int *mechanical;   /* number of mechanical neighbours */
  const int *thermal;      /* number of neighbours that only exchange heat */
  const int *contact;      /* number of neighbours of other bodies */
  ptrdiff_t stride;
} tm_rows;

typedef struct {
  tm_rows rows;
  tm_records rec;
  unsigned effects;        /* run-time bits for the extended instantiation */

  tm_real h;               /* smoothing length */
  tm_real reach2;          /* (support * h)^2 */
  tm_real norm;            /* kernel constant, 1/h^dim included */
  tm_real slope_norm;      /* of its slope: norm/h over the lattice's gradient, see tm_lattice.h */
  tm_real visc_alpha, visc_beta;
  int art_n;               /* exponent of the artificial stress */
  tm_real art_inv_w;       /* 1 / shape(dp/h) */
  tm_real xsph;            /* XSPH epsilon, 0..1 */
  tm_real force_unit;      /* mass times acceleration -> force of the unit style */
  const tm_real *conductance;  /* interface conductance per type pair (0: bonded), or NULL */
  const int *type;         /* LAMMPS types, owned and ghost; only with conductance */
  int ntypes;

  /* results, rows of owned particles; added to where said so */
  double *force;           /* 3, added to */
  tm_real *gradient;       /* 9, L row major */
  tm_real *heat;           /* conduction, power per volume, or NULL */
  tm_real *correction;     /* 6, K of tm_moment.h, with correction; read by the rate pass */
  tm_real *xsph_v;         /* 3, with XSPH */
  tm_real *surface;        /* 3, with surface */
  tm_real *artificial;     /* heating by artificial terms, power, or NULL */
} tm_rates_args;

/* Columns of a chunk: first the records, then what the pair functions make of them. */
enum {
  TM_COL_STRESS = TM_REC,
  TM_COL_HEAT = TM_COL_STRESS + TM_REC_STRESS,
  TM_COL_CORRECTION = TM_COL_HEAT + TM_REC_HEAT,
  TM_COL_SLOPE = TM_COL_CORRECTION + TM_REC_CORRECTION, /* m_j W'/r */
  TM_COL_TENSILE,      /* f^n of the artificial stress */
  TM_COL_VISCOUS,      /* Pi */
  TM_COL_CONDUCTED,    /* power per volume into i */
  TM_COL_PER_RHO,      /* 1/rho_j */
  TM_COL_SMOOTH,       /* m_j/rho_mean W */
  TM_COLUMNS
};

/* Appends to jj, n long, the neighbours within reach from entry *k of a row on, until the row ends
   or jj is TM_CHUNK long; returns the new n. Room behind may be overwritten. Where columns have one
   entry, position receives that of the last one looked at. */
TM_FN int tm_within_reach(const tm_real *rec, const int *row, ptrdiff_t stride, int *k, int end,
                          tm_real x, tm_real y, tm_real z, tm_real reach2, int dim3, int *jj, int n,
                          tm_real *position)
{
  (void) position;
#if TM_LANES >= 4
  int block[TM_LANES];
  tm_real TM_ALIGNED col[4][TM_COLUMN];
  for (; *k < end && n < TM_CHUNK; *k += TM_LANES) {
    const int *r = row + *k, left = end - *k;
    if (left < TM_LANES || stride != 1) {
      for (int l = 0; l < TM_LANES; l++) block[l] = row[(l < left ? *k + l : *k) * stride];
      r = block;
    }
    tm_transpose(rec, TM_REC, r, dim3 ? 4 : 2, col[0]);
    const tm_lanes dx = x - tm_lanes_load(col[0]), dy = y - tm_lanes_load(col[1]);
    const tm_lanes dz = dim3 ? z - tm_lanes_load(col[2]) : tm_lanes_zero();
    const tm_lanes r2 = dx * dx + dy * dy + dz * dz;
    const unsigned inside = tm_lanes_below(r2, reach2, left < TM_LANES ? (1u << left) - 1u : 255u);
    n += tm_compress(r, inside, jj + n);
  }
#else
  for (; *k < end && n < TM_CHUNK; ++*k) {
    const int j = row[*k * stride];
    tm_real r[4];
    tm_fetch(rec + (ptrdiff_t) j * TM_REC, 4, r);
    const tm_real dx = x - r[0], dy = y - r[1], dz = dim3 ? z - r[2] : 0.0;
    jj[tm_at(n)] = j;
    n += dx * dx + dy * dy + dz * dz < reach2;
    if (TM_COLUMN == 1)
      for (int c = 0; c < 4; c++) position[c] = r[c];
  }
#endif
  return n;
}

TM_FN void tm_rates(int i, const tm_rates_args *a, unsigned effects)
{
  const int kernel = tm_fx_kernel(effects);
  const unsigned fx =
      (effects & TM_FX_EXTENDED) ? (effects & (TM_FX_3D | TM_FX_KERNEL_MASK)) | a->effects : effects;
  const int dim3 = (effects & TM_FX_3D) != 0;
  const int viscosity = (fx & TM_FX_VISCOSITY) != 0, artstress = (fx & TM_FX_ARTSTRESS) != 0;
  const int conduction = (fx & TM_FX_CONDUCTION) != 0, form_f14 = (fx & TM_FX_FORM_F14) != 0;
  const int correction = (fx & TM_FX_CORRECTION) != 0, balsara = (fx & TM_FX_BALSARA) != 0;
  const int xsph = (fx & TM_FX_XSPH) != 0, surface = (fx & TM_FX_SURFACE) != 0;
  const int per_rho = form_f14 || surface;

  const int *row = a->rows.index + a->rows.first[i];
  const int n_mech = a->rows.mechanical[i];
  const tm_real *TM_RESTRICT rec = a->rec.main;
  const tm_real *TM_RESTRICT rec_s = a->rec.stress;
  const tm_real *TM_RESTRICT rec_t = a->rec.heat;
  const tm_real *TM_RESTRICT rec_c = a->rec.correction;

  const tm_real *ri = rec + (ptrdiff_t) i * TM_REC;
  const tm_real xi = ri[0], yi = ri[1], zi = ri[2], mi = ri[TM_REC_M];
  const tm_real vxi = ri[4], vyi = ri[5], vzi = ri[6], rhoi = ri[TM_REC_RHO];
  const tm_real pxx = ri[8], pyy = ri[9], pzz = ri[10], pxy = ri[11], pxz = ri[12], pyz = ri[13];
  const tm_real ci = ri[TM_REC_C], bi = ri[TM_REC_BALSARA];
  const tm_real inv_rhoi = 1.0 / rhoi;
  tm_real qxx = 0, qyy = 0, qzz = 0, qxy = 0, qxz = 0, qyz = 0, ti = 0, ki = 0;
  tm_real cxx = 0, cxy = 0, cxz = 0, cyx = 0, cyy = 0, cyz = 0, czx = 0, czy = 0, czz = 0;
  if (artstress) {
    const tm_real *q = rec_s + (ptrdiff_t) i * TM_REC_STRESS;
    qxx = q[0]; qyy = q[1]; qzz = q[2]; qxy = q[3]; qxz = q[4]; qyz = q[5];
  }
  if (conduction) {
    ti = rec_t[(ptrdiff_t) i * TM_REC_HEAT + TM_REC_T];
    ki = rec_t[(ptrdiff_t) i * TM_REC_HEAT + TM_REC_K];
  }
  if (correction) {
    const tm_real *c = rec_c + (ptrdiff_t) i * TM_REC_CORRECTION;
    cxx = c[0]; cxy = c[1]; cxz = c[2]; cyx = c[3]; cyy = c[4]; cyz = c[5];
    czx = c[6]; czy = c[7]; czz = c[8];
  }

  const tm_real inv_h = 1.0 / a->h, slope_norm = a->slope_norm, norm = a->norm;
  const tm_real alpha = a->visc_alpha, beta = a->visc_beta, h = a->h, inv_w = a->art_inv_w;
  const int art_n = a->art_n;

  const tm_lanes zero = tm_lanes_zero();
  tm_lanes ax = zero, ay = zero, az = zero, heat = zero, art = zero;
  tm_lanes lxx = zero, lxy = zero, lxz = zero, lyx = zero, lyy = zero, lyz = zero;
  tm_lanes lzx = zero, lzy = zero, lzz = zero;
  tm_lanes ux = zero, uy = zero, uz = zero, nx = zero, ny = zero, nz = zero;

  int jj[TM_COLUMN + TM_LANES];
  jj[0] = i;
  tm_real TM_ALIGNED col[TM_COLUMNS][TM_COLUMN];
  for (int k = 0, n = 0;;) {
    n = tm_within_reach(rec, row, a->rows.stride, &k, n_mech, xi, yi, zi, a->reach2, dim3, jj, n,
                        col[TM_REC_X]);
    if (n == 0) break;

    /* lanes left over wait for the next chunk, or are filled up with copies of i out of reach */
    const int last = TM_COLUMN > 1 && k >= n_mech;
    const int lanes =
        TM_COLUMN == 1 ? 1 : (last ? n + TM_LANES - 1 : n) / TM_LANES * TM_LANES;
    if (TM_COLUMN > 1) {
      for (int l = n; l < lanes; l++) jj[tm_at(l)] = i;
      tm_transpose_rows(rec, TM_REC, jj, lanes, TM_REC, col[0]);
      for (int l = n; l < lanes; l++) col[TM_REC_X][tm_at(l)] = xi + 4.0 * h;
      if (artstress)
        tm_transpose_rows(rec_s, TM_REC_STRESS, jj, lanes, TM_REC_STRESS, col[TM_COL_STRESS]);
      if (conduction)
        tm_transpose_rows(rec_t, TM_REC_HEAT, jj, lanes, TM_REC_HEAT, col[TM_COL_HEAT]);
      if (correction)
        for (int l = 0; l < lanes; l++)
          for (int c = 0; c < TM_REC_CORRECTION; c++)
            col[TM_COL_CORRECTION + c][tm_at(l)] =
                rec_c[jj[tm_at(l)] * (ptrdiff_t) TM_REC_CORRECTION + c];
    } else {
      const ptrdiff_t j = jj[0];
      tm_fetch(rec + j * TM_REC + TM_REC_V, (viscosity ? TM_REC : TM_REC_C) - TM_REC_V, col[TM_REC_V]);
      if (artstress) tm_fetch(rec_s + j * TM_REC_STRESS, TM_REC_STRESS, col[TM_COL_STRESS]);
      if (conduction) tm_fetch(rec_t + j * TM_REC_HEAT, TM_REC_HEAT, col[TM_COL_HEAT]);
      if (correction)
        for (int c = 0; c < TM_REC_CORRECTION; c++)
          col[TM_COL_CORRECTION + c][0] = rec_c[j * TM_REC_CORRECTION + c];
    }
    /* entry l of a column */
#define TM_MAIN(c) TM_COL(c)
#define TM_STRESS(c) TM_COL(TM_COL_STRESS + (c))
#define TM_HEAT(c) TM_COL(TM_COL_HEAT + (c))
#define TM_CORR(c) TM_COL(TM_COL_CORRECTION + (c))
#define TM_COL(c) col[c][tm_at(l)]
#define TM_X(c) TM_COL(TM_REC_X + (c))

    /* coefficients of each pair */
#if !defined(__CUDACC__)
#pragma omp simd
#endif
    for (int l = 0; l < lanes; l++) {
      const tm_real dx = xi - TM_X(0), dy = yi - TM_X(1), dz = dim3 ? zi - TM_X(2) : 0.0;
      const tm_real r2 = dx * dx + dy * dy + dz * dz, r = sqrt(r2), q = r * inv_h;
      const tm_real mj = TM_MAIN(TM_REC_M), rhoj = TM_MAIN(TM_REC_RHO);
      tm_real inv_r;
      if (viscosity) {
        const tm_real vx = vxi - TM_MAIN(4), vy = vyi - TM_MAIN(5);
        const tm_real vz = dim3 ? vzi - TM_MAIN(6) : 0.0;
        const tm_real rho2 = rhoi + rhoj, soft2 = tm_viscosity_soft2(h, r2);
        const tm_real inv = 1.0 / (r2 * (soft2 * rho2));  /* one division for three */
        inv_r = r * (soft2 * rho2) * inv;
        const tm_real mu = tm_viscosity_mu(h, vx * dx + vy * dy + vz * dz, r2 * rho2 * inv);
        tm_real pi = tm_viscosity_pi(alpha, beta, mu, 0.5 * (ci + TM_MAIN(TM_REC_C)),
                                     2.0 * (r2 * soft2) * inv);
        if (balsara) pi *= 0.5 * (bi + TM_MAIN(TM_REC_BALSARA));
        TM_COL(TM_COL_VISCOUS) = pi;
      } else
        inv_r = 1.0 / r;
      const tm_real g = slope_norm * tm_kernel_slope(kernel, q) * inv_r;  /* W'/r */
      TM_COL(TM_COL_SLOPE) = mj * g;
      if (artstress)
        TM_COL(TM_COL_TENSILE) = tm_power_int(tm_kernel_shape(kernel, q) * inv_w, art_n);
      if (conduction)
        TM_COL(TM_COL_CONDUCTED) = tm_conduction_pair(ki, TM_HEAT(TM_REC_K), ti,
                                                      TM_HEAT(TM_REC_T), mj / rhoj, g);
      if (per_rho) TM_COL(TM_COL_PER_RHO) = 1.0 / rhoj;
      if (xsph)
        TM_COL(TM_COL_SMOOTH) =
            tm_xsph_pair(mj, 0.5 * (rhoi + rhoj), norm * tm_kernel_shape(kernel, q));
    }

    /* sums */
#define TM_LOAD(entry) tm_lanes_load(&entry)
    for (int l = 0; l < lanes; l += TM_LANES) {
      const tm_lanes dx = xi - TM_LOAD(TM_X(0)), dy = yi - TM_LOAD(TM_X(1));
      const tm_lanes dz = dim3 ? zi - TM_LOAD(TM_X(2)) : zero;
      const tm_lanes vx = vxi - TM_LOAD(TM_MAIN(4)), vy = vyi - TM_LOAD(TM_MAIN(5));
      const tm_lanes vz = dim3 ? vzi - TM_LOAD(TM_MAIN(6)) : zero;
      const tm_lanes mg = TM_LOAD(TM_COL(TM_COL_SLOPE)), wx = mg * dx, wy = mg * dy, wz = mg * dz;
      const tm_lanes vol = per_rho ? TM_LOAD(TM_COL(TM_COL_PER_RHO)) : zero;

      /* velocity gradient, sum of -v_ij (x) gradW; volume m/rho_j, or m to be divided by rho_i */
      const tm_lanes gx = form_f14 ? vol * wx : wx, gy = form_f14 ? vol * wy : wy;
      const tm_lanes gz = form_f14 ? vol * wz : wz;
      lxx -= vx * gx; lxy -= vx * gy;
      lyx -= vy * gx; lyy -= vy * gy;
      if (dim3) {
        lxz -= vx * gz; lyz -= vy * gz;
        lzx -= vz * gx; lzy -= vz * gy; lzz -= vz * gz;
      }

      /* momentum */
      const tm_lanes mx = form_f14 ? inv_rhoi * gx : wx, my = form_f14 ? inv_rhoi * gy : wy;
      const tm_lanes mz = form_f14 ? inv_rhoi * gz : wz;
      if (correction) {
        ax += (cxx + TM_LOAD(TM_CORR(0))) * mx + (cxy + TM_LOAD(TM_CORR(1))) * my;
        ay += (cyx + TM_LOAD(TM_CORR(3))) * mx + (cyy + TM_LOAD(TM_CORR(4))) * my;
        if (dim3) {
          ax += (cxz + TM_LOAD(TM_CORR(2))) * mz;
          ay += (cyz + TM_LOAD(TM_CORR(5))) * mz;
          az += (czx + TM_LOAD(TM_CORR(6))) * mx + (czy + TM_LOAD(TM_CORR(7))) * my
              + (czz + TM_LOAD(TM_CORR(8))) * mz;
        }
      } else {
        const int P = TM_REC_P;
        const tm_lanes sxx = pxx + TM_LOAD(TM_MAIN(P)), syy = pyy + TM_LOAD(TM_MAIN(P + 1));
        const tm_lanes sxy = pxy + TM_LOAD(TM_MAIN(P + 3));
        ax += sxx * mx + sxy * my;
        ay += sxy * mx + syy * my;
        if (dim3) {
          const tm_lanes szz = pzz + TM_LOAD(TM_MAIN(P + 2)), sxz = pxz + TM_LOAD(TM_MAIN(P + 4));
          const tm_lanes syz = pyz + TM_LOAD(TM_MAIN(P + 5));
          ax += sxz * mz;
          ay += syz * mz;
          az += sxz * mx + syz * my + szz * mz;
        }
      }

      /* artificial terms, kept apart for the energy book: d = artificial acceleration */
      tm_lanes dxa = zero, dya = zero, dza = zero;
      if (artstress) {
        const tm_lanes f = TM_LOAD(TM_COL(TM_COL_TENSILE));
        const tm_lanes sxx = qxx + TM_LOAD(TM_STRESS(0)), syy = qyy + TM_LOAD(TM_STRESS(1));
        const tm_lanes sxy = qxy + TM_LOAD(TM_STRESS(3));
        dxa = sxx * wx + sxy * wy;
        dya = sxy * wx + syy * wy;
        if (dim3) {
          const tm_lanes szz = qzz + TM_LOAD(TM_STRESS(2)), sxz = qxz + TM_LOAD(TM_STRESS(4));
          const tm_lanes syz = qyz + TM_LOAD(TM_STRESS(5));
          dxa += sxz * wz;
          dya += syz * wz;
          dza = sxz * wx + syz * wy + szz * wz;
        }
        dxa *= f; dya *= f; dza *= f;
      }
      if (viscosity) {
        const tm_lanes pi = TM_LOAD(TM_COL(TM_COL_VISCOUS));
        dxa -= pi * wx; dya -= pi * wy; dza -= pi * wz;
      }
      if (artstress || viscosity) {
        art -= dxa * vx + dya * vy + dza * vz;
        ax += dxa; ay += dya; az += dza;
      }

      if (conduction) heat += TM_LOAD(TM_COL(TM_COL_CONDUCTED));
      if (xsph) {
        const tm_lanes w = TM_LOAD(TM_COL(TM_COL_SMOOTH));
        ux -= w * vx; uy -= w * vy; uz -= w * vz;
      }
      if (surface) {
        nx += vol * wx; ny += vol * wy; nz += vol * wz;
      }
    }
#undef TM_MAIN
#undef TM_STRESS
#undef TM_HEAT
#undef TM_CORR
#undef TM_COL
#undef TM_X
#undef TM_LOAD
    if (last) break;
    for (int l = lanes; l < n; l++) jj[tm_at(l - lanes)] = jj[tm_at(l)];
    n -= lanes;
  }

  const tm_real lscale = form_f14 ? 1.0 : inv_rhoi;
  tm_real *L = a->gradient + (ptrdiff_t) i * 9;
  L[0] = lscale * tm_lanes_sum(lxx); L[1] = lscale * tm_lanes_sum(lxy);
  L[2] = lscale * tm_lanes_sum(lxz); L[3] = lscale * tm_lanes_sum(lyx);
  L[4] = lscale * tm_lanes_sum(lyy); L[5] = lscale * tm_lanes_sum(lyz);
  L[6] = lscale * tm_lanes_sum(lzx); L[7] = lscale * tm_lanes_sum(lzy);
  L[8] = lscale * tm_lanes_sum(lzz);
  if (correction) {
    const tm_sym3 K = tm_sym_load(a->correction + (ptrdiff_t) i * 6);
    for (int r = 0; r < 9; r += 3) {
      const tm_vec3 l = tm_sym_mul_vec(K, tm_vec(L[r], L[r + 1], L[r + 2]));
      L[r] = l.x; L[r + 1] = l.y; L[r + 2] = l.z;
    }
  }
  const tm_real mf = mi * a->force_unit;
  double *f = a->force + 3 * (ptrdiff_t) i;
  f[0] += mf * tm_lanes_sum(ax);
  f[1] += mf * tm_lanes_sum(ay);
  f[2] += mf * tm_lanes_sum(az);
  if ((artstress || viscosity) && a->artificial) a->artificial[i] = 0.5 * mi * tm_lanes_sum(art);
  if (conduction) a->heat[i] = tm_lanes_sum(heat);
  if (xsph) {
    tm_real *u = a->xsph_v + 3 * (ptrdiff_t) i;
    u[0] = a->xsph * tm_lanes_sum(ux);
    u[1] = a->xsph * tm_lanes_sum(uy);
    u[2] = a->xsph * tm_lanes_sum(uz);
  }
  if (surface) {
    tm_real *s = a->surface + 3 * (ptrdiff_t) i;
    s[0] = tm_lanes_sum(nx);
    s[1] = tm_lanes_sum(ny);
    s[2] = tm_lanes_sum(nz);
  }
}

#endif
