/* The layer between centers and the surface of a tool: its thickness, the count of steps, and a particle that is squeezed against
   a floor: penetration, stress for the next step, and the books of energy; in a corner; with two tools. */
#include "ut_contact.h"

#include "tm_contact_layer.h"

static void thickness(void)
{
  tm_real slope;
  UT_NEAR(tm_layer_stretch(0.0, &slope), 1.0, 1e-15);
  UT_NEAR(slope, 1.0, 1e-15);
  UT_NEAR(tm_layer_stretch(log(0.8), &slope), 0.8, 1e-3);
  UT_NEAR(tm_layer_stretch(log(0.6), &slope), 0.6, 0.01);
  UT_TRUE(tm_layer_stretch(1e6, &slope) <= TM_LAYER_REACH);
  UT_NEAR(tm_layer_stretch(-1e6, &slope), exp(-TM_LAYER_LEAST), 1e-12);
  for (double x = -3.0; x < 3.0; x += 0.0625) { /* its derivative, which is smooth at 0 */
    const double d = 1e-5, more = tm_layer_stretch(x + d, &slope), less = tm_layer_stretch(x - d, &slope);
    tm_layer_stretch(x, &slope);
    UT_TRUE(fabs((more - less) / (2 * d) - slope) < 1e-8);
    UT_TRUE(slope > 0.0 && slope < 1.5);
  }
}

/* The stress is that of the next step alone; the strain is kept for some steps more. */
static void countdown(void)
{
  tm_real row[TM_L_COLUMNS * TM_BLOCK] = {0};
  tm_layer_end_of_step(row);
  UT_TRUE(tm_layer_stress(row).zz == 0.0 && row[tm_column(TM_L_NEAR)] == 0.0);
  tm_sym_to_row(row + tm_column(TM_L_STRESS), tm_sym(1, 2, 3, 4, 5, 6));
  row[tm_column(TM_L_NEAR)] = TM_LAYER_NOW;
  tm_layer_end_of_step(row);
  const tm_sym3 T = tm_layer_stress(row);
  UT_TRUE(T.xx == 1 && T.zz == 3 && T.yz == 6);
  for (int n = 2; n < 7; n++) {
    tm_layer_end_of_step(row);
    UT_TRUE(row[tm_column(TM_L_NEAR)] == tm_max(TM_LAYER_NOW - n, 0.0) && tm_layer_stress(row).zz == 0.0);
  }
}

static ut_scene s;
static tm_real layer[TM_L_COLUMNS * TM_BLOCK], gradient[9 * TM_BLOCK], record[TM_REC * TM_BLOCK];
static const double dp = 0.02, heavy = 1e12; /* so that it stays at rest */

static void floor_scene(double stiffness, double damping)
{
  tm_soup soup = ut_soup(2 * 20 * 20);
  ut_sheet(&soup, tm_vec(-1, -1, 0), tm_vec(2, 0, 0), tm_vec(0, 2, 0), 20, 20);
  ut_arrange(&s, &soup, dp);
  s.law[1].stiffness = stiffness;
  s.law[1].damping = damping;
  s.mass[1] = heavy;
  memset(layer, 0, sizeof layer);
  memset(gradient, 0, sizeof gradient);
  memset(record, 0, sizeof record);
  record[tm_part(TM_REC_M)] = 1.0;
  record[tm_part(TM_REC_RHO)] = 1.0 / (dp * dp * dp);
  s.args.record = record;
  s.args.layer = layer;
  s.law[1].layer = 1;
  s.args.gradient = gradient;
  s.args.tool = 7.0;
}

/* A center at rest whose surroundings are squeezed along the normal: the layer becomes thinner as it should, its power is
   what the spring loses and damping takes, and the stress is that of the force of the next step. */
