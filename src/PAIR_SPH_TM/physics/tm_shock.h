/* SPH-TM: bulk viscosity of a particle in a shock.

   A shock is thinner than a few spacings. With the quadratic viscosity of pairs alone, which at the small Mach numbers of impacts
   between metals is far too small (mu/c is a hundredth), particles go on ringing behind it: the deviator is worn down and metal
   flows that should rest (case_plate_impact.py). So in compression a pressure can be added, as von Neumann and Richtmyer 1950 (doi
   10.1063/1.1699639) did, here linear in the rate (Landshoff 1955), as in every code of finite elements for impact:

     q = b w rho c h rate,   b = shock (Z^2 - 0.01)/(1 + Z^2) >= 0,   Z = 10 (h/c) rate/(Y/(rho c^2)),   rate = (drho/dt)/rho > 0

   Z is 1 where the longitudinal stress rises by a tenth of the flow stress in the time that sound takes for h. A shock that makes
   metal flow passes in 2 to 4 of these times, so Z is far above 1 there. In metal that is cut or forged the density changes far
   more slowly, and elastic waves pass with what the flow stress bears: there q is small, and nothing at all below Z = 0.1, which slow metal does not pass.
   A pressure leaves shear alone. Linear viscosity of pairs, switched on by the same Z, does not: it made the foot of a Taylor bar
   3 to 6 % too small, and left twenty times the error in the deviator of copper.

   q acts with the stress, in the same sums: momentum is exact, and its work on the motion is -q tr L, what the update books as
   heat. The rate is that of the last step; what its lag bears limits b, tm_shock_bound(). At free faces, and for particles that lose
   their neighbors, gradients answer faster than that: w = 1 - (|K - 1|/0.3)^2, not below 0, lets q act inside alone, where the
   correction K is near 1. Without w single particles at a tool made up to a
   tenth of its work out of nothing. It is on where a material yields (effect_plan.cpp). shock trades what is
   behind a front against its width, in h about shock c/u, u the jump of the velocity: bounds of q by the compression there is
   already, or by a part that is quadratic in the rate, made the one worse as they made the other better. Without a flow stress
   TM_SHOCK_LEAST rho c^2 takes its place; what is elastic has no q, since ringing leaves nothing behind there. */
#ifndef TM_SHOCK_H
#define TM_SHOCK_H

#include "tm_tensor.h"

#define TM_SHOCK_RISE 10.0
/* Z from which on there is a q. */
#define TM_SHOCK_STARTS 0.1
/* Least flow stress, over rho c^2: that of soft aluminum. */
#define TM_SHOCK_LEAST 5e-4
/* Turn of the shortest waves in h/c where a particle has neighbors all around: 1.1 in a lattice (tm_time_step.h), and what disorder adds. */
#define TM_SHOCK_TURN 1.7
/* |K - 1| from which on q is 0; at the face of a plane it is 0.5. */
#define TM_SHOCK_INSIDE 0.3

/* w of the correction K: the mean square of K - 1 over the axes of space counts. */
TM_FN tm_real tm_shock_inside(tm_sym3 K, int dim3)
{
  const tm_sym3 D = tm_sym_axpy(K, -1.0, tm_sym(1.0, 1.0, 1.0, 0.0, 0.0, 0.0));
  const tm_real off = dim3 ? tm_sym_ddot(D, D) / 3.0 : 0.5 * (D.xx * D.xx + D.yy * D.yy) + D.xy * D.xy;
  return tm_max(1.0 - off / (TM_SHOCK_INSIDE * TM_SHOCK_INSIDE), 0.0);
}

/* The largest b for which a wave is damped that turns by t in a step, while its rate lags by a step: with the predictor of tm_state.h
   1.7 b t may be 0.74, 0.60, 0.49, 0.35 for t = 0.2, 0.4, 0.5, 0.6 (eigenvalues); 0.85 (1 - t) is below, for shorter steps b is above 1. */
TM_FN tm_real tm_shock_bound(tm_real h, tm_real c, tm_real dt)
{
  const tm_real t = TM_SHOCK_TURN * c * dt / h;
  return 0.85 * tm_max(1.0 - t, 0.0) / (TM_SHOCK_TURN * t);
}

/* Whether there is a q at all, by products alone; rho_rate = drho/dt, all others as below. */
TM_FN int tm_shock_acts(tm_real rho_rate, tm_real h, tm_real c, tm_real rho, tm_real yield)
{
  return TM_SHOCK_RISE * rho_rate * h * c > TM_SHOCK_STARTS * tm_max(yield, TM_SHOCK_LEAST * rho * c * c);
}

/* q >= 0 (pressure) of a particle inside; rate = (drho/dt)/rho (1/time), yield = Y >= 0; shock >= 0, rho > 0, c > 0, h > 0, dt > 0. */
TM_FN tm_real tm_shock_pressure(tm_real shock, tm_real rate, tm_real h, tm_real c, tm_real rho, tm_real yield,
                                tm_real dt)
{
  const tm_real squeezed = tm_max(rate, 0.0) * h / c; /* in h/c */
  const tm_real rho_c2 = rho * c * c;
  const tm_real Z = TM_SHOCK_RISE * squeezed / tm_max(yield / rho_c2, TM_SHOCK_LEAST);
  const tm_real most = shock * tm_max(Z * Z - TM_SHOCK_STARTS * TM_SHOCK_STARTS, 0.0) / (1.0 + Z * Z);
  const tm_real b = tm_min(most, tm_shock_bound(h, c, dt));
  return b * rho_c2 * squeezed;
}

#endif
