/* SPH-TM: flow stress, objective stress rate and radial return.

     plastic        Y = yield + H eps_p,  H = E Et/(E - Et)            F14 (12), misprint corrected
     johnson/cook   Y = (A + B eps_p^n) (1 + C ln rate*) (1 - T*^m)    Johnson and Cook 1983
                    rate* = rate/rate0 clamped below at 1: slower than the reference rate the
                    material is not softer (and ln never diverges); C = 0 takes no logarithm
                    T* = (T - Tref)/(Tmelt - Tref) clamped to [0, 1]: no softening below Tref, no
                    strength at and above Tmelt
   Y is never negative. Jaumann rate F14 (9), radial return F14 (11)-(14), solved here for the
   hardening, rate and temperature of the end of the step. */
#ifndef TM_STRENGTH_H
#define TM_STRENGTH_H

#include "tm_material.h"
#include "tm_tensor.h"

#define TM_STRENGTH_INFINITE 1e300  /* flow stress of elastic material, any unit */

/* --- factors of Johnson and Cook, shared with damage -------------------------------------- */

/* T*; 0 when the melting temperature is not above the reference temperature (not given). */
TM_FN tm_real tm_homologous_temperature(const tm_material *m, tm_real T)
{
  const tm_real range = m->t_melt - m->t_ref;
  return range > 0.0 ? tm_clamp((T - m->t_ref) / range, 0.0, 1.0) : 0.0;
}

/* ln rate*; 0 when no reference rate was given. */
TM_FN tm_real tm_log_rate(const tm_material *m, tm_real rate)
{
  return m->jc_rate0 > 0.0 && rate > m->jc_rate0 ? log(rate / m->jc_rate0) : 0.0;
}

/* 1 - T*^m */
TM_FN tm_real tm_thermal_softening(const tm_material *m, tm_real T)
{
  const tm_real t = tm_homologous_temperature(m, T);
  if (t <= 0.0) return 1.0;
  if (m->jc_m == 1.0) return 1.0 - t;
  return t >= 1.0 ? 0.0 : 1.0 - pow(t, m->jc_m);
}

/* eps^n for eps >= 0 */
TM_FN tm_real tm_hardening_power(tm_real eps, tm_real n)
{
  if (n == 1.0) return eps;
  return eps > 0.0 ? pow(eps, n) : (n == 0.0 ? 1.0 : 0.0);
}

/* The flow stress of Johnson and Cook is hardening times rate factor times tm_thermal_softening.
   A + B eps^n, eps >= 0; the power eps^n is what its slope needs. The constants are read before the power is
   taken: the order that the compiler sees decides where it contracts to fused multiply-adds. */
TM_FN tm_real tm_johnson_cook_hardening(const tm_material *m, tm_real eps, tm_real *power)
{
  const tm_real a = m->jc_a, b = m->jc_b;
  *power = tm_hardening_power(eps, m->jc_n);
  return a + b * *power;
}
/* 1 + C ln rate* */
TM_FN tm_real tm_johnson_cook_rate(const tm_material *m, tm_real log_rate) { return 1.0 + m->jc_c * log_rate; }

/* Flow stress at plastic strain eps_p, plastic strain rate and temperature. */
TM_FN tm_real tm_flow_stress(const tm_material *m, tm_real eps_p, tm_real rate, tm_real T)
{
  const tm_real eps = tm_max(eps_p, 0.0);
  if (m->strength == TM_STRENGTH_ELASTIC) return TM_STRENGTH_INFINITE;
  if (m->strength == TM_STRENGTH_NONE) return 0.0;
  if (m->strength == TM_STRENGTH_PLASTIC) return tm_max(m->yield + m->hardening * eps, 0.0);
  tm_real power;
  const tm_real y = tm_johnson_cook_hardening(m, eps, &power);
  const tm_real r = m->jc_c == 0.0 ? 1.0 : tm_johnson_cook_rate(m, tm_log_rate(m, rate));
  return tm_max(y * r * tm_thermal_softening(m, T), 0.0);
}

/* --- objective rate ----------------------------------------------------------------------- */

/* Jaumann rate of a deviator: 2G dev(D) + W S - S W,  W = (L - L^T)/2. */
TM_FN tm_sym3 tm_jaumann_rate(tm_sym3 s, tm_mat3 L, tm_real G)
{
  const tm_real wxy = 0.5 * (L.xy - L.yx), wxz = 0.5 * (L.xz - L.zx), wyz = 0.5 * (L.yz - L.zy);
  tm_sym3 r = tm_sym_scale(2.0 * G, tm_sym_deviator(tm_mat_symmetric(L)));
  r.xx += 2.0 * (wxy * s.xy + wxz * s.xz);
  r.yy += 2.0 * (wyz * s.yz - wxy * s.xy);
  r.zz -= 2.0 * (wxz * s.xz + wyz * s.yz);
  r.xy += wxy * (s.yy - s.xx) + wxz * s.yz + wyz * s.xz;
  r.xz += wxz * (s.zz - s.xx) + wxy * s.yz - wyz * s.xy;
  r.yz += wyz * (s.zz - s.yy) - wxy * s.xz - wxz * s.xy;
  return r;
}

