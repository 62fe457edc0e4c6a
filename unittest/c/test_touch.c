/* Where contact is felt: no bumps on a tessellated plane, no gaps at convex edges and vertices, one
   push per wall in corners, the right side everywhere. Stiffness 1 and radius r: the force is the
   penetration r - d. The true distance comes from the body's formula, not from its triangles. */
#include "ut_contact.h"

static const double dp = 0.02, r = 0.01;

/* Slide over more than 1000 edges of a plane of uneven triangles, in several directions, grazing
   vertices exactly: nothing above 1e-9 of the normal force may change. (The issue allows 1e-2.) */
static void plane_without_bumps(void)
{
  static ut_scene s;
  tm_soup soup = ut_soup(2 * 300 * 40);
  ut_sheet(&soup, tm_vec(0, 0, 0), tm_vec(3, 0, 0), tm_vec(0, 0.4, 0), 300, 40);
  for (int k = 0; k < 9 * soup.n; k++) {   /* push the vertices about within the plane */
    const double x = soup.corner[k - k % 3], y = soup.corner[k - k % 3 + 1];
    if (k % 3 == 1) soup.corner[k] += 0.004 * sin(40 * x + 9) * sin(TM_PI * y / 0.4);
  }
  ut_arrange(&s, &soup, dp);
  UT_TRUE(s.mesh.npatch == 1);
  double worst = 0.0, edges = 0.0;
  for (int line = 0; line < 8; line++) {
    int last = -1;
    const double y0 = line == 0 ? 0.2 : ut_random(0.05, 0.35);
    const double slope = line < 3 ? 0.0 : ut_random(-0.04, 0.04);
    for (int k = 0; k <= 30000; k++) {
      const double x = 0.1 + 2.8 * k / 30000.0;
      const tm_vec3 p = tm_vec(x, y0 + slope * (x - 1.5), 0.3 * r);
      const tm_vec3 f = ut_force_at(&s, p, 0);
      worst = fmax(worst, tm_vec_norm(tm_vec_sub(f, tm_vec(0, 0, 0.7 * r))));
      tm_touch t[TM_TOUCH_MAX];
      if (tm_touch_find(&s.args.mesh, &s.args.grid, p, r, dp, 0, tm_group_alone(), t) == 1) {
        edges += t[0].triangle != last;
        last = t[0].triangle;
      } else worst = 1e9;
    }
  }
  printf("plane: %.0f edges crossed, largest change of force / normal force %.2e\n", edges,
         worst / (0.7 * r));
  UT_TRUE(edges > 1000);
  UT_WITHIN(worst / (0.7 * r), 0.0, 1e-9);
  ut_clear(&s);
}

/* Distance from the outside of the box |x| < h, and the direction away from it. */
static double box_distance(tm_vec3 p, double h, tm_vec3 *away)
{
  const tm_vec3 q = tm_vec(tm_clamp(p.x, -h, h), tm_clamp(p.y, -h, h), tm_clamp(p.z, -h, h));
  *away = tm_vec_sub(p, q);
  const double d = tm_vec_norm(*away);
  if (d > 0.0) *away = tm_vec_scale(1.0 / d, *away);
  return d;
}

static void compare_box(ut_scene *s, tm_vec3 p, double h, int *felt, double *worst)
{
  tm_vec3 away;
  const double d = box_distance(p, h, &away);
  if (d == 0.0) return;
  const tm_vec3 f = ut_force_at(s, p, 0), due = tm_vec_scale(fmax(r - d, 0.0), away);
  *worst = fmax(*worst, tm_vec_norm(tm_vec_sub(f, due)));
  *felt += r - d > 0.0;
}

/* Around a box in triangles: force r - d along the true direction at every place outside, on
   lattices that meet edges and vertices exactly and at random. */
