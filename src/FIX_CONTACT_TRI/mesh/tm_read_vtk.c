/* SPH-TM: legacy VTK files of triangles.

     # vtk DataFile Version 3.0
     title
     ASCII | BINARY
     DATASET POLYDATA | UNSTRUCTURED_GRID
     POINTS n type            x y z of each
     POLYGONS | CELLS n size  3 i j k of each; from version 5.1 on instead of that
                              OFFSETS type, n numbers, CONNECTIVITY type, size numbers
     CELL_TYPES n             5 for a triangle (UNSTRUCTURED_GRID only)
     POINT_DATA | CELL_DATA   not read

   Numbers are read one by one through number(), text or big-endian alike. */
#include <stdlib.h>
#include <string.h>

#include "tm_scan.h"

#define VTK_TRIANGLE 5
#define VTK_POLYGON 7

typedef struct {
  const char *name;
  int bytes, real, sign;
} vtk_type;
static const vtk_type types[] = {{"float", 4, 1, 1},         {"double", 8, 1, 1},        {"int", 4, 0, 1},
                                 {"unsigned_int", 4, 0, 0},  {"short", 2, 0, 1},         {"unsigned_short", 2, 0, 0},
                                 {"char", 1, 0, 1},          {"unsigned_char", 1, 0, 0}, {"long", 8, 0, 1},
                                 {"unsigned_long", 8, 0, 0}, {"vtktypeint64", 8, 0, 1},  {"vtkidtype", 4, 0, 1},
                                 {"vtktypeint32", 4, 0, 1},  {"vtktypeuint64", 8, 0, 0}, {NULL, 0, 0, 0}};

typedef struct {
  int binary, grid; /* grid: UNSTRUCTURED_GRID */
  uint64_t points, cells, typed;
  double *point;
  uint64_t *index; /* 3 per cell */
} vtk;

static const vtk_type *type_of(const char *name)
{
  const vtk_type *t = types;
  while (t->name && strcmp(t->name, name) != 0) t++;
  return t->name ? t : NULL;
}

static double big_endian(const unsigned char *b, const vtk_type *t)
{
  uint64_t u = 0;
  for (int k = 0; k < t->bytes; k++) u = u << 8 | b[k];
  if (t->real && t->bytes == 4) {
    const uint32_t w = (uint32_t) u;
    float f;
    memcpy(&f, &w, sizeof f);
    return f;
  }
  if (t->real) {
    double d;
    memcpy(&d, &u, sizeof d);
    return d;
  }
  if (t->sign && (u >> (8 * t->bytes - 1)) & 1) return -1.0; /* no count or index is negative */
  return (double) u;
}

static int number(tm_scan *s, const vtk *v, const vtk_type *t, double *value)
{
  if (!v->binary) return tm_scan_real(s, value);
  if (tm_scan_left(s) < (size_t) t->bytes) return 0;
  *value = big_endian(s->p, t);
  s->p += t->bytes;
  return 1;
}

static int cut_off(tm_scan *s, const char *what)
{
  return tm_scan_fail(s, tm_scan_left(s) < 8 ? TM_MESH_TRUNCATED : TM_MESH_SYNTAX,
                      "VTK: %s are cut off or not numbers (line %d)", what, tm_scan_line(s));
}

static int count(tm_scan *s, const char *what, uint64_t *n)
{
  char word[TM_WORD];
  tm_scan_peek(s, word);
  if (tm_scan_count(s, TM_MESH_MAX_FACETS * (uint64_t) 9, n)) return TM_MESH_OK;
  const int digits = word[0] >= '0' && word[0] <= '9';
  return tm_scan_fail(s,
                      digits    ? TM_MESH_TOO_LARGE
                      : word[0] ? TM_MESH_SYNTAX
                                : TM_MESH_TRUNCATED,
                      "VTK: number of %s %s (line %d)", what, digits ? "too large" : "missing", tm_scan_line(s));
}

