/* SPH-TM: coefficient of the linear artificial viscosity of a particle, switched on by shocks.

   A shock is thinner than a few spacings. With quadratic viscosity alone, which at the small Mach numbers of impacts between
   metals is far below the linear one (mu/c is a hundredth), particles go on ringing behind it: the deviator is worn down and
   metal flows that should rest (case_plate_impact.py). Linear viscosity everywhere takes work out of slow flow. So

     alpha_i = shock Z^4/(1 + Z^4),   Z = 10 rho c^2/Y (h/c) (drho/dt)/rho     in compression, 0 else

   Z is 1 where the longitudinal stress rises by a tenth of the flow stress in the time that sound takes for h. A shock that
   makes metal flow passes in 2 to 4 of these times, so Z is far above 1 there, and also behind it where particles ring by more
   than that tenth. In metal that is cut or forged the density changes far more slowly; but particles that flow fast move against
   each other by as much, so the foot of a Taylor bar gets 3 to 6 % too small: hence an option. Without a flow stress TM_SHOCK_LEAST
   rho c^2 takes its place; what is elastic has no switch, since ringing leaves nothing behind there.

   Own construction; a coefficient for each particle that rises in shocks is that of Morris and Monaghan 1997 (doi
   10.1006/jcph.1997.5690), compression as its only source that of Cullen and Dehnen 2010 (doi 10.1111/j.1365-2966.2010.17158.x). Both
   let it decay behind the shock; where rates are known at every step and ringing compresses again itself, no memory is needed. */
#ifndef TM_SHOCK_H
#define TM_SHOCK_H

#include "tm_tensor.h"

#define TM_SHOCK_RISE 10.0
/* Least flow stress, over rho c^2: that of soft aluminum. */
#define TM_SHOCK_LEAST 5e-4

/* alpha of a particle, from alpha to the larger of alpha and shock; rate = (drho/dt)/rho (1/time), yield_share = Y/(rho c^2) >= 0,
   h > 0, c > 0. */
TM_FN tm_real tm_shock_alpha(tm_real alpha, tm_real shock, tm_real rate, tm_real h, tm_real c, tm_real yield_share)
{
  const tm_real Z = TM_SHOCK_RISE * tm_max(rate, 0.0) * h / (c * tm_max(yield_share, TM_SHOCK_LEAST));
  const tm_real Z2 = Z * Z;
  return tm_max(alpha, shock * (1.0 - 1.0 / (1.0 + Z2 * Z2)));
}

#endif
