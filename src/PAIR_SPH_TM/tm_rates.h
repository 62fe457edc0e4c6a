/* SPH-TM: all rates of one particle in one pass over its neighbours.

   velocity gradient   L_i  = 1/rho_i  sum_j m_j (v_j - v_i) (x) gradW        conjugate of F15 (4)
                       L_i  = sum_j m_j/rho_j (v_j - v_i) (x) gradW           conjugate of F14 (6)
   density             drho_i/dt = -rho_i tr L_i                              F15 (2), F14 (4)
   acceleration        a_i = sum_j m_j (P_i + P_j + f^n (R_i + R_j) - Pi I) gradW   F15 (4), F14 (15)
   heat                rho c_p dT_i/dt = sum_j m_j/rho_j 4 k_i k_j/(k_i + k_j) (T_i - T_j) W'/r
                                                                              F15 (6)
   XSPH                dx_i = eps sum_j m_j/rho_mean (v_j - v_i) W
   surface             n_i = sum_j m_j/rho_j gradW; area of the surface = 2 V_i |n_i|

   Each velocity gradient is the work conjugate of its momentum form: the power of the pair forces
   equals minus sum V sigma:L minus the artificial heating, to round-off.

   The row is walked in chunks: neighbours within reach are compacted in row order, then worked
   on by a loop without branches that the compiler vectorises. Rows are sorted by tag, so the sum
   does not depend on where a particle sits in memory, on the skin or on the number of ranks. On
   a GPU a chunk is one neighbour. */
#ifndef TM_RATES_H
#define TM_RATES_H

#include "tm_artificial.h"
#include "tm_heat.h"
#include "tm_kernel.h"
#include "tm_record.h"
#include "tm_tensor.h"

