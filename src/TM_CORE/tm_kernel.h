/* SPH-TM: smoothing kernels.

     W(r) = norm(dim, h) shape(q),  dW/dr = norm(dim, h)/h slope(q),  q = r/h >= 0

   With (a)+ = a where positive and 0 elsewhere every shape is one expression without cases:
     hyperbolic    (2-q)+^3 - 2(1-q)+^3                       Yang, Liu, Peng 2014, F15 [21]
                   = q^3-6q+6 below 1, (2-q)^3 below 2; the slope at 0 is -6, not 0
     cubic         (2-q)+^3/4 - (1-q)+^3                      M4 spline, F14 (7)
     quintic       (3-q)+^5 - 6(2-q)+^5 + 15(1-q)+^5          M6 spline
     Wendland C2   (1-q/2)+^4 (2q+1)                          2D and 3D function of Wendland 1995
     Wendland C4   (1-q/2)+^6 (35q^2/12+3q+1)
   Shape and slope are exactly zero at and beyond the support. The norms make the integral over
   space 1 (checked by quadrature in unittest/c/test_kernel.c). In one dimension the Wendland
   kernels are the same radial functions, normalized on the line. */
#ifndef TM_KERNEL_H
#define TM_KERNEL_H

#include "tm_real.h"

enum tm_kernel {
  TM_KERNEL_HYPERBOLIC = 0,
  TM_KERNEL_CUBIC,
  TM_KERNEL_QUINTIC,
  TM_KERNEL_WENDLAND_C2,
  TM_KERNEL_WENDLAND_C4,
  TM_KERNEL_COUNT
};

/* Radius in units of h beyond which the kernel is zero. */
TM_FN tm_real tm_kernel_support(int kernel) { return kernel == TM_KERNEL_QUINTIC ? 3.0 : 2.0; }

/* Constant of W, 1/h^dim included; dim = 1, 2, 3, h > 0. NaN for an unknown kernel. */
TM_FN tm_real tm_kernel_norm(int kernel, int dim, tm_real h)
{
  const tm_real area = TM_PI * h * h;
  const tm_real v = dim == 1 ? 1.0 / h : dim == 2 ? 1.0 / area : 1.0 / (area * h);
  tm_real c1 = NAN, c2 = NAN, c3 = NAN;
  /* clang-format off */
  switch (kernel) {
    case TM_KERNEL_HYPERBOLIC: c1 = 1.0 / 7.0; c2 = 1.0 / 3.0; c3 = 15.0 / 62.0; break;
    case TM_KERNEL_CUBIC: c1 = 2.0 / 3.0; c2 = 10.0 / 7.0; c3 = 1.0; break;
    case TM_KERNEL_QUINTIC: c1 = 1.0 / 120.0; c2 = 7.0 / 478.0; c3 = 1.0 / 120.0; break;
    case TM_KERNEL_WENDLAND_C2: c1 = 3.0 / 4.0; c2 = 7.0 / 4.0; c3 = 21.0 / 16.0; break;
    case TM_KERNEL_WENDLAND_C4: c1 = 27.0 / 32.0; c2 = 9.0 / 4.0; c3 = 495.0 / 256.0; break;
  }
  /* clang-format on */
  return v * (dim == 1 ? c1 : dim == 2 ? c2 : c3);
}

/* [hot] W / norm; kernel is a literal. */
TM_FN tm_pair tm_kernel_shape(int kernel, tm_pair q)
{
  const tm_pair a1 = tm_pair_max(1 - q, 0), a2 = tm_pair_max(2 - q, 0);
  if (kernel == TM_KERNEL_HYPERBOLIC) return a2 * a2 * a2 - 2 * (a1 * a1 * a1);
  if (kernel == TM_KERNEL_CUBIC) return TM_PAIR(0.25) * (a2 * a2 * a2) - a1 * a1 * a1;
  if (kernel == TM_KERNEL_QUINTIC) {
    const tm_pair a3 = tm_pair_max(3 - q, 0), b1 = a1 * a1, b2 = a2 * a2, b3 = a3 * a3;
    return b3 * b3 * a3 - 6 * (b2 * b2 * a2) + 15 * (b1 * b1 * a1);
  }
  const tm_pair b = TM_PAIR(0.25) * a2 * a2; /* (1-q/2)^2 */
  if (kernel == TM_KERNEL_WENDLAND_C2) return b * b * (2 * q + 1);
  return b * b * b * ((TM_PAIR(35.0 / 12.0) * q + 3) * q + 1);
}

/* Where the hyperbolic kernel is rounded, over h; a lattice has no pairs as close. */
#define TM_KERNEL_CORE 0.25

/* [hot] d shape / dq, never positive; kernel is a literal. The hyperbolic kernel alone has a slope at q = 0, -6: the force
   of a pair would jump from one side to the other where its particles pass each other, and W'/r of what equalizes (heat,
   displacements of hourglass control) would have no bound. Large plastic flow draws pairs as close as 1e-3 of the spacing;
   no step resolves the jump, and the energy drifts or the pair is thrown apart. Closer than TM_KERNEL_CORE the slope goes to
   0 with q instead, W'/r stays at five times that of neighbors in a lattice, as with Wendland C2 everywhere. Gradients of
   velocity, stress and temperature take the same, so energy and momenta stay exact. */
TM_FN tm_pair tm_kernel_slope(int kernel, tm_pair q)
{
  const tm_pair a1 = tm_pair_max(1 - q, 0), a2 = tm_pair_max(2 - q, 0);
  if (kernel == TM_KERNEL_HYPERBOLIC)
    return (6 * (a1 * a1) - 3 * (a2 * a2)) * tm_pair_min(TM_PAIR(1.0 / TM_KERNEL_CORE) * q, 1);
  if (kernel == TM_KERNEL_CUBIC) return 3 * (a1 * a1) - TM_PAIR(0.75) * (a2 * a2);
  if (kernel == TM_KERNEL_QUINTIC) {
    const tm_pair a3 = tm_pair_max(3 - q, 0), b1 = a1 * a1, b2 = a2 * a2, b3 = a3 * a3;
    return -5 * (b3 * b3) + 30 * (b2 * b2) - 75 * (b1 * b1);
  }
  const tm_pair a = TM_PAIR(0.5) * a2, b = a * a;
  if (kernel == TM_KERNEL_WENDLAND_C2) return -5 * q * (b * a);
  return TM_PAIR(-7.0 / 3.0) * q * (b * b * a) * (5 * q + 2);
}

#endif
