/* SPH-TM: resistance to patterns that no velocity gradient sees (hourglass modes), a pass of its own.

   Positions that alternate from particle to particle make no strain in sums over gradients, so nothing
   of the material resists them; under tension the momentum sum makes them grow (tensile instability).
   Each particle therefore has a displacement w against its neighbourhood: what its velocity differs by
   from the linear field that fits those of its neighbours best (weights m_j/rho_j W),

     dw_i/dt = v_i - a_i + Omega_i w_i - |D_i|/eps w_i,   min over a, B of sum_j m_j/rho_j W |v_j - a - B (x_j - x_i)|^2

   with the spin Omega and the rate of deformation D. A linear field, and so every homogeneous strain and
   rotation, makes none, at free surfaces too. Neighbours resist the difference along the line between them:

     a_i = sum_j m_j k_ij/(rho_i rho_j) (w_i - w_j).x/r^2 gradW,   k_ij = 2 k_i k_j/(k_i + k_j),  k = xi rho c^2

   central and equal and opposite: both momenta stay to round-off. xi is the stiffness over that of
   longitudinal waves. Displacements are forgotten with the deformation, over a strain eps: so what has
   flowed is not held back, while a pattern, which grows slowly, meets a stiff resistance.

   Own construction; the idea of a penalty on what differs from the linear field is that of Ganzenmueller
   2015 (doi 10.1016/j.cma.2014.12.005), there with positions of the reference state. */
#ifndef TM_HOURGLASS_H
#define TM_HOURGLASS_H

#include "tm_eigen.h"
#include "tm_rates.h"

#if TM_SINGLE
#error "double only: displacements are small differences of velocities"
#endif

/* Strain over which displacements are forgotten. */
#define TM_HOURGLASS_STRAIN 0.05
/* Least determinant of the second moment of the neighbours, over that of an even neighbourhood: with less
   no linear field can be told. */
#define TM_HOURGLASS_LEAST 0.02

/* The particle's own w at the force point and k. A failed one, or one without strength, has none. */
TM_FN void tm_hourglass_record(const tm_real *field, tm_real ahead, tm_real stiffness, tm_real *out)
{
  for (int d = 0; d < 3; d++)
    out[d] = stiffness > 0.0 ? field[tm_column(TM_G_W + d)] + ahead * field[tm_column(TM_G_RATE + d)] : 0.0;
  out[TM_HOURGLASS_K] = stiffness;
}

/* w after a step with velocity gradient L and rate v - a. */
TM_FN void tm_hourglass_step(tm_real *field, const tm_real *rate, tm_mat3 L, tm_real dt, int forget)
{
  const tm_sym3 D = tm_mat_symmetric(L);
  const tm_real keep = forget ? 0.0 : 1.0 / (1.0 + dt * sqrt(tm_sym_ddot(D, D)) / TM_HOURGLASS_STRAIN);
  const tm_real x = field[tm_column(TM_G_W)], y = field[tm_column(TM_G_W + 1)], z = field[tm_column(TM_G_W + 2)];
  const tm_real sx = 0.5 * (L.zy - L.yz), sy = 0.5 * (L.xz - L.zx), sz = 0.5 * (L.yx - L.xy);
  const tm_real turn[3] = {sy * z - sz * y, sz * x - sx * z, sx * y - sy * x}, old[3] = {x, y, z};
  for (int d = 0; d < 3; d++) {
    field[tm_column(TM_G_W + d)] = keep * (old[d] + dt * (turn[d] + rate[d]));
    field[tm_column(TM_G_RATE + d)] = forget ? 0.0 : rate[d];
  }
}

/* v_i - a of the fit, from the sums over the neighbours: weights, x, v, x (x) x, v (x) x; relative to particle i. */
TM_FN tm_vec3 tm_hourglass_rate(tm_real weights, tm_vec3 x, tm_vec3 v, tm_sym3 xx, tm_mat3 vx, int dim3)
{
  const tm_vec3 none = tm_vec(0, 0, 0);
  if (!(weights > 0.0)) return none;
  const tm_real s = 1.0 / weights;
  x = tm_vec_scale(s, x);
  v = tm_vec_scale(s, v);
  tm_sym3 M = tm_sym(s * xx.xx - x.x * x.x, s * xx.yy - x.y * x.y, s * xx.zz - x.z * x.z, s * xx.xy - x.x * x.y,
                     s * xx.xz - x.x * x.z, s * xx.yz - x.y * x.z);
  const tm_real mean = (M.xx + M.yy + (dim3 ? M.zz : 0.0)) / (dim3 ? 3.0 : 2.0);
  if (!(mean > 1e-6 * s * (xx.xx + xx.yy + xx.zz))) return none;    /* all in one place */
  M = tm_sym_scale(1.0 / mean, M);
  if (!dim3) {
    M.zz = 1.0;
    M.xz = M.yz = 0.0;
  }
  const tm_real det = tm_sym_det(M);
  if (!(det > TM_HOURGLASS_LEAST)) return none;
  const tm_sym3 inverse = tm_sym_inverse_bounded(M, dim3, 0.0);
  const tm_vec3 b = tm_vec_scale(1.0 / mean, tm_sym_mul_vec(inverse, x));    /* B x = C b, C of the centred v (x) x */
  const tm_real bx = tm_vec_dot(b, x);
  return tm_vec(s * (vx.xx * b.x + vx.xy * b.y + vx.xz * b.z) - v.x * bx - v.x,
                s * (vx.yx * b.x + vx.yy * b.y + vx.yz * b.z) - v.y * bx - v.y,
                s * (vx.zx * b.x + vx.zy * b.y + vx.zz * b.z) - v.z * bx - v.z);
}

