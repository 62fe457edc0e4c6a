/* SPH-TM: vectors and tensors of three dimensions as plain structs, passed by value.

   tm_sym3 holds a symmetric tensor as xx yy zz xy xz yz. In two dimensions xz = yz = 0
   (plane strain and plane stress both keep zz). tm_mat3 is row major: m.xy = row x, column y;
   for a velocity gradient L, L.xy = d v_x / d y. */
#ifndef TM_TENSOR_H
#define TM_TENSOR_H

#include "tm_layout.h"

/* clang-format off */
typedef struct { tm_real x, y, z; } tm_vec3;
typedef struct { tm_real xx, yy, zz, xy, xz, yz; } tm_sym3;
typedef struct { tm_real xx, xy, xz, yx, yy, yz, zx, zy, zz; } tm_mat3;

/* --- vectors --------------------------------------------------------------------------- */

TM_FN tm_vec3 tm_vec(tm_real x, tm_real y, tm_real z)
{
  tm_vec3 v;
  v.x = x; v.y = y; v.z = z;
  return v;
}
TM_FN tm_vec3 tm_load3(const double *p) { return tm_vec(p[0], p[1], p[2]); }
TM_FN void tm_store3(double *p, tm_vec3 v)
{
  p[0] = v.x;
  p[1] = v.y;
  p[2] = v.z;
}
TM_FN tm_vec3 tm_vec_add(tm_vec3 a, tm_vec3 b) { return tm_vec(a.x + b.x, a.y + b.y, a.z + b.z); }
TM_FN tm_vec3 tm_vec_sub(tm_vec3 a, tm_vec3 b) { return tm_vec(a.x - b.x, a.y - b.y, a.z - b.z); }
TM_FN tm_vec3 tm_vec_scale(tm_real s, tm_vec3 a) { return tm_vec(s * a.x, s * a.y, s * a.z); }
/* a + s b */
TM_FN tm_vec3 tm_vec_axpy(tm_vec3 a, tm_real s, tm_vec3 b)
{
  return tm_vec(a.x + s * b.x, a.y + s * b.y, a.z + s * b.z);
}
TM_FN tm_real tm_vec_dot(tm_vec3 a, tm_vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
TM_FN tm_vec3 tm_vec_cross(tm_vec3 a, tm_vec3 b)
{
  return tm_vec(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}
TM_FN tm_real tm_vec_norm(tm_vec3 a) { return sqrt(tm_vec_dot(a, a)); }

/* --- symmetric tensors ----------------------------------------------------------------- */

TM_FN tm_sym3 tm_sym(tm_real xx, tm_real yy, tm_real zz, tm_real xy, tm_real xz, tm_real yz)
{
  tm_sym3 s;
  s.xx = xx; s.yy = yy; s.zz = zz; s.xy = xy; s.xz = xz; s.yz = yz;
  return s;
}
TM_FN tm_sym3 tm_sym_scale(tm_real k, tm_sym3 a)
{
  return tm_sym(k * a.xx, k * a.yy, k * a.zz, k * a.xy, k * a.xz, k * a.yz);
}
/* a + k b */
TM_FN tm_sym3 tm_sym_axpy(tm_sym3 a, tm_real k, tm_sym3 b)
{
  return tm_sym(a.xx + k * b.xx, a.yy + k * b.yy, a.zz + k * b.zz, a.xy + k * b.xy,
                a.xz + k * b.xz, a.yz + k * b.yz);
}
TM_FN tm_real tm_sym_trace(tm_sym3 a) { return a.xx + a.yy + a.zz; }
/* a + k I */
TM_FN tm_sym3 tm_sym_add_iso(tm_sym3 a, tm_real k)
{
  return tm_sym(a.xx + k, a.yy + k, a.zz + k, a.xy, a.xz, a.yz);
}
/* double contraction a : b, off-diagonal components counted twice */
TM_FN tm_real tm_sym_ddot(tm_sym3 a, tm_sym3 b)
{
  return a.xx * b.xx + a.yy * b.yy + a.zz * b.zz
       + 2.0 * (a.xy * b.xy + a.xz * b.xz + a.yz * b.yz);
}
TM_FN tm_vec3 tm_sym_mul_vec(tm_sym3 a, tm_vec3 b)
{
  return tm_vec(a.xx * b.x + a.xy * b.y + a.xz * b.z, a.xy * b.x + a.yy * b.y + a.yz * b.z,
                a.xz * b.x + a.yz * b.y + a.zz * b.z);
}
TM_FN tm_sym3 tm_sym_deviator(tm_sym3 a) { return tm_sym_add_iso(a, -tm_sym_trace(a) / 3.0); }
/* von Mises equivalent of a deviator s: sqrt(3/2 s:s) */
TM_FN tm_real tm_sym_mises(tm_sym3 s) { return sqrt(1.5 * tm_sym_ddot(s, s)); }

/* --- general tensors ------------------------------------------------------------------- */

/* symmetric part: rate of deformation of a velocity gradient */
TM_FN tm_sym3 tm_mat_symmetric(tm_mat3 l)
{
  return tm_sym(l.xx, l.yy, l.zz, 0.5 * (l.xy + l.yx), 0.5 * (l.xz + l.zx), 0.5 * (l.yz + l.zy));
}
TM_FN tm_mat3 tm_mat_from_sym(tm_sym3 s)
{
  tm_mat3 m;
  m.xx = s.xx; m.xy = s.xy; m.xz = s.xz;
  m.yx = s.xy; m.yy = s.yy; m.yz = s.yz;
  m.zx = s.xz; m.zy = s.yz; m.zz = s.zz;
  return m;
}
TM_FN tm_real tm_mat_trace(tm_mat3 l) { return l.xx + l.yy + l.zz; }
/* of the upper left 2 x 2 in two dimensions */
TM_FN tm_real tm_mat_det(tm_mat3 m, int dim3)
{
  return dim3 ? m.xx * (m.yy * m.zz - m.yz * m.zy) - m.xy * (m.yx * m.zz - m.yz * m.zx) + m.xz * (m.yx * m.zy - m.yy * m.zx)
              : m.xx * m.yy - m.xy * m.yx;
}
TM_FN tm_mat3 tm_mat_identity(void)
{
  tm_mat3 m;
  m.xx = 1.0; m.xy = 0.0; m.xz = 0.0;
  m.yx = 0.0; m.yy = 1.0; m.yz = 0.0;
  m.zx = 0.0; m.zy = 0.0; m.zz = 1.0;
  return m;
}
TM_FN tm_mat3 tm_mat_scale(tm_real k, tm_mat3 a)
{
  a.xx *= k; a.xy *= k; a.xz *= k;
  a.yx *= k; a.yy *= k; a.yz *= k;
  a.zx *= k; a.zy *= k; a.zz *= k;
  return a;
}
TM_FN tm_mat3 tm_mat_mul(tm_mat3 a, tm_mat3 b)
{
  tm_mat3 c;
  c.xx = a.xx * b.xx + a.xy * b.yx + a.xz * b.zx;
  c.xy = a.xx * b.xy + a.xy * b.yy + a.xz * b.zy;
  c.xz = a.xx * b.xz + a.xy * b.yz + a.xz * b.zz;
  c.yx = a.yx * b.xx + a.yy * b.yx + a.yz * b.zx;
  c.yy = a.yx * b.xy + a.yy * b.yy + a.yz * b.zy;
  c.yz = a.yx * b.xz + a.yy * b.yz + a.yz * b.zz;
  c.zx = a.zx * b.xx + a.zy * b.yx + a.zz * b.zx;
  c.zy = a.zx * b.xy + a.zy * b.yy + a.zz * b.zy;
  c.zz = a.zx * b.xz + a.zy * b.yz + a.zz * b.zz;
  return c;
}

/* product of two symmetric tensors */
TM_FN tm_mat3 tm_sym_mul(tm_sym3 a, tm_sym3 b) { return tm_mat_mul(tm_mat_from_sym(a), tm_mat_from_sym(b)); }

/* --- in arrays ------------------------------------------------------------------------- */

TM_FN tm_sym3 tm_sym_load(const tm_real *p) { return tm_sym(p[0], p[1], p[2], p[3], p[4], p[5]); }
TM_FN void tm_sym_store(tm_real *p, tm_sym3 s)
{
  p[0] = s.xx; p[1] = s.yy; p[2] = s.zz; p[3] = s.xy; p[4] = s.xz; p[5] = s.yz;
}
TM_FN tm_mat3 tm_mat_load(const tm_real *p)
{
  tm_mat3 m;
  m.xx = p[0]; m.xy = p[1]; m.xz = p[2];
  m.yx = p[3]; m.yy = p[4]; m.yz = p[5];
  m.zx = p[6]; m.zy = p[7]; m.zz = p[8];
  return m;
}
TM_FN void tm_mat_store(tm_real *p, tm_mat3 m)
{
  p[0] = m.xx; p[1] = m.xy; p[2] = m.xz;
  p[3] = m.yx; p[4] = m.yy; p[5] = m.yz;
  p[6] = m.zx; p[7] = m.zy; p[8] = m.zz;
}

/* The same in rows of a particle, and in its record, where first is even; see tm_layout.h. In two dimensions, dim3 = 0, a
   literal in loops, what couples a plane with z is 0 in every row and stays so: it is neither read nor written. */
TM_FN tm_sym3 tm_sym_from_row_in(const tm_real *row, int dim3)
{
  tm_real p[6] = {0};
  for (int k = 0; k < (dim3 ? 6 : 4); k++) p[k] = row[tm_column(k)];
  return tm_sym_load(p);
}
TM_FN void tm_sym_to_row_in(tm_real *row, tm_sym3 s, int dim3)
{
  tm_real p[6];
  tm_sym_store(p, s);
  for (int k = 0; k < (dim3 ? 6 : 4); k++) row[tm_column(k)] = p[k];
}
TM_FN tm_sym3 tm_sym_from_row(const tm_real *row) { return tm_sym_from_row_in(row, 1); }
TM_FN void tm_sym_to_row(tm_real *row, tm_sym3 s) { tm_sym_to_row_in(row, s, 1); }
TM_FN tm_mat3 tm_mat_from_row(const tm_real *row)
{
  tm_real p[9];
  for (int k = 0; k < 9; k++) p[k] = row[tm_column(k)];
  return tm_mat_load(p);
}
/* A velocity gradient of a plane has no zz either. */
TM_FN tm_mat3 tm_mat_from_row_in(const tm_real *row, int dim3)
{
  if (dim3) return tm_mat_from_row(row);
  const tm_real p[9] = {row[0], row[tm_column(1)], 0, row[tm_column(3)], row[tm_column(4)], 0, 0, 0, 0};
  return tm_mat_load(p);
}
TM_FN tm_vec3 tm_vec_from_row_in(const tm_real *row, int dim3)
{
  return tm_vec(row[0], row[tm_column(1)], dim3 ? row[tm_column(2)] : 0.0);
}
TM_FN void tm_vec_to_row_in(tm_real *row, tm_vec3 v, int dim3)
{
  row[0] = v.x;
  row[tm_column(1)] = v.y;
  if (dim3) row[tm_column(2)] = v.z;
}
TM_FN tm_vec3 tm_vec_from_record(const tm_real *record, int first, int dim3)
{
  return tm_vec(record[tm_part(first)], record[tm_part(first + 1)],
                dim3 ? record[tm_part(first + 2)] : 0.0);
}
TM_FN tm_sym3 tm_sym_from_record(const tm_real *record, int first)
{
  tm_real p[6];
  for (int k = 0; k < 6; k++) p[k] = record[tm_part(first + k)];
  return tm_sym_load(p);
}
/* The components of m row major, from column `first` of a record on. */
TM_FN void tm_mat_to_record(tm_real *record, int first, tm_mat3 m)
{
  tm_real c[9];
  tm_mat_store(c, m);
  for (int k = 0; k < 9; k++) record[tm_part(first + k)] = c[k];
}
TM_FN void tm_vec_to_record(tm_real *record, int first, tm_vec3 v)
{
  record[tm_part(first)] = v.x;
  record[tm_part(first + 1)] = v.y;
  record[tm_part(first + 2)] = v.z;
}
TM_FN tm_vec3 tm_vec_from_row(const tm_real *row) { return tm_vec(row[0], row[tm_column(1)], row[tm_column(2)]); }
TM_FN void tm_vec_to_row(tm_real *row, tm_vec3 v)
{
  row[0] = v.x;
  row[tm_column(1)] = v.y;
  row[tm_column(2)] = v.z;
}
TM_FN tm_mat3 tm_mat_transposed(tm_mat3 a)
{
  tm_real t = a.xy; a.xy = a.yx; a.yx = t;
  t = a.xz; a.xz = a.zx; a.zx = t;
  t = a.yz; a.yz = a.zy; a.zy = t;
  return a;
}
/* The rotation R by the vector `angle` (radian), in the form of Cayley: orthogonal, and off by |angle|^3/12. */
TM_FN tm_mat3 tm_mat_rotation(tm_vec3 angle)
{
  const tm_vec3 a = tm_vec_scale(0.5, angle);
  const tm_real f = 2.0 / (1.0 + tm_vec_dot(a, a)), n = 1.0 - f * tm_vec_dot(a, a);
  tm_mat3 R; /* 1 + f ([a] + [a]^2), [a]^2 = a a^T - a.a */
  R.xx = n + f * a.x * a.x;
  R.yy = n + f * a.y * a.y;
  R.zz = n + f * a.z * a.z;
  R.xy = f * (a.x * a.y - a.z);
  R.yx = f * (a.x * a.y + a.z);
  R.xz = f * (a.x * a.z + a.y);
  R.zx = f * (a.x * a.z - a.y);
  R.yz = f * (a.y * a.z - a.x);
  R.zy = f * (a.y * a.z + a.x);
  return R;
}
/* R s R^T of the same rotation */
TM_FN tm_sym3 tm_sym_turned(tm_sym3 s, tm_vec3 angle)
{
  const tm_mat3 R = tm_mat_rotation(angle);
  return tm_mat_symmetric(tm_mat_mul(R, tm_mat_mul(tm_mat_from_sym(s), tm_mat_transposed(R))));
}
TM_FN tm_mat3 tm_mat_outer(tm_vec3 a, tm_vec3 b)
{
  const tm_mat3 m = {a.x * b.x, a.x * b.y, a.x * b.z, a.y * b.x, a.y * b.y, a.y * b.z, a.z * b.x, a.z * b.y, a.z * b.z};
  return m;
}
TM_FN tm_vec3 tm_mat_mul_vec(tm_mat3 a, tm_vec3 b)
{
  return tm_vec(a.xx * b.x + a.xy * b.y + a.xz * b.z, a.yx * b.x + a.yy * b.y + a.yz * b.z,
                a.zx * b.x + a.zy * b.y + a.zz * b.z);
}
TM_FN void tm_sym_to_record(tm_real *record, int first, tm_sym3 s)
{
  tm_real p[6];
  tm_sym_store(p, s);
  for (int k = 0; k < 6; k++) record[tm_part(first + k)] = p[k];
}


TM_FN tm_mat3 tm_mat_add(tm_mat3 a, tm_mat3 b)
{
  a.xx += b.xx; a.xy += b.xy; a.xz += b.xz;
  a.yx += b.yx; a.yy += b.yy; a.yz += b.yz;
  a.zx += b.zx; a.zy += b.zy; a.zz += b.zz;
  return a;
}

/* Inverse; *good is 0 where the matrix is nearly singular. In two dimensions that of the upper left block, with
   zz = 1. */
TM_FN tm_mat3 tm_mat_inverse(tm_mat3 a, int dim3, int *good)
{
  tm_mat3 b = tm_mat_identity();
  const tm_real size = a.xx * a.xx + a.xy * a.xy + a.yx * a.yx + a.yy * a.yy;
  if (!dim3) {
    const tm_real det = a.xx * a.yy - a.xy * a.yx;
    *good = fabs(det) > 0.05 * 0.5 * size;
    if (!*good) return b;
    b.xx = a.yy / det; b.xy = -a.xy / det; b.yx = -a.yx / det; b.yy = a.xx / det;
    return b;
  }
  const tm_real all = (size + a.xz * a.xz + a.yz * a.yz + a.zx * a.zx + a.zy * a.zy + a.zz * a.zz) / 3.0;
  const tm_real cxx = a.yy * a.zz - a.yz * a.zy, cyx = a.yz * a.zx - a.yx * a.zz, czx = a.yx * a.zy - a.yy * a.zx;
  const tm_real det = a.xx * cxx + a.xy * cyx + a.xz * czx;
  *good = det * det > 0.0025 * all * all * all;
  if (!*good) return b;
  const tm_real per = 1.0 / det;
  b.xx = cxx * per; b.yx = cyx * per; b.zx = czx * per;
  b.xy = (a.xz * a.zy - a.xy * a.zz) * per;
  b.yy = (a.xx * a.zz - a.xz * a.zx) * per;
  b.zy = (a.xy * a.zx - a.xx * a.zy) * per;
  b.xz = (a.xy * a.yz - a.xz * a.yy) * per;
  b.yz = (a.xz * a.yx - a.xx * a.yz) * per;
  b.zz = (a.xx * a.yy - a.xy * a.yx) * per;
  return b;
}
/* clang-format on */

#endif
