/* Kinetic and elastic energy and virial of one particle, against closed forms. */
#include "tm_tally.h"
#include "ut_state.h"

static ut_particles p;
static double records[TM_REC * UT_ROOM], each[TM_TALLY * UT_ROOM];

static tm_tally_args args(void)
{
  tm_tally_args a;
  memset(&a, 0, sizeof a);
  a.rec.main = records;
  a.state = p.state;
  a.to_energy = 1.0;
  a.per_particle = each;
  return a;
}

/* particle i of volume 2 under the stress, with the density of its pressure (linear, K = 160, rho0 = 10) */
static void press(int i, tm_sym3 sigma, int form_f14)
{
  double *r = records + TM_REC * i;
  const double rho = 10.0 * (1.0 - tm_sym_trace(sigma) / 3.0 / 160.0);
  r[TM_REC_M] = 2.0 * rho;
  r[TM_REC_RHO] = rho;
  tm_sym_store(r + TM_REC_P, tm_sym_scale(form_f14 ? 1.0 : 1.0 / (rho * rho), sigma));
}
static double of_pressure(double p) /* energy per volume: K x (ln x + 1/x - 1) = p^2/2K + ... */
{
  const double x = 1.0 + p / 160.0;
  return 160.0 * x * (log(x) + 1.0 / x - 1.0);
}

int main(void)
{
  ut_particles_make(&p);
  p.v[3] = 1.0;
  p.v[4] = -2.0;
  p.v[5] = 3.0;
  UT_NEAR(tm_kinetic_energy(1, &p.state), 0.5 * 2.0 * 14.0, 1e-15);
  UT_TRUE(tm_kinetic_energy(0, &p.state) == 0.0);
  p.type[1] = 3; /* mass 6 */
  UT_NEAR(tm_kinetic_energy(1, &p.state), 0.5 * 6.0 * 14.0, 1e-15);
  double rmass[2] = {1.0, 8.0};
  p.state.rmass = rmass;
  UT_NEAR(tm_kinetic_energy(1, &p.state), 0.5 * 8.0 * 14.0, 1e-15);

  /* uniaxial stress S: energy V S^2/(6G) of the deviator and that of the pressure, V S^2/(2E) for small stress */
  const double G = 80.0, K = 160.0, V = 2.0;
  p.material[1].shear = G;
  p.material[1].bulk = K;
  p.material[1].strength = TM_STRENGTH_ELASTIC;
  p.state.field[TM_F_DAMAGE] = NULL;
  tm_tally_args a = args();
  for (int f14 = 0; f14 < 2; f14++) {
    const unsigned fx = f14 ? TM_FX_FORM_F14 : 0u;
    press(0, tm_sym(7.0, 0, 0, 0, 0, 0), f14);
    tm_tally_result r = tm_tally(0, &a, fx);
    UT_NEAR(r.value[0], V * (49.0 / (6.0 * G) + of_pressure(-7.0 / 3.0)), 1e-13);
    UT_NEAR(r.value[1], -V * 7.0, 1e-14);
    for (int k = 2; k < TM_TALLY; k++) UT_WITHIN(r.value[k], 0.0, 1e-14);
    press(0, tm_sym(0.007, 0, 0, 0, 0, 0), f14);
    UT_NEAR(tm_tally(0, &a, fx).value[0], V * 49e-6 / (2.0 * 9.0 * K * G / (3.0 * K + G)), 1e-4);
    press(0, tm_sym(-5.0, -5.0, -5.0, 0, 0, 0), f14);
    UT_NEAR(tm_tally(0, &a, fx).value[0], V * of_pressure(5.0), 1e-13);
    press(0, tm_sym(0, 0, 0, 1.0, -2.0, 3.0), f14); /* shear: V t^2/(2G); the virial in its order */
    r = tm_tally(0, &a, fx);
    UT_NEAR(r.value[0], V * 14.0 / (2.0 * G), 1e-14);
    UT_NEAR(r.value[4], -V * 1.0, 1e-14);
    UT_NEAR(r.value[5], V * 2.0, 1e-14);
    UT_NEAR(r.value[6], -V * 3.0, 1e-14);
  }
  /* both energies at once, that of the stress with the ledger alone */
  tm_energies energies = tm_energies_nothing();
  for (int i = 0; i < 2; i++) *tm_field_row(&p.state, TM_F_RHO, i) = 1.01 * p.material[1].rho0;
  for (int i = 0; i < 2; i++) {
    const tm_energies e = tm_energies_of(i, &p.state, i == 0 ? TM_FX_LEDGER : 0u);
    UT_TRUE(e.kinetic == tm_kinetic_energy(i, &p.state) && e.stored == (i == 0 ? tm_stored_in(0, &p.state) : 0.0));
    tm_energies_sum(&energies, &e);
  }
  UT_NEAR(energies.kinetic, tm_kinetic_energy(0, &p.state) + tm_kinetic_energy(1, &p.state), 1e-15);
  UT_NEAR(energies.stored, tm_stored_in(0, &p.state), 1e-15);

  /* each particle's row, the unit of energy, sums */
  press(2, tm_sym(7.0, 1.0, 2.0, 3.0, 4.0, 5.0), 0);
  a.to_energy = 0.25;
  tm_tally_result sum = {{0}}, r = tm_tally(2, &a, 0);
  UT_NEAR(r.value[1], -0.25 * V * 7.0, 1e-14);
  for (int k = 0; k < TM_TALLY; k++) UT_TRUE(each[2 * TM_TALLY + k] == r.value[k]);
  a.per_particle = NULL;
  const tm_tally_result again = tm_tally(2, &a, 0);
  tm_tally_sum(&sum, &r);
  tm_tally_sum(&sum, &again);
  for (int k = 0; k < TM_TALLY; k++)
    UT_TRUE(again.value[k] == r.value[k] && sum.value[k] == 2.0 * r.value[k] && r.value[k] != 0.0);
  /* plane stress of thickness 1.25: density and stress of the record count times it */
  p.field[TM_F_THICKNESS][0] = 1.25;
  press(0, tm_sym(0, 0, 0, 6.0, 0, 0), 0);
  a.to_energy = 1.0;
  const double flat = tm_tally(0, &a, 0).value[0];
  records[TM_REC_RHO] *= 1.25;
  tm_sym_store(records + TM_REC_P,
               tm_sym_scale(1.25 / (records[TM_REC_RHO] * records[TM_REC_RHO]), tm_sym(0, 0, 0, 6.0, 0, 0)));
  UT_NEAR(tm_tally(0, &a, TM_FX_PLANE_STRESS).value[0], flat, 1e-14);
  /* the same of the state, at the end of the step */
  p.type[1] = 1;
  p.field[TM_F_RHO][1] = 10.5;
  p.field[TM_F_STRESS][6 + 3] = 4.0;
  UT_NEAR(tm_stored_in(1, &p.state), 8.0 / 10.5 * (32.0 / (4.0 * G) + of_pressure(8.0)), 1e-12);
  p.material[1].body = TM_BODY_HEAT; /* a body of heat stores none */
  UT_TRUE(tm_stored_in(1, &p.state) == 0.0);
  r = tm_tally(2, &a, 0);
  for (int k = 0; k < TM_TALLY; k++) UT_TRUE(r.value[k] == 0.0);
  return ut_summary();
}
