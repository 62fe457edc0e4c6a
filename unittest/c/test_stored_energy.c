/* Elastic energy as a function of the state: closed forms of the integral of the pressure, the deviator's part, failed
   material, and what a path of small steps through tm_constitutive takes up. */
#include "tm_stored_energy.h"
#include "tm_update.h"
#include "ut_state.h"

static tm_material copper(int eos)
{
  tm_material m;
  memset(&m, 0, sizeof m);
  m.rho0 = 8960;
  m.bulk = 1.29e11;
  m.shear = 4.6e10;
  m.strength = TM_STRENGTH_ELASTIC;
  m.eos = eos;
  m.eos_c0 = 3940;
  m.eos_s = 1.489;
  m.eos_gamma = 2.0;
  m.eos_n = 7;
  return m;
}

static void pressure(void)
{
  const tm_material lin = copper(TM_EOS_LINEAR), tait = copper(TM_EOS_TAIT), shock = copper(TM_EOS_SHOCK);
  const double c = lin.bulk / lin.rho0, n = 7;
  for (double x = 0.5; x < 2.01; x += 0.05) {
    UT_WITHIN(tm_pressure_energy(&lin, 8960 * x), c * (log(x) + 1 / x - 1), 1e-8 * c);
    UT_WITHIN(tm_pressure_energy(&tait, 8960 * x), c / n * ((pow(x, n - 1) - 1) / (n - 1) + 1 / x - 1), 1e-7 * c);
  }
  for (double d = 1e-3; d > 1e-14; d *= 0.1) /* K d^2/2 per volume, to all digits */
    UT_NEAR(tm_pressure_energy(&lin, 8960 * (1 + d)), 0.5 * c * d * d, 2 * d + 1e-3 * (d < 1e-12) + 1e-14 / d);
  UT_TRUE(tm_pressure_energy(&lin, 8960) == 0);
  /* shock: the trapezoidal sum over 20000 densities, in tension and in compression */
  const double to[3] = {0.7, 1.1, 1.5};
  for (int k = 0; k < 3; k++) {
    double sum = 0;
    for (int i = 0; i < 20000; i++) {
      const double a = 8960 * (1 + (to[k] - 1) * i / 20000), b = 8960 * (1 + (to[k] - 1) * (i + 1) / 20000);
      sum += 0.5 * (b - a) * (tm_eos_pressure(&shock, a, 0) / (a * a) + tm_eos_pressure(&shock, b, 0) / (b * b));
    }
    UT_NEAR(tm_pressure_energy(&shock, 8960 * to[k]), sum, 1e-6);
  }
}

static void shape(void)
{
  tm_material m = copper(TM_EOS_LINEAR);
  const tm_sym3 s = tm_sym(2e8, -1e8, -1e8, 3e7, -4e7, 5e7);
  const double part = (6e16 + 2 * 50e14) / (4 * 4.6e10 * 8000);
  UT_NEAR(tm_stored_energy(&m, 8000, 1.0, s, 0) - tm_pressure_energy(&m, 8000), part, 1e-12);
  UT_TRUE(tm_stored_energy(&m, 8000, 1.0, s, 1) == 0.0); /* failed: no deviator, no tension */
  UT_NEAR(tm_stored_energy(&m, 9100, 1.0, s, 1), tm_pressure_energy(&m, 9100), 1e-15);
  m.strength = TM_STRENGTH_NONE;
  m.shear = 0.0;
  UT_NEAR(tm_stored_energy(&m, 9100, 1.0, s, 0), tm_pressure_energy(&m, 9100), 1e-15);
}

/* what grows by heat as its density falls stores nothing */
static void heated(void)
{
  const tm_material m = copper(TM_EOS_LINEAR);
  const tm_sym3 none = tm_sym(0, 0, 0, 0, 0, 0);
  for (double g = 1.0; g < 1.1; g += 0.01) {
    UT_TRUE(tm_stored_energy(&m, 8960 / g, g, none, 0) < 1e-9);
    UT_NEAR(tm_stored_energy(&m, 9100, g, none, 0), tm_pressure_energy(&m, 9100 * g), 1e-15);
  }
}

