/* SPH-TM: correction of the kernel gradients (Bonet and Lok 1999), a pass of its own before the
   rate pass.

     M_i = sum_j m_j/rho_i (x_j - x_i) (x) gradW      symmetric, 1 in the continuum
     K_i = M_i^-1

   With gradW K_i the gradient of a linear field is exact, also at free surfaces, and the momentum
   sum with (sigma/rho^2) K_i is its work conjugate: a rigid rotation makes no stress, and the
   stress no torque. Both hold to round-off only with the positions at which the forces act; hence
   the pass, since the record of a particle, which its neighbors read, needs its own K first.

   M is half of its value across a free face, a quarter at corners (h = 1.2 spacings), and singular
   for particles in one plane: eigenvalues below TM_MOMENT_LOW count as TM_MOMENT_LOW, so K is
   bounded and changes without jumps when a particle comes loose. At a free face M has the weights of tm_face.h. */
#ifndef TM_MOMENT_H
#define TM_MOMENT_H

#include "tm_chunk.h"
#include "tm_eigen.h"
#include "tm_pair.h"
#include "tm_residual.h"

#if TM_SINGLE
#error "double only: the correction of the gradients has the precision of the state"
#endif

/* M of row i of the arguments with the normal b of a free face, and sum_j V_j gradW. */
TM_FN tm_mat3 tm_moment_sum(int i, const tm_rates_args *a, unsigned effects, tm_vec3 b, tm_vec3 *face)
{
  const int kernel = tm_fx_kernel(effects), dim3 = (effects & TM_FX_3D) != 0;
  const int sizes = (a->effects & TM_FX_SMOOTHING) != 0;
  const tm_lanes zero = {0};
  const tm_real kappa = TM_FACE_TILT / tm_rates_h(i, a);
  const tm_real scale = tm_face_scale(b);
  const tm_lanes_vec normal = {zero + b.x, zero + b.y, zero + b.z};
  enum { Z = 4, SLOPE = Z + TM_REC_SIZE, COLUMNS }; /* x y z m, size, m_j W'/r */
  tm_real ri[TM_REC];
  tm_fetch(a->rec.main + tm_record(i, TM_REC), TM_REC_V, ri);
  tm_sum_mat M = tm_sum_mat_zero();
  tm_sum_vec F = tm_sum_vec_zero();

  tm_chunk c;
  int jj[TM_CHUNK_ROOM];
  tm_real TM_ALIGNED col[COLUMNS][TM_COLUMN];
  for (tm_chunk_begin(&c, i, a, ri, sizes, jj); tm_chunk_gather(&c, jj, col[0], dim3); tm_chunk_carry(&c, jj)) {
    if (c.n == 0) continue;
    const int lanes = c.lanes;
    tm_chunk_fetch_main(&c, jj, TM_REC_V, dim3, col);
    if (sizes) tm_fetch_rows(a->rec.size, TM_REC_SIZE, jj, lanes, col[Z]);
    TM_SIMD
    for (int l = 0; l < lanes; l++) { /* rounding depends on this form, see tm_chunk_pair_size() */
      const int m = tm_at(l);
      const tm_real dx = c.x - col[0][m], dy = c.y - col[1][m], dz = dim3 ? c.z - col[2][m] : 0.0;
      const tm_real r = sqrt(dx * dx + dy * dy + dz * dz);
      const tm_pair_size p = sizes ? tm_pair_of_sizes(&c.own, col[(int) Z + TM_SIZE_INV_H][m],
                                                      col[(int) Z + TM_SIZE_FACTOR][m], 1.0, a->norm_of_one, dim3)
                                   : c.of_all;
      col[SLOPE][m] = col[TM_REC_M][m] * tm_kernel_slope(kernel, r * p.inv_h) / r;
      if (sizes) col[SLOPE][m] *= p.slope_norm;
    }
    /* (x_j - x_i) (x) gradW = -d (x) (W'/r d), d = x_i - x_j */
    for (int l = 0; l < lanes; l += TM_LANES) {
      const tm_lanes_vec d = {tm_chunk_lanes_apart(c.x, col[0], l), tm_chunk_lanes_apart(c.y, col[1], l),
                              dim3 ? tm_chunk_lanes_apart(c.z, col[2], l) : zero};
      const tm_lanes_vec m_gradw = tm_lanes_scale(tm_values_load(col[SLOPE], l), d);
      const tm_lanes s = zero - tm_lanes_dot(normal, d, dim3), slope = tm_values_load(col[SLOPE], l);
      const tm_lanes_vec tilted = tm_lanes_add(tm_lanes_scale(1 - kappa * s, m_gradw),
                                               tm_lanes_scale(zero - slope * (kappa * scale) * s * s, normal));
      tm_pair_gradient(&M, d, tilted, dim3);
      tm_sum_vec_add(&F, m_gradw);
    }
  }
  const tm_real s = (sizes ? 1.0 : a->slope_norm) / tm_main_record(&a->rec, i)[tm_part(TM_REC_RHO)];
  *face = tm_vec(s * tm_lanes_sum(F.x), s * tm_lanes_sum(F.y), s * tm_lanes_sum(F.z));
  const tm_real all[9] = {tm_lanes_sum(M.xx), tm_lanes_sum(M.xy), tm_lanes_sum(M.xz),
                          tm_lanes_sum(M.yx), tm_lanes_sum(M.yy), tm_lanes_sum(M.yz),
                          tm_lanes_sum(M.zx), tm_lanes_sum(M.zy), tm_lanes_sum(M.zz)};
  return tm_mat_scale(s, tm_mat_load(all));
}

/* What the trace of a moment without b lacks: 0 inside a body. */
TM_FN tm_real tm_moment_lacks(tm_mat3 M, int dim3) { return dim3 ? 3.0 - tm_mat_trace(M) : 2.0 - M.xx - M.yy; }

/* K of particle i into a->correction, P K^T and b into its record. */
TM_FN void tm_moment(int i, const tm_rates_args *a, unsigned effects)
{
  const tm_real h = tm_rates_h(i, a);
  tm_vec3 g, b = tm_vec(0, 0, 0);
  tm_mat3 M = tm_moment_sum(i, a, effects, b, &g);
  if (a->faces) b = tm_face_normal(g, h, tm_moment_lacks(M, (effects & TM_FX_3D) != 0));
  if (!tm_face_none(b)) M = tm_moment_sum(i, a, effects, b, &g);
  const tm_mat3 K = tm_correction_of_loose(tm_face_inverse(M, b, (effects & TM_FX_3D) != 0), h, g);
  const tm_sym3 P = tm_sym_from_record(tm_main_record(&a->rec, i), TM_REC_P);
  const tm_mat3 PK = tm_mat_mul(tm_mat_from_sym(P), tm_mat_transposed(K));
  tm_mat_store(a->correction + (ptrdiff_t) i * 9, K);
  if (a->rec.stab) {
    tm_mat_to_record(tm_stab_record(&a->rec, i), TM_STAB_PK, PK);
    tm_vec_to_record(tm_stab_record(&a->rec, i), TM_STAB_FACE, b);
  } else {
    tm_real *rec = a->rec.correction + (ptrdiff_t) i * TM_REC_CORRECTION;
    tm_mat_store(rec, PK);
    rec[TM_CORRECTION_FACE] = b.x;
    rec[TM_CORRECTION_FACE + 1] = b.y;
    rec[TM_CORRECTION_FACE + 2] = b.z;
  }
}

#endif