static void squeezed(double damping)
{
  floor_scene(100.0, damping);
  const double rate = -0.5, dt = s.args.dt = s.args.layer_dt = 1e-3, distance = 0.55 * 0.5 * dp, V = dp * dp * dp;
  s.args.after = 0.5 * dt;
  gradient[tm_column(8)] = rate;
  gradient[tm_column(1)] = 0.2; /* does not count along z */
  double stored = -1.0, work = 0.0, damped = 0.0, next = 0.0;
  for (int n = 0; n < 1300; n++) {
    ut_put(&s, 0, tm_vec(0.1, 0.1, distance), tm_vec(0, 0, 0));
    const tm_contact_result r = tm_contact_tri(0, &s.args, TM_CT_3D);
    tm_real slope;
    const double time = (n + 0.5) * dt, e = 0.5 * dp * tm_layer_stretch(rate * time, &slope);
    UT_NEAR(r.depth, e - distance, 1e-9);
    const double closing = rate * slope * 0.5 * dp;
    const double f = tm_max(100.0 * (e - distance) + tm_contact_damping(damping, 100.0, heavy) * closing, 0.0);
    UT_NEAR(s.f[2], f, 1e-9);
    UT_NEAR(r.inner, 0.0, 1e-15);
    UT_NEAR(r.within, 0.5 * dp - distance, 1e-12);
    UT_NEAR(layer[tm_column(TM_L_STRAIN)], (n + 1) * dt * rate, 1e-12);
    if (n > 1) UT_NEAR(next, f * slope * 0.5 * dp / V, 2e-3); /* predicted a step ago */
    tm_layer_end_of_step(layer);
    next = tm_layer_stress(layer).zz;
    if (n == 0) UT_NEAR(next, 2 * f * 0.5 * dp / V, 5e-3); /* and what was lacking in the first step */
    UT_TRUE(r.particle_power < 1e-12 && r.tool_power == 0.0);
    if (n > 0) {
      work += dt * f * slope * 0.5 * dp * rate;
      damped += dt * r.damping_power;
      UT_NEAR(r.spring - stored, work - damped, 2e-3); /* of the ends of steps */
    } else stored = r.spring;
    if (f == 0.0 || r.depth < 0.1 * 0.5 * dp) return;
  }
  UT_TRUE(0);
}

/* At the bound of the strain the layer stays as it is: its thickness, without work and without stress; and takes up again
   when the strain turns. The spring keeps what it stores. */
static void ended(void)
{
  floor_scene(100.0, 0.0);
  const double dt = s.args.dt = s.args.layer_dt = 1e-2, distance = 0.1 * dp;
  tm_real slope;
  double depth = 0.0, spring = 0.0;
  gradient[tm_column(8)] = -0.7;
  for (int n = 0; n < 400; n++) {
    ut_put(&s, 0, tm_vec(0.1, 0.1, distance), tm_vec(0, 0, 0));
    const tm_contact_result r = tm_contact_tri(0, &s.args, TM_CT_3D);
    const double x = layer[tm_column(TM_L_STRAIN)];
    tm_layer_end_of_step(layer);
    UT_TRUE(x >= -TM_LAYER_BOUND);
    if (n > 300) {
      UT_TRUE(x < -TM_LAYER_BOUND + 0.7 * dt);
      UT_NEAR(r.depth, 0.5 * dp * tm_layer_stretch(x, &slope) - distance, 1e-12);
      UT_TRUE(r.damping_power == 0.0 && tm_layer_stress(layer).zz == 0.0 && s.f[2] > 0.0);
      if (n > 301) UT_TRUE(r.depth == depth && r.spring == spring);
      depth = r.depth;
      spring = r.spring;
    }
  }
  gradient[tm_column(8)] = 0.7;
  ut_put(&s, 0, tm_vec(0.1, 0.1, distance), tm_vec(0, 0, 0));
  tm_contact_tri(0, &s.args, TM_CT_3D);
  UT_TRUE(layer[tm_column(TM_L_STRAIN)] > -TM_LAYER_BOUND + 0.7 * dt - 1e-12);
  tm_layer_end_of_step(layer);
  UT_TRUE(tm_layer_stress(layer).zz > 0.0);
}

/* A second tool in the step finds half a spacing; a tool that is far is forgotten; one that is near without touching is not. */
static void nearness(void)
{
  floor_scene(100.0, 0.0);
  s.args.dt = s.args.layer_dt = 1e-3;
  gradient[tm_column(8)] = -1.0;
  ut_put(&s, 0, tm_vec(0.1, 0.1, 0.45 * dp), tm_vec(0, 0, 0));
  tm_contact_tri(0, &s.args, TM_CT_3D);
  const double stress = layer[tm_column(TM_L_STRESS + 2)];
  UT_TRUE(stress > 0.0 && layer[tm_column(TM_L_TOOL)] == 7.0);
  s.args.tool = 8.0;
  UT_NEAR(ut_force_at(&s, tm_vec(0.1, 0.1, 0.45 * dp), 0).z, 100.0 * 0.05 * dp, 1e-9);
  s.args.tool = 7.0;
  UT_NEAR(layer[tm_column(TM_L_STRAIN)], -1e-3, 1e-12);
  UT_TRUE(layer[tm_column(TM_L_STRESS + 2)] == stress && layer[tm_column(TM_L_TOOL)] == 7.0);
  tm_layer_end_of_step(layer);
  layer[tm_column(TM_L_STRAIN)] = -0.4; /* thinner than the distance: near, not touched */
  ut_put(&s, 0, tm_vec(0.1, 0.1, 0.45 * dp), tm_vec(0, 0, 0));
  UT_TRUE(tm_contact_tri(0, &s.args, TM_CT_3D).depth == 0.0 && s.f[2] == 0.0);
  UT_NEAR(layer[tm_column(TM_L_STRAIN)], -0.401, 1e-12);
  UT_TRUE(layer[tm_column(TM_L_NEAR)] == TM_LAYER_NOW);
  UT_NEAR(layer[tm_column(TM_L_STRESS + 2)], -0.5 * stress,
          1e-2); /* taken back: it was predicted, and there was no force */
  for (int n = 0; n < 4; n++) {
    tm_layer_end_of_step(layer);
    ut_put(&s, 0, tm_vec(0.1, 0.1, 0.51 * dp), tm_vec(0, 0, 0));
    tm_contact_tri(0, &s.args, TM_CT_3D);
  }
  UT_TRUE(layer[tm_column(TM_L_NEAR)] == 0.0);
  gradient[tm_column(8)] = 0.0;
  s.args.tool = 8.0;
  UT_NEAR(ut_force_at(&s, tm_vec(0.1, 0.1, 0.45 * dp), 0).z, 100.0 * 0.05 * dp,
          1e-9); /* as it was made, for any tool */
  UT_TRUE(layer[tm_column(TM_L_TOOL)] == 8.0);
  layer[tm_column(TM_L_STRAIN)] = 0.2; /* thicker: touched from farther */
  tm_real slope;
  UT_NEAR(ut_force_at(&s, tm_vec(0.1, 0.1, 0.55 * dp), 0).z, 100.0 * dp * (0.5 * tm_layer_stretch(0.2, &slope) - 0.55),
          1e-9);
}

