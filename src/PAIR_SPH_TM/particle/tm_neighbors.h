/* SPH-TM: neighbor rows made from the host's list, and what is measured with them.

   A row has three segments: mechanical neighbors, those that exchange heat, contact candidates; a
   pair that conducts and touches stands in two. Each segment is in order of tag, then of memory, so
   that sums do not depend on the order in memory.

   On a GPU rows are interleaved, so that threads side by side read side by side: entry k of the
   rows of one slice of TM_ROW_SLICE particles lies together. Where no pair stands in two segments a row can be the host's
   own, put in order in its place: then there is one list in memory, not two, but rows lie farther apart. */
#ifndef TM_NEIGHBORS_H
#define TM_NEIGHBORS_H

#include "tm_chunk.h"
#include "tm_eigen.h"

#define TM_ROW_SLICE_GPU 32
#define TM_ROW_SLICE TM_BLOCK

/* segments of a row, as bits of what a pair takes part in */
enum { TM_MEETS_MECHANICAL = 1, TM_MEETS_THERMAL = 2, TM_MEETS_CONTACT = 4, TM_SEGMENTS = 3 };

typedef struct {
  const int *list, *length; /* the host's list: entry k of i is list[i row_step + k step] */
  ptrdiff_t row_step, step;
  int bits;                   /* of an entry that are the index */
  const unsigned char *meets; /* per type pair, index i * (ntypes + 1) + j: segments */
  const int *type, *tag;      /* LAMMPS's, owned and ghost */
  int ntypes;
  /* results */
  int *index, *count[TM_SEGMENTS];
  ptrdiff_t *first;
  ptrdiff_t stride; /* of index, for tm_row_put() */
  int in_place;     /* index is list */
} tm_row_args;

TM_FN int tm_row_meets(int i, int j, const tm_row_args *a)
{
  return a->meets[(ptrdiff_t) a->type[i] * (a->ntypes + 1) + a->type[j]];
}

/* Lengths of the segments of row i; returns their sum. */
TM_FN int tm_row_count(int i, const tm_row_args *a)
{
  const int *list = a->list + i * a->row_step;
  int count[TM_SEGMENTS] = {0, 0, 0};
  for (int k = 0; k < a->length[i]; k++) {
    const int meets = tm_row_meets(i, list[k * a->step] & a->bits, a);
    for (int s = 0; s < TM_SEGMENTS; s++) count[s] += meets >> s & 1;
  }
  for (int s = 0; s < TM_SEGMENTS; s++) a->count[s][i] = count[s];
  if (a->in_place) a->first[i] = i * a->row_step;
  return count[0] + count[1] + count[2];
}

/* Room for the rows of slice s; first holds where each slice begins, in order of slices. */
TM_FN ptrdiff_t tm_row_slice_size(int s, int n, const tm_row_args *a)
{
  int longest = 0;
  for (int i = s * TM_ROW_SLICE; i < n && i < (s + 1) * TM_ROW_SLICE; i++) {
    const int length = a->count[0][i] + a->count[1][i] + a->count[2][i];
    if (length > longest) longest = length;
  }
  return (ptrdiff_t) longest * TM_ROW_SLICE;
}

TM_FN int tm_row_before(int j, int k, const int *tag) { return tag[j] != tag[k] ? tag[j] < tag[k] : j < k; }

/* Entries of row i, sorted in one by one. */
TM_FN void tm_row_fill(int i, const tm_row_args *a)
{
  const int *list = a->list + i * a->row_step;
  int *begin[TM_SEGMENTS], used[TM_SEGMENTS];
  int *row = a->index + a->first[i];
  for (int s = 0; s < TM_SEGMENTS; s++) {
    begin[s] = row;
    used[s] = 0;
    row += (ptrdiff_t) a->count[s][i] * TM_ROW_SLICE;
  }
  for (int k = 0; k < a->length[i]; k++) {
    const int j = list[k * a->step] & a->bits, meets = tm_row_meets(i, j, a);
    for (int s = 0; s < TM_SEGMENTS; s++) {
      if (!(meets >> s & 1)) continue;
      ptrdiff_t at = used[s]++;
      for (; at > 0 && tm_row_before(j, begin[s][(at - 1) * TM_ROW_SLICE], a->tag); at--)
        begin[s][at * TM_ROW_SLICE] = begin[s][(at - 1) * TM_ROW_SLICE];
      begin[s][at * TM_ROW_SLICE] = j;
    }
  }
}

/* The same by many threads for one row: the entries of the host's list, and where each goes. In place all entries are
   loaded before the first is put. An entry is compared with all others of its row, so it is made for that: of two the one with
   the lower key comes first, and `meets` counts in all segments at once, 16 bits for each. */
typedef struct {
  unsigned long long key; /* tag, then index */
  unsigned long long meets;
} tm_row_entry;
enum { TM_ROW_COUNT_BITS = 16 };

TM_FN tm_row_entry tm_row_load(int i, int k, const tm_row_args *a)
{
  const int index = a->list[i * a->row_step + k * a->step] & a->bits, meets = tm_row_meets(i, index, a);
  tm_row_entry e;
  e.key = (unsigned long long) (unsigned) a->tag[index] << 32 | (unsigned) index;
  e.meets = a->in_place && !meets ? 1ull << TM_SEGMENTS * (int) TM_ROW_COUNT_BITS : 0;
  for (int s = 0; s < TM_SEGMENTS; s++) e.meets |= (unsigned long long) (meets >> s & 1) << s * TM_ROW_COUNT_BITS;
  return e;
}

/* Puts entry k of all n into the segments it belongs to, behind those of lower tag; in place what meets nothing goes to the
   end. */
