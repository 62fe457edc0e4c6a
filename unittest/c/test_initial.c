/* The state new particles start with, the history that the set-up leaves, and the first limits of the time step. */
#include "tm_initial.h"
#include "ut_state.h"

static ut_particles p;

static tm_initial_args initial(unsigned fields)
{
  tm_initial_args a;
  memset(&a, 0, sizeof a);
  a.state = p.state;
  a.fields = fields;
  a.temperature = 350.0;
  return a;
}

static void new_particles(void)
{
  const unsigned all = (1u << TM_F_COUNT) - 1;
  ut_particles_make(&p);
  p.type[1] = 2;
  tm_initial_args a = initial(all);
  p.field[TM_F_TEMP][3 + 1] = 7.0;      /* rates of temperature start with 0 */
  tm_initial_of_new(1, &a);
  UT_TRUE(p.field[TM_F_RHO][1] == 20.0 && p.field[TM_F_BALSARA][1] == 1.0 && p.field[TM_F_THICKNESS][1] == 1.0);
  UT_TRUE(p.field[TM_F_TEMP][3] == 350.0 && p.field[TM_F_TEMP][4] == 0.0 && p.field[TM_F_TEMP][5] == 0.0);
  UT_TRUE(p.field[TM_F_UNSTRAINED][1] == 350.0);
  for (int k = 0; k < 6; k++) UT_TRUE(p.field[TM_F_STRESS][6 + k] == 0.0);
  UT_TRUE(p.field[TM_F_PSTRAIN][3] == 0.0 && p.field[TM_F_RHO][0] == 0.0 && p.field[TM_F_RHO][2] == 0.0);

  a.temperature = 400.0;                /* it is not new any more */
  p.field[TM_F_RHO][1] = 19.0;
  tm_initial_of_new(1, &a);
  UT_TRUE(p.field[TM_F_RHO][1] == 19.0 && p.field[TM_F_TEMP][3] == 350.0);

  a = initial(1u << TM_F_TEMP);         /* only the fields that are asked for */
  tm_initial(2, &a);
  UT_TRUE(p.field[TM_F_TEMP][6] == 350.0 && p.field[TM_F_RHO][2] == 0.0 && p.field[TM_F_BALSARA][2] == 0.0);
  a = initial(1u << TM_F_RHO);
  tm_initial(3, &a);
  UT_TRUE(p.field[TM_F_RHO][3] == 10.0 && p.field[TM_F_TEMP][9] == 0.0 && p.field[TM_F_THICKNESS][3] == 0.0);
}

static double gradient[9 * UT_ROOM], records[TM_REC * UT_ROOM];

static tm_update_args update(void)
{
  tm_update_args a;
  memset(&a, 0, sizeof a);
  a.state = p.state;
  a.rec.main = records;
  a.gradient = gradient;
  a.group = 1;
  a.h = 0.5;
  a.visc_alpha = 0.25;
  a.accel_unit = 3.0;
  a.heat_rate = 2.0;
  a.k_max = 8.0;
  return a;
}

/* one particle of mass 2 and density 5 in a known velocity gradient */
static void arrange(void)
{
  ut_particles_make(&p);
  p.material[1].shear = 4.0;
  p.material[1].heat = 1;
  p.material[1].conductivity.value = 8.0;
  p.material[1].capacity.value = 6.0;
  p.force[0] = 4.0; p.force[1] = -8.0; p.force[2] = 2.0;
  p.field[TM_F_RHO][0] = 5.0;
  p.field[TM_F_TEMP][0] = 300.0;
  memset(gradient, 0, sizeof gradient);
  gradient[0] = 0.3;                    /* stretch along x and a shear v_x = 0.2 y */
  gradient[1] = 0.2;
  p.field[TM_F_STRESS][0] = 1.5; p.field[TM_F_STRESS][1] = -1.5;
  records[TM_REC_C] = 10.0;
}

