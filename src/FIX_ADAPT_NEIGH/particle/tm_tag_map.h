/* SPH-TM: tag map of adaptive lists, from the pairs of a row to particles that have got other indices.

   Before particles are renumbered or migrate, the tags of all indices are written down; from then on an entry of a
   row is an index into that list. Tags of rows that come from another rank are appended. Afterwards each entry becomes
   the index of the particle with its tag, of several images that of the closest. */
#ifndef TM_TAG_MAP_H
#define TM_TAG_MAP_H

#include "tm_tl_migration.h"
#include "tm_tl_rates.h"

typedef struct {
  tm_tl_store store;
  const int *entry_tag; /* of each entry of the tag map */
  const int *tag;       /* owned and ghost */
  const double *x;
  int largest;         /* tag */
  int *first;          /* of each tag up to the largest: index + 1 of a particle with it, 0: none */
  int *next;           /* of each particle: the same for another image of its tag */
  int back_to_ul;      /* a particle that loses a pair becomes updated-Lagrangian; else it keeps the others */
  unsigned char *gone; /* result: 1 for entries whose particle was not found. NULL: not wanted */
  tm_records rec;      /* of this force point */
  tm_real slope_norm;  /* as in tm_rates_args */
  int corrected, dim3; /* corrected: as in tm_freeze_args */
} tm_tag_map_args;

/* Index of the image of a tag that is closest to particle i, or -1. */
TM_FN int tm_tag_map_find(int tag, int i, const tm_tag_map_args *a)
{
  const double *xi = a->x + 3 * (ptrdiff_t) i;
  tm_real least = 1e300;
  int found = -1;
  for (int next = tag <= a->largest ? a->first[tag] : 0; next; next = a->next[next - 1]) {
    const int j = next - 1;
    const double *y = a->x + 3 * (ptrdiff_t) j;
    const tm_real dx = xi[0] - y[0], dy = xi[1] - y[1], dz = xi[2] - y[2], r2 = dx * dx + dy * dy + dz * dz;
    if (j == i || r2 > least || (r2 == least && j > found)) continue;
    least = r2;
    found = j;
  }
  return found;
}

/* Entries of row i become indices of particles; pairs whose other particle is not found are removed. Returns their
   number. B of the particle does not change: G is that of the pairs left, and Q = G^T B. */
TM_FN int tm_tag_map_resolve(int i, const tm_tag_map_args *a)
{
  const tm_tl_rows *r = &a->store.rows;
  int *row = r->index + r->first[i], n = r->tl[i];
  short *w = tm_weight(r, i);
  tm_real *k = a->store.history + (ptrdiff_t) i * TM_TL_HISTORY;
  for (int e = 0; e < n; e++) {
    const int entry = row[e * r->stride], j = tm_tag_map_find(a->entry_tag[entry], i, a);
    if (j >= 0) {
      row[e * r->stride] = j;
      continue;
    }
    if (a->gone) a->gone[entry] = 1;
    n--;
    row[e * r->stride] = row[n * r->stride];
    for (int c = 0; c < TM_WEIGHTS; c++) {
      w[tm_weight_place(r, c, e)] = w[tm_weight_place(r, c, n)];
      w[tm_weight_place(r, c, n)] = 0;
    }
    e--;
  }
  const int lost = r->tl[i] - n;
  r->tl[i] = n;
  for (int e = n; e < tm_tl_padded(n); e++) row[e * r->stride] = i;
  if (lost && a->back_to_ul) k[TM_TL_PROXIMITY] = TM_PROXIMITY_HOLD;
  else if (lost) {
    const tm_mat3 G = tm_tl_position_gradient(i, r, &a->rec, a->slope_norm, a->dim3, k + TM_TL_SUM);
    if (!a->corrected) tm_mat_store(k + TM_TL_Q, tm_mat_mul(tm_mat_transposed(G), tm_mat_load(k + TM_TL_B)));
    tm_mat_store(k + TM_TL_G, G);
    tm_tl_advance_map(k, tm_mat_scale(0.0, G), 0.0, a->dim3);
  }
  return lost;
}

#endif
