/* States of a particle that cannot go on, each by itself, and the last that can. */
#include "tm_update.h"
#include "ut_state.h"

static ut_particles p;
static double gradient[9 * UT_ROOM], records[TM_REC * UT_ROOM];
static const unsigned EFFECTS = TM_FX_3D | TM_FX_PLASTICITY | TM_FX_HEAT | TM_FX_DAMAGE;

/* one particle of density 10 and sound speed 100 at 300 K, at rest, plastic from a stress of 1 on */
static tm_update_args arrange(void)
{
  tm_update_args a;
  ut_particles_make(&p);
  memset(gradient, 0, sizeof gradient);
  memset(records, 0, sizeof records);
  memset(&a, 0, sizeof a);
  tm_material *m = p.material + 1;
  m->young = 2.5e4;
  m->poisson = 0.25;
  m->shear = 1e4;
  m->bulk = 1e5 / 6.0;
  m->eos_c0 = sqrt(m->bulk / m->rho0);
  m->strength = TM_STRENGTH_JOHNSON_COOK;
  m->jc_a = 1.0;
  m->jc_rate0 = 1.0;
  m->jc_m = 1.0;
  m->t_ref = 300.0;
  m->t_melt = 1000.0;
  m->heat = 1;
  m->capacity.value = 5.0;
  p.field[TM_F_RHO][0] = 10.0;
  p.field[TM_F_TEMP][0] = 300.0;
  records[TM_REC_M] = 2.0;
  records[TM_REC_RHO] = 10.0;
  records[TM_REC_C] = 100.0;
  a.state = p.state;
  a.rec.main = records;
  a.gradient = gradient;
  a.group = 1;
  a.dt = 0.01;
  a.h = 1.0;
  a.accel_unit = 1.0;
  a.hottest = 5000.0;
  a.densest = 3.0;
  a.watch_melt = 1;
  return a;
}

static tm_update_result update(const tm_update_args *a) { return tm_update(0, a, EFFECTS); }

/* equal stretch in three directions by div/3 each */
static void dilate(double div) { gradient[0] = gradient[4] = gradient[8] = div / 3.0; }

static int status_of(double div)
{
  const tm_update_args a = arrange();
  dilate(div);
  return update(&a).status;
}

static void densities(void)
{
  UT_TRUE(status_of(0.0) == TM_OK);
  UT_TRUE(status_of(66.0) == TM_OK); /* 10 (1 - 0.66) */
  UT_TRUE(status_of(67.0) == TM_BAD_VOLUME);
  UT_TRUE(status_of(100.1) == TM_BAD_DENSITY);
  UT_TRUE(status_of(-199.0) == TM_OK);
  UT_TRUE(status_of(-201.0) == TM_BAD_VOLUME);
  tm_update_args a = arrange(); /* debris may spread, but not be pressed together */
  p.field[TM_F_DAMAGE][1] = 1.0;
  dilate(90.0);
  UT_TRUE(update(&a).status == TM_OK);
  a = arrange();
  p.field[TM_F_DAMAGE][1] = 1.0;
  dilate(-201.0);
  UT_TRUE(update(&a).status == TM_BAD_VOLUME);
  a = arrange(); /* another limit */
  a.densest = 20.0;
  dilate(90.0);
  UT_TRUE(update(&a).status == TM_OK);
}

static void strains(void)
{
  tm_update_args a = arrange();
  gradient[1] = 170.0; /* shear of 1.7 in the step: 0.98 plastic strain */
  UT_TRUE(update(&a).status == TM_OK);
  a = arrange();
  gradient[1] = 180.0;
  UT_TRUE(update(&a).status == TM_BAD_STRAIN);
}

static void temperatures(void)
{
  const struct {
    double T;
    int status, melts;
  } cases[] = {{999.0, TM_OK, 0},        {1001.0, TM_OK, 1},           {4999.0, TM_OK, 1},
               {5001.0, TM_BAD_HEAT, 1}, {0.0, TM_BAD_TEMPERATURE, 0}, {-5.0, TM_BAD_TEMPERATURE, 0},
               {NAN, TM_BAD_NAN, 0}};
  for (int k = 0; k < (int) (sizeof cases / sizeof *cases); k++) {
    tm_update_args a = arrange();
    p.field[TM_F_TEMP][0] = cases[k].T;
    tm_update_result r = update(&a);
    UT_TRUE(r.status == cases[k].status);
    UT_TRUE((r.melted == 0) == cases[k].melts);
    a = arrange();
    p.field[TM_F_TEMP][0] = cases[k].T;
    a.watch_melt = 0;
    r = update(&a);
    UT_TRUE(r.melted == INT_MAX);
  }
}

static void others(void)
{
  tm_update_args a = arrange();
  p.v[0] = 999.0;
  UT_TRUE(update(&a).status == TM_OK);
  p.v[0] = 1001.0;
  UT_TRUE(update(&a).status == TM_BAD_VELOCITY);
  a = arrange();
  p.force[1] = NAN;
  UT_TRUE(update(&a).status == TM_BAD_NAN);
}

/* of several particles: the first status, the first that has melted */
static void sums(void)
{
  tm_update_result sum = tm_update_nothing(), r = tm_update_nothing();
  UT_TRUE(sum.melted == INT_MAX && sum.status == TM_OK);
  r.particle = 7;
  r.status = TM_BAD_STRAIN;
  r.melted = 9;
  tm_update_sum(&sum, &r, 0);
  r.particle = 3;
  r.status = TM_BAD_HEAT;
  r.melted = 12;
  tm_update_sum(&sum, &r, 0);
  UT_TRUE(sum.particle == 3 && sum.status == TM_BAD_HEAT && sum.melted == 9);
}

int main(void)
{
  densities();
  strains();
  temperatures();
  others();
  sums();
  return ut_summary();
}
