/* SPH-TM: velocity gradients of second order at free faces.

   At a free face all neighbors lie on one side. A corrected gradient (tm_moment.h) is exact there for linear fields, but
   with V_j gradW = w (x_j - x_i) what it shows of du/dt, t along the face, is that of a point sum w t^2 s/sum w t^2
   inside, s the depth: a quarter of a spacing at h = 1.2 spacings. So a beam of N rows is too soft by 1/N^2 for the lattice
   and some 5/N^2 for its faces. Therefore a particle at a face weights its neighbors for derivatives along the face by
   1 - kappa s, and for those across it as before: in its sums x_j - x_i, here e, is replaced by

     D = (1 - kappa s) e + kappa s^2 b/|b|^2,   s = b.e,   kappa = TM_FACE_TILT/h

   b points inward along the normal. The part of D along it is that of e, the rest is 1 - kappa s times that of e; sum w t^2 s
   (1 - kappa s) vanishes where kappa h |b| is 1.16 to 1.19 (h = 1.2 spacings, any of the kernels) to 1.4 (1.7 spacings).
   The moment is sum w e (x) D, so linear fields stay exact, and the momentum sum has the same D (its transpose): both
   momenta and the balance of energy stay exact too. b is 0 inside a body.

   Its length comes from x = h |sum V_j gradW|, which is 0 inside and 0.57 to 0.66 at faces (0.03 to 0.2 one row deeper):
   kappa h |b| = 2.055 x meets what faces need within 1.5 %, and less of it, from nothing on, what the next row needs. Edges, corners and what hangs loose
   have less of it, since some direction along their face has few neighbors of its own layer, and the moment would come
   close to 0 there. They are told by what the trace of the moment lacks: 0 inside, 0.5 to 0.6 at faces, 1 to 1.3 at edges,
   2 at corners.

   Own construction. Corrections of second order by larger matrices: Liu and Jun 1998; here a vector per particle does. */
#ifndef TM_FACE_H
#define TM_FACE_H

#include "tm_eigen.h"
#include "tm_residual.h"

/* kappa h */
#define TM_FACE_TILT 1.18
/* kappa h |b| between which it begins, the most it can be, and what the trace lacks between which it ends. */
#define TM_FACE_BEGINS 0.15
#define TM_FACE_WHOLE 0.6
#define TM_FACE_MOST 1.4
#define TM_FACE_EDGE 0.65
#define TM_FACE_LOOSE 1.5

/* b of a particle from h, g = sum_j V_j gradW (1/length), and what the trace of its moment lacks to the dimension. */
TM_FN tm_vec3 tm_face_normal(tm_vec3 g, tm_real h, tm_real lacks)
{
  const tm_real least = TM_FACE_BEGINS / 2.055, square = tm_vec_dot(g, g);
  if (!(h * h * square > least * least && lacks < TM_FACE_LOOSE)) return tm_vec(0, 0, 0);
  const tm_real size = sqrt(square), tilt = 2.055 * h * size;
  const tm_real u = tm_min((tilt - TM_FACE_BEGINS) / (TM_FACE_WHOLE - TM_FACE_BEGINS), 1.0);
  const tm_real ends = tm_min((TM_FACE_LOOSE - lacks) / (TM_FACE_LOOSE - TM_FACE_EDGE), 1.0);
  const tm_real length = tm_min(tilt, TM_FACE_MOST) / TM_FACE_TILT * u * ends;
  return tm_vec_scale(length / size, g);
}

TM_FN int tm_face_none(tm_vec3 b) { return b.x == 0.0 && b.y == 0.0 && b.z == 0.0; }

/* K from its symmetric part and the vector of its antisymmetric part, which is 0 where b is, and back. */
TM_FN tm_mat3 tm_face_matrix(tm_sym3 K, tm_vec3 turn)
{
  tm_mat3 m = tm_mat_from_sym(K);
  m.xy -= turn.z;
  m.yx += turn.z;
  m.xz += turn.y;
  m.zx -= turn.y;
  m.yz -= turn.x;
  m.zy += turn.x;
  return m;
}
TM_FN tm_vec3 tm_face_turn(tm_mat3 K) { return tm_vec(0.5 * (K.zy - K.yz), 0.5 * (K.xz - K.zx), 0.5 * (K.yx - K.xy)); }

/* Share of b in strained material; strain: equivalent, plastic and elastic (sigma_Mises/3G) together. A lattice that is
   distorted or torn up has no face of which depths could be told, and in chips and necks weights of both signs make
   noise. */
#define TM_FACE_STRAIN 0.1
TM_FN tm_real tm_face_kept(tm_real strain) { return tm_max(1.0 - strain / TM_FACE_STRAIN, 0.0); }

/* Inverse of a moment matrix, which is symmetric without b. Its symmetric part is bounded as in tm_moment.h; where that
   bound is met the rest of it is left away. */
TM_FN tm_mat3 tm_face_inverse(tm_mat3 M, tm_vec3 b, int dim3)
{
  tm_sym3 S = tm_mat_symmetric(M);
  const tm_sym3 K = tm_sym_inverse_bounded(S, dim3, TM_MOMENT_LOW);
  if (tm_face_none(b)) return tm_mat_from_sym(K);
  if (!dim3) {
    S.zz = 1.0;
    S.xz = S.yz = 0.0;
  }
  int good = 0;
  const tm_mat3 inverse = tm_mat_inverse(M, dim3, &good);
  return good && tm_sym_det(S) * tm_sym_det(K) > 1.0 - 1e-9 ? inverse : tm_mat_from_sym(K);
}

/* Whether a particle with this normal, as pairs have it, is at a free face: for all who ask, with the same answer. */
TM_FN int tm_face_is_there(tm_pair x, tm_pair y, tm_pair z) { return x != 0 || y != 0 || z != 0; }

#endif
