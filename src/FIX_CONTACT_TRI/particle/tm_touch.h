/* SPH-TM: where does a particle touch a mesh?

   A particle has at most one contact per smooth patch, at the patch's nearest point: so triangles of
   one patch are never counted twice, and a plane or a rounding in many triangles is one surface. Of
   the patches, those count whose nearest point is a minimum of distance for the whole surface: a
   point on the boundary between patches is none when the patch across the boundary comes nearer. At
   a convex edge that leaves one contact, across face, edge and vertex regions without a gap; in a
   concave corner it leaves one per wall.

   The sign of the pseudo-normal of the feature gives the side. A center behind the surface has one
   contact, the nearest point of all; its penetration r + d goes on smoothly from r - d outside. It is
   found up to `deep` (one spacing) behind the surface. Open rims have no inside. Corners sharper than
   the particle within one patch count as one contact.

   The inside-outside test of F15 (7)-(9) is here for comparison: every triangle for itself, faces
   only, unsigned distance, force along the face normal. It leaves gaps at convex edges and counts
   twice where prisms over faces overlap. */
#ifndef TM_TOUCH_H
#define TM_TOUCH_H

#include "tm_closest.h"
#include "tm_group.h"
#include "tm_tri_grid.h"

#include <limits.h>

#define TM_TOUCH_MAX 6 /* patches or, with F15's test, triangles that one particle may touch */

typedef struct {
  tm_vec3 point;    /* on the surface */
  tm_vec3 normal;   /* unit, the direction of the normal force */
  tm_real distance; /* of the center from the surface along normal, negative behind it */
  int triangle;
} tm_touch;

/* Nearest point of one patch. */
typedef struct {
  tm_closest near;
  int triangle, patch;
} tm_candidate;

/* Relative size under which directions and places count as equal: coordinates on a lattice meet
   vertices and edges exactly, and rounding must not decide whether they are found. */
#define TM_TOUCH_EPS 1e-7

/* Is the point of an edge or vertex also nearest among the patches across the boundary? */
TM_FN int tm_touch_is_minimum(const tm_tri_view *m, const tm_candidate *c, tm_vec3 p)
{
  if (c->near.feature == TM_FACE) return 1;
  const tm_vec3 q = c->near.point, d = tm_vec_sub(p, q);
  const tm_real slack2 = TM_TOUCH_EPS * TM_TOUCH_EPS * c->near.dist2;
  if (c->near.feature >= TM_VERTEX_0) {
    const int v = m->tri[3 * (ptrdiff_t) c->triangle + c->near.feature - TM_VERTEX_0];
    for (int s = m->spoke_first[v]; s < m->spoke_first[v + 1]; s++) {
      const tm_vec3 w = tm_vec_sub(tm_load3(m->vertex + 3 * (ptrdiff_t) m->spoke[s]), q);
      const tm_real climb = tm_vec_dot(d, w);
      if (climb > 0.0 && climb * climb > slack2 * tm_vec_dot(w, w)) return 0;
    }
    return 1;
  }
  const int h = 3 * c->triangle + c->near.feature - TM_EDGE_0;
  for (int g = m->twin[h]; g >= 0 && g != h; g = m->twin[g]) {
    if (m->patch[g / 3] == c->patch) continue;
    const double *apex = m->corner + 9 * (ptrdiff_t) (g / 3) + 3 * ((g % 3 + 2) % 3);
    const tm_vec3 w = tm_vec_sub(tm_load3(apex), q); /* d is square to the edge */
    const tm_real climb = tm_vec_dot(d, w);
    if (climb > 0.0 && climb * climb > slack2 * tm_vec_dot(w, w)) return 0;
  }
  return 1;
}

