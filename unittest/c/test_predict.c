/* The prediction of the half step against histories that are polynomials in time, and the record it writes. */
#include "tm_predict.h"
#include "ut_state.h"

static ut_particles p;
static double records[TM_REC * UT_ROOM], heat[TM_REC_HEAT * UT_ROOM];
static const double DT = 0.02;

static tm_predict_args arrange(void)
{
  tm_predict_args a;
  ut_particles_make(&p);
  memset(&a, 0, sizeof a);
  tm_material *m = p.material + 1;
  m->young = 2.5e4;
  m->poisson = 0.25;
  m->shear = 1e4;
  m->bulk = 1e5 / 6.0;
  m->eos_c0 = sqrt(m->bulk / m->rho0);
  m->strength = TM_STRENGTH_PLASTIC;
  m->yield = 100.0;
  m->conductivity.n = 2;
  m->conductivity.t[1] = 1000.0;
  m->conductivity.y[1] = 50.0;
  p.field[TM_F_RHO][0] = 10.0;
  p.field[TM_F_TEMP][0] = 300.0;
  p.field[TM_F_THICKNESS][0] = 1.0;
  a.state = p.state;
  a.rec.main = records;
  a.rec.heat = heat;
  a.dt_ahead = 0.5 * DT;
  return a;
}

/* y0 + y1 t + y2 t^2 at t = 0 with its mean rates over the last two steps, as the corrector leaves them */
static double value(const double y[3], double t) { return y[0] + t * (y[1] + t * y[2]); }
static double rate_of_step(const double y[3], int back)
{
  return (value(y, -back * DT + DT) - value(y, -back * DT)) / DT;
}

/* the state of particle 0 from one polynomial per component: v (3), rho, s (6), T */
static void history(double y[11][3])
{
  double *h = p.field[TM_F_HISTORY];
  for (int k = 0; k < 3; k++) p.v[k] = y[k][0];
  p.field[TM_F_RHO][0] = y[3][0];
  for (int k = 0; k < 6; k++) p.field[TM_F_STRESS][k] = y[4 + k][0];
  p.field[TM_F_TEMP][0] = y[10][0];
  for (int k = 0; k < TM_H_STEP; k++) {
    h[k] = rate_of_step(y[k], 1);
    h[TM_H_STEP + k] = rate_of_step(y[k], 2);
  }
  p.field[TM_F_TEMP][1] = rate_of_step(y[10], 1);
  p.field[TM_F_TEMP][2] = rate_of_step(y[10], 2);
}

/* Linear histories come out exactly. Of a parabola with curvature y2 the mean rates lie half a step back: 3/4 (y1 - y2 dt)
   - 1/4 (y1 - 3 y2 dt) = y1/2, so the error is y2 (dt/2)^2, of second order. */
static void weights(void)
{
  const tm_predict_weights w = tm_predict_weights_at(0.5 * DT);
  UT_NEAR(w.last, 0.75 * DT, 1e-15);
  UT_NEAR(w.older, -0.25 * DT, 1e-15);
  for (int curved = 0; curved < 2; curved++) {
    const tm_predict_args a = arrange();
    double y[11][3];
    for (int k = 0; k < 11; k++) {
      y[k][0] = k == 3 ? 10.0 : k == 10 ? 300.0 : ut_random(-5, 5);
      y[k][1] = ut_random(-5, 5);
      y[k][2] = curved ? ut_random(-5, 5) : 0.0;
    }
    history(y);
    tm_predict(0, &a, TM_FX_3D | TM_FX_HEAT | TM_FX_PLASTICITY | TM_FX_FORM_F14);
    const double have[5] = {records[TM_REC_V], records[TM_REC_V + 2], records[TM_REC_RHO], records[TM_REC_P + 3], heat[TM_REC_T]};
    const int which[5] = {0, 2, 3, 7, 10};
    for (int k = 0; k < 5; k++)
      UT_WITHIN(have[k], value(y[which[k]], 0.5 * DT) - 0.25 * y[which[k]][2] * DT * DT, 1e-12 * (1 + fabs(have[k])));
    UT_NEAR(heat[TM_REC_K], 50.0 * heat[TM_REC_T] / 1000.0, 1e-14);
  }
}

