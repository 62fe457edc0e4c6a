/* Splitting patterns: overlap integrals against brute force, published masses, symmetry, refusals. */
#include "tm_split_pattern.h"
#include "ut.h"

/* the integral over a fine grid; the kernels are smooth enough for 1e-6 */
static double brute(int kernel, int dim, double alpha, double d)
{
  const double reach = tm_kernel_support(kernel), dx = dim == 2 ? 0.01 : 0.05;
  const int n = (int) (reach / dx) + 1, nz = dim == 3 ? n : 0;
  double sum = 0.0;
  for (int i = -n; i <= n; i++)
    for (int j = -n; j <= n; j++)
      for (int k = -nz; k <= nz; k++) {
        const double x = i * dx, y = j * dx, z = k * dx;
        const double r = sqrt(x * x + y * y + z * z), s = sqrt((x - d) * (x - d) + y * y + z * z);
        sum += tm_kernel_shape(kernel, r) * tm_kernel_shape(kernel, s / alpha);
      }
  const double cell = dim == 3 ? dx * dx * dx : dx * dx;
  return sum * cell * tm_kernel_norm(kernel, dim, 1.0) * tm_kernel_norm(kernel, dim, alpha);
}

int main(void)
{
  for (int kernel = 0; kernel < TM_KERNEL_COUNT; kernel++)
    for (int dim = 2; dim <= 3; dim++)
      for (int k = 0; k < 4; k++) {
        const double d = 0.45 * k, alpha = 0.6 + 0.15 * k, at_0 = tm_kernel_overlap(kernel, dim, alpha, 0.0);
        UT_WITHIN(tm_kernel_overlap(kernel, dim, alpha, d), brute(kernel, dim, alpha, d),
                  (dim == 2 ? 2e-6 : 4e-4) * at_0);
        /* which of two kernels is called the first does not matter */
        const double unit = pow(alpha, -dim);
        UT_NEAR(tm_kernel_overlap(kernel, dim, alpha, d),
                unit * tm_kernel_overlap(kernel, dim, 1 / alpha, d / alpha), 1e-10);
      }

  tm_split_pattern p;
  /* Feldman and Bonet's hexagon, S13 [5]: published for the cubic spline; found by quadrature for the hyperbolic */
  UT_TRUE(tm_split_make(TM_SPLIT_HEXAGON, TM_KERNEL_CUBIC, 0.4, 0.9, &p) == TM_SPLIT_OK);
  UT_WITHIN(p.mass[0], 0.178706, 1e-6);
  for (int k = 1; k < 7; k++) UT_WITHIN(p.mass[k], 0.136882, 1e-6);
  UT_TRUE(tm_split_make(TM_SPLIT_HEXAGON, TM_KERNEL_HYPERBOLIC, 0.4, 0.9, &p) == TM_SPLIT_OK);
  UT_WITHIN(p.mass[0], 0.367787, 1e-6);
  for (int k = 1; k < 7; k++) UT_WITHIN(p.mass[k], 0.105369, 1e-6);
  /* a negative centre is refused, and told */
  UT_TRUE(tm_split_make(TM_SPLIT_HEXAGON, TM_KERNEL_CUBIC, 0.4, 0.8, &p) == TM_SPLIT_NEGATIVE);
  UT_WITHIN(p.mass[0], -0.322, 1e-3);

  /* children as wide as the parent: the centre takes all */
  UT_TRUE(tm_split_make(TM_SPLIT_HEXAGON, TM_KERNEL_CUBIC, 0.6, 1.0, &p) == TM_SPLIT_NEGATIVE);
  UT_WITHIN(p.mass[0], 1.0, 1e-9);

  for (int kind = 0; kind < TM_SPLIT_KINDS; kind++)
    for (int kernel = 0; kernel < TM_KERNEL_COUNT; kernel++) {
      const int status = tm_split_make(kind, kernel, 0.5, 0.9, &p);
      UT_TRUE(status == TM_SPLIT_OK || status == TM_SPLIT_NEGATIVE);
      UT_TRUE(p.dim == tm_split_dim(kind) && p.n <= TM_SPLIT_MOST);
      double m = 0.0, first[3] = {0, 0, 0};
      for (int k = 0; k < p.n; k++) {
        m += p.mass[k];
        for (int c = 0; c < 3; c++) first[c] += p.mass[k] * p.x[k][c];
      }
      UT_WITHIN(m, 1.0, 1e-13);
      for (int c = 0; c < 3; c++) UT_WITHIN(first[c], 0.0, 1e-13);
      if (kind == TM_SPLIT_SQUARE) UT_NEAR(p.mass[0], 0.25, 1e-10);
      if (kind == TM_SPLIT_CUBE) UT_NEAR(p.mass[7], 0.125, 1e-10);
      UT_TRUE(p.error >= 0.0 && p.error < 1.0);
    }
  /* the closer and the larger the children, the smaller the error */
  double last = 1.0;
  for (int k = 0; k < 3; k++) {
    const double e[3] = {0.4, 0.2, 0.1}, a[3] = {0.9, 0.97, 0.99};
    tm_split_make(TM_SPLIT_CUBE, TM_KERNEL_WENDLAND_C2, e[k], a[k], &p);
    UT_TRUE(p.error < last);
    last = p.error;
  }
  UT_TRUE(tm_split_make(TM_SPLIT_KINDS, 0, 0.5, 0.9, &p) == TM_SPLIT_BAD_INPUT);
  UT_TRUE(tm_split_make(0, TM_KERNEL_COUNT, 0.5, 0.9, &p) == TM_SPLIT_BAD_INPUT);
  UT_TRUE(tm_split_make(0, 0, 0.0, 0.9, &p) == TM_SPLIT_BAD_INPUT);
  UT_TRUE(tm_split_make(0, 0, 0.5, -0.9, &p) == TM_SPLIT_BAD_INPUT);
  UT_TRUE(tm_split_make(0, 0, NAN, 0.9, &p) == TM_SPLIT_BAD_INPUT);
  UT_TRUE(tm_split_make(TM_SPLIT_HEXAGON, 0, 1e-7, 0.9, &p) == TM_SPLIT_SINGULAR);
  return ut_summary();
}
