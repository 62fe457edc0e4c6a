/* SPH-TM: rows of neighbors, and the loop over the mechanical neighbors of one particle.

     for (tm_chunk_begin(&c, ...); tm_chunk_gather(&c, ...); tm_chunk_carry(&c, ...)) {
       if (c.n == 0) continue;
       ... columns and sums of c.lanes neighbors ...
     }

   Neighbors within the support radius are compacted in row order and their records transposed into columns
   (tm_lanes.h), a chunk of them at a time. Neighbor number n of those within the support radius always goes to lane
   n mod TM_LANES, and rows are sorted by tag: so a sum does not depend on where a particle lies in memory, on the skin,
   on the size of a chunk or on the number of ranks. Lanes beyond the last neighbor of a row hold the particle itself,
   moved out of the support radius: the kernel makes their terms zero.

   On a GPU a chunk is one entry of the row, with n = 0 where it is outside the support radius: so the threads of a warp,
   whose particles are side by side, stay at the same entry and fetch records that are side by side. Where there are
   few particles several threads share a row (tm_chunk_share()); neighbor number n then goes to thread n mod their number. */
#ifndef TM_CHUNK_H
#define TM_CHUNK_H

#include "tm_group.h"
#include "tm_kernel.h"
#include "tm_record.h"
#include "tm_size.h"
#include "tm_transpose.h"

/* Neighbor rows: entry k of particle i is index[first[i] + k * stride]. Mechanical neighbors come first, then those
   that only exchange heat, then those of other bodies in contact. */
typedef struct {
  const int *index;
  const ptrdiff_t *first;
  const int *mechanical; /* number of mechanical neighbors */
  const int *thermal;    /* number of neighbors that only exchange heat */
  const int *contact;    /* number of neighbors of other bodies */
  ptrdiff_t stride;
  const int *with_thermal; /* the particles with neighbors that only exchange heat, or NULL: no list of them */
  int n_with_thermal;      /* how many */
} tm_rows;

/* Arguments of the passes over rows. */
typedef struct {
  tm_rows rows;
  tm_records rec;
  tm_records_single single;
  unsigned effects; /* run-time bits for the extended instantiation */

  tm_real h;                     /* smoothing length */
  tm_real support_radius2;       /* (support * h)^2 */
  tm_real norm;                  /* kernel constant, 1/h^dim included */
  tm_real slope_norm;            /* of its slope: norm/h over the lattice's gradient, see tm_lattice.h */
  tm_real support2, norm_of_one; /* of h = 1, for particles with an h of their own */
  tm_real visc_alpha, visc_beta;
  int art_n;                  /* exponent of the artificial stress */
  tm_real art_inv_w;          /* 1 / shape(dp/h) */
  tm_real xsph;               /* XSPH epsilon, 0..1 */
  tm_real force_unit;         /* mass times acceleration -> force of the unit style */
  const tm_real *conductance; /* interface conductance per type pair (0: bonded), or NULL */
  const int *which;           /* the particles, or NULL: all */
  const int *type;            /* LAMMPS types, owned and ghost; only with conductance */
  int ntypes;

  /* results, rows of owned particles; added to where said so */
  double *force; /* 3, added to what is there unless force_begins */
  int force_begins;
  tm_real *gradient;       /* 9, L row major, in rows of tm_layout.h */
  tm_real *heat;           /* conduction, power per volume, or NULL */
  tm_real *correction;     /* 6, K of tm_moment.h, with correction; read by the rate pass */
  tm_real *turn;           /* 3, the antisymmetric part of K, with TM_FX_FACES */
  tm_real *face_next;      /* TM_FACE_COLUMNS of this force point, with TM_FX_FACES */
  tm_real *moment;         /* TM_MOMENT_COLUMNS of this force point, where the rate pass makes them */
  tm_real *xsph_v;         /* 3, with XSPH */
  tm_real *uneven;         /* 3, sum V_j gradW with shifting; else NULL */
  tm_real *hourglass_rate; /* 3, with the hourglass control: tm_hourglass.h */
  tm_real *surface;        /* 3, with surface */
  int surface_of_pass; /* nonzero: neighbors have the density of the particle; with one pass surface is a sum it has */
  tm_real *artificial; /* heating by artificial terms, power, or NULL */
} tm_rates_args;

