/* One step of the corrector against closed forms: motion, density and pressure, elastic and plastic stress, plane stress,
   temperature, the energy balance of the step, and the limits of the next one. */
#include "tm_update.h"
#include "ut_state.h"

static ut_particles p;
static double gradient[9 * UT_ROOM], records[TM_REC * UT_ROOM], conducted[UT_ROOM], internal[3 * UT_ROOM],
    source[UT_ROOM];
static const double DT = 1e-3, G = 1e4, K = 1e5 / 6.0, RHO = 10.0, MASS = 2.0;
static const unsigned ALL = TM_FX_3D | TM_FX_PLASTICITY | TM_FX_HEAT | TM_FX_CONDUCTION | TM_FX_LEDGER;

static tm_update_args arrange(void)
{
  tm_update_args a;
  ut_particles_make(&p);
  memset(gradient, 0, sizeof gradient);
  memset(records, 0, sizeof records);
  memset(conducted, 0, sizeof conducted);
  memset(internal, 0, sizeof internal);
  memset(source, 0, sizeof source);
  memset(&a, 0, sizeof a);
  tm_material *m = p.material + 1;
  m->young = 2.5e4;
  m->poisson = 0.25;
  m->shear = G;
  m->bulk = K;
  m->eos_c0 = sqrt(K / RHO);
  m->strength = TM_STRENGTH_PLASTIC;
  m->yield = 1e9;
  m->heat = 1;
  m->capacity.value = 5.0;
  m->conductivity.value = 3.0;
  m->taylor_quinney = 0.9;
  p.field[TM_F_RHO][0] = RHO;
  p.field[TM_F_TEMP][0] = 300.0;
  p.field[TM_F_THICKNESS][0] = 1.0;
  records[TM_REC_M] = MASS;
  records[TM_REC_RHO] = RHO;
  records[TM_REC_C] = 60.0;
  a.state = p.state;
  a.rec.main = records;
  a.gradient = gradient;
  a.heat = conducted;
  a.force_internal = internal;
  a.source = source;
  a.group = 1;
  a.dt = DT;
  a.h = 1.5;
  a.visc_alpha = 0.25;
  a.accel_unit = 1.0;
  a.hottest = 5000.0;
  a.densest = 3.0;
  a.k_max = 3.0;
  a.heat_rate = 6.0;
  return a;
}

/* semi-implicit: v first, then x with the new v; kinetic energy of the step; forces enter in the style's unit */
static void motion(void)
{
  tm_update_args a = arrange();
  const double v0[3] = {1.0, -2.0, 0.5}, f[3] = {6.0, 4.0, -8.0};
  a.accel_unit = 3.0;
  for (int k = 0; k < 3; k++) {
    p.v[k] = v0[k];
    p.x[k] = 0.1 * k;
    p.force[k] = f[k];
    internal[k] = 0.5 * f[k];
  }
  const tm_update_result r = tm_update(0, &a, ALL);
  double gained = 0.0, inner = 0.0;
  for (int k = 0; k < 3; k++) {
    const double acc = 3.0 * f[k] / MASS, v1 = v0[k] + DT * acc;
    UT_NEAR(p.v[k], v1, 1e-15);
    UT_WITHIN(p.x[k], 0.1 * k + 0.5 * DT * v1, 1e-15);
    UT_NEAR(p.field[TM_F_HISTORY][TM_H_V + k], acc, 1e-15);
    gained += 0.5 * MASS * (v1 * v1 - v0[k] * v0[k]);
    inner += 3.0 * 0.5 * f[k] * 0.5 * (v0[k] + v1) * DT;
  }
  UT_NEAR(r.kinetic_work, gained, 1e-12);
  UT_NEAR(r.internal_work, inner, 1e-13);
  a.group = 2; /* of another group: its state goes on, it does not move */
  p.x[0] = 7.0;
  tm_update(0, &a, ALL);
  UT_TRUE(p.x[0] == 7.0 && p.field[TM_F_HISTORY][TM_H_V] == 0.0);
}