static int fits(tm_scan *s, const vtk *v, const vtk_type *t, uint64_t n, const char *what)
{
  /* text: at least a digit and a blank per number but for the last */
  const uint64_t least = v->binary ? n * (uint64_t) t->bytes : n > 0 ? 2 * n - 1 : 0;
  if (least <= tm_scan_left(s)) return TM_MESH_OK;
  return tm_scan_fail(s, TM_MESH_TRUNCATED, "VTK: %llu numbers of %s are announced, only %llu bytes follow",
                      (unsigned long long) n, what, (unsigned long long) tm_scan_left(s));
}

static int data_type(tm_scan *s, const vtk_type **t)
{
  char word[TM_WORD];
  tm_scan_word(s, word);
  *t = type_of(word);
  if (*t) return TM_MESH_OK;
  return tm_scan_fail(s, TM_MESH_UNSUPPORTED, "VTK: data type '%.30s' is not read", word);
}

static int read_points(tm_scan *s, vtk *v)
{
  const vtk_type *t;
  int status = count(s, "points", &v->points);
  if (status == TM_MESH_OK) status = data_type(s, &t);
  if (status != TM_MESH_OK) return status;
  if (v->point) return tm_scan_fail(s, TM_MESH_SYNTAX, "VTK: POINTS twice");
  tm_scan_line_end(s);
  status = fits(s, v, t, 3 * v->points, "POINTS");
  if (status != TM_MESH_OK) return status;
  v->point = (double *) malloc(sizeof(double) * (3 * (size_t) v->points + 1));
  if (!v->point) return tm_scan_fail(s, TM_MESH_TOO_LARGE, "VTK: no memory for the points");
  for (uint64_t i = 0; i < 3 * v->points; i++)
    if (!number(s, v, t, v->point + i)) return cut_off(s, "POINTS");
  return TM_MESH_OK;
}

static int not_triangle(tm_scan *s, uint64_t cell, double corners)
{
  return tm_scan_fail(s, TM_MESH_NOT_TRIANGLES,
                      "VTK: cell %llu has %.0f vertices; only triangles are read, "
                      "triangulate the mesh first",
                      (unsigned long long) cell, corners);
}

static int allocate_cells(tm_scan *s, vtk *v)
{
  if (v->index) return tm_scan_fail(s, TM_MESH_SYNTAX, "VTK: two lists of cells");
  if (v->cells > TM_MESH_MAX_FACETS)
    return tm_scan_fail(s, TM_MESH_TOO_LARGE, "VTK: more than %d cells", TM_MESH_MAX_FACETS);
  v->index = (uint64_t *) malloc(sizeof(uint64_t) * (3 * (size_t) v->cells + 1));
  return v->index ? TM_MESH_OK : tm_scan_fail(s, TM_MESH_TOO_LARGE, "VTK: no memory for cells");
}

static int read_index(tm_scan *s, const vtk *v, const vtk_type *t, uint64_t *index)
{
  double x;
  if (!number(s, v, t, &x)) return cut_off(s, "cells");
  if (!(x >= 0.0 && x < 9e15) || x != floor(x))
    return tm_scan_fail(s, TM_MESH_BAD_INDEX, "VTK: %g is no point number", x);
  *index = (uint64_t) x;
  return TM_MESH_OK;
}

/* Versions before 5.1: "3 i j k" of each cell. */
static int read_cells(tm_scan *s, vtk *v, uint64_t size)
{
  const vtk_type *t = type_of("int");
  int status = fits(s, v, t, size, "cells");
  if (status == TM_MESH_OK && size / 4 < v->cells && size >= v->cells)
    status = tm_scan_fail(s, TM_MESH_NOT_TRIANGLES, "VTK: cells with less than three vertices");
  else if (status == TM_MESH_OK && size < v->cells)
    status = tm_scan_fail(s, TM_MESH_SYNTAX, "VTK: sizes of the cell list contradict each other");
  if (status == TM_MESH_OK) status = allocate_cells(s, v);
  for (uint64_t c = 0; c < v->cells && status == TM_MESH_OK; c++) {
    double corners;
    if (!number(s, v, t, &corners)) return cut_off(s, "cells");
    if (corners != 3.0) return not_triangle(s, c + 1, corners);
    for (int k = 0; k < 3 && status == TM_MESH_OK; k++) status = read_index(s, v, t, v->index + 3 * c + k);
  }
  return status;
}

