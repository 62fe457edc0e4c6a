/* Meshes: every file of unittest/meshes against its line in expected.txt; welding, patches,
   pseudo-normals, placement; what is written comes back. */
#include "tm_closest.h"
#include "tm_mesh_read.h"
#include "tm_mesh_transform.h"
#include "tm_mesh_write.h"
#include "tm_winding.h"
#include "ut_mesh.h"

#ifndef SPHTM_SOURCE
#define SPHTM_SOURCE "."
#endif
#define MESHES SPHTM_SOURCE "/unittest/meshes/"

static int read_and_build(const char *path, tm_mesh *m, char *msg, size_t nmsg)
{
  tm_soup soup;
  int status = tm_mesh_read_file(path, 100000000, &soup, msg, nmsg);
  memset(m, 0, sizeof *m);
  if (status == TM_MESH_OK) status = tm_mesh_build(&soup, NULL, m, msg, nmsg);
  tm_soup_free(&soup);
  return status;
}

static void status_word(int status, char *word)
{
  strcpy(word, tm_mesh_status_name(status));
  for (char *c = word; *c; c++)
    if (*c == ' ') *c = '_';
}

static void corpus(void)
{
  FILE *f = fopen(MESHES "expected.txt", "r");
  UT_TRUE(f != NULL);
  if (!f) return;
  char line[300], name[100], status[40], path[400], word[40], msg[256];
  int files = 0, n[8];
  double volume;
  while (fgets(line, sizeof line, f)) {
    if (line[0] == '#') continue;
    if (sscanf(line, "%99s %39s %d %d %d %d %d %d %d %d %lf", name, status, n, n + 1, n + 2, n + 3,
               n + 4, n + 5, n + 6, n + 7, &volume) != 11) {
      UT_TRUE(!"expected.txt is malformed");
      continue;
    }
    files++;
    snprintf(path, sizeof path, MESHES "%s", name);
    tm_mesh m;
    status_word(read_and_build(path, &m, msg, sizeof msg), word);
    const int found[8] = {m.nt, m.nv, m.dropped_degenerate, m.dropped_duplicate, m.open_edges,
                          m.nonmanifold_edges, m.inconsistent_edges, m.flipped_normals};
    int same = strcmp(word, status) == 0;
    for (int k = 0; k < 8; k++) same = same && found[k] == n[k];
    /* far from the origin a volume loses the digits of the coordinates */
    same = same && fabs(m.volume - volume) <= 1e-8 * fabs(volume);
    same = same && (strcmp(status, "ok") == 0) == (msg[0] == '\0');
    if (!same) printf("%s: %s (%s), expected %s", name, word, msg, line);
    UT_TRUE(same);
    tm_mesh_free(&m);
  }
  fclose(f);
  UT_TRUE(files > 90);
}

/* A buffer may hold anything, in any length: every beginning of every good file. */
static void every_length(void)
{
  const char *names[4] = {"ascii.stl", "binary.stl", "poly_binary_51.vtk", "grid_ascii_30.vtk"};
  char path[400], msg[256];
  for (int k = 0; k < 4; k++) {
    unsigned char data[8192];
    snprintf(path, sizeof path, MESHES "%s", names[k]);
    FILE *f = fopen(path, "rb");
    if (!f) continue;
    const size_t size = fread(data, 1, sizeof data, f);
    fclose(f);
    int accepted = 0;
    for (size_t n = 0; n <= size; n++) {
      tm_soup s;
      unsigned char *copy = (unsigned char *) malloc(n + 1);   /* ends where the memory does */
      memcpy(copy, data, n);
      accepted += tm_mesh_read_buffer(copy, n, &s, msg, sizeof msg) == TM_MESH_OK;
      free(copy);
      tm_soup_free(&s);
    }
    UT_TRUE(accepted >= 1 && accepted <= 16);   /* only what the last line end is cut from */
  }
}

/* A file may have as many bytes as are allowed and not one more. */
static void limit_of_size(void)
{
  char msg[256];
  tm_soup s;
  UT_TRUE(tm_mesh_read_file(MESHES "binary.stl", 484, &s, msg, sizeof msg) == TM_MESH_OK);   /* 84 + 50 n */
  UT_TRUE(s.n == 8);
  tm_soup_free(&s);
  UT_TRUE(tm_mesh_read_file(MESHES "binary.stl", 483, &s, msg, sizeof msg) == TM_MESH_TOO_LARGE);
  UT_TRUE(s.n == 0 && strstr(msg, "more than 483 bytes") != NULL);
  UT_TRUE(tm_mesh_read_file(MESHES "nowhere.stl", 483, &s, msg, sizeof msg) == TM_MESH_NO_FILE);
  UT_TRUE(tm_mesh_read_file(MESHES, 483, &s, msg, sizeof msg) == TM_MESH_NO_FILE);   /* a directory */
  UT_TRUE(s.n == 0 && msg[0] != '\0');
}

