/* SPH-TM: records of neighbors into columns, see tm_lanes.h.

   GCC 12 joins registers with a shuffle where an insertion from memory would leave the shuffle unit
   free: hence its built-ins. */
#ifndef TM_TRANSPOSE_H
#define TM_TRANSPOSE_H

#include "tm_lanes.h"

#if TM_SINGLE

#if TM_VECTOR
typedef float tm_f4 __attribute__((vector_size(16)));
typedef float tm_f4_mem __attribute__((vector_size(16), aligned(4), may_alias));

/* Four numbers each of records 0, 4, 8 ... behind r, side by side. */
TM_FN tm_lanes tm_join_quads(const float *const *r, int k)
{
  const tm_f4 a = *(const tm_f4_mem *) (r[0] + k);
#if TM_VECTOR == 16
  return a;
#elif TM_VECTOR == 32
  const tm_f4 b = *(const tm_f4_mem *) (r[4] + k);
#if defined(__clang__)
  return __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7);
#else
  return __builtin_ia32_vinsertf128_ps256(__builtin_ia32_ps256_ps(a), b, 1);
#endif
#else
  const tm_f4 b = *(const tm_f4_mem *) (r[4] + k), c = *(const tm_f4_mem *) (r[8] + k);
  const tm_f4 d = *(const tm_f4_mem *) (r[12] + k);
#if defined(__clang__)
  return __builtin_shufflevector(__builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7),
                                 __builtin_shufflevector(c, d, 0, 1, 2, 3, 4, 5, 6, 7), 0, 1, 2, 3, 4, 5, 6, 7, 8, 9,
                                 10, 11, 12, 13, 14, 15);
#else
  tm_lanes x = __builtin_ia32_ps512_ps(a);
  x = __builtin_ia32_insertf32x4_mask(x, b, 1, x, (unsigned short) -1);
  x = __builtin_ia32_insertf32x4_mask(x, c, 2, x, (unsigned short) -1);
  return __builtin_ia32_insertf32x4_mask(x, d, 3, x, (unsigned short) -1);
#endif
#endif
}

/* entries A B of a and C D of b, of each quad */
#if TM_VECTOR == 16
#define TM_QUADS(a, b, A, B, C, D) __builtin_shufflevector(a, b, A, B, (C) + 4, (D) + 4)
#elif TM_VECTOR == 32
#define TM_QUADS(a, b, A, B, C, D) \
  __builtin_shufflevector(a, b, A, B, (C) + 8, (D) + 8, (A) + 4, (B) + 4, (C) + 12, (D) + 12)
#else
#define TM_QUADS(a, b, A, B, C, D)                                                                                \
  __builtin_shufflevector(a, b, A, B, (C) + 16, (D) + 16, (A) + 4, (B) + 4, (C) + 20, (D) + 20, (A) + 8, (B) + 8, \
                          (C) + 24, (D) + 24, (A) + 12, (B) + 12, (C) + 28, (D) + 28)
#endif

/* Entry k of a, b, c and d side by side, of each quad: into w[k]. */
TM_FN void tm_transpose_quads(tm_lanes a, tm_lanes b, tm_lanes c, tm_lanes d, tm_lanes *w)
{
  const tm_lanes ab0 = TM_QUADS(a, b, 0, 1, 0, 1), ab1 = TM_QUADS(a, b, 2, 3, 2, 3);
  const tm_lanes cd0 = TM_QUADS(c, d, 0, 1, 0, 1), cd1 = TM_QUADS(c, d, 2, 3, 2, 3);
  w[0] = TM_QUADS(ab0, cd0, 0, 2, 0, 2);
  w[1] = TM_QUADS(ab0, cd0, 1, 3, 1, 3);
  w[2] = TM_QUADS(ab1, cd1, 0, 2, 0, 2);
  w[3] = TM_QUADS(ab1, cd1, 1, 3, 1, 3);
}
#endif

#if TM_VECTOR == 64
/* Eight numbers each of two records, side by side. */
TM_FN tm_lanes tm_join_eights(const float *p, const float *q)
{
  typedef float eight __attribute__((vector_size(32), aligned(4), may_alias));
  typedef float numbers __attribute__((vector_size(32)));
  const numbers a = *(const eight *) p, b = *(const eight *) q;
#if defined(__clang__)
  return __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
#else
  const tm_lanes x = __builtin_ia32_ps512_256ps(a);
  return __builtin_ia32_insertf32x8_mask(x, b, 1, x, (unsigned short) -1);
#endif
}

