/* Time of the rate pass of one pass (tm_rates.h) alone: a cube of a cubic lattice, jittered by 1 % of the spacing, with made-up
   velocities and stresses. Prints ns per particle, least and median of the turns. bench/rate_pass.sh compiles and runs it.

   Defined by the compiler's line: EFFECTS; TM_PAIR_SINGLE for pairs in single precision.
   Arguments: particles along an edge, turns. */
#include "tm_lattice.h"
#include "tm_rates.h"
#include "tm_single.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { ROOM = 128 };                                                                 /* entries of a row */
static const double DX = 1e-3, H = 1.2e-3, RHO = 2700.0, REACH = 2.0 * 1.2e-3 * 1.1; /* the skin is a tenth */

static double noise(void) { return rand() / (double) RAND_MAX - 0.5; }

static void *zeroed(size_t bytes)
{
  void *p = aligned_alloc(64, (bytes + 4096) / 64 * 64);
  if (!p) exit(1);
  memset(p, 0, (bytes + 4096) / 64 * 64);
  return p;
}
#define NEW(type, n) ((type *) zeroed(sizeof(type) * (size_t) (n)))

static int before(const void *a, const void *b)
{
  const double x = *(const double *) a, y = *(const double *) b;
  return (x > y) - (x < y);
}

/* Records of particle i, at cell c of `edge` cells along each side. */
static void fill(const tm_records *rec, int i, const int *c, int edge)
{
  double *r = rec->main + (ptrdiff_t) i * TM_REC, *s = rec->stab + (ptrdiff_t) i * TM_REC_STAB;
  for (int d = 0; d < 3; d++) {
    r[TM_REC_X + d] = (c[d] + 0.02 * noise()) * DX;
    r[TM_REC_V + d] = 10.0 * noise();
  }
  r[TM_REC_M] = RHO * DX * DX * DX;
  r[TM_REC_RHO] = RHO * (1.0 + 0.01 * noise());
  for (int k = 0; k < 6; k++) r[TM_REC_P + k] = noise();
  r[TM_REC_C] = 6000.0;
  r[TM_REC_BALSARA] = 1.0;
  for (int k = 0; k < 9; k++) s[TM_STAB_PK + k] = 30.0 * noise();
  for (int k = 0; k < 3; k++) s[TM_STAB_W + k] = 1e-6 * noise();
  s[TM_STAB_K] = 1e11;
  if (!rec->faces) s[TM_STAB_C] = 6000.0;
  for (int d = 0; rec->faces && d < 3; d++)
    s[TM_STAB_FACE + d] = c[d] == 0 ? 0.6 / H : c[d] == edge - 1 ? -0.6 / H : 0.0;
}

/* The row of each particle, from the cells around it. */
static double fill_rows(const double *main, int edge, int *index, ptrdiff_t *first, int *count)
{
  const int w = (int) (REACH / DX) + 1;
  ptrdiff_t total = 0;
  for (int i = 0; i < edge * edge * edge; i++) {
    const int c[3] = {i % edge, i / edge % edge, i / edge / edge};
    first[i] = total;
    for (int z = c[2] - w; z <= c[2] + w; z++)
      for (int y = c[1] - w; y <= c[1] + w; y++)
        for (int x = c[0] - w; x <= c[0] + w; x++) {
          if (x < 0 || y < 0 || z < 0 || x >= edge || y >= edge || z >= edge) continue;
          const int j = x + edge * (y + edge * z);
          double r2 = 0.0;
          for (int d = 0; d < 3; d++) {
            const double e = main[(ptrdiff_t) i * TM_REC + d] - main[(ptrdiff_t) j * TM_REC + d];
            r2 += e * e;
          }
          if (j != i && r2 < REACH * REACH) index[total++] = j;
        }
    count[i] = (int) (total - first[i]);
  }
  return (double) total;
}

int main(int argc, char **argv)
{
  const int edge = argc > 1 ? atoi(argv[1]) : 30, turns = argc > 2 ? atoi(argv[2]) : 40, n = edge * edge * edge;
  tm_rates_args a = {0};
  a.rec.main = NEW(double, n *TM_REC);
  a.rec.stab = NEW(double, n *TM_REC_STAB);
  a.rec.faces = ((EFFECTS) &TM_FX_FACES) != 0;
  a.correction = NEW(double, 6 * n);
  for (int i = 0; i < n; i++) {
    const int c[3] = {i % edge, i / edge % edge, i / edge / edge};
    fill(&a.rec, i, c, edge);
    for (int k = 0; k < 3; k++) a.correction[6 * i + k] = 1.0;
  }
  int *index = NEW(int, (ptrdiff_t) n *ROOM), *count = NEW(int, n), *none = NEW(int, n);
  ptrdiff_t *first = NEW(ptrdiff_t, n);
  const double entries = fill_rows(a.rec.main, edge, index, first, count) / n;
  a.rows = (tm_rows){index, first, count, none, none, 1, NULL, 0};
  a.effects = EFFECTS;
  a.h = H;
  a.support_radius2 = 4.0 * H * H;
  a.norm = tm_kernel_norm(TM_KERNEL_HYPERBOLIC, 3, H);
  a.slope_norm = a.norm / H;
  a.support2 = 4.0;
  a.visc_beta = 2.0;
  a.force_unit = 1.0;
  a.force_begins = 1;
  a.ntypes = 1;
  a.force = NEW(double, 3 * n);
  a.gradient = NEW(double, 9 * n);
  a.hourglass_rate = NEW(double, 3 * n);
  a.artificial = NEW(double, n);
  a.moment = NEW(double, TM_MOMENT_COLUMNS *n);
  a.turn = NEW(double, 3 * n);
  a.face_next = NEW(double, TM_FACE_COLUMNS *n);
  a.single.length = DX;
  a.single.volume = DX * DX * DX;
  a.single.visc_beta = 2.0f;
  a.single.position = tm_single_position_unit(REACH, DX);
  a.single.main = NEW(float, n *TM_REC);
  a.single.stab = NEW(float, n *TM_REC_STAB);
  const tm_single_args single = {a.rec, a.single, 0};
  for (int i = 0; TM_SINGLE && i < n; i++) tm_single(i, &single, EFFECTS);

  double *ns = NEW(double, turns), sum = 0.0;
  for (int k = 0; k < turns; k++) {
    struct timespec began, done;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &began);
    for (int i = 0; i < n; i++) tm_rates(i, &a, EFFECTS);
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &done);
    ns[k] = (1e9 * (double) (done.tv_sec - began.tv_sec) + (double) (done.tv_nsec - began.tv_nsec)) / n;
  }
  qsort(ns, (size_t) turns, sizeof(double), before);
  for (int i = 0; i < 3 * n; i++) sum += fabs(a.force[i]);
  printf("%d particles, %.1f entries: least %.1f, median %.1f ns; sum of forces %.12g\n", n, entries, ns[0],
         ns[turns / 2], sum);
  return 0;
}
