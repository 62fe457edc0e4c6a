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
  a.type = p.type;
  a.material = p.material;
  a.to_energy = 1.0;
  a.per_particle = each;
  return a;
}

/* particle i of mass 6 and density 3 under the stress */
static void press(int i, tm_sym3 sigma, int form_f14)
{
  double *r = records + TM_REC * i;
  r[TM_REC_M] = 6.0;
  r[TM_REC_RHO] = 3.0;
  tm_sym_store(r + TM_REC_P, tm_sym_scale(form_f14 ? 1.0 : 1.0 / 9.0, sigma));
}

int main(void)
{
  ut_particles_make(&p);
  p.v[3] = 1.0; p.v[4] = -2.0; p.v[5] = 3.0;
  UT_NEAR(tm_kinetic_energy(1, &p.state), 0.5 * 2.0 * 14.0, 1e-15);
  UT_TRUE(tm_kinetic_energy(0, &p.state) == 0.0);
  p.type[1] = 3;                                     /* mass 6 */
  UT_NEAR(tm_kinetic_energy(1, &p.state), 0.5 * 6.0 * 14.0, 1e-15);
  double rmass[2] = {1.0, 8.0};
  p.state.rmass = rmass;
  UT_NEAR(tm_kinetic_energy(1, &p.state), 0.5 * 8.0 * 14.0, 1e-15);

  /* uniaxial stress S: energy V S^2/(2E), E = 9KG/(3K+G) */
  const double G = 80.0, K = 160.0, E = 9.0 * K * G / (3.0 * K + G), V = 2.0;
  p.material[1].shear = G;
  p.material[1].bulk = K;
  tm_tally_args a = args();
  for (int f14 = 0; f14 < 2; f14++) {
    const unsigned fx = f14 ? TM_FX_FORM_F14 : 0u;
    press(0, tm_sym(7.0, 0, 0, 0, 0, 0), f14);
    tm_tally_result r = tm_tally(0, &a, fx);
    UT_NEAR(r.value[0], V * 49.0 / (2.0 * E), 1e-14);
    UT_NEAR(r.value[1], -V * 7.0, 1e-14);
    for (int k = 2; k < TM_TALLY; k++) UT_WITHIN(r.value[k], 0.0, 1e-14);
    press(0, tm_sym(-5.0, -5.0, -5.0, 0, 0, 0), f14);   /* pressure: V p^2/(2K) */
    UT_NEAR(tm_tally(0, &a, fx).value[0], V * 25.0 / (2.0 * K), 1e-14);
    press(0, tm_sym(0, 0, 0, 1.0, -2.0, 3.0), f14);     /* shear: V t^2/(2G); the virial in its order */
    r = tm_tally(0, &a, fx);
    UT_NEAR(r.value[0], V * 14.0 / (2.0 * G), 1e-14);
    UT_NEAR(r.value[4], -V * 1.0, 1e-14);
    UT_NEAR(r.value[5], V * 2.0, 1e-14);
    UT_NEAR(r.value[6], -V * 3.0, 1e-14);
  }
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
  p.material[1].body = TM_BODY_HEAT;                  /* a body of heat stores none */
  r = tm_tally(2, &a, 0);
  for (int k = 0; k < TM_TALLY; k++) UT_TRUE(r.value[k] == 0.0);
  return ut_summary();
}
