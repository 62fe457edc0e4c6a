/* Lattice sums against values summed independently (numpy, wave vectors on a fine mesh), the surface
   of a flat face layer by layer, and the heat flux through it. */
#include "tm_surface_flux.h"
#include "ut.h"

static const struct {
  int kernel, dim;
  double h, gradient, interface, rate;   /* rate: before the division by gradient */
} known[] = {
    {TM_KERNEL_HYPERBOLIC, 2, 1.2, 0.9452, 0.9080, 5.612}, {TM_KERNEL_HYPERBOLIC, 3, 1.2, 0.9624, 0.7886, 6.074},
    {TM_KERNEL_HYPERBOLIC, 3, 1.5, 0.9995, 0.7247, 6.332}, {TM_KERNEL_CUBIC, 2, 1.3, 1.0105, 0.8340, 5.758},
    {TM_KERNEL_QUINTIC, 3, 1.2, 0.9991, 0.7234, 4.001},    {TM_KERNEL_WENDLAND_C2, 2, 2.0, 0.9992, 0.8141, 6.806},
    {TM_KERNEL_WENDLAND_C4, 3, 2.0, 0.9994, 0.7125, 9.140}, {TM_KERNEL_WENDLAND_C4, 2, 1.0, 0.8618, 1.0918, 5.849}};

/* n of the particle at depth layers below the face x = 0 of a half-space, spacing dp */
static tm_vec3 normal(int kernel, int dim, double dp, double h, int depth)
{
  const int m = (int) (3 * h / dp) + 1, mz = dim == 3 ? m : 0;
  const double V = dim == 3 ? dp * dp * dp : dp * dp, gradient = tm_lattice_sums(kernel, dim, h / dp).gradient;
  const double norm = tm_kernel_norm(kernel, dim, h) / (h * gradient);
  tm_vec3 n = tm_vec(0, 0, 0);
  for (int x = -m; x <= depth; x++)
    for (int y = -m; y <= m; y++)
      for (int z = -mz; z <= mz; z++) {
        const tm_vec3 d = tm_vec(-x * dp, -y * dp, -z * dp);   /* x_i - x_j */
        const double r = tm_vec_norm(d);
        if (r > 0) n = tm_vec_axpy(n, V * norm * tm_kernel_slope(kernel, r / h) / r, d);
      }
  return n;
}

