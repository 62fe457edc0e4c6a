/* SPH-TM: proximity check of adaptive lists, from time to time: is a particle near that is no neighbor in the row of
   total-Lagrangian pairs, or has a neighbor moved? */
#ifndef TM_TL_PROXIMITY_H
#define TM_TL_PROXIMITY_H

#include "tm_tl_rows.h"

typedef struct {
  tm_tl_rows rows;
  tm_rows candidates; /* of all within reach */
  tm_records rec;
  tm_real *history;
  const unsigned char *is_ul;       /* updated-Lagrangian */
  tm_real h, support, near, change; /* radius, near distance, displacement: in units of h */
  tm_real time;                     /* since the last check, taken for that to the next one */
} tm_proximity_args;

/* Counts of a row: pairs that are near or will be so at the next check at their present velocity, those of them whose
   other end is total-Lagrangian, pairs that have moved. */
typedef struct {
  int near, near_tl, moved;
} tm_proximity_counts;

/* With weights a pair has moved if its distance differs from that of the freezing; without, if it is near and has moved
   far since the last check. Rows may hold particles beyond the reach: those do not count. */
TM_FN tm_proximity_counts tm_proximity_row(int i, const int *row, ptrdiff_t stride, int n_row,
                                           const tm_tl_rows *weights, const tm_proximity_args *a)
{
  const tm_real *ri = tm_main_record(&a->rec, i);
  const tm_real xi = ri[tm_part(0)], yi = ri[tm_part(1)], zi = ri[tm_part(2)];
  const tm_real vxi = ri[tm_part(4)], vyi = ri[tm_part(5)], vzi = ri[tm_part(6)];
  const tm_real near = a->near * a->h, support = a->support * a->h, change = a->change * a->h;
  const short *w = weights ? tm_weight(weights, i) : NULL;
  int near_all = 0, near_tl = 0, moved = 0;
  int TM_ALIGNED jj[TM_COLUMN], tl[TM_COLUMN];
  tm_pair TM_ALIGNED col[8][TM_COLUMN], then[TM_COLUMN];
  for (int k = 0; k < n_row; k += TM_CHUNK) {
    const int n = n_row - k < TM_CHUNK ? n_row - k : TM_CHUNK;
    const int lanes = TM_COLUMN == 1 ? 1 : (n + TM_LANES - 1) / TM_LANES * TM_LANES;
    for (int l = 0; l < lanes; l++) {
      const int j = l < n ? row[(k + l) * stride] : i;
      jj[tm_at(l)] = j;
      tl[tm_at(l)] = !a->is_ul[j];
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
      near_tl += is_near & tl[m];
      moved += w ? (r < then[m] - change) | (r > then[m] + change) : is_near & (fabs(a->time * vx) > change * r);
    }
  }
  const tm_proximity_counts sum = {near_all, near_tl, moved};
  return sum;
}

/* Sets TM_TL_PROXIMITY: the particle is updated-Lagrangian until no pair has moved in TM_PROXIMITY_HOLD checks. Where
   bodies meet, slide and part, rates are thus updated-Lagrangian; total-Lagrangian pairs would hold parting bodies
   together. Returns whether it was not so before. */
TM_FN int tm_proximity_check(int i, const tm_proximity_args *a)
{
  tm_real *k = a->history + (ptrdiff_t) i * TM_TL_HISTORY;
  const int was_near = k[TM_TL_PROXIMITY] > 0.5;
  if (!was_near && tm_is_ul(k)) return 0;
  const tm_tl_rows *r = &a->rows;
  const int *near = a->candidates.index + a->candidates.first[i], n_near = a->candidates.mechanical[i];
  if (was_near) {
    if (tm_proximity_row(i, near, a->candidates.stride, n_near, NULL, a).moved) k[TM_TL_PROXIMITY] = TM_PROXIMITY_HOLD;
    else k[TM_TL_PROXIMITY] -= 1.0;
    return 0;
  }
  const tm_proximity_counts known = tm_proximity_row(i, r->index + r->first[i], r->stride, r->tl[i], r, a);
  if (!known.moved && tm_proximity_row(i, near, a->candidates.stride, n_near, NULL, a).near_tl <= known.near) return 0;
  k[TM_TL_PROXIMITY] = TM_PROXIMITY_HOLD;
  return 1;
}

#endif
