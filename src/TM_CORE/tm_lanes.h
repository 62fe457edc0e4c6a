/* SPH-TM: several neighbors at once.

   A tm_lanes holds one value of TM_LANES neighbors: a vector register of the instruction set the
   file is compiled for, or one number (CUDA, other compilers), in the precision of pair arithmetic.
   + - * / work on it in C and C++, also with a number on one side (vector extension of GCC and clang).
   Comparisons and functions do not: what needs them is written for one neighbor and put into a column.

   A column holds one quantity of up to TM_COLUMN neighbors. Particles are stored as records (all
   quantities of one particle side by side), so records are transposed into columns. Transposing in
   registers costs a quarter of the time of hardware gathers, and a third of that of scalar copies. */
#ifndef TM_LANES_H
#define TM_LANES_H

#include "tm_group.h"
#include "tm_layout.h"

#include <string.h>

#if defined(__has_builtin) && defined(__SSE2__) && !defined(__CUDACC__)
#if __has_builtin(__builtin_shufflevector)
#define TM_VECTORS
#endif
#endif
/* bytes of a vector register; 0: none */
#if defined(TM_VECTORS) && defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
#define TM_VECTOR 64
#elif defined(TM_VECTORS) && defined(__AVX__)
#define TM_VECTOR 32
#elif defined(TM_VECTORS)
#define TM_VECTOR 16
#else
#define TM_VECTOR 0
#endif
#define TM_LANES (TM_VECTOR ? TM_VECTOR / (TM_SINGLE ? 4 : 8) : 1)

/* Neighbors looked at together; multiples of 8 keep columns aligned. On a GPU one. */
#define TM_COLUMN_MOST 112 /* of all kinds of files */
#if defined(__CUDACC__)
#define TM_CHUNK 1
#define TM_COLUMN 1
#else
#define TM_CHUNK 96
#define TM_COLUMN (TM_CHUNK + (TM_SINGLE ? 16 : 8))
#endif

/* Loops of scalar code that the compiler vectorizes have a multiple of this many turns: so no
   remainder, whose last bit might differ. */
#define TM_TURNS (TM_VECTOR ? 8 : 1)

#if TM_VECTOR
#define TM_ALIGNED __attribute__((aligned(64)))
typedef double tm_v2 __attribute__((vector_size(16)));
typedef double tm_v4 __attribute__((vector_size(32)));
typedef double tm_v8 __attribute__((vector_size(64)));
typedef double tm_v2_mem __attribute__((vector_size(16), aligned(8), may_alias));
typedef double tm_v4_mem __attribute__((vector_size(32), aligned(8), may_alias));
typedef tm_pair tm_lanes __attribute__((vector_size(TM_VECTOR)));
typedef tm_pair tm_lanes_mem __attribute__((vector_size(TM_VECTOR), may_alias));
typedef tm_pair tm_lanes_any __attribute__((vector_size(TM_VECTOR), aligned(4), may_alias));
#else
#define TM_ALIGNED
typedef tm_pair tm_lanes, tm_lanes_mem, tm_lanes_any;
#endif

/* A sum over the neighbors of a row. Where it is not spread over lanes it is kept in double, so that its error does not grow
   with the number of neighbors; but on a GPU, where a conversion takes as long as four sums. There the error of 50 terms
   is that of the terms themselves. */
#if TM_VECTOR
typedef tm_lanes tm_sum;
#elif defined(__CUDACC__)
typedef tm_pair tm_sum;
#else
typedef tm_real tm_sum;
#endif

/* A loop over the neighbors of a chunk, of scalar code that the compiler vectorizes. */
#if defined(__CUDACC__)
#define TM_SIMD
#else
#define TM_SIMD _Pragma("omp simd")
#endif

/* One quantity of the neighbors of a chunk. */
typedef tm_pair tm_values[TM_COLUMN];

/* Index into a column or a list of a chunk. Where it can only be 0 the compiler is told so, and
   keeps columns in registers. */
TM_FN int tm_at(int l) { return TM_COLUMN > 1 ? l : 0; }

/* n columns of a record from the one at p on, 16 bytes at a time where that is faster: the first and
   n are multiples of TM_TOGETHER. */
TM_FN void tm_fetch(const tm_pair *p, int n, tm_pair *out)
{
#if defined(__CUDA_ARCH__) && TM_SINGLE
#pragma unroll
  for (int c = 0; c < n; c += 4) {
    const float4 v = *(const float4 *) (p + tm_pair_part(c));
    out[c] = v.x;
    out[c + 1] = v.y;
    out[c + 2] = v.z;
    out[c + 3] = v.w;
  }
#elif defined(__CUDA_ARCH__)
#pragma unroll
  for (int c = 0; c < n; c += 2) {
    const double2 v = *(const double2 *) (p + tm_pair_part(c));
    out[c] = v.x;
    out[c + 1] = v.y;
  }
#else
  for (int c = 0; c < n; c++) out[c] = p[tm_pair_part(c)];
#endif
}

