/* Particle shifting: nothing in a lattice, stretched or not, at its face or before the metal has flowed; the closed form between its
   bounds; a particle off its site goes back there as its neighborhood flows; rows that were pressed together spread into a gap. */
#include "tm_kernel.h"
#include "tm_shift.h"
#include "ut.h"

static tm_mat3 matrix(double xx, double xy, double xz, double yx, double yy, double yz, double zx, double zy, double zz)
{
  const tm_real row[9] = {xx, xy, xz, yx, yy, yz, zx, zy, zz};
  return tm_mat_load(row);
}

/* sum V gradW of a particle at p in a lattice of spacings sx, sy(, 1), those of x > most left away; site: its own, left out */
static tm_vec3 uneven(int kernel, int dim, double h, double sx, double sy, tm_vec3 p, double most)
{
  const int mx = (int) (2 * h / sx) + 2, my = (int) (2 * h / sy) + 2, mz = dim == 3 ? (int) (2 * h) + 1 : 0;
  const double norm = tm_kernel_norm(kernel, dim, h) / h, V = sx * sy;
  tm_vec3 g = tm_vec(0, 0, 0);
  for (int x = -mx; x <= mx; x++)
    for (int y = -my; y <= my; y++)
      for (int z = -mz; z <= mz; z++) {
        const tm_vec3 d = tm_vec(p.x - x * sx, p.y - y * sy, p.z - z);
        const double r = tm_vec_norm(d);
        if ((x || y || z) && x * sx < most && r < 2 * h)
          g = tm_vec_axpy(g, V * norm * tm_kernel_slope(kernel, r / h) / r, d);
      }
  return g;
}

/* All of g along the stretch, of metal that turns so that it is strained with this F. */
static tm_vec3 moved(double pure, tm_vec3 g, double h, double eps, double d_eps, double tension)
{
  const tm_shift_flow flow = {pure, g, g};
  return tm_shift(g, flow, h, eps, d_eps, tension, 1e300);
}

static double way(tm_vec3 g, double h, double eps, double d_eps)
{
  return tm_vec_norm(moved(1.0, g, h, eps, d_eps, 0.0));
}

/* A g: along the stretch of a bar all, across it a quarter; across that of a pressed one three, along it nothing; of shear the
   direction that is stretched, in any axes; never against g. F: less with spin, nothing with as much. */
static tm_vec3 part(tm_mat3 L, tm_vec3 g, int dim3) { return tm_shift_along(L, g, dim3).along; }

static double pure(tm_mat3 L) { return tm_shift_along(L, tm_vec(1, 0, 0), 1).pure; }

static void along(void)
{
  const tm_vec3 one = tm_vec(1, 1, 1);
  const tm_mat3 bar = matrix(3e4, 0, 0, 0, -1.5e4, 0, 0, 0, -1.5e4), pressed = tm_mat_scale(-1.0, bar);
  tm_vec3 m = part(bar, one, 1);
  UT_NEAR(m.x, 1.0, 1e-14);
  UT_NEAR(m.y, 0.25, 1e-14);
  UT_NEAR(m.z, 0.25, 1e-14);
  m = part(pressed, one, 1);
  UT_WITHIN(m.x, 0.0, 1e-14);
  UT_NEAR(m.y, 0.75, 1e-14);
  const double s = sqrt(0.75); /* plane strain; what grows in volume meanwhile does not count */
  m = part(matrix(2.1, 0, 0, 0, -1.9, 0, 0, 0, 0.1), one, 1);
  UT_NEAR(m.x, (1.0 + s) / 2.0, 1e-13);
  UT_NEAR(m.y, (1.0 - s) / 2.0, 1e-12);
  UT_NEAR(m.z, 0.5, 1e-13);
  const tm_vec3 plane = part(matrix(2, 0, 0, 0, -2, 0, 0, 0, 0), one, 0); /* in two dimensions all and nothing */
  UT_NEAR(plane.x, 1.0, 1e-14);
  UT_WITHIN(plane.y, 0.0, 1e-14);
  const tm_mat3 slanted = matrix(0, 8, 0, 8, 0, 0, 0, 0, 0), shear = matrix(0, 8, 0, 0, 0, 0, 0, 0, 0);
  const tm_vec3 out = part(slanted, tm_vec(1, 1, 0), 1), in = part(slanted, tm_vec(1, -1, 0), 1);
  UT_NEAR(out.x, m.x, 1e-13);
  UT_NEAR(out.y, m.x, 1e-13);
  UT_NEAR(in.x, m.y, 1e-12);
  UT_NEAR(in.y, -m.y, 1e-12);
  const tm_mat3 turning = matrix(0, 8, 0, 8.0 / 3.0, 0, 0, 0, 0, 0); /* spin over strain 1/2 */
  UT_NEAR(part(turning, tm_vec(1, 1, 0), 1).x, m.x, 1e-13);
  UT_NEAR(pure(turning), 0.75 * 0.75 * 0.75, 1e-13);
  UT_NEAR(pure(bar), 1.0, 1e-14);
  UT_NEAR(pure(pressed), 1.0, 1e-14);
  const tm_mat3 spin = matrix(0, 5, 0, -5, 0, 0, 0, 0, 0), none = tm_mat_scale(0.0, spin);
  UT_WITHIN(pure(shear), 0.0, 1e-14);
  UT_TRUE(pure(spin) == 0.0 && pure(none) == 0.0);
  for (double k = -1.0; k < 2.0; k += 0.125) {
    const tm_mat3 L = matrix(1, 0.3 * k, k, 0.7, k, 0.2, -0.4 * k, 0.9, -1 - k);
    for (double a = 0; a < 6.3; a += 0.1) {
      const tm_vec3 g = tm_vec(cos(a), sin(a) * cos(3 * a), sin(a) * sin(3 * a));
      const double with = tm_vec_dot(g, part(L, g, 1));
      UT_TRUE(with > -1e-15 && with < 1.0 + 1e-12);
    }
  }
}

