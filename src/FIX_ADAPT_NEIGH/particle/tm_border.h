/* SPH-TM: adaptive lists: which rows of neighbours are out of date, which particles are searched, and the rows
   at the border between them and those that are kept. See tm_kept.h.

   Every particle has a row of all within reach and a margin, from its place at its last search. It is
   searched anew when a particle near it has moved by half the margin. Of such rows the rates take what
   is within reach, so nothing depends on when they were made.

   Where particles have a reach of their own, R = support h, the row of i holds all j with r < (1 + m) max(R_i, R_j), m
   the margin. What R_i has grown by since then counts as a way of the particle: as long as way and growth of each are
   below m R/2, r + growth < (1 + m) max(R_i, R_j) for all that are within reach now. */
#ifndef TM_BORDER_H
#define TM_BORDER_H

#include "tm_kept_moment.h"
#include "tm_search.h"
#include "tm_settle.h"

typedef struct {
  const double *x;             /* owned and ghost */
  double *place;               /* at the last search */
  tm_real margin;              /* a distance; where each has its own reach: over that */
  tm_real part;                /* of the margin that a particle may move; negative: all count as moved */
  unsigned char *marks;        /* result: has moved; then place becomes x. NULL: only look */
  /* particles with a reach of their own */
  const tm_real *size;         /* records of size, or NULL: all have the same reach */
  tm_real support;             /* reach over h */
  tm_real *reach;              /* of each, with the margin; becomes that of now with place */
} tm_moved_args;

TM_FN int tm_moved(int i, const tm_moved_args *a)
{
  const double *x = a->x + 3 * (ptrdiff_t) i;
  double *p = a->place + 3 * (ptrdiff_t) i;
  const tm_real dx = x[0] - p[0], dy = x[1] - p[1], dz = x[2] - p[2];
  tm_real limit = a->part * a->margin, reach = 0.0;
  if (a->size) {
    const tm_real then = a->reach[i] / (1.0 + a->margin);
    reach = a->support / a->size[(ptrdiff_t) i * TM_REC_SIZE + TM_SIZE_INV_H];
    limit = limit * then - tm_max(reach - then, 0.0);
  }
  const int moved = a->part < 0.0 || limit < 0.0 || !(dx * dx + dy * dy + dz * dz <= limit * limit);
  if (!a->marks) return moved;
  a->marks[i] = (unsigned char) moved;
  for (int d = 0; moved && d < 3; d++) p[d] = x[d];
  if (moved && a->size) a->reach[i] = (1.0 + a->margin) * reach;
  return moved;
}

typedef struct {
  tm_kept_rows rows;
  tm_rows near;
  const tm_real *next;         /* as in tm_settle_args */
  unsigned char *was, *now, *dirty;
  int own, ghosts;             /* particles */
} tm_border_args;

/* What is to come is now; returns whether that is a change. */
TM_FN int tm_border_change(int i, const tm_border_args *a)
{
  a->was[i] = a->now[i];
  a->now[i] = a->next[i] > 0.5;
  return a->was[i] != a->now[i];
}

/* Marks the rows that hold one that has changed. Rows of owned particles are told by it; ghosts have none. */
TM_FN void tm_border_touch(int i, const tm_border_args *a)
{
  const int change = a->was[i] != a->now[i];
  if (!change && !a->ghosts) return;
  const int lengths[2] = {a->near.mechanical[i], a->rows.kept[i]};
  const int *rows[2] = {a->near.index + a->near.first[i], a->rows.index + a->rows.first[i]};
  if (change) a->dirty[i] = 1;
  for (int r = 0; r < 2; r++)
    for (int e = 0; e < lengths[r]; e++) {
      const int j = rows[r][e * a->rows.stride];
      if (j < a->own) {
        if (change) a->dirty[j] = 1;
      } else if (a->was[j] != a->now[j])
        a->dirty[i] = 1;
    }
}

/* Behind the kept pairs of a row: those whose other end is searched, in the order of the near row. */
TM_FN void tm_border(int i, const tm_border_args *a)
{
  if (!a->dirty[i]) return;
  const tm_kept_rows *r = &a->rows;
  const int places = tm_kept_places(r->kept[i]);
  const int *near = a->near.index + a->near.first[i];
  int *row = r->index + r->first[i] + places * r->stride, n = 0;
  for (int e = 0; e < a->near.mechanical[i] && !a->now[i]; e++) {
    const int j = near[e * a->near.stride];
    if (a->now[j]) row[n++ * r->stride] = j;
  }
  r->fresh[i] = n;
  r->fresh_first[i] = r->first[i] + places * r->stride;
}

/* Kinds of particles to be listed. */
enum {
  TM_SELECT_SEARCHED,          /* searched */
  TM_SELECT_BORDER,            /* not searched, with neighbours that are, or without any */
  TM_SELECT_NEAR               /* those near one that has moved */
};

typedef struct {
  int kind;
  tm_border_args border;
  tm_cells cells;              /* with the marked counted */
} tm_select_args;

