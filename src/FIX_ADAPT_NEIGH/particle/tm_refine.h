/* SPH-TM: state of the particles that a split or a merge makes, S13 section 4.

   Split: a value A of the parent becomes A + phi g.d at the child's place d, with g the gradient that is
   exact for linear fields (moment matrix), and 0 <= phi <= 1 the largest factor for which no child lies
   outside of the least and largest value of the parent and its neighbors. The places have their center
   of mass in the parent, so the mass mean of the children is the parent's value: plastic strain, damage,
   temperature and energy are bounded and conserved at once. (S13 interpolates with the kernel, which is
   bounded too, but smears and does not conserve.)

   Merge: mass, momentum and volume are summed, state is the mean over mass, stress over volume. */
#ifndef TM_REFINE_H
#define TM_REFINE_H

#include "tm_fields.h"
#include "tm_kernel.h"
#include "tm_tensor.h"

/* What a particle exports for interpolation: columns of one row of a table. */
enum {
  TM_CLOUD_X = 0,      /* position */
  TM_CLOUD_V = 3,      /* velocity */
  TM_CLOUD_VOLUME = 6, /* m/rho */
  TM_CLOUD_MASS = 7,
  TM_CLOUD_MARK = 8,   /* what is to be done to it */
  TM_CLOUD_FAMILY = 9, /* its family, 0 without */
  TM_CLOUD_LEVEL = 10,
  TM_CLOUD_STATE = 11 /* and on: state fields, one after the other */
};

typedef struct {
  const tm_real *row; /* of particle 0, owned and ghost */
  int width;          /* columns of a row */
  int kernel, dim;
} tm_cloud;

TM_FN const tm_real *tm_cloud_row(const tm_cloud *c, int i) { return c->row + (ptrdiff_t) i * c->width; }

