/* Contact between bodies of particles: the smooth surface against a lattice at any offset, forces against the gradient of
   the stored energy, and the books of momentum, angular momentum, power and heat of random clouds; friction, its shear limit and
   table, stiffness per area, types that are one body. */
#include "ut_bodies.h"

/* --- the surface --------------------------------------------------------------------------------- */

/* delta and |grad delta| over half a lattice, at height g over a particle of its first layer moved by (x, y) */
static double lattice_depth(const tm_body_surface *f, int dim, double x, double y, double g, double *along,
                            double *across)
{
  double psi = 0.0, grad[3] = {0, 0, 0}, rate;
  for (int p = -5; p <= 5; p++)
    for (int q = dim == 3 ? -5 : 0; q <= (dim == 3 ? 5 : 0); q++)
      for (int l = 0; l < 4; l++) {
        const double d[3] = {x - p, dim == 3 ? y - q : 0.0, g + l}, r2 = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
        psi += tm_body_weight(f, r2) / f->norm;
        for (int k = 0; k < 3; k++) grad[k] -= 2.0 * tm_body_fall(f, r2) * d[k] / f->norm;
      }
  const double depth = tm_body_depth(f, psi, &rate);
  *along = -rate * grad[2];
  *across = rate * hypot(grad[0], grad[1]);
  return depth;
}

static void surface(void)
{
  for (int dim = 2; dim < 4; dim++) {
    const tm_body_surface f = tm_body_surface_make(dim, 2.4);
    double off = 0.0, slope = 0.0, tilt = 0.0, deep = 0.0;
    for (int k = 0; k < 200; k++) {
      const double x = ut_random(0, 1), y = ut_random(0, 1), d = ut_random(0.002, 0.1);
      double along, across;
      off = fmax(off, fabs(lattice_depth(&f, dim, x, y, 1.0 - d, &along, &across) - d));
      slope = fmax(slope, fabs(along - 1.0));
      tilt = fmax(tilt, across);
      lattice_depth(&f, dim, x, y, 1.0 - 3.0 * d, &along, &across);
      deep = fmax(deep, fabs(along - 1.0));
    }
    printf("%dd flat face: penetration off by %.5f spacings, slope by %.4f, normal by %.4f; slope down to 0.3: %.4f\n",
           dim, off, slope, tilt, deep);
    UT_TRUE(off < 0.001 && slope < 0.01 && tilt < 0.005 && deep < 0.05);
    for (double support = 1.6; support < 3.1; support += 0.2) {
      const tm_body_surface g = tm_body_surface_make(dim, support);
      double along, across, mean = 0.0;
      for (int k = 0; k < 100; k++)
        mean += 0.01 * lattice_depth(&g, dim, (k % 10) / 10.0, dim == 3 ? (k / 10) / 10.0 : 0.0, 0.95, &along, &across);
      UT_WITHIN(mean, 0.05, 0.003);
    }
    /* a face of another spacing, y in means of both: particles touch it at 1 whatever the offset, but for a ripple */
    for (double y = 0.3; y < 1.65; y += 0.15) {
      double worst = 0.0;
      for (int k = 0; k < 30; k++) {
        const double ox = y * ut_random(0, 1), oy = y * ut_random(0, 1);
        double psi = 0.0;
        for (double g = 1.0; g < 2.4; g += y)
          for (int i = -9; i <= 9; i++)
            for (int j = dim == 3 ? -9 : 0; j <= (dim == 3 ? 9 : 0); j++) {
              const double dx = y * i + ox, dy = dim == 3 ? y * j + oy : 0.0;
              psi += tm_body_weight(&f, dx * dx + dy * dy + g * g);
            }
        worst = fmax(worst, fabs(psi * (dim == 3 ? y * y : y) / tm_body_norm(&f, y) - 1.0));
      }
      UT_TRUE(worst < 0.004 + 2.5 * (dim - 1) * exp(-TM_PI * TM_PI * TM_BODY_WIDTH / (y * y)));
    }
    UT_NEAR(tm_body_norm(&f, 1.0), f.norm, 1e-15);
    /* derivatives; delta goes on smoothly where it is deep */
    for (double x = 0.05; x < 7.0; x += 0.17)
      UT_WITHIN(tm_body_fall(&f, x), (tm_body_weight(&f, x - 1e-5) - tm_body_weight(&f, x + 1e-5)) / 2e-5, 1e-8);
    for (double psi = 1.01; psi < 6.0; psi += 0.093) {
      double rate, none;
      tm_body_depth(&f, psi, &rate);
      UT_NEAR(rate, (tm_body_depth(&f, psi + 1e-5, &none) - tm_body_depth(&f, psi - 1e-5, &none)) / 2e-5, 1e-4);
    }
    double none;
    UT_TRUE(tm_body_depth(&f, 1.0, &none) == 0.0 && none == 0.0);
    UT_TRUE(tm_body_weight(&f, f.reach2) == 0.0 && tm_body_fall(&f, f.reach2) == 0.0);
    UT_WITHIN(tm_body_weight(&f, f.reach2 - 1e-9), 0.0, 1e-12);
  }
}

