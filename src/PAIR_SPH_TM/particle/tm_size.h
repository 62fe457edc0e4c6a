/* SPH-TM: particles with a smoothing length and a size of their own.

   A pair has one kernel, with h_ij = sqrt(h_i h_j), and the mean of the two correction factors: all of
   it symmetric, so that pair forces stay equal and opposite and energy stays as exact as with one h.
   Measured at an interface of particles 1 : 2 in size on square lattices, hyperbolic kernel, h = 1.2 edges,
   root of the mean squares near the interface:
                                  gradient of a linear field     h acceleration under uniform stress
     sqrt(h_i h_j)                          0.036                            0.046 sigma/rho
     (h_i + h_j)/2                          0.040                            0.060
     mean of the two gradients              0.033                            0.081
   It also costs least. A pair meets when r < support h_ij.

   Sums over gradW are divided by what they make of a linear field on the lattice (tm_lattice.h); here
   by that of the particle's own h over its own spacing (m/rho)^(1/d), so that it stays right for
   refined particles and where h follows a stretched neighborhood. */
#ifndef TM_SIZE_H
#define TM_SIZE_H

#include "tm_lattice.h"
#include "tm_record.h"
#include "tm_state.h"

/* Kernel of a pair. */
typedef struct {
  tm_pair h, inv_h, norm, slope_norm, inv_w;
} tm_pair_size;

/* The particle's own, from its record: slope_norm is its correction factor. Without a record, that of
   all particles. */
TM_FN tm_pair_size tm_own_size(const tm_pair *record, tm_pair_size of_all)
{
  tm_pair_size p = of_all;
  if (!record) return p;
  p.inv_h = record[TM_SIZE_INV_H];
  p.h = 1 / p.inv_h;
  p.slope_norm = record[TM_SIZE_FACTOR];
  p.inv_w = record[TM_SIZE_TENSILE];
  return p;
}

/* [hot] The pair with a particle of 1/h inv_h and so on; norm_of_one: constant of the kernel for h = 1. */
TM_FN tm_pair_size tm_pair_of_sizes(const tm_pair_size *own, tm_pair inv_h, tm_pair factor, tm_pair tensile,
                                    tm_pair norm_of_one, int dim3)
{
  tm_pair_size p;
  const tm_pair k2 = own->inv_h * inv_h;
  p.inv_h = tm_pair_sqrt(k2);
  p.h = 1 / p.inv_h;
  p.norm = norm_of_one * k2 * (dim3 ? p.inv_h : 1);
  p.slope_norm = p.norm * p.inv_h * TM_PAIR(0.5) * (own->slope_norm + factor);
  p.inv_w = TM_PAIR(0.5) * (own->inv_w + tensile);
  return p;
}

/* 1/G over h/spacing, in equal steps from TM_GRADIENT_LEAST to TM_GRADIENT_MOST; constant outside. */
enum { TM_GRADIENT_ENTRIES = 257 };
#define TM_GRADIENT_LEAST 0.8
#define TM_GRADIENT_MOST 4.0

TM_FN void tm_gradient_table(int kernel, int dim, tm_real *table)
{
  for (int k = 0; k < TM_GRADIENT_ENTRIES; k++)
    table[k] = 1.0 / tm_lattice_gradient(kernel, dim,
                                         TM_GRADIENT_LEAST +
                                             k * (TM_GRADIENT_MOST - TM_GRADIENT_LEAST) / (TM_GRADIENT_ENTRIES - 1));
}

TM_FN tm_real tm_gradient_factor(const tm_real *table, tm_real ratio)
{
  const tm_real at = (ratio - TM_GRADIENT_LEAST) * (TM_GRADIENT_ENTRIES - 1) / (TM_GRADIENT_MOST - TM_GRADIENT_LEAST);
  const tm_real in = tm_min(tm_max(at, 0.0), (tm_real) TM_GRADIENT_ENTRIES - 1.0); /* NaN: 0 */
  const int k = (int) tm_min(in, (tm_real) TM_GRADIENT_ENTRIES - 2.0);
  return table[k] + (in - k) * (table[k + 1] - table[k]);
}

/* d-th root */
TM_FN tm_real tm_edge(tm_real volume, int dim3) { return dim3 ? cbrt(volume) : sqrt(volume); }

/* The size of a particle that is new. ratio: h over spacing. */
TM_FN void tm_size_initial(tm_real *size, tm_real mass, tm_real rho0, tm_real ratio, int dim3)
{
  size[tm_column(TM_S_DP)] = tm_edge(mass / rho0, dim3);
  size[tm_column(TM_S_H)] = ratio * size[tm_column(TM_S_DP)];
  size[tm_column(TM_S_RATIO)] = ratio;
  size[tm_column(TM_S_TARGET)] = 0.0;
}

/* Record of size of a particle; volume is the current one (plane stress: area). */
TM_FN void tm_size_record(const tm_real *size, tm_real volume, const tm_real *gradient, int kernel, int dim3,
                          tm_real *out)
{
  out[TM_SIZE_INV_H] = 1.0 / size[tm_column(TM_S_H)];
  out[TM_SIZE_FACTOR] = tm_gradient_factor(gradient, size[tm_column(TM_S_H)] / tm_edge(volume, dim3));
  out[TM_SIZE_TENSILE] = 1.0 / tm_kernel_shape(kernel, 1.0 / size[tm_column(TM_S_RATIO)]);
  out[TM_SIZE_DP] = size[tm_column(TM_S_DP)];
}

/* Extremes over particles. */
typedef struct {
  tm_real largest_h, smallest_h, smallest_dp;
} tm_size_range;

TM_FN tm_size_range tm_size_nothing(void)
{
  tm_size_range r;
  r.largest_h = 0.0;
  r.smallest_h = r.smallest_dp = 1e300;
  return r;
}
TM_FN tm_size_range tm_size_of(int i, const tm_state *s)
{
  const tm_real *size = tm_field_row(s, TM_F_SIZE, i);
  tm_size_range r = tm_size_nothing();
  if (!(size[tm_column(TM_S_H)] > 0.0)) return r; /* new, and not set yet */
  r.largest_h = r.smallest_h = size[tm_column(TM_S_H)];
  r.smallest_dp = size[tm_column(TM_S_DP)];
  return r;
}
TM_FN void tm_size_sum(tm_size_range *sum, const tm_size_range *r)
{
  sum->largest_h = tm_max(sum->largest_h, r->largest_h);
  sum->smallest_h = tm_min(sum->smallest_h, r->smallest_h);
  sum->smallest_dp = tm_min(sum->smallest_dp, r->smallest_dp);
}

#endif
