/* SPH-TM: what the pair sums make of simple fields on the regular (square, cubic) lattice.

   A particle's own volume, the core of the kernel, adds nothing to a sum over gradW. What is missing
   vanishes with spacing/h, not with the spacing: with the hyperbolic kernel and h = 1.2 spacings the
   gradient of a linear field comes out 5.5 % (2D) and 3.8 % (3D) too small however fine the lattice,
   and so do strain rates, forces (elastic stiffness: the square) and conduction. All sums over gradW
   are therefore divided by G, by one constant for all pairs: momentum and energy stay as exact as
   without. A lattice that deforms keeps the missing core, so the factor stays right on the average.

     gradient   G = sum_j V |W'|/r x^2, 1 in the continuum. With plain gradW F15 (6) conducts G k, and
                the surface normals sum_j V gradW of the layers below a flat face add up to G/2
     interface  a plane between two layers conducts hc when every pair across it gets hc * interface
                (with gradW divided by G: hc * interface * G);
                2/3 (3D), pi/4 (2D) in the continuum, see tm_interface_conductance. Exact where the
                interface resists more than a particle does, within 4 % for hc dp/k up to 3
     heat_rate  fastest decay of a plane wave by F15 (6), divided by G, in units of k/(rho c_p h^2)
   The lattice has spacing 1: h stands for h over the spacing. */
#ifndef TM_LATTICE_H
#define TM_LATTICE_H

#include "tm_kernel.h"

typedef struct {
  tm_real gradient, interface, heat_rate;
} tm_lattice;

/* 2 V |W'|/r at lattice vector x y z; 0 at the origin and outside the support radius */
TM_FN tm_real tm_lattice_weight(int kernel, int dim, tm_real h, int x, int y, int z)
{
  const tm_real r = sqrt((tm_real) (x * x + y * y + z * z));
  if (r == 0.0) return 0.0;
  return -2.0 * tm_kernel_norm(kernel, dim, h) / (h * r) * tm_kernel_slope(kernel, r / h);
}
/* Spacings within the support radius. */
TM_FN int tm_lattice_cells(int kernel, tm_real h) { return (int) (tm_kernel_support(kernel) * h); }

/* sum of 2 V |W'|/r (1 - cos(k.x)), k = pi/8 (a b c) */
TM_FN tm_real tm_lattice_wave(int kernel, int dim, tm_real h, int a, int b, int c)
{
  const int cells = tm_lattice_cells(kernel, h), nz = dim == 3 ? cells : 0;
  const tm_real u = 0.125 * TM_PI;
  tm_real sum = 0.0;
  for (int x = 0; x <= cells; x++)
    for (int y = 0; y <= cells; y++)
      for (int z = 0; z <= nz; z++) /* one octant, with its mirror images */
        sum += (x ? 2 : 1) * (y ? 2 : 1) * (z ? 2 : 1) * tm_lattice_weight(kernel, dim, h, x, y, z) *
               (1.0 - cos(u * a * x) * cos(u * b * y) * cos(u * c * z));
  return sum;
}

/* Sums over the pairs between the layer x = 0 and the one at x, of weight times x and times r. */
TM_FN void tm_lattice_layer(int kernel, int dim, tm_real h, int x, tm_real *by_x, tm_real *by_r)
{
  const int cells = tm_lattice_cells(kernel, h), nz = dim == 3 ? cells : 0;
  *by_x = *by_r = 0.0;
  for (int y = -cells; y <= cells; y++)
    for (int z = -nz; z <= nz; z++) {
      const tm_real w = tm_lattice_weight(kernel, dim, h, x, y, z);
      *by_x += w * x;
      *by_r += w * sqrt((tm_real) (x * x + y * y + z * z));
    }
}

TM_FN tm_real tm_lattice_gradient(int kernel, int dim, tm_real h)
{
  tm_real sum = 0.0, by_x, by_r;
  for (int x = 1; x <= tm_lattice_cells(kernel, h); x++) {
    tm_lattice_layer(kernel, dim, h, x, &by_x, &by_r);
    sum += x * by_x;
  }
  return sum;
}

TM_FN tm_lattice tm_lattice_sums(int kernel, int dim, tm_real h)
{
  tm_lattice out;
  tm_real across = 0.0;
  out.heat_rate = 0.0;
  out.gradient = tm_lattice_gradient(kernel, dim, h);
  for (int x = 1; x <= tm_lattice_cells(kernel, h); x++) {
    tm_real by_x, by_r;
    tm_lattice_layer(kernel, dim, h, x, &by_x, &by_r);
    across += x * by_r; /* x pairs of layers cross the interface */
  }
  out.interface = 1.0 / across;
  for (int a = 0; a <= 8; a++)
    for (int b = 0; b <= a; b++)
      for (int c = 0; c <= (dim == 3 ? b : 0); c++)
        out.heat_rate = tm_max(out.heat_rate, tm_lattice_wave(kernel, dim, h, a, b, c));
  out.heat_rate *= h * h / out.gradient;
  return out;
}

/* 2 |n| of the particles in the first layer below a flat face */
TM_FN tm_real tm_lattice_face_normal(int kernel, int dim, tm_real h)
{
  tm_real n = 0.0;
  for (int x = 1; x <= tm_lattice_cells(kernel, h); x++) {
    tm_real by_x, by_r;
    tm_lattice_layer(kernel, dim, h, x, &by_x, &by_r);
    n += by_x;
  }
  return n;
}

/* 2 |n| summed over the layers below a flat face that have at least 2 |n| = least */
TM_FN tm_real tm_lattice_face_sum(int kernel, int dim, tm_real h, tm_real least)
{
  tm_real n = 0.0, sum = 0.0;
  for (int x = tm_lattice_cells(kernel, h); x >= 1; x--) { /* the layer without neighbors from x on */
    tm_real by_x, by_r;
    tm_lattice_layer(kernel, dim, h, x, &by_x, &by_r);
    n += by_x;
    if (n >= least) sum += n;
  }
  return sum;
}

#endif
