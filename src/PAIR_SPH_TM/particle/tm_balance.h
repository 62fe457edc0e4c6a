/* SPH-TM: the balanced artificial stress, which leaves a lattice under even stress alone.

   The artificial stress R f^n, f = W(r)/W(dp), pushes neighbors apart that are in tension. On the lattice, where
   nothing is wrong yet, it takes a part of the force already:
     a_i = sum m_j (P_i + P_j + (R_i + R_j) f^n).gradW,  P = sigma/rho^2,  R = -eps P+
     share = sum_j V f^n |W'|/r x^2 / sum_j V |W'|/r x^2     on the lattice of the particle's h over spacing
   passes on (1 - eps share) of a tension and all of a pressure: a bar in bending has its neutral axis elsewhere, and
   where two sizes meet the stress jumps with the share. Balanced, P - share R stands for P: the sum passes on what P
   says, and pairs that are nearer than the lattice has them are pushed apart, others pulled, as before.

   The part share R takes power out of the motion as a stress does: rho share R : L per mass, see tm_update.h. */
#ifndef TM_BALANCE_H
#define TM_BALANCE_H

#include "tm_artificial.h"
#include "tm_lattice.h"
#include "tm_size.h"

/* [setup] The share on the lattice of spacing 1, h over spacing, with exponent n. */
TM_FN tm_real tm_tensile_share(int kernel, int dim, tm_real h, int n)
{
  const int cells = tm_lattice_cells(kernel, h), nz = dim == 3 ? cells : 0;
  const tm_real inv_w = 1.0 / tm_kernel_shape(kernel, 1.0 / h);
  tm_real part = 0.0, whole = 0.0;
  for (int x = 1; x <= cells; x++)
    for (int y = -cells; y <= cells; y++)
      for (int z = -nz; z <= nz; z++) {
        const tm_real w = tm_lattice_weight(kernel, dim, h, x, y, z) * x * x;
        const tm_real f = tm_kernel_shape(kernel, sqrt((tm_real) (x * x + y * y + z * z)) / h) * inv_w;
        whole += w;
        part += w * tm_power_int(f, n);
      }
  return part / whole;
}

/* [setup] Over h/spacing as tm_gradient_table has it; tm_gradient_factor reads it. */
TM_FN void tm_tensile_table(int kernel, int dim, int n, tm_real *table)
{
  for (int k = 0; k < TM_GRADIENT_ENTRIES; k++)
    table[k] =
        tm_tensile_share(kernel, dim,
                         TM_GRADIENT_LEAST + k * (TM_GRADIENT_MOST - TM_GRADIENT_LEAST) / (TM_GRADIENT_ENTRIES - 1), n);
}

/* The share of particle i; table: NULL where the stress is not balanced; size: NULL where all have the one ratio. */
TM_FN tm_real tm_share_of(const tm_real *table, const tm_real *size, tm_real ratio)
{
  return table ? tm_gradient_factor(table, size ? size[tm_column(TM_S_RATIO)] : ratio) : 0.0;
}

#endif
