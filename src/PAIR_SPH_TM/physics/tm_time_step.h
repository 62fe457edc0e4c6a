/* SPH-TM: the largest stable time steps, without safety factors. The step, the set-up and refined sizes ask here.

   sound        h/c, see tm_sound_time_step, with tm_step_length in place of h
   force        sqrt(h/|a|)
   conduction   rho c_p h^2 over the fastest decay rate of the lattice and the conductivity of the pair
   contact      2/w of a particle on its contact spring */
#ifndef TM_TIME_STEP_H
#define TM_TIME_STEP_H

#include "tm_effects.h"
#include "tm_heat.h"
#include "tm_residual.h"

enum tm_dt_cause {
  TM_DT_SOUND = 0,
  TM_DT_FORCE = 1,
  TM_DT_CONDUCTION = 2,
  TM_DT_CONTACT = 3,
  TM_DT_MOTION = 4,
  TM_DT_MAXIMUM = 5,
  TM_DT_CAUSES = 6
};
#define TM_DT_NO_LIMIT 1e300

/* h/c, less what correction and viscosity take. The shortest waves of a lattice turn by 1.1 (most
   kernels; C4 1.3) in h/c, with corrected gradients at free corners by 2.2 (C4 2.6), and viscosity
   damps them by 2 alpha; a particle whose neighbors lie on one side and close would turn faster, so its correction is
   reduced (tm_correction_of_loose()). Hourglass control adds at most 3.6 xi to the square of the turn (the kernel C4 in two
   dimensions; most below 2.8); tm_state.h bears turns of 0.77 and damping of 0.67 per step. */
TM_FN tm_real tm_sound_time_step(tm_real h, tm_real c, tm_real visc_alpha, tm_real hourglass, unsigned effects)
{
  tm_real turn = (effects & TM_FX_CORRECTION) ? 2.2 : 1.0;
  if (effects & TM_FX_HOURGLASS) turn = sqrt(turn * turn + 3.0 * tm_max(hourglass, 0.0));
  return h / (c * tm_max(turn, 2.0 * visc_alpha));
}

/* h, where it is at most TM_STEP_RATIO spacings: kernels may be wider, waves that run through a body are a few spacings long
   still, and the error of a step is that of their turn. ratio: h over the spacing. */
#define TM_STEP_RATIO 1.7
TM_FN tm_real tm_step_length(tm_real h, tm_real ratio)
{
  return ratio > TM_STEP_RATIO ? h * (TM_STEP_RATIO / ratio) : h;
}

/* acc: magnitude of the acceleration. */
TM_FN tm_real tm_force_time_step(tm_real h, tm_real acc) { return acc > 0.0 ? sqrt(h / acc) : TM_DT_NO_LIMIT; }

/* Of a temperature that decays at the rate (1/time): 3/4 of the limit of the predictor in tm_state.h, TM_DECAY_STABLE/rate. */
#define TM_DECAY_STABLE (2.0 / 3.0)
TM_FN tm_real tm_decay_time_step(tm_real rate) { return rate > 0.0 ? 0.5 / rate : TM_DT_NO_LIMIT; }

/* The same of explicit conduction, whose fastest decay rate is rate k/(rho c_p h^2) (tm_lattice.h). A pair conducts
   with the harmonic mean of its sides, up to twice its own k where the other side has k_max, the largest in the
   scene; k > 0. */
TM_FN tm_real tm_heat_time_step(tm_real rho, tm_real cp, tm_real h, tm_real k, tm_real k_max, tm_real rate)
{
  return 0.5 * rho * cp * h * h / (rate * 2.0 * k * k_max / (k + k_max));
}

/* The same of a material at temperature T. */
TM_FN tm_real tm_conduction_time_step(const tm_material *m, tm_real rho, tm_real T, tm_real h, tm_real k_max,
                                      tm_real rate)
{
  const tm_real k = tm_conductivity(m, T);
  return k > 0.0 ? tm_heat_time_step(rho, tm_capacity(m, T), h, k, k_max, rate) : TM_DT_NO_LIMIT;
}

/* A mass on a contact spring of stiffness k with damping ratio z, central differences with lagging damping
   velocity: 2/w (sqrt(1 + z^2) - z), w = sqrt(k/mass). */
TM_FN tm_real tm_contact_time_step(tm_real k, tm_real mass, tm_real z)
{
  return 2.0 * sqrt(mass / k) * (sqrt(1.0 + z * z) - z);
}

#endif
