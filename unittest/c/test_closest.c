/* Closest point of a triangle, against two things that know nothing of how it is found: the
   inequality (p - q).(v - q) <= 0 for every vertex v, which holds at the projection q on a convex
   set and nowhere else, and a search by subdivision. */
#include "tm_closest.h"
#include "ut.h"

static tm_vec3 point(double lo, double hi)
{
  const double x = ut_random(lo, hi), y = ut_random(lo, hi);
  return tm_vec(x, y, ut_random(lo, hi));
}

static tm_vec3 unit_normal(const tm_vec3 *v)
{
  const tm_vec3 n = tm_vec_cross(tm_vec_sub(v[1], v[0]), tm_vec_sub(v[2], v[0]));
  return tm_vec_scale(1.0 / tm_vec_norm(n), n);
}

/* Largest violation of the inequality, over |p - q| times the size of the triangle; the direction
   of a p - q far smaller than the triangle is rounding. */
static double violation(const tm_vec3 *v, tm_vec3 p, tm_vec3 q, double size)
{
  double worst = 0.0;
  for (int k = 0; k < 3; k++)
    worst = fmax(worst, tm_vec_dot(tm_vec_sub(p, q), tm_vec_sub(v[k], q)));
  return worst / (size * (tm_vec_norm(tm_vec_sub(p, q)) + 1e-4 * size));
}

/* Distance from the point to the feature named, as a line, point or plane. */
static double feature_distance(const tm_vec3 *v, tm_vec3 n, tm_vec3 p, int feature)
{
  if (feature == TM_FACE) return fabs(tm_vec_dot(n, tm_vec_sub(p, v[0])));
  if (feature >= TM_VERTEX_0) return tm_vec_norm(tm_vec_sub(p, v[feature - TM_VERTEX_0]));
  const int k = feature - TM_EDGE_0;
  const tm_vec3 e = tm_vec_sub(v[(k + 1) % 3], v[k]);
  return tm_vec_norm(tm_vec_cross(e, tm_vec_sub(p, v[k]))) / tm_vec_norm(e);
}

/* Least distance by subdividing the triangle; the bound of a piece is its centre's distance. */
static double search(const tm_vec3 *v, tm_vec3 p, int level, double best)
{
  tm_vec3 mid = tm_vec_scale(1.0 / 3.0, tm_vec_add(v[0], tm_vec_add(v[1], v[2])));
  double radius = 0.0;
  for (int k = 0; k < 3; k++) {
    radius = fmax(radius, tm_vec_norm(tm_vec_sub(v[k], mid)));
    best = fmin(best, tm_vec_norm(tm_vec_sub(p, v[k])));
  }
  if (level == 0 || tm_vec_norm(tm_vec_sub(p, mid)) - radius > best) return best;
  const tm_vec3 a = tm_vec_scale(0.5, tm_vec_add(v[0], v[1]));
  const tm_vec3 b = tm_vec_scale(0.5, tm_vec_add(v[1], v[2]));
  const tm_vec3 c = tm_vec_scale(0.5, tm_vec_add(v[2], v[0]));
  const tm_vec3 part[4][3] = {{v[0], a, c}, {a, v[1], b}, {c, b, v[2]}, {a, b, c}};
  for (int k = 0; k < 4; k++) best = search(part[k], p, level - 1, best);
  return best;
}

static void check(const tm_vec3 *v, tm_vec3 p, double size, double tolerance, int *seen)
{
  const tm_vec3 n = unit_normal(v);
  const tm_closest c = tm_closest_on_triangle(p, v[0], v[1], v[2], n);
  seen[c.feature]++;
  const double d = sqrt(c.dist2);
  UT_WITHIN(violation(v, p, c.point, size), 0.0, tolerance);
  UT_WITHIN(tm_vec_norm(tm_vec_sub(p, c.point)), d, tolerance * size);
  UT_WITHIN(feature_distance(v, n, p, c.feature), d, tolerance * size);
  UT_WITHIN(tm_vec_dot(n, tm_vec_sub(c.point, v[0])), 0.0, tolerance * size);
}

int main(void)
{
  int seen[7] = {0};
  for (int trial = 0; trial < 1000000; trial++) {
    const tm_vec3 v[3] = {point(-1, 1), point(-1, 1), point(-1, 1)};
    const double area = tm_vec_norm(tm_vec_cross(tm_vec_sub(v[1], v[0]), tm_vec_sub(v[2], v[0])));
    if (area < 1e-3) continue;   /* needles below */
    check(v, point(-2, 2), 1.0, 1e-11, seen);
  }
  for (int f = 0; f < 7; f++) UT_TRUE(seen[f] > 10000);

  /* needles of aspect 1e4, points near them at the scale of their width and far away */
  for (int trial = 0; trial < 200000; trial++) {
    const double width = 1e-4, near = trial % 2 ? 1.0 : 3e-4;
    const tm_vec3 a = point(-1, 1), u = tm_vec_sub(point(-1, 1), a);
    if (tm_vec_norm(u) < 0.1) continue;
    const tm_vec3 w = tm_vec_cross(u, point(-1, 1));
    const tm_vec3 side = tm_vec_scale(width * tm_vec_norm(u) / (tm_vec_norm(w) + 1e-3), w);
    const tm_vec3 top = tm_vec_axpy(a, ut_random(-0.1, 1.1), u);
    const tm_vec3 v[3] = {a, tm_vec_add(a, u), tm_vec_add(top, side)};
    if (tm_vec_norm(side) < 1e-5) continue;
    const tm_vec3 on = tm_vec_axpy(a, ut_random(-0.05, 1.05), u);
    check(v, tm_vec_axpy(on, near, point(-1, 1)), 1.0, 1e-10, seen);
  }

  /* the value itself, by search */
  for (int trial = 0; trial < 3000; trial++) {
    const tm_vec3 v[3] = {point(-1, 1), point(-1, 1), point(-1, 1)}, p = point(-2, 2);
    const tm_closest c = tm_closest_on_triangle(p, v[0], v[1], v[2], unit_normal(v));
    UT_WITHIN(search(v, p, 12, 1e9), sqrt(c.dist2), 2e-3);
  }

  /* exactly on vertices, edges and the face */
  const tm_vec3 v[3] = {tm_vec(0, 0, 0), tm_vec(1, 0, 0), tm_vec(0, 1, 0)}, n = tm_vec(0, 0, 1);
  for (int k = 0; k < 3; k++)
    UT_TRUE(tm_closest_on_triangle(v[k], v[0], v[1], v[2], n).dist2 == 0.0);
  UT_TRUE(tm_closest_on_triangle(tm_vec(0.5, 0, 0), v[0], v[1], v[2], n).feature == TM_EDGE_0);
  UT_TRUE(tm_closest_on_triangle(tm_vec(1, 1, 3), v[0], v[1], v[2], n).feature == TM_EDGE_1);
  UT_TRUE(tm_closest_on_triangle(tm_vec(-1, 0.5, 0), v[0], v[1], v[2], n).feature == TM_EDGE_2);
  UT_TRUE(tm_closest_on_triangle(tm_vec(0.2, 0.2, -3), v[0], v[1], v[2], n).feature == TM_FACE);
  return ut_summary();
}