static void box_is_watertight(int n)
{
  static ut_scene s;
  const double h = 0.05;
  tm_soup soup = ut_soup(12 * n * n);
  ut_box(&soup, tm_vec(-h, -h, -h), tm_vec(h, h, h), n);
  ut_arrange(&s, &soup, dp);
  UT_TRUE(s.mesh.closed && s.mesh.npatch == 6);
  UT_NEAR(s.mesh.volume, 8 * h * h * h, 1e-12);
  double worst = 0.0;
  int felt = 0;
  const double lattice[9] = {-h - 0.6 * r, -h - 0.2 * r, -h, -0.5 * h, 0, 0.3 * h, h, h + 0.2 * r,
                             h + 0.6 * r};
  for (int i = 0; i < 729; i++)
    compare_box(&s, tm_vec(lattice[i % 9], lattice[i / 9 % 9], lattice[i / 81]), h, &felt, &worst);
  for (int k = 0; k < 200000; k++) {
    tm_vec3 p = ut_point(-h - r, h + r);
    if (k % 3 == 0) p.x = k % 2 ? h : -h;          /* in the plane of a face: beside edges */
    if (k % 5 == 0) p.y = p.x;                     /* on the diagonal: the middle of an edge */
    compare_box(&s, p, h, &felt, &worst);
  }
  printf("box of %d triangles: %d contacts, largest error of force / radius %.2e\n", s.mesh.nt,
         felt, worst / r);
  UT_TRUE(felt > 10000);
  UT_WITHIN(worst / r, 0.0, 1e-9);

  /* behind the surface: out by the nearest face, force r + depth, up to one spacing */
  for (int k = 0; k < 20000; k++) {
    const tm_vec3 p = ut_point(-h, h);
    const double gap[6] = {h - p.x, h + p.x, h - p.y, h + p.y, h - p.z, h + p.z};
    int near = 0, second = -1;
    for (int j = 1; j < 6; j++)
      if (gap[j] < gap[near]) near = j;
    for (int j = 0; j < 6; j++)
      if (j != near && (second < 0 || gap[j] < gap[second])) second = j;
    if (gap[second] - gap[near] < 1e-9 || fabs(gap[near] - dp) < 1e-9) continue;
    const tm_vec3 f = ut_force_at(&s, p, 0);
    const double out = gap[near] < dp ? r + gap[near] : 0.0;
    const double c[3] = {f.x, f.y, f.z};
    for (int j = 0; j < 3; j++)
      UT_WITHIN(c[j], j == near / 2 ? (near % 2 ? -out : out) : 0.0, 1e-12);
  }
  ut_clear(&s);
}

/* A box turned inside out is the hull of a room: one push per wall, two in edges, three in
   corners. */
static void corners_count_walls(void)
{
  static ut_scene s;
  const double h = 0.05;
  tm_soup soup = ut_soup(12 * 25);
  ut_box(&soup, tm_vec(-h, -h, -h), tm_vec(h, h, h), 5);
  tm_soup_flip(&soup);
  ut_arrange(&s, &soup, dp);
  UT_TRUE(s.mesh.closed && s.mesh.volume < 0.0);
  for (int k = 0; k < 50000; k++) {
    const tm_vec3 p = ut_point(-h, h);
    const double c[3] = {p.x, p.y, p.z};
    const tm_vec3 f = ut_force_at(&s, p, 0);
    const double g[3] = {f.x, f.y, f.z};
    for (int j = 0; j < 3; j++) {
      const double due = fmax(r - (h - fabs(c[j])), 0.0);
      UT_WITHIN(g[j], c[j] > 0 ? -due : due, 1e-12);
    }
  }
  ut_clear(&s);
}

/* A ball in facets: distance from the true sphere within the sagitta, force continuous. */
static void ball(void)
{
  static ut_scene s;
  const int nu = 64, nv = 32;
  const double R = 0.08;
  tm_soup soup = ut_soup(2 * nu * nv);
  for (int i = 0; i < nu; i++)
    for (int j = 0; j < nv; j++) {
      tm_vec3 p[4];
      for (int k = 0; k < 4; k++) {
        const double a = 2 * TM_PI * ((i + (k == 1 || k == 2)) % nu) / nu;
        const double b = TM_PI * (j + (k >= 2)) / nv;
        p[k] = tm_vec(R * sin(b) * cos(a), R * sin(b) * sin(a), R * cos(b));
      }
      ut_facet(&soup, p[0], p[2], p[1]);
      ut_facet(&soup, p[0], p[3], p[2]);
    }
  ut_arrange(&s, &soup, dp);
  UT_TRUE(s.mesh.closed && s.mesh.npatch == 1 && s.mesh.volume > 0.0);
  UT_TRUE(s.mesh.dropped_degenerate == 2 * nu);
  const double sagitta = R * (1 - cos(TM_PI / nu)) + R * (1 - cos(0.5 * TM_PI / nv));
  double jump = 0.0;
  tm_vec3 last = tm_vec(0, 0, 0);
  for (int k = 0; k < 40000; k++) {
    const double a = 2 * TM_PI * k / 40000, b = 1.1 + 0.7 * sin(3 * a);
    const tm_vec3 u = tm_vec(sin(b) * cos(a), sin(b) * sin(a), cos(b));
    const tm_vec3 f = ut_force_at(&s, tm_vec_scale(R + 0.4 * r, u), 0);
    UT_WITHIN(tm_vec_dot(f, u), 0.6 * r, 1.05 * sagitta);
    if (k) jump = fmax(jump, tm_vec_norm(tm_vec_sub(f, last)));
    last = f;
  }
  printf("ball: largest change of force / normal force in steps of a turn/40000: %.2e\n",
         jump / (0.6 * r));
  UT_WITHIN(jump / (0.6 * r), 0.0, 5e-2);
  ut_clear(&s);
}

