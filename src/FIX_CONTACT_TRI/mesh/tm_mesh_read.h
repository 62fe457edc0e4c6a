/* SPH-TM: reading triangles from STL and legacy VTK.

   STL: a file of 84 + 50 n bytes, n being its little-endian bytes 81-84, is binary, whatever its
   first word; anything else must be ASCII: `solid` ... `endsolid`, any number of solids, any case,
   any line ends. Facet normals of the file are only compared with the vertex order, so NaN there
   does no harm. VTK: versions 2 to 5.1, ASCII or BINARY (big endian), POLYDATA with POLYGONS or
   UNSTRUCTURED_GRID with triangles (type 5); other cells are refused. Attributes are not read.
   Every error has a status and a sentence; no count in a file is believed before it is held
   against the number of bytes that are there. */
#ifndef TM_MESH_READ_H
#define TM_MESH_READ_H

#include <stdio.h>

#include "tm_mesh.h"

#ifdef __cplusplus
extern "C" {
#endif

/* All return an enum tm_mesh_status; on error msg says what is wrong and soup is empty. A file of more than `most`
   bytes is refused. */
int tm_mesh_read_buffer(const void *data, size_t size, tm_soup *soup, char *msg, size_t nmsg);
int tm_mesh_read_file(const char *path, size_t most, tm_soup *soup, char *msg, size_t nmsg);
/* The bytes from here to the end of the file, to be freed; on error there are none. */
int tm_mesh_read_bytes(FILE *file, size_t most, unsigned char **data, size_t *size, char *msg, size_t nmsg);

#ifdef __cplusplus
}
#endif

#endif
