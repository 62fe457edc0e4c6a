/* SPH-TM: from facets with corners of their own to facets on shared vertices.

   Vertices go into hash buckets of cells twice the tolerance wide, so that anything within the
   tolerance of a point lies in one of eight cells; the first vertex met stands for all that follow
   it closely. */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "tm_mesh.h"

typedef struct {
  double cell, tol2, lo[3];
  size_t buckets;   /* a power of two */
  int *head, *next; /* first vertex of a bucket, next of the same bucket; -1 ends */
} weld_table;

static size_t bucket_of(const weld_table *w, int64_t i, int64_t j, int64_t k)
{
  uint64_t h = (uint64_t) i * 0x9E3779B97F4A7C15u;
  h = (h ^ (h >> 29)) + (uint64_t) j * 0xC2B2AE3D27D4EB4Fu;
  h = (h ^ (h >> 31)) + (uint64_t) k * 0x165667B19E3779F9u;
  h ^= h >> 32;
  return (size_t) (h & (w->buckets - 1));
}

/* The vertex within tolerance of p, or -1. */
static int find_vertex(const weld_table *w, const double *vertex, const double *p, const int64_t cell[3],
                       const int64_t step[3])
{
  for (int corner = 0; corner < 8; corner++) {
    const size_t b = bucket_of(w, cell[0] + (corner & 1 ? step[0] : 0), cell[1] + (corner & 2 ? step[1] : 0),
                               cell[2] + (corner & 4 ? step[2] : 0));
    for (int v = w->head[b]; v >= 0; v = w->next[v]) {
      const double *q = vertex + 3 * (ptrdiff_t) v;
      const double dx = p[0] - q[0], dy = p[1] - q[1], dz = p[2] - q[2];
      if (dx * dx + dy * dy + dz * dz <= w->tol2) return v;
    }
  }
  return -1;
}

static int weld_point(weld_table *w, tm_mesh *m, const double *p)
{
  int64_t cell[3], step[3];
  for (int d = 0; d < 3; d++) {
    const double s = (p[d] - w->lo[d]) / w->cell, f = floor(s);
    cell[d] = (int64_t) f;
    step[d] = s - f < 0.5 ? -1 : 1;
  }
  int v = find_vertex(w, m->vertex, p, cell, step);
  if (v >= 0) return v;
  v = m->nv++;
  memcpy(m->vertex + 3 * (ptrdiff_t) v, p, 3 * sizeof(double));
  const size_t b = bucket_of(w, cell[0], cell[1], cell[2]);
  w->next[v] = w->head[b];
  w->head[b] = v;
  return v;
}

static int weld_all(const tm_soup *soup, tm_mesh *m)
{
  weld_table w;
  const size_t corners = 3 * (size_t) soup->n;
  memset(&w, 0, sizeof w);
  for (w.buckets = 64; w.buckets < corners; w.buckets *= 2) {}
  w.head = (int *) malloc(sizeof(int) * w.buckets);
  w.next = (int *) malloc(sizeof(int) * corners);
  m->vertex = (double *) malloc(sizeof(double) * 3 * corners);
  m->tri = (int *) malloc(sizeof(int) * corners);
  const int ok = w.head && w.next && m->vertex && m->tri;
  if (ok) {
    for (size_t b = 0; b < w.buckets; b++) w.head[b] = -1;
    memcpy(w.lo, m->lo, sizeof w.lo);
    w.cell = 2.0 * m->tolerance;
    w.tol2 = m->tolerance * m->tolerance;
    for (size_t c = 0; c < corners; c++) m->tri[c] = weld_point(&w, m, soup->corner + 3 * c);
  }
  free(w.head);
  free(w.next);
  return ok ? TM_MESH_OK : TM_MESH_TOO_LARGE;
}

/* Unit normal and area of a facet; the smallest height comes back. */
static double facet_shape(const tm_mesh *m, const int *v, tm_vec3 *n, double *area)
{
  const tm_vec3 p[3] = {tm_load3(m->vertex + 3 * (ptrdiff_t) v[0]), tm_load3(m->vertex + 3 * (ptrdiff_t) v[1]),
                        tm_load3(m->vertex + 3 * (ptrdiff_t) v[2])};
  tm_vec3 e[3];
  int longest = 0;
  for (int k = 0; k < 3; k++) {
    e[k] = tm_vec_sub(p[(k + 1) % 3], p[k]);
    if (tm_vec_dot(e[k], e[k]) > tm_vec_dot(e[longest], e[longest])) longest = k;
  }
  /* the two shorter edges lose least to cancellation */
  *n = tm_vec_cross(e[(longest + 1) % 3], e[(longest + 2) % 3]);
  const double twice = tm_vec_norm(*n), base = tm_vec_norm(e[longest]);
  *area = 0.5 * twice;
  if (!(twice > 0.0) || !(base > 0.0)) return 0.0;
  *n = tm_vec_scale(1.0 / twice, *n);
  return twice / base;
}