/* Pseudo-normal of the nearest feature; zero on an open rim. */
TM_FN tm_vec3 tm_touch_pseudo_normal(const tm_tri_view *m, const tm_candidate *c)
{
  const ptrdiff_t t = c->triangle;
  const int f = c->near.feature;
  if (f == TM_FACE) return tm_load3(m->normal + 3 * t);
  if (f < TM_VERTEX_0) return tm_load3(m->edge_normal + 9 * t + 3 * (f - TM_EDGE_0));
  return tm_load3(m->vertex_normal + 3 * (ptrdiff_t) m->tri[3 * t + f - TM_VERTEX_0]);
}

/* Side, distance and direction of the force at a candidate. */
TM_FN tm_touch tm_touch_at(const tm_tri_view *m, const tm_candidate *c, tm_vec3 p, tm_real radius, int two_sided)
{
  const tm_vec3 d = tm_vec_sub(p, c->near.point), np = tm_touch_pseudo_normal(m, c);
  const tm_real r = sqrt(c->near.dist2);
  const int behind = !two_sided && tm_vec_dot(d, np) < 0.0;
  tm_touch t;
  t.point = c->near.point;
  t.triangle = c->triangle;
  t.distance = behind ? -r : r;
  if (c->near.feature == TM_FACE) t.normal = two_sided && tm_vec_dot(d, np) < 0.0 ? tm_vec_scale(-1.0, np) : np;
  else if (r > 1e-6 * radius) t.normal = tm_vec_scale((behind ? -1.0 : 1.0) / r, d);
  else t.normal = tm_vec_dot(np, np) > 0.0 ? np : tm_load3(m->normal + 3 * (ptrdiff_t) c->triangle);
  return t;
}

/* Puts together what the threads of a group have found: the nearest, of equal ones the first of the list; at: its place in
   the list, INT_MAX where there is none. */
TM_FN void tm_touch_nearest_of_group(tm_group group, int *at, tm_candidate *best)
{
  for (int far = group.size / 2; far > 0; far /= 2) {
    tm_candidate c;
    c.near.point.x = tm_group_other(best->near.point.x, far, group);
    c.near.point.y = tm_group_other(best->near.point.y, far, group);
    c.near.point.z = tm_group_other(best->near.point.z, far, group);
    c.near.dist2 = tm_group_other(best->near.dist2, far, group);
    c.near.feature = tm_group_other_int(best->near.feature, far, group);
    c.triangle = tm_group_other_int(best->triangle, far, group);
    c.patch = tm_group_other_int(best->patch, far, group);
    const int other = tm_group_other_int(*at, far, group);
    if (other == INT_MAX) continue;
    if (*at < INT_MAX && (c.near.dist2 > best->near.dist2 || (c.near.dist2 == best->near.dist2 && other > *at)))
      continue;
    *best = c;
    *at = other;
  }
}

/* Nearest point within `limit` on one segment of a cell's list, which is one patch; 0: none. */
TM_FN int tm_touch_nearest(const tm_tri_view *m, const tm_grid_view *g, int begin, int end, tm_vec3 p, tm_real away,
                           tm_real limit, tm_group group, tm_candidate *best)
{
  int at = INT_MAX;
  if (group.size > 1) { /* read by the others */
    best->near.point = p;
    best->near.dist2 = 0.0;
    best->near.feature = best->triangle = best->patch = 0;
  }
  for (int k = begin + group.lane; k < end; k += group.size) {
    if (g->near[k] - away >= limit) break; /* sorted: the rest is farther still */
    const ptrdiff_t t = g->list[k];
    const tm_vec3 d = tm_vec_sub(p, tm_load3(m->ball + 4 * t));
    const tm_real far = limit + m->ball[4 * t + 3];
    if (!(tm_vec_dot(d, d) < far * far)) continue;
    const tm_closest c = tm_closest_on_facet(p, m, (int) t);
    if (!(c.dist2 < limit * limit)) continue;
    limit = sqrt(c.dist2);
    best->near = c;
    best->triangle = (int) t;
    best->patch = m->patch[t];
    at = k;
  }
  if (group.size > 1) tm_touch_nearest_of_group(group, &at, best);
  return at < INT_MAX;
}