int main(void)
{
  for (size_t k = 0; k < sizeof(known) / sizeof(known[0]); k++) {
    const tm_lattice l = tm_lattice_sums(known[k].kernel, known[k].dim, known[k].h);
    UT_WITHIN(l.gradient, known[k].gradient, 6e-5);
    UT_WITHIN(l.interface, known[k].interface, 6e-5);
    UT_NEAR(l.heat_rate * l.gradient, known[k].rate, 2e-3);
  }

  /* a flat face: its layers carry its area, the interior none, whatever the threshold */
  for (int kernel = 0; kernel < TM_KERNEL_COUNT; kernel++)
    for (int dim = 2; dim <= 3; dim++)
      for (double threshold = 0; threshold < 0.9; threshold += 0.25) {
        const double dp = 0.02, h = 1.6 * dp, V = pow(dp, dim), facet = pow(dp, dim - 1);
        const tm_surface s = tm_surface_make(kernel, dim, dp, h, threshold);
        double area = 0, face = 0, away = 0;
        for (int depth = 0; depth < 8; depth++) {
          const tm_vec3 n = normal(kernel, dim, dp, h, depth);
          area += tm_surface_area(&s, n, V);
          face += tm_surface_area_facing(&s, n, V, tm_vec(1, 0, 0));
          away += tm_surface_area_facing(&s, n, V, tm_vec(-1, 0, 0));
          if (threshold > 0.2 && depth > 2) UT_TRUE(tm_surface_area(&s, n, V) == 0);
        }
        UT_NEAR(area, facet, 1e-12);
        UT_NEAR(face, facet, 1e-12);
        UT_WITHIN(away, 0, 1e-12 * facet);
      }

  /* one particle: m = 2, rho = 4, V = 0.5, cp = 10, carrying a third of a face */
  tm_real main_record[TM_REC] = {0, 0, 0, 2, 0, 0, 0, 4}, heat[TM_REC_HEAT] = {400, 50};
  const tm_real n[3] = {-3, 4, 0};
  const int type[1] = {0};
  tm_material m = {0};
  m.capacity.value = 10;
  m.emissivity = 0.25;
  tm_surface_flux_args a = {0};
  a.rec.main = main_record; a.rec.heat = heat; a.normal = n; a.type = type; a.material = &m;
  a.surface.least = 1; a.surface.scale = 0.1; a.area_factor = 2; a.emissivity = -1;
  a.strength = 7; a.T_inf = 300;
  a.mode = TM_FLUX_GIVEN;
  UT_NEAR(tm_surface_flux(0, &a).area, 0.5, 1e-15);
  UT_NEAR(tm_surface_flux(0, &a).power, 3.5, 1e-15);
  UT_TRUE(tm_surface_flux(0, &a).rate == 0);
  a.mode = TM_FLUX_SOURCE;
  UT_NEAR(tm_surface_flux(0, &a).power, 3.5, 1e-15);
  UT_TRUE(tm_surface_flux(0, &a).area == 0);
  a.mode = TM_FLUX_CONVECTION;
  for (int space = 0; space < 2; space++) {    /* half an edge of conduction in series */
    const double part = 1 / (7 * (1 / 7. + 0.5 * pow(0.5, space ? 1 / 3. : 0.5) / 50));
    a.dim3 = space;
    UT_NEAR(tm_surface_flux(0, &a).power, -350 * part, 1e-15);
    UT_NEAR(tm_surface_flux(0, &a).rate, 0.5 * 7 / 20 * part, 1e-15);
  }
  heat[TM_REC_K] = 0;    /* does not conduct */
  UT_NEAR(tm_surface_flux(0, &a).power, -350, 1e-15);
  UT_NEAR(tm_surface_flux(0, &a).rate, 0.5 * 7 / 20, 1e-15);
  a.dt = 0.66 / 0.175;    /* a step that is stable takes the flux as it is, a longer one what a decay takes, never below T_inf */
  UT_NEAR(tm_surface_flux(0, &a).power, -350, 1e-15);
  a.dt = 5 / 0.175;
  UT_NEAR(a.dt * tm_surface_flux(0, &a).power / 20, -100 * (1 - exp(-5.)), 1e-14);
  a.dt = 1e9;
  UT_TRUE(400 + a.dt * tm_surface_flux(0, &a).power / 20 >= 300 - 1e-9);
  a.T_inf = 500;          /* nor above it */
  UT_TRUE(400 + a.dt * tm_surface_flux(0, &a).power / 20 <= 500 + 1e-9);
  a.T_inf = 300;
  a.dt = 0;
  a.mode = TM_FLUX_RADIATION;
  a.strength = 5.67e-8;
  const double below = 0.5 * 0.25 * 5.67e-8 * (300. * 300 * 300 * 300 - 400. * 400 * 400 * 400);
  UT_NEAR(tm_surface_flux(0, &a).power, below, 1e-13);
  UT_NEAR(tm_surface_flux(0, &a).rate, 0.5 * 0.25 * 5.67e-8 * 4 * 400. * 400 * 400 / 20, 1e-13);
  a.emissivity = 0.5;
  UT_NEAR(tm_surface_flux(0, &a).power, 2 * below, 1e-13);
  /* the surface radiates what comes through half an edge: within the square of the small drop of temperature */
  heat[TM_REC_K] = 1000;
  a.dim3 = 1;
  const double q = tm_surface_flux(0, &a).power / 0.5, surface = 400 + q * 0.5 * cbrt(0.5) / 1000;
  UT_NEAR(tm_surface_flux(0, &a).power / 0.5, 0.5 * 5.67e-8 * (pow(300, 4) - pow(surface, 4)), 1e-3);
  a.facing = 1;
  a.d = tm_vec(1, 0, 0);   /* n points inwards */
  UT_NEAR(tm_surface_flux(0, &a).area, 0.3, 1e-15);
  a.d = tm_vec(0, 1, 0);
  UT_TRUE(tm_surface_flux(0, &a).area == 0);
  a.facing = 0;
  a.surface.least = 6;
  UT_TRUE(tm_surface_flux(0, &a).area == 0);

  /* rise by a heat: 450 at 300 to 900 at 500, 500 from 700 on */
  m.capacity.n = 3;
  const double t[] = {300, 500, 700}, c[] = {450, 900, 500};
  for (int k = 0; k < 3; k++) { m.capacity.t[k] = t[k]; m.capacity.y[k] = c[k]; }
  UT_NEAR(tm_heat_rise(&m, 300, 10 * (450 + 472.5) / 2), 10, 1e-6);
  UT_NEAR(tm_heat_rise(&m, 310, -10 * (450 + 472.5) / 2), -10, 1e-6);
  UT_NEAR(tm_heat_rise(&m, 800, 500), 1, 1e-15);
  return ut_summary();
}