/* --- radial return ------------------------------------------------------------------------ */

typedef struct {
  tm_sym3 s;       /* deviator on or inside the yield surface */
  tm_real d_eps;   /* increment of equivalent plastic strain, >= 0 */
  tm_real yield;   /* flow stress at the end of the step; 0 for elastic material */
  int iterations;  /* evaluations of the flow stress beyond the first */
} tm_return_result;

#define TM_RETURN_TOLERANCE 1e-11  /* of the flow stress */
#define TM_RETURN_ITERATIONS 100

/* Johnson-Cook increment: root of f(d) = trial - 3G d - Y(eps + d, d/dt, T), which falls from
   f(0) > 0 to f(trial/3G) <= 0. soft = 1 - T*^m, first = Y(eps, 0, T) > 0.
   Starts from the smaller of two upper bounds, no rate dependence and no elasticity, and goes on
   with Halley's method (Y'' is free once Y' is there). A step that leaves the bracket is replaced
   by bisection, by hi/100 while nothing is known from below: with eps = 0 and a small n the root
   can be any power of ten. One pow and one log per turn; 4 turns in a step of metal cutting. */
TM_FN tm_real tm_return_johnson_cook(const tm_material *m, tm_real trial, tm_real eps, tm_real soft,
                                     tm_real first, tm_real dt, int *iterations)
{
  const tm_real g3 = 3.0 * m->shear, C = m->jc_c, n = m->jc_n;
  const int rated = C > 0.0 && dt > 0.0 && m->jc_rate0 > 0.0;
  const tm_real d0 = rated ? dt * m->jc_rate0 : 0.0;  /* increment at the reference rate */
  tm_real lo = 0.0, hi = trial / g3, d = tm_min((trial - first) / g3, hi);
  if (rated) d = tm_min(d, d0 * exp(tm_min((trial / first - 1.0) / C, 500.0)));
  for (int it = 1; it <= TM_RETURN_ITERATIONS; it++) {
    tm_real power;
    const tm_real e = eps + d, hard = soft * tm_johnson_cook_hardening(m, e, &power);
    const int fast = rated && d > d0;
    const tm_real rate = fast ? tm_johnson_cook_rate(m, log(d / d0)) : 1.0, rate1 = fast ? C / d : 0.0;
    const tm_real y = hard * rate, f = trial - g3 * d - y;
    *iterations = it;
    if (fabs(f) <= TM_RETURN_TOLERANCE * y + 4e-16 * trial) break;
    if (f > 0.0) lo = d;
    else hi = d;
    const tm_real hard1 = soft * m->jc_b * n * power / e, hard2 = hard1 * (n - 1.0) / e;
    const tm_real f1 = -(g3 + hard1 * rate + hard * rate1);
    const tm_real f2 = -(hard2 * rate + 2.0 * hard1 * rate1 - hard * rate1 / d);
    const tm_real next = d - 2.0 * f * f1 / (2.0 * f1 * f1 - f * f2);
    d = next > lo && next < hi ? next : (lo > 0.0 ? 0.5 * (lo + hi) : 0.01 * hi);
    if (!(d > lo && d < hi)) break;  /* the bracket is as narrow as the arithmetic allows */
  }
  return d;
}

/* Deviator s_trial brought back to the yield surface of the end of the step of length dt. */
TM_FN tm_return_result tm_radial_return(const tm_material *m, tm_sym3 s_trial, tm_real eps_p,
                                        tm_real T, tm_real dt)
{
  tm_return_result out;
  out.s = s_trial;
  out.d_eps = 0.0;
  out.yield = 0.0;
  out.iterations = 0;
  if (m->strength == TM_STRENGTH_ELASTIC) return out;

  const tm_real trial = tm_sym_mises(s_trial), g3 = 3.0 * m->shear, eps = tm_max(eps_p, 0.0);
  const int jc = m->strength == TM_STRENGTH_JOHNSON_COOK;
  const tm_real soft = jc ? tm_thermal_softening(m, T) : 1.0;
  tm_real power, first = 0.0;  /* flow stress before the step, at no rate */
  if (jc) first = tm_max(soft * tm_johnson_cook_hardening(m, eps, &power), 0.0);
  else first = tm_flow_stress(m, eps, 0.0, T);
  out.yield = first;
  if (!(trial > first)) return out;

  if (jc && first > 0.0)
    out.d_eps = tm_return_johnson_cook(m, trial, eps, soft, first, dt, &out.iterations);
  else if (m->strength == TM_STRENGTH_PLASTIC)
    out.d_eps = tm_min((trial - first) / (g3 + m->hardening), trial / g3);
  else
    out.d_eps = g3 > 0.0 ? (trial - first) / g3 : 0.0;
  out.yield = tm_max(trial - g3 * out.d_eps, 0.0);
  if (g3 <= 0.0) out.yield = first;
  out.s = tm_sym_scale(out.yield / trial, s_trial);
  return out;
}

#endif
