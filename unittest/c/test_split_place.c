/* Children next to a surface: turned and scaled they reach as far as their parent, and press a plane with its force
   and its energy. */
#include "tm_split_pattern.h"
#include "tm_split_place.h"
#include "ut_contact.h"

static tm_vec3 direction(int dim)
{
  for (;;) {
    const tm_vec3 d = tm_vec(ut_random(-1, 1), ut_random(-1, 1), dim == 3 ? ut_random(-1, 1) : 0.0);
    const double r = tm_vec_norm(d);
    if (r > 0.1 && r < 1.0) return tm_vec_scale(1.0 / r, d);
  }
}

static void turns(void)
{
  for (int turn = 0; turn < 200; turn++) {
    const tm_vec3 n = direction(3), axis = tm_nearest_axis(n), x = direction(3), y = direction(3);
    UT_TRUE(tm_vec_dot(axis, n) > 0.577);
    const tm_vec3 a = tm_turn_from_to(x, axis, n), b = tm_turn_from_to(y, axis, n), to = tm_turn_from_to(axis, axis, n);
    UT_WITHIN(tm_vec_norm(tm_vec_sub(to, n)), 0.0, 1e-14);
    UT_WITHIN(tm_vec_dot(a, b), tm_vec_dot(x, y), 1e-14);
    UT_WITHIN(tm_vec_dot(tm_vec_cross(a, b), n), tm_vec_dot(tm_vec_cross(x, y), axis), 1e-14);    /* not mirrored */
  }
}

/* of the pattern next to a plane: in h of the parent */
static void reaches(int kind, double epsilon, double alpha)
{
  tm_split_pattern p;
  UT_TRUE(tm_split_make(kind, TM_KERNEL_HYPERBOLIC, epsilon, alpha, &p) == TM_SPLIT_OK);
  const double reach = 0.5 / 1.2;
  double radius[TM_SPLIT_MOST];
  for (int k = 0; k < p.n; k++) radius[k] = reach * pow(p.mass[k], 1.0 / p.dim);
  for (int turn = 0; turn < 100; turn++) {
    double place[3 * TM_SPLIT_MOST], most = 0.0;
    tm_vec3 n = direction(p.dim), sum = tm_vec(0, 0, 0);
    if (turn == 0) n = tm_vec(0, -1, 0);
    memcpy(place, p.x, sizeof place);
    tm_split_turn(place, p.n, n);
    if (turn == 0) UT_TRUE(memcmp(place, p.x, 3 * (size_t) p.n * sizeof(double)) == 0);    /* square to it already */
    tm_split_scale(place, p.n, n, tm_split_factor(place, radius, p.n, n, reach));
    for (int k = 0; k < p.n; k++) {
      const tm_vec3 x = tm_split_place(place, k);
      most = fmax(most, radius[k] - tm_vec_dot(n, x));
      sum = tm_vec_axpy(sum, p.mass[k], x);
      if (p.dim == 2) UT_TRUE(x.z == 0.0);
    }
    UT_NEAR(most, reach, 1e-13);
    UT_WITHIN(tm_vec_norm(sum), 0.0, 1e-14);
  }
}

/* a parent on a plane of any direction, and its children in its place */
static void presses(void)
{
  const double dp = 0.02, depth = 0.001, stiff = 3.0e4;
  for (int turn = 0; turn < 20; turn++) {
    const tm_vec3 n = direction(3), side = direction(3);
    const tm_vec3 u = tm_vec_cross(side, n), e1 = tm_vec_scale(2.0 / tm_vec_norm(u), u), e2 = tm_vec_cross(n, e1);
    tm_soup soup = ut_soup(2 * 20 * 20);
    ut_scene s;
    ut_sheet(&soup, tm_vec_scale(-0.5, tm_vec_add(e1, e2)), e1, e2, 20, 20);
    ut_arrange(&s, &soup, dp);
    s.law[1].stiffness = stiff;
    const tm_vec3 at = tm_vec_axpy(tm_vec_scale(0.01, e1), 0.5 * dp - depth, n);
    ut_put(&s, 0, at, tm_vec(0, 0, 0));
    const tm_contact_result whole = tm_contact_tri(0, &s.args, TM_CT_3D);
    UT_NEAR(-tm_vec_dot(whole.force, n), stiff * depth, 1e-9);

    tm_split_pattern p;
    UT_TRUE(tm_split_make(TM_SPLIT_CUBE, TM_KERNEL_HYPERBOLIC, 0.5, 0.5, &p) == TM_SPLIT_OK);
    const double h = 1.2 * dp;
    double place[3 * TM_SPLIT_MOST], radius[TM_SPLIT_MOST], size[8 * TM_REC_SIZE] = {0};
    memcpy(place, p.x, sizeof place);
    for (int k = 0; k < 8; k++) radius[k] = 0.25 * dp / h;
    tm_split_turn(place, 8, n);
    tm_split_scale(place, 8, n, tm_split_factor(place, radius, 8, n, 0.5 * dp / h));
    s.args.size = size;
    tm_contact_result parts = tm_contact_nothing();
    for (int k = 0; k < 8; k++) {
      size[k * TM_REC_SIZE + TM_SIZE_DP] = 0.5 * dp;
      ut_put(&s, k, tm_vec_axpy(at, h, tm_split_place(place, k)), tm_vec(0, 0, 0));
      const tm_contact_result one = tm_contact_tri(k, &s.args, TM_CT_3D);
      tm_contact_sum(&parts, &one);
    }
    UT_TRUE(parts.contacts == 4);
    UT_WITHIN(tm_vec_norm(tm_vec_sub(parts.force, whole.force)), 0.0, 1e-9 * stiff * depth);
    UT_NEAR(parts.spring, whole.spring, 1e-9);
    ut_clear(&s);
  }
}

int main(void)
{
  turns();
  reaches(TM_SPLIT_SQUARE, 0.41666667, 0.5);
  reaches(TM_SPLIT_SQUARE, 1.0, 0.5);
  reaches(TM_SPLIT_HEXAGON, 0.6, 0.6);
  reaches(TM_SPLIT_CUBE, 0.3, 0.5);
  reaches(TM_SPLIT_CUBE_CENTRE, 0.85, 0.6);
  reaches(TM_SPLIT_ICOSAHEDRON, 0.8, 0.6);
  presses();
  return ut_summary();
}