/* The records in the precision of pair arithmetic, and its units in those of the run (tm_single.h). */
typedef struct {
  const tm_pair *main, *stress, *heat, *correction, *size, *stab;
  tm_real length, volume;
  tm_pair position;
} tm_pair_records;
/* columns of the records that have stress and heat */
#define TM_STRESS_COLUMNS (TM_SINGLE ? (int) TM_MORE : (int) TM_REC_STRESS)
#define TM_HEAT_COLUMNS (TM_SINGLE ? (int) TM_MORE : (int) TM_REC_HEAT)

TM_FN tm_pair_records tm_pair_records_of(const tm_rates_args *a)
{
  tm_pair_records r;
#if TM_SINGLE
  r.main = a->single.main;
  r.stress = a->single.more;
  r.heat = r.stress ? r.stress + tm_pair_part(TM_MORE_HEAT) : NULL;
  r.correction = a->single.correction;
  r.size = a->single.size;
  r.stab = a->single.stab;
  r.length = a->single.length;
  r.volume = a->single.volume;
  r.position = (tm_pair) a->single.position;
#else
  r.main = a->rec.main;
  r.stress = a->rec.stress;
  r.heat = a->rec.heat;
  r.correction = a->rec.correction;
  r.size = a->rec.size;
  r.stab = a->rec.stab;
  r.length = r.volume = r.position = 1.0;
#endif
  return r;
}

/* Smoothing length of particle i. */
TM_FN tm_real tm_rates_h(int i, const tm_rates_args *a)
{
  return a->rec.size ? 1.0 / a->rec.size[(ptrdiff_t) i * TM_REC_SIZE + TM_SIZE_INV_H] : a->h;
}

/* Kernel of all pairs, where particles have no size of their own. */
TM_FN tm_pair_size tm_size_of_all(const tm_rates_args *a, tm_real length, tm_real volume)
{
  const tm_pair h = (tm_pair) (a->h / length);
  const tm_pair_size p = {h, 1 / h, (tm_pair) (a->norm * volume), (tm_pair) (a->slope_norm * (volume * length)),
                          (tm_pair) a->art_inv_w};
  return p;
}

/* neighbors of a chunk: the numbers of their particles, and room for what is written beyond them */
#define TM_CHUNK_ROOM (TM_COLUMN + TM_LANES)

typedef struct {
  /* the particle and the kernel of its pairs */
  int i, sizes; /* sizes: particles have sizes of their own */
  tm_coord x, y, z;
  tm_pair unit; /* of positions in single */
  tm_pair_size of_all, own;
  tm_pair support_radius2, far;
  const tm_pair *main, *size; /* records */
  /* its row */
  const int *row; /* on a GPU from entry k on */
  ptrdiff_t stride;
  int end;
  /* the chunk */
  int k, last;    /* next entry of the row; the row ends in this chunk */
  tm_group group; /* threads of a GPU that share the row */
  int dealt;      /* neighbors that they have taken so far */
  int n, lanes;   /* neighbors, and with the lanes that are filled up */
} tm_chunk;

/* own: the first three columns of the particle's record. */
TM_FN void tm_chunk_begin(tm_chunk *c, int i, const tm_rates_args *a, const tm_pair *own, int sizes, int *jj)
{
  const tm_pair_records r = tm_pair_records_of(a);
  c->i = i;
  c->sizes = sizes;
  c->x = tm_coord_load(own);
  c->y = tm_coord_load(own + 1);
  c->z = tm_coord_load(own + 2);
  c->unit = r.position;
  c->of_all = tm_size_of_all(a, r.length, r.volume);
  c->own = tm_own_size(sizes ? r.size + (ptrdiff_t) i * TM_REC_SIZE : NULL, c->of_all);
  c->support_radius2 = (tm_pair) (sizes ? a->support2 : a->support_radius2 / (r.length * r.length));
  c->far = 4 * c->own.h;
  c->main = r.main;
  c->size = sizes ? r.size : NULL;
  c->row = a->rows.index + a->rows.first[i];
  c->stride = a->rows.stride;
  c->end = a->rows.mechanical[i];
  c->k = c->last = c->n = c->lanes = 0;
  c->group = tm_group_alone();
  c->dealt = 0;
  jj[0] = i;
  if (TM_COLUMN == 1) jj[1] = c->end > 0 ? c->row[0] : i;
}

/* On a GPU: behind tm_chunk_begin(), where threads share a row, for one of them. It looks at the entries lane, lane + size,
   ... */
TM_FN void tm_chunk_share(tm_chunk *c, tm_group group, int *jj)
{
  c->k = group.lane;
  c->row += group.lane * c->stride;
  c->group = group;
  if (c->k > 0 && c->k < c->end) jj[1] = c->row[0];
}