/* Rate of w and force of particle i from its mechanical neighbours, the force added to what is there, its
   power to the heating by artificial terms. */
TM_FN void tm_hourglass(int i, const tm_rates_args *a, unsigned effects)
{
  const int kernel = tm_fx_kernel(effects), dim3 = (effects & TM_FX_3D) != 0;
  const int sizes = (a->effects & TM_FX_SMOOTHING) != 0;
  const int *row = a->rows.index + a->rows.first[i];
  const int n_mech = a->rows.mechanical[i];
  const tm_real *TM_RESTRICT rec = a->rec.main;
  const tm_real *TM_RESTRICT rec_g = a->rec.hourglass;
  const tm_real *TM_RESTRICT rec_z = sizes ? a->rec.size : NULL;
  tm_real ri[TM_REC];
  tm_fetch(rec + tm_pair_record(i, TM_REC), TM_REC, ri);
  const tm_real *gi = rec_g + (ptrdiff_t) i * TM_REC_HOURGLASS;
  const tm_real wxi = gi[0], wyi = gi[1], wzi = gi[2], ki = gi[TM_HOURGLASS_K];
  const tm_pair_size of_all = {a->h, 1.0 / a->h, a->norm, a->slope_norm, 1.0};
  const tm_pair_size own = tm_own_size(sizes ? rec_z + (ptrdiff_t) i * TM_REC_SIZE : NULL, of_all);
  const tm_real reach2 = sizes ? a->support2 : a->reach2;
  const tm_real xi = ri[0], yi = ri[1], zi = ri[2], far = 4.0 * own.h;
  const tm_lanes zero = {0};
  const tm_sum none = tm_lanes_zero();
  tm_sum s = none, sx = none, sy = none, sz = none, ux = none, uy = none, uz = none;
  tm_sum xx = none, yy = none, zz = none, xy = none, xz = none, yz = none;
  tm_sum pxx = none, pxy = none, pxz = none, pyx = none, pyy = none, pyz = none, pzx = none, pzy = none, pzz = none;
  tm_sum ax = none, ay = none, az = none, art = none;

  /* the row in chunks as in tm_rates(); columns: x y z m v rho, w k, size, weight, factor of the force */
  enum { G = 8, Z = G + TM_REC_HOURGLASS, WEIGHT = Z + TM_REC_SIZE, FORCE, COLUMNS };
  int jj[TM_COLUMN + TM_LANES];
  jj[0] = i;
  if (TM_COLUMN == 1) jj[1] = n_mech > 0 ? row[0] : i;
  tm_real TM_ALIGNED col[COLUMNS][TM_COLUMN];
  for (int k = 0, n = 0; TM_COLUMN > 1 || k < n_mech; k += TM_COLUMN == 1) {
    n = tm_within_reach(rec, rec_z, own.inv_h, row, a->rows.stride, &k, n_mech, xi, yi, zi, 1.0, reach2,
                        dim3, jj, n, col[0]);
    if (TM_COLUMN == 1 && n == 0) continue;
    if (n == 0) break;
    const int last = TM_COLUMN > 1 && k >= n_mech;
    const int lanes = TM_COLUMN == 1 ? 1 : (last ? n + TM_LANES - 1 : n) / TM_LANES * TM_LANES;
    if (TM_COLUMN > 1) {
      for (int l = n; l < lanes; l++) jj[tm_at(l)] = i;
      tm_transpose_rows(rec, TM_REC, jj, lanes, G, col[0]);
      tm_transpose_rows(rec_g, TM_REC_HOURGLASS, jj, lanes, TM_REC_HOURGLASS, col[G]);
      if (sizes) tm_transpose_rows(rec_z, TM_REC_SIZE, jj, lanes, TM_REC_SIZE, col[Z]);
      for (int l = n; l < lanes; l++) col[TM_REC_X][tm_at(l)] = xi + far;
    } else {
      const ptrdiff_t j = jj[0];
      tm_fetch(rec + tm_pair_record(j, TM_REC) + tm_pair_part(TM_REC_V), G - TM_REC_V, col[TM_REC_V]);
      for (int c = 0; c < TM_REC_HOURGLASS; c++) col[G + c][0] = rec_g[j * TM_REC_HOURGLASS + c];
      for (int c = 0; sizes && c < TM_REC_SIZE; c++) col[Z + c][0] = rec_z[j * TM_REC_SIZE + c];
    }
#if !defined(__CUDACC__)
#pragma omp simd
#endif
    for (int l = 0; l < lanes; l++) {
      const int m = tm_at(l);
      const tm_real dx = xi - col[0][m], dy = yi - col[1][m], dz = dim3 ? zi - col[2][m] : 0.0;
      const tm_real r2 = dx * dx + dy * dy + dz * dz, r = sqrt(r2);
      const tm_pair_size p = sizes ? tm_pair_of_sizes(&own, col[Z + TM_SIZE_INV_H][m], col[Z + TM_SIZE_FACTOR][m],
                                                      1.0, a->norm_of_one, dim3)
                                   : of_all;
      const tm_real q = r * p.inv_h, volume = col[TM_REC_M][m] / col[TM_REC_RHO][m], kj = col[G + TM_HOURGLASS_K][m];
      col[WEIGHT][m] = volume * p.norm * tm_kernel_shape(kernel, q);
      col[FORCE][m] = volume * p.slope_norm * tm_kernel_slope(kernel, q) * 2.0 * ki * kj /
                      ((ki + kj + 1e-300) * r2 * r * ri[TM_REC_RHO]);
    }
    for (int l = 0; l < lanes; l += TM_LANES) {
#define TM_LOAD(c) tm_lanes_load(col[c] + tm_at(l))
      const tm_lanes dx = xi - TM_LOAD(0), dy = yi - TM_LOAD(1), vx = ri[4] - TM_LOAD(4), vy = ri[5] - TM_LOAD(5);
      const tm_lanes dz = dim3 ? zi - TM_LOAD(2) : zero, vz = dim3 ? ri[6] - TM_LOAD(6) : zero;
      const tm_lanes w = TM_LOAD(WEIGHT), wx = w * dx, wy = w * dy, wz = w * dz;
      s += w;
      sx -= wx; sy -= wy;
      ux -= w * vx; uy -= w * vy;
      xx += wx * dx; yy += wy * dy; xy += wx * dy;
      pxx += wx * vx; pxy += wy * vx; pyx += wx * vy; pyy += wy * vy;
      if (dim3) {
        sz -= wz;
        uz -= w * vz;
        zz += wz * dz; xz += wx * dz; yz += wy * dz;
        pxz += wz * vx; pyz += wz * vy;
        pzx += wx * vz; pzy += wy * vz; pzz += wz * vz;
      }
      tm_lanes f = (wxi - TM_LOAD(G)) * dx + (wyi - TM_LOAD(G + 1)) * dy;
      if (dim3) f += (wzi - TM_LOAD(G + 2)) * dz;
      f *= TM_LOAD(FORCE);
      const tm_lanes fx = f * dx, fy = f * dy, fz = f * dz;
      ax += fx; ay += fy;
      if (dim3) az += fz;
      art -= fx * vx + fy * vy + fz * vz;
#undef TM_LOAD
    }
    if (last) break;
    for (int l = lanes; l < n; l++) jj[tm_at(l - lanes)] = jj[tm_at(l)];
    n -= lanes;
  }

  const tm_real vx[9] = {tm_lanes_sum(pxx), tm_lanes_sum(pxy), tm_lanes_sum(pxz), tm_lanes_sum(pyx), tm_lanes_sum(pyy),
                         tm_lanes_sum(pyz), tm_lanes_sum(pzx), tm_lanes_sum(pzy), tm_lanes_sum(pzz)};
  const tm_vec3 rate = tm_hourglass_rate(
      tm_lanes_sum(s), tm_vec(tm_lanes_sum(sx), tm_lanes_sum(sy), tm_lanes_sum(sz)),
      tm_vec(tm_lanes_sum(ux), tm_lanes_sum(uy), tm_lanes_sum(uz)),
      tm_sym(tm_lanes_sum(xx), tm_lanes_sum(yy), tm_lanes_sum(zz), tm_lanes_sum(xy), tm_lanes_sum(xz),
             tm_lanes_sum(yz)),
      tm_mat_load(vx), dim3);
  tm_real *out = a->hourglass_rate + 3 * (ptrdiff_t) i;
  out[0] = rate.x; out[1] = rate.y; out[2] = rate.z;
  const tm_real mf = ri[TM_REC_M] * a->force_unit;
  double *f = a->force + 3 * (ptrdiff_t) i;
  f[0] += mf * tm_lanes_sum(ax);
  f[1] += mf * tm_lanes_sum(ay);
  f[2] += mf * tm_lanes_sum(az);
  if (a->artificial) a->artificial[i] += 0.5 * ri[TM_REC_M] * tm_lanes_sum(art);
}

#endif
