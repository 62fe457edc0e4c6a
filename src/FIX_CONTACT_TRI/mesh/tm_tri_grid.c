/* SPH-TM: building the broad-phase grid; see tm_tri_grid.h.

   Each triangle descends into the box of cells it may touch, halving it along its longest side and
   dropping halves whose center is too far away: the work is that of the cells near the surface, not
   of the volume. Three descents: mark blocks, count, fill; then every list is sorted. */
#include "tm_tri_grid.h"

#include <stdlib.h>
#include <string.h>

#include "tm_closest.h"

enum pass { MARK, COUNT, FILL };

typedef struct {
  tm_tri_grid *grid;
  tm_tri_view mesh;
  enum pass pass;
  int unit; /* cells per smallest box of this pass: a block to mark, else 1 */
} descent;

static ptrdiff_t block_index(const tm_grid_view *v, const int *cell)
{
  return ((ptrdiff_t) (cell[2] >> TM_GRID_SHIFT) * v->blocks[1] + (cell[1] >> TM_GRID_SHIFT)) * v->blocks[0] +
         (cell[0] >> TM_GRID_SHIFT);
}

static void visit(const descent *d, const int *cell, int t)
{
  tm_tri_grid *g = d->grid;
  int *block = g->block + block_index(&g->view, cell);
  if (d->pass == MARK) {
    *block = 0;
    return;
  }
  if (*block < 0) return; /* only through rounding of the distance at its limit */
  const int m = TM_GRID_EDGE - 1;
  int *first = g->first + (ptrdiff_t) *block * TM_GRID_CELLS +
               ((((cell[2] & m) << TM_GRID_SHIFT) + (cell[1] & m)) << TM_GRID_SHIFT) + (cell[0] & m);
  if (d->pass == COUNT) first[0]++;
  else g->list[first[0]++] = t;
}

/* Cells lo..hi-1 of triangle t. */
static void descend(const descent *d, int t, const int *lo, const int *hi)
{
  const tm_grid_view *v = &d->grid->view;
  const double cell = d->grid->cell;
  double size[3], mid[3];
  int axis = 0;
  for (int k = 0; k < 3; k++) {
    size[k] = cell * (hi[k] - lo[k]);
    mid[k] = v->lo[k] + 0.5 * cell * (hi[k] + lo[k]);
    if (hi[k] - lo[k] > hi[axis] - lo[axis]) axis = k;
  }
  const double radius = 0.5 * sqrt(size[0] * size[0] + size[1] * size[1] + size[2] * size[2]);
  const double far = (v->radius + radius) * (1.0 + 1e-9);
  if (tm_closest_on_facet(tm_load3(mid), &d->mesh, t).dist2 > far * far) return;
  if (hi[axis] - lo[axis] <= d->unit) {
    visit(d, lo, t);
    return;
  }
  int cut_hi[3] = {hi[0], hi[1], hi[2]}, cut_lo[3] = {lo[0], lo[1], lo[2]};
  const int units = (hi[axis] - lo[axis]) / d->unit;
  cut_hi[axis] = cut_lo[axis] = lo[axis] + units / 2 * d->unit;
  descend(d, t, lo, cut_hi);
  descend(d, t, cut_lo, hi);
}

static void descend_all(tm_tri_grid *g, const tm_mesh *mesh, enum pass pass)
{
  descent d;
  d.grid = g;
  d.mesh = tm_mesh_view(mesh);
  d.pass = pass;
  d.unit = pass == MARK ? TM_GRID_EDGE : 1;
  for (int t = 0; t < mesh->nt; t++) {
    const double *c = mesh->corner + 9 * (ptrdiff_t) t;
    int lo[3], hi[3];
    for (int k = 0; k < 3; k++) {
      const double a = tm_min(c[k], tm_min(c[3 + k], c[6 + k])) - g->view.radius;
      const double b = tm_max(c[k], tm_max(c[3 + k], c[6 + k])) + g->view.radius;
      const int top = g->view.blocks[k] * TM_GRID_EDGE;
      lo[k] = (int) tm_clamp(floor((a - g->view.lo[k]) * g->view.inv_cell), 0.0, top - 1);
      hi[k] = 1 + (int) tm_clamp(floor((b - g->view.lo[k]) * g->view.inv_cell), 0.0, top - 1);
      lo[k] -= lo[k] % d.unit;
      hi[k] += (d.unit - hi[k] % d.unit) % d.unit;
    }
    descend(&d, t, lo, hi);
  }
}