/* Eight columns: half of the loads that quads would take. */
TM_FN void tm_transpose_eight(const float *const *r, int k, float *out)
{
  tm_lanes w[2][4]; /* of records 8g on: column c of four, column c + 4 of these, and the same of the next four */
  for (int g = 0; g < 2; g++) {
    const float *const *s = r + 8 * g;
    const tm_lanes a = tm_join_eights(s[0] + k, s[4] + k), b = tm_join_eights(s[1] + k, s[5] + k);
    const tm_lanes c = tm_join_eights(s[2] + k, s[6] + k), d = tm_join_eights(s[3] + k, s[7] + k);
    tm_transpose_quads(a, b, c, d, w[g]);
  }
  for (int c = 0; c < 4; c++) {
    tm_lanes_store(out + c * TM_COLUMN,
                   __builtin_shufflevector(w[0][c], w[1][c], 0, 1, 2, 3, 8, 9, 10, 11, 16, 17, 18, 19, 24, 25, 26, 27));
    tm_lanes_store(out + (c + 4) * TM_COLUMN, __builtin_shufflevector(w[0][c], w[1][c], 4, 5, 6, 7, 12, 13, 14, 15, 20,
                                                                      21, 22, 23, 28, 29, 30, 31));
  }
}
#endif

/* out[c * TM_COLUMN + l] = rec[jj[l] * stride + c] for the lanes l and c < columns, which is a
   multiple of 4 and a literal. */
TM_FN void tm_transpose(const float *rec, ptrdiff_t stride, const int *jj, int columns, float *out)
{
#if TM_VECTOR
  const float *r[TM_LANES];
  for (int l = 0; l < TM_LANES; l++) r[l] = rec + jj[l] * stride;
  int k = 0;
#if TM_VECTOR == 64
  for (; k + 8 <= columns; k += 8) tm_transpose_eight(r, k, out + k * TM_COLUMN);
#endif
  for (; k < columns; k += 4) {
    float *o = out + k * TM_COLUMN;
    const tm_lanes a = tm_join_quads(r, k), b = tm_join_quads(r + 1, k);
    const tm_lanes c = tm_join_quads(r + 2, k), d = tm_join_quads(r + 3, k);
    tm_lanes column[4];
    tm_transpose_quads(a, b, c, d, column);
    for (int p = 0; p < 4; p++) tm_lanes_store(o + p * TM_COLUMN, column[p]);
  }
#else
  for (int k = 0; k < columns; k++) out[k * TM_COLUMN] = rec[jj[0] * stride + k];
#endif
}

#else /* double */

/* Two, four or eight reals from several places, side by side. */
#if TM_VECTOR >= 32
TM_FN tm_v4 tm_join_pairs(const tm_real *p, const tm_real *q)
{
  const tm_v2 a = *(const tm_v2_mem *) p, b = *(const tm_v2_mem *) q;
#if defined(__clang__)
  return __builtin_shufflevector(a, b, 0, 1, 2, 3);
#else
  return __builtin_ia32_vinsertf128_pd256(__builtin_ia32_pd256_pd(a), b, 1);
#endif
}
#endif
#if TM_VECTOR == 64
TM_FN tm_v8 tm_join_quads(const tm_real *p, const tm_real *q)
{
  const tm_v4 a = *(const tm_v4_mem *) p, b = *(const tm_v4_mem *) q;
#if defined(__clang__)
  return __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7);
#else
  const tm_v8 x = __builtin_ia32_pd512_256pd(a);
  return __builtin_ia32_insertf64x4_mask(x, b, 1, x, (unsigned char) -1);
#endif
}
TM_FN tm_v8 tm_join_four_pairs(const tm_real *p, const tm_real *q, const tm_real *r, const tm_real *s)
{
#if defined(__clang__)
  return __builtin_shufflevector(tm_join_pairs(p, q), tm_join_pairs(r, s), 0, 1, 2, 3, 4, 5, 6, 7);
#else
  const tm_v2 c = *(const tm_v2_mem *) r, d = *(const tm_v2_mem *) s;
  tm_v8 x = __builtin_ia32_pd512_256pd(tm_join_pairs(p, q));
  x = __builtin_ia32_insertf64x2_512_mask(x, c, 2, x, (unsigned char) -1);
  return __builtin_ia32_insertf64x2_512_mask(x, d, 3, x, (unsigned char) -1);
#endif
}
#endif

/* out[c * TM_COLUMN + l] = rec[jj[l] * stride + c] for the lanes l and c < columns, which is even
   and a literal. */