/* F15 (2) with the density of the half step; the rates of this step and of the last are kept */
static void density(void)
{
  const tm_update_args a = arrange();
  records[TM_REC_RHO] = 10.2;
  gradient[0] = 3.0;
  gradient[4] = -1.0;
  gradient[8] = 4.0;
  p.field[TM_F_HISTORY][TM_H_RHO] = 77.0;
  tm_update(0, &a, ALL);
  const double rho = RHO - DT * 10.2 * 6.0;
  UT_NEAR(p.field[TM_F_RHO][0], rho, 1e-15);
  UT_NEAR(p.field[TM_F_HISTORY][TM_H_RHO], -10.2 * 6.0, 1e-11);
  UT_TRUE(p.field[TM_F_HISTORY][TM_H_STEP + TM_H_RHO] == 77.0);
}

/* elastic: 2G dev D over the step; its energy is sigma(half) : D, and the stress of the half step counts */
static void elastic(void)
{
  const tm_update_args a = arrange();
  gradient[1] = 0.4; /* simple shear */
  p.field[TM_F_STRESS][3] = 5.0;
  p.field[TM_F_HISTORY][TM_H_S + 3] = 200.0;
  p.field[TM_F_HISTORY][TM_H_STEP + TM_H_S + 3] = 100.0;
  const tm_update_result r = tm_update(0, &a, ALL);
  const double half = 5.0 + 0.5 * DT * (1.5 * 200.0 - 0.5 * 100.0);
  UT_NEAR(p.field[TM_F_STRESS][3], 5.0 + DT * G * 0.4, 1e-14);
  UT_NEAR(p.field[TM_F_STRESS][0], DT * 0.4 * half, 1e-13); /* Jaumann: W S - S W of the half step */
  UT_NEAR(p.field[TM_F_STRESS][1], -DT * 0.4 * half, 1e-13);
  UT_NEAR(p.field[TM_F_HISTORY][TM_H_S + 3], G * 0.4, 1e-12);
  UT_NEAR(r.stress_work, MASS * DT / RHO * half * 0.4, 1e-13);
  UT_TRUE(r.plastic == 0.0 && p.field[TM_F_PSTRAIN][0] == 0.0);
}

/* perfect plasticity in shear that flows already: all work of the step is plastic, chi of it heat */
static void plastic(void)
{
  const tm_update_args a = arrange();
  const double Y = 30.0, tau = Y / sqrt(3.0), rate = 0.4;
  p.material[1].yield = Y;
  gradient[1] = gradient[3] = 0.5 * rate;
  p.field[TM_F_STRESS][3] = tau;
  const tm_update_result r = tm_update(0, &a, ALL);
  const double d_eps = DT * rate / sqrt(3.0);
  UT_NEAR(p.field[TM_F_STRESS][3], tau, 1e-13);
  UT_NEAR(p.field[TM_F_PSTRAIN][0], d_eps, 1e-12);
  UT_NEAR(p.field[TM_F_PSTRAIN][1], d_eps / DT, 1e-12);
  UT_NEAR(p.field[TM_F_PSTRAIN][2], Y, 1e-14);
  UT_NEAR(r.plastic, MASS / RHO * Y * d_eps, 1e-12);
  UT_NEAR(r.plastic_heat, 0.9 * r.plastic, 1e-14);
  UT_WITHIN(r.stress_work, r.plastic, 1e-12 * r.plastic);
  UT_NEAR(p.field[TM_F_TEMP][0] - 300.0, 0.9 * Y * d_eps / (RHO * 5.0), 1e-9);
  UT_NEAR(r.heat, r.plastic_heat, 1e-12);
  UT_NEAR(p.field[TM_F_TEMP][1], 0.9 * Y * d_eps / (RHO * 5.0 * DT), 1e-9);
}