static void closed_form(void)
{
  const double h = 1.2, d = 1e-4;
  const tm_vec3 g = tm_vec(0.06, -0.08, 0.0); /* h |g| = 0.12 */
  const double r = TM_SHIFT_RATE * 0.7 * 0.12;
  UT_NEAR(way(g, h, 1.0, d), d * h * r / (1.0 + r / TM_SHIFT_MOST), 1e-12);
  UT_NEAR(tm_vec_norm(moved(1.0, g, h, 1.0, d, 1.0)), d * h * r / (1.0 + r / TM_SHIFT_DRAWN), 1e-12);
  UT_NEAR(tm_vec_norm(moved(1.0, g, h, 1.0, d, 0.25)),
          0.75 * way(g, h, 1.0, d) + 0.25 * tm_vec_norm(moved(1.0, g, h, 1.0, d, 1.0)), 1e-12);
  const double all = TM_SHIFT_SHEARED * 0.6 * 0.12; /* in simple shear: all ways, not in tension */
  UT_NEAR(tm_vec_norm(moved(0.0, g, h, 1.0, d, 0.0)), d * h * all, 1e-12);
  UT_NEAR(tm_vec_norm(moved(0.0, g, h, 1.0, d, 0.25)), 0.75 * 0.75 * 0.75 * d * h * all, 1e-12);
  UT_TRUE(tm_vec_norm(moved(0.0, tm_vec(0.24, 0.08, 0.0), h, 1.0, d, 0.0)) == 0.0); /* h |g| = 0.304: near a surface */
  UT_TRUE(tm_vec_norm(moved(0.0, g, h, 1.0, d, 1.0)) == 0.0);
  UT_NEAR(tm_vec_norm(moved(0.25, g, h, 1.0, d, 0.0)),
          d * h * (0.75 * 0.75 * 0.75 * all + 0.25 * r / (1.0 + 0.25 * r / TM_SHIFT_MOST)), 1e-12);
  UT_TRUE(tm_tension_share(30.0, 5.0) == 0.0 && tm_tension_share(0.0, -5.0) == 0.0 &&
          tm_tension_share(30.0, -20.0) == 1.0);
  UT_NEAR(tm_tension_share(30.0, -5.0), 0.5, 1e-14);
  UT_NEAR(way(g, h, 0.3, d), 0.5 * way(g, h, 1.0, d), 1e-12);
  const tm_vec3 dx = moved(1.0, g, h, 0.5, d, 0.0); /* down the gradient */
  UT_NEAR(dx.x / dx.y, -0.75, 1e-12);
  UT_TRUE(dx.x < 0.0 && dx.z == 0.0);
  const tm_shift_flow quarter = {1.0, tm_vec_scale(0.25, g), tm_vec(0, 0, 0)};
  UT_NEAR(tm_shift(g, quarter, h, 0.5, d, 0.0, 1e300).x,
          dx.x * 0.25 * (1.0 + r / TM_SHIFT_MOST) / (1.0 + 0.25 * r / TM_SHIFT_MOST), 1e-12);
  const tm_vec3 slow = tm_shift(g, quarter, h, 0.5, d, 0.0, 1e-5); /* the way of sound in the step is short */
  UT_NEAR(tm_vec_norm(slow), TM_SHIFT_SPEED * 1e-5, 1e-12);
  UT_NEAR(slow.x / slow.y, -0.75, 1e-12);
  UT_TRUE(way(g, h, TM_SHIFT_BEGINS, d) == 0.0 && way(g, h, 0.1, d) == 0.0);
  UT_TRUE(way(g, h, 1.0, 0.0) == 0.0 && way(tm_vec(0, 0, 0), h, 1.0, d) == 0.0);
  UT_TRUE(way(tm_vec_scale(3.4, g), h, 1.0, d) == 0.0); /* at a surface */
  UT_TRUE(way(tm_vec_scale(1.5, g), h, 1.0, d) < TM_SHIFT_MOST * d * h);
  UT_NEAR(way(tm_vec_scale(0.1, g), 10 * h, 1.0, d), 10 * way(g, h, 1.0, d), 1e-12); /* any unit of length */
  /* under tension from a smaller strain on, as far as it is without spin */
  const double pure = pow(0.5, 1.0 / 9.0), begins = 0.15, whole = 0.3; /* w = 1/2 */
  const double bar = tm_vec_norm(moved(1.0, g, h, 1.0, d, 1.0)), half = tm_vec_norm(moved(pure, g, h, 1.0, d, 1.0));
  UT_TRUE(moved(1.0, g, h, TM_SHIFT_DRAWN_BEGINS, d, 1.0).x == 0.0);
  UT_NEAR(tm_vec_norm(moved(1.0, g, h, 0.15, d, 1.0)), 0.5 * bar, 1e-12);
  UT_NEAR(tm_vec_norm(moved(1.0, g, h, TM_SHIFT_DRAWN_WHOLE, d, 1.0)), bar, 1e-12);
  UT_TRUE(moved(pure, g, h, begins - 1e-12, d, 1.0).x == 0.0);
  UT_NEAR(tm_vec_norm(moved(pure, g, h, begins + 0.25 * (whole - begins), d, 1.0)), 0.25 * half, 1e-12);
  UT_NEAR(tm_vec_norm(moved(pure, g, h, whole, d, 1.0)), half, 1e-12);
}