/* Deals what the threads have found in a round: mine is a particle, inside says whether it is a neighbor. Returns whether
   this thread gets one, which is then in *mine. */
TM_FN int tm_chunk_deal(tm_chunk *c, int inside, int *mine)
{
#if defined(__CUDA_ARCH__)
  const tm_group g = c->group;
  const unsigned those = tm_group_mask(g);
  unsigned found = __ballot_sync(those, inside) >> (__ffs(those) - 1);
  const int want = (g.lane - c->dealt) & (g.size - 1);
  c->dealt += __popc(found);
  for (int k = 0; k < want; k++) found &= found - 1;
  *mine = __shfl_sync(those, *mine, found ? __ffs(found) - 1 : g.lane, g.size);
  return found != 0;
#else
  (void) c;
  (void) mine;
  return inside;
#endif
}

/* The neighbors of the next chunk behind those carried over; 0: there are none left.

   On a GPU only entry k is looked at, which jj[1] holds already, and the first columns of its record go into position,
   in single x_i minus the position; the next entry is fetched meanwhile. */
TM_FN int tm_chunk_gather(tm_chunk *c, int *jj, tm_pair *position, int dim3)
{
  const tm_pair *rec = c->main, *size = c->size, inv_h = c->own.inv_h, unit = c->unit, limit = c->support_radius2;
  const tm_coord x = c->x, y = c->y, z = c->z;
  const int *row = c->row, end = c->end;
  const ptrdiff_t stride = c->stride;
#if TM_COLUMN == 1
  const int shared = c->group.size > 1, step = c->group.size;
  if (c->k - c->group.lane >= end) return 0;
  jj[0] = jj[1];
  if (c->k + step < end) jj[1] = row[step * stride];
  tm_fetch(rec + tm_pair_record(jj[0], TM_REC), 4, position);
  tm_pair dx = tm_apart(x, tm_coord_load(position), unit), dy = tm_apart(y, tm_coord_load(position + 1), unit);
  tm_pair dz = dim3 ? tm_apart(z, tm_coord_load(position + 2), unit) : 0;
  const tm_pair r2 = dx * dx + dy * dy + dz * dz;
  c->n = (size ? r2 * (inv_h * size[(ptrdiff_t) jj[0] * TM_REC_SIZE + TM_SIZE_INV_H]) : r2) < limit;
  c->lanes = 1;
  if (shared) {
    const int looked_at = jj[0];
    c->n = tm_chunk_deal(c, c->n && c->k < end, jj);
    if (jj[0] != looked_at) {
      tm_fetch(rec + tm_pair_record(jj[0], TM_REC), 4, position);
      dx = tm_apart(x, tm_coord_load(position), unit);
      dy = tm_apart(y, tm_coord_load(position + 1), unit);
      dz = dim3 ? tm_apart(z, tm_coord_load(position + 2), unit) : 0;
    }
  }
  if (TM_SINGLE) {
    position[0] = dx;
    position[1] = dy;
    position[2] = dz;
  }
  return 1;
#else
  (void) position;
  if (c->last) return 0;
  int k = c->k, n = c->n;
#if TM_VECTOR >= 32
  int block[TM_LANES];
  tm_pair TM_ALIGNED col[4][TM_COLUMN];
  const tm_lanes zero = {0};
  for (; k < end && n < TM_CHUNK; k += TM_LANES) {
    const int *r = row + k, left = end - k;
    unsigned in_row = (1u << TM_LANES) - 1u;
    if (left < TM_LANES && end >= TM_LANES && stride == 1) { /* the last of the row, less those that have been */
      r = row + end - TM_LANES;
      in_row &= ~0u << (TM_LANES - left);
    } else if (left < TM_LANES || stride != 1) {
      for (int l = 0; l < TM_LANES; l++) block[l] = row[(l < left ? k + l : k) * stride];
      r = block;
      if (left < TM_LANES) in_row = (1u << left) - 1u;
    }
    tm_transpose(rec, TM_REC, r, dim3 || TM_SINGLE ? 4 : 2, col[0]);
    const tm_lanes dx = tm_lanes_apart(x, col[0], unit), dy = tm_lanes_apart(y, col[1], unit);
    const tm_lanes dz = dim3 ? tm_lanes_apart(z, col[2], unit) : zero;
    tm_lanes r2 = dx * dx + dy * dy + dz * dz;
    if (size) {
      tm_transpose(size, TM_REC_SIZE, r, TM_SINGLE ? 4 : 2, col[0]);
      r2 *= inv_h * tm_lanes_load(col[TM_SIZE_INV_H]);
    }
    const unsigned inside = tm_lanes_below(r2, limit, in_row);
    n += tm_compress(r, inside, jj + n);
  }
#else
  for (; k < end && n < TM_CHUNK; ++k) {
    const int j = row[k * stride];
    const tm_pair *r = rec + (ptrdiff_t) j * TM_REC;
    const tm_pair dx = tm_apart(x, tm_coord_load(r), unit), dy = tm_apart(y, tm_coord_load(r + 1), unit);
    const tm_pair dz = dim3 ? tm_apart(z, tm_coord_load(r + 2), unit) : 0;
    jj[tm_at(n)] = j;
    const tm_pair r2 = dx * dx + dy * dy + dz * dz;
    n += (size ? r2 * (inv_h * size[(ptrdiff_t) j * TM_REC_SIZE + TM_SIZE_INV_H]) : r2) < limit;
  }
#endif
  c->k = k;
  c->n = n;
  if (n == 0) return 0;
  c->last = k >= end;
  c->lanes = (c->last ? n + TM_LANES - 1 : n) / TM_LANES * TM_LANES;
  for (int l = 0; l < TM_LANES; l++) jj[tm_at(n + l)] = c->i;
  return 1;
#endif
}

