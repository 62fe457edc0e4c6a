/* Dynamic relaxation: the frequency of an oscillator is found, critical damping, energy taken, two modes. */
#include "tm_relax.h"
#include "ut_state.h"

static ut_particles p;
static tm_relax_args a;
static double record[2 * TM_REC];

static void make(void)
{
  ut_particles_make(&p);
  memset(record, 0, sizeof record);
  memset(&a, 0, sizeof a);
  a.state = p.state;
  a.rec.main = record;
  a.group = 1;
  a.act = 1;
  a.accel_unit = 1;
  p.material[1].body = TM_BODY_SOLID;
  for (int i = 0; i < 2; i++) record[i * TM_REC + TM_REC_M] = record[i * TM_REC + TM_REC_RHO] = 2;
}

/* two oscillators of mass 2, w1 and w2; returns the number of steps until both have lost all but 1e-4 */
static int relax(double w1, double w2, double fixed, double dt, double *taken)
{
  tm_relax_mode mode = {0, 0, 0, 0, 0};
  double x[2] = {1, 1}, v[2] = {0, 0}, c = fixed;
  const double w[2] = {w1, w2};
  *taken = 0;
  make();
  for (int step = 1; step < 200000; step++) {
    tm_relax_result r = tm_relax_nothing();
    double most = 0;
    a.dt = dt;
    a.damping = c;
    for (int i = 0; i < 2; i++) {
      p.v[3 * i] = v[i];
      p.force[3 * i] = -2 * w[i] * w[i] * (x[i] + 0.5 * dt * v[i]);
      const double before = p.force[3 * i];
      const tm_relax_result one = tm_relax(i, &a, 0);
      tm_relax_sum(&r, &one);
      const double v0 = v[i];
      v[i] += dt * p.force[3 * i] / 2;
      const double mean = 0.5 * (v0 + v[i]);
      UT_WITHIN(p.force[3 * i] - before, -c * 2 * mean, 1e-12 * (1 + fabs(before)));
      *taken += dt * c * 2 * mean * mean;
      x[i] += 0.5 * dt * (v0 + v[i]);
      most = tm_max(most, fabs(x[i]));
    }
    if (fixed == 0) c = tm_relax_damping(&mode, &r, c, dt);
    if (most < 1e-4 && fabs(v[0]) < 1e-4 * w1 && fabs(v[1]) < 1e-4 * w2) return step;
  }
  return 200000;
}

int main(void)
{
  double taken;
  /* the frequency without damping */
  for (double w = 0.5; w < 40; w *= 3) {
    tm_relax_mode mode = {0, 0, 0, 0, 0};
    double x = 1, v = 0, c = 0;
    const double dt = 0.01 / w;
    make();
    a.dt = dt;
    for (int step = 0; step < 400; step++) {
      p.v[0] = v;
      p.force[0] = -2 * w * w * (x + 0.5 * dt * v);
      const tm_relax_result r = tm_relax(0, &a, 0);
      c = tm_relax_damping(&mode, &r, 0, dt);
      const double v0 = v;
      v += dt * p.force[0] / 2;
      x += 0.5 * dt * (v0 + v);
    }
    UT_NEAR(c, 2 * w, 0.01);
  }
  /* one mode: as fast as with the damping that is critical for it; all energy is taken */
  const int critical = relax(1, 1, 2, 0.01, &taken), found = relax(1, 1, 0, 0.01, &taken);
  UT_NEAR(taken, 2, 0.01);
  UT_TRUE(found < 1.5 * critical);
  /* two modes, 1 : 30: not slower than three times what the slow one needs */
  UT_TRUE(relax(1, 30, 0, 0.002, &taken) < 3 * relax(1, 1, 2, 0.002, &taken));
  /* stable whatever the damping is */
  make();
  a.dt = 1;
  a.damping = 1e6;
  p.v[0] = 3;
  tm_relax(0, &a, 0);
  UT_WITHIN(3 + p.force[0] / 2, -3, 1e-4);
  /* not of the group, conduction only: nothing */
  p.mask[0] = 2;
  p.force[0] = 5;
  UT_TRUE(tm_relax(0, &a, 0).unbalanced == 0 && p.force[0] == 5);
  p.mask[0] = 1;
  p.material[1].body = TM_BODY_HEAT;
  UT_TRUE(tm_relax(0, &a, 0).unbalanced == 0 && p.force[0] == 5);
  /* driven in y: damped and summed in x alone */
  p.material[1].body = TM_BODY_SOLID;
  p.v[0] = 2;
  p.v[1] = 8;
  p.force[0] = p.force[1] = 0;
  a.damping = 0.5;
  a.driven[1] = 1;
  const tm_relax_result r = tm_relax(0, &a, 0);
  UT_TRUE(p.force[0] < 0 && p.force[1] == 0);
  UT_NEAR(r.momentum2, tm_particle_mass(&a.state, 0) * 1.6 * 1.6, 1e-15);
  a.driven[1] = 2; /* of another group */
  tm_relax(0, &a, 0);
  UT_TRUE(p.force[1] < 0);
  a.driven[1] = 0;
  p.v[0] = p.v[1] = p.force[1] = 0;
  p.force[0] = 5;
  /* what a particle carries: stress times its face */
  p.material[1].body = TM_BODY_SOLID;
  record[TM_REC_M] = 16;
  record[TM_REC_P] = 3; /* sigma/rho^2, rho 2, volume 8 */
  a.act = 0;
  UT_NEAR(tm_relax(0, &a, TM_FX_3D).carried, 12 * 4, 1e-14);
  UT_NEAR(tm_relax(0, &a, 0).carried, 12 * sqrt(8), 1e-14);
  UT_NEAR(tm_relax(0, &a, TM_FX_FORM_F14).carried, 3 * sqrt(8), 1e-14);
  UT_TRUE(p.force[0] == 5);
  return ut_summary();
}
