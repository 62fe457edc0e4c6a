/* Heat: tables, conservation of the pair terms, particles that come together, the conductance of an
   interface on a lattice, surface flux, and the bound behind the time step. */
#include "tm_heat.h"
#include "tm_lattice.h"
#include "tm_time_step.h"
#include "ut.h"

static void check_tables(void)
{
  tm_table a = {0};
  a.value = 50;
  UT_NEAR(tm_table_at(&a, 1e6), 50, 0);
  a.n = 3;
  a.t[0] = 300;
  a.t[1] = 500;
  a.t[2] = 1000;
  a.y[0] = 50;
  a.y[1] = 40;
  a.y[2] = 45;
  UT_NEAR(tm_table_at(&a, 0), 50, 0);
  UT_NEAR(tm_table_at(&a, 300), 50, 1e-15);
  UT_NEAR(tm_table_at(&a, 350), 47.5, 1e-15);
  UT_NEAR(tm_table_at(&a, 500), 40, 1e-15);
  UT_NEAR(tm_table_at(&a, 900), 44, 1e-15);
  UT_NEAR(tm_table_at(&a, 1e9), 45, 0);
  UT_TRUE(isfinite(tm_table_at(&a, NAN)));
  a.n = 1;
  UT_NEAR(tm_table_at(&a, 200) + tm_table_at(&a, 400), 100, 1e-15);
  tm_material m = {0};
  m.conductivity = a;
  m.capacity.value = 486;
  UT_TRUE(tm_conductivity(&m, 400) == 50 && tm_capacity(&m, 400) == 486);
}

/* what leaves i arrives at j, for any two particles; the hot one cools */
static void check_pairs(void)
{
  for (int k = 0; k < 2000; k++) {
    const double ki = pow(10, ut_random(-3, 3)), kj = pow(10, ut_random(-3, 3));
    const double Ti = ut_random(0, 2000), Tj = ut_random(0, 2000);
    const double vi = ut_random(0.1, 2), vj = ut_random(0.1, 2), r = ut_random(0.1, 2);
    const double g = -ut_random(0.1, 5), hc = pow(10, ut_random(-3, 3));
    const double ri = pow(10, ut_random(-9, 4)), rj = ri * ut_random(0.1, 10); /* densities */
    const double ij = vi * tm_conduction_pair(ki, kj, Ti, Tj, vj * rj, rj, g);
    const double ji = vj * tm_conduction_pair(kj, ki, Tj, Ti, vi * ri, ri, g);
    UT_NEAR(ij, -ji, 1e-14);
    UT_TRUE(tm_conduction_pair(ki, kj, Ti, Tj, vi * ri * (vj * rj), ri * rj, g) ==
            -tm_conduction_pair(kj, ki, Tj, Ti, vj * rj * (vi * ri), rj * ri, g)); /* with the same bits */
    UT_TRUE((Ti > Tj) == (ij < 0));
    UT_NEAR(ij, 4 * ki * kj / (ki + kj) * (Ti - Tj) * vi * vj * g, 1e-14);
    const double cij = vi * tm_conduction_pair_interface(ki, kj, Ti, Tj, vj, g, r, hc);
    const double cji = vj * tm_conduction_pair_interface(kj, ki, Tj, Ti, vi, g, r, hc);
    UT_NEAR(cij, -cji, 1e-14);
    /* resistances in series */
    UT_NEAR(ij / cij, 1 + 2 * ki * kj / (ki + kj) / (r * hc), 1e-12);
    const double open = tm_conduction_pair_interface(ki, kj, Ti, Tj, vj, g, r, 1e12);
    UT_NEAR(open * vi, ij, 1e-7);
    UT_TRUE(tm_conduction_pair_interface(ki, kj, Ti, Tj, vj, g, r, 0) == 0);
    UT_TRUE(tm_conduction_pair(0, kj, Ti, Tj, vj, 1, g) == 0);
  }
  UT_TRUE(tm_conduction_pair(0, 0, 1, 2, 1, 1, -1) == 0);
  UT_TRUE(tm_conduction_pair(0, 0, 1, 2, 1e-18, 1e-18, -1) == 0); /* tonnes and millimeters */
  UT_TRUE(tm_conduction_pair_interface(0, 0, 1, 2, 1, -1, 1, 0) == 0);
}

/* 2 V |W'|/r over G of a pair at distance r, spacing 1 */
static double conducts(int kernel, int dim, double h, double r)
{
  const double g = tm_kernel_norm(kernel, dim, h) / (h * r) * tm_kernel_slope(kernel, r / h);
  return -2 * g / tm_lattice_gradient(kernel, dim, h);
}

/* Two particles that come together: what they conduct is bounded whatever the kernel, and is F15 (6) to the last bit
   from the core on. Inside a lattice, at an eighth of the time step, no temperature leaves the range it began with,
   where W'/r itself makes the hotter one colder than nothing. */