/* A blade thinner than a particle: from outside only its near side pushes. Its sharp edge is felt
   all round, as a rounding of the particle's radius. */
static void thin_blade(void)
{
  static ut_scene s;
  tm_soup soup = ut_soup(100);
  const double t = 0.5 * r;   /* wedge of half angle 5 degrees with its edge along z at x = 0 */
  const double len = 0.06;
  const tm_vec3 a = tm_vec(0, 0, -0.1), b = tm_vec(0, 0, 0.1);
  const tm_vec3 c = tm_vec(len, t, -0.1), d = tm_vec(len, t, 0.1);
  const tm_vec3 e = tm_vec(len, -t, -0.1), g = tm_vec(len, -t, 0.1);
  ut_facet(&soup, a, b, d); ut_facet(&soup, a, d, c);
  ut_facet(&soup, a, e, g); ut_facet(&soup, a, g, b);
  ut_facet(&soup, e, c, d); ut_facet(&soup, e, d, g);
  ut_facet(&soup, a, c, e); ut_facet(&soup, b, g, d);
  ut_arrange(&s, &soup, dp);
  UT_TRUE(s.mesh.closed && s.mesh.volume > 0.0);
  for (int k = 0; k < 20000; k++) {
    const double x = ut_random(-r, 0.5 * len), y = ut_random(-2 * r, 2 * r);
    const tm_vec3 p = tm_vec(x, y, ut_random(-0.05, 0.05));
    const double slope = t / len, top = slope * p.x;
    if (p.x > 0 && fabs(p.y) < top + 1e-9) continue;   /* inside */
    /* nearest point of the side that faces p */
    const double norm = sqrt(1 + slope * slope), along = (p.x + slope * fabs(p.y)) / norm;
    const double q = fmax(along, 0.0) / norm;
    const tm_vec3 near = tm_vec(q, (p.y > 0 ? slope : -slope) * q, p.z);
    const tm_vec3 away = tm_vec_sub(p, near);
    const double dist = tm_vec_norm(away);
    const tm_vec3 f = ut_force_at(&s, p, 0);
    const tm_vec3 due = tm_vec_scale(fmax(r - dist, 0.0) / dist, away);
    UT_WITHIN(tm_vec_norm(tm_vec_sub(f, due)), 0.0, 1e-9 * r);
  }
  ut_clear(&s);
}

/* F15's own test: the same on a face, nothing beside a convex edge, twice where prisms overlap. */
static void f15_test(void)
{
  static ut_scene s;
  const double h = 0.05, g = 0.4 * r;
  tm_soup soup = ut_soup(12);
  ut_box(&soup, tm_vec(-h, -h, -h), tm_vec(h, h, h), 1);
  ut_arrange(&s, &soup, dp);
  UT_NEAR(ut_force_at(&s, tm_vec(0.01, 0.02, h + g), TM_CT_F15).z, r - g, 1e-12);
  UT_TRUE(tm_vec_norm(ut_force_at(&s, tm_vec(h + g, 0.01, h + g), TM_CT_F15)) == 0.0);
  UT_NEAR(ut_force_at(&s, tm_vec(0.02, -0.02, h + g), TM_CT_F15).z, 2 * (r - g), 1e-12);
  ut_clear(&s);
}

/* An open sheet: sides told by its normal, its rim rounds off, and two-sided on request. */
static void open_sheet(void)
{
  static ut_scene s;
  tm_soup soup = ut_soup(2);
  ut_sheet(&soup, tm_vec(0, 0, 0), tm_vec(1, 0, 0), tm_vec(0, 1, 0), 1, 1);
  ut_arrange(&s, &soup, dp);
  UT_TRUE(s.mesh.open_edges == 4 && !s.mesh.closed && s.mesh.nt == 2);
  UT_NEAR(ut_force_at(&s, tm_vec(0.5, 0.3, 0.2 * r), 0).z, 0.8 * r, 1e-12);
  UT_NEAR(ut_force_at(&s, tm_vec(0.5, 0.3, -0.2 * r), 0).z, 1.2 * r, 1e-12);
  UT_NEAR(ut_force_at(&s, tm_vec(0.5, 0.3, -0.2 * r), TM_CT_TWO_SIDED).z, -0.8 * r, 1e-12);
  const tm_vec3 rim = ut_force_at(&s, tm_vec(-0.3 * r, 0.5, 0.4 * r), 0);
  UT_NEAR(rim.x, -0.5 * r * 0.6, 1e-9);
  UT_NEAR(rim.z, 0.5 * r * 0.8, 1e-9);
  ut_clear(&s);
}

int main(void)
{
  plane_without_bumps();
  box_is_watertight(1);
  box_is_watertight(13);
  corners_count_walls();
  ball();
  thin_blade();
  f15_test();
  open_sheet();
  return ut_summary();
}