/* conduction is a power per volume of the record, the source one per particle; the source is emptied */
static void temperature(void)
{
  const tm_update_args a = arrange();
  conducted[0] = 700.0;
  source[0] = 40.0;
  p.field[TM_F_TEMP][1] = 3.0;
  const tm_update_result r = tm_update(0, &a, ALL);
  const double power = 700.0 * MASS / RHO + 40.0;
  UT_NEAR(r.heat, power * DT, 1e-14);
  UT_NEAR(p.field[TM_F_TEMP][0] - 300.0, power * DT / (MASS * 5.0), 1e-10);
  UT_TRUE(p.field[TM_F_TEMP][2] == 3.0 && source[0] == 0.0);

  tm_update_args b = arrange(); /* a conduction-only material has no mechanics */
  p.material[1].body = TM_BODY_HEAT;
  source[0] = 40.0;
  gradient[0] = 5.0;
  tm_update(0, &b, ALL);
  UT_NEAR(p.field[TM_F_TEMP][0] - 300.0, 40.0 * DT / (MASS * 5.0), 1e-10);
  UT_TRUE(p.field[TM_F_RHO][0] == RHO && p.field[TM_F_STRESS][0] == 0.0);
}

/* the internal energy takes the work of the stress: a compression of a fluid, p(half) V tr L */
static void internal_energy(void)
{
  const tm_update_args a = arrange();
  p.material[1].strength = TM_STRENGTH_NONE;
  gradient[0] = gradient[4] = gradient[8] = -2.0;
  records[TM_REC_RHO] = 10.1;
  tm_update(0, &a, TM_FX_3D | TM_FX_ENERGY);
  UT_NEAR(p.field[TM_F_ENERGY][0], DT / 10.1 * K * 0.01 * 6.0, 1e-12);
}

/* plane stress: sigma_zz vanishes at the end of the step, elastic and plastic; in the elastic range
   sigma_xx = E/(1 - nu^2) eps_xx, and the thickness follows -nu/(1 - nu) eps_xx */
static void plane_stress(void)
{
  for (int k = 0; k < 2; k++) {
    const tm_update_args a = arrange();
    p.material[1].yield = k ? 5.0 : 1e9;
    gradient[0] = k ? 2.0 : 1e-4;
    tm_update(0, &a, TM_FX_PLASTICITY | TM_FX_PLANE_STRESS);
    const double pressure = K * (p.field[TM_F_RHO][0] / RHO - 1.0);
    UT_WITHIN(p.field[TM_F_STRESS][2] - pressure, 0.0, 1e-8);
    UT_TRUE((p.field[TM_F_PSTRAIN][0] > 0.0) == (k == 1));
    if (k) continue;
    UT_NEAR(p.field[TM_F_STRESS][0] - pressure, 2.5e4 / (1.0 - 0.0625) * 1e-4 * DT, 1e-5);
    UT_NEAR(p.field[TM_F_THICKNESS][0] - 1.0, -1.0 / 3.0 * 1e-4 * DT, 1e-5);
  }
}

/* a volume that shrinks warms along the isentrope, and what the artificial terms give heats; with conduction, a source and
   a shock equation of state all of it goes into e, and the sum of elastic energy, heat and artificial work is the work and
   what was given */
