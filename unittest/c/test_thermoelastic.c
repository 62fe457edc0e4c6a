/* Thermal expansion and heat of compression: strains against integrals by hand, the free and the held bar, the isentrope
   and the Hugoniot temperature against their differential equations, and c_p out of c_v. */
#include "tm_eos.h"
#include "tm_thermoelastic.h"
#include "ut.h"

static tm_material aluminium(void)
{
  tm_material m = {0};
  m.rho0 = 2700;
  m.bulk = 70e9;
  m.shear = 26e9;
  m.heat = 1;
  m.capacity.value = 900;
  m.expansion.value = 2.36e-5;
  return m;
}
static tm_material copper(void)
{
  tm_material m = {0};
  m.rho0 = 8930;
  m.bulk = 1.386e11;
  m.strength = TM_STRENGTH_NONE;
  m.eos = TM_EOS_SHOCK;
  m.eos_c0 = 3940;
  m.eos_s = 1.489;
  m.eos_gamma = 2.02;
  m.heat = 1;
  m.capacity.value = 383;
  return m;
}

/* constant alpha: alpha dT; a table: trapezoids, constant outside of it; either way back */
static void strain(void)
{
  tm_material m = aluminium();
  UT_NEAR(tm_thermal_strain(&m, 300, 400), 2.36e-3, 1e-13);
  UT_NEAR(tm_thermal_strain(&m, 400, 300), -2.36e-3, 1e-13);
  UT_NEAR(tm_thermal_growth(&m, 300, 400), 1.00236 * 1.00236 * 1.00236, 1e-14);
  m.expansion.n = 3;
  m.expansion.t[0] = 300; m.expansion.y[0] = 2e-5;
  m.expansion.t[1] = 500; m.expansion.y[1] = 3e-5;
  m.expansion.t[2] = 600; m.expansion.y[2] = 3e-5;
  UT_NEAR(tm_thermal_strain(&m, 300, 500), 5e-3, 1e-13);
  UT_NEAR(tm_thermal_strain(&m, 400, 550), 2.75e-3 + 1.5e-3, 1e-13);
  UT_NEAR(tm_thermal_strain(&m, 200, 800), 2e-3 + 5e-3 + 3e-3 + 6e-3, 1e-13);
  UT_NEAR(tm_thermal_strain(&m, 800, 200), -16e-3, 1e-13);
  UT_NEAR(tm_thermal_strain(&m, 100, 200), 2e-3, 1e-13);
  UT_NEAR(tm_thermal_strain(&m, 700, 800), 3e-3, 1e-13);
  UT_TRUE(tm_thermal_strain(&m, 450, 450) == 0.0);
  m.eos = TM_EOS_SHOCK;
  UT_TRUE(tm_thermal_strain(&m, 200, 800) == 0.0);
}

/* a free volume has no pressure at its new density; a held one has 3 K alpha dT; each equation of state */
static void pressure(void)
{
  tm_material m = aluminium();
  const double g = tm_thermal_growth(&m, 300, 350);
  for (int eos = 0; eos < 3; eos += 2) {
    m.eos = eos;
    m.eos_n = 4;
    UT_WITHIN(tm_eos_pressure(&m, g * (m.rho0 / g), 0), 0.0, 1e-4);
    UT_NEAR(tm_eos_pressure(&m, g * m.rho0, 0), 3 * m.bulk * 2.36e-5 * 50, 0.01);
  }
  /* shock: heat q at no pressure, volume grows by 3 alpha dT with 3 alpha = Gamma0 c_p/c0^2 */
  const tm_material c = copper();
  const double q = 383 * 50.0, x = 1.0 - 2.02 * q / (3940.0 * 3940.0);
  UT_WITHIN(tm_eos_pressure(&c, x * c.rho0, q), 0.0, 1.0);
}

/* dT = -Gamma T tr D dt in small steps, and that of Gamma rho constant at once */
static void isentrope(void)
{
  const tm_material m = copper();
  const double g = tm_gruneisen_density(&m, 300);
  UT_NEAR(g, 2.02 * 8930, 1e-14);
  double T = 300, rho = 8930;
  const int n = 100000;
  for (int k = 0; k < n; k++) {
    const double next = 8930 * (1 + 0.25 * (k + 1) / n), mid = 0.5 * (rho + next);
    T += g / mid * T * (next - rho) / mid;
    rho = next;
  }
  UT_NEAR(300 * tm_compression_heat(g, 8930, 1.25 * 8930), T, 1e-5);
  UT_NEAR(300 * tm_compression_heat(g, 8930, 1.25 * 8930), 300 * exp(2.02 * 0.2), 1e-13);
  UT_NEAR(tm_compression_heat(g, 8930, 9500) * tm_compression_heat(g, 9500, 8930), 1, 1e-14);
  const tm_material a = aluminium();   /* small elastic strain: dT = -3 alpha K T tr(eps)/(rho c_v), Thomson 1853 */
  UT_NEAR(tm_compression_heat(tm_gruneisen_density(&a, 300), 2700 * (1 - 1e-6), 2700) - 1,
          3 * 2.36e-5 * 70e9 / (2700 * 900.0) * 1e-6, 1e-5);
}

