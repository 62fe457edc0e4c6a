/* Contact with tools in the particle loop: a particle that bounces, friction that holds and never reverses, and the
   books of momentum, energy and heat. The laws by themselves: test_contact_law.c. */
#include "ut_contact.h"

/* --- one particle and a floor --------------------------------------------------------------- */

static const double dp = 0.02, r = 0.01;
static ut_scene s;

static void floor_scene(void)
{
  tm_soup soup = ut_soup(2 * 20 * 20);
  ut_sheet(&soup, tm_vec(-1, -1, 0), tm_vec(2, 0, 0), tm_vec(0, 2, 0), 20, 20);
  ut_arrange(&s, &soup, dp);
}

/* One step of the state fix's scheme: half a drift, forces, kick, half a drift. */
static tm_contact_result step(int i, tm_vec3 weight, unsigned effects)
{
  double *x = s.x + 3 * i, *v = s.v + 3 * i, *f = s.f + 3 * i;
  for (int d = 0; d < 3; d++) x[d] += 0.5 * s.args.dt * v[d];
  f[0] = weight.x; f[1] = weight.y; f[2] = weight.z;
  const tm_contact_result out = tm_contact_tri(i, &s.args, effects | TM_CT_3D);
  for (int d = 0; d < 3; d++) {
    v[d] += s.args.dt / s.mass[1] * f[d];
    x[d] += 0.5 * s.args.dt * v[d];
  }
  return out;
}

/* 1000 bounces under gravity without damping: the energy of flight must not grow. */
static void bounce(void)
{
  floor_scene();
  s.law[1].stiffness = 1.0e4;       /* w = 100, contact lasts about 0.03 */
  s.args.dt = 0.04 / 100.0 * 1.37;  /* 57 steps per contact, in no ratio to the bounce */
  const double g = 9.81, height = 0.013;
  ut_put(&s, 0, tm_vec(0.013, 0.017, r + height), tm_vec(0, 0, 0));
  double highest = 0.0, lowest = 1.0, top = 0.0;
  int bounces = 0, was_up = 0, touched = 1;
  while (bounces < 1000) {
    const tm_contact_result out = step(0, tm_vec(0, 0, -g), 0);
    const int up = s.v[2] > 0.0;
    if (out.contacts) touched = 1;
    if (was_up && !up && touched) {    /* top of the flight */
      top = g * (s.x[2] - r) + 0.5 * s.v[2] * s.v[2];
      highest = fmax(highest, top);
      if (bounces > 0) lowest = fmin(lowest, top);
      touched = 0;
      bounces++;
    }
    was_up = up;
  }
  printf("1000 bounces: energy between %.6f and %.6f, at the end %.6f of that at the start\n",
         lowest / (g * height), highest / (g * height), top / (g * height));
  UT_TRUE(highest < 1.002 * g * height);
  UT_TRUE(lowest > 0.998 * g * height);

  s.law[1].damping = 0.1;           /* with damping every bounce is lower, the rest is at rest */
  ut_put(&s, 0, tm_vec(0.013, 0.017, r + height), tm_vec(0, 0, 0));
  for (int n = 0; n < 40000; n++) step(0, tm_vec(0, 0, -g), 0);
  UT_NEAR(s.x[2], r - g / 1.0e4, 1e-6);
  UT_WITHIN(s.v[2], 0.0, 1e-6);
  ut_clear(&s);
}

/* A block on a slope: below the friction angle it stays where it is, above it slides with
   g (sin a - mu cos a). Gravity is turned instead of the floor. */