/* A second tool that presses from the other side is counted; one beside the first, or at a right angle to it, is not. */
static void faced(void)
{
  const tm_mat3 turns[] = {tm_mat_identity(), {1, 0, 0, 0, -1, 0, 0, 0, -1}, {0, 0, 1, 0, 1, 0, -1, 0, 0}};
  for (int k = 0; k < 3; k++) {
    floor_scene(100.0, 0.0);
    s.args.dt = s.args.layer_dt = 1e-3;
    const tm_pose pose = s.args.pose;
    ut_put(&s, 0, tm_vec(0, 0, 0.4 * dp), tm_vec(0, 0, 0));
    UT_TRUE(tm_contact_tri(0, &s.args, TM_CT_3D).faced == 0);
    /* the other surface is the first one, turned about the particle */
    s.args.tool = 8.0;
    s.args.pose.turn = turns[k];
    s.args.pose.shift = tm_vec_sub(tm_vec(0, 0, 0.4 * dp), tm_mat_mul_vec(turns[k], tm_vec(0, 0, 0.4 * dp)));
    const tm_contact_result r = tm_contact_tri(0, &s.args, TM_CT_3D);
    UT_TRUE(r.contacts == 1 && r.faced == (k == 1));
    s.args.pose = pose;
  }
}

/* A concave corner of two walls, touched equally: the strain is the mean of both directions, and so is the stress. */
static void corner(void)
{
  floor_scene(100.0, 0.0);
  tm_soup soup = ut_soup(4 * 20 * 20);
  ut_sheet(&soup, tm_vec(-1, -1, 0), tm_vec(2, 0, 0), tm_vec(0, 2, 0), 20, 20);
  ut_sheet(&soup, tm_vec(-1, -1, 0), tm_vec(0, 2, 0), tm_vec(0, 0, 2), 20, 20);
  ut_clear(&s);
  ut_arrange(&s, &soup, dp);
  s.law[1].stiffness = 100.0;
  s.args.record = record;
  s.args.layer = layer;
  s.law[1].layer = 1;
  s.args.gradient = gradient;
  s.args.tool = 7.0;
  s.args.layer_dt = s.args.dt = 1e-3;
  gradient[tm_column(0)] = -0.4;
  gradient[tm_column(8)] = -0.2;
  ut_put(&s, 0, tm_vec(-1 + 0.45 * dp, 0.1, 0.45 * dp), tm_vec(0, 0, 0));
  const tm_contact_result r = tm_contact_tri(0, &s.args, TM_CT_3D);
  UT_TRUE(r.contacts == 2);
  UT_NEAR(s.f[0], s.f[2], 1e-9);
  UT_NEAR(layer[tm_column(TM_L_STRAIN)], -0.3e-3, 1e-9);
  UT_NEAR(layer[tm_column(TM_L_STRESS)], layer[tm_column(TM_L_STRESS + 2)], 1e-9);
  UT_NEAR(layer[tm_column(TM_L_STRESS)] * dp * dp * dp, 2 * 0.5 * dp * s.f[0], 1e-2); /* that of the first step too */
  ut_clear(&s);
}

int main(void)
{
  thickness();
  countdown();
  squeezed(0.0);
  squeezed(3e-7);
  ended();
  nearness();
  faced();
  corner();
  return ut_summary();
}