/* --- clouds ---------------------------------------------------------------------------------------- */

/* the gradient of the stored energy, momentum, angular momentum */
static void forces(void)
{
  for (int dim = 2; dim < 4; dim++) {
    begin(dim);
    cloud(dim);
    all_rows();
    double l0 = 0.0, worst = 0.0, momentum = 0.0, big = 0.0;
    run();
    static double F[3 * MOST];
    memcpy(F, s.force, sizeof F);
    tm_vec3 P = tm_vec(0, 0, 0), L = P;
    for (int i = 0; i < s.n; i++) {
      const tm_vec3 f = tm_vec(F[3 * i], F[3 * i + 1], F[3 * i + 2]), x = tm_vec(rec(i)[0], rec(i)[1], rec(i)[2]);
      P = tm_vec_add(P, f);
      L = tm_vec_add(L, tm_vec_cross(x, f));
      big = fmax(big, tm_vec_norm(f));
    }
    momentum = tm_vec_norm(P);
    l0 = tm_vec_norm(L);
    UT_TRUE(big > 1.0);
    UT_WITHIN(momentum, 0.0, 1e-12 * big * s.n);
    UT_WITHIN(l0, 0.0, 1e-11 * big * s.n);
    /* the gradient of the energy of the springs, by differences */
    for (int k = 0; k < 60; k++) {
      const int i = (int) ut_random(0, s.n), d = (int) ut_random(0, dim);
      const double x = rec(i)[d], e = 1e-6;
      rec(i)[d] = x + e;
      const double up = run().spring;
      rec(i)[d] = x - e;
      const double down = run().spring;
      rec(i)[d] = x;
      worst = fmax(worst, fabs(F[3 * i + d] + (up - down) / (2 * e)));
    }
    printf("%dd: force against the gradient of the energy, off by %.2g of %.3g\n", dim, worst, big);
    UT_TRUE(worst < 1e-6 * big);
  }
}

/* work on the particles = - rate of the springs - damping - friction, heat = friction, momentum */
static void books(void)
{
  for (int dim = 2; dim < 4; dim++)
    for (int sizes = 0; sizes < 2; sizes++) {
      begin(dim);
      cloud(dim);
      if (sizes) a.rec.size = s.size;
      all_rows();
      b.source = s.source;
      for (int k = 0; k < (TYPES + 1) * (TYPES + 1); k++) {
        s.law[k].friction.value = 0.4;
        s.law[k].damping = 0.3;
      }
      const tm_body_contact_result r = run();
      tm_vec3 P = tm_vec(0, 0, 0);
      double heat = 0.0, big = 0.0;
      for (int i = 0; i < s.n; i++) {
        P = tm_vec_add(P, tm_vec(s.force[3 * i], s.force[3 * i + 1], s.force[3 * i + 2]));
        heat += s.source[i];
        big = fmax(big, fabs(s.force[3 * i]));
      }
      UT_WITHIN(tm_vec_norm(P), 0.0, 1e-12 * big * s.n);
      UT_TRUE(r.friction_power > 0.0 && r.damping_power > 0.0);
      UT_NEAR(heat, r.friction_power, 1e-12);
      UT_NEAR(r.heat_power, r.friction_power, 1e-12);
      /* power of the springs, by moving all particles with their velocities */
      double spring[2];
      for (int k = 0; k < 2; k++) {
        const double t = k ? 2e-7 : -1e-7;
        for (int i = 0; i < s.n; i++)
          for (int d = 0; d < dim; d++) rec(i)[d] += t * rec(i)[TM_REC_V + d];
        spring[k] = run().spring;
      }
      const double change = (spring[1] - spring[0]) / 2e-7;
      /* where sizes differ the mean of s over the neighbors is held in the force */
      UT_WITHIN(r.work_power, -(change + r.damping_power + r.friction_power),
                (sizes ? 0.02 : 1e-6) * (fabs(change) + r.damping_power + r.friction_power));
    }
}