/* At the side of a bar that is drawn only what lies along it moves, less than inside; not at its end, not in a bar that is pressed, nor
   where it turns. */
static void at_a_surface(void)
{
  const double h = 1.2, d = 1e-4, side = 0.6 / h, row = 0.02 / h;
  const tm_mat3 bar = matrix(2, 0, 0, 0, -1, 0, 0, 0, -1), pressed = tm_mat_scale(-1.0, bar);
  const tm_vec3 one = tm_vec(1, 1, 1), at = tm_vec(row, side, 0);
  const tm_shift_flow flow = tm_shift_along(bar, at, 1);
  UT_NEAR(tm_shift_along(bar, one, 1).axis.x, 1.0, 1e-14);
  UT_WITHIN(tm_shift_along(bar, one, 1).axis.y, 0.0, 1e-14);
  UT_WITHIN(tm_shift_along(pressed, one, 1).axis.x, 0.0, 1e-14);
  UT_NEAR(tm_shift_along(pressed, one, 1).axis.y, 0.5, 1e-14);
  UT_TRUE(tm_shift_along(bar, one, 0).axis.x == tm_shift_along(bar, one, 0).along.x);
  const double r = TM_SHIFT_RATE * TM_SHIFT_SKIN * (1.0 - 0.02 / TM_SHIFT_FACE) * 0.02;
  const tm_vec3 dx = tm_shift(at, flow, h, 1.0, d, 1.0, 1e300);
  UT_NEAR(dx.x, -d * h * r / (1.0 + r / TM_SHIFT_DRAWN), 1e-12);
  UT_WITHIN(dx.y, 0.0, 1e-17);
  UT_TRUE(dx.z == 0.0);
  const tm_vec3 end = tm_vec(side, row, 0);
  UT_TRUE(tm_vec_norm(tm_shift(end, tm_shift_along(bar, end, 1), h, 1.0, d, 1.0, 1e300)) == 0.0);
  UT_TRUE(tm_vec_norm(tm_shift(at, tm_shift_along(pressed, at, 1), h, 1.0, d, 0.0, 1e300)) == 0.0);
  const tm_shift_flow turning = {0.5, flow.along, flow.axis};
  UT_TRUE(fabs(tm_shift(at, turning, h, 1.0, d, 1.0, 1e300).x) < 2e-3 * fabs(dx.x));
  /* and between: c and what it leaves */
  const tm_vec3 near = tm_vec(row, 0.3 / h, 0);
  const double c = 1.0 - sqrt(0.3 * 0.3 + 0.02 * 0.02) / TM_SHIFT_FACE,
               skin = TM_SHIFT_SKIN * (1.0 - 0.02 / TM_SHIFT_FACE - c), x = TM_SHIFT_RATE * (c + skin) * 0.02,
               y = TM_SHIFT_RATE * c * 0.3 / 4, all = sqrt(x * x + y * y);
  const tm_vec3 both = tm_shift(near, tm_shift_along(bar, near, 1), h, 1.0, d, 1.0, 1e300);
  UT_NEAR(both.x, -d * h * x / (1.0 + all / TM_SHIFT_DRAWN), 1e-12);
  UT_NEAR(both.y, -d * h * y / (1.0 + all / TM_SHIFT_DRAWN), 1e-12);
}