static void slope(void)
{
  floor_scene();
  s.law[1].stiffness = 1.0e3;
  s.law[1].damping = 0.5;
  s.law[1].friction.value = 0.3;
  s.args.dt = 1e-3;
  const double g = 9.81;
  for (int k = 0; k < 2; k++) {
    const double angle = atan(0.3) * (k ? 1.3 : 0.99);
    const tm_vec3 weight = tm_vec(g * sin(angle), 0, -g * cos(angle));
    ut_put(&s, 0, tm_vec(-0.9, 0.1, r - g * cos(angle) / 1.0e3), tm_vec(0, 0, 0));
    for (int n = 0; n < 500; n++) step(0, weight, TM_CT_FRICTION);
    const double a = g * (sin(angle) - 0.3 * cos(angle));
    if (k) UT_NEAR(s.v[0], a * 0.5, 1e-6);
    else UT_WITHIN(s.x[0] + 0.9, 0.0, 1e-15);
  }
  /* sliding is brought to rest in v/(mu g), exactly at rest, and not turned round */
  ut_put(&s, 0, tm_vec(-0.5, 0, r - g / 1.0e3), tm_vec(0.4, 0.3, 0));
  double least = 1.0;
  for (int n = 0; n < 400; n++) {
    step(0, tm_vec(0, 0, -g), TM_CT_FRICTION);
    least = fmin(least, fmin(s.v[0], s.v[1]));
  }
  UT_TRUE(least >= -1e-16);
  UT_TRUE(s.v[0] < 1e-15 && s.v[1] < 1e-15);
  UT_NEAR(hypot(s.x[0] + 0.5, s.x[1]), 0.25 / (2 * 0.3 * g), 5e-3);
  ut_clear(&s);
}

/* --- books ----------------------------------------------------------------------------------- */

/* A box that moves and turns among particles thrown at it: force and torque on the tool, powers
   and heat against sums made here from what the particles feel. */