TM_FN tm_lanes tm_lanes_load(const tm_pair *p) { return *(const tm_lanes_mem *) p; }
/* TM_LANES neighbors of a column, from neighbor l on. */
TM_FN tm_lanes tm_values_load(const tm_pair *column, int l) { return tm_lanes_load(column + tm_at(l)); }
TM_FN tm_lanes tm_lanes_load_any(const tm_pair *p) { return *(const tm_lanes_any *) p; } /* not aligned */
TM_FN void tm_lanes_store(tm_pair *p, tm_lanes v) { *(tm_lanes_mem *) p = v; }
TM_FN tm_sum tm_lanes_zero(void)
{
  const tm_sum v = {0};
  return v;
}

#if TM_VECTOR && !TM_SINGLE
/* GCC 12 converts eight as two times four: hence its built-ins. */
typedef float tm_lanes_floats __attribute__((vector_size(4 * TM_LANES)));
typedef int tm_lanes_ints __attribute__((vector_size(4 * TM_LANES)));
TM_FN tm_lanes tm_lanes_of_floats(tm_lanes_floats v)
{
#if TM_VECTOR == 64 && !defined(__clang__)
  const tm_lanes none = {0};
  return __builtin_ia32_cvtps2pd512_mask(v, none, (unsigned char) -1, 4);
#else
  return __builtin_convertvector(v, tm_lanes);
#endif
}
TM_FN tm_lanes tm_lanes_of_ints(tm_lanes_ints v)
{
#if TM_VECTOR == 64 && !defined(__clang__)
  const tm_lanes none = {0};
  return __builtin_ia32_cvtdq2pd512_mask(v, none, (unsigned char) -1);
#else
  return __builtin_convertvector(v, tm_lanes);
#endif
}
#endif

/* 1/x, as tm_pair_inverse() has it */
TM_FN tm_lanes tm_lanes_inverse(tm_lanes x)
{
#if TM_VECTOR
  return 1 / x;
#else
  return tm_pair_inverse(x);
#endif
}

/* Where it is below 0, else 0. */
TM_FN tm_lanes tm_lanes_negative(tm_lanes v)
{
#if TM_VECTOR
#if TM_SINGLE
  typedef int tm_bits __attribute__((vector_size(TM_VECTOR)));
#else
  typedef long long tm_bits __attribute__((vector_size(TM_VECTOR)));
#endif
  const tm_lanes none = {0};
  return (tm_lanes) ((tm_bits) v & (tm_bits) (v < none));
#else
  return v < 0 ? v : 0;
#endif
}

/* ---- positions: in single they are whole numbers of a unit that wrap around (tm_single.h), so that
   differences are exact wherever the body is */

#if TM_SINGLE
typedef int tm_coord;
TM_FN tm_coord tm_coord_load(const tm_pair *p)
{
#if defined(__CUDA_ARCH__)
  return __float_as_int(*p);
#else
  tm_coord x;
  memcpy(&x, p, sizeof(x));
  return x;
#endif
}
TM_FN tm_pair tm_apart(tm_coord a, tm_coord b, tm_pair unit)
{
  return unit * (tm_pair) (int) ((unsigned) a - (unsigned) b);
}
#else
typedef tm_real tm_coord;
TM_FN tm_coord tm_coord_load(const tm_pair *p) { return *p; }
TM_FN tm_pair tm_apart(tm_coord a, tm_coord b, tm_pair unit)
{
  (void) unit;
  return a - b;
}
#endif

#if TM_VECTOR && TM_SINGLE
/* a minus a column */
TM_FN tm_lanes tm_lanes_apart(tm_coord a, const tm_pair *column, tm_pair unit)
{
  typedef int whole __attribute__((vector_size(TM_VECTOR)));
  typedef unsigned around __attribute__((vector_size(TM_VECTOR), may_alias));
  return unit * __builtin_convertvector((whole) ((unsigned) a - *(const around *) column), tm_lanes);
}
#else
TM_FN tm_lanes tm_lanes_apart(tm_coord a, const tm_pair *column, tm_pair unit)
{
#if TM_SINGLE
  return tm_apart(a, tm_coord_load(column), unit);
#else
  (void) unit;
  return a - tm_lanes_load(column);
#endif
}
#endif

/* ---- sums and choices over lanes */

/* in double, from a register of doubles */
#if TM_VECTOR
TM_FN tm_real tm_sum_of_2(tm_v2 v) { return v[0] + v[1]; }
#endif
#if TM_VECTOR >= 32
TM_FN tm_real tm_sum_of_4(tm_v4 v)
{
  return tm_sum_of_2(__builtin_shufflevector(v, v, 0, 1) + __builtin_shufflevector(v, v, 2, 3));
}
#endif
#if TM_VECTOR == 64
TM_FN tm_real tm_sum_of_8(tm_v8 v)
{
  return tm_sum_of_4(__builtin_shufflevector(v, v, 0, 1, 2, 3) + __builtin_shufflevector(v, v, 4, 5, 6, 7));
}
#endif