/* Version 5.1: offsets, then all vertices. */
static int read_cells_51(tm_scan *s, vtk *v, uint64_t offsets, uint64_t size)
{
  const vtk_type *t;
  int status = data_type(s, &t);
  if (status != TM_MESH_OK) return status;
  tm_scan_line_end(s);
  status = fits(s, v, t, offsets, "OFFSETS");
  v->cells = offsets > 0 ? offsets - 1 : 0;
  if (status == TM_MESH_OK) status = allocate_cells(s, v);
  double last = 0.0, next;
  for (uint64_t c = 0; c < offsets && status == TM_MESH_OK; c++, last = next) {
    if (!number(s, v, t, &next)) return cut_off(s, "OFFSETS");
    if (c > 0 && next - last != 3.0) return not_triangle(s, c, next - last);
  }
  if (status != TM_MESH_OK) return status;
  if (size != 3 * v->cells || !tm_scan_accept(s, "connectivity"))
    return tm_scan_fail(s, TM_MESH_SYNTAX, "VTK: CONNECTIVITY of three per cell expected");
  status = data_type(s, &t);
  if (status != TM_MESH_OK) return status;
  tm_scan_line_end(s);
  status = fits(s, v, t, size, "CONNECTIVITY");
  for (uint64_t i = 0; i < size && status == TM_MESH_OK; i++) status = read_index(s, v, t, v->index + i);
  return status;
}

static int read_cell_list(tm_scan *s, vtk *v)
{
  uint64_t size;
  int status = count(s, "cells", &v->cells);
  if (status == TM_MESH_OK) status = count(s, "cell entries", &size);
  if (status != TM_MESH_OK) return status;
  tm_scan_line_end(s);
  if (tm_scan_accept(s, "offsets")) return read_cells_51(s, v, v->cells, size);
  return read_cells(s, v, size);
}

static int read_cell_types(tm_scan *s, vtk *v)
{
  const vtk_type *t = type_of("int");
  int status = count(s, "cell types", &v->typed);
  tm_scan_line_end(s);
  if (status == TM_MESH_OK) status = fits(s, v, t, v->typed, "CELL_TYPES");
  for (uint64_t c = 0; c < v->typed && status == TM_MESH_OK; c++) {
    double kind;
    if (!number(s, v, t, &kind)) return cut_off(s, "CELL_TYPES");
    if (kind != VTK_TRIANGLE && kind != VTK_POLYGON)
      return tm_scan_fail(s, TM_MESH_NOT_TRIANGLES, "VTK: cell %llu is of type %.0f; only triangles (type 5) are read",
                          (unsigned long long) (c + 1), kind);
  }
  return status;
}

/* FIELD name arrays, each: name components tuples type, and the numbers. */
static int skip_field(tm_scan *s, vtk *v)
{
  char word[TM_WORD];
  uint64_t arrays, columns, rows;
  tm_scan_word(s, word);
  int status = count(s, "field arrays", &arrays);
  for (uint64_t a = 0; a < arrays && status == TM_MESH_OK; a++) {
    const vtk_type *t;
    tm_scan_word(s, word);
    status = count(s, "field components", &columns);
    if (status == TM_MESH_OK) status = count(s, "field tuples", &rows);
    if (status == TM_MESH_OK) status = data_type(s, &t);
    if (status != TM_MESH_OK) break;
    tm_scan_line_end(s);
    if (columns > 1000000) return tm_scan_fail(s, TM_MESH_TOO_LARGE, "VTK: field with too many components");
    status = fits(s, v, t, rows * columns, "FIELD");
    double x;
    for (uint64_t i = 0; i < rows * columns && status == TM_MESH_OK; i++)
      if (!number(s, v, t, &x)) return cut_off(s, "FIELD");
  }
  return status;
}

/* METADATA goes on to a blank line. */
static int skip_metadata(tm_scan *s)
{
  tm_scan_line_end(s);
  while (s->p < s->end && *s->p != '\n' && *s->p != '\r') tm_scan_line_end(s);
  return TM_MESH_OK;
}

