/* SPH-TM: corrected gradients of particles that are not searched, where others are. See tm_kept.h and tm_moment.h.

   The row of such a particle holds kept pairs and pairs that are searched because their other end is. Its moment is
   that of both as they are now,
     M_i = G_i B_i^T + sum over the searched pairs of m_j/rho_i (x_j - x_i) (x) gradW,   K_i = M_i^-1
   B follows the deformation as without correction. With
     L_i = (kept sum + searched sum) K_i,   A_i = rho P_i K_i^T B_i for kept pairs,   P_i K_i^T for those searched
   the gradient of a linear field is exact and the forces are its work conjugate, whatever B is: a rigid rotation makes
   no strain and the stress no torque, wherever the border between kept and searched lies. */
#ifndef TM_KEPT_MOMENT_H
#define TM_KEPT_MOMENT_H

#include "tm_kept.h"
#include "tm_moment.h"

typedef struct {
  tm_rates_args fresh;         /* with the rows of searched pairs behind the kept ones */
  const int *kept;             /* kept pairs */
  const unsigned char *now;    /* searched: those tm_moment() does */
  const tm_real *memory;       /* TM_K */
  tm_real *correction;         /* result: K, 9 in rows */
} tm_kept_moment_args;

TM_FN void tm_kept_moment(int i, const tm_kept_moment_args *a, unsigned effects)
{
  if (a->now[i]) return;
  const int dim3 = (effects & TM_FX_3D) != 0, kept = a->kept[i] > 0;
  const tm_rates_args *r = &a->fresh;
  const tm_real *memory = a->memory + (ptrdiff_t) i * TM_K;
  tm_mat3 M = tm_mat_scale(0.0, tm_mat_identity());
  if (r->rows.mechanical[i] > 0) M = tm_mat_from_sym(tm_moment_sum(i, r, effects));
  if (kept)
    M = tm_mat_add(M, tm_mat_mul(tm_mat_load(memory + TM_K_G), tm_mat_transposed(tm_mat_load(memory + TM_K_B))));
  int good = 0;
  tm_mat3 K = tm_mat_identity();
  if (kept) K = tm_mat_inverse(M, dim3, &good);
  if (!good)
    K = tm_mat_from_sym(tm_sym_inverse_bounded(tm_mat_symmetric(M), dim3, TM_MOMENT_LOW));
  tm_mat_store(a->correction + (ptrdiff_t) i * 9, K);
  /* the sum of searched pairs is corrected together with that of kept ones, if there are any */
  tm_sym_store(r->correction + (ptrdiff_t) i * 6, kept ? tm_sym(1, 1, 1, 0, 0, 0) : tm_mat_symmetric(K));
  const tm_sym3 P = tm_sym_from_record(tm_main_record(&r->rec, i), TM_REC_P);
  tm_mat_store(r->rec.correction + (ptrdiff_t) i * TM_REC_CORRECTION,
               tm_mat_mul(tm_mat_from_sym(P), tm_mat_transposed(K)));
}

#endif