TM_FN void tm_transpose(const tm_real *rec, ptrdiff_t stride, const int *jj, int columns, tm_real *out)
{
  const tm_real *r0 = rec + jj[0] * stride;
#if TM_VECTOR
  const tm_real *r1 = rec + jj[1] * stride;
#endif
#if TM_VECTOR >= 32
  const tm_real *r2 = rec + jj[2] * stride, *r3 = rec + jj[3] * stride;
#endif
#if TM_VECTOR == 64
  const tm_real *r4 = rec + jj[4] * stride, *r5 = rec + jj[5] * stride;
  const tm_real *r6 = rec + jj[6] * stride, *r7 = rec + jj[7] * stride;
  int k = 0;
  for (; k + 4 <= columns; k += 4) {
    tm_real *o = out + k * TM_COLUMN;
    const tm_v8 a = tm_join_quads(r0 + k, r2 + k), b = tm_join_quads(r1 + k, r3 + k);
    const tm_v8 c = tm_join_quads(r4 + k, r6 + k), d = tm_join_quads(r5 + k, r7 + k);
    const tm_v8 ab0 = __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
    const tm_v8 ab1 = __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
    const tm_v8 cd0 = __builtin_shufflevector(c, d, 0, 8, 2, 10, 4, 12, 6, 14);
    const tm_v8 cd1 = __builtin_shufflevector(c, d, 1, 9, 3, 11, 5, 13, 7, 15);
    tm_lanes_store(o, __builtin_shufflevector(ab0, cd0, 0, 1, 4, 5, 8, 9, 12, 13));
    tm_lanes_store(o + TM_COLUMN, __builtin_shufflevector(ab1, cd1, 0, 1, 4, 5, 8, 9, 12, 13));
    tm_lanes_store(o + 2 * TM_COLUMN, __builtin_shufflevector(ab0, cd0, 2, 3, 6, 7, 10, 11, 14, 15));
    tm_lanes_store(o + 3 * TM_COLUMN, __builtin_shufflevector(ab1, cd1, 2, 3, 6, 7, 10, 11, 14, 15));
  }
  for (; k < columns; k += 2) {
    const tm_v8 a = tm_join_four_pairs(r0 + k, r2 + k, r4 + k, r6 + k);
    const tm_v8 b = tm_join_four_pairs(r1 + k, r3 + k, r5 + k, r7 + k);
    tm_lanes_store(out + k * TM_COLUMN, __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14));
    tm_lanes_store(out + (k + 1) * TM_COLUMN, __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15));
  }
#elif TM_VECTOR == 32
  for (int k = 0; k < columns; k += 2) {
    const tm_v4 a = tm_join_pairs(r0 + k, r2 + k), b = tm_join_pairs(r1 + k, r3 + k);
    tm_lanes_store(out + k * TM_COLUMN, __builtin_shufflevector(a, b, 0, 4, 2, 6));
    tm_lanes_store(out + (k + 1) * TM_COLUMN, __builtin_shufflevector(a, b, 1, 5, 3, 7));
  }
#elif TM_VECTOR == 16
  for (int k = 0; k < columns; k += 2) {
    const tm_v2 a = *(const tm_v2_mem *) (r0 + k), b = *(const tm_v2_mem *) (r1 + k);
    tm_lanes_store(out + k * TM_COLUMN, __builtin_shufflevector(a, b, 0, 2));
    tm_lanes_store(out + (k + 1) * TM_COLUMN, __builtin_shufflevector(a, b, 1, 3));
  }
#else
  for (int k = 0; k < columns; k++) out[k * TM_COLUMN] = r0[k];
#endif
}

#endif

/* The same for n records, n a multiple of TM_LANES. */
TM_FN void tm_transpose_rows(const tm_pair *rec, ptrdiff_t stride, const int *jj, int n, int columns, tm_pair *out)
{
  for (int l = 0; l < n; l += TM_LANES) tm_transpose(rec, stride, jj + tm_at(l), columns, out + tm_at(l));
}

/* ---- columns of the neighbors jj, `lanes` of them: a multiple of TM_LANES, on a GPU one */

/* n columns of their records, which have `columns`, from the one numbered `from` on. from and n are literals, multiples
   of what tm_transpose() takes. */
TM_FN void tm_fetch_records(const tm_pair *rec, int columns, int from, int n, const int *jj, int lanes, tm_pair *out)
{
  if (TM_COLUMN > 1) tm_transpose_rows(rec + from, columns, jj, lanes, n, out);
  else tm_fetch(rec + tm_pair_record(jj[0], columns) + tm_pair_part(from), n, out);
}

/* All columns of plain rows, which lie one behind the other on a GPU too. */
TM_FN void tm_fetch_rows(const tm_pair *rows, int columns, const int *jj, int lanes, tm_pair *out)
{
  if (TM_COLUMN == 1 || columns % TM_TOGETHER)
    for (int l = 0; l < lanes; l++)
      for (int c = 0; c < columns; c++) out[c * TM_COLUMN + tm_at(l)] = rows[jj[tm_at(l)] * (ptrdiff_t) columns + c];
  else tm_transpose_rows(rows, columns, jj, lanes, columns, out);
}

#endif
