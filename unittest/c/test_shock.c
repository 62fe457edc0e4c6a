/* The shock switch of the linear viscosity: tm_shock.h. */
#include "ut.h"
#include "tm_shock.h"

static void limits(void)
{
  const double h = 1e-4, c = 6000.0, share = 3e-3;
  for (int n = 0; n < 1000; n++) {
    const double rate = ut_random(-1e8, 1e8), alpha = ut_random(0, 0.5), shock = ut_random(0, 1);
    const double a = tm_shock_alpha(alpha, shock, rate, h, c, share);
    UT_TRUE(a >= alpha && a <= (alpha > shock ? alpha : shock));
    if (rate <= 0.0) UT_TRUE(a == alpha);
    UT_TRUE(tm_shock_alpha(0.0, shock, 1.1 * rate, h, c, share) >= tm_shock_alpha(0.0, shock, rate, h, c, share));
  }
  UT_TRUE(tm_shock_alpha(0.25, 0.0, 1e12, h, c, share) == 0.25);
}

/* Half where the longitudinal stress rises by a tenth of the flow stress in h/c, a hundredth at a thirtieth, nearly all at a half. */
static void closed_form(void)
{
  const double h = 2e-4, c = 5000.0, share = 4e-3;
  const double half = 0.1 * share * c / h; /* h/c rate = share/10 */
  UT_NEAR(tm_shock_alpha(0.0, 1.0, half, h, c, share), 0.5, 1e-14);
  UT_NEAR(tm_shock_alpha(0.0, 0.6, half, h, c, share), 0.3, 1e-14);
  UT_NEAR(tm_shock_alpha(0.0, 1.0, half / 3.0, h, c, share), 1.0 / 82.0, 1e-12);
  UT_NEAR(tm_shock_alpha(0.0, 1.0, half * 5.0, h, c, share), 625.0 / 626.0, 1e-14);
}

/* The same shock on particles of any size: the rate goes with c/h. A stronger metal needs a faster one; no strength counts as little. */
static void scaling(void)
{
  const double a = tm_shock_alpha(0.0, 1.0, 1e3, 1e-3, 5000.0, 2e-3);
  UT_TRUE(a > 0.1 && a < 0.999);
  UT_NEAR(tm_shock_alpha(0.0, 1.0, 1e6, 1e-6, 5000.0, 2e-3), a, 1e-13);
  UT_TRUE(tm_shock_alpha(0.0, 1.0, 1e3, 1e-3, 5000.0, 8e-3) < a);
  UT_TRUE(tm_shock_alpha(0.0, 1.0, 1e3, 1e-3, 5000.0, 0.0) ==
          tm_shock_alpha(0.0, 1.0, 1e3, 1e-3, 5000.0, TM_SHOCK_LEAST));
}

int main(void)
{
  limits();
  closed_form();
  scaling();
  return ut_summary();
}