static void history(void)
{
  const double *h = p.field[TM_F_HISTORY];
  arrange();
  tm_update_args a = update();
  tm_initial_limits(0, &a, TM_FX_3D, 1);
  UT_TRUE(h[TM_H_V] == 6.0 && h[TM_H_V + 1] == -12.0 && h[TM_H_V + 2] == 3.0);   /* 3 f/m */
  UT_NEAR(h[TM_H_RHO], -5.0 * 0.3, 1e-15);
  /* 2G dev D = 8 (0.2, -0.1, -0.1; 0.1) plus the turn of s: w_xy = 0.1, W s - s W = (2 w s_xy, ..; w (s_yy - s_xx)),
     less s tr(D)/2 */
  UT_NEAR(h[TM_H_S], 1.6 - 0.15 * 1.5, 1e-15);
  UT_NEAR(h[TM_H_S + 1], -0.8 + 0.15 * 1.5, 1e-15);
  UT_NEAR(h[TM_H_S + 2], -0.8, 1e-15);
  UT_NEAR(h[TM_H_S + 3], 0.8 - 0.3, 1e-15);
  for (int k = 0; k < TM_H_STEP; k++) UT_TRUE(h[TM_H_STEP + k] == h[k]);   /* two steps back the same */

  arrange();                            /* no history where it is not asked for */
  a = update();
  tm_initial_limits(0, &a, TM_FX_3D, 0);
  for (int k = 0; k < TM_H_COLUMNS; k++) UT_TRUE(h[k] == 0.0);
  arrange();                            /* not of the group: nothing accelerates it */
  p.mask[0] = 2;
  a = update();
  const tm_update_result free_of_force = tm_initial_limits(0, &a, TM_FX_3D, 1);
  UT_TRUE(h[TM_H_V] == 0.0 && h[TM_H_RHO] != 0.0 && free_of_force.dt[TM_DT_FORCE] == 1e300);
  arrange();                            /* in two dimensions nothing along z */
  a = update();
  tm_initial_limits(0, &a, 0, 1);
  UT_TRUE(h[TM_H_V + 1] == -12.0 && h[TM_H_V + 2] == 0.0);
  arrange();                            /* a fluid has no stress, a body of heat no history */
  p.material[1].strength = TM_STRENGTH_NONE;
  a = update();
  tm_initial_limits(0, &a, TM_FX_3D, 1);
  UT_TRUE(h[TM_H_S] == 0.0 && h[TM_H_RHO] != 0.0);
  arrange();
  p.material[1].body = TM_BODY_HEAT;
  a = update();
  const tm_update_result heat = tm_initial_limits(0, &a, TM_FX_3D | TM_FX_CONDUCTION, 1);
  UT_TRUE(h[TM_H_V] == 0.0 && h[TM_H_RHO] == 0.0);
  UT_TRUE(heat.dt[TM_DT_SOUND] == 1e300 && heat.dt[TM_DT_FORCE] == 1e300 && heat.dt[TM_DT_CONDUCTION] < 1e300);
}

static void limits(void)
{
  arrange();
  tm_update_args a = update();
  tm_update_result r = tm_initial_limits(0, &a, TM_FX_3D, 0);
  UT_NEAR(r.dt[TM_DT_SOUND], 0.05, 1e-15);                            /* h/c */
  UT_NEAR(r.dt[TM_DT_FORCE], sqrt(0.5 / sqrt(36.0 + 144.0 + 9.0)), 1e-15);
  UT_TRUE(r.dt[TM_DT_CONDUCTION] == 1e300 && r.status == TM_OK);
  r = tm_initial_limits(0, &a, TM_FX_3D | TM_FX_CONDUCTION, 0);
  UT_NEAR(r.dt[TM_DT_CONDUCTION], 0.5 * 5.0 * 6.0 * 0.25 / (2.0 * 8.0), 1e-15);
  a.visc_alpha = 2.0;
  r = tm_initial_limits(0, &a, TM_FX_3D, 0);
  UT_NEAR(r.dt[TM_DT_SOUND], 0.0125, 1e-15);                          /* less 2 alpha */
  p.force[0] = p.force[1] = p.force[2] = 0.0;
  r = tm_initial_limits(0, &a, TM_FX_3D, 0);
  UT_TRUE(r.dt[TM_DT_FORCE] == 1e300);
}

int main(void)
{
  new_particles();
  history();
  limits();
  return ut_summary();
}
