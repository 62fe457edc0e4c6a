/* SPH-TM: meshes made in the tests themselves, and a build that must succeed. */
#ifndef UT_MESH_H
#define UT_MESH_H

#include <stdlib.h>
#include <string.h>

#include "tm_mesh.h"
#include "ut.h"

static inline tm_soup ut_soup(int n)
{
  tm_soup s;
  s.n = 0;
  s.normal = NULL;
  s.corner = (double *) malloc(sizeof(double) * 9 * (size_t) n);
  return s;
}
static inline void ut_facet(tm_soup *s, tm_vec3 a, tm_vec3 b, tm_vec3 c)
{
  const tm_vec3 p[3] = {a, b, c};
  for (int k = 0; k < 3; k++) {
    double *q = s->corner + 9 * (size_t) s->n + 3 * k;
    q[0] = p[k].x; q[1] = p[k].y; q[2] = p[k].z;
  }
  s->n++;
}
/* nu x nv cells over the parallelogram at o with edges u, v; normal along u x v */
static inline void ut_sheet(tm_soup *s, tm_vec3 o, tm_vec3 u, tm_vec3 v, int nu, int nv)
{
  for (int i = 0; i < nu; i++)
    for (int j = 0; j < nv; j++) {
      tm_vec3 p[4];
      for (int k = 0; k < 4; k++) {
        const double a = (double) (i + (k == 1 || k == 2)) / nu;
        const double b = (double) (j + (k >= 2)) / nv;
        p[k] = tm_vec_axpy(tm_vec_axpy(o, a, u), b, v);
      }
      if ((i + j) % 2) {
        ut_facet(s, p[0], p[1], p[2]);
        ut_facet(s, p[0], p[2], p[3]);
      } else {
        ut_facet(s, p[0], p[1], p[3]);
        ut_facet(s, p[1], p[2], p[3]);
      }
    }
}
/* closed box of n cells per edge */
static inline void ut_box(tm_soup *s, tm_vec3 lo, tm_vec3 hi, int n)
{
  const tm_vec3 d = tm_vec_sub(hi, lo);
  const tm_vec3 x = tm_vec(d.x, 0, 0), y = tm_vec(0, d.y, 0), z = tm_vec(0, 0, d.z);
  ut_sheet(s, lo, y, x, n, n);
  ut_sheet(s, tm_vec_add(lo, z), x, y, n, n);
  ut_sheet(s, lo, z, y, n, n);
  ut_sheet(s, tm_vec_add(lo, x), y, z, n, n);
  ut_sheet(s, lo, x, z, n, n);
  ut_sheet(s, tm_vec_add(lo, y), z, x, n, n);
}
static inline tm_mesh ut_build(tm_soup *s)
{
  tm_mesh m;
  char msg[200];
  const int status = tm_mesh_build(s, NULL, &m, msg, sizeof msg);
  if (status) printf("build: %s: %s\n", tm_mesh_status_name(status), msg);
  UT_TRUE(status == TM_MESH_OK);
  tm_soup_free(s);
  return m;
}
static inline tm_vec3 ut_point(double lo, double hi)
{
  const double x = ut_random(lo, hi), y = ut_random(lo, hi);
  return tm_vec(x, y, ut_random(lo, hi));
}

#endif