static void books(void)
{
  tm_soup soup = ut_soup(12 * 9);
  ut_box(&soup, tm_vec(-.05, -.05, -.05), tm_vec(.05, .05, .05), 3);
  ut_arrange(&s, &soup, dp);
  static double tri_force[3 * 108], tri_heat[108], record[TM_REC * UT_PARTICLES];
  static int tri_count[108];
  memset(tri_force, 0, sizeof tri_force);
  memset(tri_heat, 0, sizeof tri_heat);
  memset(tri_count, 0, sizeof tri_count);
  tm_contact_args *a = &s.args;
  tm_contact_law *w = s.law + 1;
  w->stiffness = 50.0; w->damping = 0.2; w->friction.value = 0.25;
  w->tool_effusivity = 9.0; w->conductance = 4.0;
  s.mass[1] = 0.3;
  a->force_unit = 7.0;
  a->pose.turn = tm_rotation_about(tm_vec(1, 2, 3), 0.7);
  a->pose.shift = tm_vec(0.3, 0.1, -0.2);
  a->pose.velocity = tm_vec(-1, 0.2, 0.1);
  a->pose.omega = tm_vec(3, 5, -4);
  a->pose.center = tm_vec(0.2, 0, 0);
  a->reference = tm_vec(0.5, -0.4, 0.1);
  a->tool_temperature = 450.0;
  a->record = record;
  a->tri_force = tri_force; a->tri_heat = tri_heat; a->tri_count = tri_count;
  const unsigned fx = TM_CT_3D | TM_CT_HEAT | TM_CT_FRICTION | TM_CT_OUTPUT;
  tm_contact_result sum = tm_contact_nothing();
  double power = 0.0, heat = 0.0;
  int with_room = 0, without_room = 0;
  tm_vec3 force = tm_vec(0, 0, 0);
  for (int i = 0; i < UT_PARTICLES; i++) {
    const tm_vec3 p = ut_point(-0.055, 0.055);
    ut_put(&s, i, tm_pose_to_world(&a->pose, p), ut_point(-1, 1));
    const tm_vec3 before = ut_point(-5, 5);
    s.f[3 * i] = before.x; s.f[3 * i + 1] = before.y; s.f[3 * i + 2] = before.z;
    for (int d = 0; d < 3; d++) record[TM_REC * i + TM_REC_V + d] = s.v[3 * i + d] + ut_random(-0.1, 0.1);
    s.temperature[i] = ut_random(300, 400);
    s.source[i] = 2.0;
    /* the same where somebody has looked before, with room for some */
    static int place[UT_PARTICLES], taken;
    static tm_touch touch[20];
    const double as_before[4] = {s.f[3 * i], s.f[3 * i + 1], s.f[3 * i + 2], s.source[i]};
    a->found = (tm_contact_found){place, touch, &taken, 20};
    tm_contact_look(i, tm_group_alone(), a, fx);
    const tm_contact_result found = tm_contact_tri(i, a, fx & ~(unsigned) TM_CT_OUTPUT);
    const tm_vec3 by_found = tm_load3(s.f + 3 * i);
    s.f[3 * i] = as_before[0]; s.f[3 * i + 1] = as_before[1]; s.f[3 * i + 2] = as_before[2];
    s.source[i] = as_before[3];
    memset(&a->found, 0, sizeof a->found);
    const tm_contact_result one = tm_contact_tri(i, a, fx);
    UT_TRUE(!memcmp(&by_found, s.f + 3 * i, sizeof by_found) && found.contacts == one.contacts);
    UT_TRUE(found.spring == one.spring && found.friction_heat == one.friction_heat && found.depth == one.depth);
    without_room += place[i] < 0;
    with_room += place[i] > 0;
    tm_contact_sum(&sum, &one);
    const tm_vec3 F =
        tm_vec_scale(1 / a->force_unit, tm_vec_sub(tm_load3(s.f + 3 * i), before));
    force = tm_vec_add(force, F);
    const double c = 0.5 * a->dt / (s.mass[1] * a->force_unit);
    power += tm_vec_dot(F, tm_vec_axpy(tm_load3(s.v + 3 * i), c, tm_load3(s.f + 3 * i)));
    heat += s.source[i] - 2.0;
  }
  UT_TRUE(sum.contacts > 10 && with_room > 5 && without_room > 5);
  UT_WITHIN(tm_vec_norm(tm_vec_add(force, sum.force)), 0.0, 1e-12);
  UT_NEAR(sum.particle_power, power, 1e-11);
  UT_NEAR(sum.friction_heat + sum.conducted, heat, 1e-12);
  UT_NEAR(sum.heat_tool + sum.friction_heat + sum.conducted, sum.friction_power, 1e-12);
  UT_TRUE(sum.friction_power > 0.0 && sum.friction_heat > 0.0 && sum.conducted > 0.0);
  double on_tri[3] = {0, 0, 0}, heat_tri = 0.0;
  int count = 0;
  for (int t = 0; t < 108; t++) {
    for (int d = 0; d < 3; d++) on_tri[d] += tri_force[3 * t + d];
    heat_tri += tri_heat[t];
    count += tri_count[t];
  }
  UT_NEAR(on_tri[0], a->force_unit * sum.force.x, 1e-12);
  UT_NEAR(on_tri[1], a->force_unit * sum.force.y, 1e-12);
  UT_NEAR(on_tri[2], a->force_unit * sum.force.z, 1e-12);
  UT_NEAR(heat_tri, sum.heat_tool, 1e-12);
  UT_TRUE(count == sum.contacts);
  ut_clear(&s);
}

/* Energy over a run: work of the tool = kinetic energy gained + spring + damping + friction. The
   floor oscillates and drags; particles bounce and rub on it. */
