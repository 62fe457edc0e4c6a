/* SPH-TM: several neighbours at once.

   A tm_lanes holds one value of TM_LANES neighbours: a vector register of the instruction set the
   file is compiled for, or one real (CUDA, other compilers). + - * / work on it in C and C++, also
   with a real on one side (vector extension of GCC and clang). Comparisons and functions do not:
   what needs them is written for one neighbour and put into a column.

   A column holds one quantity of up to TM_COLUMN neighbours. Particles are stored as records (all
   quantities of one particle side by side), so records are transposed into columns. Transposing in
   registers costs a quarter of the time of hardware gathers, and a third of that of scalar copies. */
#ifndef TM_LANES_H
#define TM_LANES_H

#include "tm_real.h"

#if defined(__has_builtin) && defined(__SSE2__) && !defined(__CUDACC__)
#if __has_builtin(__builtin_shufflevector)
#define TM_VECTORS
#endif
#endif
#if defined(TM_VECTORS) && defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
#define TM_LANES 8
#elif defined(TM_VECTORS) && defined(__AVX__)
#define TM_LANES 4
#elif defined(TM_VECTORS)
#define TM_LANES 2
#else
#define TM_LANES 1
#endif

/* Neighbours looked at together; multiples of 8 keep columns aligned. On a GPU one. */
#if defined(__CUDACC__)
#define TM_CHUNK 1
#define TM_COLUMN 1
#else
#define TM_CHUNK 96
#define TM_COLUMN (TM_CHUNK + 8)
#endif

/* Loops of scalar code that the compiler vectorises have a multiple of this many turns: so no
   remainder, whose last bit might differ. */
#define TM_TURNS (TM_LANES > 1 ? 8 : 1)

#if TM_LANES > 1
typedef double tm_v2 __attribute__((vector_size(16)));
typedef double tm_v4 __attribute__((vector_size(32)));
typedef double tm_v8 __attribute__((vector_size(64)));
typedef double tm_v2_mem __attribute__((vector_size(16), aligned(8), may_alias));
typedef double tm_v4_mem __attribute__((vector_size(32), aligned(8), may_alias));
typedef double tm_lanes __attribute__((vector_size(8 * TM_LANES)));
typedef double tm_lanes_mem __attribute__((vector_size(8 * TM_LANES), may_alias));
#define TM_ALIGNED __attribute__((aligned(64)))
#else
typedef tm_real tm_lanes, tm_lanes_mem;
#define TM_ALIGNED
#endif

/* Index into a column or a list of a chunk. Where it can only be 0 the compiler is told so, and
   keeps columns in registers. */
TM_FN int tm_at(int l) { return TM_COLUMN > 1 ? l : 0; }

/* n (even) reals at p, 16 bytes aligned, two at a time where that is faster. */
TM_FN void tm_fetch(const tm_real *p, int n, tm_real *out)
{
#if defined(__CUDA_ARCH__)
#pragma unroll
  for (int c = 0; c < n; c += 2) {
    const double2 v = *(const double2 *) (p + c);
    out[c] = v.x;
    out[c + 1] = v.y;
  }
#else
  for (int c = 0; c < n; c++) out[c] = p[c];
#endif
}

TM_FN tm_lanes tm_lanes_load(const tm_real *p) { return *(const tm_lanes_mem *) p; }
TM_FN void tm_lanes_store(tm_real *p, tm_lanes v) { *(tm_lanes_mem *) p = v; }
TM_FN tm_lanes tm_lanes_zero(void)
{
  const tm_lanes v = {0};
  return v;
}
TM_FN tm_real tm_lanes_sum(tm_lanes v)
{
#if TM_LANES == 8
  const tm_v4 h = __builtin_shufflevector(v, v, 0, 1, 2, 3) + __builtin_shufflevector(v, v, 4, 5, 6, 7);
#elif TM_LANES == 4
  const tm_v4 h = v;
#endif
#if TM_LANES >= 4
  const tm_v2 q = __builtin_shufflevector(h, h, 0, 1) + __builtin_shufflevector(h, h, 2, 3);
  return q[0] + q[1];
#elif TM_LANES == 2
  return v[0] + v[1];
#else
  return v;
#endif
}

