/* SPH-TM: gradient correction and normals of free faces from one force point to the next.

   The rate pass finds K of a force point (tm_moment.h) and the normal of a face (tm_face.h) when it is done; what it needs
   itself is predicted: that of the last force point, with its rate, turned with the particle. */
#ifndef TM_CORRECTION_STEP_H
#define TM_CORRECTION_STEP_H

#include "tm_eigen.h"
#include "tm_face.h"
#include "tm_fields.h"

/* Most that a prediction adds to K, the root of the sum of squares. */
#define TM_CORRECTION_STEP 0.1

/* Twice the spin that a row of K holds; in a plane only about z. */
TM_FN tm_vec3 tm_spin_of_row(const tm_real *field, int dim3)
{
  const tm_real *spin = field + tm_column(TM_K_SPIN);
  return tm_vec(dim3 ? spin[0] : 0.0, dim3 ? spin[tm_column(1)] : 0.0, spin[tm_column(2)]);
}

/* K at the time `ahead` of the state: that of the last force point and its rate, turned; 1 where it is not known yet. */
TM_FN tm_sym3 tm_turned_correction(const tm_real *field, tm_real ahead, int dim3)
{
  if (field[0] == 0.0) return tm_sym(1, 1, 1, 0, 0, 0);
  const tm_real since = ahead + field[tm_column(TM_K_SINCE)];
  const tm_vec3 spin = tm_spin_of_row(field, dim3);
  const tm_sym3 rate = tm_sym_from_row_in(field + tm_column(TM_K_RATE), dim3);
  const tm_real size = since * sqrt(tm_sym_ddot(rate, rate));
  const tm_real more = size > TM_CORRECTION_STEP ? since * TM_CORRECTION_STEP / size : since;
  return tm_sym_turned(tm_sym_axpy(tm_sym_from_row_in(field, dim3), more, rate), tm_vec_scale(0.5 * since, spin));
}

/* The normal of a free face and the antisymmetric part of K at the time `ahead` of the state; correction: the field of K. */
typedef struct {
  tm_vec3 normal, turn;
} tm_face;
TM_FN tm_face tm_turned_face(const tm_real *field, const tm_real *correction, tm_real ahead, int dim3)
{
  const tm_real since = ahead + correction[tm_column(TM_K_SINCE)];
  const tm_mat3 R = tm_mat_rotation(tm_vec_scale(0.5 * since, tm_spin_of_row(correction, dim3)));
  tm_face f;
  f.normal = tm_mat_mul_vec(R, tm_vec_from_row(field + tm_column(TM_FACE_NORMAL)));
  f.turn = tm_mat_mul_vec(R, tm_vec_from_row(field + tm_column(TM_FACE_TURN)));
  return f;
}

/* Those of this force point, for the next: `next` as the rate pass leaves them; kept: tm_face_kept(). */
TM_FN void tm_face_step(tm_real *field, const tm_real *next, tm_real kept)
{
  tm_vec_to_row(field + tm_column(TM_FACE_NORMAL),
                tm_vec_scale(kept, tm_vec_from_row(next + tm_column(TM_FACE_NORMAL))));
  tm_vec_to_row(field + tm_column(TM_FACE_TURN), tm_vec_from_row(next + tm_column(TM_FACE_TURN)));
}

/* What a step of K needs of the last: the field as it was. */
typedef struct {
  tm_real known, since;
  tm_sym3 rate;
} tm_correction_last;
TM_FN tm_correction_last tm_correction_last_of(const tm_real *field, int dim3)
{
  tm_correction_last last;
  last.known = field[0];
  last.since = field[tm_column(TM_K_SINCE)];
  last.rate = tm_sym_from_row_in(field + tm_column(TM_K_RATE), dim3);
  return last;
}

/* K of this force point, for the next: `since` before the state, in a particle with velocity gradient L. What the one that
   was predicted for it, dt after the last, has missed adds to the rate; last, predicted: NULL at a set-up. */
TM_FN void tm_correction_step(tm_real *field, const tm_correction_last *last, tm_sym3 K, const tm_sym3 *predicted,
                              tm_mat3 L, tm_real dt, tm_real since, int dim3)
{
  tm_sym3 rate = tm_sym(0, 0, 0, 0, 0, 0);
  if (last && predicted && last->known != 0.0)
    rate = tm_sym_axpy(last->rate, 1.0 / dt, tm_sym_axpy(K, -1.0, *predicted));
  tm_sym_to_row_in(field, K, dim3);
  tm_sym_to_row_in(field + tm_column(TM_K_RATE), rate, dim3);
  if (dim3) {
    field[tm_column(TM_K_SPIN)] = L.zy - L.yz;
    field[tm_column(TM_K_SPIN + 1)] = L.xz - L.zx;
  }
  field[tm_column(TM_K_SPIN + 2)] = L.yx - L.xy;
  field[tm_column(TM_K_SINCE)] = since;
}

#endif
