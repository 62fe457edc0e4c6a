/* SPH-TM: eigenvalues and eigenvectors of symmetric tensors, positive part, guarded inverse.

   Jacobi rotations (Golub and Van Loan, section 8.5): unconditionally stable, orthonormal
   vectors to round-off also for equal eigenvalues. A tensor with xz = yz = 0 is diagonal after
   one rotation. */
#ifndef TM_EIGEN_H
#define TM_EIGEN_H

#include "tm_tensor.h"

typedef struct {
  tm_real value[3];
  tm_vec3 vector[3]; /* orthonormal, vector[k] belongs to value[k]; no order */
} tm_eigen;

typedef struct {
  tm_real c, s, t; /* cosine, sine, tangent */
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
TM_FN void tm_jacobi_rotate(tm_real *app, tm_real *aqq, tm_real *apq, tm_real *apr, tm_real *aqr, tm_vec3 *vp,
                            tm_vec3 *vq)
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
  /* clang-format off */
  e.value[0] = a.xx; e.value[1] = a.yy; e.value[2] = a.zz;
  e.vector[0] = u; e.vector[1] = v; e.vector[2] = w;
  /* clang-format on */
  return e;
}

/* a + k v v^T */
TM_FN tm_sym3 tm_sym_add_dyad(tm_sym3 a, tm_real k, tm_vec3 v)
{
  return tm_sym(a.xx + k * v.x * v.x, a.yy + k * v.y * v.y, a.zz + k * v.z * v.z, a.xy + k * v.x * v.y,
                a.xz + k * v.x * v.z, a.yz + k * v.y * v.z);
}

/* --- positive part: sum_k max(lambda_k, 0) e_k e_k^T, without eigenvectors where possible ---- */

/* Of the xx, yy, xy block; the rest is returned as 0. */
TM_FN tm_sym3 tm_sym_positive_part_2d(tm_sym3 a)
{
  const tm_real mean = 0.5 * (a.xx + a.yy), d = 0.5 * (a.xx - a.yy), r = sqrt(d * d + a.xy * a.xy);
  const tm_real p1 = tm_max(mean + r, 0.0), p2 = tm_max(mean - r, 0.0);
  const tm_real c = 0.5 * (p1 + p2), k = r > 0.0 ? 0.5 * (p1 - p2) / r : 0.0;
  return tm_sym(c + k * d, c - k * d, 0.0, k * a.xy, 0.0, 0.0);
}

/* cos(acos(r)/3) for r in [0, 1]: Newton for 4c^3 - 3c = r from a start within 5e-4 */
TM_FN tm_real tm_cos_third(tm_real r)
{
  tm_real c = 0.86602540378443865 + r * (0.161 - 0.02702540378443865 * r);
  c -= ((4.0 * c * c - 3.0) * c - r) / (12.0 * c * c - 3.0);
  c -= ((4.0 * c * c - 3.0) * c - r) / (12.0 * c * c - 3.0);
  c -= ((4.0 * c * c - 3.0) * c - r) / (12.0 * c * c - 3.0);
  return c;
}

/* Unit null vector of a symmetric matrix of rank 2: the longest cross product of two rows. */
TM_FN tm_vec3 tm_sym_null_vector(tm_sym3 a)
{
  const tm_vec3 x = tm_vec(a.xx, a.xy, a.xz), y = tm_vec(a.xy, a.yy, a.yz);
  const tm_vec3 z = tm_vec(a.xz, a.yz, a.zz);
  const tm_vec3 c1 = tm_vec_cross(x, y), c2 = tm_vec_cross(y, z), c3 = tm_vec_cross(z, x);
  const tm_real n1 = tm_vec_dot(c1, c1), n2 = tm_vec_dot(c2, c2), n3 = tm_vec_dot(c3, c3);
  const tm_real n12 = tm_max(n1, n2), s = 1.0 / sqrt(tm_max(n12, n3));
  const int one = n1 >= n2, three = n3 >= n12;
  /* clang-format off */
  return tm_vec(s * (three ? c3.x : one ? c1.x : c2.x), s * (three ? c3.y : one ? c1.y : c2.y),
                s * (three ? c3.z : one ? c1.z : c2.z));
  /* clang-format on */
}

TM_FN tm_real tm_sym_det(tm_sym3 s)
{
  return s.xx * (s.yy * s.zz - s.yz * s.yz) - s.xy * (s.xy * s.zz - s.yz * s.xz) + s.xz * (s.xy * s.yz - s.yy * s.xz);
}
/* a : (u v^T) */
TM_FN tm_real tm_sym_between(tm_vec3 u, tm_sym3 a, tm_vec3 v) { return tm_vec_dot(u, tm_sym_mul_vec(a, v)); }

