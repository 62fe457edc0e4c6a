/* SPH-TM: the pressure q of tm_shock.h of one particle at the force point, as prediction and update know it alike. */
#ifndef TM_SHOCKED_H
#define TM_SHOCKED_H

#include "tm_shock.h"
#include "tm_state.h"

/* No part of the loops that call it: what is contracted to fused products there, and so the last digits of every scene, does not depend
   on it. */
#if defined(__GNUC__) && !defined(__CUDACC__)
#define TM_FN_APART static __attribute__((noinline, unused))
#else
#define TM_FN_APART TM_FN
#endif

TM_FN tm_real tm_shock_yield(int i, const tm_state *s, unsigned effects)
{
  return (effects & TM_FX_PLASTICITY) ? tm_field_row(s, TM_F_PSTRAIN, i)[tm_column(2)] : 0.0;
}

/* Whether particle i has one. rho_rate: drho/dt of the last step; rho, c: density and speed of sound of the record, h: its smoothing
   length. With one pass, and not in plane stress, where a front is far thicker than the sheet; read before the update writes the
   flow stress. Most particles have none, and end here. */
TM_FN_APART int tm_shock_reaches(int i, const tm_state *s, tm_real shock, tm_real rho_rate, tm_real rho, tm_real c,
                                 tm_real h, unsigned effects)
{
  if (!(shock > 0.0 && c > 0.0 && tm_shock_acts(rho_rate, h, c, rho, 0.0))) return 0;
  if (!(effects & TM_FX_ONE_PASS) || (effects & TM_FX_PLANE_STRESS)) return 0;
  return s->material[s->type[i]].strength != TM_STRENGTH_ELASTIC &&
         tm_shock_acts(rho_rate, h, c, rho, tm_shock_yield(i, s, effects));
}

/* The pressure of such a particle; K: its correction. */
TM_FN_APART tm_real tm_shocked(int i, const tm_state *s, tm_real shock, tm_real rho_rate, tm_real rho, tm_real c,
                               tm_real h, tm_real dt, tm_sym3 K, unsigned effects)
{
  if (!(dt > 0.0)) return 0.0;
  return tm_shock_inside(K, (effects & TM_FX_3D) != 0) *
         tm_shock_pressure(shock, rho_rate / rho, h, c, rho, tm_shock_yield(i, s, effects), dt);
}

#endif
