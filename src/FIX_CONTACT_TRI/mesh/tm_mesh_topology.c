/* SPH-TM: edges, smooth patches and pseudo-normals of a welded mesh; see tm_mesh.h. */
#include <stdlib.h>
#include <string.h>

#include "tm_mesh.h"

typedef struct {
  int lo, hi, h;
} edge_key;

static int compare_edges(const void *a, const void *b)
{
  const edge_key *p = (const edge_key *) a, *q = (const edge_key *) b;
  if (p->lo != q->lo) return p->lo < q->lo ? -1 : 1;
  if (p->hi != q->hi) return p->hi < q->hi ? -1 : 1;
  return p->h < q->h ? -1 : p->h > q->h;
}

static int edge_start(const tm_mesh *m, int h) { return m->tri[h]; }
static int edge_end(const tm_mesh *m, int h) { return m->tri[h % 3 == 2 ? h - 2 : h + 1]; }

/* One edge: the half-edges key[0..n-1] lie on it. */
static void link_edge(tm_mesh *m, const edge_key *key, int n)
{
  for (int k = 0; k < n; k++) m->twin[key[k].h] = n > 1 ? key[(k + 1) % n].h : -1;
  if (n == 1) m->open_edges++;
  if (n > 2) m->nonmanifold_edges++;
  if (n == 2 && edge_start(m, key[0].h) == edge_start(m, key[1].h)) m->inconsistent_edges++;
}

int tm_mesh_link(tm_mesh *m)
{
  const int edges = 3 * m->nt;
  edge_key *key = (edge_key *) malloc(sizeof(edge_key) * (size_t) edges);
  m->twin = (int *) malloc(sizeof(int) * (size_t) edges);
  const int ok = key && m->twin;
  if (ok) {
    for (int h = 0; h < edges; h++) {
      const int a = edge_start(m, h), b = edge_end(m, h);
      key[h].lo = a < b ? a : b;
      key[h].hi = a < b ? b : a;
      key[h].h = h;
    }
    qsort(key, (size_t) edges, sizeof(edge_key), compare_edges);
    for (int first = 0, next; first < edges; first = next) {
      for (next = first + 1; next < edges && key[next].lo == key[first].lo && key[next].hi == key[first].hi; next++) {}
      link_edge(m, key + first, next - first);
    }
  }
  free(key);
  return ok ? TM_MESH_OK : TM_MESH_TOO_LARGE;
}

/* --- smooth patches: triangles joined by manifold, consistent, nearly flat edges ------------ */

static int find_root(int *parent, int t)
{
  while (parent[t] != t) t = parent[t] = parent[parent[t]];
  return t;
}

static int smooth_edge(const tm_mesh *m, int h, double cos_limit)
{
  const int g = m->twin[h];
  if (g < 0 || m->twin[g] != h || edge_start(m, g) == edge_start(m, h)) return 0;
  return tm_vec_dot(tm_load3(m->normal + 3 * (ptrdiff_t) (h / 3)), tm_load3(m->normal + 3 * (ptrdiff_t) (g / 3))) >
         cos_limit;
}

/* Edges around the vertices where patches meet, for the test whether such a vertex is nearest. */
static int collect_spokes(tm_mesh *m)
{
  int *seen = (int *) malloc(sizeof(int) * (size_t) m->nv); /* patch of the vertex, -2: several */
  m->spoke_first = (int *) calloc((size_t) m->nv + 1, sizeof(int));
  if (!seen || !m->spoke_first) {
    free(seen);
    return TM_MESH_TOO_LARGE;
  }
  for (int v = 0; v < m->nv; v++) seen[v] = -1;
  for (int h = 0; h < 3 * m->nt; h++) {
    int *s = seen + m->tri[h];
    *s = *s == -1 || *s == m->patch[h / 3] ? m->patch[h / 3] : -2;
  }
  for (int pass = 0; pass < 2; pass++) {
    for (int h = 0; h < 3 * m->nt; h++) {
      int lowest = 1; /* each edge once: from the first half-edge of its ring */
      for (int g = m->twin[h]; g >= 0 && g != h; g = m->twin[g]) lowest = lowest && h < g;
      const int end[2] = {edge_start(m, h), edge_end(m, h)};
      for (int k = 0; k < 2 && lowest; k++) {
        if (seen[end[k]] != -2) continue;
        if (pass == 0) m->spoke_first[end[k] + 1]++;
        else m->spoke[m->spoke_first[end[k]]++] = end[1 - k];
      }
    }
    if (pass == 1) break;
    for (int v = 0; v < m->nv; v++) m->spoke_first[v + 1] += m->spoke_first[v];
    m->spoke = (int *) malloc(sizeof(int) * ((size_t) m->spoke_first[m->nv] + 1));
    if (!m->spoke) break;
  }
  for (int v = m->nv; v > 0 && m->spoke; v--) m->spoke_first[v] = m->spoke_first[v - 1];
  m->spoke_first[0] = 0;
  free(seen);
  return m->spoke ? TM_MESH_OK : TM_MESH_TOO_LARGE;
}