static void energy_closes(void)
{
  floor_scene();
  tm_contact_law *w = s.law + 1;
  w->stiffness = 1.0e4; w->damping = 0.05; w->friction.value = 0.2;
  double error[2];
  for (int k = 0; k < 2; k++) {
    s.args.dt = k ? 5e-5 : 1e-4;
    s.args.after = 0.5 * s.args.dt;
    tm_motion m;
    memset(&m, 0, sizeof m);
    m.kind = TM_MOTION_WIGGLE;
    m.v = tm_vec(0.01, 0, 0.002);
    m.period = 0.11;
    const tm_pose rest = tm_pose_rest();
    ut_put(&s, 0, tm_vec(0, 0, 0.013), tm_vec(0.3, 0.1, -0.2));
    const double kinetic0 = 0.5 * (0.09 + 0.01 + 0.04);
    double gone = 0.0, tool = 0.0, spring = 0.0, friction = 0.0;
    const double weight = -9.81, z0 = s.x[2];
    double t = 0.0;
    for (; t < 1.0; t += s.args.dt) {
      s.args.pose = tm_motion_pose(&m, &rest, t + 0.5 * s.args.dt);
      const tm_contact_result out = step(0, tm_vec(0, 0, weight), TM_CT_FRICTION);
      gone += s.args.dt * (out.damping_power + out.friction_power);
      tool += s.args.dt * out.tool_power;
      friction += s.args.dt * out.friction_power;
      spring = out.spring;
    }
    const double kinetic =
        0.5 * (s.v[0] * s.v[0] + s.v[1] * s.v[1] + s.v[2] * s.v[2]);
    error[k] = kinetic - kinetic0 + spring + gone - tool - weight * (s.x[2] - z0);
    printf("energy: dissipated %.4e (friction %.4e), tool work %.4e, left over %.2e\n", gone,
           friction, tool, error[k]);
    UT_WITHIN(error[k], 0.0, 1e-3 * gone);
  }
  ut_clear(&s);
}

/* A particle between two plates that close and slide, with damping and friction: the same books, if the tools know of each
   other; without that each leaves out what the other's force adds to the velocity of the step. */
static void two_tools(void)
{
  double error[5], gone = 0.0, lost = 0.0;    /* [3] and [4]: with a drag behind both plates */
  for (int k = 0; k < 5; k++) {
    const double drag = k > 2 ? 20.0 : 0.0;
    double dragged = 0.0;
    floor_scene();
    tm_contact_law *w = s.law + 1;
    w->stiffness = 1.0e4; w->damping = 0.05; w->friction.value = 0.2;
    static double earlier[TM_EARLIER * UT_PARTICLES];
    tm_motion low, high;
    memset(&low, 0, sizeof low);
    low.kind = TM_MOTION_WIGGLE;
    low.v = tm_vec(0.01, 0, 0.002);
    low.period = 0.11;
    high = low;
    high.v = tm_vec(-0.02, 0.01, -0.001);
    tm_pose below = tm_pose_rest(), above = tm_pose_rest();
    above.turn = tm_rotation_about(tm_vec(1, 0, 0), TM_PI);
    s.args.dt = k == 2 ? 5e-5 : 1e-4;
    s.args.after = 0.5 * s.args.dt;
    s.args.earlier = k ? earlier : NULL;
    above.shift.z = 0.95 * dp;    /* pressed from both sides */
    ut_put(&s, 0, tm_vec(0, 0, 0.475 * dp), tm_vec(0.3, 0.1, 0));
    double tool = 0.0, spring = 0.0, first = 1.0e4 * pow(0.025 * dp, 2), kinetic0 = 0.5 * (0.09 + 0.01), t = 0.0;
    gone = 0.0;
    for (int n = 0; t < 1.0; n++, t += s.args.dt) {
      double *x = s.x, *v = s.v, *f = s.f;
      spring = 0.0;
      for (int d = 0; d < 3; d++) {
        x[d] += 0.5 * s.args.dt * v[d];
        f[d] = 0.0;
      }
      for (int plate = 0; plate < 2; plate++) {
        s.args.pose = tm_motion_pose(plate ? &high : &low, plate ? &above : &below, t + 0.5 * s.args.dt);
        s.args.first = plate == 0;
        const tm_contact_result out = tm_contact_tri(0, &s.args, TM_CT_3D | TM_CT_FRICTION);
        gone += s.args.dt * (out.damping_power + out.friction_power + out.late_friction);
        tool += s.args.dt * out.tool_power;
        spring += out.spring;
        UT_TRUE(out.contacts == 1 || n > 0);
      }
      for (int d = 0; d < 3; d++) f[d] -= drag * s.mass[1] * v[d];
      for (int d = 0; d < 3; d++) dragged += s.args.dt * drag * s.mass[1] * v[d] * (v[d] + 0.5 * s.args.dt / s.mass[1] * f[d]);
      if (k == 4) {
        const tm_contact_result late = tm_contact_late(0, &s.args, TM_CT_3D | TM_CT_FRICTION);
        gone += s.args.dt * (late.damping_power + late.late_friction);
        spring += late.spring;
      }
      for (int d = 0; d < 3; d++) {
        v[d] += s.args.dt / s.mass[1] * f[d];
        x[d] += 0.5 * s.args.dt * v[d];
      }
    }
    const double kinetic = 0.5 * (s.v[0] * s.v[0] + s.v[1] * s.v[1] + s.v[2] * s.v[2]);
    error[k] = kinetic - kinetic0 + spring - first + gone - tool + dragged;
    if (k < 3) lost = gone;
    ut_clear(&s);
  }
  printf("two tools: dissipated %.4e, left over %.2e alone, %.2e together, %.2e with half the step; with a force behind them %.2e "
         "not known, %.2e known\n", lost, error[0], error[1], error[2], error[3], error[4]);
  UT_WITHIN(error[1], 0.0, 2e-3 * lost);
  UT_TRUE(fabs(error[0]) > 5 * fabs(error[1]));
  UT_WITHIN(error[4], 0.0, 2e-3 * lost);
  UT_TRUE(fabs(error[3]) > 5 * fabs(error[4]));
}

