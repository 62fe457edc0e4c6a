/* SPH-TM: rows of total-Lagrangian pairs while particles get other indices: copying, and migration to other ranks.
   Entries of a row are then indices into a tag map, see tm_tag_map.h: rows are copied as they are, and those that come
   from another rank bring the tags of their pairs. */
#ifndef TM_TL_MIGRATION_H
#define TM_TL_MIGRATION_H

#include "tm_tl_rows.h"

typedef struct {
  tm_tl_rows rows;
  tm_real *history;
} tm_tl_store;

/* Row and history of particle `from` of a to index `to` of b. */
TM_FN void tm_tl_copy(const tm_tl_store *a, int from, const tm_tl_store *b, int to)
{
  const tm_tl_rows *r = &a->rows, *s = &b->rows;
  const int *index = r->index + r->first[from];
  const short *w = tm_weight(r, from);
  int *to_index = s->index + s->first[to];
  short *to_w = tm_weight(s, to);
  s->tl[to] = r->tl[from];
  for (int c = 0; c < TM_TL_HISTORY; c++)
    b->history[(ptrdiff_t) to * TM_TL_HISTORY + c] = a->history[(ptrdiff_t) from * TM_TL_HISTORY + c];
  for (int e = 0; e < tm_tl_padded(r->tl[from]); e++) {
    to_index[e * s->stride] = index[e * r->stride];
    for (int c = 0; c < TM_WEIGHTS; c++) to_w[tm_weight_place(s, c, e)] = w[tm_weight_place(r, c, e)];
  }
}

/* Values of a packed row: its length, the history of the particle, then tag and weights of each pair. */
TM_FN int tm_tl_packed(int entries) { return 1 + TM_TL_HISTORY + entries * (1 + TM_WEIGHTS); }

/* tag: of each entry in the tag map. */
TM_FN int tm_tl_pack(int i, const tm_tl_store *a, const int *tag, double *buf)
{
  const tm_tl_rows *r = &a->rows;
  const int n = r->tl[i], *index = r->index + r->first[i];
  const short *w = tm_weight(r, i);
  *buf++ = n;
  for (int c = 0; c < TM_TL_HISTORY; c++) *buf++ = a->history[(ptrdiff_t) i * TM_TL_HISTORY + c];
  for (int e = 0; e < n; e++) {
    *buf++ = tag[index[e * r->stride]];
    for (int c = 0; c < TM_WEIGHTS; c++) *buf++ = w[tm_weight_place(r, c, e)];
  }
  return tm_tl_packed(n);
}

/* Into index i; the tags of its pairs go to first_entry of the tag map and behind it. */
TM_FN int tm_tl_unpack(int i, const tm_tl_store *a, const double *buf, int first_entry, int *tag)
{
  const tm_tl_rows *r = &a->rows;
  const int n = (int) *buf++;
  int *index = r->index + r->first[i];
  short *w = tm_weight(r, i);
  r->tl[i] = n;
  for (int c = 0; c < TM_TL_HISTORY; c++) a->history[(ptrdiff_t) i * TM_TL_HISTORY + c] = *buf++;
  for (int e = 0; e < tm_tl_padded(n); e++) {
    index[e * r->stride] = e < n ? first_entry + e : 0;
    if (e < n) tag[first_entry + e] = (int) *buf++;
    for (int c = 0; c < TM_WEIGHTS; c++) w[tm_weight_place(r, c, e)] = e < n ? (short) *buf++ : (short) 0;
  }
  return tm_tl_packed(n);
}

/* Particles that are sent to another rank or received, packed with a fixed width. */
typedef struct {
  tm_tl_store store;
  int *tag;             /* of each entry in the tag map */
  const int *place;     /* index of particle k; -1: it is not for this rank */
  const int *filled_by; /* sent: index of the particle that takes its place, or -1 */
  double *buf;
  int width, first_entry; /* the tags of received particle k begin at first_entry + k capacity of a row */
} tm_tl_migration_args;

TM_FN void tm_tl_send(int k, const tm_tl_migration_args *a)
{
  tm_tl_pack(a->place[k], &a->store, a->tag, a->buf + (ptrdiff_t) k * a->width);
  if (a->filled_by[k] >= 0) tm_tl_copy(&a->store, a->filled_by[k], &a->store, a->place[k]);
}
TM_FN void tm_tl_receive(int k, const tm_tl_migration_args *a)
{
  if (a->place[k] >= 0)
    tm_tl_unpack(a->place[k], &a->store, a->buf + (ptrdiff_t) k * a->width, a->first_entry + k * a->store.rows.capacity,
                 a->tag);
}

#endif
