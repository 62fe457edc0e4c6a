/* SPH-TM: legacy VTK and STL files; see tm_mesh_write.h. */
#include "tm_mesh_write.h"

#include <errno.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

static void put_big32(FILE *f, uint32_t u)
{
  const unsigned char b[4] = {(unsigned char) (u >> 24), (unsigned char) (u >> 16), (unsigned char) (u >> 8),
                              (unsigned char) u};
  fwrite(b, 1, 4, f);
}

static void put_big_double(FILE *f, double x)
{
  uint64_t u;
  memcpy(&u, &x, sizeof u);
  put_big32(f, (uint32_t) (u >> 32));
  put_big32(f, (uint32_t) u);
}

static void put_little32(FILE *f, uint32_t u)
{
  const unsigned char b[4] = {(unsigned char) u, (unsigned char) (u >> 8), (unsigned char) (u >> 16),
                              (unsigned char) (u >> 24)};
  fwrite(b, 1, 4, f);
}

static void put_little_float(FILE *f, double x)
{
  const float y = (float) x;
  uint32_t u;
  memcpy(&u, &y, sizeof u);
  put_little32(f, u);
}

static void put_numbers(FILE *f, const double *x, ptrdiff_t n, int columns, int binary)
{
  for (ptrdiff_t i = 0; i < n; i++)
    if (binary) put_big_double(f, x[i]);
    else fprintf(f, "%.17g%c", x[i], (i + 1) % columns ? ' ' : '\n');
  if (binary) fputc('\n', f);
}

static FILE *begin(const char *path, char *msg, size_t nmsg)
{
  if (nmsg > 0) msg[0] = '\0';
  errno = 0;
  FILE *f = fopen(path, "wb");
  if (!f) snprintf(msg, nmsg, "cannot write %s: %s", path, strerror(errno));
  return f;
}

static int finish(FILE *f, const char *path, char *msg, size_t nmsg)
{
  errno = 0;
  const int bad = ferror(f);
  if (fclose(f) == 0 && !bad) return TM_MESH_OK;
  snprintf(msg, nmsg, "cannot write %s: %s", path, errno ? strerror(errno) : "write failed");
  return TM_MESH_WRITE_FAILED;
}

int tm_write_vtk(const char *path, const tm_facets *s, const tm_cell_array *array, int arrays, const char *title,
                 int binary, char *msg, size_t nmsg)
{
  FILE *f = begin(path, msg, nmsg);
  if (!f) return TM_MESH_WRITE_FAILED;
  fprintf(f, "# vtk DataFile Version 3.0\n%.200s\n%s\nDATASET POLYDATA\nPOINTS %d double\n", title,
          binary ? "BINARY" : "ASCII", s->nv);
  put_numbers(f, s->vertex, 3 * (ptrdiff_t) s->nv, 3, binary);
  fprintf(f, "POLYGONS %d %lld\n", s->nt, 4 * (long long) s->nt);
  for (ptrdiff_t t = 0; t < s->nt; t++) {
    const int *v = s->tri + 3 * t;
    if (!binary) fprintf(f, "3 %d %d %d\n", v[0], v[1], v[2]);
    for (int k = 0; k < 4 && binary; k++) put_big32(f, k ? (uint32_t) v[k - 1] : 3u);
  }
  if (binary) fputc('\n', f);
  if (arrays > 0) fprintf(f, "CELL_DATA %d\n", s->nt);
  for (int a = 0; a < arrays; a++) {
    const int columns = array[a].columns;
    if (columns == 1) fprintf(f, "SCALARS %s double 1\nLOOKUP_TABLE default\n", array[a].name);
    else fprintf(f, "VECTORS %s double\n", array[a].name);
    put_numbers(f, array[a].value, columns * (ptrdiff_t) s->nt, columns, binary);
  }
  return finish(f, path, msg, nmsg);
}

static tm_vec3 facet_normal(const tm_vec3 *p)
{
  const tm_vec3 n = tm_vec_cross(tm_vec_sub(p[1], p[0]), tm_vec_sub(p[2], p[0]));
  const double length = tm_vec_norm(n);
  return tm_vec_scale(length > 0.0 ? 1.0 / length : 0.0, n);
}

static void put_facet(FILE *f, tm_vec3 n, const tm_vec3 *p, int binary)
{
  if (!binary) fprintf(f, "  facet normal %.9g %.9g %.9g\n    outer loop\n", n.x, n.y, n.z);
  for (int k = binary ? -1 : 0; k < 3; k++) {
    const tm_vec3 a = k < 0 ? n : p[k];
    if (binary) {
      put_little_float(f, a.x);
      put_little_float(f, a.y);
      put_little_float(f, a.z);
    } else {
      fprintf(f, "      vertex %.17g %.17g %.17g\n", a.x, a.y, a.z);
    }
  }
  if (!binary) fputs("    endloop\n  endfacet\n", f);
  else fwrite("\0", 1, 2, f);
}

int tm_write_stl(const char *path, const tm_facets *s, const char *name, int binary, char *msg, size_t nmsg)
{
  FILE *f = begin(path, msg, nmsg);
  if (!f) return TM_MESH_WRITE_FAILED;
  if (binary) {
    char header[80] = "SPH-TM ";
    strncat(header, name, sizeof header - 8);
    fwrite(header, 1, sizeof header, f);
    put_little32(f, (uint32_t) s->nt);
  } else {
    fprintf(f, "solid %s\n", name);
  }
  for (ptrdiff_t t = 0; t < s->nt; t++) {
    tm_vec3 p[3];
    for (int k = 0; k < 3; k++) p[k] = tm_load3(s->vertex + 3 * (ptrdiff_t) s->tri[3 * t + k]);
    put_facet(f, facet_normal(p), p, binary);
  }
  if (!binary) fprintf(f, "endsolid %s\n", name);
  return finish(f, path, msg, nmsg);
}