/* Two, four or eight reals from several places, side by side. GCC 12 joins registers with a
   shuffle where an insertion from memory would leave the shuffle unit free: hence its built-ins. */
#if TM_LANES >= 4
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
#if TM_LANES == 8
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

#if TM_LANES >= 4
/* Bit k is set where a[k] < b and where it is set in mask. */
TM_FN unsigned tm_lanes_below(tm_lanes a, tm_real b, unsigned mask)
{
  const tm_lanes limit = b + tm_lanes_zero();
#if TM_LANES == 8
  return (unsigned) __builtin_ia32_cmppd512_mask(a, limit, 1, (unsigned char) mask, 4);
#else
  return (unsigned) __builtin_ia32_movmskpd256(__builtin_ia32_cmppd256(a, limit, 1)) & mask;
#endif
}

/* Copies p[k], k < TM_LANES, where bit k of mask is set; returns how many. Writes beyond them. */
TM_FN int tm_compress(const int *p, unsigned mask, int *out)
{
#if TM_LANES == 8
  typedef int eight __attribute__((vector_size(32)));
  typedef int eight_mem __attribute__((vector_size(32), aligned(4), may_alias));
  const eight v = *(const eight_mem *) p;
  *(eight_mem *) out = (eight) __builtin_ia32_compresssi256_mask(v, v, (unsigned char) mask);
  return __builtin_popcount(mask);
#else
  int n = 0;
  for (int k = 0; k < TM_LANES; k++) {
    out[n] = p[k];
    n += (int) (mask >> k & 1u);
  }
  return n;
#endif
}
#endif

/* out[c * TM_COLUMN + l] = rec[jj[l] * stride + c] for the lanes l and c < columns, which is even
   and a literal. */
TM_FN void tm_transpose(const tm_real *rec, ptrdiff_t stride, const int *jj, int columns,
                        tm_real *out)
{
  const tm_real *r0 = rec + jj[0] * stride;
#if TM_LANES > 1
  const tm_real *r1 = rec + jj[1] * stride;
#endif
#if TM_LANES > 2
  const tm_real *r2 = rec + jj[2] * stride, *r3 = rec + jj[3] * stride;
#endif
#if TM_LANES == 8
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
    tm_lanes_store(out + (k + 1) * TM_COLUMN,
                   __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15));
  }
#elif TM_LANES == 4
  for (int k = 0; k < columns; k += 2) {
    const tm_v4 a = tm_join_pairs(r0 + k, r2 + k), b = tm_join_pairs(r1 + k, r3 + k);
    tm_lanes_store(out + k * TM_COLUMN, __builtin_shufflevector(a, b, 0, 4, 2, 6));
    tm_lanes_store(out + (k + 1) * TM_COLUMN, __builtin_shufflevector(a, b, 1, 5, 3, 7));
  }
#elif TM_LANES == 2
  for (int k = 0; k < columns; k += 2) {
    const tm_v2 a = *(const tm_v2_mem *) (r0 + k), b = *(const tm_v2_mem *) (r1 + k);
    tm_lanes_store(out + k * TM_COLUMN, __builtin_shufflevector(a, b, 0, 2));
    tm_lanes_store(out + (k + 1) * TM_COLUMN, __builtin_shufflevector(a, b, 1, 3));
  }
#else
  for (int k = 0; k < columns; k++) out[k * TM_COLUMN] = r0[k];
#endif
}

/* The same for n records, n a multiple of TM_LANES. */
TM_FN void tm_transpose_rows(const tm_real *rec, ptrdiff_t stride, const int *jj, int n,
                             int columns, tm_real *out)
{
  for (int l = 0; l < n; l += TM_LANES)
    tm_transpose(rec, stride, jj + tm_at(l), columns, out + tm_at(l));
}

#endif
