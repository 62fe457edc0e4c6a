/* SPH-TM: heat conduction and heat flux through surfaces.

   Conduction, F15 (6) after Jubelgas 2007: particle i receives, as power per volume,
     k laplace T = sum_j m_j/rho_j 4 k_i k_j/(k_i + k_j) (T_i - T_j) (x_ij . gradW)/r^2
   with (x_ij . gradW)/r^2 = W'/r < 0, so the hotter particle cools. The factor is twice the
   harmonic mean: two half distances in series. It is symmetric in i and j, so what leaves one
   particle arrives at the other. An interface of conductance hc is a third resistance in the
   series.
   Convection hc (Tinf - T) and radiation sigma emissivity (Tinf^4 - T^4) are heat fluxes into the
   body, power per area. Temperatures are absolute. */
#ifndef TM_HEAT_H
#define TM_HEAT_H

#include "tm_kernel.h"
#include "tm_material.h"

#define TM_HEAT_TINY TM_PAIR(TM_SINGLE ? 1e-36 : 1e-300) /* keeps 0/0 at 0 where neither side conducts */

/* Value of a table at T: linear between its points, constant outside. */
TM_FN tm_real tm_table_at(const tm_table *a, tm_real T)
{
  if (a->n == 0) return a->value;
  if (!(T > a->t[0])) return a->y[0];
  for (int i = 1; i < a->n; i++)
    if (T < a->t[i]) return a->y[i - 1] + (a->y[i] - a->y[i - 1]) * (T - a->t[i - 1]) / (a->t[i] - a->t[i - 1]);
  return a->y[a->n - 1];
}

/* k(T), power/(length temperature) */
TM_FN tm_real tm_conductivity(const tm_material *m, tm_real T) { return tm_table_at(&m->conductivity, T); }

/* Integral of a table over T from a to b: exact, piece by piece. */
TM_FN tm_real tm_table_integral(const tm_table *table, tm_real a, tm_real b)
{
  if (table->n == 0) return table->value * (b - a);
  const tm_real lo = tm_min(a, b), hi = tm_max(a, b);
  tm_real sum = 0.0, from = lo;
  for (int i = 0; i <= table->n && from < hi; i++) {
    const tm_real to = i < table->n ? tm_min(hi, table->t[i]) : hi;
    if (to <= from) continue;
    sum += 0.5 * (tm_table_at(table, from) + tm_table_at(table, to)) * (to - from);
    from = to;
  }
  return b < a ? -sum : sum;
}

/* What heat per mass and temperature is at the volume of the particle, energy/(mass temperature): the given c_p(T), or
   the c_v that follows from it where compression heats, c_p - (3 alpha)^2 K T/rho0 (linear, tait; at least c_p/2) or
   c_p times a constant (shock), see tm_thermoelastic.h. */
TM_FN tm_real tm_capacity(const tm_material *m, tm_real T)
{
  const tm_real cp = tm_table_at(&m->capacity, T);
  if (!(m->expansion_work > 0.0)) return cp * (1.0 - m->capacity_less);
  const tm_real alpha = tm_table_at(&m->expansion, T);
  return tm_max(0.5 * cp, cp - m->expansion_work * alpha * alpha * T);
}

/* sqrt(k rho c_p), power time^(1/2)/(area temperature). Two half-spaces that are brought together share the heat of
   friction by it, and meet at the mean of their temperatures weighted by it. */
TM_FN tm_real tm_effusivity(tm_real k, tm_real rho, tm_real cp) { return sqrt(k * rho * cp); }

/* [hot] One pair of F15 (6): power per volume into particle i. The volume of j is mass/rho; with those of both, multiplied, it is
   the power, with the same bits for either particle. */
TM_FN tm_pair tm_conduction_pair(tm_pair ki, tm_pair kj, tm_pair Ti, tm_pair Tj, tm_pair mass, tm_pair rho,
                                 tm_pair dwdr_over_r)
{
  return 4 * ki * kj * mass * tm_pair_inverse((ki + kj) * rho + TM_HEAT_TINY) * (Ti - Tj) * dwdr_over_r;
}

/* [hot] The same through an interface of conductance hc_pair between i and j, distance r:
   resistance r/(2 ki) + r/(2 kj) + 1/hc_pair. hc_pair = 0 insulates. For an interface whose
   conductance per area is hc, hc_pair = tm_interface_conductance(hc, dim). */
TM_FN tm_real tm_conduction_pair_interface(tm_real ki, tm_real kj, tm_real Ti, tm_real Tj, tm_real vol_j,
                                           tm_real dwdr_over_r, tm_real r, tm_real hc_pair)
{
  const tm_real kk = 2.0 * ki * kj, b = hc_pair * r;
  const tm_real k = kk * b / ((ki + kj) * b + kk + TM_HEAT_TINY);
  return 2.0 * k * (Ti - Tj) * (vol_j * dwdr_over_r);
}

/* Conductance to give to each pair so that a plane interface conducts hc per area.
   Pairs cross it at an angle theta, with r instead of the normal distance r cos(theta). In the
   continuum the flux of a linear profile with a jump is q = 2 int s_n |W'|/r k_pair (dT) dV over
   s_n > 0, and is right for every hc and k when hc_pair/hc = <cos^2>/<cos> over the half sphere:
   2/3 in 3D, pi/4 in 2D, 1 in 1D. On a lattice with h = 1.2 spacings a resistive interface then
   conducts 0.87 (3D), 0.91 (2D) of hc, with 1.9 spacings 0.95, 0.97. */
TM_FN tm_real tm_interface_conductance(tm_real hc, int dim)
{
  return hc * (dim == 3 ? 2.0 / 3.0 : dim == 2 ? 0.25 * TM_PI : 1.0);
}

/* Heat flux into the body by convection, power per area; h_c in power/(area temperature). */
TM_FN tm_real tm_convection(tm_real h_c, tm_real T, tm_real T_inf) { return h_c * (T_inf - T); }

/* Heat flux into the body by radiation, power per area; sigma_sb is the Stefan-Boltzmann constant
   in the units of the run. */
TM_FN tm_real tm_radiation(tm_real sigma_sb, tm_real emissivity, tm_real T, tm_real T_inf)
{
  const tm_real a = T * T, b = T_inf * T_inf;
  return sigma_sb * emissivity * (b - a) * (b + a);
}

/* Rise of temperature by a heat per mass: heat = integral of the capacity from T. Where it varies it is taken
   in the middle of the rise, found by iteration: exact within a segment of the table, so that what
   is given to a particle can be found in it. */
TM_FN tm_real tm_heat_rise(const tm_material *m, tm_real T, tm_real heat)
{
  tm_real rise = heat / tm_capacity(m, T);
  if (m->capacity.n || m->expansion_work > 0.0)
    for (int it = 0; it < 3; it++) rise = heat / tm_capacity(m, T + 0.5 * rise);
  return rise;
}

#endif