int tm_mesh_patches(tm_mesh *m, double smooth_angle)
{
  const double cos_limit = cos(smooth_angle * TM_PI / 180.0);
  int *parent = (int *) malloc(sizeof(int) * (size_t) m->nt);
  m->patch = (int *) malloc(sizeof(int) * (size_t) m->nt);
  if (!parent || !m->patch) {
    free(parent);
    return TM_MESH_TOO_LARGE;
  }
  for (int t = 0; t < m->nt; t++) parent[t] = t;
  for (int h = 0; h < 3 * m->nt; h++)
    if (smooth_edge(m, h, cos_limit)) {
      const int a = find_root(parent, h / 3), b = find_root(parent, m->twin[h] / 3);
      parent[a > b ? a : b] = a > b ? b : a; /* roots are the lowest index of their patch */
    }
  m->npatch = 0;
  for (int t = 0; t < m->nt; t++) {
    const int root = find_root(parent, t);
    m->patch[t] = root == t ? m->npatch++ : m->patch[root];
  }
  free(parent);
  return collect_spokes(m);
}

/* --- pseudo-normals -------------------------------------------------------------------------- */

static void store_unit(double *p, tm_vec3 n, double least)
{
  const double norm = tm_vec_norm(n), s = norm > least ? 1.0 / norm : 0.0;
  p[0] = s * n.x;
  p[1] = s * n.y;
  p[2] = s * n.z;
}

static double corner_angle(const tm_mesh *m, int h)
{
  const tm_vec3 p = tm_load3(m->vertex + 3 * (ptrdiff_t) m->tri[h]);
  const int t3 = h - h % 3;
  const tm_vec3 a = tm_vec_sub(tm_load3(m->vertex + 3 * (ptrdiff_t) m->tri[t3 + (h + 1) % 3]), p);
  const tm_vec3 b = tm_vec_sub(tm_load3(m->vertex + 3 * (ptrdiff_t) m->tri[t3 + (h + 2) % 3]), p);
  return atan2(tm_vec_norm(tm_vec_cross(a, b)), tm_vec_dot(a, b));
}

int tm_mesh_normals(tm_mesh *m)
{
  m->edge_normal = (double *) calloc(9 * (size_t) m->nt, sizeof(double));
  m->vertex_normal = (double *) calloc(3 * (size_t) m->nv, sizeof(double));
  char *rim = (char *) calloc((size_t) m->nv, 1);
  if (!m->edge_normal || !m->vertex_normal || !rim) {
    free(rim);
    return TM_MESH_TOO_LARGE;
  }
  for (int h = 0; h < 3 * m->nt; h++) {
    const tm_vec3 own = tm_load3(m->normal + 3 * (ptrdiff_t) (h / 3));
    double *v = m->vertex_normal + 3 * (ptrdiff_t) m->tri[h];
    const double angle = corner_angle(m, h);
    v[0] += angle * own.x;
    v[1] += angle * own.y;
    v[2] += angle * own.z;
    if (m->twin[h] < 0) {
      rim[edge_start(m, h)] = rim[edge_end(m, h)] = 1;
      continue;
    }
    tm_vec3 sum = own;
    for (int g = m->twin[h]; g != h; g = m->twin[g])
      sum = tm_vec_add(sum, tm_load3(m->normal + 3 * (ptrdiff_t) (g / 3)));
    store_unit(m->edge_normal + 3 * (ptrdiff_t) h, sum, 1e-6);
  }
  for (int v = 0; v < m->nv; v++) {
    double *p = m->vertex_normal + 3 * (ptrdiff_t) v;
    store_unit(p, rim[v] ? tm_vec(0, 0, 0) : tm_load3(p), 1e-6);
  }
  free(rim);
  return TM_MESH_OK;
}