static int read_header(tm_scan *s, vtk *v)
{
  char word[TM_WORD];
  tm_scan_line_end(s);
  tm_scan_line_end(s);
  tm_scan_word(s, word);
  v->binary = strcmp(word, "binary") == 0;
  if (!v->binary && strcmp(word, "ascii") != 0)
    return tm_scan_fail(s, TM_MESH_SYNTAX, "VTK: third line must be ASCII or BINARY, not '%.20s'", word);
  return TM_MESH_OK;
}

static int read_dataset(tm_scan *s, vtk *v)
{
  char word[TM_WORD];
  tm_scan_word(s, word);
  v->grid = strcmp(word, "unstructured_grid") == 0;
  if (v->grid || strcmp(word, "polydata") == 0) return TM_MESH_OK;
  return tm_scan_fail(s, TM_MESH_UNSUPPORTED,
                      "VTK: dataset '%.30s' is no triangle mesh (POLYDATA or UNSTRUCTURED_GRID)", word);
}

/* One section; *done when the rest is attributes. */
static int read_section(tm_scan *s, vtk *v, const char *word, int *done)
{
  if (strcmp(word, "dataset") == 0) return read_dataset(s, v);
  if (strcmp(word, "points") == 0) return read_points(s, v);
  if (strcmp(word, "polygons") == 0 && !v->grid) return read_cell_list(s, v);
  if (strcmp(word, "cells") == 0 && v->grid) return read_cell_list(s, v);
  if (strcmp(word, "cell_types") == 0 && v->grid) return read_cell_types(s, v);
  if (strcmp(word, "field") == 0) return skip_field(s, v);
  if (strcmp(word, "metadata") == 0) return skip_metadata(s);
  if (strcmp(word, "vertices") == 0 || strcmp(word, "lines") == 0 || strcmp(word, "triangle_strips") == 0)
    return tm_scan_fail(s, TM_MESH_NOT_TRIANGLES, "VTK: %s are not read, only triangles", word);
  *done = strcmp(word, "point_data") == 0 || strcmp(word, "cell_data") == 0;
  if (*done) return TM_MESH_OK;
  return tm_scan_fail(s, v->index ? TM_MESH_TRAILING : TM_MESH_SYNTAX,
                      "VTK: '%.20s' is no section that is known here (line %d)", word, tm_scan_line(s));
}

static int to_soup(tm_scan *s, const vtk *v, tm_soup *soup)
{
  if (!v->point || !v->index || (v->grid && v->typed != v->cells))
    return tm_scan_fail(s, TM_MESH_TRUNCATED, "VTK: %s missing",
                        !v->point   ? "POINTS"
                        : !v->index ? "cells"
                                    : "CELL_TYPES of all cells");
  if (v->cells == 0) return tm_scan_fail(s, TM_MESH_NO_TRIANGLES, "VTK: no triangles");
  soup->corner = (double *) malloc(sizeof(double) * 9 * (size_t) v->cells);
  if (!soup->corner) return tm_scan_fail(s, TM_MESH_TOO_LARGE, "VTK: no memory for the triangles");
  soup->n = (int) v->cells;
  for (size_t c = 0; c < 3 * (size_t) v->cells; c++) {
    if (v->index[c] >= v->points)
      return tm_scan_fail(s, TM_MESH_BAD_INDEX, "VTK: cell %llu refers to point %llu of %llu",
                          (unsigned long long) (c / 3 + 1), (unsigned long long) v->index[c],
                          (unsigned long long) v->points);
    memcpy(soup->corner + 3 * c, v->point + 3 * (size_t) v->index[c], 3 * sizeof(double));
  }
  return TM_MESH_OK;
}

int tm_read_vtk(tm_scan *s, tm_soup *soup)
{
  vtk v;
  char word[TM_WORD];
  memset(&v, 0, sizeof v);
  int done = 0, status = read_header(s, &v);
  while (status == TM_MESH_OK && !done) {
    tm_scan_word(s, word);
    if (!word[0]) break;
    status = read_section(s, &v, word, &done);
  }
  if (status == TM_MESH_OK) status = to_soup(s, &v, soup);
  free(v.point);
  free(v.index);
  return status;
}