/* Entries expected with a cell edge: volume of the points whose cell center comes near enough, by
   Steiner's formula 2 r A + pi/2 r^2 P + 4/3 pi r^3 per triangle. */
static double expected_entries(const tm_mesh *m, double radius, double cell)
{
  const double r = radius + 0.866 * cell;
  double volume = 0.0;
  for (ptrdiff_t t = 0; t < m->nt; t++) {
    const double *c = m->corner + 9 * t;
    const tm_vec3 a = tm_load3(c), b = tm_load3(c + 3), e = tm_load3(c + 6);
    const double perimeter =
        tm_vec_norm(tm_vec_sub(a, b)) + tm_vec_norm(tm_vec_sub(b, e)) + tm_vec_norm(tm_vec_sub(e, a));
    volume += r * (2.0 * m->area[t] + TM_PI * r * (0.5 * perimeter + 4.0 / 3.0 * r));
  }
  return volume / (cell * cell * cell);
}

/* Grid corner and extent for a cell edge; the number of blocks in the dense table. */
static double lay_out(tm_tri_grid *g, const tm_mesh *m)
{
  double n = 1.0;
  const double edge = TM_GRID_EDGE * g->cell;
  for (int k = 0; k < 3; k++) {
    g->view.lo[k] = m->lo[k] - g->view.radius * (1.0 + 1e-9);
    const double blocks = ceil((m->hi[k] - m->lo[k] + 2.0 * g->view.radius) * (1.0 + 1e-9) / edge);
    g->view.blocks[k] = blocks < 1e8 ? (int) tm_max(blocks, 1.0) : 100000000;
    n *= tm_max(blocks, 1.0);
  }
  g->view.cell = g->cell;
  g->view.inv_cell = 1.0 / g->cell;
  return n;
}

static int number_blocks(tm_tri_grid *g, size_t table)
{
  g->nblocks = 0;
  for (size_t b = 0; b < table; b++)
    if (g->block[b] == 0) g->block[b] = g->nblocks++;
  g->first = (int *) calloc((size_t) g->nblocks * TM_GRID_CELLS + 1, sizeof(int));
  return g->first != NULL;
}

/* Counts become where each list begins. */
static int prefix_sums(tm_tri_grid *g)
{
  const ptrdiff_t cells = (ptrdiff_t) g->nblocks * TM_GRID_CELLS;
  g->entries = 0;
  for (ptrdiff_t c = 0; c <= cells; c++) {
    const int n = g->first[c];
    g->first[c] = (int) g->entries;
    g->entries += n;
    if (g->entries > 2000000000) return 0;
  }
  g->list = (int *) malloc(sizeof(int) * ((size_t) g->entries + 1));
  return g->list != NULL;
}

/* --- segments: the list of a cell by patch, within a patch by distance from the center -------- */

typedef struct {
  int patch, t;
  double near;
} listed;

static int compare_listed(const void *a, const void *b)
{
  const listed *p = (const listed *) a, *q = (const listed *) b;
  if (p->patch != q->patch) return p->patch < q->patch ? -1 : 1;
  if (p->near != q->near) return p->near < q->near ? -1 : 1;
  return p->t < q->t ? -1 : p->t > q->t;
}

static tm_vec3 cell_center(const tm_grid_view *v, ptrdiff_t table, int cell)
{
  const int m = TM_GRID_EDGE - 1, nx = v->blocks[0], ny = v->blocks[1];
  const int i = (int) (table % nx) * TM_GRID_EDGE + (cell & m);
  const int j = (int) (table / nx % ny) * TM_GRID_EDGE + (cell >> TM_GRID_SHIFT & m);
  const int k = (int) (table / nx / ny) * TM_GRID_EDGE + (cell >> 2 * TM_GRID_SHIFT);
  return tm_vec(v->lo[0] + v->cell * (i + 0.5), v->lo[1] + v->cell * (j + 0.5), v->lo[2] + v->cell * (k + 0.5));
}

