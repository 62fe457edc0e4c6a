/* Contact between bodies of particles: the smooth surface against a lattice at any offset, forces against the gradient of
   the stored energy, and the books of momentum, angular momentum, power and heat of random clouds; friction, its shear limit and
   table, stiffness per area, types that are one body. */
#include "tm_body_contact.h"
#include "ut.h"

#include <stdlib.h>
#include <string.h>

enum { MOST = 1400, TYPES = 3 };

static struct {
  int n, dim, type[MOST], mask[MOST], length[MOST], none[MOST];
  ptrdiff_t first[MOST];
  int *row;
  double main[MOST * TM_REC], heat[MOST * TM_REC_HEAT], size[MOST * TM_REC_SIZE], ahead[TM_AHEAD * MOST], source[MOST];
  double force[3 * MOST], sides[MOST * 2 * TM_BODY_SIDE];
  tm_body_law law[(TYPES + 1) * (TYPES + 1)];
  double layer[TM_L_COLUMNS * MOST], thin[TM_THIN * MOST], gradient[9 * MOST];
  int side[(TYPES + 1) * (TYPES + 1)], strains[TYPES + 1];
  double effusivity[TYPES + 1];
} s;
static tm_rates_args a;
static tm_body_contact_args b;

static double *rec(int i) { return s.main + (ptrdiff_t) i * TM_REC; }

static void begin(int dim)
{
  memset(&s, 0, sizeof s);
  memset(&a, 0, sizeof a);
  memset(&b, 0, sizeof b);
  s.dim = dim;
  a.rec.main = s.main;
  a.type = s.type;
  a.ntypes = TYPES;
  a.force = s.force;
  a.force_unit = 1.0;
  b.law = s.law;
  b.side = s.side;
  b.sides = 1;
  b.effusivity = s.effusivity;
  b.surface = tm_body_surface_make(dim, 2.4);
  b.spacing = 1.0;
  b.dt = 1e-9;
  b.sides_of = s.sides;
  b.ahead = s.ahead;
  b.mask = s.mask;
  for (int t = 1; t <= TYPES; t++) {
    s.effusivity[t] = t;
    for (int u = 1; u <= TYPES; u++) {
      s.law[t * (TYPES + 1) + u].modulus = tm_contact_modulus_of_two(100.0, 100.0);
      s.side[t * (TYPES + 1) + u] = t != u;
    }
  }
}

static void put(int type, double x, double y, double z)
{
  double *r = rec(s.n);
  r[0] = x; r[1] = y; r[2] = z;
  r[TM_REC_M] = 1.0;
  s.type[s.n++] = type;
}

static void all_rows(void)
{
  size_t room = 0;
  for (int pass = 0; pass < 2; pass++) {
    room = 0;
    for (int i = 0; i < s.n; i++) {
      s.first[i] = (ptrdiff_t) room;
      s.length[i] = 0;
      for (int j = 0; j < s.n; j++) {
        double r2 = 0;
        for (int d = 0; d < s.dim; d++) r2 += (rec(i)[d] - rec(j)[d]) * (rec(i)[d] - rec(j)[d]);
        if (i == j || s.type[i] == s.type[j] || r2 > 9.0) continue;
        if (pass) s.row[room] = j;
        s.length[i]++;
        room++;
      }
    }
    if (!pass) {
      free(s.row);
      s.row = (int *) malloc((room + 1) * sizeof(int));
    }
  }
  a.rows.index = s.row;
  a.rows.first = s.first;
  a.rows.stride = 1;
  a.rows.mechanical = a.rows.thermal = s.none;
  a.rows.contact = s.length;
}

static tm_body_contact_result run(void)
{
  const unsigned fx = s.dim == 3 ? (unsigned) TM_FX_3D : 0u;
  tm_body_contact_result sum = tm_body_contact_nothing();
  memset(s.force, 0, sizeof s.force);
  memset(s.source, 0, sizeof s.source);
  for (int i = 0; i < s.n; i++)
    for (int d = 0; d < 3; d++) s.ahead[TM_AHEAD * i + d] = rec(i)[TM_REC_V + d];
  for (int i = 0; b.thin && i < s.n; i++) tm_body_thin(i, &a, &b, fx);
  for (int i = 0; i < s.n; i++) {
    const tm_body_contact_result r = tm_body_touch(i, &a, &b, fx);
    tm_body_contact_sum(&sum, &r);
  }
  for (int i = 0; i < s.n; i++) {
    const tm_body_contact_result r = tm_body_contact(i, &a, &b, fx);
    tm_body_contact_sum(&sum, &r);
  }
  return sum;
}

/* --- the surface --------------------------------------------------------------------------------- */