/* The wedge of the corpus: LIGGGHTS's list has three neighbours for every facet, too. */
static void wedge_topology(void)
{
  tm_mesh m;
  char msg[256];
  UT_TRUE(read_and_build(MESHES "ascii.stl", &m, msg, sizeof msg) == TM_MESH_OK);
  UT_TRUE(m.closed && m.npatch == 5);   /* two ends, three sides */
  double area = 0.0;
  for (int h = 0; h < 3 * m.nt; h++) {
    const int g = m.twin[h];
    UT_TRUE(g >= 0 && m.twin[g] == h && g / 3 != h / 3);
    UT_TRUE(m.tri[h] == m.tri[g % 3 == 2 ? g - 2 : g + 1]);
    area += m.area[h / 3] / 3.0;
  }
  UT_NEAR(area, 1.0 + 2.0 + sqrt(2.0), 1e-14);
  UT_NEAR(m.total_area, area, 1e-14);
  tm_mesh_free(&m);
}

/* Sign of (p - q).n at the closest feature tells inside from outside, as the winding number
   does. */
static void pseudo_normals(void)
{
  tm_soup soup = ut_soup(400);
  for (int k = 0; k < 120; k++) {   /* a spiky body: a cone of 60 facets up, one down, uneven */
    const int i = k % 60;
    const double a = 2 * TM_PI * i / 60, b = 2 * TM_PI * ((i + 1) % 60) / 60;
    const double ra = i % 3 ? 1.0 : 0.4, rb = (i + 1) % 3 ? 1.0 : 0.4;
    const tm_vec3 p = tm_vec(ra * cos(a), ra * sin(a), 0), q = tm_vec(rb * cos(b), rb * sin(b), 0);
    if (k < 60) ut_facet(&soup, p, q, tm_vec(0, 0, 1.5));
    else ut_facet(&soup, q, p, tm_vec(0, 0, -0.3));
  }
  tm_mesh m = ut_build(&soup);
  UT_TRUE(m.closed && m.volume > 0.0);
  const tm_tri_view v = tm_mesh_view(&m);
  int inside = 0, wrong = 0;
  for (int k = 0; k < 20000; k++) {
    const tm_vec3 p = ut_point(-1.2, 1.2);
    tm_closest best = tm_closest_on_facet(p, &v, 0);
    int t_best = 0;
    for (int t = 1; t < m.nt; t++) {
      const tm_closest c = tm_closest_on_facet(p, &v, t);
      if (!(c.dist2 < best.dist2)) continue;
      best = c;
      t_best = t;
    }
    const int f = best.feature;
    const double *n = f == TM_FACE ? m.normal + 3 * t_best
        : f < TM_VERTEX_0 ? m.edge_normal + 9 * t_best + 3 * (f - TM_EDGE_0)
                          : m.vertex_normal + 3 * m.tri[3 * t_best + f - TM_VERTEX_0];
    const int behind = tm_vec_dot(tm_vec_sub(p, best.point), tm_load3(n)) < 0.0;
    const int within = tm_winding_inside(&v, m.volume, p);
    wrong += behind != within;
    inside += within;
  }
  UT_TRUE(inside > 500);
  UT_TRUE(wrong == 0);
  tm_mesh_free(&m);
}

static tm_vec3 placed(int order)
{
  tm_soup s = ut_soup(1);
  ut_facet(&s, tm_vec(1, 2, 3), tm_vec(0, 0, 0), tm_vec(0, 1, 0));
  for (int k = 0; k < 3; k++) {
    const int step = order / (k == 0 ? 100 : k == 1 ? 10 : 1) % 10;
    if (step == 1) tm_soup_scale(&s, 2, 3, 4);
    if (step == 2) tm_soup_move(&s, tm_vec(10, 20, 30));
    if (step == 3) tm_soup_rotate(&s, tm_vec(0, 0, 2), 90);
  }
  const tm_vec3 p = tm_load3(s.corner);
  tm_soup_free(&s);
  return p;
}