/* The friction of a particle without heat is that of the temperature it started with, of its group or of all; a table
   holds its last values beyond its ends. */
static void starts(void)
{
  floor_scene();
  s.law[1].stiffness = 1.0;
  tm_table *t = &s.law[1].friction;
  t->n = 2;
  t->t[0] = 300; t->y[0] = 0.4;
  t->t[1] = 900; t->y[1] = 0.1;
  s.args.dt = 1e-6;
  const double T[4][3] = {{600, 0, 0.25}, {100, 0, 0.4}, {2000, 0, 0.1}, {100, 700, 0.2}};
  s.args.mask = s.type;    /* bit 1 */
  s.args.group = 1;
  for (int k = 0; k < 4; k++) {
    s.args.start.of_all = T[k][0];
    s.args.start.n = T[k][1] > 0.0;
    s.args.start.bit[0] = 1;
    s.args.start.of[0] = T[k][1];
    ut_put(&s, 0, tm_vec(0.1, 0.1, 0.5 * r), tm_vec(1, 0, 0));
    tm_contact_tri(0, &s.args, TM_CT_3D | TM_CT_FRICTION);
    UT_NEAR(-s.f[0] / s.f[2], T[k][2], 1e-12);
  }
  s.args.mask = NULL;
  ut_clear(&s);
}

/* Yield-limited friction and the conducted heat reach the particle through the loop. */
static void limits_in_the_loop(void)
{
  floor_scene();
  s.law[1].friction.value = 0.5;
  s.law[1].shear = 1.0;
  s.args.pstrain = s.pstrain;
  s.pstrain[2] = 2.0;
  s.args.dt = 1e-6;
  ut_put(&s, 0, tm_vec(0.1, 0.1, -0.5 * r), tm_vec(1, 0, 0));
  s.law[1].stiffness = 1.0;
  tm_contact_tri(0, &s.args, TM_CT_3D | TM_CT_FRICTION);
  UT_NEAR(s.f[0], -2.0 / sqrt(3.0) * dp * dp, 1e-12);
  UT_NEAR(s.f[2], 1.5 * r, 1e-12);
  s.args.mask = s.type;   /* group bit 2 is not set: no contact */
  s.args.group = 2;
  ut_put(&s, 0, tm_vec(0.1, 0.1, -0.5 * r), tm_vec(1, 0, 0));
  UT_TRUE(tm_contact_tri(0, &s.args, TM_CT_3D).contacts == 0 && s.f[2] == 0.0);
  s.args.mask = NULL;
  /* a particle of half the size: half the radius and a quarter of the stiffness */
  double size[TM_REC_SIZE] = {0};
  size[TM_SIZE_DP] = 0.5 * dp;
  s.args.size = size;
  ut_put(&s, 0, tm_vec(0.1, 0.1, -0.2 * r), tm_vec(0, 0, 0));
  tm_contact_tri(0, &s.args, TM_CT_3D);
  UT_NEAR(fabs(s.f[2]), 0.25 * (0.5 * r + 0.2 * r), 1e-12);
  s.args.size = NULL;
  ut_clear(&s);
}

