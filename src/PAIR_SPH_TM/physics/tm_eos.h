/* SPH-TM: equation of state, p(rho, e), positive in compression.

     linear   p = K (rho/rho0 - 1)
     tait     p = K/n ((rho/rho0)^n - 1)                                Murnaghan 1944
     shock    p = pH(eta) (1 - Gamma0 eta/2) + Gamma0 rho0 e            Mie-Grueneisen
              pH = rho0 c0^2 eta/(1 - s eta)^2,  eta = 1 - rho0/rho, from U_s = c0 + s u_p,
              with Gamma rho = Gamma0 rho0; e is the internal energy per mass above the
              reference state
              in tension (eta < 0) p = rho0 c0^2 (rho/rho0 - 1) + Gamma0 rho0 e, which joins
              with the same slope

   The Hugoniot is singular at s eta = 1. Beyond s eta = TM_EOS_SHOCK_LIMIT it goes on as its
   tangent, so pressure stays finite and rises with density; shocks there are outside of the
   range of U_s-u_p fits anyway. Densities of zero and below give finite values: the caller
   finds such particles by their density. */
#ifndef TM_EOS_H
#define TM_EOS_H

#include "tm_material.h"

#define TM_EOS_SHOCK_LIMIT 0.8

/* What one evaluation gives. */
typedef struct {
  tm_real p;
  tm_real dp_drho; /* at constant entropy; linear and tait do not depend on energy */
} tm_eos_point;

/* Hugoniot part pH (1 - Gamma0 eta/2) over rho0 c0^2, and its derivative by eta; eta >= 0. */
TM_FN tm_eos_point tm_eos_hugoniot(tm_real s, tm_real gamma, tm_real eta)
{
  const tm_real limit = s > TM_EOS_SHOCK_LIMIT ? TM_EOS_SHOCK_LIMIT / s : 1.0;
  const tm_real x = tm_min(eta, limit), d = 1.0 / (1.0 - tm_min(s * x, TM_EOS_SHOCK_LIMIT));
  const tm_real f = x * d * d, df = (1.0 + s * x) * d * d * d;
  tm_eos_point q;
  q.dp_drho = df * (1.0 - 0.5 * gamma * x) - 0.5 * gamma * f;
  q.p = f * (1.0 - 0.5 * gamma * x) + (eta - x) * q.dp_drho;
  return q;
}

TM_FN tm_eos_point tm_eos_shock(const tm_material *m, tm_real rho, tm_real e)
{
  const tm_real k = m->rho0 * m->eos_c0 * m->eos_c0, inv = 1.0 / tm_max(rho, 1e-6 * m->rho0);
  const tm_real thermal = m->eos_gamma * m->rho0, x = rho / m->rho0;
  tm_eos_point q;
  if (x > 1.0) {
    q = tm_eos_hugoniot(m->eos_s, m->eos_gamma, 1.0 - m->rho0 * inv);
    q.p = k * q.p + thermal * e;
    q.dp_drho = k * q.dp_drho * m->rho0 * inv * inv; /* d eta/d rho = rho0/rho^2 */
  } else {
    q.p = k * (x - 1.0) + thermal * e;
    q.dp_drho = k / m->rho0;
  }
  q.dp_drho += thermal * tm_max(q.p, 0.0) * inv * inv; /* (dp/de) de, de = p/rho^2 drho */
  return q;
}

TM_FN tm_eos_point tm_eos_tait(const tm_material *m, tm_real rho)
{
  const tm_real x = tm_max(rho / m->rho0, 1e-6), y = pow(x, m->eos_n);
  tm_eos_point q;
  q.p = m->bulk / m->eos_n * (y - 1.0);
  q.dp_drho = m->bulk * y / (x * m->rho0);
  return q;
}

TM_FN tm_eos_point tm_eos_evaluate(const tm_material *m, tm_real rho, tm_real e)
{
  tm_eos_point q;
  if (m->eos == TM_EOS_SHOCK) return tm_eos_shock(m, rho, e);
  if (m->eos == TM_EOS_TAIT) return tm_eos_tait(m, rho);
  q.p = m->bulk * (rho / m->rho0 - 1.0);
  q.dp_drho = m->bulk / m->rho0;
  return q;
}

/* Pressure; e = internal energy per mass, read by shock only. */
TM_FN tm_real tm_eos_pressure(const tm_material *m, tm_real rho, tm_real e) { return tm_eos_evaluate(m, rho, e).p; }

/* Thinner than this part of its reference density is debris alone, which bears neither tension nor shear. */
#define TM_EOS_DEBRIS 0.5

/* Speed of longitudinal waves, sqrt(dp/drho + 4G/(3 rho)); G counts as 0 without strength. The
   bulk part is held above a hundredth of its reference value, and the density in the other
   above that of debris, so that the time step stays finite and clouds of it do not set it. */
TM_FN tm_real tm_eos_sound_speed(const tm_material *m, tm_real rho, tm_real e)
{
  const tm_real shear = m->strength == TM_STRENGTH_NONE ? 0.0 : m->shear;
  const tm_real bulk = tm_max(tm_eos_evaluate(m, rho, e).dp_drho, 1e-2 * m->bulk / m->rho0);
  return sqrt(bulk + 4.0 / 3.0 * shear / tm_max(rho, TM_EOS_DEBRIS * m->rho0));
}

#endif
