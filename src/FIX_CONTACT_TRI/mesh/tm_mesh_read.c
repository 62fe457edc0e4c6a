/* SPH-TM: telling mesh formats apart, and binary STL; see tm_mesh_read.h. */
#include "tm_mesh_read.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tm_scan.h"

#define STL_HEADER 84
#define STL_FACET 50

static uint32_t little_endian(const unsigned char *b)
{
  return (uint32_t) b[0] | (uint32_t) b[1] << 8 | (uint32_t) b[2] << 16 | (uint32_t) b[3] << 24;
}

static double little_float(const unsigned char *b)
{
  const uint32_t u = little_endian(b);
  float f;
  memcpy(&f, &u, sizeof f);
  return f;
}

static uint64_t binary_size(const tm_scan *s)
{
  return STL_HEADER + STL_FACET * (uint64_t) little_endian(s->begin + 80);
}

static int read_stl_binary(tm_scan *s, tm_soup *soup)
{
  const uint32_t n = little_endian(s->begin + 80);
  if (n == 0) return tm_scan_fail(s, TM_MESH_NO_TRIANGLES, "the binary STL file has no triangles");
  if (n > TM_MESH_MAX_FACETS)
    return tm_scan_fail(s, TM_MESH_TOO_LARGE, "%lu facets are more than the %d accepted", (unsigned long) n,
                        TM_MESH_MAX_FACETS);
  soup->corner = (double *) malloc(sizeof(double) * 9 * n);
  soup->normal = (double *) malloc(sizeof(double) * 3 * n);
  if (!soup->corner || !soup->normal)
    return tm_scan_fail(s, TM_MESH_TOO_LARGE, "no memory for %lu facets", (unsigned long) n);
  soup->n = (int) n;
  const unsigned char *b = s->begin + STL_HEADER;
  for (size_t t = 0; t < n; t++, b += STL_FACET) {
    for (size_t d = 0; d < 3; d++) soup->normal[3 * t + d] = little_float(b + 4 * d);
    for (size_t d = 0; d < 9; d++) soup->corner[9 * t + d] = little_float(b + 12 + 4 * d);
  }
  return TM_MESH_OK;
}

static int starts_with(const tm_scan *s, const char *text)
{
  const size_t n = strlen(text);
  return tm_scan_left(s) >= n && memcmp(s->p, text, n) == 0;
}

/* Bytes that no text has; `printable` counts the 80-byte STL header, where 0 fills up. */
static int has_control_bytes(const unsigned char *p, size_t n, int zero_is_one)
{
  for (size_t i = 0; i < n; i++)
    if ((p[i] < 9 && (p[i] != 0 || zero_is_one)) || (p[i] > 13 && p[i] < 27)) return 1;
  return 0;
}

/* Not binary STL by its size, nor text: say what comes closest. */
static int refuse_binary(tm_scan *s)
{
  const size_t size = (size_t) (s->end - s->begin);
  if (size < STL_HEADER || has_control_bytes(s->begin, 80, 0))
    return tm_scan_fail(s, TM_MESH_NOT_A_MESH, "neither STL nor legacy VTK: binary data without an STL header");
  const unsigned long n = little_endian(s->begin + 80);
  const unsigned long long due = binary_size(s);
  if (size < due)
    return tm_scan_fail(s, TM_MESH_TRUNCATED, "binary STL is truncated: %lu facets need %llu bytes, there are %llu", n,
                        due, (unsigned long long) size);
  return tm_scan_fail(s, TM_MESH_TRAILING, "binary STL goes on for %llu bytes after its %lu facets",
                      (unsigned long long) size - due, n);
}

