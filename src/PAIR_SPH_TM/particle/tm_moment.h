/* SPH-TM: correction of the kernel gradients (Bonet and Lok 1999), a pass of its own before the
   rate pass.

     M_i = sum_j m_j/rho_i (x_j - x_i) (x) gradW      symmetric, 1 in the continuum
     K_i = M_i^-1

   With gradW K_i the gradient of a linear field is exact, also at free surfaces, and the momentum
   sum with (sigma/rho^2) K_i is its work conjugate: a rigid rotation makes no stress, and the
   stress no torque. Both hold to round-off only with the positions at which the forces act; hence
   the pass, since what a particle shows its neighbours needs its own K first.

   M is half of its value across a free face, a quarter at corners (h = 1.2 spacings), and singular
   for particles in one plane: eigenvalues below TM_MOMENT_LOW count as TM_MOMENT_LOW, so K is
   bounded and changes without jumps when a particle comes loose. */
#ifndef TM_MOMENT_H
#define TM_MOMENT_H

#include "tm_eigen.h"
#include "tm_rates.h"

#if TM_SINGLE
#error "double only: the correction of the gradients has the precision of the state"
#endif

#define TM_MOMENT_LOW 0.1

/* M of row i of the arguments. */
TM_FN tm_sym3 tm_moment_sum(int i, const tm_rates_args *a, unsigned effects)
{
  const int kernel = tm_fx_kernel(effects), dim3 = (effects & TM_FX_3D) != 0;
  const int sizes = (a->effects & TM_FX_SMOOTHING) != 0;
  const int *row = a->rows.index + a->rows.first[i];
  const int n_mech = a->rows.mechanical[i];
  const tm_real *TM_RESTRICT rec = a->rec.main;
  const tm_real *ri = tm_main_record(&a->rec, i);
  const tm_real *TM_RESTRICT rec_z = sizes ? a->rec.size : NULL;
  const tm_pair_size of_all = {a->h, 1.0 / a->h, a->norm, a->slope_norm, 1.0};
  const tm_pair_size own = tm_own_size(sizes ? rec_z + (ptrdiff_t) i * TM_REC_SIZE : NULL, of_all);
  const tm_real reach2 = sizes ? a->support2 : a->reach2;
  const tm_real xi = ri[0], yi = ri[1], zi = ri[tm_part(2)], far = 4.0 * own.h;
  const tm_lanes zero = tm_lanes_zero();
  tm_lanes mxx = zero, myy = zero, mzz = zero, mxy = zero, mxz = zero, myz = zero;

  /* the row in chunks as in tm_rates() */
  int jj[TM_COLUMN + TM_LANES];
  jj[0] = i;
  if (TM_COLUMN == 1) jj[1] = n_mech > 0 ? row[0] : i;
  tm_real TM_ALIGNED col[5 + TM_REC_SIZE][TM_COLUMN];  /* x y z m, m_j W'/r, size */
  for (int k = 0, n = 0; TM_COLUMN > 1 || k < n_mech; k += TM_COLUMN == 1) {
    n = tm_within_reach(rec, rec_z, own.inv_h, row, a->rows.stride, &k, n_mech, xi, yi, zi, 1.0, reach2,
                        dim3, jj, n, col[0]);
    if (TM_COLUMN == 1 && n == 0) continue;
    if (n == 0) break;
    const int last = TM_COLUMN > 1 && k >= n_mech;
    const int lanes =
        TM_COLUMN == 1 ? 1 : (last ? n + TM_LANES - 1 : n) / TM_LANES * TM_LANES;
    if (TM_COLUMN > 1) {
      for (int l = n; l < lanes; l++) jj[tm_at(l)] = i;
      tm_transpose_rows(rec, TM_REC, jj, lanes, 4, col[0]);
      if (sizes) tm_transpose_rows(rec_z, TM_REC_SIZE, jj, lanes, TM_REC_SIZE, col[5]);
      for (int l = n; l < lanes; l++) col[TM_REC_X][tm_at(l)] = xi + far;
    } else if (sizes)
      for (int c = 0; c < TM_REC_SIZE; c++) col[5 + c][0] = rec_z[jj[0] * (ptrdiff_t) TM_REC_SIZE + c];
#if !defined(__CUDACC__)
#pragma omp simd
#endif
    for (int l = 0; l < lanes; l++) {
      const int m = tm_at(l);
      const tm_real dx = xi - col[0][m], dy = yi - col[1][m], dz = dim3 ? zi - col[2][m] : 0.0;
      const tm_real r = sqrt(dx * dx + dy * dy + dz * dz);
      const tm_pair_size p = sizes ? tm_pair_of_sizes(&own, col[5 + TM_SIZE_INV_H][m], col[5 + TM_SIZE_FACTOR][m],
                                                      1.0, a->norm_of_one, dim3)
                                   : of_all;
      col[4][m] = col[TM_REC_M][m] * tm_kernel_slope(kernel, r * p.inv_h) / r;
      if (sizes) col[4][m] *= p.slope_norm;
    }
    for (int l = 0; l < lanes; l += TM_LANES) {
      const tm_lanes dx = xi - tm_lanes_load(col[0] + tm_at(l)), dy = yi - tm_lanes_load(col[1] + tm_at(l));
      const tm_lanes g = tm_lanes_load(col[4] + tm_at(l)), gx = g * dx, gy = g * dy;
      mxx -= gx * dx; myy -= gy * dy; mxy -= gx * dy;
      if (dim3) {
        const tm_lanes dz = zi - tm_lanes_load(col[2] + tm_at(l));
        mxz -= gx * dz; myz -= gy * dz; mzz -= g * dz * dz;
      }
    }
    if (last) break;
    for (int l = lanes; l < n; l++) jj[tm_at(l - lanes)] = jj[tm_at(l)];
    n -= lanes;
  }

  const tm_real s = (sizes ? 1.0 : a->slope_norm) / ri[tm_part(TM_REC_RHO)];
  return tm_sym(s * tm_lanes_sum(mxx), s * tm_lanes_sum(myy), s * tm_lanes_sum(mzz),
                s * tm_lanes_sum(mxy), s * tm_lanes_sum(mxz), s * tm_lanes_sum(myz));
}

/* K of particle i into a->correction, P K into its record. */
TM_FN void tm_moment(int i, const tm_rates_args *a, unsigned effects)
{
  const tm_sym3 K = tm_sym_inverse_bounded(tm_moment_sum(i, a, effects), (effects & TM_FX_3D) != 0, TM_MOMENT_LOW);
  const tm_sym3 P = tm_sym_from_record(tm_main_record(&a->rec, i), TM_REC_P);
  tm_sym_store(a->correction + (ptrdiff_t) i * 6, K);
  tm_mat_store(a->rec.correction + (ptrdiff_t) i * TM_REC_CORRECTION, tm_sym_mul(P, K));
}

#endif