/* heat per temperature at constant pressure: T of a body that expands freely while heated */
static void capacity(void)
{
  for (int shock = 0; shock < 2; shock++) {
    tm_material m = shock ? copper() : aluminium();
    const double T0 = 300, cp = m.capacity.value;
    tm_set_compression_heat(&m, 1, T0);
    const double alpha3 = shock ? 2.02 * 383 / (3940.0 * 3940.0) : 3 * 2.36e-5;
    const double gamma = tm_gruneisen_density(&m, T0) / m.rho0;
    UT_NEAR(cp / tm_capacity(&m, T0), 1 + alpha3 * gamma * T0, 1e-12);
    UT_TRUE(tm_capacity(&m, T0) < 0.98 * cp && tm_capacity(&m, T0) > 0.94 * cp);
    const double dT = 1e-3, grown = m.rho0 * (1 - alpha3 * dT);
    const double cooled = T0 * (1 - tm_compression_heat(gamma * m.rho0, m.rho0, grown));
    UT_NEAR(tm_capacity(&m, T0) * (dT + cooled), cp * dT, 1e-4);
  }
  tm_material none = aluminium();
  none.expansion.value = 0;
  tm_set_compression_heat(&none, 1, 300);
  UT_TRUE(tm_capacity(&none, 300) == 900.0 && tm_gruneisen_density(&none, 300) == 0.0);
  tm_material off = aluminium();
  tm_set_compression_heat(&off, 0, 300);
  UT_TRUE(tm_capacity(&off, 300) == 900.0);
  /* the integral of c_v = c_p - (3 alpha)^2 K T/rho0 from 300 to 400 K, by its rise */
  tm_material m = aluminium();
  tm_set_compression_heat(&m, 1, 300);
  const double b = 9 * 2.36e-5 * 2.36e-5 * 70e9 / 2700;
  UT_NEAR(tm_heat_rise(&m, 300, 900 * 100 - b * 0.5 * (400.0 * 400 - 300.0 * 300)), 100, 1e-8);
}

/* Shock along a Rayleigh line with the dissipation of the jump: the sum of isentropic heat and dissipation over c_v is
   Walsh and Christian 1955 (8): dT/dv = -Gamma T/v + ((v0 - v) dpH/dv + pH)/(2 c_v) along the Hugoniot. */
static void hugoniot(void)
{
  const tm_material m = copper();
  const double cv = 370, v0 = 1 / m.rho0, us = 3940 + 1.489 * 1000, v1 = v0 * (us - 1000) / us;
  double T = 300, along = 300;
  const int n = 20000;
  for (int k = 0; k < n; k++) {
    const double a = v0 + (v1 - v0) * k / n, b = v0 + (v1 - v0) * (k + 1) / n, v = 0.5 * (a + b), d = 1e-6 * v0;
    /* Rayleigh line: stress p = p_s + q, p_s of the equation of state at the energy (v0 - v)^2 (us/v0)^2/2 */
    const double e = 0.5 * (v0 - v) * (v0 - v) * us * us / (v0 * v0), total = (v0 - v) * us * us / (v0 * v0);
    const double q = total - tm_eos_pressure(&m, 1 / v, e);
    T = T * tm_compression_heat(tm_gruneisen_density(&m, T), 1 / a, 1 / b) + q * (a - b) / cv;
    const double eta = (v0 - v) / v0, ph = m.rho0 * 3940.0 * 3940.0 * eta / ((1 - 1.489 * eta) * (1 - 1.489 * eta));
    const double eta2 = eta - d / v0, ph2 = m.rho0 * 3940.0 * 3940.0 * eta2 / ((1 - 1.489 * eta2) * (1 - 1.489 * eta2));
    along += (b - a) * (-2.02 / v0 * along + ((v0 - v) * (ph2 - ph) / d + ph) / (2 * cv));
  }
  UT_NEAR(T, along, 1e-4);
  UT_TRUE(T > 600 && T < 1000);
}

int main(void)
{
  strain();
  pressure();
  isentrope();
  capacity();
  hugoniot();
  return ut_summary();
}