#if defined(__CUDACC__)
#define TM_CHUNK 1
#else
#define TM_CHUNK 96
#endif

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
  tm_real *gradient;       /* 9, L row major (raw sums are corrected when correction is on) */
  tm_real *heat;           /* conduction, power per volume, or NULL */
  tm_real *moment;         /* 9: sum m_j/rho (x_j - x_i) (x) gradW, with correction */
  tm_real *xsph_v;         /* 3, with XSPH */
  tm_real *surface;        /* 3, with surface */
  tm_real *artificial;     /* heating by artificial terms, power, or NULL */
} tm_rates_args;

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

  const int *TM_RESTRICT row = a->rows.index + a->rows.first[i];
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

  const tm_real inv_h = 1.0 / a->h, slope_norm = a->norm * inv_h;
  const tm_real alpha = a->visc_alpha, beta = a->visc_beta, h = a->h, inv_w = a->art_inv_w;
  const int art_n = a->art_n;

  tm_real ax = 0, ay = 0, az = 0, heat = 0, art = 0;
  tm_real lxx = 0, lxy = 0, lxz = 0, lyx = 0, lyy = 0, lyz = 0, lzx = 0, lzy = 0, lzz = 0;
  tm_real kxx = 0, kxy = 0, kxz = 0, kyx = 0, kyy = 0, kyz = 0, kzx = 0, kzy = 0, kzz = 0;
  tm_real ux = 0, uy = 0, uz = 0, nx = 0, ny = 0, nz = 0;

  int jj[TM_CHUNK + 1];
  tm_real bx[TM_CHUNK + 1], by[TM_CHUNK + 1], bz[TM_CHUNK + 1], b2[TM_CHUNK + 1];
  int k = 0;
  while (k < n_mech) {
    int n = 0;
    for (; k < n_mech && n < TM_CHUNK; k++) {
      const int j = row[k * a->rows.stride];
      const tm_real *rj = rec + (ptrdiff_t) j * TM_REC;
      const tm_real dx = xi - rj[0], dy = yi - rj[1], dz = dim3 ? zi - rj[2] : 0.0;
      const tm_real r2 = dx * dx + dy * dy + dz * dz;
      jj[n] = j; bx[n] = dx; by[n] = dy; bz[n] = dz; b2[n] = r2;
      n += r2 < a->reach2;
    }
#if !defined(__CUDACC__)
#pragma omp simd reduction(+ : ax, ay, az, heat, art, lxx, lxy, lxz, lyx, lyy, lyz, lzx, lzy, lzz) \
    reduction(+ : kxx, kxy, kxz, kyx, kyy, kyz, kzx, kzy, kzz, ux, uy, uz, nx, ny, nz)
#endif
    for (int l = 0; l < n; l++) {
      const ptrdiff_t j = jj[l];
      const tm_real *rj = rec + j * TM_REC;
      const tm_real dx = bx[l], dy = by[l], dz = bz[l], r2 = b2[l];
      const tm_real r = sqrt(r2), inv_r = 1.0 / r, q = r * inv_h;
      const tm_real mj = rj[TM_REC_M], rhoj = rj[TM_REC_RHO];
      const tm_real g = slope_norm * tm_kernel_slope(kernel, q) * inv_r;  /* W'/r */
      const tm_real gx = g * dx, gy = g * dy, gz = g * dz;
      const tm_real vx = vxi - rj[4], vy = vyi - rj[5], vz = dim3 ? vzi - rj[6] : 0.0;

      /* velocity gradient, sum of -v_ij (x) gradW; volume m/rho_j, or m to be divided by rho_i */
      const tm_real vol = form_f14 ? mj / rhoj : mj;
      const tm_real wx = vol * gx, wy = vol * gy, wz = vol * gz;
      lxx -= vx * wx; lxy -= vx * wy;
      lyx -= vy * wx; lyy -= vy * wy;
      if (dim3) {
        lxz -= vx * wz; lyz -= vy * wz;
        lzx -= vz * wx; lzy -= vz * wy; lzz -= vz * wz;
      }
      if (correction) {
        kxx -= dx * wx; kxy -= dx * wy; kyx -= dy * wx; kyy -= dy * wy;
        if (dim3) {
          kxz -= dx * wz; kyz -= dy * wz;
          kzx -= dz * wx; kzy -= dz * wy; kzz -= dz * wz;
        }
      }

      /* momentum */
      const tm_real scale = form_f14 ? inv_rhoi / rhoj : 1.0;
      tm_real fx_ = 0, fy_ = 0, fz_ = 0;
      if (correction) {
        const tm_real *c = rec_c + j * TM_REC_CORRECTION;
        fx_ = (cxx + c[0]) * gx + (cxy + c[1]) * gy;
        fy_ = (cyx + c[3]) * gx + (cyy + c[4]) * gy;
        if (dim3) {
          fx_ += (cxz + c[2]) * gz; fy_ += (cyz + c[5]) * gz;
          fz_ = (czx + c[6]) * gx + (czy + c[7]) * gy + (czz + c[8]) * gz;
        }
      } else {
        const tm_real sxx = pxx + rj[8], syy = pyy + rj[9], sxy = pxy + rj[11];
        fx_ = sxx * gx + sxy * gy;
        fy_ = sxy * gx + syy * gy;
        if (dim3) {
          const tm_real szz = pzz + rj[10], sxz = pxz + rj[12], syz = pyz + rj[13];
          fx_ += sxz * gz; fy_ += syz * gz;
          fz_ = sxz * gx + syz * gy + szz * gz;
        }
      }
      if (form_f14) { fx_ *= scale; fy_ *= scale; fz_ *= scale; }

      /* artificial terms, kept apart for the energy book: d = artificial acceleration */
      tm_real dxa = 0, dya = 0, dza = 0;
      if (artstress) {
        const tm_real *qj = rec_s + j * TM_REC_STRESS;
        const tm_real f = tm_power_int(tm_kernel_shape(kernel, q) * inv_w, art_n);
        const tm_real sxx = qxx + qj[0], syy = qyy + qj[1], sxy = qxy + qj[3];
        dxa = sxx * gx + sxy * gy;
        dya = sxy * gx + syy * gy;
        if (dim3) {
          const tm_real szz = qzz + qj[2], sxz = qxz + qj[4], syz = qyz + qj[5];
          dxa += sxz * gz; dya += syz * gz;
          dza = sxz * gx + syz * gy + szz * gz;
        }
        dxa *= f; dya *= f; dza *= f;
      }
      if (viscosity) {
        const tm_real rhom = 0.5 * (rhoi + rhoj), cm = 0.5 * (ci + rj[TM_REC_C]);
        tm_real pi = tm_viscosity_pair(alpha, beta, h, vx * dx + vy * dy + vz * dz, r2, cm, rhom);
        if (balsara) pi *= 0.5 * (bi + rj[TM_REC_BALSARA]);
        dxa -= pi * gx; dya -= pi * gy; dza -= pi * gz;
      }
      if (artstress || viscosity) {
        art -= mj * (dxa * vx + dya * vy + dza * vz);
        fx_ += dxa; fy_ += dya; fz_ += dza;
      }
      ax += mj * fx_; ay += mj * fy_; az += mj * fz_;

      if (conduction) {
        const tm_real tj = rec_t[j * TM_REC_HEAT + TM_REC_T], kj = rec_t[j * TM_REC_HEAT + TM_REC_K];
        heat += tm_conduction_pair(ki, kj, ti, tj, mj / rhoj, g);
      }
      if (xsph) {
        const tm_real w = a->norm * tm_kernel_shape(kernel, q) * 2.0 * mj / (rhoi + rhoj);
        ux -= w * vx; uy -= w * vy; uz -= w * vz;
      }
      if (surface) {
        const tm_real v = mj / rhoj;
        nx += v * gx; ny += v * gy; nz += v * gz;
      }
    }
  }

  const tm_real lscale = form_f14 ? 1.0 : inv_rhoi;
  tm_real *L = a->gradient + (ptrdiff_t) i * 9;
  L[0] = lscale * lxx; L[1] = lscale * lxy; L[2] = lscale * lxz;
  L[3] = lscale * lyx; L[4] = lscale * lyy; L[5] = lscale * lyz;
  L[6] = lscale * lzx; L[7] = lscale * lzy; L[8] = lscale * lzz;
  if (correction) {
    tm_real *K = a->moment + (ptrdiff_t) i * 9;
    K[0] = lscale * kxx; K[1] = lscale * kxy; K[2] = lscale * kxz;
    K[3] = lscale * kyx; K[4] = lscale * kyy; K[5] = lscale * kyz;
    K[6] = lscale * kzx; K[7] = lscale * kzy; K[8] = lscale * kzz;
  }
  const tm_real mf = mi * a->force_unit;
  a->force[3 * (ptrdiff_t) i] += mf * ax;
  a->force[3 * (ptrdiff_t) i + 1] += mf * ay;
  a->force[3 * (ptrdiff_t) i + 2] += mf * az;
  if ((artstress || viscosity) && a->artificial) a->artificial[i] = 0.5 * mi * art;
  if (conduction) a->heat[i] = heat;
  if (xsph) {
    a->xsph_v[3 * (ptrdiff_t) i] = a->xsph * ux;
    a->xsph_v[3 * (ptrdiff_t) i + 1] = a->xsph * uy;
    a->xsph_v[3 * (ptrdiff_t) i + 2] = a->xsph * uz;
  }
  if (surface) {
    a->surface[3 * (ptrdiff_t) i] = nx;
    a->surface[3 * (ptrdiff_t) i + 1] = ny;
    a->surface[3 * (ptrdiff_t) i + 2] = nz;
  }
}

#endif