static void shock_heat(void)
{
  static double artificial[UT_ROOM];
  const unsigned shock = TM_FX_3D | TM_FX_HEAT | TM_FX_CONDUCTION | TM_FX_ENERGY | TM_FX_LEDGER;
  const unsigned heats[3] = {0, TM_FX_COMPRESSION_HEAT, TM_FX_COMPRESSION_HEAT | TM_FX_ARTIFICIAL_HEAT};
  for (int k = 0; k < 3; k++) {
    tm_update_args a = arrange();
    tm_material *m = p.material + 1;
    m->strength = TM_STRENGTH_NONE;
    m->eos = TM_EOS_SHOCK;
    m->eos_s = 1.4;
    m->eos_gamma = 2.0;
    a.artificial = artificial;
    artificial[0] = 90.0;
    conducted[0] = 700.0;
    source[0] = 40.0;
    gradient[0] = -5.0;
    records[TM_REC_RHO] = 10.1;
    const tm_update_result r = tm_update(0, &a, shock | heats[k]);
    const double given = DT * (700.0 * MASS / 10.1 + 40.0), e = p.field[TM_F_ENERGY][0], rho = p.field[TM_F_RHO][0];
    const double work = MASS * e - given - DT * 90.0;
    const double warmer = k ? 300.0 * exp(2.0 * RHO * (1.0 / RHO - 1.0 / rho)) : 300.0;
    UT_NEAR(rho, RHO + DT * 10.1 * 5.0, 1e-14);
    UT_NEAR(p.field[TM_F_TEMP][0], warmer + (given + (k == 2) * DT * 90.0) / (MASS * 5.0), 1e-12);
    UT_NEAR(r.heat, given + MASS * 5.0 * (warmer - 300.0), 1e-10);
    UT_NEAR(r.artificial, DT * 90.0, 1e-14);
    UT_NEAR(r.stress_work - r.plastic + given, work + given, 1e-10);
    UT_NEAR(r.heat - r.compression, given, 1e-10);
  }
  /* artificial stress gives energy: with it only what is taken under pressure is heat */
  const unsigned with = TM_FX_ARTIFICIAL_HEAT | TM_FX_ARTSTRESS;
  UT_TRUE(tm_artificial_heat(3.0, 5.0, 0) == 0.0 && tm_artificial_heat(-3.0, -5.0, TM_FX_ARTIFICIAL_HEAT) == -3.0);
  UT_TRUE(tm_artificial_heat(3.0, 5.0, with) == 3.0 && tm_artificial_heat(3.0, -5.0, with) == 0.0);
  UT_TRUE(tm_artificial_heat(-3.0, 5.0, with) == 0.0);
  tm_update_args a = arrange(); /* failed, and open: no tension, no heat */
  p.material[1].expansion.value = 1e-3;
  p.field[TM_F_DAMAGE][tm_column(1)] = 1.0;
  gradient[0] = 5.0;
  tm_update(0, &a, TM_FX_3D | TM_FX_HEAT | TM_FX_DAMAGE | TM_FX_COMPRESSION_HEAT);
  UT_TRUE(p.field[TM_F_TEMP][0] == 300.0);
}

/* thermal expansion: at rest, in plane stress the thickness grows until sigma_zz is 0; E alpha dT/(1 - nu) in the plane */
static void expansion(void)
{
  const tm_update_args a = arrange();
  p.material[1].expansion.value = 1e-5;
  p.field[TM_F_UNSTRAINED][0] = 290.0;
  tm_update(0, &a, TM_FX_HEAT | TM_FX_EXPANSION | TM_FX_PLANE_STRESS);
  const double growth = (1.0 + 1e-4) * (1.0 + 1e-4) * (1.0 + 1e-4);
  const double pressure = K * (growth * p.field[TM_F_RHO][0] / RHO - 1.0);
  UT_WITHIN(p.field[TM_F_STRESS][2] - pressure, 0.0, 1e-8);
  UT_NEAR(p.field[TM_F_STRESS][0] - pressure, -2.5e4 * 1e-4 / 0.75, 1e-3);
  UT_NEAR(p.field[TM_F_THICKNESS][0] - 1.0, 1e-4 * 1.25 / 0.75, 1e-3);
}

/* failed material in plane stress keeps its thickness */
static void failed_plate(void)
{
  const tm_update_args a = arrange();
  p.field[TM_F_DAMAGE][tm_column(1)] = 1.0;
  p.field[TM_F_THICKNESS][0] = 0.9;
  gradient[0] = gradient[4] = -2.0;
  records[TM_REC_RHO] = 0.9 * RHO;
  tm_update(0, &a, TM_FX_PLASTICITY | TM_FX_DAMAGE | TM_FX_PLANE_STRESS);
  UT_TRUE(p.field[TM_F_THICKNESS][0] == 0.9);
  UT_NEAR(p.field[TM_F_RHO][0], RHO + DT * RHO * 4.0, 1e-14);
}