static void check_clump(void)
{
  for (int kernel = 0; kernel < TM_KERNEL_COUNT; kernel++) {
    for (int dim = 2; dim <= 3; dim++) {
      const double h = 1.2;
      for (double r = 1e-9; r < 1; r *= 1.1) UT_TRUE(conducts(kernel, dim, h, r) < 8 * conducts(kernel, dim, h, 1));
      const tm_lattice sums = tm_lattice_sums(kernel, dim, h);
      for (double r = 1e-8; r < 0.3; r *= 10) {
        /* two in one place of the lattice, the others at 500 K; k/(rho c_p) = 1 */
        const double dt = 0.125 * tm_heat_time_step(1, 1, h, 1, 1, sums.heat_rate);
        const double w = conducts(kernel, dim, h, r), rest = tm_lattice_wave(kernel, dim, h, 8, 8, dim == 3 ? 8 : 0);
        double a = 600, b = 500;
        for (int step = 0; step < 200; step++) {
          const double to_b = dt * w * (a - b);
          a += dt * rest * (500 - a) - to_b;
          b += dt * rest * (500 - b) + to_b;
          UT_TRUE(a <= 600 && b <= 600 && a >= 500 - 1e-9 && b >= 500 - 1e-9);
        }
        UT_WITHIN(a - b, 0, 1);
      }
    }
  }
}

/* Heat through an interface at x = 0 between lattice layers at -1/2 and 1/2, per unit area, for
   the steady profile of flux 1: slope 1/k, jump 1/hc. 1 is exact. */
static double flux(int dim, double h, double k, double hc)
{
  const int m = (int) (2 * h) + 1, my = dim > 1 ? m : 0, mz = dim > 2 ? m : 0;
  const double norm = tm_kernel_norm(TM_KERNEL_CUBIC, dim, h) / h;
  const double pair = tm_interface_conductance(hc, dim);
  double sum = 0;
  for (int left = 1; left <= m; left++)
    for (int right = 0; right < m; right++)
      for (int y = -my; y <= my; y++)
        for (int z = -mz; z <= mz; z++) {
          const double x = left + right, r = sqrt(x * x + y * y + z * z);
          const double g = norm * tm_kernel_slope(TM_KERNEL_CUBIC, r / h) / r;
          const double rise = x / k + 1 / hc;
          sum += tm_conduction_pair_interface(k, k, 0, rise, 1, g, r, pair);
        }
  return sum;
}
static void check_interface(void)
{
  for (int dim = 1; dim <= 3; dim++)
    for (double biot = 1e-3; biot < 2e3; biot *= 10) {
      UT_WITHIN(flux(dim, 1.3, 7, 7 * biot), 1, 0.12);    /* the lattice of a run */
      UT_WITHIN(flux(dim, 6, 7, 7 * biot / 6), 1, 0.005); /* towards the continuum */
    }
}

/* largest eigenvalue of the conduction sum on a lattice, times h^2, over plane waves */
static double largest_eigenvalue(int kernel, int dim, double h)
{
  const int m = (int) (tm_kernel_support(kernel) * h) + 1, my = dim > 1 ? m : 0;
  const int mz = dim > 2 ? m : 0;
  const double norm = tm_kernel_norm(kernel, dim, h) / h;
  double best = 0;
  for (int a = 0; a <= 4; a++)
    for (int b = 0; b <= a; b++)
      for (int c = 0; c <= b; c++) {
        double sum = 0;
        for (int x = -m; x <= m; x++)
          for (int y = -my; y <= my; y++)
            for (int z = -mz; z <= mz; z++) {
              const double r = sqrt((double) (x * x + y * y + z * z));
              if (r == 0) continue;
              const double wave = cos(TM_PI / 4 * (a * x + b * y + c * z));
              const double g = norm * tm_kernel_slope(kernel, r / h) / r;
              sum -= tm_conduction_pair(1, 1, 1, wave, 1, 1, g);
            }
        best = tm_max(best, sum * h * h);
      }
  return best;
}

int main(void)
{
  check_tables();
  check_pairs();
  check_clump();
  check_interface();
  for (int kernel = 0; kernel < TM_KERNEL_COUNT; kernel++)
    for (int dim = 1; dim <= 3; dim++)
      for (double h = 1; h < 2.1; h += 0.25) {
        const double rate = largest_eigenvalue(kernel, dim, h); /* k/(rho cp h^2) = 1 */
        if (dim == 1) continue;
        const tm_lattice sums = tm_lattice_sums(kernel, dim, h);
        UT_NEAR(sums.heat_rate * sums.gradient, rate, 0.01);
        UT_TRUE(rate <= sums.heat_rate * sums.gradient * (1 + 1e-12));
        UT_NEAR(tm_heat_time_step(1, 1, 1, 1, 1, sums.heat_rate) * sums.heat_rate, 0.5, 1e-14);
      }
  UT_NEAR(tm_heat_time_step(7870, 486, 1e-4, 50.7, 50.7, 6), 7870 * 486 * 1e-8 / 50.7 / 12, 1e-14);
  UT_NEAR(tm_heat_time_step(1, 1, 1, 1, 1e9, 5), 0.05, 1e-8);

  /* into the body: the cold body warms */
  UT_NEAR(tm_convection(20, 300, 400), 2000, 1e-15);
  UT_NEAR(tm_radiation(5.670374419e-8, 0.5, 300, 1000), 28122.2, 1e-5);
  UT_NEAR(tm_radiation(5.670374419e-8, 1, 1000, 0), -56703.74419, 1e-12);
  UT_TRUE(tm_radiation(5.67e-8, 1, 293.15, 293.15) == 0);
  return ut_summary();
}
