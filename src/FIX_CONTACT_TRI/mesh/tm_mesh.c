/* SPH-TM: building a mesh from a triangle soup; see tm_mesh.h. */
#include "tm_mesh.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* clang-format off */
static const char *const status_name[] = {
    "ok",           "no file",      "empty file",        "not a mesh",   "truncated",
    "trailing data", "syntax error", "bad value",         "no triangles", "all facets degenerate",
    "too large",    "not triangles", "bad vertex index",  "unsupported",  "cannot write"};
/* clang-format on */

const char *tm_mesh_status_name(int status)
{
  return status >= 0 && status <= TM_MESH_WRITE_FAILED ? status_name[status] : "unknown";
}

tm_mesh_options tm_mesh_defaults(void)
{
  tm_mesh_options o;
  o.tolerance = 1e-7;
  o.smooth_angle = 30.0;
  return o;
}

void tm_soup_free(tm_soup *soup)
{
  free(soup->corner);
  free(soup->normal);
  memset(soup, 0, sizeof *soup);
}

void tm_soup_flip(tm_soup *soup)
{
  for (ptrdiff_t t = 0; t < soup->n; t++) {
    double *b = soup->corner + 9 * t + 3;
    for (int d = 0; d < 3; d++) {
      const double x = b[d];
      b[d] = b[3 + d];
      b[3 + d] = x;
      if (soup->normal) soup->normal[3 * t + d] = -soup->normal[3 * t + d];
    }
  }
}

void tm_mesh_free(tm_mesh *m)
{
  free(m->vertex);
  free(m->corner);
  free(m->normal);
  free(m->ball);
  free(m->area);
  free(m->edge_normal);
  free(m->vertex_normal);
  free(m->tri);
  free(m->twin);
  free(m->patch);
  free(m->spoke_first);
  free(m->spoke);
  memset(m, 0, sizeof *m);
}

tm_tri_view tm_mesh_view(const tm_mesh *m)
{
  tm_tri_view v;
  v.nv = m->nv;
  v.nt = m->nt;
  v.npatch = m->npatch;
  v.vertex = m->vertex;
  v.corner = m->corner;
  v.normal = m->normal;
  v.ball = m->ball;
  v.tri = m->tri;
  v.twin = m->twin;
  v.patch = m->patch;
  v.edge_normal = m->edge_normal;
  v.vertex_normal = m->vertex_normal;
  v.spoke_first = m->spoke_first;
  v.spoke = m->spoke;
  return v;
}

/* A small sphere around a triangle: about the middle of its longest edge where that holds the third
   vertex, else about the centroid. */
static void enclose(const double *corner, double *ball)
{
  const tm_vec3 p[3] = {tm_load3(corner), tm_load3(corner + 3), tm_load3(corner + 6)};
  double longest = 0.0, radius = 0.0;
  tm_vec3 c = p[0];
  for (int k = 0; k < 3; k++) {
    const double length = tm_vec_norm(tm_vec_sub(p[(k + 1) % 3], p[k]));
    if (length <= longest) continue;
    longest = length;
    c = tm_vec_scale(0.5, tm_vec_add(p[k], p[(k + 1) % 3]));
  }
  for (int pass = 0; pass < 2; pass++) {
    radius = 0.0;
    for (int k = 0; k < 3; k++) radius = tm_max(radius, tm_vec_norm(tm_vec_sub(p[k], c)));
    if (pass == 1 || radius <= 0.5 * longest * (1.0 + 1e-12)) break;
    c = tm_vec_scale(1.0 / 3.0, tm_vec_add(p[0], tm_vec_add(p[1], p[2])));
  }
  ball[0] = c.x;
  ball[1] = c.y;
  ball[2] = c.z;
  ball[3] = radius * (1.0 + 1e-12);
}

/* Corners once more in facet order, spheres around them, box, area and enclosed volume. */
static int tm_mesh_measure(tm_mesh *m)
{
  m->corner = (double *) malloc(sizeof(double) * 9 * (size_t) m->nt);
  m->ball = (double *) malloc(sizeof(double) * 4 * (size_t) m->nt);
  if (!m->corner || !m->ball) return TM_MESH_TOO_LARGE;
  for (int d = 0; d < 3; d++) m->lo[d] = m->hi[d] = m->vertex[d];
  for (ptrdiff_t i = 0; i < 3 * (ptrdiff_t) m->nv; i++) {
    m->lo[i % 3] = tm_min(m->lo[i % 3], m->vertex[i]);
    m->hi[i % 3] = tm_max(m->hi[i % 3], m->vertex[i]);
  }
  const tm_vec3 mid = tm_vec(0.5 * (m->lo[0] + m->hi[0]), 0.5 * (m->lo[1] + m->hi[1]), 0.5 * (m->lo[2] + m->hi[2]));
  double volume = 0.0;
  m->total_area = 0.0;
  for (ptrdiff_t t = 0; t < m->nt; t++) {
    double *c = m->corner + 9 * t;
    for (int k = 0; k < 3; k++) memcpy(c + 3 * k, m->vertex + 3 * (ptrdiff_t) m->tri[3 * t + k], 3 * sizeof(double));
    enclose(c, m->ball + 4 * t);
    m->total_area += m->area[t];
    volume += m->area[t] / 3.0 * tm_vec_dot(tm_vec_sub(tm_load3(c), mid), tm_load3(m->normal + 3 * t));
  }
  m->closed = m->open_edges == 0 && m->nonmanifold_edges == 0 && m->inconsistent_edges == 0;
  m->volume = m->closed ? volume : 0.0;
  return TM_MESH_OK;
}

int tm_mesh_build(const tm_soup *soup, const tm_mesh_options *options, tm_mesh *mesh, char *msg, size_t nmsg)
{
  const tm_mesh_options o = options ? *options : tm_mesh_defaults();
  memset(mesh, 0, sizeof *mesh);
  if (nmsg > 0) msg[0] = '\0';
  int status = soup->n > 0 ? TM_MESH_OK : TM_MESH_NO_TRIANGLES;
  if (soup->n > TM_MESH_MAX_FACETS) status = TM_MESH_TOO_LARGE;
  if (status == TM_MESH_OK) status = tm_mesh_weld(soup, o.tolerance, mesh);
  if (status == TM_MESH_OK) status = tm_mesh_link(mesh);
  if (status == TM_MESH_OK) status = tm_mesh_patches(mesh, o.smooth_angle);
  if (status == TM_MESH_OK) status = tm_mesh_normals(mesh);
  if (status == TM_MESH_OK) status = tm_mesh_measure(mesh);
  if (status == TM_MESH_OK) return status;
  if (status == TM_MESH_ALL_DEGENERATE) snprintf(msg, nmsg, "none of the %d facets has an area", soup->n);
  else if (status == TM_MESH_NO_TRIANGLES) snprintf(msg, nmsg, "the mesh has no triangles");
  else snprintf(msg, nmsg, "no memory for a mesh of %d facets", soup->n);
  tm_mesh_free(mesh);
  return status;
}