/* --- flat faces -------------------------------------------------------------------------------------- */

/* two flat bodies of 2 layers that overlap by `deep`, moved along each other by (x, z) */
static void faces(int dim, double deep, double x, double z)
{
  for (int t = 1; t <= 2; t++)
    for (int p = -6; p <= 6; p++)
      for (int q = dim == 3 ? -6 : 0; q <= (dim == 3 ? 6 : 0); q++)
        for (int l = 0; l < 2; l++)
          put(t, p + (t == 2) * x, t == 1 ? -l : 1.0 - deep + l, dim == 3 ? q + (t == 2) * z : 0.0);
}

/* forces on the part of body 2 that lies over one unit cell of body 1: mean over offsets of the middle particle */
static void flat(void)
{
  for (int dim = 2; dim < 4; dim++) {
    double most = 0.0, least = 1e9, mean = 0.0, ratio = 0.0;
    const int tries = 12;
    for (int k = 0; k < tries; k++) {
      begin(dim);
      for (int p = 0; p < (TYPES + 1) * (TYPES + 1); p++) s.law[p].modulus = tm_contact_modulus_of_two(300.0, 100.0);
      s.law[1 * (TYPES + 1) + 2].friction.value = s.law[2 * (TYPES + 1) + 1].friction.value = 0.3;
      faces(dim, 0.04, k == 0 ? 0.0 : ut_random(-0.5, 0.5), k == 0 ? 0.0 : ut_random(-0.5, 0.5));
      for (int i = 0; i < s.n; i++)
        if (s.type[i] == 2) rec(i)[TM_REC_V] = 1.0;
      all_rows();
      run();
      double f[3] = {0, 0, 0};
      int count = 0;
      for (int i = 0; i < s.n; i++) { /* columns of the middle */
        if (s.type[i] != 2 || fabs(rec(i)[0]) > 2.6 || fabs(rec(i)[2]) > 2.6) continue;
        for (int d = 0; d < 3; d++) f[d] += s.force[3 * i + d];
        count++;
      }
      const double pressed = f[1] / (0.5 * count * 75.0 * 0.04);
      most = fmax(most, pressed);
      least = fmin(least, pressed);
      mean += pressed / tries;
      ratio = fmax(ratio, fabs(-f[0] / f[1] - 0.3));
    }
    printf("%dd flat faces: stiffness %.4f to %.4f of the due one, friction off by %.5f of 0.3\n", dim, least, most,
           ratio / 0.3);
    UT_TRUE(least > 0.97 && most < 1.03);
    UT_WITHIN(mean, 1.0, 0.02);
    UT_TRUE(ratio < 0.3 * 0.01);
  }
}

static double middle_friction(double *normal)
{
  run();
  double f[3] = {0, 0, 0};
  for (int i = 0; i < s.n; i++)
    if (s.type[i] == 2 && fabs(rec(i)[0]) < 2.6 && fabs(rec(i)[2]) < 2.6)
      for (int d = 0; d < 3; d++) f[d] += s.force[3 * i + d];
  *normal = f[1];
  return -f[0];
}