static int read_any(tm_scan *s, tm_soup *soup)
{
  const size_t size = tm_scan_left(s);
  char word[TM_WORD];
  if (size == 0) return tm_scan_fail(s, TM_MESH_EMPTY, "the file is empty");
  if (size >= STL_HEADER && size == binary_size(s)) return read_stl_binary(s, soup);
  if (starts_with(s, "\xEF\xBB\xBF")) s->p += 3; /* byte order mark of UTF-8 */
  tm_scan_peek(s, word);
  if (starts_with(s, "# vtk DataFile")) return tm_read_vtk(s, soup);
  if (has_control_bytes(s->p, size < 512 ? tm_scan_left(s) : 500, 1)) return refuse_binary(s);
  if (strcmp(word, "solid") == 0) return tm_read_stl_ascii(s, soup);
  if (strncmp(word, "<!doctype", 9) == 0 || strncmp(word, "<html", 5) == 0)
    return tm_scan_fail(s, TM_MESH_NOT_A_MESH, "this is a web page (HTML), not a mesh: save the file itself");
  if (!word[0]) return tm_scan_fail(s, TM_MESH_EMPTY, "there is nothing but blank space");
  return tm_scan_fail(s, TM_MESH_NOT_A_MESH, "neither STL nor legacy VTK: it begins with '%.20s'", word);
}

static int check_values(tm_scan *s, const tm_soup *soup)
{
  for (size_t i = 0; i < 9 * (size_t) soup->n; i++)
    if (!(fabs(soup->corner[i]) <= 1e30))
      return tm_scan_fail(s, TM_MESH_BAD_VALUE,
                          "facet %lu has a vertex coordinate that is NaN, infinite or beyond 1e30",
                          (unsigned long) (i / 9 + 1));
  return TM_MESH_OK;
}

int tm_mesh_read_buffer(const void *data, size_t size, tm_soup *soup, char *msg, size_t nmsg)
{
  tm_scan s;
  s.begin = s.p = (const unsigned char *) data;
  s.end = s.begin + size;
  s.msg = msg;
  s.nmsg = nmsg;
  if (nmsg > 0) msg[0] = '\0';
  memset(soup, 0, sizeof *soup);
  int status = read_any(&s, soup);
  if (status == TM_MESH_OK) status = check_values(&s, soup);
  if (status != TM_MESH_OK) tm_soup_free(soup);
  return status;
}

int tm_mesh_read_bytes(FILE *file, size_t most, unsigned char **data, size_t *size, char *msg, size_t nmsg)
{
  size_t room = 0;
  *data = NULL;
  *size = 0;
  errno = 0;
  for (;;) {
    if (*size == room) {
      room = room ? 2 * room : 65536;
      if (room > most) room = most + 1; /* one more, to notice it */
      unsigned char *more = (unsigned char *) realloc(*data, room);
      if (!more) {
        snprintf(msg, nmsg, "no memory for the file");
        break;
      }
      *data = more;
    }
    const size_t got = fread(*data + *size, 1, room - *size, file);
    *size += got;
    if (*size > most) {
      snprintf(msg, nmsg, "the file has more than %llu bytes", (unsigned long long) most);
      break;
    }
    if (got > 0) continue;
    if (!ferror(file)) return TM_MESH_OK;
    snprintf(msg, nmsg, "cannot read the file: %s", strerror(errno));
    break;
  }
  free(*data);
  *data = NULL;
  *size = 0;
  return ferror(file) ? TM_MESH_NO_FILE : TM_MESH_TOO_LARGE;
}

int tm_mesh_read_file(const char *path, size_t most, tm_soup *soup, char *msg, size_t nmsg)
{
  memset(soup, 0, sizeof *soup);
  errno = 0;
  FILE *file = fopen(path, "rb");
  if (!file) {
    snprintf(msg, nmsg, "cannot open the file: %s", strerror(errno));
    return TM_MESH_NO_FILE;
  }
  unsigned char *data;
  size_t size;
  int status = tm_mesh_read_bytes(file, most, &data, &size, msg, nmsg);
  fclose(file);
  if (status == TM_MESH_OK) status = tm_mesh_read_buffer(data, size, soup, msg, nmsg);
  free(data);
  return status;
}