/* The neighbors that do not fill a vector go into the next chunk. */
TM_FN void tm_chunk_carry(tm_chunk *c, int *jj)
{
  if (TM_COLUMN == 1) {
    c->k += c->group.size;
    c->row += c->group.size * c->stride;
  } else if (!c->last) {
    for (int l = c->lanes; l < c->n; l++) jj[tm_at(l - c->lanes)] = jj[tm_at(l)];
    c->n -= c->lanes;
  }
}

/* ---- columns of a chunk; see also tm_fetch_records(), tm_fetch_rows() */

/* The first n columns of the main records; positions in single: x_i minus them. A GPU has the first four already. */
TM_FN void tm_chunk_fetch_main(const tm_chunk *c, const int *jj, int n, int dim3, tm_values *col)
{
  if (TM_COLUMN == 1) {
    tm_fetch_records(c->main, TM_REC, TM_REC_V, n - TM_REC_V, jj, 1, col[TM_REC_V]);
    return;
  }
  tm_fetch_records(c->main, TM_REC, 0, n, jj, c->lanes, col[0]);
  for (int l = 0; TM_SINGLE && l < c->lanes; l += TM_LANES) {
    tm_lanes_store(col[0] + tm_at(l), tm_lanes_apart(c->x, col[0] + tm_at(l), c->unit));
    tm_lanes_store(col[1] + tm_at(l), tm_lanes_apart(c->y, col[1] + tm_at(l), c->unit));
    if (dim3) tm_lanes_store(col[2] + tm_at(l), tm_lanes_apart(c->z, col[2] + tm_at(l), c->unit));
  }
  if (c->n < c->lanes) { /* in the last vector */
    const int begin = c->lanes - TM_LANES, filled = c->n - begin;
    const tm_pair away = TM_SINGLE ? c->far : (tm_pair) c->x + c->far;
    tm_pair *x = col[TM_REC_X] + tm_at(begin);
    for (int l = 0; l < TM_LANES; l++) x[l] = l < filled ? x[l] : away;
  }
}

/* x_i - x_j of one pair and of TM_LANES pairs: coordinate x of the particle and its column */
TM_FN tm_pair tm_chunk_apart(tm_coord x, const tm_pair *column, int l)
{
  return TM_SINGLE ? column[tm_at(l)] : (tm_pair) x - column[tm_at(l)];
}
TM_FN tm_lanes tm_chunk_lanes_apart(tm_coord x, const tm_pair *column, int l)
{
  return TM_SINGLE ? tm_values_load(column, l) : (tm_pair) x - tm_values_load(column, l);
}

/* Kernel of the pair with neighbor l, whose record of size is in the columns size; sizes: c->sizes. norm_of_one is read only with sizes:
   where it lies in the arguments GCC leaves the loop scalar, and products are not fused across the branches of the
   kernel, which rounds differently. */
TM_FN tm_pair_size tm_chunk_pair_size(const tm_chunk *c, int sizes, tm_values *size, int l, const tm_pair *norm_of_one,
                                      int dim3)
{
  return sizes ? tm_pair_of_sizes(&c->own, size[TM_SIZE_INV_H][tm_at(l)], size[TM_SIZE_FACTOR][tm_at(l)],
                                  size[TM_SIZE_TENSILE][tm_at(l)], *norm_of_one, dim3)
               : c->of_all;
}

#endif
