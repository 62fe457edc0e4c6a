/* Equations of state: closed points, the Hugoniot from jump conditions, derivatives, limits. */
#include "tm_eos.h"
#include "ut.h"

static tm_material copper(int eos)
{
  tm_material m = {0};
  m.rho0 = 8960;
  m.bulk = 1.29e11;
  m.shear = 4.6e10;
  m.eos = eos;
  m.eos_c0 = 3940;
  m.eos_s = 1.489;
  m.eos_gamma = 2.0;
  m.eos_n = 7;
  return m;
}

/* c^2 - 4G/(3 rho) is dp/drho along the isentrope de = p/rho^2 drho */
static void check_sound_speed(const tm_material *m, double rho, double e)
{
  const double d = 1e-6 * m->rho0, p = tm_eos_pressure(m, rho, e);
  const double de = m->eos == TM_EOS_SHOCK ? tm_max(p, 0) / (rho * rho) * d : 0;
  const double slope =
      (tm_eos_pressure(m, rho + d, e + de) - tm_eos_pressure(m, rho - d, e - de)) / (2 * d);
  const double c = tm_eos_sound_speed(m, rho, e);
  UT_NEAR(c * c, slope + 4.0 / 3.0 * m->shear / rho, 1e-6);
}

int main(void)
{
  tm_material lin = copper(TM_EOS_LINEAR), tait = copper(TM_EOS_TAIT);
  tm_material shock = copper(TM_EOS_SHOCK), fluid = lin;

  UT_NEAR(tm_eos_pressure(&lin, 1.01 * 8960, 0), 1.29e9, 1e-12);
  UT_NEAR(tm_eos_pressure(&lin, 0.99 * 8960, 5e5), -1.29e9, 1e-12);
  UT_NEAR(tm_eos_sound_speed(&lin, 8960, 0), sqrt((1.29e11 + 4.0 / 3 * 4.6e10) / 8960), 1e-14);
  fluid.strength = TM_STRENGTH_NONE;
  UT_NEAR(tm_eos_sound_speed(&fluid, 8960, 0), sqrt(1.29e11 / 8960), 1e-14);
  UT_NEAR(tm_eos_pressure(&tait, 1.1 * 8960, 0), 1.29e11 / 7 * 0.9487171, 1e-9); /* 1.1^7 */
  UT_TRUE(tm_eos_pressure(&tait, 0.5 * 8960, 0) > -1.29e11 / 7);

  /* state behind a shock of particle speed u: jump conditions, no equation of state */
  for (double u = 50; u <= 2500; u += 50) {
    const double us = 3940 + 1.489 * u, rho = 8960 * us / (us - u);
    UT_NEAR(tm_eos_pressure(&shock, rho, 0.5 * u * u), 8960 * us * u, 1e-10);
  }
  UT_NEAR(tm_eos_pressure(&shock, 8960, 1000), 2.0 * 8960 * 1000, 1e-12);
  UT_NEAR(tm_eos_pressure(&shock, 0.99 * 8960, 0), -0.01 * 8960 * 3940.0 * 3940.0, 1e-12);

  for (int k = 0; k < 200; k++) {
    const double rho = 8960 * ut_random(0.8, 1.5), e = ut_random(0, 1e6);
    check_sound_speed(&lin, rho, e);
    check_sound_speed(&tait, rho, e);
    check_sound_speed(&shock, rho, e);
  }

  /* continuous with its slope at rho0 and at the limit of the Hugoniot, rising beyond, finite */
  const double d = 1e-7;
  const double left = tm_eos_pressure(&shock, 8960 * (1 - d), 0);
  UT_NEAR(tm_eos_pressure(&shock, 8960 * (1 + d), 0), -left, 1e-5);
  const double edge = 8960 / (1 - TM_EOS_SHOCK_LIMIT / 1.489);
  UT_NEAR(tm_eos_pressure(&shock, edge * (1 + d), 0), tm_eos_pressure(&shock, edge * (1 - d), 0),
          1e-5);
  double last = -1e300;
  for (double x = 0.01; x < 50; x *= 1.01) {
    const double p = tm_eos_pressure(&shock, x * 8960, 0);
    const double c = tm_eos_sound_speed(&shock, x * 8960, 0);
    UT_TRUE(isfinite(p) && p > last);
    UT_TRUE(isfinite(c) && c > 0);
    /* thinner than half: debris, whose waves are not faster for it */
    if (x < 0.5) UT_NEAR(c, sqrt(3940.0 * 3940.0 + 4.0 / 3.0 * 4.6e10 / (0.5 * 8960)), 1e-12);
    last = p;
  }
  for (int eos = 0; eos < 3; eos++) {
    const tm_material m = copper(eos);
    for (double rho = -8960; rho <= 0; rho += 8960) {
      UT_TRUE(isfinite(tm_eos_pressure(&m, rho, 1e5)));
      UT_TRUE(tm_eos_sound_speed(&m, rho, 1e5) > 0);
    }
  }
  shock.eos_s = 0; /* a slope of zero has no singularity */
  UT_NEAR(tm_eos_pressure(&shock, 2 * 8960, 0), 8960 * 3940.0 * 3940.0 * 0.5 * 0.5, 1e-12);
  return ut_summary();
}