/* Sort one list and return its number of segments; their beginnings go to `segment`. */
static int sort_list(tm_tri_grid *g, const tm_tri_view *m, tm_vec3 center, int begin, int n, listed *work, int *segment)
{
  int segments = 0;
  for (int k = 0; k < n; k++) {
    work[k].t = g->list[begin + k];
    work[k].patch = m->patch[work[k].t];
    work[k].near = sqrt(tm_closest_on_facet(center, m, work[k].t).dist2);
  }
  qsort(work, (size_t) n, sizeof(listed), compare_listed);
  for (int k = 0; k < n; k++) {
    g->list[begin + k] = work[k].t;
    g->near[begin + k] = (float) (work[k].near * (1.0 - 1e-6));
    if (k == 0 || work[k].patch != work[k - 1].patch) segment[segments++] = begin + k;
  }
  return segments;
}

static int cut_segments(tm_tri_grid *g, const tm_mesh *mesh, size_t table)
{
  const tm_tri_view m = tm_mesh_view(mesh);
  const ptrdiff_t cells = (ptrdiff_t) g->nblocks * TM_GRID_CELLS;
  int longest = 1, segments = 0;
  for (ptrdiff_t c = 0; c < cells; c++)
    if (g->first[c + 1] - g->first[c] > longest) longest = g->first[c + 1] - g->first[c];
  listed *work = (listed *) malloc(sizeof(listed) * (size_t) longest);
  g->near = (float *) malloc(sizeof(float) * ((size_t) g->entries + 1));
  g->segment = (int *) malloc(sizeof(int) * ((size_t) g->entries + 1)); /* as many at most */
  const int ok = work && g->near && g->segment;
  for (size_t b = 0; b < table && ok; b++) {
    if (g->block[b] < 0) continue;
    int *first = g->first + (ptrdiff_t) g->block[b] * TM_GRID_CELLS;
    for (int c = 0; c < TM_GRID_CELLS; c++) {
      const int begin = first[c], n = first[c + 1] - begin;
      first[c] = segments; /* blocks come in the order of their numbers */
      segments += sort_list(g, &m, cell_center(&g->view, (ptrdiff_t) b, c), begin, n, work, g->segment + segments);
    }
  }
  free(work);
  if (!ok) return 0;
  g->first[cells] = segments;
  g->segment[segments] = (int) g->entries;
  int *fitted = (int *) realloc(g->segment, sizeof(int) * ((size_t) segments + 1));
  if (fitted) g->segment = fitted;
  return 1;
}

static void set_view(tm_tri_grid *g)
{
  g->view.block = g->block;
  g->view.first = g->first;
  g->view.segment = g->segment;
  g->view.list = g->list;
  g->view.near = g->near;
}

int tm_tri_grid_build(tm_tri_grid *g, const tm_mesh *mesh, double radius, double budget)
{
  memset(g, 0, sizeof *g);
  g->view.radius = radius;
  g->cell = radius;
  double table = lay_out(g, mesh);
  budget = tm_max(budget, 40.0 * mesh->nt);
  while (expected_entries(mesh, radius, g->cell) > budget || table > budget) {
    g->cell *= 1.26;
    table = lay_out(g, mesh);
  }
  g->block = (int *) malloc(sizeof(int) * (size_t) table);
  if (!g->block) return TM_MESH_TOO_LARGE;
  memset(g->block, 0xff, sizeof(int) * (size_t) table);
  descend_all(g, mesh, MARK);
  int ok = number_blocks(g, (size_t) table);
  if (ok) descend_all(g, mesh, COUNT);
  ok = ok && prefix_sums(g);
  if (ok) {
    descend_all(g, mesh, FILL);
    const ptrdiff_t cells = (ptrdiff_t) g->nblocks * TM_GRID_CELLS;
    for (ptrdiff_t c = cells; c > 0; c--) g->first[c] = g->first[c - 1];
    g->first[0] = 0;
    ok = cut_segments(g, mesh, (size_t) table);
  }
  if (!ok) {
    tm_tri_grid_free(g);
    return TM_MESH_TOO_LARGE;
  }
  set_view(g);
  return TM_MESH_OK;
}

void tm_tri_grid_free(tm_tri_grid *g)
{
  free(g->block);
  free(g->first);
  free(g->segment);
  free(g->list);
  free(g->near);
  memset(g, 0, sizeof *g);
}