/* work of the stress along a path of compression, shear and rotation, small or large, against the state at its end */
static void path(void)
{
  for (int k = 0; k < 2; k++) {
    const tm_material m = copper(k ? TM_EOS_TAIT : TM_EOS_LINEAR);
    for (double size = 0.3; size > 1e-5; size *= 0.1) {
      const int steps = 2000;
      double rho = m.rho0, work = 0;
      tm_sym3 s = tm_sym(0, 0, 0, 0, 0, 0);
      for (int i = 0; i < steps; i++) {
        const double t = (i + 0.5) / steps;
        const tm_real l[9] = {-size, size * cos(3 * t), 0, -size * sin(2 * t), 0.3 * size, 0, 0, 0.5 * size, -size * t};
        const tm_mat3 L = tm_mat_load(l);
        const double dt = 1.0 / steps, half = rho * (1 - 0.5 * dt * tm_mat_trace(L));
        const tm_sym3 s_half = tm_sym_axpy(s, 0.5 * dt, tm_deviator_rate(s, L, m.shear));
        const tm_point q = tm_constitutive(&m, rho, half, s, s_half, L, 0, 1, 0, 300, dt, 0);
        work += dt / half * tm_sym_ddot(tm_sym_add_iso(s_half, -tm_eos_pressure(&m, half, 0)), tm_mat_symmetric(L));
        rho = q.rho;
        s = q.s;
      }
      UT_NEAR(tm_stored_energy(&m, rho, 1.0, s, 0), work, 2e-6);
    }
  }
}

/* the ledger of a step: a particle that fails loses what it held; with a shock equation of state the pressure by the
   internal energy is counted apart */
static void ledger(void)
{
  static ut_particles p;
  static double gradient[9 * UT_ROOM], records[TM_REC * UT_ROOM], internal[3 * UT_ROOM];
  ut_particles_make(&p);
  p.material[1] = copper(TM_EOS_SHOCK);
  p.material[1].strength = TM_STRENGTH_PLASTIC;
  p.material[1].yield = 1e8;
  p.material[1].damage = TM_DAMAGE_STRAIN;
  p.material[1].strain_max = 0.5;
  const double rho = 0.99 * 8960, mass = 2.0, e = 5e4, dt = 1e-9;
  p.field[TM_F_RHO][0] = records[TM_REC_RHO] = rho;
  records[TM_REC_M] = mass;
  records[TM_REC_C] = 5000.0;
  p.field[TM_F_ENERGY][0] = e;
  p.field[TM_F_PSTRAIN][0] = 0.5;
  p.field[TM_F_STRESS][3] = 1e8 / sqrt(3.0);
  gradient[0] = gradient[4] = gradient[8] = 100.0;
  gradient[1] = gradient[3] = 1e4;
  tm_update_args a;
  memset(&a, 0, sizeof a);
  a.state = p.state;
  a.rec.main = records;
  a.gradient = gradient;
  a.force_internal = internal;
  a.group = 1;
  a.dt = dt;
  a.h = 1e-3;
  a.accel_unit = 1.0;
  a.densest = 3.0;
  const unsigned fx = TM_FX_3D | TM_FX_PLASTICITY | TM_FX_DAMAGE | TM_FX_ENERGY | TM_FX_LEDGER;
  tm_update_result r = tm_update(0, &a, fx);
  UT_TRUE(p.field[TM_F_DAMAGE][1] == 1.0);
  const double held = 1e16 * 2.0 / 3.0 / (4 * 4.6e10 * rho) + tm_pressure_energy(p.material + 1, rho);
  UT_NEAR(r.failure, mass * held, 1e-4);
  UT_NEAR(r.thermal_pressure, -mass * dt / rho * 300.0 * 2.0 * 8960 * e, 1e-12);
  r = tm_update(0, &a, fx); /* it has failed: nothing is left to lose */
  UT_TRUE(r.failure == 0.0);
}

int main(void)
{
  pressure();
  shape();
  heated();
  path();
  ledger();
  return ut_summary();
}
