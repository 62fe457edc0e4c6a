/* SPH-TM: flow stress, objective stress rate and radial return.

     plastic        Y = yield + H eps_p,  H = E Et/(E - Et)            F14 (12), misprint corrected
     johnson/cook   Y = (A + B eps_p^n) (1 + C ln rate*) (1 - T*^m)    Johnson and Cook 1983
                    rate* = rate/rate0 clamped below at 1: slower than the reference rate the
                    material is not softer (and ln never diverges); C = 0 takes no logarithm
                    T* = (T - Tref)/(Tmelt - Tref) clamped to [0, 1]: no softening below Tref, no
                    strength at and above Tmelt
     johnson/cook/tanh   with strain softening, tm_flow_tanh             Calamaz et al. 2008, Sima and Ozel 2010
     zerilli/armstrong   tm_flow_zerilli_armstrong                       Zerilli and Armstrong 1987
   Y is never negative. Jaumann rate F14 (9), radial return F14 (11)-(14), solved here for the
   hardening, rate and temperature of the end of the step. */
#ifndef TM_STRENGTH_H
#define TM_STRENGTH_H

#include "tm_material.h"
#include "tm_tensor.h"

#define TM_STRENGTH_INFINITE 1e300 /* flow stress of elastic material, any unit */

/* --- factors of Johnson and Cook, shared with damage -------------------------------------- */

/* x^y for x > 0. A GPU's pow carries digits that nothing here needs, at twice the time: so the error is 1e-16 |y ln x|. */
TM_FN tm_real tm_power(tm_real x, tm_real y)
{
#if defined(__CUDA_ARCH__)
  return exp(y * log(x));
#else
  return pow(x, y);
#endif
}

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
  return t >= 1.0 ? 0.0 : 1.0 - tm_power(t, m->jc_m);
}