/* mu(T) of the mean temperature, with and without heat; never beyond the ends of the table; the shear limit of the weaker */
static void friction_laws(void)
{
  begin(2);
  faces(2, 0.02, 0.0, 0.0);
  for (int i = 0; i < s.n; i++) {
    if (s.type[i] == 2) rec(i)[TM_REC_V] = 1.0;
    s.mask[i] = s.type[i];
  }
  all_rows();
  tm_body_law *w = s.law + 1 * (TYPES + 1) + 2;
  tm_table *t = &w->friction;
  t->n = 2;
  t->t[0] = 300;
  t->y[0] = 0.4;
  t->t[1] = 900;
  t->y[1] = 0.1;
  s.law[2 * (TYPES + 1) + 1] = *w;
  const double T[5][2] = {{100, 200}, {300, 300}, {500, 700}, {300, 900}, {2000, 1500}},
               due[5] = {0.4, 0.4, 0.25, 0.25, 0.1};
  for (int heat = 0; heat < 2; heat++)
    for (int k = 0; k < 5; k++) {
      double fn;
      b.start.of_all = T[k][0]; /* of group 2 another one */
      b.start.n = 1;
      b.start.bit[0] = 2;
      b.start.of[0] = T[k][1];
      a.rec.heat = heat ? s.heat : NULL;
      for (int i = 0; i < s.n; i++) s.heat[i * TM_REC_HEAT + TM_REC_T] = T[k][s.type[i] - 1];
      const double ft = middle_friction(&fn);
      UT_NEAR(ft / fn, due[k], 0.005);
    }
  /* the shear limit of the weaker material, m Y/sqrt(3) per area; none where no flow stress is known */
  a.rec.heat = NULL;
  t->n = 0;
  t->value = 0.5;
  w->shear = 0.8;
  s.law[2 * (TYPES + 1) + 1] = *w;
  double fn;
  UT_NEAR(middle_friction(&fn) / fn, 0.5, 0.005);
  for (int i = 0; i < s.n; i++) s.ahead[TM_AHEAD * i + TM_AHEAD_YIELD] = s.type[i] == 1 ? 0.9 : 0.0;
  UT_NEAR(middle_friction(&fn), 5 * 0.8 * 0.9 / sqrt(3.0), 0.01); /* 5 particles of edge 1 */
  for (int i = 0; i < s.n; i++) s.ahead[TM_AHEAD * i + TM_AHEAD_YIELD] = s.type[i] == 1 ? 0.9 : 0.4;
  UT_NEAR(middle_friction(&fn), 5 * 0.8 * 0.4 / sqrt(3.0), 0.01);
  /* slow sliding is braked by what stops it */
  b.dt = 1.0;
  for (int i = 0; i < s.n; i++) rec(i)[TM_REC_V] = s.type[i] == 2 ? 1e-3 : 0.0;
  const double brake = middle_friction(&fn);
  UT_TRUE(brake > 0.0 && brake < 0.5 * fn);
  UT_NEAR(brake, TM_BODY_STOP * 5 * 0.5 * 1e-3, 0.02); /* reduced mass 1/2 */
}

/* A body of two types that are bonded is one surface; a particle between two other bodies meets each by itself. */
static void types(void)
{
  double one[2], two[2];
  for (int k = 0; k < 2; k++) {
    begin(2);
    faces(2, 0.05, 0.3, 0.0);
    if (k) {
      for (int i = 0; i < s.n; i++)
        if (s.type[i] == 2 && rec(i)[0] > 0.1) s.type[i] = 3;
      s.side[2 * (TYPES + 1) + 3] = s.side[3 * (TYPES + 1) + 2] = 0;
    }
    all_rows();
    (k ? two : one)[0] = run().spring;
    (k ? two : one)[1] = s.force[3 * 6 + 1];
  }
  UT_NEAR(two[0], one[0], 1e-12);
  UT_WITHIN(two[1], one[1], 1e-12);
  /* a plate between two bodies, pressed by both */
  begin(2);
  b.sides = 2;
  s.side[1 * (TYPES + 1) + 3] = 2;
  s.side[2 * (TYPES + 1) + 3] = s.side[3 * (TYPES + 1) + 2] = 0;
  for (int p = -6; p <= 6; p++)
    for (int l = 0; l < 2; l++) {
      put(1, p, -l, 0);
      put(2, p, 0.95 + l, 0);
      put(3, p, -1.95 - l, 0);
    }
  all_rows();
  run();
  double pressed[TYPES + 1] = {0};
  for (int i = 0; i < s.n; i++)
    if (fabs(rec(i)[0]) < 2.6) pressed[s.type[i]] += s.force[3 * i + 1];
  UT_WITHIN(pressed[1], 0.0, 1e-12);
  UT_NEAR(pressed[2], 5 * 50.0 * 0.05, 0.02);
  UT_NEAR(pressed[3], -5 * 50.0 * 0.05, 0.02);
}

int main(void)
{
  surface();
  forces();
  books();
  flat();
  friction_laws();
  types();
  free(s.row);
  return ut_summary();
}