/* Stiffness per area does not depend on the size of a particle: a pressed particle and the 8 of half the size
   in its place (or the other way round) have one force, one spring energy, and the time step follows. */
static void sizes(void)
{
  tm_contact_law w = {0};
  for (int dim3 = 0; dim3 < 2; dim3++) {
    w.radius = 0.5 * dp;
    w.area = dim3 ? dp * dp : dp;
    w.stiffness = tm_contact_stiffness(0.7 * 110e9, dp, dp, dim3);
    const tm_contact_law same = tm_contact_law_of_size(&w, dp, dim3);
    UT_TRUE(same.stiffness == w.stiffness && same.area == w.area && same.radius == w.radius);
    for (double edge = 0.1; edge < 3.0; edge *= 1.7) {
      const tm_contact_law own = tm_contact_law_of_size(&w, edge * dp, dim3);
      UT_NEAR(own.stiffness / own.area, 0.7 * 110e9 / dp, 1e-14);
      UT_NEAR(own.area, pow(edge * dp, dim3 ? 2 : 1), 1e-14);
      /* m follows the volume */
      const double m = 0.4, z = 0.1;
      UT_NEAR(tm_contact_time_step(own.stiffness, m * pow(edge, dim3 ? 3 : 2), z),
              sqrt(edge) * tm_contact_time_step(w.stiffness, m, z), 1e-14);
    }
    /* bodies: as many more pairs per area as the finer particles are smaller */
    const double E = 0.7 * tm_contact_modulus_of_two(110e9, 70e9), k = tm_contact_stiffness(E, dp, dp, dim3);
    UT_NEAR(k, 0.7 * 110e9 * 70e9 / (110e9 + 70e9) * (dim3 ? dp : 1.0), 1e-15);
    UT_NEAR(pow(2.0, dim3 ? 2 : 1) * tm_contact_stiffness(E, dp, 0.5 * dp, dim3), k, 1e-14);
  }

  floor_scene();
  s.law[1].stiffness = 3.0e4;
  double size[8 * TM_REC_SIZE] = {0};
  const double depth = 0.13 * r;
  const tm_vec3 at = tm_vec(0.013, 0.017, r - depth);
  ut_put(&s, 0, at, tm_vec(0, 0, 0));
  const tm_contact_result whole = tm_contact_tri(0, &s.args, TM_CT_3D);
  UT_NEAR(-whole.force.z, 3.0e4 * depth, 1e-12);
  tm_contact_result parts = tm_contact_nothing();
  s.args.size = size;
  for (int k = 0; k < 8; k++) {
    const double e = 0.25 * dp;
    size[k * TM_REC_SIZE + TM_SIZE_DP] = 0.5 * dp;
    ut_put(&s, k, tm_vec(at.x + (k & 1 ? e : -e), at.y + (k & 2 ? e : -e), at.z + (k & 4 ? e : -e)), tm_vec(0, 0, 0));
    const tm_contact_result one = tm_contact_tri(k, &s.args, TM_CT_3D);
    tm_contact_sum(&parts, &one);
  }
  UT_TRUE(parts.contacts == 4);
  UT_NEAR(parts.force.z, whole.force.z, 1e-12);
  UT_NEAR(parts.depth, whole.depth, 1e-12);
  UT_NEAR(whole.spring, 0.5 * 3.0e4 * depth * depth, 1e-12);
  UT_NEAR(parts.spring, whole.spring, 1e-12);
  s.args.size = NULL;
  ut_clear(&s);
}

int main(void)
{
  sizes();
  bounce();
  slope();
  books();
  energy_closes();
  two_tools();
  starts();
  limits_in_the_loop();
  return ut_summary();
}
