/* The host's half of the test that compares a GPU with the host: the same headers, compiled as C. */
#include "on_host.h"

#include "ut_mesh.h"

void points_on_host(int which, int n, int n_in, int n_out, const double *in, const tm_material *m, double *out, double *scale)
{
  for (int i = 0; i < n; i++) scale[i] = point_run(which, in + (ptrdiff_t) i * n_in, m, out + (ptrdiff_t) i * n_out);
}

void cloud_on_host(int stage, cloud *w)
{
  for (int i = 0; i < w->n; i++) cloud_run(stage, i, w);
}

void rows_on_host(cloud *w)
{
  const tm_row_args a = cloud_row_args(w);
  ptrdiff_t at = 0;
  for (int i = 0; i < w->n; i++) tm_row_count(i, &a);
  for (int s = 0; s * TM_ROW_SLICE < w->n; s++) {
    for (int i = s * TM_ROW_SLICE; i < w->n && i < (s + 1) * TM_ROW_SLICE; i++) w->first[i] = at + i % TM_ROW_SLICE;
    at += tm_row_slice_size(s, w->n, &a);
  }
  for (int i = 0; i < w->n; i++) tm_row_fill(i, &a);
  w->slice = TM_ROW_SLICE;
}

void random_fill(double *p, ptrdiff_t n, double lo, double hi)
{
  for (ptrdiff_t k = 0; k < n; k++) p[k] = ut_random(lo, hi);
}

/* --- the cloud: two bodies that meet in the middle, a lattice with noise, all fields at random in their range */

static void make_particle(cloud *w, int i, const int *at, int side)
{
  const double dp = w->spacing, noise = 0.12 * dp;
  for (int d = 0; d < 3; d++) {
    const int in_plane = d < w->dim;
    w->x[3 * i + d] = in_plane ? (at[d] + 0.5) * dp + ut_random(-noise, noise) : 0.0;
    w->v[3 * i + d] = in_plane ? ut_random(-20, 20) : 0.0;
    w->force[3 * i + d] = in_plane ? ut_random(-1e2, 1e2) : 0.0;
    w->force_internal[3 * i + d] = in_plane ? ut_random(-1e2, 1e2) : 0.0;
    w->xsph[3 * i + d] = in_plane ? ut_random(-1, 1) : 0.0;
    w->hourglass[TM_G_COLUMNS * i + TM_G_U + d] = in_plane ? 0.01 * dp * ut_random(-1, 1) : 0.0;
    w->hourglass[TM_G_COLUMNS * i + TM_G_RATE + d] = in_plane ? ut_random(-1, 1) : 0.0;
  }
  w->type[i] = 1 + (at[w->dim - 1] >= side / 2);
  w->mask[i] = 1 + 2 * (i % 3 == 0);
  w->tag[i] = (int) ((i * 7919ll + 13) % 1000003);
  const tm_real rho = w->material[w->type[i]].rho0 * ut_random(0.99, 1.02);
  w->rho[i] = rho;
  const tm_sym3 s = tm_sym(ut_random(-3e8, 3e8), ut_random(-3e8, 3e8), ut_random(-3e8, 3e8), ut_random(-2e8, 2e8),
                           w->dim == 3 ? ut_random(-2e8, 2e8) : 0.0, w->dim == 3 ? ut_random(-2e8, 2e8) : 0.0);
  tm_sym_store(w->stress + 6 * i, tm_sym_deviator(s));
  for (int step = 0; step < 2; step++) {
    double *h = w->history + (ptrdiff_t) i * TM_H_COLUMNS + step * TM_H_STEP;
    random_fill(h + TM_H_V, w->dim, -1e7, 1e7);
    h[TM_H_RHO] = ut_random(-1e7, 1e7);
    random_fill(h + TM_H_S, w->dim == 3 ? 6 : 4, -1e14, 1e14);
    h[TM_H_S + 2] = -h[TM_H_S] - h[TM_H_S + 1];
  }
  w->pstrain[3 * i] = ut_random(0, 0.5);
  w->temperature[3 * i] = ut_random(300, 1500);
  w->temperature[3 * i + 1] = ut_random(-1e6, 1e6);
  w->temperature[3 * i + 2] = ut_random(-1e6, 1e6);
  w->energy[3 * i] = ut_random(0, 1e4);
  w->energy[3 * i + 1] = ut_random(-1e9, 1e9);
  w->energy[3 * i + 2] = ut_random(-1e9, 1e9);
  w->damage[2 * i] = ut_random(0, 0.999);
  w->damage[2 * i + 1] = i % 17 == 0;
  w->balsara[i] = ut_random(0, 1);
  w->thickness[i] = ut_random(0.9, 1.1);
  tm_size_initial(w->size + TM_S_COLUMNS * i, w->mass[w->type[i]], w->material[w->type[i]].rho0, w->h / dp, w->dim == 3);
  w->size[TM_S_COLUMNS * i + TM_S_H] *= ut_random(0.9, 1.1);
  w->source[i] = ut_random(0, 1e2);
  w->unstrained[i] = ut_random(250, 350);
  double *K = w->turned + TM_K_COLUMNS * i;
  random_fill(K, 6, -0.1, 0.1);
  random_fill(K + TM_K_RATE, 6, -1e5, 1e5);
  for (int d = 0; d < 3; d++) K[d] += 1.0;
  random_fill(K + TM_K_SPIN, 3, -1e4, 1e4);
  K[TM_K_SINCE] = 0.5 * w->dt;
  if (i % 13 == 0) K[0] = 0.0;    /* not known yet */
  if (i % 3 == 0) random_fill(w->face + TM_FACE_COLUMNS * i + TM_FACE_NORMAL, w->dim, -0.5, 0.5);
  if (i % 3 == 0) random_fill(w->face + TM_FACE_COLUMNS * i + TM_FACE_TURN, 3, -0.05, 0.05);
  if (i % 2 == 0) { /* the others begin to strain where they touch */
    double *layer = w->body_layer + TM_L_COLUMNS * i;
    random_fill(layer + TM_L_STRESS, 6, -1e8, 1e8);
    layer[TM_L_AHEAD] = ut_random(-1e8, 1e8);
    layer[TM_L_STRAIN] = ut_random(-0.2, 0.1);
    layer[TM_L_NEAR] = TM_LAYER_NOW - 1.0;
    layer[TM_L_TOOL] = i % 4 ? TM_LAYER_OF_BODIES : -TM_LAYER_OF_BODIES;
  }
}

