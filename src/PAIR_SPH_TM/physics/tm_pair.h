/* SPH-TM: what a pair of particles i, j adds to the sums over the neighbors of particle i.

   d = x_i - x_j, v = v_i - v_j, gradW = W'/r d. The functions take TM_LANES pairs at once (tm_lanes.h), or one pair
   where there are no vectors. Each adds its products in one order, so all loops over pairs round alike. The scalar
   coefficients of a pair are in tm_artificial.h (Pi, f^n, XSPH) and tm_heat.h (conduction).

     velocity gradient   L -= v (x) g            F15 (2), F14 (4) is its trace; conjugate of F15 (4), F14 (6)
     momentum            a += P g                P = P_i + P_j, P = sigma/rho^2       F15 (4), F14 (6), (15)
     artificial stress   a += f^n R g            R = R_i + R_j                        F14 (15), (18)
     viscosity           a -= Pi g                                                    F14 (6), (15)
     artificial heating  e -= a_artificial . v   twice what the pair gives particle i, per mass
     XSPH                u -= w v                w = m_j/rho_mean W                   F14 */
#ifndef TM_PAIR_H
#define TM_PAIR_H

#include "tm_lanes.h"

typedef struct {
  tm_lanes x, y, z;
} tm_lanes_vec;
typedef struct {
  tm_lanes xx, xy, xz, yx, yy, yz, zx, zy, zz;
} tm_lanes_mat;
/* sums over neighbors */
typedef struct {
  tm_sum x, y, z;
} tm_sum_vec;
typedef struct {
  tm_sum xx, xy, xz, yx, yy, yz, zx, zy, zz;
} tm_sum_mat;
typedef struct {
  tm_sum xx, yy, zz, xy, xz, yz;
} tm_sum_sym;

TM_FN tm_sum_vec tm_sum_vec_zero(void)
{
  const tm_sum o = tm_lanes_zero();
  const tm_sum_vec s = {o, o, o};
  return s;
}
TM_FN tm_sum_mat tm_sum_mat_zero(void)
{
  const tm_sum o = tm_lanes_zero();
  const tm_sum_mat s = {o, o, o, o, o, o, o, o, o};
  return s;
}
TM_FN tm_sum_sym tm_sum_sym_zero(void)
{
  const tm_sum o = tm_lanes_zero();
  const tm_sum_sym s = {o, o, o, o, o, o};
  return s;
}
TM_FN void tm_sum_vec_add(tm_sum_vec *s, tm_lanes_vec a)
{
  s->x += a.x;
  s->y += a.y;
  s->z += a.z;
}

/* ---- values of pairs from columns, from neighbor l on */

/* own minus three columns */
TM_FN tm_lanes_vec tm_pair_difference(const tm_pair *own, tm_values *col, int l, int dim3)
{
  const tm_lanes zero = {0};
  const tm_lanes_vec v = {own[0] - tm_values_load(col[0], l), own[1] - tm_values_load(col[1], l),
                          dim3 ? own[2] - tm_values_load(col[2], l) : zero};
  return v;
}
/* own plus the columns of a symmetric tensor, both xx yy zz xy xz yz */
TM_FN tm_lanes_mat tm_pair_symmetric_sum(const tm_pair *own, tm_values *col, int l)
{
  tm_lanes_mat P;
  P.xx = own[0] + tm_values_load(col[0], l);
  P.yy = own[1] + tm_values_load(col[1], l);
  P.zz = own[2] + tm_values_load(col[2], l);
  P.xy = P.yx = own[3] + tm_values_load(col[3], l);
  P.xz = P.zx = own[4] + tm_values_load(col[4], l);
  P.yz = P.zy = own[5] + tm_values_load(col[5], l);
  return P;
}
/* own plus the columns of a tensor, both row major */
TM_FN tm_lanes_mat tm_pair_tensor_sum(const tm_pair *own, tm_values *col, int l)
{
  const tm_lanes_mat P = {own[0] + tm_values_load(col[0], l), own[1] + tm_values_load(col[1], l),
                          own[2] + tm_values_load(col[2], l), own[3] + tm_values_load(col[3], l),
                          own[4] + tm_values_load(col[4], l), own[5] + tm_values_load(col[5], l),
                          own[6] + tm_values_load(col[6], l), own[7] + tm_values_load(col[7], l),
                          own[8] + tm_values_load(col[8], l)};
  return P;
}

/* ---- products */

TM_FN tm_lanes_vec tm_lanes_scale(tm_lanes s, tm_lanes_vec a)
{
  const tm_lanes_vec v = {s * a.x, s * a.y, s * a.z};
  return v;
}
TM_FN tm_lanes_vec tm_lanes_add(tm_lanes_vec a, tm_lanes_vec b)
{
  const tm_lanes_vec v = {a.x + b.x, a.y + b.y, a.z + b.z};
  return v;
}
TM_FN tm_lanes tm_lanes_dot(tm_lanes_vec a, tm_lanes_vec b, int dim3)
{
  const tm_lanes plane = a.x * b.x + a.y * b.y;
  return dim3 ? plane + a.z * b.z : plane;
}
/* P g: the part that two dimensions have, and the rest; sums over neighbors take one after the other. */
TM_FN tm_lanes_vec tm_lanes_product_2d(tm_lanes_mat P, tm_lanes_vec g)
{
  const tm_lanes zero = {0};
  const tm_lanes_vec v = {P.xx * g.x + P.xy * g.y, P.yx * g.x + P.yy * g.y, zero};
  return v;
}
TM_FN tm_lanes_vec tm_lanes_product_rest(tm_lanes_mat P, tm_lanes_vec g)
{
  const tm_lanes_vec v = {P.xz * g.z, P.yz * g.z, P.zx * g.x + P.zy * g.y + P.zz * g.z};
  return v;
}

