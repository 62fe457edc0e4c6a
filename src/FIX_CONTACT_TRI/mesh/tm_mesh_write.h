/* SPH-TM: writing triangles: legacy VTK (POLYDATA, with values per triangle) and STL.

   VTK files are version 3.0, ASCII or BINARY (big endian, double precision); scalars and vectors
   appear in ParaView and OVITO under their names. STL is single precision when binary. */
#ifndef TM_MESH_WRITE_H
#define TM_MESH_WRITE_H

#include "tm_mesh.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Values per triangle: a scalar (1 column) or a vector (3). */
typedef struct {
  const char *name; /* no blanks */
  int columns;
  const double *value; /* columns nt */
} tm_cell_array;

/* What to write: nv vertices, nt triangles of three vertex indices. */
typedef struct {
  int nv, nt;
  const double *vertex;
  const int *tri;
} tm_facets;

/* Both return TM_MESH_OK, or TM_MESH_WRITE_FAILED with the reason in msg. */
int tm_write_vtk(const char *path, const tm_facets *s, const tm_cell_array *array, int arrays, const char *title,
                 int binary, char *msg, size_t nmsg);
int tm_write_stl(const char *path, const tm_facets *s, const char *name, int binary, char *msg, size_t nmsg);

#ifdef __cplusplus
}
#endif

#endif
