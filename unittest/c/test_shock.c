/* The bulk viscosity of shocks: tm_shock.h. */
#include "ut.h"
#include "tm_shock.h"
#include "tm_state.h"

static const double SMALL = 1e-12; /* of a step, with no bound */

/* q over rho c h rate */
static double coefficient(double shock, double rate, double h, double c, double share, double dt)
{
  const double rho = 8000.0;
  return tm_shock_pressure(shock, rate, h, c, rho, share * rho * c * c, dt) / (rho * c * h * rate);
}

static void limits(void)
{
  const double h = 1e-4, c = 6000.0, share = 3e-3, rho = 2700.0, Y = share * rho * c * c;
  for (int n = 0; n < 1000; n++) {
    const double rate = ut_random(-1e8, 1e8), shock = ut_random(0, 1), dt = ut_random(0, 0.6) * h / c;
    const double q = tm_shock_pressure(shock, rate, h, c, rho, Y, dt);
    UT_TRUE(q >= 0.0);
    if (rate <= 0.0) UT_TRUE(q == 0.0);
    else {
      UT_TRUE(q <= (1 + 1e-14) * shock * rho * c * h * rate);
      UT_TRUE(q <= (1 + 1e-14) * tm_shock_bound(h, c, dt) * rho * c * h * rate);
      UT_TRUE(tm_shock_pressure(shock, 1.1 * rate, h, c, rho, Y, dt) >= q);
    }
  }
  UT_TRUE(tm_shock_pressure(0.0, 1e12, h, c, rho, Y, 1e-9) == 0.0);
}

/* (Z^2 - 0.01)/(1 + Z^2), where Z is 1 where the longitudinal stress rises by a tenth of the flow stress in h/c; nothing at a tenth of that. */
static void closed_form(void)
{
  const double h = 2e-4, c = 5000.0, share = 4e-3;
  const double half = 0.1 * share * c / h; /* h/c rate = share/10 */
  UT_NEAR(coefficient(1.0, half, h, c, share, SMALL), 0.495, 1e-14);
  UT_NEAR(coefficient(0.6, half, h, c, share, SMALL), 0.297, 1e-14);
  UT_NEAR(coefficient(1.0, half / 3.0, h, c, share, SMALL), (1.0 / 9.0 - 0.01) / (10.0 / 9.0), 1e-13);
  UT_NEAR(coefficient(1.0, half * 5.0, h, c, share, SMALL), 24.99 / 26.0, 1e-14);
  UT_TRUE(coefficient(1.0, 0.0999 * half, h, c, share, SMALL) == 0.0 && coefficient(1.0, 0.1001 * half, h, c, share, SMALL) > 0.0);
  for (double z = 0.01; z < 0.2; z *= 1.1) {
    const double rho = 8000.0, Y = share * rho * c * c;
    UT_TRUE(tm_shock_acts(rho * z * half, h, c, rho, Y) == (coefficient(1.0, z * half, h, c, share, SMALL) > 0.0));
  }
  UT_TRUE(!tm_shock_acts(-1e12, h, c, 8000.0, 0.0) && tm_shock_acts(1e12, h, c, 8000.0, 0.0));
}

/* The same shock on particles of any size: the rate goes with c/h. A stronger metal needs a faster one; no strength counts as little. */
static void scaling(void)
{
  const double a = coefficient(1.0, 1e3, 1e-3, 5000.0, 2e-3, SMALL);
  UT_TRUE(a > 0.1 && a < 0.999);
  UT_NEAR(coefficient(1.0, 1e6, 1e-6, 5000.0, 2e-3, SMALL), a, 1e-13);
  UT_TRUE(coefficient(1.0, 1e3, 1e-3, 5000.0, 8e-3, SMALL) < a);
  UT_NEAR(coefficient(1.0, 1e3, 1e-3, 5000.0, 0.0, SMALL), coefficient(1.0, 1e3, 1e-3, 5000.0, TM_SHOCK_LEAST, SMALL), 1e-14);
}

/* A wave that turns by t in a step, v' = -t u - 1.7 b t (rate of the step before), u' = t v, with the predictor of tm_state.h: with the
   b of a coefficient of 1 it dies, with 2 tm_shock_bound() it grows. */
static double after(double t, double damping, int steps)
{
  const double last = 0.5 * (1.0 + 2.0 * TM_PREDICT_BETA), older = -TM_PREDICT_BETA;
  double v = 1.0, u = 0.3, a1 = 0.0, a2 = 0.0, r1 = 0.0, r2 = 0.0, largest = 0.0;
  for (int n = 0; n < steps; n++) {
    const double vp = v + last * a1 + older * a2, up = u + t * (last * r1 + older * r2);
    const double a = -t * up - damping * r1;
    v += a;
    u += t * vp;
    a2 = a1;
    a1 = a;
    r2 = r1;
    r1 = vp;
    if (n > steps - 50) largest = fmax(largest, fmax(fabs(v), fabs(u)));
  }
  return largest;
}
static void stability(void)
{
  const double h = 1e-4, c = 5000.0, turns[] = {0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6};
  for (int k = 0; k < 7; k++) {
    const double dt = turns[k] * h / (TM_SHOCK_TURN * c), most = TM_SHOCK_TURN * turns[k] * tm_shock_bound(h, c, dt);
    UT_NEAR(most, 0.85 * (1.0 - turns[k]), 1e-14);
    if (turns[k] > 0.15) UT_TRUE(after(turns[k], most, 4000) < 1e-3);
    UT_TRUE(after(turns[k], fmin(most, TM_SHOCK_TURN * turns[k]), 4000) < 1e-3);
    UT_TRUE(after(turns[k], 2.0 * most, 400) > 1e3);
  }
  UT_TRUE(tm_shock_bound(h, c, h / c) == 0.0);
  /* the usual step, courant 0.4 of h/c over 2.2, bears a coefficient of 1; courant 0.6 one of 0.57 */
  UT_TRUE(tm_shock_bound(h, c, 0.4 / 2.2 * h / c) > 1.0);
  UT_NEAR(tm_shock_bound(h, c, 0.6 / 2.2 * h / c), 0.578431372549, 1e-9);
}

/* 1 inside, 0 at faces, whatever the axes; z does not count in a plane. */
static void inside(void)
{
  UT_TRUE(tm_shock_inside(tm_sym(1, 1, 1, 0, 0, 0), 1) == 1.0);
  UT_TRUE(tm_shock_inside(tm_sym(1, 1, 7, 0, 0, 0), 0) == 1.0);
  UT_TRUE(tm_shock_inside(tm_sym(1.7, 1, 1, 0, 0, 0), 0) == 0.0);
  UT_TRUE(tm_shock_inside(tm_sym(0.5, 0.5, 0.5, 0, 0, 0), 1) == 0.0);
  for (int n = 0; n < 100; n++) {
    const double c = cos(0.1 * n), s = sin(0.1 * n), e = 0.3; /* diag(1 + e, 1) turned */
    const tm_sym3 K = tm_sym(1 + e * c * c, 1 + e * s * s, 1, e * c * s, 0, 0);
    UT_NEAR(tm_shock_inside(K, 0), 0.5, 1e-13);
    UT_NEAR(tm_shock_inside(K, 1), 2.0 / 3.0, 1e-13);
  }
}

int main(void)
{
  limits();
  closed_form();
  scaling();
  stability();
  inside();
  return ut_summary();
}
