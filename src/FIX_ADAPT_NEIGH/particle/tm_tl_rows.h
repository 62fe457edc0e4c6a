/* SPH-TM: storage of total-Lagrangian (stored-gradient) pairs: rows, 16-bit weights, history variables.

   A pair stores the kernel gradient of the step in which it was frozen (tm_freeze.h), pulled back to each of its ends,
   and what viscosity and conduction take; tm_tl_rates.h has the equations.

   A step reads all weights of all rows from memory, which takes as long as computing with them: they are 16 bits wide.
   Gradients, slope(q) x/r in place of grad W, are integer multiples of a unit that is 6e-5 of the steepest slope; the
   weights of the viscosity are the upper half of a float. Both ends of a pair hold the same numbers, and the products
   are in double: momentum and energy are conserved as with exact weights. */
#ifndef TM_TL_ROWS_H
#define TM_TL_ROWS_H

#include "tm_rates.h"

#if TM_SINGLE
#error "double only: both ends of a total-Lagrangian pair hold the same products in double"
#endif

enum {
  TM_W_OWN = 0,       /* a_i, the gradient pulled back to particle i */
  TM_W_BULK = 3,      /* alpha c/rho slope(q)/q / (q^2 + 0.01), c and rho means of the pair */
  TM_W_SHOCK,         /* beta/rho slope(q)/q / (q^2 + 0.01)^2 */
  TM_W_OTHER,         /* a_j, the gradient pulled back to particle j */
  TM_W_SLOPE = 8,     /* slope(q)/q of conduction, a float: upper and lower half */
  TM_W_DISTANCE = 10, /* q = r/h when the pair was frozen, over TM_DISTANCE_UNIT */
  TM_WEIGHTS
};
#define TM_DISTANCE_UNIT (1.0 / 8192.0)
/* Largest stored gradient over the steepest slope of the kernel. A particle with a larger one is not frozen. */
#define TM_TL_SLOPE_RANGE 2.0

/* Entry k of row i is index[first[i] + k stride]. The tl[i] total-Lagrangian pairs come first, padded with weights of
   0; then the ul[i] pairs of a total-Lagrangian particle whose other end is updated-Lagrangian. Weight c: tm_weight().
   tl, and the history of particles, have room for one more: the next particle's is prefetched. */
typedef struct {
  int *index, *tl, *ul;
  const ptrdiff_t *first;
  ptrdiff_t *ul_first; /* where the ul[i] updated-Lagrangian pairs of row i begin */
  ptrdiff_t stride;
  int capacity;
  tm_real unit; /* of gradients */
  short *weight;
} tm_tl_rows;

/* The unit of gradients of a kernel. */
TM_HOST_FN tm_real tm_tl_unit(int kernel)
{
  tm_real most = 0.0;
  for (int k = 0; k <= 3000; k++) most = tm_max(most, fabs(tm_kernel_slope(kernel, 1e-3 * k)));
  return TM_TL_SLOPE_RANGE * most / 32767.0;
}

/* The nearest integer, halves away from 0. */
TM_FN short tm_weight_whole(tm_real v) { return (short) tm_clamp(v < 0.0 ? v - 0.5 : v + 0.5, -32767.0, 32767.0); }

/* The halves of a float. */
TM_FN unsigned tm_weight_bits(float v)
{
  unsigned bits;
  memcpy(&bits, &v, sizeof bits);
  return bits;
}
TM_FN float tm_weight_float(unsigned bits)
{
  float v;
  memcpy(&v, &bits, sizeof v);
  return v;
}
TM_FN short tm_weight_upper(tm_real v) { return (short) ((tm_weight_bits((float) v) + 0x8000u) >> 16); }

/* The weights of row i, and where weight c of entry k lies there: eight entries together, apart those weights that
   all rows need, those of rows with TM_TL_TWO_SIDED, and the others. */
