/* SPH-TM: ASCII STL.

     solid [name]
       facet normal nx ny nz
         outer loop
           vertex x y z      three times
         endloop
       endfacet              any number
     endsolid [name]         any number of solids */
#include <stdlib.h>
#include <string.h>

#include "tm_scan.h"

/* Room for one more facet. */
static int grow(tm_scan *s, tm_soup *soup, size_t *room)
{
  if ((size_t) soup->n < *room) return TM_MESH_OK;
  if (soup->n >= TM_MESH_MAX_FACETS)
    return tm_scan_fail(s, TM_MESH_TOO_LARGE, "more than %d facets", TM_MESH_MAX_FACETS);
  const size_t more = *room ? 2 * *room : 256;
  double *corner = (double *) realloc(soup->corner, sizeof(double) * 9 * more);
  if (corner) soup->corner = corner;
  double *normal = (double *) realloc(soup->normal, sizeof(double) * 3 * more);
  if (normal) soup->normal = normal;
  if (!corner || !normal) return tm_scan_fail(s, TM_MESH_TOO_LARGE, "no memory for %d facets", soup->n);
  *room = more;
  return TM_MESH_OK;
}

static int expect(tm_scan *s, const char *word)
{
  char found[TM_WORD];
  if (tm_scan_accept(s, word)) return TM_MESH_OK;
  tm_scan_peek(s, found);
  if (!found[0])
    return tm_scan_fail(s, TM_MESH_TRUNCATED, "ASCII STL ends in line %d, before '%s'", tm_scan_line(s), word);
  if (strcmp(word, "endloop") == 0 && strcmp(found, "vertex") == 0)
    return tm_scan_fail(s, TM_MESH_NOT_TRIANGLES, "facet with more than three vertices in line %d",
                        tm_scan_line(s) + 1);
  return tm_scan_fail(s, TM_MESH_SYNTAX, "'%s' expected after line %d, found '%.20s'", word, tm_scan_line(s), found);
}

static int vertex(tm_scan *s, double *p)
{
  const int status = expect(s, "vertex");
  if (status != TM_MESH_OK) return status;
  for (int d = 0; d < 3; d++) {
    char word[TM_WORD];
    tm_scan_peek(s, word);
    if (!word[0])
      return tm_scan_fail(s, TM_MESH_TRUNCATED, "ASCII STL ends in line %d, within a vertex", tm_scan_line(s));
    if (!tm_scan_real(s, p + d))
      return tm_scan_fail(s, TM_MESH_SYNTAX, "line %d: '%.20s' is not a number", tm_scan_line(s), word);
  }
  return TM_MESH_OK;
}

static int facet(tm_scan *s, tm_soup *soup)
{
  double *normal = soup->normal + 3 * (size_t) soup->n;
  double *corner = soup->corner + 9 * (size_t) soup->n;
  int status = expect(s, "normal");
  for (int d = 0; d < 3 && status == TM_MESH_OK; d++) {
    if (!tm_scan_real(s, normal + d) || !(fabs(normal[d]) <= 1e30)) normal[d] = 0.0;
  }
  if (status == TM_MESH_OK) status = expect(s, "outer");
  if (status == TM_MESH_OK) status = expect(s, "loop");
  for (int k = 0; k < 3 && status == TM_MESH_OK; k++) status = vertex(s, corner + 3 * k);
  if (status == TM_MESH_OK) status = expect(s, "endloop");
  if (status == TM_MESH_OK) status = expect(s, "endfacet");
  if (status == TM_MESH_OK) soup->n++;
  return status;
}

int tm_read_stl_ascii(tm_scan *s, tm_soup *soup)
{
  size_t room = 0;
  char word[TM_WORD];
  while (tm_scan_accept(s, "solid")) {
    tm_scan_line_end(s);
    while (tm_scan_accept(s, "facet")) {
      int status = grow(s, soup, &room);
      if (status == TM_MESH_OK) status = facet(s, soup);
      if (status != TM_MESH_OK) return status;
    }
    const int status = expect(s, "endsolid");
    if (status != TM_MESH_OK) return status;
    tm_scan_line_end(s);
  }
  tm_scan_peek(s, word);
  if (word[0])
    return tm_scan_fail(s, TM_MESH_TRAILING, "'%.20s' after the end of the last solid in line %d", word,
                        tm_scan_line(s));
  if (soup->n == 0) return tm_scan_fail(s, TM_MESH_NO_TRIANGLES, "the ASCII STL file has no triangles");
  return TM_MESH_OK;
}