/* ---- sums */

/* L -= v (x) g */
TM_FN void tm_pair_gradient(tm_sum_mat *L, tm_lanes_vec v, tm_lanes_vec g, int dim3)
{
  /* clang-format off */
  L->xx -= v.x * g.x; L->xy -= v.x * g.y;
  L->yx -= v.y * g.x; L->yy -= v.y * g.y;
  if (dim3) {
    L->xz -= v.x * g.z; L->yz -= v.y * g.z;
    L->zx -= v.z * g.x; L->zy -= v.z * g.y; L->zz -= v.z * g.z;
  }
  /* clang-format on */
}

/* M -= d (x) g, symmetric, g along d */
TM_FN void tm_pair_moment(tm_sum_sym *M, tm_lanes_vec d, tm_lanes_vec g, int dim3)
{
  M->xx -= d.x * g.x;
  M->yy -= d.y * g.y;
  M->xy -= d.x * g.y;
  if (dim3) {
    M->zz -= d.z * g.z;
    M->xz -= d.x * g.z;
    M->yz -= d.y * g.z;
  }
}

/* a += P g */
TM_FN void tm_pair_momentum(tm_sum_vec *a, tm_lanes_mat P, tm_lanes_vec g, int dim3)
{
  const tm_lanes_vec plane = tm_lanes_product_2d(P, g), rest = tm_lanes_product_rest(P, g);
  a->x += plane.x;
  a->y += plane.y;
  if (dim3) {
    a->x += rest.x;
    a->y += rest.y;
    a->z += rest.z;
  }
}

/* a += P_j g, P_j row major in columns. That of the particle itself, P_i g, is P_i times the sum of g. */
TM_FN void tm_pair_momentum_of_other(tm_sum_vec *a, tm_values *col, int l, tm_lanes_vec g, int dim3)
{
  /* clang-format off */
  a->x += tm_values_load(col[0], l) * g.x; a->x += tm_values_load(col[1], l) * g.y;
  a->y += tm_values_load(col[3], l) * g.x; a->y += tm_values_load(col[4], l) * g.y;
  if (dim3) {
    a->x += tm_values_load(col[2], l) * g.z; a->y += tm_values_load(col[5], l) * g.z;
    a->z += tm_values_load(col[6], l) * g.x; a->z += tm_values_load(col[7], l) * g.y; a->z += tm_values_load(col[8], l) * g.z;
  }
  /* clang-format on */
}

/* The artificial acceleration along times d into a sum of accelerations, its heating into that of heating. */
TM_FN void tm_pair_along(tm_sum_vec *a, tm_sum *heating, tm_lanes along, tm_lanes_vec d, tm_lanes_vec v, int dim3)
{
  a->x += along * d.x;
  a->y += along * d.y;
  if (dim3) a->z += along * d.z;
  *heating -= along * tm_lanes_dot(v, d, dim3);
}

/* The artificial acceleration f^n R g of one pair. */
TM_FN tm_lanes_vec tm_pair_artificial_stress(tm_lanes_mat R, tm_lanes power, tm_lanes_vec g, int dim3)
{
  tm_lanes_vec a = tm_lanes_product_2d(R, g);
  if (dim3) {
    const tm_lanes_vec rest = tm_lanes_product_rest(R, g);
    a.x += rest.x;
    a.y += rest.y;
    a.z = rest.z;
  }
  return tm_lanes_scale(power, a);
}

/* a -= Pi g, the artificial acceleration of one pair */
TM_FN void tm_pair_viscosity(tm_lanes_vec *a, tm_lanes Pi, tm_lanes_vec g)
{
  a->x -= Pi * g.x;
  a->y -= Pi * g.y;
  a->z -= Pi * g.z;
}

/* m_j Pi W'/r of a pair with the frozen factors of tm_viscosity_factors(), each in units of its own; vx = v.d */
TM_FN tm_lanes tm_pair_viscosity_frozen(tm_lanes m, tm_lanes vx, tm_pair shock_unit, tm_lanes shock, tm_pair bulk_unit,
                                        tm_lanes bulk)
{
  const tm_lanes x = tm_lanes_negative(vx);
  return m * x * (shock_unit * shock * x - bulk_unit * bulk);
}

/* u -= w v */
TM_FN void tm_pair_xsph(tm_sum_vec *u, tm_lanes w, tm_lanes_vec v)
{
  u->x -= w * v.x;
  u->y -= w * v.y;
  u->z -= w * v.z;
}

/* The artificial acceleration of a pair into a sum of accelerations, its heating into that of heating. */
TM_FN void tm_pair_artificial(tm_sum_vec *a, tm_sum *heating, tm_lanes_vec artificial, tm_lanes_vec v)
{
  *heating -= tm_lanes_dot(artificial, v, 1);
  tm_sum_vec_add(a, artificial);
}

#endif
