/* ASPH: a published lattice table, its inverse, stretching and shearing lattices, the update's fixed point. */
#include "tm_asph.h"
#include "ut.h"

/* Psi of a lattice stretched by e along x (and squeezed by nothing), all within reach */
static double stretched(int kernel, int dim, double n_h, double e)
{
  double sum = 0.0;
  const int nz = dim == 3 ? 20 : 0;
  for (int i = -20; i <= 20; i++)
    for (int j = -20; j <= 20; j++)
      for (int k = -nz; k <= nz; k++)
        if (i || j || k) sum += tm_kernel_shape(kernel, sqrt(e * e * i * i + j * j + k * k) / n_h);
  return tm_asph_psi(kernel, dim, sum);
}

int main(void)
{
  /* without the particle itself: sums over the lattice, independent figures */
  static const double n_h[4] = {1.0, 1.2, 1.5, 2.0};
  static const double cubic2[4] = {0.73900841, 0.99243242, 1.34276300, 1.88284414};
  static const double hyper2[4] = {0.71394995, 0.96082797, 1.30935421, 1.85369713};
  static const double cubic3[4] = {0.88008203, 1.12163479, 1.45223551, 1.97316861};
  static const double hyper3[4] = {0.87051516, 1.11059957, 1.44201261, 1.96604556};
  for (int k = 0; k < 4; k++) {
    UT_WITHIN(tm_asph_lattice_psi(TM_KERNEL_CUBIC, 2, n_h[k]), cubic2[k], 1e-8);
    UT_WITHIN(tm_asph_lattice_psi(TM_KERNEL_HYPERBOLIC, 2, n_h[k]), hyper2[k], 1e-8);
    UT_WITHIN(tm_asph_lattice_psi(TM_KERNEL_CUBIC, 3, n_h[k]), cubic3[k], 1e-8);
    UT_WITHIN(tm_asph_lattice_psi(TM_KERNEL_HYPERBOLIC, 3, n_h[k]), hyper3[k], 1e-8);
  }
  for (int kernel = 0; kernel < TM_KERNEL_COUNT; kernel++)
    for (int dim = 2; dim <= 3; dim++) {
      static tm_asph_table t;
      tm_asph_make(kernel, dim, &t);
      for (int k = 1; k < TM_ASPH_ENTRIES; k++) UT_TRUE(t.psi[k] > t.psi[k - 1]);
      for (int k = 0; k < 100; k++) {    /* the table inverts */
        const double n = ut_random(t.least + 0.2, TM_ASPH_MOST);
        UT_NEAR(tm_asph_nodes(&t, tm_asph_lattice_psi(kernel, dim, n)), n, 2e-4);
      }
      UT_NEAR(tm_asph_nodes(&t, 0.0), t.least, 1e-15);
      UT_TRUE(tm_asph_nodes(&t, 2.0 * t.psi[TM_ASPH_ENTRIES - 1]) > TM_ASPH_MOST);
      /* all distances twice as far: h doubles, from either side, and stays there */
      for (int grow = 0; grow < 2; grow++) {
        const double target = 1.3, spacing = grow ? 2.0 : 0.5;
        double h = target;
        for (int turn = 0; turn < 60; turn++)
          h = tm_asph_next(h, target, tm_asph_nodes(&t, tm_asph_lattice_psi(kernel, dim, h / spacing)));
        UT_NEAR(h, target * spacing, 1e-3);
      }
      /* stretched along one axis: the same Psi as before at a larger h, less than the stretch */
      double h = 1.3;
      const double first = tm_asph_nodes(&t, stretched(kernel, dim, h, 1.0));
      for (int turn = 0; turn < 60; turn++)
        h = tm_asph_next(h, first, tm_asph_nodes(&t, stretched(kernel, dim, h, 1.5)));
      UT_NEAR(stretched(kernel, dim, h, 1.5), stretched(kernel, dim, 1.3, 1.0), 1e-3);
      UT_TRUE(h > 1.3 && h < 1.3 * 1.5);
    }
  /* one step is limited and h never jumps past the target */
  UT_NEAR(tm_asph_next(1.0, 1.0, 1.0), 1.0, 1e-15);
  UT_NEAR(tm_asph_next(1.0, 8.0, 1.0), 1.0 - 0.4 * (1 + 1.0 / 64) + 0.4 * (1 + 1.0 / 64) * 4.0, 1e-14);
  UT_NEAR(tm_asph_next(1.0, 0.5, 1.0), 1.0 - 0.4 * 1.25 + 0.4 * 1.25 * 0.5, 1e-14);
  /* against S13 (5) step by step */
  for (int dim = 2; dim <= 3; dim++) {
    double h = 2.0, rho = 1.5;
    for (int k = 0; k < 100000; k++) {
      h -= h / (dim * rho) * -5e-6;
      rho -= 5e-6;
    }
    UT_NEAR(tm_density_h(2.0, dim, 1.5, rho), h, 1e-5);
  }
  return ut_summary();
}