/* delta and |grad delta| over half a lattice, at height g over a particle of its first layer moved by (x, y) */
static double lattice_depth(const tm_body_surface *f, int dim, double x, double y, double g, double *along, double *across)
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
    printf("%dd flat face: penetration off by %.5f spacings, slope by %.4f, normal by %.4f; slope down to 0.3: %.4f\n", dim,
           off, slope, tilt, deep);
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

/* two blocks that touch and overlap, with noise, all moving */
static void cloud(int dim)
{
  const int side = dim == 3 ? 5 : 9;
  for (int t = 1; t <= 2; t++)
    for (int p = 0; p < side; p++)
      for (int q = 0; q < side; q++)
        for (int l = 0; l < (dim == 3 ? 3 : 1); l++) {
          const double y = t == 1 ? -q : q + 0.9;
          put(t, p + 0.3 * t + 0.1 * ut_random(-1, 1), y + 0.1 * ut_random(-1, 1), dim == 3 ? l + 0.05 * ut_random(-1, 1) : 0);
          double *r = rec(s.n - 1);
          for (int d = 0; d < dim; d++) r[TM_REC_V + d] = ut_random(-1, 1);
          r[TM_REC_M] = ut_random(0.5, 2.0);
          s.size[(s.n - 1) * TM_REC_SIZE + TM_SIZE_DP] = ut_random(0.8, 1.2);
        }
}

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

/* Layers that strain, of both bodies or one: forces against the energy of the springs at given thickness; work on particles and
   layers = - rate of the springs - damping - friction; momentum. */