/* Keep facets with area; their normals are compared with those of the file. */
static int drop_degenerate(const tm_soup *soup, tm_mesh *m)
{
  m->normal = (double *) malloc(sizeof(double) * 3 * (size_t) soup->n);
  m->area = (double *) malloc(sizeof(double) * (size_t) soup->n);
  if (!m->normal || !m->area) return TM_MESH_TOO_LARGE;
  for (ptrdiff_t t = 0; t < soup->n; t++) {
    const int v[3] = {m->tri[3 * t], m->tri[3 * t + 1], m->tri[3 * t + 2]};
    tm_vec3 n;
    double area;
    const double height = facet_shape(m, v, &n, &area);
    if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0] || !(height > m->tolerance)) {
      m->dropped_degenerate++;
      continue;
    }
    const ptrdiff_t k = m->nt++;
    memcpy(m->tri + 3 * k, v, sizeof v);
    m->normal[3 * k] = n.x;
    m->normal[3 * k + 1] = n.y;
    m->normal[3 * k + 2] = n.z;
    m->area[k] = area;
    if (soup->normal && tm_vec_dot(tm_load3(soup->normal + 3 * t), n) < 0.0) m->flipped_normals++;
  }
  return m->nt > 0 ? TM_MESH_OK : TM_MESH_ALL_DEGENERATE;
}

typedef struct {
  int v[3], t;
} facet_key;

static int compare_facets(const void *a, const void *b)
{
  const facet_key *p = (const facet_key *) a, *q = (const facet_key *) b;
  for (int k = 0; k < 3; k++)
    if (p->v[k] != q->v[k]) return p->v[k] < q->v[k] ? -1 : 1;
  return p->t < q->t ? -1 : p->t > q->t;
}

static facet_key key_of(const int *v, int t)
{
  facet_key f;
  const int lo = v[0] < v[1] ? v[0] : v[1], hi = v[0] < v[1] ? v[1] : v[0];
  f.v[0] = v[2] < lo ? v[2] : lo;
  f.v[2] = v[2] > hi ? v[2] : hi;
  f.v[1] = v[2] < lo ? lo : v[2] > hi ? hi : v[2];
  f.t = t;
  return f;
}

/* Of facets on the same three vertices, whichever way round, the first stays. */
static int drop_duplicates(tm_mesh *m)
{
  facet_key *key = (facet_key *) malloc(sizeof(facet_key) * (size_t) m->nt);
  char *gone = (char *) calloc((size_t) m->nt, 1);
  if (key && gone) {
    for (int t = 0; t < m->nt; t++) key[t] = key_of(m->tri + 3 * (ptrdiff_t) t, t);
    qsort(key, (size_t) m->nt, sizeof(facet_key), compare_facets);
    for (int t = 1; t < m->nt; t++)
      if (memcmp(key[t].v, key[t - 1].v, sizeof key[t].v) == 0) gone[key[t].t] = 1;
    ptrdiff_t k = 0;
    for (ptrdiff_t t = 0; t < m->nt; t++) {
      if (gone[t]) continue;
      memmove(m->tri + 3 * k, m->tri + 3 * t, 3 * sizeof(int));
      memmove(m->normal + 3 * k, m->normal + 3 * t, 3 * sizeof(double));
      m->area[k++] = m->area[t];
    }
    m->dropped_duplicate = m->nt - (int) k;
    m->nt = (int) k;
  }
  const int ok = key && gone;
  free(key);
  free(gone);
  return ok ? TM_MESH_OK : TM_MESH_TOO_LARGE;
}

/* Forget vertices that only dropped facets had. */
static int compact_vertices(tm_mesh *m)
{
  int *map = (int *) malloc(sizeof(int) * (size_t) m->nv);
  if (!map) return TM_MESH_TOO_LARGE;
  for (int v = 0; v < m->nv; v++) map[v] = -1;
  for (ptrdiff_t c = 0; c < 3 * (ptrdiff_t) m->nt; c++) map[m->tri[c]] = 0;
  int kept = 0;
  for (int v = 0; v < m->nv; v++) {
    if (map[v] < 0) continue;
    memmove(m->vertex + 3 * (ptrdiff_t) kept, m->vertex + 3 * (ptrdiff_t) v, 3 * sizeof(double));
    map[v] = kept++;
  }
  for (ptrdiff_t c = 0; c < 3 * (ptrdiff_t) m->nt; c++) m->tri[c] = map[m->tri[c]];
  m->nv = kept;
  free(map);
  return TM_MESH_OK;
}

int tm_mesh_weld(const tm_soup *soup, double tolerance, tm_mesh *m)
{
  for (int d = 0; d < 3; d++) m->lo[d] = m->hi[d] = soup->corner[d];
  for (ptrdiff_t i = 0; i < 9 * (ptrdiff_t) soup->n; i++) {
    m->lo[i % 3] = tm_min(m->lo[i % 3], soup->corner[i]);
    m->hi[i % 3] = tm_max(m->hi[i % 3], soup->corner[i]);
  }
  const double diagonal = tm_vec_norm(tm_vec_sub(tm_load3(m->hi), tm_load3(m->lo)));
  if (!(diagonal > 1e-100)) return TM_MESH_ALL_DEGENERATE; /* areas would underflow */
  m->tolerance = tm_clamp(tolerance, 1e-14, 0.1) * diagonal;
  int status = weld_all(soup, m);
  if (status == TM_MESH_OK) status = drop_degenerate(soup, m);
  if (status == TM_MESH_OK) status = drop_duplicates(m);
  if (status == TM_MESH_OK) status = compact_vertices(m);
  return status;
}
