/* SPH-TM: a mesh, its grid and contact arguments for a few particles of one type, for the tests. */
#ifndef UT_CONTACT_H
#define UT_CONTACT_H

#include "tm_contact_tri.h"
#include "ut_mesh.h"

#define UT_PARTICLES 64

typedef struct {
  tm_mesh mesh;
  tm_tri_grid grid;
  tm_contact_args args;
  tm_contact_law law[2];
  tm_material material[2];
  double x[3 * UT_PARTICLES], v[3 * UT_PARTICLES], f[3 * UT_PARTICLES];
  double temperature[UT_PARTICLES], source[UT_PARTICLES], pstrain[3 * UT_PARTICLES];
  double mass[2];
  int type[UT_PARTICLES];
} ut_scene;

/* spacing dp, stiffness 1, mass 1, no damping, no friction, at rest, no force */
static inline void ut_arrange(ut_scene *s, tm_soup *soup, double dp)
{
  memset(s, 0, sizeof *s);
  s->mesh = ut_build(soup);
  UT_TRUE(tm_tri_grid_build(&s->grid, &s->mesh, dp, TM_GRID_BUDGET) == TM_MESH_OK);
  tm_contact_law *w = s->law + 1;
  w->active = 1;
  w->radius = 0.5 * dp;
  w->stiffness = 1.0;
  w->area = dp * dp;
  w->share = -1.0;
  s->mass[1] = 1.0;
  tm_material *m = s->material + 1;
  m->rho0 = 2.0;
  m->conductivity.value = 3.0;
  m->capacity.value = 5.0;
  for (int i = 0; i < UT_PARTICLES; i++) s->type[i] = 1;
  tm_contact_args *a = &s->args;
  a->mesh = tm_mesh_view(&s->mesh);
  a->grid = s->grid.view;
  a->pose = tm_pose_rest();
  a->deep = dp;
  a->dt = 0.01;
  a->force_unit = 1.0;
  a->law = s->law;
  a->type = s->type;
  a->x = s->x; a->v = s->v; a->f = s->f;
  a->x_stride = a->v_stride = a->f_stride = 3;
  a->mass = s->mass;
  a->material = s->material;
  a->temperature = s->temperature;
  a->temperature_stride = 1;
  a->source = s->source;
}
static inline void ut_clear(ut_scene *s)
{
  tm_tri_grid_free(&s->grid);
  tm_mesh_free(&s->mesh);
}
static inline void ut_put(ut_scene *s, int i, tm_vec3 x, tm_vec3 v)
{
  double *p = s->x + 3 * i, *q = s->v + 3 * i, *f = s->f + 3 * i;
  p[0] = x.x; p[1] = x.y; p[2] = x.z;
  q[0] = v.x; q[1] = v.y; q[2] = v.z;
  f[0] = f[1] = f[2] = 0.0;
}
/* force on a particle at rest at x */
static inline tm_vec3 ut_force_at(ut_scene *s, tm_vec3 x, unsigned effects)
{
  ut_put(s, 0, x, tm_vec(0, 0, 0));
  tm_contact_tri(0, &s->args, effects | TM_CT_3D);
  return tm_load3(s->f);
}

#endif
