/* SPH-TM: eigenvalues and eigenvectors of symmetric tensors, tensile part, guarded inverse.

   Jacobi rotations (Golub and Van Loan, section 8.5): unconditionally stable, orthonormal
   vectors to round-off also for equal eigenvalues. A tensor with xz = yz = 0 is diagonal after
   one rotation. */
#ifndef TM_EIGEN_H
#define TM_EIGEN_H

#include "tm_tensor.h"

typedef struct {
  tm_real value[3];
  tm_vec3 vector[3];  /* orthonormal, vector[k] belongs to value[k]; no order */
} tm_eigen;

typedef struct {
  tm_real c, s, t;  /* cosine, sine, tangent */
} tm_rotation;

/* Rotation that makes the off-diagonal b of [a b; b d] vanish; the smaller angle. */
TM_FN tm_rotation tm_jacobi_angle(tm_real a, tm_real b, tm_real d)
{
  tm_rotation r;
  const tm_real half = 0.5 * (d - a), norm = fabs(half) + sqrt(half * half + b * b);
  r.t = norm > 0.0 ? (half < 0.0 ? -b : b) / norm : 0.0;
  r.c = 1.0 / sqrt(1.0 + r.t * r.t);
  r.s = r.t * r.c;
  return r;
}

/* p' = c p - s q, q' = s p + c q */
TM_FN void tm_jacobi_turn(tm_rotation r, tm_real *p, tm_real *q)
{
  const tm_real a = *p, b = *q;
  *p = r.c * a - r.s * b;
  *q = r.s * a + r.c * b;
}
TM_FN void tm_jacobi_turn_vec(tm_rotation r, tm_vec3 *p, tm_vec3 *q)
{
  tm_jacobi_turn(r, &p->x, &q->x);
  tm_jacobi_turn(r, &p->y, &q->y);
  tm_jacobi_turn(r, &p->z, &q->z);
}

/* One rotation in the plane of two axes: diagonals app, aqq, their off-diagonal apq, and the
   couplings apr, aqr to the third axis. */
TM_FN void tm_jacobi_rotate(tm_real *app, tm_real *aqq, tm_real *apq, tm_real *apr, tm_real *aqr,
                            tm_vec3 *vp, tm_vec3 *vq)
{
  const tm_rotation r = tm_jacobi_angle(*app, *apq, *aqq);
  const tm_real d = r.t * *apq;
  *app -= d;
  *aqq += d;
  *apq = 0.0;
  tm_jacobi_turn(r, apr, aqr);
  tm_jacobi_turn_vec(r, vp, vq);
}

/* Eigenvalues and eigenvectors of a. */
TM_FN tm_eigen tm_sym_eigen(tm_sym3 a)
{
  tm_vec3 u = tm_vec(1, 0, 0), v = tm_vec(0, 1, 0), w = tm_vec(0, 0, 1);
  const tm_real norm2 = tm_sym_ddot(a, a);
  tm_jacobi_rotate(&a.xx, &a.yy, &a.xy, &a.xz, &a.yz, &u, &v);
  for (int sweep = 0; sweep < 12; sweep++) {
    const tm_real off = a.xy * a.xy + a.xz * a.xz + a.yz * a.yz;
    if (off <= 1e-34 * norm2) break;
    tm_jacobi_rotate(&a.xx, &a.zz, &a.xz, &a.xy, &a.yz, &u, &w);
    tm_jacobi_rotate(&a.yy, &a.zz, &a.yz, &a.xy, &a.xz, &v, &w);
    tm_jacobi_rotate(&a.xx, &a.yy, &a.xy, &a.xz, &a.yz, &u, &v);
  }
  tm_eigen e;
  e.value[0] = a.xx; e.value[1] = a.yy; e.value[2] = a.zz;
  e.vector[0] = u; e.vector[1] = v; e.vector[2] = w;
  return e;
}

/* a + k v v^T */
TM_FN tm_sym3 tm_sym_add_dyad(tm_sym3 a, tm_real k, tm_vec3 v)
{
  return tm_sym(a.xx + k * v.x * v.x, a.yy + k * v.y * v.y, a.zz + k * v.z * v.z,
                a.xy + k * v.x * v.y, a.xz + k * v.x * v.z, a.yz + k * v.y * v.z);
}

/* sum_k max(lambda_k, 0) e_k e_k^T */
TM_FN tm_sym3 tm_sym_positive_part(tm_sym3 a)
{
  const tm_eigen e = tm_sym_eigen(a);
  tm_sym3 p = tm_sym(0, 0, 0, 0, 0, 0);
  for (int k = 0; k < 3; k++) p = tm_sym_add_dyad(p, tm_max(e.value[k], 0.0), e.vector[k]);
  return p;
}

/* Inverse of a; in two dimensions that of its upper left 2x2 block, with zz = 1. ok = 0 and the
   identity where |det| < min_det (or is not a number). */
TM_FN tm_mat3 tm_mat_inverse_guarded(tm_mat3 a, int dim3, tm_real min_det, int *ok)
{
  tm_mat3 b = tm_mat_identity();
  if (!dim3) {
    const tm_real det = a.xx * a.yy - a.xy * a.yx;
    *ok = fabs(det) >= min_det && det != 0.0;
    if (!*ok) return b;
    b.xx = a.yy / det; b.xy = -a.xy / det;
    b.yx = -a.yx / det; b.yy = a.xx / det;
    return b;
  }
  tm_mat3 c; /* transposed cofactors */
  c.xx = a.yy * a.zz - a.yz * a.zy; c.xy = a.xz * a.zy - a.xy * a.zz;
  c.yx = a.yz * a.zx - a.yx * a.zz; c.yy = a.xx * a.zz - a.xz * a.zx;
  c.zx = a.yx * a.zy - a.yy * a.zx; c.zy = a.xy * a.zx - a.xx * a.zy;
  c.xz = a.xy * a.yz - a.xz * a.yy;
  c.yz = a.xz * a.yx - a.xx * a.yz;
  c.zz = a.xx * a.yy - a.xy * a.yx;
  const tm_real det = a.xx * c.xx + a.xy * c.yx + a.xz * c.zx;
  *ok = fabs(det) >= min_det && det != 0.0;
  return *ok ? tm_mat_scale(1.0 / det, c) : b;
}

#endif
