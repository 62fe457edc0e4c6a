/* SPH-TM: damage.

     johnson/cook  D += d_eps/eps_f,  failed at D >= 1                    Johnson and Cook 1985
                   eps_f = (D1 + D2 exp(D3 s*)) (1 + D4 ln rate*) (1 + D5 T*)
                   s* = mean stress/mises, positive in tension (so D3 < 0 for metals), clamped to
                   [-3, 1.5]: above 1.5 the fit of the paper ends, below -3 (hydrostatic
                   compression) eps_f stays finite; rate* and T* as in tm_strength.h
     strain        D += d_eps/strain_max, failed at eps_p >= strain_max
   Where a set of constants gives eps_f <= 0 the material fails at once. Failed material carries
   no deviatoric stress and no tension; compression stays. */
#ifndef TM_DAMAGE_H
#define TM_DAMAGE_H

#include "tm_strength.h"

#define TM_TRIAXIALITY_MIN (-3.0)
#define TM_TRIAXIALITY_MAX 1.5
#define TM_FRACTURE_STRAIN_MIN 1e-12

/* Plastic strain at fracture of Johnson and Cook. */
TM_FN tm_real tm_fracture_strain(const tm_material *m, tm_real mean_stress, tm_real mises, tm_real rate, tm_real T)
{
  const tm_real ratio = mises > 0.0 ? mean_stress / mises : 0.0;
  const tm_real t = tm_clamp(ratio, TM_TRIAXIALITY_MIN, TM_TRIAXIALITY_MAX);
  const tm_real by_stress = m->d1 + m->d2 * exp(m->d3 * t);
  const tm_real by_rate = m->d4 == 0.0 ? 1.0 : 1.0 + m->d4 * tm_log_rate(m, rate);
  return by_stress * by_rate * (1.0 + m->d5 * tm_homologous_temperature(m, T));
}

/* Growth of D over a step. mean_stress = tr(sigma)/3, positive in tension. */
TM_FN tm_real tm_damage_increment(const tm_material *m, tm_real mean_stress, tm_real mises, tm_real d_eps, tm_real rate,
                                  tm_real T)
{
  if (m->damage == TM_DAMAGE_NONE || !(d_eps > 0.0)) return 0.0;
  const tm_real limit = m->damage == TM_DAMAGE_STRAIN ? m->strain_max
                                                      : tm_fracture_strain(m, mean_stress, mises, rate, T);
  return d_eps / tm_max(limit, TM_FRACTURE_STRAIN_MIN);
}

TM_FN int tm_damage_failed(const tm_material *m, tm_real D, tm_real eps_p)
{
  if (m->damage == TM_DAMAGE_STRAIN) return eps_p >= m->strain_max;
  return m->damage == TM_DAMAGE_JOHNSON_COOK && D >= 1.0;
}

/* Pressure that a possibly failed material carries; its deviator is 0. */
TM_FN tm_real tm_damage_pressure(tm_real p, int failed) { return failed ? tm_max(p, 0.0) : p; }

#endif
