/* SPH-TM: smoothing length from the neighbors' distances (ASPH), S13 section 3 after Owen 2010.

     Psi_i = (sum over j != i of W(|x_ij|/h_i))^(1/d), kernel normalized for h = 1       S13 (1)
   On the regular lattice of spacing dp, Psi is a rising function of n_h = h/dp; the table is that
   function, and its inverse gives the effective n_h of any neighborhood. With the target n_h of the
   particle's own first neighborhood and s = target/n_h, kept within [1/4, 4]:
     a = 0.4 (1 + s^2) below 1, 0.4 (1 + s^-3) above;  h_new = h (1 - a + a s)          S13 (2), (3)
   The particle itself is left out of the sum: it would add the same at any distance of the others.
   The alternative, h from density, is dh/dt = -(h/(d rho)) drho/dt                      S13 (5),
   whose solution is h proportional to rho^(-1/d)                                        S13 (4). */
#ifndef TM_ASPH_H
#define TM_ASPH_H

#include "tm_kernel.h"

enum { TM_ASPH_ENTRIES = 256 };
#define TM_ASPH_MOST 4.0 /* largest n_h of the table; above, Psi/n_h of its end is kept */

typedef struct {
  tm_real psi[TM_ASPH_ENTRIES]; /* at n_h = least + k (TM_ASPH_MOST - least)/(TM_ASPH_ENTRIES - 1) */
  tm_real least;                /* the n_h below which a lattice has no neighbors */
  int dim;
} tm_asph_table;

/* Psi of the regular lattice (square, cubic) of spacing 1 with h = n_h, S13 (1). */
TM_FN tm_real tm_asph_lattice_psi(int kernel, int dim, tm_real n_h)
{
  const int reach = (int) (tm_kernel_support(kernel) * n_h), nz = dim == 3 ? reach : 0;
  tm_real sum = 0.0;
  for (int x = 0; x <= reach; x++)
    for (int y = 0; y <= reach; y++)
      for (int z = 0; z <= nz; z++) /* one octant, with its mirror images */
        if (x + y + z > 0)
          sum += (x ? 2 : 1) * (y ? 2 : 1) * (z ? 2 : 1) *
                 tm_kernel_shape(kernel, sqrt((tm_real) (x * x + y * y + z * z)) / n_h);
  return pow(sum * tm_kernel_norm(kernel, dim, 1.0), 1.0 / dim);
}

/* [setup] kernel, dim 2 or 3 */
TM_FN void tm_asph_make(int kernel, int dim, tm_asph_table *t)
{
  t->dim = dim;
  t->least = 1.0 / tm_kernel_support(kernel);
  for (int k = 0; k < TM_ASPH_ENTRIES; k++)
    t->psi[k] = tm_asph_lattice_psi(kernel, dim, t->least + k * (TM_ASPH_MOST - t->least) / (TM_ASPH_ENTRIES - 1));
}

/* Effective n_h of a neighborhood with the given Psi >= 0: the table read backwards. No neighbors
   (Psi 0) reads as the least n_h. */
TM_FN tm_real tm_asph_nodes(const tm_asph_table *t, tm_real psi)
{
  int lo = 0, hi = TM_ASPH_ENTRIES - 1;
  const tm_real step = (TM_ASPH_MOST - t->least) / hi;
  if (!(psi > t->psi[0])) return t->least;
  if (psi >= t->psi[hi]) return TM_ASPH_MOST * psi / t->psi[hi];
  while (hi - lo > 1) {
    const int mid = (lo + hi) / 2;
    if (t->psi[mid] <= psi) lo = mid;
    else hi = mid;
  }
  return t->least + step * (lo + (psi - t->psi[lo]) / (t->psi[hi] - t->psi[lo]));
}

/* Psi from the plain sum of shape(|x_ij|/h_i) over the neighbors, S13 (1). */
TM_FN tm_real tm_asph_psi(int kernel, int dim, tm_real shape_sum)
{
  const tm_real w = shape_sum * tm_kernel_norm(kernel, dim, 1.0);
  return dim == 3 ? cbrt(w) : sqrt(w);
}

/* Next h, S13 (2), (3); target and n_h > 0. */
TM_FN tm_real tm_asph_next(tm_real h, tm_real target, tm_real n_h)
{
  const tm_real s = tm_min(tm_max(target / n_h, 0.25), 4.0);
  const tm_real a = s < 1.0 ? 0.4 * (1.0 + s * s) : 0.4 * (1.0 + 1.0 / (s * s * s)); /* S13 (2) */
  return h * (1.0 - a + a * s);                                                      /* S13 (3) */
}

/* h at density rho of what had h0 at rho0, S13 (4). */
TM_FN tm_real tm_density_h(tm_real h0, int dim, tm_real rho0, tm_real rho)
{
  return h0 * (dim == 3 ? cbrt(rho0 / rho) : sqrt(rho0 / rho));
}

#endif
