/* Particle shifting: nothing in a lattice, stretched or not, at its face or before the metal has flowed; the closed form between its
   bounds; a particle off its site goes back there as its neighborhood flows; rows that were pressed together spread into a gap. */
#include "tm_kernel.h"
#include "tm_shift.h"
#include "ut.h"

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
        if ((x || y || z) && x * sx < most && r < 2 * h) g = tm_vec_axpy(g, V * norm * tm_kernel_slope(kernel, r / h) / r, d);
      }
  return g;
}

static double way(tm_vec3 g, double h, double eps, double d_eps) { return tm_vec_norm(tm_shift(g, h, eps, d_eps, 1.0)); }

static void closed_form(void)
{
  const double h = 1.2, d = 1e-4;
  const tm_vec3 g = tm_vec(0.06, -0.08, 0.0); /* h |g| = 0.12 */
  UT_NEAR(way(g, h, 1.0, d), TM_SHIFT_RATE * d * 0.7 * h * 0.12, 1e-12);
  UT_NEAR(way(g, h, 0.3, d), 0.5 * way(g, h, 1.0, d), 1e-12);
  const tm_vec3 dx = tm_shift(g, h, 0.5, d, 1.0); /* down the gradient */
  UT_NEAR(dx.x / dx.y, -0.75, 1e-12);
  UT_TRUE(dx.x < 0.0 && dx.z == 0.0);
  UT_NEAR(tm_shift(g, h, 0.5, d, 0.25).x, 0.25 * dx.x, 1e-12);
  UT_TRUE(tm_shift_share(30.0, 5.0) == 1.0 && tm_shift_share(30.0, 0.0) == 1.0); /* pressure */
  UT_TRUE(tm_shift_share(0.0, 0.0) == 1.0 && tm_shift_share(0.0, 2.0) == 1.0 && tm_shift_share(0.0, -2.0) == 0.0); /* molten */
  UT_NEAR(tm_shift_share(30.0, -5.0), 0.5, 1e-12);
  UT_TRUE(tm_shift_share(30.0, -10.0) <= 1e-12 && tm_shift_share(30.0, -50.0) == 0.0); /* uniaxial tension, and more */
  UT_TRUE(way(g, h, TM_SHIFT_BEGINS, d) == 0.0 && way(g, h, 0.1, d) == 0.0);
  UT_TRUE(way(g, h, 1.0, 0.0) == 0.0 && way(tm_vec(0, 0, 0), h, 1.0, d) == 0.0);
  UT_TRUE(way(tm_vec_scale(3.4, g), h, 1.0, d) == 0.0); /* at a surface */
  UT_NEAR(way(g, h, 1.0, 5.0), TM_SHIFT_MOST * h, 1e-12);
  UT_NEAR(way(tm_vec_scale(0.1, g), 10 * h, 1.0, d), 10 * way(g, h, 1.0, d), 1e-12); /* any unit of length */
}

static void lattices(int kernel, int dim, double h)
{
  const tm_vec3 site = tm_vec(0, 0, 0);
  for (double stretch = 1.0; stretch < 2.5; stretch += 0.25) {
    const tm_vec3 g = uneven(kernel, dim, h, stretch, 1 / stretch, site, 1e300);
    UT_TRUE(way(g, h, 1.0, 1e-3) < 1e-15);
  }
  UT_TRUE(way(uneven(kernel, dim, h, 1, 1, site, 0.5), h, 1.0, 1e-3) == 0.0); /* in a face */
  UT_TRUE(way(uneven(kernel, dim, h, 1, 1, site, 1.5), h, 1.0, 1e-3) < 2e-3); /* beneath it: at most twice the strain, in h */
  tm_vec3 p = tm_vec(0.15, -0.1, dim == 3 ? 0.1 : 0.0);
  for (double eps = 0.4; eps < 1.0; eps += 1e-3) {
    const tm_vec3 dx = tm_shift(uneven(kernel, dim, h, 1, 1, p, 1e300), h, eps, 1e-3, 1.0);
    UT_TRUE(tm_vec_dot(dx, p) <= 0.0);
    p = tm_vec_add(p, dx);
  }
  UT_TRUE(tm_vec_norm(p) < 0.08); /* of 0.18 to 0.2: 0.007 to 0.017 in two dimensions, 0.04 to 0.07 in three */
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
    off += tm_shift(g, h, eps, 1e-3, 1.0).x;
  }
  UT_TRUE(off > 0.1 && off < 0.6); /* of 0.55, a quarter of the distance of the rows; 0.001 at the start */
}

int main(void)
{
  closed_form();
  lattices(TM_KERNEL_HYPERBOLIC, 2, 1.2);
  lattices(TM_KERNEL_HYPERBOLIC, 3, 1.2);
  lattices(TM_KERNEL_CUBIC, 2, 1.3);
  lattices(TM_KERNEL_WENDLAND_C2, 3, 1.6);
  gap();
  return ut_summary();
}
