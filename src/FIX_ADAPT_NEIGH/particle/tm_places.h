/* SPH-TM: kept rows while particles get other places in memory.

   Before they do, the tags of all places are written down as names, and from then on an entry of a kept row is a place
   in that list. Rows then move as they are; those that come from another rank bring their tags, which go to the end of
   the list. Afterwards each entry becomes the place of the particle with its tag; of several images the closest. */
#ifndef TM_PLACES_H
#define TM_PLACES_H

#include "tm_kept.h"

typedef struct {
  tm_kept_rows rows;
  tm_real *memory;
} tm_kept_store;

/* Row and memory of particle `from` of a to place `to` of b. */
TM_FN void tm_kept_copy(const tm_kept_store *a, int from, const tm_kept_store *b, int to)
{
  const tm_kept_rows *r = &a->rows, *s = &b->rows;
  const int *index = r->index + r->first[from];
  const short *w = tm_weight(r, from);
  int *to_index = s->index + s->first[to];
  short *to_w = tm_weight(s, to);
  s->kept[to] = r->kept[from];
  for (int c = 0; c < TM_K; c++) b->memory[(ptrdiff_t) to * TM_K + c] = a->memory[(ptrdiff_t) from * TM_K + c];
  for (int e = 0; e < tm_kept_places(r->kept[from]); e++) {
    to_index[e * s->stride] = index[e * r->stride];
    for (int c = 0; c < TM_WEIGHTS; c++) to_w[tm_weight_place(s, c, e)] = w[tm_weight_place(r, c, e)];
  }
}

/* Values of a packed row: its length, the memory of the particle, then tag and weights of each entry. */
TM_FN int tm_kept_packed(int entries) { return 1 + TM_K + entries * (1 + TM_WEIGHTS); }

/* name: what entries mean. */
TM_FN int tm_kept_pack(int i, const tm_kept_store *a, const int *name, double *buf)
{
  const tm_kept_rows *r = &a->rows;
  const int n = r->kept[i], *index = r->index + r->first[i];
  const short *w = tm_weight(r, i);
  *buf++ = n;
  for (int c = 0; c < TM_K; c++) *buf++ = a->memory[(ptrdiff_t) i * TM_K + c];
  for (int e = 0; e < n; e++) {
    *buf++ = name[index[e * r->stride]];
    for (int c = 0; c < TM_WEIGHTS; c++) *buf++ = w[tm_weight_place(r, c, e)];
  }
  return tm_kept_packed(n);
}

/* Into place i; the names of its entries go to first_name and behind it. */
TM_FN int tm_kept_unpack(int i, const tm_kept_store *a, const double *buf, int first_name, int *name)
{
  const tm_kept_rows *r = &a->rows;
  const int n = (int) *buf++;
  int *index = r->index + r->first[i];
  short *w = tm_weight(r, i);
  r->kept[i] = n;
  for (int c = 0; c < TM_K; c++) a->memory[(ptrdiff_t) i * TM_K + c] = *buf++;
  for (int e = 0; e < tm_kept_places(n); e++) {
    index[e * r->stride] = e < n ? first_name + e : 0;
    if (e < n) name[first_name + e] = (int) *buf++;
    for (int c = 0; c < TM_WEIGHTS; c++) w[tm_weight_place(r, c, e)] = e < n ? (short) *buf++ : (short) 0;
  }
  return tm_kept_packed(n);
}

/* Particles that go to another rank or come from one, packed with a width of their own. */
typedef struct {
  tm_kept_store store;
  int *name;
  const int *place;            /* of particle k; -1: it is not for this rank */
  const int *filled_by;        /* when it goes: who takes its place, or -1 */
  double *buf;
  int width, first_name;       /* the names of received particle k begin at first_name + k room of a row */
} tm_kept_send_args;

TM_FN void tm_kept_send(int k, const tm_kept_send_args *a)
{
  tm_kept_pack(a->place[k], &a->store, a->name, a->buf + (ptrdiff_t) k * a->width);
  if (a->filled_by[k] >= 0) tm_kept_copy(&a->store, a->filled_by[k], &a->store, a->place[k]);
}
TM_FN void tm_kept_receive(int k, const tm_kept_send_args *a)
{
  if (a->place[k] >= 0)
    tm_kept_unpack(a->place[k], &a->store, a->buf + (ptrdiff_t) k * a->width,
                   a->first_name + k * a->store.rows.capacity, a->name);
}

typedef struct {
  tm_kept_store store;
  const int *name;             /* what entries mean */
  const int *tag;              /* owned and ghost */
  const double *x;
  int most;                    /* the largest tag */
  int *holder;                 /* by tag, to most: the place + 1 of a particle that has it, 0: none */
  int *other;                  /* of each place: the same for another particle of its tag */
  int forgets;                 /* who loses an entry is searched for a while; if not, he goes on with those left */
  unsigned char *gone;         /* of each name: 1 where an entry is nowhere. NULL: nobody asks */
  tm_records rec;              /* of this force point */
  tm_real slope_norm;          /* as in tm_rates_args */
  int corrected, dim3;         /* gradients are: Q = 1 */
} tm_places_args;

/* Place of the image of tag `name` that is closest to particle i, or -1. */
TM_FN int tm_place_of(int name, int i, const tm_places_args *a)
{
  const double *xi = a->x + 3 * (ptrdiff_t) i;
  tm_real least = 1e300;
  int found = -1;
  for (int next = name <= a->most ? a->holder[name] : 0; next; next = a->other[next - 1]) {
    const int j = next - 1;
    const double *y = a->x + 3 * (ptrdiff_t) j;
    const tm_real dx = xi[0] - y[0], dy = xi[1] - y[1], dz = xi[2] - y[2], r2 = dx * dx + dy * dy + dz * dz;
    if (j == i || r2 > least || (r2 == least && j > found)) continue;
    least = r2;
    found = j;
  }
  return found;
}

/* Entries of row i become places; those of particles that are nowhere go. Returns how many. Without them B of a kept
   particle stays what it is: G is that of the entries left, Q follows. */
TM_FN int tm_places(int i, const tm_places_args *a)
{
  const tm_kept_rows *r = &a->store.rows;
  int *row = r->index + r->first[i], n = r->kept[i];
  short *w = tm_weight(r, i);
  tm_real *k = a->store.memory + (ptrdiff_t) i * TM_K;
  for (int e = 0; e < n; e++) {
    const int entry = row[e * r->stride], j = tm_place_of(a->name[entry], i, a);
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
  const int lost = r->kept[i] - n;
  r->kept[i] = n;
  for (int e = n; e < tm_kept_places(n); e++) row[e * r->stride] = i;
  if (lost && a->forgets) k[TM_K_NEAR] = TM_NEAR_HOLD;
  else if (lost) {
    const tm_mat3 G = tm_kept_stretch(i, r, &a->rec, a->slope_norm, a->dim3, k + TM_K_SUM);
    if (!a->corrected) tm_mat_store(k + TM_K_Q, tm_mat_mul(tm_mat_transposed(G), tm_mat_load(k + TM_K_B)));
    tm_mat_store(k + TM_K_G, G);
    tm_kept_turn(k, tm_mat_scale(0.0, G), 0.0, a->dim3);
  }
  return lost;
}

#endif