static void limits(void)
{
  const tm_update_args a = arrange();
  p.force[0] = 3.0 * MASS;
  p.force[1] = 4.0 * MASS;
  tm_update_result r = tm_update(0, &a, ALL);
  UT_NEAR(r.dt[TM_DT_SOUND], 1.5 / 60.0, 1e-14);
  UT_NEAR(r.dt[TM_DT_FORCE], sqrt(1.5 / 5.0), 1e-14);
  UT_NEAR(r.dt[TM_DT_CONDUCTION], 0.5 * RHO * 5.0 * 1.5 * 1.5 / (6.0 * 3.0), 1e-14);
  p.force[0] = p.force[1] = 0.0;
  p.material[1].conductivity.value = 0.0;
  r = tm_update(0, &a, ALL);
  UT_TRUE(r.dt[TM_DT_FORCE] == TM_DT_NO_LIMIT && r.dt[TM_DT_CONDUCTION] == TM_DT_NO_LIMIT);
  UT_TRUE(r.status == TM_OK);
  UT_TRUE(tm_decay_time_step(0.0) == TM_DT_NO_LIMIT);
  UT_NEAR(tm_decay_time_step(4.0), 0.125, 1e-15);
}

/* Metal that flows moves by tm_shift() too, and the way counts as speed; not what another fix holds, is not of the group, is
   elastic or has failed. Velocity and stress are as without. */
static void shifting(void)
{
  static double uneven[3 * UT_ROOM];
  const tm_vec3 g = tm_vec(0.03, -0.02, 0.01);
  for (int k = 0; k < 6; k++) {
    tm_update_args a = arrange();
    double *x = p.state.x, *eps = p.field[TM_F_PSTRAIN];
    tm_store3(uneven, g);
    p.material[1].yield = k == 4 ? 1e9 : 10.0;
    eps[0] = 0.5;
    gradient[0] = 2.0;
    gradient[tm_column(4)] = -2.0;
    records[TM_REC_C] = 600.0;
    p.state.v[0] = 7.0;
    const tm_vec3 at = tm_load3(x);
    a.uneven = k == 0 ? NULL : uneven;
    a.held = k == 2 ? 1 : 2;
    if (k == 3) a.group = 4;
    const unsigned damage = k == 5 ? (unsigned) TM_FX_DAMAGE : 0u;
    if (damage) p.field[TM_F_DAMAGE][tm_column(1)] = 1.0;
    const tm_update_result r = tm_update(0, &a, ALL | damage);
    const double d_eps = eps[0] - 0.5, way = k == 3 ? 0.0 : 0.5 * DT * 7.0;
    const double tension =
        tm_tension_share(eps[tm_column(2)], tm_eos_pressure(&p.material[1], p.field[TM_F_RHO][0], 0.0));
    const tm_shift_flow flow = tm_shift_along(tm_mat_from_row(gradient), g, 1);
    const tm_vec3 want = k == 1 ? tm_shift(g, flow, a.h, 0.5, d_eps, tension, 600.0 * DT) : tm_vec(0, 0, 0);
    UT_TRUE(k >= 4 ? d_eps == 0.0 : d_eps > 1e-4);
    UT_NEAR(x[0] - at.x, way + want.x, 1e-12);
    UT_NEAR(x[1] - at.y, want.y, 1e-12);
    UT_NEAR(x[2] - at.z, want.z, 1e-12);
    UT_NEAR(sqrt(r.speed2), 7.0 + 2.0 / DT * tm_vec_norm(want), 1e-12);
    UT_TRUE(p.state.v[0] == 7.0 && (k != 1 || want.x < 0.0));
  }
}