static void placement(void)
{
  const struct { int order; double x, y, z; } due[4] = {
      {123, -26, 12, 42}, {213, -66, 22, 132}, {321, 16, 63, 132}, {132, 4, 22, 42}};
  for (int k = 0; k < 4; k++) {
    const tm_vec3 p = placed(due[k].order);
    UT_NEAR(p.x, due[k].x, 1e-14);
    UT_NEAR(p.y, due[k].y, 1e-14);
    UT_NEAR(p.z, due[k].z, 1e-14);
  }
  tm_soup s = ut_soup(12);   /* a mirrored body still has its normals outward */
  ut_box(&s, tm_vec(0, 0, 0), tm_vec(1, 1, 1), 1);
  tm_soup_scale(&s, -1, 2, 1);
  tm_mesh m = ut_build(&s);
  UT_NEAR(m.volume, 2.0, 1e-14);
  tm_mesh_free(&m);
}

/* Written, read and built again: the same mesh, to the precision of the format. */
static void round_trips(void)
{
  tm_soup s = ut_soup(12 * 9);
  ut_box(&s, tm_vec(-0.31, 0.017, 2.3), tm_vec(0.7, 1.1, 3.9), 3);
  tm_mesh m = ut_build(&s), back;
  char msg[256], path[4][60];
  const tm_facets facets = {m.nv, m.nt, m.vertex, m.tri};
  const tm_cell_array arrays[2] = {{"area", 1, m.area}, {"normal", 3, m.normal}};
  for (int k = 0; k < 4; k++) {
    snprintf(path[k], sizeof path[k], "test_mesh_%ld_%d.%s", (long) (ut_random(0, 1) * 1e9), k,
             k < 2 ? "vtk" : "stl");
    const int status = k < 2
        ? tm_write_vtk(path[k], &facets, arrays, 2, "round trip", k % 2, msg, sizeof msg)
        : tm_write_stl(path[k], &facets, "round trip", k % 2, msg, sizeof msg);
    UT_TRUE(status == TM_MESH_OK);
    UT_TRUE(read_and_build(path[k], &back, msg, sizeof msg) == TM_MESH_OK);
    UT_TRUE(back.nt == m.nt && back.nv == m.nv && back.closed && back.flipped_normals == 0);
    UT_NEAR(back.volume, m.volume, k == 3 ? 1e-6 : 1e-14);
    tm_mesh_free(&back);
    remove(path[k]);
  }
  UT_TRUE(tm_write_stl("no/such/folder/x.stl", &facets, "x", 1, msg, sizeof msg) != TM_MESH_OK);
  UT_TRUE(strstr(msg, "no/such/folder") != NULL);
  tm_mesh_free(&m);
}

/* Two boxes in a file, the second alone turned inside out: none where both are right, or where it is a cavity of the first. */
static int turned_box(tm_vec3 lo, tm_vec3 hi, int turned)
{
  tm_soup s = ut_soup(24 * 4);
  ut_box(&s, tm_vec(0, 0, 0), tm_vec(1, 1, 1), 2);
  const int first = s.n;
  ut_box(&s, lo, hi, 2);
  for (int t = first; t < s.n && turned; t++)
    for (int d = 0; d < 3; d++) {
      double *q = s.corner + 9 * (size_t) t, keep = q[d];
      q[d] = q[3 + d];
      q[3 + d] = keep;
    }
  tm_mesh m = ut_build(&s);
  const int found = tm_mesh_inside_out(&m, 0), right = found < 0 || m.corner[9 * (size_t) found] > 1.5;
  UT_TRUE(m.closed && m.volume > 0.0 && right);
  /* seen with all turned round there are some that point in, if not all pointed in */
  UT_TRUE(tm_mesh_inside_out(&m, 1) >= 0);
  tm_mesh_free(&m);
  return found >= 0;
}
static void bodies(void)
{
  const tm_vec3 lo = tm_vec(2, 0, 0), hi = tm_vec(2.5, 0.5, 0.5);
  UT_TRUE(turned_box(lo, hi, 1));
  UT_TRUE(!turned_box(lo, hi, 0));
  UT_TRUE(!turned_box(tm_vec(0.2, 0.2, 0.2), tm_vec(0.7, 0.7, 0.7), 1)); /* a cavity */
}

int main(void)
{
  corpus();
  bodies();
  every_length();
  limit_of_size();
  wedge_topology();
  pseudo_normals();
  placement();
  round_trips();
  return ut_summary();
}