TM_FN short *tm_weight(const tm_tl_rows *r, int i)
{
  const ptrdiff_t lane = i % r->stride;
  return r->weight + (r->first[i] - lane) * TM_WEIGHTS + lane;
}
TM_FN ptrdiff_t tm_weight_place(const tm_tl_rows *r, int c, int k)
{
  const int begin = c < TM_W_OTHER ? 0 : c < TM_W_SLOPE ? TM_W_OTHER : TM_W_SLOPE;
  const int width = c < TM_W_OTHER ? TM_W_OTHER : c < TM_W_SLOPE ? TM_W_SLOPE - TM_W_OTHER : TM_WEIGHTS - TM_W_SLOPE;
  return ((ptrdiff_t) begin * r->capacity + (k / 8 * width + c - begin) * 8 + k % 8) * r->stride;
}

/* Entries that n pairs take in a row: whole vectors. */
TM_FN int tm_tl_padded(int n) { return (n + 7) / 8 * 8; }

/* History variables of a particle, TM_TL_HISTORY columns. */
enum {
  TM_TL_B = 0, /* B at the next force point */
  TM_TL_Q = 9,
  TM_TL_G = 18,         /* G at the next force point */
  TM_TL_PSTRAIN = 27,   /* plastic strain when it was updated-Lagrangian last */
  TM_TL_IS_UL = 28,     /* 1: updated-Lagrangian in the coming step */
  TM_TL_WAS_UL = 29,    /* 1: was so in the last step, AdaptNode of F14 */
  TM_TL_UL_STEPS = 30,  /* number of steps in which it was so */
  TM_TL_PROXIMITY = 31, /* above 0: a particle came near, slid or was deleted; proximity checks that it remains so */
  TM_TL_TWO_SIDED = 32, /* 1: a_i and a_j differ in a pair of the row */
  TM_TL_SUM = 33,       /* sum over the row of m_j a_i, in units of its weights */
  TM_TL_HISTORY = 36
};
enum { TM_PROXIMITY_HOLD = 10 }; /* proximity checks after which TM_TL_PROXIMITY ends */

/* Is the particle with history k updated-Lagrangian in this step? New particles are. */
TM_FN int tm_is_ul(const tm_real *k) { return k[TM_TL_IS_UL] > 0.5 || k[TM_TL_UL_STEPS] < 0.5; }

/* Weights of TM_LANES entries of a row: integers, and upper halves of floats. */
#if TM_VECTOR
typedef short tm_shorts __attribute__((vector_size(2 * TM_LANES)));
typedef short tm_shorts_mem __attribute__((vector_size(2 * TM_LANES), aligned(2), may_alias));
TM_FN tm_lanes_ints tm_weight_int_lanes(const short *w, ptrdiff_t stride)
{
  short TM_ALIGNED t[TM_LANES];
  for (int l = 0; stride != 1 && l < TM_LANES; l++) t[l] = w[l * stride];
  const tm_shorts v = *(const tm_shorts_mem *) (stride != 1 ? t : w);
#if TM_VECTOR == 64 && !defined(__clang__)
  return __builtin_ia32_pmovsxwd256(v);
#else
  return __builtin_convertvector(v, tm_lanes_ints);
#endif
}
TM_FN tm_lanes tm_weight_lanes(const short *w, ptrdiff_t stride)
{
  return tm_lanes_of_ints(tm_weight_int_lanes(w, stride));
}
TM_FN tm_lanes tm_weight_upper_lanes(const short *w, ptrdiff_t stride)
{
  return tm_lanes_of_floats((tm_lanes_floats) (tm_weight_int_lanes(w, stride) << 16));
}
#else
TM_FN tm_lanes tm_weight_lanes(const short *w, ptrdiff_t stride)
{
  (void) stride;
  return *w;
}
TM_FN tm_lanes tm_weight_upper_lanes(const short *w, ptrdiff_t stride)
{
  (void) stride;
  return tm_weight_float((unsigned) (unsigned short) *w << 16);
}
#endif

/* W'/r of entry k for conduction, in units of slope_norm/h. */
TM_FN tm_real tm_weight_slope(const tm_tl_rows *r, const short *w, int k)
{
  const unsigned upper = (unsigned short) w[tm_weight_place(r, TM_W_SLOPE, k)];
  return tm_weight_float(upper << 16 | (unsigned short) w[tm_weight_place(r, TM_W_SLOPE + 1, k)]);
}

#endif