static void make_list(cloud *w)
{
  const double radius = 1.1 * tm_kernel_support(w->kernel) * w->h;
  for (int i = 0; i < w->n; i++) {
    w->length[i] = 0;
    for (int j = 0; j < w->n; j++) {
      const tm_vec3 d = tm_vec_sub(tm_load3(w->x + 3 * i), tm_load3(w->x + 3 * j));
      if (i != j && tm_vec_dot(d, d) < radius * radius && w->length[i] < ROOM) w->list[i * ROOM + w->length[i]++] = j;
    }
  }
}

void cloud_make(cloud *w, int dim, int kernel, double ratio, unsigned effects, tm_mesh *mesh, tm_tri_grid *grid)
{
  memset(w, 0, sizeof *w);
  w->effects = effects | (unsigned) kernel << TM_FX_KERNEL_SHIFT | (dim == 3 ? (unsigned) TM_FX_3D : 0u);
  w->dim = dim;
  w->kernel = kernel;
  w->spacing = 1e-3;
  w->h = ratio * w->spacing;
  w->dt = 1e-7;
  for (int t = 1; t <= TYPES; t++) {
    w->touch_strains[t] = 1;
    points_material(t == 1 ? POINTS_PLASTIC : POINTS_JOHNSON_COOK, w->material + t);
    w->mass[t] = w->material[t].rho0 * pow(w->spacing, dim);
    w->effusivity[t] = 1e4 * t;
    tm_contact_law *law = w->law + t;
    law->active = 1;
    law->radius = 0.5 * w->spacing;
    law->stiffness = tm_contact_stiffness(0.1 * w->material[t].young, w->spacing, w->spacing, dim == 3);
    law->damping = 0.2;
    law->area = pow(w->spacing, dim - 1);
    law->friction.value = 0.3;
    law->share = -1.0;
    law->tool_effusivity = 8e3;
    law->conductance = 1e5;
  }
  for (int a = 1; a <= TYPES; a++)
    for (int b = 1; b <= TYPES; b++) {
      const int pair = a * (TYPES + 1) + b;
      w->meets[pair] = a == b ? TM_MEETS_MECHANICAL : TM_MEETS_THERMAL | TM_MEETS_CONTACT;
      w->touch_side[pair] = a != b;
      w->conductance[pair] = a != b ? 2e4 : 0.0;
      w->touch_law[pair].friction.value = 0.2; w->touch_law[pair].damping = 0.3;
      w->touch_law[pair].modulus = 0.1 * tm_contact_modulus_of_two(w->material[a].young, w->material[b].young);
    }
  w->body_surface = tm_body_surface_make(dim, tm_kernel_support(kernel) * ratio);
  tm_gradient_table(kernel, dim, w->factor);
  const int side = dim == 3 ? SIDE : 31;
  for (int a = 0; a < side; a++)
    for (int b = 0; b < side; b++)
      for (int c = 0; c < (dim == 3 ? side : 1); c++) {
        const int at[3] = {a, b, c};
        make_particle(w, w->n++, at, side);
      }
  make_list(w);
  rows_on_host(w);

  const double size = side * w->spacing;
  tm_soup soup = ut_soup(12 * 16);
  ut_box(&soup, tm_vec(0.2 * size, 0.2 * size, dim == 3 ? 0.2 * size : -size),
         tm_vec(0.7 * size, 0.6 * size, dim == 3 ? 0.7 * size : size), 4);
  *mesh = ut_build(&soup);
  UT_TRUE(tm_tri_grid_build(grid, mesh, w->spacing, TM_GRID_BUDGET) == TM_MESH_OK);
  w->mesh = tm_mesh_view(mesh);
  w->grid = grid->view;
  w->from = w->to = tm_pose_rest();
  w->to.turn = tm_rotation_about(tm_vec(0, 0, 1), 0.1);
  w->to.shift = tm_vec(0.02 * size, 0.0, 0.0);
  w->to.velocity = tm_vec(10.0, -5.0, 0.0);
  w->to.omega = tm_vec(0.0, 0.0, 1e3);
}

int points_not_built(void) { return ut_failures; }
