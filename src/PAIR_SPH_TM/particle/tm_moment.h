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
   bounded and changes without jumps when a particle comes loose. */
#ifndef TM_MOMENT_H
#define TM_MOMENT_H

#include "tm_chunk.h"
#include "tm_eigen.h"
#include "tm_pair.h"
#include "tm_face.h"

#if TM_SINGLE
#error "double only: the correction of the gradients has the precision of the state"
#endif

/* M of row i of the arguments, and sum_j V_j gradW; with tilted, a literal, the moment with the normal b of a free face. */
TM_FN tm_mat3 tm_moment_sum(int i, const tm_rates_args *a, unsigned effects, int tilted, tm_vec3 b, tm_vec3 *face)
{
  const int kernel = tm_fx_kernel(effects), dim3 = (effects & TM_FX_3D) != 0;
  const int sizes = (a->effects & TM_FX_SMOOTHING) != 0;
  const tm_lanes zero = {0};
  const tm_real kappa = tilted ? TM_FACE_TILT / tm_rates_h(i, a) : 0.0;
  const tm_real scale = tilted ? kappa / (tm_vec_dot(b, b) + 1e-30) : 0.0;
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
      if (tilted) {
        const tm_lanes s = zero - tm_lanes_dot(normal, d, dim3), slope = tm_values_load(col[SLOPE], l);
        tm_pair_gradient(&M, d,
                         tm_lanes_add(tm_lanes_scale(1 - kappa * s, m_gradw),
                                      tm_lanes_scale(zero - slope * scale * s * s, normal)),
                         dim3);
      } else tm_pair_gradient(&M, d, m_gradw, dim3);
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

/* K of particle i into a->correction, P K into its record. */
TM_FN void tm_moment(int i, const tm_rates_args *a, unsigned effects)
{
  const int dim3 = (effects & TM_FX_3D) != 0, faces = a->rec.stab && a->rec.faces;
  const tm_real h = tm_rates_h(i, a);
  tm_vec3 g, b = tm_vec(0, 0, 0), turn = b;
  tm_mat3 M = tm_moment_sum(i, a, effects, 0, b, &g);
  if (faces) b = tm_face_normal(g, h, dim3 ? 3.0 - tm_mat_trace(M) : 2.0 - M.xx - M.yy);
  if (!tm_face_none(b)) M = tm_moment_sum(i, a, effects, 1, b, &g);
  const tm_mat3 inverse = tm_face_inverse(M, b, dim3);
  const tm_real sum = tm_vec_norm(tm_mat_mul_vec(tm_mat_transposed(inverse), g));
  tm_real face = sum;
  const tm_sym3 K = tm_correction_of_loose(tm_mat_symmetric(inverse), h, &face);
  if (faces) turn = tm_vec_scale(sum > 0.0 ? face / sum : 1.0, tm_face_turn(inverse));
  const tm_sym3 P = tm_sym_from_record(tm_main_record(&a->rec, i), TM_REC_P);
  tm_sym_to_row(a->correction + tm_row(i, 6), K);
  const tm_mat3 PK = tm_mat_mul(tm_mat_from_sym(P), tm_mat_transposed(tm_face_matrix(K, turn)));
  if (faces) {
    tm_vec_to_row(a->turn + tm_row(i, 3), turn);
    tm_vec_to_record(tm_stab_record(&a->rec, i), TM_STAB_FACE, b);
  }
  if (a->rec.stab) tm_mat_to_record(tm_stab_record(&a->rec, i), TM_STAB_PK, PK);
  else tm_mat_store(a->rec.correction + (ptrdiff_t) i * TM_REC_CORRECTION, PK);
}

#endif