TM_FN void tm_row_put(int i, int k, int n, const tm_row_entry *entry, const tm_row_args *a)
{
  const tm_row_entry e = entry[k];
  unsigned long long rank = 0;
  if (!e.meets) return;
  for (int l = 0; l < n; l++) {
    const tm_row_entry o = entry[l];
    if (o.key < e.key) rank += o.meets;
  }
  int *row = a->index + a->first[i];
  for (int s = 0; s <= TM_SEGMENTS; s++) {
    const int at = s * TM_ROW_COUNT_BITS;
    if (e.meets >> at & 1)
      row[(ptrdiff_t) (rank >> at & ((1u << TM_ROW_COUNT_BITS) - 1u)) * a->stride] = (int) (unsigned) e.key;
    if (s < TM_SEGMENTS) row += a->count[s][i] * a->stride;
  }
}

/* ---- measures of the rows at the positions of the records, those of owned and ghost particles at one time */

typedef struct {
  tm_rows rows;
  const tm_real *main;     /* records */
  tm_real support_radius2; /* (support h)^2, with size support^2 */
  const tm_real *size;     /* records of size, or NULL */
  tm_real *count;          /* mechanical neighbors within the support radius of each particle, or NULL */
  int dim;
} tm_near_args;

/* Square of the distance in the row; j its particle. */
TM_FN tm_real tm_near_dist2(int i, int k, const tm_near_args *a, int *j)
{
  *j = a->rows.index[a->rows.first[i] + k * a->rows.stride];
  const tm_real *p = a->main + tm_record(i, TM_REC), *q = a->main + tm_record(*j, TM_REC);
  const tm_real dx = p[0] - q[0], dy = p[1] - q[1], dz = p[tm_part(2)] - q[tm_part(2)];
  return dx * dx + dy * dy + dz * dz;
}

/* The same over the smoothing lengths of both, where particles have their own: to be compared with support_radius2. */
TM_FN tm_real tm_near_of_size(int i, int j, tm_real r2, const tm_near_args *a)
{
  if (!a->size) return r2;
  return r2 * a->size[(ptrdiff_t) i * TM_REC_SIZE + TM_SIZE_INV_H] *
         a->size[(ptrdiff_t) j * TM_REC_SIZE + TM_SIZE_INV_H];
}

/* Mechanical neighbors within the support radius. */
TM_FN tm_real tm_near_count(int i, const tm_near_args *a)
{
  int count = 0, j;
  for (int k = 0; k < a->rows.mechanical[i]; k++) {
    const tm_real r2 = tm_near_dist2(i, k, a, &j);
    count += tm_near_of_size(i, j, r2, a) < a->support_radius2;
  }
  if (a->count) a->count[i] = count;
  return count;
}

typedef struct {
  tm_real distance; /* of the closest mechanical neighbors */
  int i, j;
  tm_real sum;   /* of the distances to the nearest neighbor */
  tm_real count; /* of particles that have one */
  tm_real
      density;  /* of pairs, (1 - r^2/R^2)^2, R the support radius: a strain in any direction changes it by as much */
  tm_real flat; /* of particles whose neighbors all lie in one line or, in 3D, plane with them */
} tm_nearest;

TM_FN tm_nearest tm_nearest_nothing(void)
{
  tm_nearest c;
  c.distance = 1e300;
  c.i = c.j = -1;
  c.sum = c.count = c.density = c.flat = 0.0;
  return c;
}

/* Whether the second moment M of what is near shows no extent in some direction of dim. */
TM_FN int tm_near_is_flat(tm_sym3 M, int dim)
{
  const tm_real size = tm_sym_trace(M);
  const tm_real det = dim == 3 ? tm_sym_det(M) : M.xx * M.yy - M.xy * M.xy;
  return det <= 1e-9 * (dim == 3 ? size * size * size : size * size);
}

TM_FN tm_nearest tm_nearest_neighbor(int i, const tm_near_args *a)
{
  tm_nearest c = tm_nearest_nothing();
  const tm_vec3 at = tm_vec_from_record(a->main + tm_record(i, TM_REC), TM_REC_X, a->dim == 3);
  tm_sym3 M = tm_sym(0, 0, 0, 0, 0, 0);
  for (int k = 0; k < a->rows.mechanical[i]; k++) {
    int j;
    const tm_real r2 = tm_near_dist2(i, k, a, &j), r = sqrt(r2);
    const tm_real inside = 1.0 - tm_near_of_size(i, j, r2, a) / a->support_radius2;
    if (inside > 0.0) {
      const tm_vec3 d = tm_vec_sub(tm_vec_from_record(a->main + tm_record(j, TM_REC), TM_REC_X, a->dim == 3), at);
      c.density += inside * inside;
      M = tm_sym_axpy(M, 1.0 / a->support_radius2, tm_mat_symmetric(tm_mat_outer(d, d)));
    }
    if (r >= c.distance) continue;
    c.distance = r;
    c.i = i;
    c.j = j;
  }
  if (c.i >= 0) {
    c.sum = c.distance;
    c.count = 1.0;
    c.flat = tm_near_is_flat(M, a->dim);
  }
  return c;
}

TM_FN void tm_nearest_sum(tm_nearest *sum, const tm_nearest *c)
{
  if (c->distance < sum->distance || (c->distance == sum->distance && c->i >= 0 && c->i < sum->i)) {
    sum->distance = c->distance;
    sum->i = c->i;
    sum->j = c->j;
  }
  sum->sum += c->sum;
  sum->count += c->count;
  sum->density += c->density;
  sum->flat += c->flat;
}

#endif
