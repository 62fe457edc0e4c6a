/* SPH-TM: whether the particles around one are as far apart as their masses say, for the checks of a start.

     S = sum_j m_j/rho_j W(r_ij, h), itself included, 1 in the continuum
   On the lattice of spacing s dp with the mass of spacing dp it is
     S(s) = s^-dim sum over the lattice of W at h/(s dp),  falling with s,
   so s follows from S: 1 where all is right, less where two lattices lie over each other, more where the spacing of the
   pair style is too small. At a free surface S is low too: only where the neighbors lie around evenly,
     |sum V W x_ij| << h S,  sum V W x_ij x_ij nearly isotropic,  sum V W r^2/(h^2 S) that of a lattice
   does a low S tell of the spacing; the last is lower in the middle of a body that ends within the support radius. */
#ifndef TM_FILLING_H
#define TM_FILLING_H

#include "tm_lattice.h"
#include "tm_chunk.h"

typedef struct {
  tm_rows rows;
  tm_records rec; /* of owned and ghost particles */
  int kernel, dim;
  tm_real h; /* of particles without a size of their own */
} tm_filling_args;

typedef struct {
  tm_real sum;    /* S */
  tm_real spread; /* sum V W r^2/(h^2 S) */
  int inside;     /* its neighbors lie around it evenly */
} tm_filling;

/* On the lattice: h over the spacing of the masses, s: true spacing over theirs. */
TM_FN tm_filling tm_filling_of_lattice(int kernel, int dim, tm_real h, tm_real s)
{
  tm_filling out;
  const tm_real of = h / s, norm = tm_kernel_norm(kernel, dim, of);
  const int cells = tm_lattice_cells(kernel, of), nz = dim == 3 ? cells : 0;
  tm_real sum = 0.0, second = 0.0;
  for (int x = -cells; x <= cells; x++)
    for (int y = -cells; y <= cells; y++)
      for (int z = -nz; z <= nz; z++) {
        const tm_real r2 = x * x + y * y + z * z, w = norm * tm_kernel_shape(kernel, sqrt(r2) / of);
        sum += w;
        second += w * r2;
      }
  out.sum = sum / (dim == 3 ? s * s * s : s * s);
  out.spread = second / (of * of * sum);
  out.inside = 1;
  return out;
}

/* The s with that S, within 0.3 to 3. */
TM_FN tm_real tm_filling_spacing(int kernel, int dim, tm_real h, tm_real sum)
{
  tm_real lo = 0.3, hi = 3.0;
  for (int k = 0; k < 40; k++) {
    const tm_real mid = 0.5 * (lo + hi);
    if (tm_filling_of_lattice(kernel, dim, h, mid).sum > sum) lo = mid;
    else hi = mid;
  }
  return 0.5 * (lo + hi);
}

/* Limits of "evenly": on the lattice both are 0 beyond the support radius from a surface. */
#define TM_FILLING_LOPSIDED 0.02
#define TM_FILLING_UNEVEN 0.1

TM_FN tm_filling tm_filling_around(int i, const tm_filling_args *a)
{
  tm_filling out;
  const tm_real *p = a->rec.main + tm_record(i, TM_REC);
  const tm_real h = a->rec.size ? 1.0 / a->rec.size[(ptrdiff_t) i * TM_REC_SIZE + TM_SIZE_INV_H] : a->h;
  const tm_real norm = tm_kernel_norm(a->kernel, a->dim, h);
  tm_real first[3] = {0, 0, 0}, second[3][3] = {{0}};
  out.sum = p[tm_part(TM_REC_M)] / p[tm_part(TM_REC_RHO)] * norm * tm_kernel_shape(a->kernel, 0.0);
  for (int k = 0; k < a->rows.mechanical[i]; k++) {
    const int j = a->rows.index[a->rows.first[i] + k * a->rows.stride];
    const tm_real *q = a->rec.main + tm_record(j, TM_REC);
    const tm_real d[3] = {p[0] - q[0], p[1] - q[1], a->dim == 3 ? p[tm_part(2)] - q[tm_part(2)] : 0.0};
    const tm_real r = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    const tm_real w = q[tm_part(TM_REC_M)] / q[tm_part(TM_REC_RHO)] * norm * tm_kernel_shape(a->kernel, r / h);
    out.sum += w;
    for (int c = 0; c < 3; c++) {
      first[c] += w * d[c];
      for (int e = 0; e < 3; e++) second[c][e] += w * d[c] * d[e];
    }
  }
  tm_real uneven = 0.0, trace = 0.0;
  out.spread = (second[0][0] + second[1][1] + second[2][2]) / (h * h * out.sum);
  for (int c = 0; c < a->dim; c++) trace += second[c][c] / a->dim;
  for (int c = 0; c < a->dim; c++)
    for (int e = 0; e < a->dim; e++) uneven = tm_max(uneven, fabs(second[c][e] - (c == e ? trace : 0.0)));
  const tm_real lopsided = sqrt(first[0] * first[0] + first[1] * first[1] + first[2] * first[2]);
  out.inside = trace > 0.0 && lopsided < TM_FILLING_LOPSIDED * h * out.sum && uneven < TM_FILLING_UNEVEN * trace;
  return out;
}

#endif