/* the record is made of the predicted values: pressure and sound speed of the predicted density, sigma/rho^2 */
static void record(void)
{
  tm_predict_args a = arrange();
  p.x[0] = 0.3;
  p.field[TM_F_HISTORY][TM_H_RHO] = p.field[TM_F_HISTORY][TM_H_STEP + TM_H_RHO] = 8.0;
  p.field[TM_F_STRESS][0] = 6.0;
  p.field[TM_F_STRESS][1] = p.field[TM_F_STRESS][2] = -3.0;
  tm_predict(0, &a, TM_FX_3D | TM_FX_PLASTICITY);
  const double rho = 10.0 + 0.5 * DT * 8.0, pressure = 1e5 / 6.0 * (rho / 10.0 - 1.0);
  UT_NEAR(records[TM_REC_RHO], rho, 1e-14);
  UT_NEAR(records[TM_REC_P], (6.0 - pressure) / (rho * rho), 1e-12);
  UT_NEAR(records[TM_REC_P + 1], (-3.0 - pressure) / (rho * rho), 1e-12);
  UT_NEAR(records[TM_REC_C], sqrt(1e5 / 60.0 + 4.0 / 3.0 * 1e4 / rho), 1e-13);
  UT_TRUE(records[TM_REC_X] == 0.3 && records[TM_REC_M] == 2.0 && records[TM_REC_BALSARA] == 1.0);
  UT_TRUE(p.field[TM_F_RHO][0] == 10.0);    /* the state stays */

  a.dt_ahead = 0.0;                         /* at the set-up: the state itself */
  tm_predict(0, &a, TM_FX_3D | TM_FX_PLASTICITY);
  UT_TRUE(records[TM_REC_RHO] == 10.0 && records[TM_REC_P] == 6.0 / 100.0);
}

/* failed material: no deviator, no tension, and the pressure of compression */
static void failed(void)
{
  for (int pressed = 0; pressed < 2; pressed++) {
    const tm_predict_args a = arrange();
    p.field[TM_F_DAMAGE][1] = 1.0;
    p.field[TM_F_RHO][0] = pressed ? 10.1 : 9.9;
    p.field[TM_F_STRESS][3] = 5.0;
    tm_predict(0, &a, TM_FX_3D | TM_FX_PLASTICITY | TM_FX_DAMAGE);
    UT_NEAR(records[TM_REC_P], pressed ? -1e5 / 6.0 * 0.01 / (10.1 * 10.1) : 0.0, 1e-12);
    UT_TRUE(records[TM_REC_P + 3] == 0.0);
  }
}

/* the same in plane stress, times the thickness */
static void failed_plate(void)
{
  for (int pressed = 0; pressed < 2; pressed++) {
    const tm_predict_args a = arrange();
    const double rho = pressed ? 10.1 : 9.9, sum = 0.9 * rho;
    p.field[TM_F_DAMAGE][1] = 1.0;
    p.field[TM_F_RHO][0] = rho;
    p.field[TM_F_THICKNESS][0] = 0.9;
    p.field[TM_F_STRESS][0] = 5.0;
    tm_predict(0, &a, TM_FX_PLASTICITY | TM_FX_DAMAGE | TM_FX_PLANE_STRESS);
    for (int k = 0; k < 3; k++) UT_NEAR(records[TM_REC_P + k], pressed ? -1e5 / 6.0 * 0.01 * 0.9 / (sum * sum) : 0.0, 1e-12);
  }
}

/* thermal expansion: the pressure of the density that the mass would have without thermal strain, at T of the half step */
static void expansion(void)
{
  const tm_predict_args a = arrange();
  p.material[1].expansion.value = 1e-4;
  p.field[TM_F_UNSTRAINED][0] = 290.0;
  p.field[TM_F_TEMP][1] = 1000.0 / DT; /* weights 3/4 and -1/4 */
  p.field[TM_F_TEMP][2] = 1000.0 / DT;
  tm_predict(0, &a, TM_FX_3D | TM_FX_HEAT | TM_FX_EXPANSION);
  const double eps = 1e-4 * (300.0 + 500.0 - 290.0);
  UT_NEAR(records[TM_REC_P], -1e5 / 6.0 * ((1.0 + eps) * (1.0 + eps) * (1.0 + eps) - 1.0) / 100.0, 1e-12);
  UT_NEAR(heat[TM_REC_T], 800.0, 1e-14);
}

/* plane stress: sigma_zz = 0 whatever the density, and sums run over areas of the thickness */
static void plane_stress(void)
{
  const tm_predict_args a = arrange();
  p.field[TM_F_RHO][0] = 10.4;
  p.field[TM_F_THICKNESS][0] = 0.9;
  p.field[TM_F_STRESS][0] = 6.0;
  p.field[TM_F_STRESS][1] = -2.0;
  p.field[TM_F_STRESS][2] = -4.0;
  tm_predict(0, &a, TM_FX_PLASTICITY | TM_FX_PLANE_STRESS);
  UT_WITHIN(records[TM_REC_P + 2], 0.0, 1e-16);
  UT_NEAR(records[TM_REC_RHO], 10.4 * 0.9, 1e-15);
  UT_NEAR(records[TM_REC_P], (6.0 + 4.0) * 0.9 / (10.4 * 0.9 * 10.4 * 0.9), 1e-14);    /* thickness times sigma */
}

int main(void)
{
  weights();
  record();
  failed();
  failed_plate();
  expansion();
  plane_stress();
  return ut_summary();
}