static void lattices(int kernel, int dim, double h)
{
  const tm_vec3 site = tm_vec(0, 0, 0);
  for (double stretch = 1.0; stretch < 2.5; stretch += 0.25) {
    const tm_vec3 g = uneven(kernel, dim, h, stretch, 1 / stretch, site, 1e300);
    UT_TRUE(way(g, h, 1.0, 1e-3) < 1e-15);
  }
  UT_TRUE(way(uneven(kernel, dim, h, 1, 1, site, 0.5), h, 1.0, 1e-3) == 0.0); /* in a face */
  const tm_vec3 beneath =
      uneven(kernel, dim, h, 1, 1, site, 1.5); /* a face that is stretched: hardly beneath it either */
  const tm_mat3 drawn = matrix(dim == 3 ? -0.5 : -1, 0, 0, 0, 1, 0, 0, 0, dim == 3 ? -0.5 : 0);
  const tm_vec3 out = part(drawn, beneath, dim == 3);
  UT_TRUE(beneath.x < -0.01);
  UT_WITHIN(out.x, dim == 3 ? 0.25 * beneath.x : 0.0, 1e-14);
  UT_WITHIN(tm_vec_norm(out), fabs(out.x), 1e-14);
  tm_vec3 p = tm_vec(0.15, -0.1, dim == 3 ? 0.1 : 0.0);
  for (double eps = 0.4; eps < 1.0; eps += 1e-3) {
    const tm_vec3 g = uneven(kernel, dim, h, 1, 1, p, 1e300), dx = moved(1.0, g, h, eps, 1e-3, 0.0);
    UT_TRUE(tm_vec_dot(dx, p) <= 1e-20);
    p = tm_vec_add(p, dx);
  }
  UT_TRUE(tm_vec_norm(p) < 1e-3); /* of 0.18 to 0.2 */
}

/* Two rows along y, far apart along x, pressed together along y: every other particle of a row goes into the gap. */
static void gap(void)
{
  const double h = 1.2, sy = 0.45;
  double off = 1e-3;
  for (double eps = 0.4; eps < 1.6; eps += 1e-3) {
    tm_vec3 g = tm_vec(0, 0, 0);
    const double V = 1.0, norm = tm_kernel_norm(TM_KERNEL_HYPERBOLIC, 2, h) / h;
    for (int x = -1; x <= 1; x++)
      for (int y = -8; y <= 8; y++) {
        if (!x && !y) continue;
        const tm_vec3 d = tm_vec(off - (2.2 * x + (y % 2 ? -off : off)), -y * sy, 0.0);
        const double r = tm_vec_norm(d);
        if (r < 2 * h) g = tm_vec_axpy(g, V * norm * tm_kernel_slope(TM_KERNEL_HYPERBOLIC, r / h) / r, d);
      }
    UT_TRUE(fabs(g.y) < 1e-12);
    off += moved(1.0, g, h, eps, 1e-3, 0.0).x;
  }
  UT_TRUE(off > 0.1 && off < 0.6); /* of 0.55, a quarter of the distance of the rows; 0.001 at the start */
}

int main(void)
{
  closed_form();
  at_a_surface();
  along();
  lattices(TM_KERNEL_HYPERBOLIC, 2, 1.2);
  lattices(TM_KERNEL_HYPERBOLIC, 3, 1.2);
  lattices(TM_KERNEL_CUBIC, 2, 1.3);
  lattices(TM_KERNEL_WENDLAND_C2, 3, 1.6);
  gap();
  return ut_summary();
}
