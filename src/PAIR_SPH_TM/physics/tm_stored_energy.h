/* SPH-TM: elastic energy per mass, a function of the state: what the deviator s and the density store,

     psi = s : s/(4 G rho) + integral of p(rho, e = 0)/rho^2 drho from rho0 to g rho

   with the growth g of the volume by heat, which makes no stress (tm_thermoelastic.h).
   The rate of the stress, tm_deviator_rate(), integrates to the first term. What a shock
   equation of state adds to the pressure with the internal energy, Gamma0 rho0 e, is no function of the density; its
   work is summed in tm_update.h. */
#ifndef TM_STORED_ENERGY_H
#define TM_STORED_ENERGY_H

#include "tm_eos.h"
#include "tm_tensor.h"

/* Integral of p/rho^2 drho: of p deta/rho0, eta = 1 - rho0/rho, by Gauss and Legendre's rule with eight points. Exact to
   round-off for small strains, where closed forms lose digits; to 1e-7 at half and twice the density. */
TM_FN tm_real tm_pressure_energy(const tm_material *m, tm_real rho)
{
  const tm_real eta = 1.0 - m->rho0 / tm_max(rho, 1e-6 * m->rho0);
  tm_real sum = 0.0;
  for (int k = 0; k < 4; k++) {
    const tm_real at = k == 0   ? 0.1834346424956498
                       : k == 1 ? 0.5255324099163290
                       : k == 2 ? 0.7966664774136267
                                : 0.9602898564975363;
    const tm_real weight = k == 0   ? 0.3626837833783620
                           : k == 1 ? 0.3137066458778873
                           : k == 2 ? 0.2223810344533745
                                    : 0.1012285362903763;
    sum += weight * (tm_eos_pressure(m, m->rho0 / (1.0 - 0.5 * eta * (1.0 - at)), 0.0) +
                     tm_eos_pressure(m, m->rho0 / (1.0 - 0.5 * eta * (1.0 + at)), 0.0));
  }
  return 0.5 * eta * sum / m->rho0;
}

/* psi; failed material bears compression alone. */
TM_FN tm_real tm_stored_energy(const tm_material *m, tm_real rho, tm_real growth, tm_sym3 s, int failed)
{
  const tm_real shape =
      failed || m->strength == TM_STRENGTH_NONE || !(m->shear > 0.0) ? 0.0 : tm_sym_ddot(s, s) / (4.0 * m->shear * rho);
  return shape + (failed && growth * rho < m->rho0 ? 0.0 : tm_pressure_energy(m, growth * rho));
}

#endif