#define TM_PART(type, ...) __builtin_convertvector(__builtin_shufflevector(v, v, __VA_ARGS__), type)
#if TM_VECTOR == 64
/* In double; of floats the two halves added. */
TM_FN tm_v8 tm_lanes_folded(tm_sum v)
{
#if TM_SINGLE
  return TM_PART(tm_v8, 0, 1, 2, 3, 4, 5, 6, 7) + TM_PART(tm_v8, 8, 9, 10, 11, 12, 13, 14, 15);
#else
  return v;
#endif
}
#endif
TM_FN tm_real tm_lanes_sum(tm_sum v)
{
#if !TM_VECTOR
  return v;
#elif TM_VECTOR == 64
  return tm_sum_of_8(tm_lanes_folded(v));
#elif TM_SINGLE && TM_VECTOR == 32
  return tm_sum_of_4(TM_PART(tm_v4, 0, 1, 2, 3) + TM_PART(tm_v4, 4, 5, 6, 7));
#elif TM_SINGLE
  return tm_sum_of_2(TM_PART(tm_v2, 0, 1) + TM_PART(tm_v2, 2, 3));
#elif TM_VECTOR == 32
  return tm_sum_of_4(v);
#else
  return tm_sum_of_2(v);
#endif
}
#undef TM_PART

/* The sum over the threads of a GPU that share a row, for each of them. */
TM_FN tm_sum tm_group_sum(tm_sum v, tm_group g)
{
#if TM_VECTOR
  (void) g;
#else
  for (int far = g.size / 2; far > 0; far /= 2) v += TM_GROUP_SHUFFLE(v, far, g);
#endif
  return v;
}

/* out[k] = tm_lanes_sum(v[k]), k < n, to the bit; n is a literal. */
TM_FN void tm_lanes_sums(const tm_sum *v, int n, tm_real *out)
{
  int k = 0;
#if TM_VECTOR == 64
  for (; k + 8 <= n; k += 8, v += 8) {
    tm_v8 s[4], t[2];
    for (int p = 0; p < 4; p++) {
      const tm_v8 a = tm_lanes_folded(v[2 * p]), b = tm_lanes_folded(v[2 * p + 1]);
      s[p] = __builtin_shufflevector(a, b, 0, 1, 2, 3, 8, 9, 10, 11) +
             __builtin_shufflevector(a, b, 4, 5, 6, 7, 12, 13, 14, 15);
    }
    for (int p = 0; p < 2; p++)
      t[p] = __builtin_shufflevector(s[2 * p], s[2 * p + 1], 0, 1, 4, 5, 8, 9, 12, 13) +
             __builtin_shufflevector(s[2 * p], s[2 * p + 1], 2, 3, 6, 7, 10, 11, 14, 15);
    const tm_v8 u = __builtin_shufflevector(t[0], t[1], 0, 2, 4, 6, 8, 10, 12, 14) +
                    __builtin_shufflevector(t[0], t[1], 1, 3, 5, 7, 9, 11, 13, 15);
    for (int l = 0; l < 8; l++) out[k + l] = u[l];
  }
#endif
  for (; k < n; k++) out[k] = tm_lanes_sum(*v++);
}

#if TM_VECTOR >= 32
/* Bit k is set where a[k] < b and where it is set in mask. */
TM_FN unsigned tm_lanes_below(tm_lanes a, tm_pair b, unsigned mask)
{
  const tm_lanes zero = {0}, limit = b + zero;
#if TM_SINGLE && TM_VECTOR == 64
  return (unsigned) __builtin_ia32_cmpps512_mask(a, limit, 1, (unsigned short) mask, 4);
#elif TM_SINGLE
  return (unsigned) __builtin_ia32_movmskps256(__builtin_ia32_cmpps256(a, limit, 1)) & mask;
#elif TM_VECTOR == 64
  return (unsigned) __builtin_ia32_cmppd512_mask(a, limit, 1, (unsigned char) mask, 4);
#else
  return (unsigned) __builtin_ia32_movmskpd256(__builtin_ia32_cmppd256(a, limit, 1)) & mask;
#endif
}

/* Copies p[k], k < TM_LANES, where bit k of mask is set; returns how many. Writes beyond them. */
TM_FN int tm_compress(const int *p, unsigned mask, int *out)
{
#if TM_VECTOR == 64
  typedef int ints __attribute__((vector_size(4 * TM_LANES)));
  typedef int ints_mem __attribute__((vector_size(4 * TM_LANES), aligned(4), may_alias));
  const ints v = *(const ints_mem *) p;
#if TM_SINGLE
  *(ints_mem *) out = (ints) __builtin_ia32_compresssi512_mask(v, v, (unsigned short) mask);
#else
  *(ints_mem *) out = (ints) __builtin_ia32_compresssi256_mask(v, v, (unsigned char) mask);
#endif
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

#endif
