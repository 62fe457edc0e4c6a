/* Contact between bodies whose half spacing up to the surface strains (tm_body_layer.h): forces against the energy of the springs,
   the books of energy and momentum. */
#include "ut_bodies.h"

/* Layers that strain, of both bodies or one: forces against the energy of the springs at given thickness; work on particles and
   layers = - rate of the springs - damping - friction; momentum. */
static void layers(void)
{
  const unsigned both = 2, effect = TM_FX_3D;
  for (int dim = 2; dim < 4; dim++)
    for (unsigned bodies = 1; bodies <= both; bodies++) {
      begin(dim);
      cloud(dim);
      all_rows();
      b.layer = s.layer;
      b.thin = s.thin;
      b.strains = s.strains;
      b.layer_dt = 1e-14;
      a.gradient = s.gradient;
      for (int t = 1; t <= TYPES; t++) s.strains[t] = t <= (int) bodies;
      for (int k = 0; k < 9 * s.n; k++) s.gradient[k] = (dim == 3 || (k % 3 < 2 && k % 9 < 6)) ? ut_random(-1, 1) : 0.0;
      double strain[MOST], rate[MOST];
      for (int i = 0; i < s.n; i++) {
        double *row = s.layer + i * TM_L_COLUMNS;
        rec(i)[TM_REC_RHO] = 1.3;
        row[TM_L_STRAIN] = strain[i] = ut_random(-0.3, 0.2);
        row[TM_L_NEAR] = TM_LAYER_NOW;
        row[TM_L_TOOL] = TM_LAYER_OF_BODIES;
      }
      for (int k = 0; k < (TYPES + 1) * (TYPES + 1); k++) {
        s.law[k].friction.value = 0.4;
        s.law[k].damping = 0.3;
      }
      tm_body_contact_result r = run();
      int thin = 0;
      double on_layers = 0.0, big = 0.0;
      tm_vec3 P = tm_vec(0, 0, 0);
      for (int i = 0; i < s.n; i++) {
        double *row = s.layer + i * TM_L_COLUMNS;
        const double by = s.thin[i * TM_THIN + TM_THIN_BY];
        P = tm_vec_add(P, tm_vec(s.force[3 * i], s.force[3 * i + 1], s.force[3 * i + 2]));
        big = fmax(big, fabs(s.force[3 * i]));
        rate[i] = 0.0;
        if (s.thin[i * TM_THIN + TM_THIN_SIDE] == 0.0) continue;
        UT_TRUE(s.type[i] <= (int) bodies);
        thin++;
        tm_vec3 n;
        double arm;
        UT_TRUE(tm_body_psi(i, 0, &a, &b, dim == 3, &n) > 0.0);
        n = tm_vec_scale(1.0 / tm_vec_norm(n), n);
        UT_WITHIN(by, 0.5 * tm_layer_stretch(strain[i], &arm) - 0.5, 1e-14);
        rate[i] = tm_vec_dot(n, tm_mat_mul_vec(tm_mat_from_row(s.gradient + 9 * i), n));
        UT_NEAR(s.thin[i * TM_THIN + TM_THIN_RATE], 0.5 * arm * rate[i], 1e-12);
        /* of the stress, what is of this force point */
        const tm_sym3 T = tm_sym_from_row(row + TM_L_STRESS);
        on_layers += (tm_sym_trace(T) - row[TM_L_AHEAD]) * rate[i] * rec(i)[TM_REC_M] / rec(i)[TM_REC_RHO];
        UT_WITHIN(tm_vec_dot(n, tm_sym_mul_vec(T, n)), tm_sym_trace(T), 1e-12 * fabs(tm_sym_trace(T)));
      }
      UT_TRUE(thin > (dim == 3 ? 8 : 3));
      UT_WITHIN(tm_vec_norm(P), 0.0, 1e-12 * big * s.n);
      double spring[2], work = r.work_power - on_layers;
      for (int k = 0; k < 2; k++) {
        const double t = k ? 2e-7 : -1e-7, at = k ? 1e-7 : -1e-7;
        for (int i = 0; i < s.n; i++) {
          double *row = s.layer + i * TM_L_COLUMNS;
          for (int d = 0; d < dim; d++) rec(i)[d] += t * rec(i)[TM_REC_V + d];
          row[TM_L_STRAIN] = strain[i] + at * rate[i];
          row[TM_L_NEAR] = TM_LAYER_NOW;
        }
        spring[k] = run().spring;
      }
      const double change = (spring[1] - spring[0]) / 2e-7, lost = r.damping_power + r.friction_power;
      printf("%dd, layers of %u: %d, work %.8g against %.8g, of the layers %.3g\n", dim, bodies, thin, work,
             -(change + lost), on_layers);
      UT_TRUE(fabs(on_layers) > 0.01 * fabs(work));
      UT_WITHIN(work, -(change + lost), 2e-6 * (fabs(change) + lost));
      /* a new one begins at touch; one that is there stays until the other body is away */
      for (int i = 0; i < s.n; i++) {
        tm_vec3 n;
        const double psi = tm_body_psi(i, 0, &a, &b, dim == 3, &n);
        s.layer[i * TM_L_COLUMNS + TM_L_NEAR] = 0.0;
        tm_body_thin(i, &a, &b, dim == 3 ? effect : 0u);
        UT_TRUE((s.thin[i * TM_THIN + TM_THIN_SIDE] > 0.0) == (s.type[i] <= (int) bodies && psi > 1.0));
        UT_WITHIN(s.thin[i * TM_THIN + TM_THIN_BY], 0.0, 1e-12);
        s.layer[i * TM_L_COLUMNS + TM_L_NEAR] = 1.0;
        tm_body_thin(i, &a, &b, dim == 3 ? effect : 0u);
        UT_TRUE((s.thin[i * TM_THIN + TM_THIN_SIDE] > 0.0) == (s.type[i] <= (int) bodies && psi > 0.0));
      }
      /* a layer that a tool owns is not the bodies', one that is forgotten begins anew */
      s.layer[TM_L_TOOL] = 3.0;
      tm_body_thin(0, &a, &b, dim == 3 ? effect : 0u);
      UT_TRUE(s.thin[TM_THIN_SIDE] == 0.0);
    }
}
int main(void)
{
  layers();
  free(s.row);
  return ut_summary();
}