static void layers(void)
{
  const unsigned both = 2, effect = TM_FX_3D;
  for (int dim = 2; dim < 4; dim++)
    for (unsigned bodies = 1; bodies <= both; bodies++) {
      begin(dim);
      cloud(dim);
      all_rows();
      b.layer = s.layer;
      b.thin = s.thin;
      b.strains = s.strains;
      b.layer_dt = 1e-14;
      a.gradient = s.gradient;
      for (int t = 1; t <= TYPES; t++) s.strains[t] = t <= (int) bodies;
      for (int k = 0; k < 9 * s.n; k++) s.gradient[k] = (dim == 3 || (k % 3 < 2 && k % 9 < 6)) ? ut_random(-1, 1) : 0.0;
      double strain[MOST], rate[MOST];
      for (int i = 0; i < s.n; i++) {
        double *row = s.layer + i * TM_L_COLUMNS;
        rec(i)[TM_REC_RHO] = 1.3;
        row[TM_L_STRAIN] = strain[i] = ut_random(-0.3, 0.2);
        row[TM_L_NEAR] = TM_LAYER_NOW;
        row[TM_L_TOOL] = TM_LAYER_OF_BODIES;
      }
      for (int k = 0; k < (TYPES + 1) * (TYPES + 1); k++) {
        s.law[k].friction.value = 0.4;
        s.law[k].damping = 0.3;
      }
      tm_body_contact_result r = run();
      int thin = 0;
      double on_layers = 0.0, big = 0.0;
      tm_vec3 P = tm_vec(0, 0, 0);
      for (int i = 0; i < s.n; i++) {
        double *row = s.layer + i * TM_L_COLUMNS;
        const double by = s.thin[i * TM_THIN + TM_THIN_BY];
        P = tm_vec_add(P, tm_vec(s.force[3 * i], s.force[3 * i + 1], s.force[3 * i + 2]));
        big = fmax(big, fabs(s.force[3 * i]));
        rate[i] = 0.0;
        if (s.thin[i * TM_THIN + TM_THIN_SIDE] == 0.0) continue;
        UT_TRUE(s.type[i] <= (int) bodies);
        thin++;
        tm_vec3 n;
        double arm;
        UT_TRUE(tm_body_psi(i, 0, &a, &b, dim == 3, &n) > 0.0);
        n = tm_vec_scale(1.0 / tm_vec_norm(n), n);
        UT_WITHIN(by, 0.5 * tm_layer_stretch(strain[i], &arm) - 0.5, 1e-14);
        rate[i] = tm_vec_dot(n, tm_mat_mul_vec(tm_mat_from_row(s.gradient + 9 * i), n));
        UT_NEAR(s.thin[i * TM_THIN + TM_THIN_RATE], 0.5 * arm * rate[i], 1e-12);
        /* of the stress, what is of this force point */
        const tm_sym3 T = tm_sym_from_row(row + TM_L_STRESS);
        on_layers += (tm_sym_trace(T) - row[TM_L_AHEAD]) * rate[i] * rec(i)[TM_REC_M] / rec(i)[TM_REC_RHO];
        UT_WITHIN(tm_vec_dot(n, tm_sym_mul_vec(T, n)), tm_sym_trace(T), 1e-12 * fabs(tm_sym_trace(T)));
      }
      UT_TRUE(thin > (dim == 3 ? 8 : 3));
      UT_WITHIN(tm_vec_norm(P), 0.0, 1e-12 * big * s.n);
      double spring[2], work = r.work_power - on_layers;
      for (int k = 0; k < 2; k++) {
        const double t = k ? 2e-7 : -1e-7, at = k ? 1e-7 : -1e-7;
        for (int i = 0; i < s.n; i++) {
          double *row = s.layer + i * TM_L_COLUMNS;
          for (int d = 0; d < dim; d++) rec(i)[d] += t * rec(i)[TM_REC_V + d];
          row[TM_L_STRAIN] = strain[i] + at * rate[i];
          row[TM_L_NEAR] = TM_LAYER_NOW;
        }
        spring[k] = run().spring;
      }
      const double change = (spring[1] - spring[0]) / 2e-7, lost = r.damping_power + r.friction_power;
      printf("%dd, layers of %u: %d, work %.8g against %.8g, of the layers %.3g\n", dim, bodies, thin, work, -(change + lost), on_layers);
      UT_TRUE(fabs(on_layers) > 0.01 * fabs(work));
      UT_WITHIN(work, -(change + lost), 2e-6 * (fabs(change) + lost));
      /* a new one begins at touch; one that is there stays until the other body is away */
      for (int i = 0; i < s.n; i++) {
        tm_vec3 n;
        const double psi = tm_body_psi(i, 0, &a, &b, dim == 3, &n);
        s.layer[i * TM_L_COLUMNS + TM_L_NEAR] = 0.0;
        tm_body_thin(i, &a, &b, dim == 3 ? effect : 0u);
        UT_TRUE((s.thin[i * TM_THIN + TM_THIN_SIDE] > 0.0) == (s.type[i] <= (int) bodies && psi > 1.0));
        UT_WITHIN(s.thin[i * TM_THIN + TM_THIN_BY], 0.0, 1e-12);
        s.layer[i * TM_L_COLUMNS + TM_L_NEAR] = 1.0;
        tm_body_thin(i, &a, &b, dim == 3 ? effect : 0u);
        UT_TRUE((s.thin[i * TM_THIN + TM_THIN_SIDE] > 0.0) == (s.type[i] <= (int) bodies && psi > 0.0));
      }
      /* a layer that a tool owns is not the bodies', one that is forgotten begins anew */
      s.layer[TM_L_TOOL] = 3.0;
      tm_body_thin(0, &a, &b, dim == 3 ? effect : 0u);
      UT_TRUE(s.thin[TM_THIN_SIDE] == 0.0);
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
      for (int i = 0; i < s.n; i++) {    /* columns of the middle */
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
    printf("%dd flat faces: stiffness %.4f to %.4f of the due one, friction off by %.5f of 0.3\n", dim, least, most, ratio / 0.3);
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
  t->t[0] = 300; t->y[0] = 0.4;
  t->t[1] = 900; t->y[1] = 0.1;
  s.law[2 * (TYPES + 1) + 1] = *w;
  const double T[5][2] = {{100, 200}, {300, 300}, {500, 700}, {300, 900}, {2000, 1500}}, due[5] = {0.4, 0.4, 0.25, 0.25, 0.1};
  for (int heat = 0; heat < 2; heat++)
    for (int k = 0; k < 5; k++) {
      double fn;
      b.start.of_all = T[k][0];    /* of group 2 another one */
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
  UT_NEAR(middle_friction(&fn), 5 * 0.8 * 0.9 / sqrt(3.0), 0.01);    /* 5 particles of edge 1 */
  for (int i = 0; i < s.n; i++) s.ahead[TM_AHEAD * i + TM_AHEAD_YIELD] = s.type[i] == 1 ? 0.9 : 0.4;
  UT_NEAR(middle_friction(&fn), 5 * 0.8 * 0.4 / sqrt(3.0), 0.01);
  /* slow sliding is braked by what stops it */
  b.dt = 1.0;
  for (int i = 0; i < s.n; i++) rec(i)[TM_REC_V] = s.type[i] == 2 ? 1e-3 : 0.0;
  const double brake = middle_friction(&fn);
  UT_TRUE(brake > 0.0 && brake < 0.5 * fn);
  UT_NEAR(brake, TM_BODY_STOP * 5 * 0.5 * 1e-3, 0.02);    /* reduced mass 1/2 */
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
  layers();
  flat();
  friction_laws();
  types();
  free(s.row);
  return ut_summary();
}
