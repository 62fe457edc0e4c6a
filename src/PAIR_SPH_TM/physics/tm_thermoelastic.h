/* SPH-TM: thermal expansion, and the heat of compression.

   Thermal expansion, linear and tait: eps_T = integral of alpha dT from the temperature T_u at which the particle has no
   thermal strain. A volume that is free grows by (1 + eps_T)^3, so the pressure is that of the density
     rho (1 + eps_T)^3
   which the same mass would have at T_u. With a shock equation of state the internal energy e does it, p = pH + Gamma0
   rho0 e: all heat goes into e, and 3 alpha = Gamma0 c_p/c0^2.

   Compression heat: dT = -Gamma T tr(D) dt + dissipation/(rho c_v)             Malvern 1969, 7.4; Meyers 1994, 5.5
     shock          Gamma rho = Gamma0 rho0
     linear, tait   Gamma rho = 3 alpha K/c_v
   With Gamma rho constant an isentrope is T2 = T1 exp(Gamma rho (1/rho1 - 1/rho2)).

   Both together are what makes c_p of c_v: c_p/c_v = 1 + 3 alpha Gamma T. c_p is what is given and c_v what heats the
   particle (tm_capacity). A free body then takes up c_p(T); with a shock equation of state, where temperatures rise under
   pressure, the ratio is that at the temperature of the start, and c_v is constant where c_p is. */
#ifndef TM_THERMOELASTIC_H
#define TM_THERMOELASTIC_H

#include "tm_heat.h"

/* Thermal strain of a free length at T that has none at T_u; 0 for a shock equation of state. */
TM_FN tm_real tm_thermal_strain(const tm_material *m, tm_real T_u, tm_real T)
{
  return m->eos == TM_EOS_SHOCK ? 0.0 : tm_table_integral(&m->expansion, T_u, T);
}

/* The same of a volume, over that at T_u. */
TM_FN tm_real tm_thermal_growth(const tm_material *m, tm_real T_u, tm_real T)
{
  const tm_real a = 1.0 + tm_thermal_strain(m, T_u, T);
  return a * a * a;
}

/* Gamma rho c_v, the growth of pressure with temperature at constant volume, pressure/temperature, over c_v: Gamma rho. */
TM_FN tm_real tm_gruneisen_density(const tm_material *m, tm_real T)
{
  if (m->eos == TM_EOS_SHOCK) return m->eos_gamma * m->rho0;
  return 3.0 * tm_table_at(&m->expansion, T) * m->bulk / tm_capacity(m, T);
}

/* Ratio of the temperatures after and before an isentropic change of density. */
TM_FN tm_real tm_compression_heat(tm_real gruneisen_density, tm_real rho_before, tm_real rho_after)
{
  return exp(gruneisen_density * (1.0 / rho_before - 1.0 / rho_after));
}

/* [setup] What tm_capacity needs where compression heats; T: temperature of the start.
     shock          c_p - c_v = Gamma0 (Gamma0 c_p/c0^2) c_v T
     linear, tait   c_p - c_v = (3 alpha)^2 K T/rho0 */
TM_FN void tm_set_compression_heat(tm_material *m, int heats, tm_real T)
{
  m->capacity_less = m->expansion_work = 0.0;
  if (!heats || m->body != TM_BODY_SOLID || !m->heat) return;
  if (m->eos == TM_EOS_SHOCK) {
    const tm_real x = m->eos_gamma * m->eos_gamma * tm_table_at(&m->capacity, T) * T / (m->eos_c0 * m->eos_c0);
    m->capacity_less = x / (1.0 + x);
  } else if (m->expansion.n || m->expansion.value > 0.0) {
    m->expansion_work = 9.0 * m->bulk / m->rho0;
  }
}

#endif