/* In three dimensions, after Scherzinger and Dohrmann 2008: the eigenvalue farthest from the two
   others (mean +- 2p cos(phi), well conditioned) and its vector, then the plane across it in
   closed form, which takes equal eigenvalues as they come. Without branches, for loops over many
   tensors; what is not a number where all eigenvalues have one sign is thrown away at the end. */
TM_FN tm_sym3 tm_sym_positive_part(tm_sym3 a)
{
  const tm_real mean = tm_sym_trace(a) / 3.0;
  const tm_sym3 dev = tm_sym_add_iso(a, -mean);
  const tm_real p = sqrt(tm_sym_ddot(dev, dev) / 6.0);
  const int all = mean >= 2.0 * p, none = mean <= -2.0 * p;

  const tm_sym3 s = tm_sym_scale(1.0 / p, dev); /* eigenvalues 2 cos(phi), phi + 2 pi/3 ... */
  const tm_real half = 0.5 * tm_sym_det(s);
  const tm_real c = 2.0 * tm_cos_third(tm_min(fabs(half), 1.0));
  const tm_vec3 v = tm_sym_null_vector(tm_sym_add_iso(s, half < 0.0 ? c : -c));

  /* u, w across v: Duff et al. 2017 */
  const tm_real sign = v.z < 0.0 ? -1.0 : 1.0, f = -1.0 / (sign + v.z), g = v.x * v.y * f;
  const tm_vec3 u = tm_vec(1.0 + sign * v.x * v.x * f, sign * g, -sign * v.x);
  const tm_vec3 w = tm_vec(g, sign + v.y * v.y * f, -v.y);
  const tm_sym3 plane = tm_sym_positive_part_2d(
      tm_sym(tm_sym_between(u, a, u), tm_sym_between(w, a, w), 0, tm_sym_between(u, a, w), 0, 0));
  const tm_vec3 pu = tm_vec_axpy(tm_vec_scale(plane.xx, u), plane.xy, w);
  const tm_vec3 pw = tm_vec_axpy(tm_vec_scale(plane.xy, u), plane.yy, w);
  const tm_vec3 pv = tm_vec_scale(tm_max(tm_sym_between(v, a, v), 0.0), v);
  const tm_real xx = pu.x * u.x + pw.x * w.x + pv.x * v.x, yy = pu.y * u.y + pw.y * w.y + pv.y * v.y;
  const tm_real zz = pu.z * u.z + pw.z * w.z + pv.z * v.z, xy = pu.x * u.y + pw.x * w.y + pv.x * v.y;
  const tm_real xz = pu.x * u.z + pw.x * w.z + pv.x * v.z, yz = pu.y * u.z + pw.y * w.z + pv.y * v.z;
  /* clang-format off */
  return tm_sym(all ? a.xx : none ? 0.0 : xx, all ? a.yy : none ? 0.0 : yy,
                all ? a.zz : none ? 0.0 : zz, all ? a.xy : none ? 0.0 : xy,
                all ? a.xz : none ? 0.0 : xz, all ? a.yz : none ? 0.0 : yz);
  /* clang-format on */
}

/* --- inverse of a positive semidefinite tensor ------------------------------------------------ */

/* Eigenvalues below low > 0 count as low. In two dimensions that of the upper left 2x2 block, with
   zz = 1. The direct inverse where no eigenvalue can be below low; not a number stays so. */
TM_FN tm_sym3 tm_sym_inverse_bounded(tm_sym3 a, int dim3, tm_real low)
{
  if (!dim3) {
    a.zz = 1.0;
    a.xz = a.yz = 0.0;
  }
  const tm_real det = dim3 ? tm_sym_det(a) : a.xx * a.yy - a.xy * a.xy;
  const tm_real trace = dim3 ? tm_sym_trace(a) : a.xx + a.yy;
  /* the product of the two larger eigenvalues is at most (trace/2)^2 */
  if (det < low * (dim3 ? 0.25 * trace * trace : trace) || det <= 0.0) {
    const tm_eigen e = tm_sym_eigen(a);
    tm_sym3 b = tm_sym(0, 0, 0, 0, 0, 0);
    for (int k = 0; k < 3; k++) b = tm_sym_add_dyad(b, 1.0 / tm_max(e.value[k], low), e.vector[k]);
    return b;
  }
  const tm_real d = 1.0 / det;
  if (!dim3) return tm_sym(d * a.yy, d * a.xx, 1.0, -d * a.xy, 0.0, 0.0);
  return tm_sym(d * (a.yy * a.zz - a.yz * a.yz), d * (a.xx * a.zz - a.xz * a.xz), d * (a.xx * a.yy - a.xy * a.xy),
                d * (a.xz * a.yz - a.xy * a.zz), d * (a.xy * a.yz - a.xz * a.yy), d * (a.xy * a.xz - a.xx * a.yz));
}

#endif
