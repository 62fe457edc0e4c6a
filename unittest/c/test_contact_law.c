/* Contact laws: closed forms of stiffness, damping and friction, which stops the sliding and never turns it round. */
#include "ut_contact.h"

static void laws(void)
{
  UT_NEAR(tm_contact_stiffness(tm_contact_modulus_of_two(50.0, 150.0), 0.1, 0.1, 1), 0.5 * 75.0 * 0.1, 1e-15);
  UT_NEAR(tm_contact_stiffness(tm_contact_modulus_of_two(50.0, 1e30), 0.1, 0.1, 1), 0.5 * 100.0 * 0.1, 1e-15);
  UT_NEAR(tm_contact_stiffness(50.0, 0.1, 0.1, 1), 0.5 * 100.0 * 0.1, 1e-15);
  UT_NEAR(tm_contact_stiffness(50.0, 0.1, 0.1, 0), 0.5 * 100.0, 1e-15);
  for (int elastic = 0; elastic < 2; elastic++) {
    UT_NEAR(tm_contact_modulus(0.5, 100.0, 270.0, elastic), 50.0, 1e-15);
    UT_NEAR(tm_contact_modulus(TM_PENALTY_MATERIAL, 100.0, 270.0, elastic), 270.0, 1e-15);
    UT_NEAR(tm_contact_modulus(TM_PENALTY_USUAL, 100.0, 270.0, elastic), elastic ? 270.0 : 100.0, 1e-15);
  }
  /* elastic bodies: under a pressure the compliance of two halves of a spacing, (dp/2)/M each */
  const double M1 = 135.0, M2 = 405.0, dp = 0.1, area = dp * dp, closes = 0.5 * dp / M1 + 0.5 * dp / M2;
  const double one = tm_contact_half_layer(M1), two = tm_contact_half_layer(M2);
  UT_NEAR(area / tm_contact_stiffness(tm_contact_modulus_of_two(one, two), dp, dp, 1), closes, 1e-14);
  UT_NEAR(area / tm_contact_stiffness(one, dp, dp, 1), 0.5 * dp / M1, 1e-14);

  UT_NEAR(tm_contact_normal(10.0, 0.1, 2.0, 0.3, 0), 1.6, 1e-15);    /* closing: damping adds */
  UT_NEAR(tm_contact_normal(10.0, 0.1, 2.0, -0.3, 0), 0.4, 1e-15);
  UT_TRUE(tm_contact_normal(10.0, 0.1, 2.0, -1.0, 0) == 0.0);        /* never tensile */
  UT_TRUE(tm_contact_normal(10.0, 0.1, 2.0, -0.3, 1) == 0.0);        /* F15: separating, dropped */
  UT_NEAR(tm_contact_normal(10.0, 0.1, 2.0, 0.3, 1), 1.6, 1e-15);

  tm_contact_law w;
  memset(&w, 0, sizeof w);
  w.radius = 0.5; w.area = 1.0; w.friction.value = 0.4;
  UT_NEAR(tm_contact_friction_limit(&w, 10.0, 300.0, 3.0), 4.0, 1e-15);
  w.shear = 1.0;
  UT_NEAR(tm_contact_friction_limit(&w, 10.0, 300.0, 3.0), sqrt(3.0), 1e-15);   /* Y/sqrt3 A */
  UT_NEAR(tm_contact_friction_limit(&w, 1.0, 300.0, 3.0), 0.4, 1e-15);
  w.friction.n = 2;
  w.friction.t[0] = 300; w.friction.y[0] = 0.4;
  w.friction.t[1] = 900; w.friction.y[1] = 0.1;
  UT_NEAR(tm_contact_friction_limit(&w, 1.0, 600.0, 0.0), 0.25, 1e-15);

  /* aluminium on steel, the half-spaces' closed form: fraction 0.5507 of friction heat */
  w.share = -1.0;
  w.tool_effusivity = sqrt(50.7 * 7870 * 486);
  UT_NEAR(tm_contact_share(&w, sqrt(120.0 * 2700 * 899)), 0.5507, 1e-4);
  w.share = 0.3;
  UT_NEAR(tm_contact_share(&w, 1.0), 0.3, 1e-15);

  w.conductance = -1.0;   /* perfect: the half spacing alone */
  UT_NEAR(tm_contact_conductance(&w, 7.0), 14.0, 1e-15);
  w.conductance = 14.0;
  UT_NEAR(tm_contact_conductance(&w, 7.0), 7.0, 1e-15);
  UT_NEAR(tm_contact_heat(1e-6, 500, 300, 2.0, 0.1), 2e-4, 1e-6);     /* small: h A dT */
  UT_NEAR(tm_contact_heat(1e9, 500, 300, 2.0, 0.1), 4000.0, 1e-12);   /* large: not past T_tool */
  UT_NEAR(tm_contact_time_step(100.0, 0.25, 0.0), 2.0 * 0.05, 1e-15);
}

/* Friction stops the sliding, at most its limit, and where other forces turn the sliding round within the step it takes
   nothing out of it and puts nothing in. */
static void braking(void)
{
  const double mass = 0.5, dt = 0.1;
  const tm_vec3 end = tm_vec(3, -4, 0);
  UT_TRUE(tm_contact_most_braking(tm_vec(1, 1, 0), tm_vec(4, 3, 0)) == 1.0);
  UT_TRUE(tm_contact_most_braking(tm_vec(0, 0, 0), end) == 1.0);        /* at rest: held */
  UT_TRUE(tm_contact_most_braking(tm_vec(-30, 40, 0), end) == 0.0);     /* stopped by the other forces already */
  UT_TRUE(tm_contact_most_braking(tm_vec(1, 1, 0), tm_vec(0, 0, 0)) == 1.0);
  const tm_vec3 stopped = tm_contact_friction(end, mass, dt, 1e9, 1.0);
  UT_NEAR(tm_vec_norm(tm_vec_axpy(end, dt / mass, stopped)) + 1.0, 1.0, 1e-15);
  UT_NEAR(tm_vec_norm(tm_contact_friction(end, mass, dt, 7.0, 1.0)), 7.0, 1e-15);
  const tm_vec3 start = tm_vec(-1, 0.5, 0);
  const double most = tm_contact_most_braking(start, end);
  UT_NEAR(most + 1e-12, 0.8, 1e-15);
  const tm_vec3 f = tm_contact_friction(end, mass, dt, 1e9, most);
  const tm_vec3 mean = tm_vec_scale(0.5, tm_vec_add(start, tm_vec_axpy(end, dt / mass, f)));
  UT_NEAR(tm_vec_dot(f, mean), -0.5e-12 * most * mass / dt * tm_vec_dot(end, end), 2e-3);
  UT_TRUE(tm_vec_dot(f, mean) < 0.0); /* it takes energy */
}

/* Critical damping: no overshoot with DFAC 1, an overshoot with less. */
static void critical_damping(void)
{
  for (int k = 0; k < 2; k++) {
    const double mass = 0.7, stiff = 13.0, c = tm_contact_damping(k ? 1.0 : 0.7, stiff, mass);
    double y = 1.0, v = 0.0, least = 1.0;   /* a spring both ways */
    for (int n = 0; n < 200000; n++) {
      v -= 1e-4 / mass * (stiff * y + c * v);
      y += 1e-4 * v;
      least = fmin(least, y);
    }
    UT_TRUE(k ? least > -1e-6 : least < -1e-3);
  }
}

int main(void)
{
  laws();
  braking();
  critical_damping();
  return ut_summary();
}