/* From i to j, and the weight of j: its volume times the kernel of size h. */
TM_FN tm_vec3 tm_cloud_link(const tm_cloud *c, int i, int j, tm_real h, tm_real *weight)
{
  const tm_real *p = tm_cloud_row(c, i), *q = tm_cloud_row(c, j);
  const tm_vec3 d = tm_vec(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
  *weight = q[TM_CLOUD_VOLUME] * tm_kernel_shape(c->kernel, tm_vec_norm(d) / h);
  return d;
}

/* Inverse of a symmetric positive matrix of three dimensions; 0, and *inverse 0, where its determinant is not
   above least (tr/3)^3: nearly singular. */
TM_FN int tm_sym_inverse(tm_sym3 m, tm_real least, tm_sym3 *inverse)
{
  const tm_real cxx = m.yy * m.zz - m.yz * m.yz, cxy = m.xz * m.yz - m.xy * m.zz, cxz = m.xy * m.yz - m.xz * m.yy;
  const tm_real det = m.xx * cxx + m.xy * cxy + m.xz * cxz, mean = tm_sym_trace(m) / 3.0;
  *inverse = tm_sym(0, 0, 0, 0, 0, 0);
  if (!(det > least * mean * mean * mean)) return 0;
  *inverse = tm_sym_scale(1.0 / det, tm_sym(cxx, m.xx * m.zz - m.xz * m.xz, m.xx * m.yy - m.xy * m.xy, cxy, cxz,
                                            m.xy * m.xz - m.xx * m.yz));
  return 1;
}

/* Inverse of the moment matrix sum w d d of the neighbors j[0..n-1] of i. Returns 0 where they do not
   span the space: nobody within reach, or all near one line or plane; *inverse is 0 then. In 2D z stays
   out. Rank is judged by det(M)/(tr(M)/dim)^dim, which is 1 for a lattice. */
TM_FN int tm_cloud_moments(const tm_cloud *c, int i, const int *j, int n, tm_real h, tm_sym3 *inverse)
{
  tm_sym3 m = tm_sym(0, 0, 0, 0, 0, 0);
  *inverse = m;
  for (int k = 0; k < n; k++) {
    tm_real w;
    const tm_vec3 d = tm_cloud_link(c, i, j[k], h, &w);
    m = tm_sym_axpy(m, w, tm_sym(d.x * d.x, d.y * d.y, d.z * d.z, d.x * d.y, d.x * d.z, d.y * d.z));
  }
  const tm_real least = 1e-3;
  if (c->dim == 2) {
    const tm_real det = m.xx * m.yy - m.xy * m.xy, mean = 0.5 * (m.xx + m.yy);
    if (!(det > least * mean * mean)) return 0;
    *inverse = tm_sym(m.yy / det, m.xx / det, 0.0, -m.xy / det, 0.0, 0.0);
    return 1;
  }
  return tm_sym_inverse(m, least, inverse);
}

typedef struct {
  tm_vec3 gradient;
  tm_real least, most; /* of the particle and its neighbors within reach */
} tm_slope;

/* Column col of the table about particle i. */
TM_FN tm_slope tm_cloud_slope(const tm_cloud *c, int i, const int *j, int n, tm_real h, const tm_sym3 *inverse, int col)
{
  tm_slope s;
  tm_vec3 sum = tm_vec(0, 0, 0);
  const tm_real own = tm_cloud_row(c, i)[col];
  s.least = s.most = own;
  for (int k = 0; k < n; k++) {
    tm_real w;
    const tm_vec3 d = tm_cloud_link(c, i, j[k], h, &w);
    const tm_real other = tm_cloud_row(c, j[k])[col];
    if (!(w > 0.0)) continue;
    s.least = tm_min(s.least, other);
    s.most = tm_max(s.most, other);
    sum = tm_vec_axpy(sum, w * (other - own), d);
  }
  s.gradient = tm_sym_mul_vec(*inverse, sum);
  return s;
}

/* The largest factor up to 1 for which own + factor gradient.d stays within the bounds at all n places d
   (x, y, z each), scaled by size. */
TM_FN tm_real tm_slope_limit(const tm_slope *s, tm_real own, const double *place, int n, tm_real size)
{
  tm_real phi = 1.0;
  for (int k = 0; k < n; k++) {
    const tm_real step = size * tm_vec_dot(s->gradient, tm_vec(place[3 * k], place[3 * k + 1], place[3 * k + 2]));
    const tm_real room = step > 0.0 ? s->most - own : own - s->least;
    if (fabs(step) * phi > room) phi = room / fabs(step);
  }
  return phi;
}

/* Children of parent i: for n_col columns from col on, which share one factor (the components of a tensor;
   a scalar alone), adds to row k of the children (n rows of width columns, which hold the parent's) what
   their places give. place: in units of size. */
TM_FN void tm_cloud_spread(const tm_cloud *c, int i, const int *j, int neighbors, tm_real h, const tm_sym3 *inverse,
                           int col, int n_col, const double *place, int n, tm_real size, tm_real *children)
{
  enum { MOST = 6 };
  tm_slope s[MOST];
  tm_real phi = 1.0;
  for (int m = 0; m < n_col && m < MOST; m++) {
    s[m] = tm_cloud_slope(c, i, j, neighbors, h, inverse, col + m);
    const tm_real own = tm_cloud_row(c, i)[col + m];
    phi = tm_min(phi, tm_slope_limit(&s[m], own, place, n, size));
  }
  for (int k = 0; k < n; k++)
    for (int m = 0; m < n_col && m < MOST; m++) {
      const tm_real step = size * tm_vec_dot(s[m].gradient, tm_vec(place[3 * k], place[3 * k + 1], place[3 * k + 2]));
      tm_real *value = children + (ptrdiff_t) k * c->width + col + m;
      /* the bounds once more, against the last bit */
      *value = tm_min(tm_max(*value + phi * step, s[m].least), s[m].most);
    }
}

/* The size (columns TM_S_...) of a child from its parent's: part of the mass, alpha of the smoothing length, one
   of n. Its spacing is its own, (m/rho0)^(1/d), and so is the reference spacing of the artificial stress, h over
   TM_S_RATIO. tm_size_of_parent undoes it. */
TM_FN void tm_size_of_child(tm_real *size, tm_real part, tm_real alpha, int n, int dim)
{
  const tm_real edge = pow(part, 1.0 / dim);
  size[TM_S_H] *= alpha;
  size[TM_S_DP] *= edge;
  size[TM_S_RATIO] *= alpha / edge;
  size[TM_S_TARGET] *= alpha * pow((tm_real) n, 1.0 / dim);
}
TM_FN void tm_size_of_parent(tm_real *size, tm_real part, tm_real alpha, int n, int dim)
{
  const tm_real edge = pow(part, 1.0 / dim);
  size[TM_S_H] /= alpha;
  size[TM_S_DP] /= edge;
  size[TM_S_RATIO] *= edge / alpha;
  size[TM_S_TARGET] /= alpha * pow((tm_real) n, 1.0 / dim);
}

/* sum_j V_j gradW_ij, which is 0 where particles lie evenly: the acceleration in a material of uniform stress,
   over twice stress/density. The first column of state is h. */
TM_FN tm_vec3 tm_cloud_unevenness(const tm_cloud *c, int i, const int *j, int n)
{
  tm_vec3 sum = tm_vec(0, 0, 0);
  const tm_real *p = tm_cloud_row(c, i);
  for (int k = 0; k < n; k++) {
    const tm_real *q = tm_cloud_row(c, j[k]);
    const tm_vec3 d = tm_vec(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    const tm_real r = tm_vec_norm(d), h = sqrt(p[TM_CLOUD_STATE] * q[TM_CLOUD_STATE]);
    if (!(r > 0.0)) continue;
    const tm_real slope = tm_kernel_norm(c->kernel, c->dim, h) * tm_kernel_slope(c->kernel, r / h) / (h * r);
    sum = tm_vec_axpy(sum, q[TM_CLOUD_VOLUME] * slope, d);
  }
  return sum;
}

/* The sums that a split or a merge should leave as they are. */
typedef struct {
  tm_real mass, kinetic, elastic;
  tm_vec3 momentum, angular;
} tm_content;

TM_FN tm_content tm_content_nothing(void)
{
  tm_content c;
  c.mass = c.kinetic = c.elastic = 0.0;
  c.momentum = c.angular = tm_vec(0, 0, 0);
  return c;
}

/* Adds sign times the particle; x about a point near it, so that the sums keep their digits. */
TM_FN void tm_content_add(tm_content *c, tm_real sign, tm_real m, tm_vec3 x, tm_vec3 v, tm_real elastic)
{
  const tm_vec3 p = tm_vec_scale(sign * m, v);
  c->mass += sign * m;
  c->momentum = tm_vec_add(c->momentum, p);
  c->angular = tm_vec_add(c->angular, tm_vec_cross(x, p));
  c->kinetic += 0.5 * tm_vec_dot(p, v);
  c->elastic += sign * elastic;
}

TM_FN void tm_content_sum(tm_content *sum, const tm_content *c)
{
  sum->mass += c->mass;
  sum->kinetic += c->kinetic;
  sum->elastic += c->elastic;
  sum->momentum = tm_vec_add(sum->momentum, c->momentum);
  sum->angular = tm_vec_add(sum->angular, c->angular);
}

/* One particle from n (rows of width columns): mass and volume are sums, the center of mass, its velocity,
   state the mean over mass. Returns the kinetic energy that is no longer in the motion. */
TM_FN tm_real tm_cloud_merge(const tm_real *const *member, int n, int width, tm_real *out)
{
  const tm_real *first = member[0];
  tm_real mass = 0.0, lost = 0.0;
  for (int c = 0; c < width; c++) out[c] = 0.0;
  for (int k = 0; k < n; k++) {
    const tm_real *r = member[k], m = r[TM_CLOUD_MASS];
    mass += m;
    out[TM_CLOUD_VOLUME] += r[TM_CLOUD_VOLUME];
    for (int c = 0; c < width; c++)
      if (c != TM_CLOUD_VOLUME) out[c] += m * (r[c] - first[c]);
  }
  for (int c = 0; c < width; c++)
    if (c != TM_CLOUD_VOLUME) out[c] = first[c] + out[c] / mass;
  out[TM_CLOUD_MASS] = mass;
  for (int k = 0; k < n; k++)
    for (int c = 0; c < 3; c++) {
      const tm_real d = member[k][TM_CLOUD_V + c] - out[TM_CLOUD_V + c];
      lost += 0.5 * member[k][TM_CLOUD_MASS] * d * d;
    }
  return lost;
}

/* Mean over volume of n_col columns from col on, for stress. */
TM_FN void tm_cloud_volume_mean(const tm_real *const *member, int n, int col, int n_col, tm_real *out)
{
  for (int c = col; c < col + n_col; c++) {
    tm_real sum = 0.0, volume = 0.0;
    for (int k = 0; k < n; k++) {
      sum += member[k][TM_CLOUD_VOLUME] * (member[k][c] - member[0][c]);
      volume += member[k][TM_CLOUD_VOLUME];
    }
    out[c] = member[0][c] + sum / volume;
  }
}

#endif
