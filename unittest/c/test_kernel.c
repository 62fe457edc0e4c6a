/* Smoothing kernels: the published forms, integral 1, slope against differences, lattice sums. */
#include "tm_kernel.h"
#include "ut.h"

/* the published piecewise forms, independent of the ()+ form in tm_kernel.h */
static double published(int kernel, double q)
{
  switch (kernel) {
    case TM_KERNEL_HYPERBOLIC: return q < 1 ? q * q * q - 6 * q + 6 : q < 2 ? pow(2 - q, 3) : 0;
    case TM_KERNEL_CUBIC:
      return q < 1 ? 1 - 1.5 * q * q + 0.75 * q * q * q : q < 2 ? 0.25 * pow(2 - q, 3) : 0;
    case TM_KERNEL_QUINTIC:
      return (q < 3 ? pow(3 - q, 5) : 0) - (q < 2 ? 6 * pow(2 - q, 5) : 0)
           + (q < 1 ? 15 * pow(1 - q, 5) : 0);
    case TM_KERNEL_WENDLAND_C2: return q < 2 ? pow(1 - q / 2, 4) * (2 * q + 1) : 0;
    default: return q < 2 ? pow(1 - q / 2, 6) * (35 * q * q / 12 + 3 * q + 1) : 0;
  }
}

/* integral of W over space: five-point Gauss on pieces of h/20, exact for these polynomials */
static double integral(int kernel, int dim, double h)
{
  const double b = sqrt(10.0 / 7.0), node[5] = {0, sqrt(5 - 2 * b) / 3, -sqrt(5 - 2 * b) / 3,
                                                sqrt(5 + 2 * b) / 3, -sqrt(5 + 2 * b) / 3};
  const double w1 = (322 + 13 * sqrt(70.0)) / 900, w2 = (322 - 13 * sqrt(70.0)) / 900;
  const double weight[5] = {128.0 / 225, w1, w1, w2, w2};
  double sum = 0;
  for (int piece = 0; piece < 60; piece++)
    for (int k = 0; k < 5; k++) {
      const double q = (piece + 0.5 + 0.5 * node[k]) / 20, r = q * h;
      const double shell = dim == 1 ? 2 : dim == 2 ? 2 * TM_PI * r : 4 * TM_PI * r * r;
      sum += weight[k] / 40 * h * shell * tm_kernel_shape(kernel, q);
    }
  return sum * tm_kernel_norm(kernel, dim, h);
}

static double lattice_sum(int kernel, double h)
{
  double sum = 0;
  for (int x = -4; x <= 4; x++)
    for (int y = -4; y <= 4; y++)
      for (int z = -4; z <= 4; z++)
        sum += tm_kernel_shape(kernel, sqrt((double) (x * x + y * y + z * z)) / h);
  return sum * tm_kernel_norm(kernel, 3, h);
}

int main(void)
{
  for (int kernel = 0; kernel < TM_KERNEL_COUNT; kernel++) {
    for (int dim = 1; dim <= 3; dim++) {
      UT_NEAR(integral(kernel, dim, 1.0), 1.0, 1e-10);
      UT_NEAR(integral(kernel, dim, 1.7e-5), 1.0, 1e-10);
    }
    const double peak = tm_kernel_shape(kernel, 0), end = tm_kernel_support(kernel);
    for (int k = 0; k < 400; k++) {
      const double q = ut_random(0.001, 3.2), d = 1e-5;
      UT_WITHIN(tm_kernel_shape(kernel, q), published(kernel, q), 1e-13 * peak);
      const double slope = (published(kernel, q + d) - published(kernel, q - d)) / (2 * d);
      const int core = kernel == TM_KERNEL_HYPERBOLIC && q < TM_KERNEL_CORE;
      UT_WITHIN(tm_kernel_slope(kernel, q), core ? slope * q / TM_KERNEL_CORE : slope, 1e-8 * peak);
      UT_TRUE(tm_kernel_slope(kernel, q) <= 0);
      UT_TRUE(q >= end || tm_kernel_shape(kernel, q) > 0);
    }
    for (double q = end; q < 5; q += 0.37) {
      UT_TRUE(tm_kernel_shape(kernel, q) == 0);
      UT_TRUE(tm_kernel_slope(kernel, q) == 0);
    }
  }
  UT_NEAR(tm_kernel_slope(TM_KERNEL_HYPERBOLIC, TM_KERNEL_CORE), 3 * TM_KERNEL_CORE * TM_KERNEL_CORE - 6, 1e-14);
  for (int kernel = 0; kernel < TM_KERNEL_COUNT; kernel++) /* no jump where a pair passes, W'/r bounded */
    for (double q = 1e-9; q < 0.5; q *= 1.5)
      UT_TRUE(-tm_kernel_slope(kernel, q) / q < 8 * -tm_kernel_slope(kernel, 0.8) / 0.8);
  UT_NEAR(tm_kernel_slope(TM_KERNEL_HYPERBOLIC, 1.5), -0.75, 1e-14);
  UT_TRUE(tm_kernel_slope(TM_KERNEL_CUBIC, 0) == 0);
  UT_TRUE(isnan(tm_kernel_norm(TM_KERNEL_COUNT, 3, 1.0)));
  UT_WITHIN(lattice_sum(TM_KERNEL_HYPERBOLIC, 1.2), 1.0601, 5e-5);
  UT_WITHIN(lattice_sum(TM_KERNEL_CUBIC, 1.2), 1.0008, 5e-5);
  return ut_summary();
}
