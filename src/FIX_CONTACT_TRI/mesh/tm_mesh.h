/* SPH-TM: a triangle mesh with the topology that contact needs, built from a triangle soup.

   Vertices closer than a tolerance (relative to the diagonal of the bounding box) become one.
   Facets of no area, whose smallest height is below that tolerance, and facets on vertices already
   taken are dropped and counted; what remains is linked by its edges. Triangles joined by edges of
   a dihedral angle below `smooth_angle` form a smooth patch. Pseudo-normals: mean of the two faces
   at an edge, angle-weighted mean at a vertex (Baerentzen and Aanaes 2005), so that the sign of
   (p - q).n tells the side at the closest point q whatever feature q lies on. */
#ifndef TM_MESH_H
#define TM_MESH_H

#include <stddef.h>

#include "tm_tri_view.h"

#ifdef __cplusplus
extern "C" {
#endif

enum tm_mesh_status {
  TM_MESH_OK = 0,
  TM_MESH_NO_FILE,        /* cannot be opened or read */
  TM_MESH_EMPTY,          /* no bytes */
  TM_MESH_NOT_A_MESH,     /* neither STL nor legacy VTK */
  TM_MESH_TRUNCATED,      /* ends before it says it does */
  TM_MESH_TRAILING,       /* goes on after it says it ends */
  TM_MESH_SYNTAX,         /* a word or number where another was due */
  TM_MESH_BAD_VALUE,      /* NaN, infinity or beyond 1e30 */
  TM_MESH_NO_TRIANGLES,   /* a mesh of nothing */
  TM_MESH_ALL_DEGENERATE, /* no facet with area */
  TM_MESH_TOO_LARGE,      /* counts that cannot be right, or no memory for them */
  TM_MESH_NOT_TRIANGLES,  /* VTK cells of another kind */
  TM_MESH_BAD_INDEX,      /* VTK cell with a point that does not exist */
  TM_MESH_UNSUPPORTED,    /* VTK dataset or type that is not read */
  TM_MESH_WRITE_FAILED
};

/* Most facets that are accepted: 9 nt and 3 nt + 3 nt must fit an int. */
#define TM_MESH_MAX_FACETS 100000000

/* Triangles as read: three corners each, and the facet normal where the file has one. */
typedef struct {
  int n;
  double *corner; /* 9 n */
  double *normal; /* 3 n, or NULL */
} tm_soup;

typedef struct {
  int nv, nt, npatch;
  double *vertex, *corner, *normal, *ball, *area, *edge_normal, *vertex_normal;
  int *tri, *twin, *patch, *spoke_first, *spoke;
  double lo[3], hi[3]; /* bounding box */
  double total_area;
  double volume;    /* enclosed, positive with outward normals; 0 when not closed */
  double tolerance; /* length under which vertices became one */
  int dropped_degenerate, dropped_duplicate;
  int open_edges, nonmanifold_edges;
  int inconsistent_edges; /* manifold edges run twice in the same direction */
  int flipped_normals;    /* facets whose normal in the file opposes their vertex order */
  int closed;             /* no open, non-manifold or inconsistent edge */
} tm_mesh;

typedef struct {
  double tolerance;    /* merge vertices within this times the box diagonal; default 1e-7 */
  double smooth_angle; /* degrees; default 30 */
} tm_mesh_options;

tm_mesh_options tm_mesh_defaults(void);

/* Both return an enum tm_mesh_status; msg gets the reason (up to nmsg characters with the 0). */
int tm_mesh_build(const tm_soup *soup, const tm_mesh_options *options, tm_mesh *mesh, char *msg, size_t nmsg);
void tm_mesh_free(tm_mesh *mesh);
void tm_soup_free(tm_soup *soup);
/* Turn every facet around (for a mesh that was written inside out). */
void tm_soup_flip(tm_soup *soup);

tm_tri_view tm_mesh_view(const tm_mesh *mesh);
/* Of a closed mesh: a triangle of a body whose normals point into it, and that is no cavity of another body, or -1. turned: of
   the mesh with all triangles turned round. */
int tm_mesh_inside_out(const tm_mesh *mesh, int turned);
const char *tm_mesh_status_name(int status);

/* The steps of tm_mesh_build, in tm_mesh_topology.c. */
int tm_mesh_weld(const tm_soup *soup, double tolerance, tm_mesh *mesh);
int tm_mesh_link(tm_mesh *mesh);
int tm_mesh_patches(tm_mesh *mesh, double smooth_angle);
int tm_mesh_normals(tm_mesh *mesh);

#ifdef __cplusplus
}
#endif

#endif
