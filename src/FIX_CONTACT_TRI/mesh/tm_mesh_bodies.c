#include "tm_mesh.h"
#include "tm_winding.h"

#include <stdlib.h>

static int root_of(int *parent, int t)
{
  while (parent[t] != t) t = parent[t] = parent[parent[t]];
  return t;
}

/* Triangles that are joined by edges have one root, the lowest of their indices. */
static void join(const tm_mesh *m, int *parent)
{
  for (int t = 0; t < m->nt; t++) parent[t] = t;
  for (int h = 0; h < 3 * m->nt; h++) {
    if (m->twin[h] < 0) continue;
    const int a = root_of(parent, h / 3), b = root_of(parent, m->twin[h] / 3);
    parent[a > b ? a : b] = a > b ? b : a;
  }
}

/* How often the other bodies surround the first corner of triangle t. */
static double surrounded(const tm_mesh *m, int *parent, int t)
{
  const tm_vec3 p = tm_load3(m->corner + 9 * (ptrdiff_t) t);
  double sum = 0.0;
  for (int o = 0; o < m->nt; o++)
    if (root_of(parent, o) != t) sum += tm_winding_angle(m->corner + 9 * (ptrdiff_t) o, p);
  return sum / (4.0 * TM_PI);
}

int tm_mesh_inside_out(const tm_mesh *m, int turned)
{
  const double sign = turned ? -1.0 : 1.0;
  int *parent = (int *) malloc(sizeof(int) * (size_t) m->nt);
  double *volume = (double *) calloc((size_t) m->nt, sizeof(double));
  int found = -1;
  if (parent && volume && m->closed) {
    const tm_vec3 mid = tm_vec(0.5 * (m->lo[0] + m->hi[0]), 0.5 * (m->lo[1] + m->hi[1]), 0.5 * (m->lo[2] + m->hi[2]));
    join(m, parent);
    for (int t = 0; t < m->nt; t++)
      volume[root_of(parent, t)] +=
          m->area[t] / 3.0 *
          tm_vec_dot(tm_vec_sub(tm_load3(m->corner + 9 * (ptrdiff_t) t), mid), tm_load3(m->normal + 3 * (ptrdiff_t) t));
    for (int t = 0; t < m->nt && found < 0; t++)
      if (parent[t] == t && sign * volume[t] < 0.0 && sign * surrounded(m, parent, t) < 0.75) found = t;
  }
  free(parent);
  free(volume);
  return found;
}
