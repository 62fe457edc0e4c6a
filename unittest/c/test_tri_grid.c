/* Broad phase against a test of every triangle, and its cost with triangles far away. */
#include <time.h>

#include "tm_closest.h"
#include "tm_tri_grid.h"
#include "ut_mesh.h"

/* Every triangle within reach of p must be in the list of its cell. */
static void complete(const tm_mesh *m, const tm_tri_grid *g, double reach, int points)
{
  const tm_tri_view view = tm_mesh_view(m);
  int missing = 0, near_any = 0;
  for (int k = 0; k < points; k++) {
    tm_vec3 p;
    if (k % 2) {   /* near the surface */
      const int t = (int) ut_random(0, m->nt);
      const double a = ut_random(0, 1), b = ut_random(0, 1 - a);
      const double *c = m->corner + 9 * (ptrdiff_t) t;
      p = tm_vec_axpy(tm_vec_scale(1 - a - b, tm_load3(c)), a, tm_load3(c + 3));
      p = tm_vec_axpy(tm_vec_axpy(p, b, tm_load3(c + 6)), 1.5 * reach, ut_point(-1, 1));
    } else {
      p = tm_vec(ut_random(m->lo[0] - reach, m->hi[0] + reach),
                 ut_random(m->lo[1] - reach, m->hi[1] + reach),
                 ut_random(m->lo[2] - reach, m->hi[2] + reach));
    }
    int n;
    const int *list = tm_grid_query(&g->view, p, &n);
    for (int t = 0; t < m->nt; t++) {
      if (tm_closest_on_facet(p, &view, t).dist2 > reach * reach) continue;
      int found = 0;
      for (int i = 0; i < n; i++) found |= list[i] == t;
      missing += !found;
      near_any++;
    }
  }
  UT_TRUE(missing == 0);
  UT_TRUE(near_any > points / 10);
}

static tm_mesh random_mesh(int n)
{
  tm_soup s = ut_soup(n);
  for (int t = 0; t < n; t++) {
    const tm_vec3 a = ut_point(-1, 1);
    const double size = t % 10 ? 0.1 : 2.0;   /* small ones and a few across everything */
    ut_facet(&s, a, tm_vec_axpy(a, size, ut_point(-1, 1)), tm_vec_axpy(a, size, ut_point(-1, 1)));
  }
  return ut_build(&s);
}

/* Mean number of triangles listed for points within reach of the plate of 100 triangles at the
   origin, and time per query. */
static double cost(const tm_mesh *m, double reach, double *seconds)
{
  tm_tri_grid g;
  UT_TRUE(tm_tri_grid_build(&g, m, reach, TM_GRID_BUDGET) == TM_MESH_OK);
  const tm_tri_view view = tm_mesh_view(m);
  double listed = 0.0, keep = 0.0;
  const int points = 300000;
  ut_state = 88172645463325252ull;
  const clock_t start = clock();
  for (int k = 0; k < points; k++) {
    const double x = ut_random(0, 1), y = ut_random(0, 1);
    const tm_vec3 p = tm_vec(x, y, ut_random(-reach, reach));
    int n;
    const int *list = tm_grid_query(&g.view, p, &n);
    listed += n;
    for (int i = 0; i < n; i++) keep += tm_closest_on_facet(p, &view, list[i]).dist2;
  }
  *seconds = (double) (clock() - start) / CLOCKS_PER_SEC / points + 1e-30 * keep;
  tm_tri_grid_free(&g);
  return listed / points;
}

static void far_triangles(void)
{
  const double reach = 0.02;
  double few_time, many_time;
  tm_soup s = ut_soup(100);
  ut_sheet(&s, tm_vec(0, 0, 0), tm_vec(1, 0, 0), tm_vec(0, 1, 0), 10, 5);
  tm_mesh few = ut_build(&s);
  s = ut_soup(100100);
  ut_sheet(&s, tm_vec(0, 0, 0), tm_vec(1, 0, 0), tm_vec(0, 1, 0), 10, 5);
  ut_sheet(&s, tm_vec(0, 0, 0.3), tm_vec(1, 0, 0.2), tm_vec(0, 1, 0), 250, 200);
  tm_mesh many = ut_build(&s);
  const double a = cost(&few, reach, &few_time), b = cost(&many, reach, &many_time);
  printf("triangles listed per query: %.3f of %d, %.3f of %d; %.1f and %.1f ns per query\n", a,
         few.nt, b, many.nt, 1e9 * few_time, 1e9 * many_time);
  UT_TRUE(many.nt == 100100 && few.nt == 100);
  UT_TRUE(b <= 1.05 * a);   /* cell boundaries differ, far triangles do not count */
  tm_mesh_free(&few);
  tm_mesh_free(&many);
}

int main(void)
{
  tm_mesh m = random_mesh(300);
  tm_tri_grid g;
  const double reaches[3] = {0.01, 0.1, 0.7};
  for (int k = 0; k < 3; k++) {
    UT_TRUE(tm_tri_grid_build(&g, &m, reaches[k], TM_GRID_BUDGET) == TM_MESH_OK);
    complete(&m, &g, reaches[k], 3000);
    tm_tri_grid_free(&g);
  }
  /* a budget too small for cells of one reach: larger cells, still complete */
  UT_TRUE(tm_tri_grid_build(&g, &m, 0.002, 20000) == TM_MESH_OK);
  UT_TRUE(g.cell > 0.002 && g.entries < 60000);
  complete(&m, &g, 0.002, 3000);
  int n;   /* far away and nowhere: nothing */
  tm_grid_query(&g.view, tm_vec(100, 0, 0), &n);
  UT_TRUE(n == 0);
  tm_grid_query(&g.view, tm_vec(NAN, 0, 0), &n);
  UT_TRUE(n == 0);
  tm_tri_grid_free(&g);
  tm_mesh_free(&m);
  far_triangles();
  return ut_summary();
}
