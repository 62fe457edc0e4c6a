/* SPH-TM: artificial viscosity, artificial stress, XSPH.

   Viscosity (Monaghan 1992; the Pi of F14 (6), (15), added to -sigma/rho^2):
     Pi_ij = (-alpha c mu + beta mu^2)/rho,  mu = h v_ij.x_ij/(r^2 + 0.01 h^2)
   for approaching pairs (v_ij.x_ij < 0), 0 otherwise. alpha c and rho are means of the pair; alpha is one of all particles,
   or rises in shocks (tm_shock.h).
   Balsara 1995: factor |div v|/(|div v| + |curl v| + 1e-4 c/h) keeps it out of shear.

   Artificial stress, F14 (15)-(18): the pair gets (R_i + R_j) f^n, f = W(r)/W(dp).
     principal  R = -eps/rho^2 sum_k max(sigma_k, 0) e_k e_k^T           Gray, Monaghan, Swift 2001
     component  R_ab = -eps/rho^2 max(sigma_ab, 0)                       F14 (18)
   The component form depends on the frame; principal axes are the default. In two dimensions only
   the in-plane part acts; xz, yz and zz are returned as 0. F14 (18) prints no 1/rho^2, which
   F14 (15) needs for its units. */
#ifndef TM_ARTIFICIAL_H
#define TM_ARTIFICIAL_H

#include "tm_eigen.h"
#include "tm_tensor.h"

/* r^2 + 0.01 h^2, in the denominator of mu */
TM_FN tm_pair tm_viscosity_soft2(tm_pair h, tm_pair r2) { return r2 + TM_PAIR(0.01) * h * h; }

/* [hot] Pi_ij, and 1/r and 1/rho_sum with the same division. vx = v_ij.x_ij, r2 = r^2, alpha_c the mean of alpha c,
   rho_sum = rho_i + rho_j, h > 0, r > 0. */
TM_FN tm_pair tm_viscosity_pair(tm_pair beta, tm_pair h, tm_pair vx, tm_pair r2, tm_pair r, tm_pair alpha_c,
                                tm_pair rho_sum, tm_pair *inv_r, tm_pair *inv_rho_sum)
{
  const tm_pair soft2 = tm_viscosity_soft2(h, r2), inv = tm_pair_inverse(r2 * (soft2 * rho_sum));
  const tm_pair mu = h * tm_pair_min(vx, 0) * (r2 * rho_sum * inv);
  *inv_r = r * (soft2 * rho_sum) * inv;
  *inv_rho_sum = r2 * soft2 * inv;
  return (beta * mu - alpha_c) * mu * (2 * (r2 * soft2) * inv);
}

/* Pi_ij W'/r of a pair whose distance, densities and sound speeds stay as they were at one time,
     Pi_ij W'/r = x (shock x - bulk),  x = min(v_ij.x_ij, 0),
     bulk = alpha c/rho (W'/r)/(q^2 + 0.01) /h,  shock = beta/rho (W'/r)/(q^2 + 0.01)^2 /h^2,  q = r/h
   The factors without their powers of h; g = W'/r in any unit. */
TM_FN void tm_viscosity_factors(tm_real alpha, tm_real beta, tm_real q, tm_real g, tm_real c_mean, tm_real rho_sum,
                                tm_real *bulk, tm_real *shock)
{
  const tm_real per_soft = 1.0 / tm_viscosity_soft2(1.0, q * q), pi = 2.0 * g * per_soft / rho_sum;
  *bulk = alpha * c_mean * pi;
  *shock = beta * per_soft * pi;
}

/* Shear switch of one particle, 0..1; div and curl are of the velocity. */
TM_FN tm_real tm_balsara(tm_real div, tm_real curl, tm_real c, tm_real h)
{
  const tm_real d = fabs(div);
  return d / (d + fabs(curl) + 1e-4 * c / h);
}

/* [hot] Weight of v_j - v_i in the XSPH velocity of i, F14: m_j/rho_mean W; inv_rho_sum: 1/(rho_i + rho_j). */
TM_FN tm_pair tm_xsph_pair(tm_pair mass_j, tm_pair inv_rho_sum, tm_pair w) { return 2 * mass_j * inv_rho_sum * w; }

/* [hot] f^n, n = 0..15. */
TM_FN tm_pair tm_power_int(tm_pair f, int n)
{
  const tm_pair f2 = f * f, f4 = f2 * f2, f8 = f4 * f4;
  return ((n & 1) ? f : 1) * ((n & 2) ? f2 : 1) * ((n & 4) ? f4 : 1) * ((n & 8) ? f8 : 1);
}

/* Artificial stress of one particle in principal axes; scale = 1/rho^2. */
TM_FN tm_sym3 tm_artificial_stress_principal(tm_sym3 sigma, tm_real eps, tm_real scale, int dim3)
{
  const tm_sym3 t = dim3 ? tm_sym_positive_part(sigma) : tm_sym_positive_part_2d(sigma);
  return tm_sym_scale(-eps * scale, t);
}

/* Artificial stress of one particle per component, F14 (18); scale = 1/rho^2. */
TM_FN tm_sym3 tm_artificial_stress_component(tm_sym3 sigma, tm_real eps, tm_real scale, int dim3)
{
  const tm_sym3 t =
      tm_sym(tm_max(sigma.xx, 0.0), tm_max(sigma.yy, 0.0), dim3 ? tm_max(sigma.zz, 0.0) : 0.0, tm_max(sigma.xy, 0.0),
             dim3 ? tm_max(sigma.xz, 0.0) : 0.0, dim3 ? tm_max(sigma.yz, 0.0) : 0.0);
  return tm_sym_scale(-eps * scale, t);
}

#endif