/* in a plane the columns that couple it with z are neither read nor written, and all others come out as in three dimensions */
static void plane(void)
{
  static const int across[][2] = {{TM_F_STRESS, 4},
                                  {TM_F_STRESS, 5},
                                  {TM_F_HISTORY, TM_H_V + 2},
                                  {TM_F_HISTORY, TM_H_S + 4},
                                  {TM_F_HISTORY, TM_H_S + 5},
                                  {TM_F_HISTORY, TM_H_STEP + TM_H_V + 2},
                                  {TM_F_HISTORY, TM_H_STEP + TM_H_S + 4},
                                  {TM_F_HISTORY, TM_H_STEP + TM_H_S + 5},
                                  {TM_F_HOURGLASS, TM_G_U + 2},
                                  {TM_F_HOURGLASS, TM_G_RATE + 2},
                                  {TM_F_CORRECTION, 4},
                                  {TM_F_CORRECTION, 5},
                                  {TM_F_CORRECTION, TM_K_SPIN},
                                  {TM_F_CORRECTION, TM_K_SPIN + 1},
                                  {TM_F_CORRECTION, TM_K_RATE + 4},
                                  {TM_F_CORRECTION, TM_K_RATE + 5}};
  static const int fields[] = {TM_F_RHO,  TM_F_STRESS,    TM_F_HISTORY,   TM_F_PSTRAIN,
                               TM_F_TEMP, TM_F_HOURGLASS, TM_F_CORRECTION};
  static const double moment[TM_MOMENT_COLUMNS] = {1.1, 0.9, 1.0, 0.05, 0, 0},
                      correction[6] = {1.08, 0.93, 1.0, 0.04, 0, 0};
  static const double rate[3] = {0.3, -0.2, 0.0};
  const int many = (int) (sizeof across / sizeof *across);
  double state[2][7][TM_H_COLUMNS];
  for (int flat = 0; flat < 2; flat++) {
    tm_update_args a = arrange();
    p.material[1].yield = 20.0;
    a.moment = moment;
    a.correction = correction;
    a.hourglass_rate = rate;
    a.hourglass = 0.1;
    const double L[9] = {0.3, 0.5, 0, -0.2, -0.1, 0, 0, 0, 0};
    for (int k = 0; k < 9; k++) gradient[k] = L[k];
    for (int f = 1; f < 7; f++)
      for (int c = 0; c < tm_field_columns(fields[f]); c++) p.field[fields[f]][c] = 0.01 * (c + 1) + f;
    for (int k = 0; k < many; k++) p.field[across[k][0]][across[k][1]] = flat ? NAN : 0.0;
    p.field[TM_F_TEMP][0] = 300.0;
    p.state.v[0] = 3.0;
    const unsigned effects = (ALL | TM_FX_HOURGLASS | TM_FX_ONE_PASS) & ~(flat ? TM_FX_3D : 0u);
    const tm_update_result r = tm_update(0, &a, effects);
    UT_TRUE(r.status == TM_OK);
    for (int k = 0; k < many; k++) {
      double *value = p.field[across[k][0]] + across[k][1];
      UT_TRUE(flat ? isnan(*value) : *value == 0.0);
      *value = 0.0;
    }
    for (int f = 0; f < 7; f++)
      for (int c = 0; c < tm_field_columns(fields[f]); c++) state[flat][f][c] = p.field[fields[f]][c];
  }
  for (int f = 0; f < 7; f++)
    for (int c = 0; c < tm_field_columns(fields[f]); c++) UT_TRUE(state[0][f][c] == state[1][f][c]);
}

int main(void)
{
  plane();
  shifting();
  motion();
  density();
  elastic();
  plastic();
  temperature();
  internal_energy();
  plane_stress();
  shock_heat();
  expansion();
  failed_plate();
  limits();
  return ut_summary();
}