/* eps^n for eps >= 0 */
TM_FN tm_real tm_hardening_power(tm_real eps, tm_real n)
{
  if (n == 1.0) return eps;
  return eps > 0.0 ? tm_power(eps, n) : (n == 0.0 ? 1.0 : 0.0);
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

/* Johnson-Cook TANH, with strain softening above a critical strain that falls with temperature:
     Y = (A + B eps^n exp(-eps^a)) (1 + C ln rate*) (1 - T*^m) (D + (1 - D) tanh((eps + S)^-r)^s)
     D = 1 - (T/Tmelt)^d,  S = (T/Tmelt)^b
   s = 1: Calamaz, Coupard, Girot 2008; any s: Sima and Ozel 2010. D and S take the ratio of absolute temperatures,
   between 0 and 1; T* and rate* are those of Johnson and Cook. a = 0 leaves out exp, s = 0 leaves out tanh; without
   both it is Johnson-Cook. */
TM_CALLED_FN tm_real tm_flow_tanh(const tm_material *m, tm_real eps, tm_real rate, tm_real T)
{
  const tm_real hot = tm_clamp(T / m->t_melt, 0.0, 1.0), D = 1.0 - pow(hot, m->tanh_d);
  const tm_real decay = m->tanh_a > 0.0 ? exp(-pow(eps, m->tanh_a)) : 1.0;
  const tm_real hard = m->jc_a + m->jc_b * tm_hardening_power(eps, m->jc_n) * decay;
  const tm_real fast = m->jc_c == 0.0 ? 1.0 : tm_johnson_cook_rate(m, tm_log_rate(m, rate));
  const tm_real bend = tanh(pow(eps + pow(hot, m->tanh_b), -m->tanh_r));
  return hard * fast * tm_thermal_softening(m, T) * (D + (1.0 - D) * pow(bend, m->tanh_s));
}

/* Zerilli-Armstrong, both forms in one:
     Y = C0 + (C1 + C2 sqrt(eps)) exp(-C3 T + C4 T ln(rate/rate0)) + C5 eps^n
   C2 = 0: body-centered cubic; C1 = C5 = 0: face-centered cubic. T is absolute, rate0 the unit of rate of the fit,
   1/s in the paper. The paper's exponential vanishes at no rate; rates below TM_ZA_SLOWEST rate0, slower than any
   test, count as that. It knows no melting; at and above Tmelt there is no strength here, as with the other laws. */
#define TM_ZA_SLOWEST 1e-4
TM_CALLED_FN tm_real tm_flow_zerilli_armstrong(const tm_material *m, tm_real eps, tm_real rate, tm_real T)
{
  if (T >= m->t_melt) return 0.0;
  const tm_real ln_rate = log(tm_max(rate / m->za_rate0, TM_ZA_SLOWEST));
  const tm_real thermal = exp(T * (m->za_c4 * ln_rate - m->za_c3));
  return m->za_c0 + (m->za_c1 + m->za_c2 * sqrt(eps)) * thermal + m->za_c5 * tm_hardening_power(eps, m->za_n);
}

/* Flow stress at plastic strain eps_p, plastic strain rate and temperature. */
TM_FN tm_real tm_flow_stress(const tm_material *m, tm_real eps_p, tm_real rate, tm_real T)
{
  const tm_real eps = tm_max(eps_p, 0.0);
  if (m->strength == TM_STRENGTH_ELASTIC) return TM_STRENGTH_INFINITE;
  if (m->strength == TM_STRENGTH_NONE) return 0.0;
  if (m->strength == TM_STRENGTH_PLASTIC) return tm_max(m->yield + m->hardening * eps, 0.0);
  if (m->strength == TM_STRENGTH_JOHNSON_COOK_TANH) return tm_max(tm_flow_tanh(m, eps, rate, T), 0.0);
  if (m->strength == TM_STRENGTH_ZERILLI_ARMSTRONG) return tm_max(tm_flow_zerilli_armstrong(m, eps, rate, T), 0.0);
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

/* Rate of a deviator whose material turns and changes its volume: Jaumann's, F14 (9), less s tr(D)/2. With it s : D/rho is
   the rate of s : s/(4 G rho), so that a closed path of shear and compression gives back what it took. Jaumann's alone leaves
   s : s/(4 G rho) tr(D), which is small where the volume hardly changes, as in metals. */
TM_FN tm_sym3 tm_deviator_rate(tm_sym3 s, tm_mat3 L, tm_real G)
{
  return tm_sym_axpy(tm_jaumann_rate(s, L, G), -0.5 * tm_mat_trace(L), s);
}

/* --- radial return ------------------------------------------------------------------------ */

typedef struct {
  tm_sym3 s;      /* deviator on or inside the yield surface */
  tm_real d_eps;  /* increment of equivalent plastic strain, >= 0 */
  tm_real yield;  /* flow stress at the end of the step; 0 for elastic material */
  int iterations; /* evaluations of the flow stress beyond the first */
} tm_return_result;

#define TM_RETURN_TOLERANCE 1e-11 /* of the flow stress */
#define TM_RETURN_ITERATIONS 100

/* Johnson-Cook increment: root of f(d) = trial - 3G d - Y(eps + d, d/dt, T), which falls from
   f(0) > 0 to f(trial/3G) <= 0. soft = 1 - T*^m, first = Y(eps, 0, T) > 0.
   Starts from the smaller of two upper bounds, no rate dependence and no elasticity, and goes on
   with Halley's method (Y'' is free once Y' is there). A step that leaves the bracket is replaced
   by bisection, by hi/100 while nothing is known from below: with eps = 0 and a small n the root
   can be any power of ten. A relative step below TM_RETURN_STEP is the last: the error of Halley's method goes with the cube
   of it. 3 turns in a step of metal cutting; the power and the logarithm of one that is close to a known one come from
   that. */
#define TM_RETURN_STEP 1e-5
#define TM_CLOSE 1e-3 /* relative difference, up to which these series end within rounding */
/* (1 + z)^n - 1 and ln(1 + z), |z| <= TM_CLOSE */
TM_FN tm_real tm_power_step(tm_real z, tm_real n)
{
  return n * z *
         (1.0 + (n - 1.0) / 2.0 * z *
                    (1.0 + (n - 2.0) / 3.0 * z * (1.0 + (n - 3.0) / 4.0 * z * (1.0 + (n - 4.0) / 5.0 * z))));
}
TM_FN tm_real tm_log_step(tm_real z) { return z * (1.0 - z * (0.5 - z * (1.0 / 3.0 - z * (0.25 - z * 0.2)))); }

/* power0: eps^n */
TM_FN tm_real tm_return_johnson_cook(const tm_material *m, tm_real trial, tm_real eps, tm_real power0, tm_real soft,
                                     tm_real first, tm_real dt, int *iterations)
{
  const tm_real g3 = 3.0 * m->shear, C = m->jc_c, n = m->jc_n;
  const int rated = C > 0.0 && dt > 0.0 && m->jc_rate0 > 0.0;
  const tm_real d0 = rated ? dt * m->jc_rate0 : 0.0; /* increment at the reference rate */
  tm_real lo = 0.0, hi = trial / g3, d = tm_min((trial - first) / g3, hi);
  tm_real known = 0.0, log_known = 0.0; /* an increment, and ln of it over d0 */
  if (rated) {
    log_known = tm_min((trial / first - 1.0) / C, 500.0);
    known = d0 * exp(log_known);
    d = tm_min(d, known);
  }
  for (int it = 1; it <= TM_RETURN_ITERATIONS; it++) {
    tm_real power = power0;
    const tm_real e = eps + d;
    if (d <= TM_CLOSE * eps) power += power0 * tm_power_step(d / eps, n);
    else power = tm_hardening_power(e, n);
    const tm_real hard = soft * (m->jc_a + m->jc_b * power);
    const int fast = rated && d > d0;
    if (fast && d != known) {
      log_known = fabs(d - known) <= TM_CLOSE * known ? log_known + tm_log_step((d - known) / known) : log(d / d0);
      known = d;
    }
    const tm_real rate = fast ? tm_johnson_cook_rate(m, log_known) : 1.0, rate1 = fast ? C / d : 0.0;
    const tm_real y = hard * rate, f = trial - g3 * d - y;
    *iterations = it;
    if (fabs(f) <= TM_RETURN_TOLERANCE * y + 4e-16 * trial) break;
    if (f > 0.0) lo = d;
    else hi = d;
    const tm_real hard1 = soft * m->jc_b * n * power / e, hard2 = hard1 * (n - 1.0) / e;
    const tm_real f1 = -(g3 + hard1 * rate + hard * rate1);
    const tm_real f2 = -(hard2 * rate + 2.0 * hard1 * rate1 - hard * rate1 / d);
    const tm_real next = d - 2.0 * f * f1 / (2.0 * f1 * f1 - f * f2);
    const int last = fabs(next - d) <= TM_RETURN_STEP * d && next > lo && next < hi;
    d = next > lo && next < hi ? next : (lo > 0.0 ? 0.5 * (lo + hi) : 0.01 * hi);
    if (last) break;
    if (!(d > lo && d < hi)) break; /* the bracket is as narrow as the arithmetic allows */
  }
  return d;
}

typedef struct {
  tm_real d_eps;
  int iterations;
} tm_return_root;

/* The increment for any law that gives its flow stress alone: root of f(d) = trial - 3G d - Y(eps + d, d/dt, T),
   f(0) > 0 >= f(trial/3G). Secants through the last two points, in ln d where these are far apart, since the rate acts
   by its logarithm; the first step takes the flow stress as constant. A step that leaves the bracket is replaced by the
   bracket's middle in ln d, by hi/100 while nothing is known from below, and from turn 12 on every other one is.
   A law that hardens, or softens by less than 3G per plastic strain, has one root. With more the stress jumps; then
   the search starts below the first root, at (trial - first)/3G, and takes one that its steps bracket. */
TM_CALLED_FN tm_return_root tm_return_search(const tm_material *m, tm_real trial, tm_real eps, tm_real T, tm_real first,
                                             tm_real dt)
{
  tm_return_root out;
  const tm_real g3 = 3.0 * m->shear, inv_dt = dt > 0.0 ? 1.0 / dt : 0.0;
  tm_real lo = 0.0, hi = trial / g3, d = tm_min((trial - first) / g3, hi), old = 0.0, f_old = 0.0;
  for (int it = 1; it <= TM_RETURN_ITERATIONS; it++) {
    const tm_real y = tm_flow_stress(m, eps + d, d * inv_dt, T), f = trial - g3 * d - y;
    out.iterations = it;
    if (fabs(f) <= TM_RETURN_TOLERANCE * y + 4e-16 * trial) break;
    if (f > 0.0) lo = d;
    else hi = d;
    tm_real next = (trial - y) / g3;
    if (old > 0.0 && f != f_old) {
      const tm_real ratio = old / d;
      if (ratio > 0.25 && ratio < 4.0) next = d - f * (old - d) / (f_old - f);
      else next = d * exp(-f * log(ratio) / (f_old - f));
    }
    if (!(next > lo && next < hi) || (it >= 12 && it % 2)) next = lo > 0.0 ? sqrt(lo) * sqrt(hi) : 0.01 * hi;
    old = d;
    f_old = f;
    d = next;
    if (!(d > lo && d < hi)) break; /* the bracket is as narrow as the arithmetic allows */
  }
  out.d_eps = d;
  return out;
}

/* Deviator s_trial brought back to the yield surface of the end of the step of length dt. */
TM_FN tm_return_result tm_radial_return(const tm_material *m, tm_sym3 s_trial, tm_real eps_p, tm_real T, tm_real dt)
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
  tm_real power = 0.0, first = 0.0; /* eps^n of Johnson-Cook; flow stress before the step, at no rate */
  if (jc) first = tm_max(soft * tm_johnson_cook_hardening(m, eps, &power), 0.0);
  else first = tm_flow_stress(m, eps, 0.0, T);
  out.yield = first;
  if (!(trial > first)) return out;

  if (jc && first > 0.0) out.d_eps = tm_return_johnson_cook(m, trial, eps, power, soft, first, dt, &out.iterations);
  else if (m->strength == TM_STRENGTH_PLASTIC) out.d_eps = tm_min((trial - first) / (g3 + m->hardening), trial / g3);
  else if (!jc && g3 > 0.0 && tm_strength_flow(m->strength) == TM_FLOW_THERMAL) {
    const tm_return_root root = tm_return_search(m, trial, eps, T, first, dt);
    out.d_eps = root.d_eps;
    out.iterations = root.iterations;
  } else out.d_eps = g3 > 0.0 ? (trial - first) / g3 : 0.0;
  out.yield = tm_max(trial - g3 * out.d_eps, 0.0);
  if (g3 <= 0.0) out.yield = first;
  out.s = tm_sym_scale(out.yield / trial, s_trial);
  return out;
}

/* How far a state of stress is one of tension, 0..1: of the pressure, from 0 to that of a bar in tension, -p = flow/3. flow: flow stress or
   von Mises stress; 0 without one. */
TM_FN tm_real tm_tension_share(tm_real flow, tm_real p)
{
  return flow > 0.0 ? tm_max(0.0, tm_min(1.0, -3.0 * p / flow)) : 0.0;
}

#endif
