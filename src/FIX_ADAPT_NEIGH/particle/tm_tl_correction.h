/* SPH-TM: corrected gradients of total-Lagrangian particles beside updated-Lagrangian ones. See tm_tl_rates.h and
   tm_moment.h.

   The row of such a particle holds total-Lagrangian pairs, and updated-Lagrangian ones where the other end is. Its
   moment is that of both at the current positions,
     M_i = G_i B_i^T + sum over the updated-Lagrangian pairs of m_j/rho_i (x_j - x_i) (x) gradW,   K_i = M_i^-1
   B follows the deformation as without correction. With
     L_i = (TL sum + UL sum) K_i,   A_i = rho P_i K_i^T B_i for total-Lagrangian pairs,   P_i K_i^T for the others
   the gradient of a linear field is exact and the forces are its work conjugate, whatever B is: a rigid rotation causes
   no strain and the stress no torque, wherever the TL/UL interface lies. */
#ifndef TM_TL_CORRECTION_H
#define TM_TL_CORRECTION_H

#include "tm_tl_rates.h"
#include "tm_moment.h"

typedef struct {
  tm_rates_args ul;           /* with the updated-Lagrangian pairs of total-Lagrangian particles as rows */
  const int *tl;              /* number of total-Lagrangian pairs of each particle */
  const unsigned char *is_ul; /* updated-Lagrangian particles: tm_moment() does those */
  const tm_real *history;     /* TM_TL_HISTORY */
  tm_real *correction;        /* result: K, 9 in rows */
} tm_tl_correction_args;

/* K_i into correction, P_i K_i^T into the record. */
TM_FN void tm_tl_correction(int i, const tm_tl_correction_args *a, unsigned effects)
{
  if (a->is_ul[i]) return;
  const int dim3 = (effects & TM_FX_3D) != 0, stored = a->tl[i] > 0;
  const tm_rates_args *r = &a->ul;
  const tm_real *history = a->history + (ptrdiff_t) i * TM_TL_HISTORY;
  tm_mat3 M = tm_mat_scale(0.0, tm_mat_identity());
  tm_vec3 face; /* stored pairs hold the particle */
  if (r->rows.mechanical[i] > 0) M = tm_moment_sum(i, r, effects, 0, tm_vec(0, 0, 0), &face);
  if (stored)
    M = tm_mat_add(M, tm_mat_mul(tm_mat_load(history + TM_TL_G), tm_mat_transposed(tm_mat_load(history + TM_TL_B))));
  int good = 0;
  tm_mat3 K = tm_mat_identity();
  if (stored) K = tm_mat_inverse(M, dim3, &good);
  if (!good) K = tm_mat_from_sym(tm_sym_inverse_bounded(tm_mat_symmetric(M), dim3, TM_MOMENT_LOW));
  tm_mat_store(a->correction + (ptrdiff_t) i * 9, K);
  /* with total-Lagrangian pairs, tm_tl_rates() applies K to the sum of both kinds of pairs */
  tm_sym_to_row(r->correction + tm_row(i, 6), stored ? tm_sym(1, 1, 1, 0, 0, 0) : tm_mat_symmetric(K));
  const tm_sym3 P = tm_sym_from_record(tm_main_record(&r->rec, i), TM_REC_P);
  tm_mat_store(r->rec.correction + (ptrdiff_t) i * TM_REC_CORRECTION,
               tm_mat_mul(tm_mat_from_sym(P), tm_mat_transposed(K)));
}

#endif