/* Nearest points of the patches within the search radius of p, the nearest of all first; their number. When
   there are too many patches the nearest ones are kept. */
TM_FN int tm_touch_candidates(const tm_tri_view *m, const tm_grid_view *g, tm_vec3 p, tm_real search, tm_group group,
                              tm_candidate *list)
{
  tm_real away;
  const ptrdiff_t cell = tm_grid_cell(g, p, &away);
  int n = 0;
  if (cell < 0) return 0;
  for (int s = g->first[cell]; s < g->first[cell + 1]; s++) {
    tm_candidate c;
    if (!tm_touch_nearest(m, g, g->segment[s], g->segment[s + 1], p, away, search, group, &c)) continue;
    int k = n < TM_TOUCH_MAX ? n++ : TM_TOUCH_MAX; /* sorted in by distance */
    for (; k > 0 && c.near.dist2 < list[k - 1].near.dist2; k--)
      if (k < TM_TOUCH_MAX) list[k] = list[k - 1];
    if (k < TM_TOUCH_MAX) list[k] = c;
  }
  return n;
}

/* Contacts of a particle at p in the mesh's frame; their number. All threads of a group get them. */
TM_FN int tm_touch_find(const tm_tri_view *m, const tm_grid_view *g, tm_vec3 p, tm_real radius, tm_real deep,
                        int two_sided, tm_group group, tm_touch *out)
{
  tm_candidate list[TM_TOUCH_MAX];
  const tm_real search = two_sided ? radius : tm_max(radius, deep);
  const int n = tm_touch_candidates(m, g, p, search, group, list);
  int found = 0;
  for (int k = 0; k < n; k++) {
    if (k > 0 && !tm_touch_is_minimum(m, list + k, p)) continue;
    const tm_touch t = tm_touch_at(m, list + k, p, radius, two_sided);
    /* behind the surface: true of the nearest point only, others may be the far side of a blade */
    int keep = t.distance < 0.0 ? k == 0 : t.distance < radius;
    for (int j = 0; j < found && t.distance >= 0.0; j++) {
      const tm_vec3 e = tm_vec_sub(out[j].point, t.point);
      if (out[j].distance >= 0.0 && tm_vec_dot(e, e) < 1e-12 * radius * radius) keep = 0;
    }
    if (keep) out[found++] = t;
  }
  return found;
}

/* The same by F15 (7)-(9). */
TM_FN int tm_touch_find_f15(const tm_tri_view *m, const tm_grid_view *g, tm_vec3 p, tm_real radius, tm_touch *out)
{
  int length, found = 0;
  const int *near = tm_grid_query(g, p, &length);
  for (int k = 0; k < length && found < TM_TOUCH_MAX; k++) {
    const ptrdiff_t t = near[k];
    const double *c = m->corner + 9 * t;
    const tm_vec3 A = tm_load3(c), B = tm_load3(c + 3), C = tm_load3(c + 6);
    const tm_vec3 n = tm_load3(m->normal + 3 * t);     /* F15 (7) */
    const tm_real h = tm_vec_dot(n, tm_vec_sub(p, A)); /* of F15 (9) */
    if (!(fabs(h) < radius)) continue;
    const tm_vec3 Q = tm_vec_axpy(p, -h, n); /* inside by F15 (8)? */
    if (tm_vec_dot(tm_vec_cross(tm_vec_sub(B, A), tm_vec_sub(Q, A)), n) < 0.0 ||
        tm_vec_dot(tm_vec_cross(tm_vec_sub(C, B), tm_vec_sub(Q, B)), n) < 0.0 ||
        tm_vec_dot(tm_vec_cross(tm_vec_sub(A, C), tm_vec_sub(Q, C)), n) < 0.0)
      continue;
    out[found].point = Q;
    out[found].normal = n;
    out[found].distance = fabs(h);
    out[found++].triangle = (int) t;
  }
  return found;
}

#endif