TM_FN int tm_selected(int i, const tm_select_args *a)
{
  if (a->kind == TM_SELECT_SEARCHED) return a->border.now[i];
  if (a->kind == TM_SELECT_BORDER)
    return !a->border.now[i] && (a->border.rows.fresh[i] > 0 || a->border.rows.kept[i] == 0);
  tm_around around = tm_cells_around(&a->cells, a->cells.x + 3 * (ptrdiff_t) i);
  int begin, end;
  while (tm_around_next(&around, &a->cells, &begin, &end)) {
    if (a->cells.marked[begin] != a->cells.marked[end]) {
      a->border.dirty[i] = 1;
      return 1;
    }
  }
  return 0;
}

/* ---- from time to time: is something near that is no neighbour, or has a neighbour moved? */

typedef struct {
  tm_kept_rows rows;
  tm_rows near_rows;           /* all that are within reach */
  tm_records rec;
  tm_real *memory;
  const unsigned char *now;    /* searched */
  tm_real h, support, near, change;  /* the last three in units of h: see below */
  tm_real time;                /* since the last time, taken for that to the next one */
} tm_watch_args;

/* What a row tells: pairs that are near or will be the next time if they go on, those of them that are not searched,
   pairs that have moved. */
typedef struct {
  int near, near_kept, moved;
} tm_watched;

/* With weights a pair has moved if its distance is not that of its search any more; without, if it is near and has gone
   far since the last time. Rows may hold more than what is within reach: who asks must not notice. */
TM_FN tm_watched tm_watch_row(int i, const int *row, ptrdiff_t stride, int n_row, const tm_kept_rows *weights,
                              const tm_watch_args *a)
{
  const tm_real *ri = tm_main_record(&a->rec, i);
  const tm_real xi = ri[tm_part(0)], yi = ri[tm_part(1)], zi = ri[tm_part(2)];
  const tm_real vxi = ri[tm_part(4)], vyi = ri[tm_part(5)], vzi = ri[tm_part(6)];
  const tm_real near = a->near * a->h, support = a->support * a->h, change = a->change * a->h;
  const short *w = weights ? tm_weight(weights, i) : NULL;
  int near_all = 0, near_kept = 0, moved = 0;
  int TM_ALIGNED jj[TM_COLUMN], kept[TM_COLUMN];
  tm_pair TM_ALIGNED col[8][TM_COLUMN], then[TM_COLUMN];
  for (int k = 0; k < n_row; k += TM_CHUNK) {
    const int n = n_row - k < TM_CHUNK ? n_row - k : TM_CHUNK;
    const int lanes = TM_COLUMN == 1 ? 1 : (n + TM_LANES - 1) / TM_LANES * TM_LANES;
    for (int l = 0; l < lanes; l++) {
      const int j = l < n ? row[(k + l) * stride] : i;
      jj[tm_at(l)] = j;
      kept[tm_at(l)] = !a->now[j];
      then[tm_at(l)] = w && l < n ? a->h * TM_DISTANCE_UNIT * w[tm_weight_place(weights, TM_W_DISTANCE, k + l)] : 0.0;
    }
    if (TM_COLUMN > 1) tm_transpose_rows(a->rec.main, TM_REC, jj, lanes, 8, col[0]);
    else
      for (int c = 0; c < 8; c++) col[c][0] = tm_main_record(&a->rec, jj[0])[tm_part(c)];
    for (int l = 0; l < n; l++) {
      const int m = tm_at(l);
      const tm_real dx = xi - col[0][m], dy = yi - col[1][m], dz = zi - col[2][m];
      const tm_real vx = (vxi - col[4][m]) * dx + (vyi - col[5][m]) * dy + (vzi - col[6][m]) * dz;
      const tm_real r2 = dx * dx + dy * dy + dz * dz, r = sqrt(r2);
      const int is_near = (r < near) | ((r < support) & (r2 + a->time * vx < near * r));
      near_all += is_near;
      near_kept += is_near & kept[m];
      moved += w ? (r < then[m] - change) | (r > then[m] + change) : is_near & (fabs(a->time * vx) > change * r);
    }
  }
  const tm_watched sum = {near_all, near_kept, moved};
  return sum;
}

/* Sets memory TM_K_NEAR: the particle is searched in every step until nothing has moved for
   TM_NEAR_HOLD times. So where bodies meet, slide and part the rates are those of the search in every
   step; kept pairs would hold bodies together that part. Returns whether it was not so before. */
TM_FN int tm_watch(int i, const tm_watch_args *a)
{
  tm_real *k = a->memory + (ptrdiff_t) i * TM_K;
  const int was_near = k[TM_K_NEAR] > 0.5;
  if (!was_near && tm_is_searched(k)) return 0;
  const tm_kept_rows *r = &a->rows;
  const int *near = a->near_rows.index + a->near_rows.first[i], n_near = a->near_rows.mechanical[i];
  if (was_near) {
    if (tm_watch_row(i, near, a->near_rows.stride, n_near, NULL, a).moved) k[TM_K_NEAR] = TM_NEAR_HOLD;
    else k[TM_K_NEAR] -= 1.0;
    return 0;
  }
  const tm_watched known = tm_watch_row(i, r->index + r->first[i], r->stride, r->kept[i], r, a);
  if (!known.moved && tm_watch_row(i, near, a->near_rows.stride, n_near, NULL, a).near_kept <= known.near) return 0;
  k[TM_K_NEAR] = TM_NEAR_HOLD;
  return 1;
}

#endif
