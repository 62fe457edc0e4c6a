/* SPH-TM: scalar type and the one qualifier of every physics function.

   Everything in tm_*.h is the common subset of C11, C++17, C++20 and CUDA: no designated
   initializers, no variable-length arrays, no compound literals, no globals. */
#ifndef TM_REAL_H
#define TM_REAL_H

#include <math.h>
#include <stddef.h>

/* TM_FN: forced inline on the host, host + device and forced inline under CUDA. */
#if defined(__CUDACC__)
#define TM_FN static __host__ __device__ __forceinline__
#elif defined(__GNUC__)
#define TM_FN static inline __attribute__((always_inline))
#else
#define TM_FN static inline
#endif
/* one that few scenes run: called, so that it is in no loop's machine code. It writes nothing. */
#if defined(__CUDACC__)
#define TM_CALLED_FN static __host__ __device__ __noinline__
#elif defined(__GNUC__)
#define TM_CALLED_FN static __attribute__((noinline, unused, pure))
#else
#define TM_CALLED_FN static inline
#endif
/* one that a GPU does not run */
#if defined(__CUDACC__)
#define TM_HOST_FN static inline
#else
#define TM_HOST_FN TM_FN
#endif

/* A pointer that no other pointer of the same loop aliases. */
#if defined(__cplusplus) || defined(__CUDACC__)
#define TM_RESTRICT __restrict__
#else
#define TM_RESTRICT restrict
#endif

/* Precision of particle state and of the sums over neighbors. */
typedef double tm_real;

/* Precision of pair arithmetic: that of the state, or single in a file that defines TM_PAIR_SINGLE
   before its first header. Constants of pair functions are integers or TM_PAIR(x), so that nothing
   is computed in double on the way. A header that is double only refuses to compile in single. */
#if defined(TM_PAIR_SINGLE)
typedef float tm_pair;
#define TM_SINGLE 1
#else
typedef double tm_pair;
#define TM_SINGLE 0
#endif
#define TM_PAIR(x) ((tm_pair) (x))

#define TM_PI 3.14159265358979323846

/* fmin/fmax honour NaN and signed zero and so do not vectorise; these do. */
TM_FN tm_real tm_min(tm_real a, tm_real b) { return a < b ? a : b; }
TM_FN tm_real tm_max(tm_real a, tm_real b) { return a > b ? a : b; }
TM_FN tm_pair tm_pair_min(tm_pair a, tm_pair b) { return a < b ? a : b; }
TM_FN tm_pair tm_pair_max(tm_pair a, tm_pair b) { return a > b ? a : b; }
#if defined(TM_PAIR_SINGLE)
TM_FN tm_pair tm_pair_sqrt(tm_pair x) { return sqrtf(x); }
#else
TM_FN tm_pair tm_pair_sqrt(tm_pair x) { return sqrt(x); }
#endif

/* 1/x, and the square root of x > 0, of pairs of particles. What a compiler makes of / and sqrt() for a GPU has a path for
   numbers that are not normal ones, a call that costs registers and a fifth of the instructions of a pair; these have none, and are
   off by a unit or two of the last bit. */
TM_FN tm_pair tm_pair_inverse(tm_pair x)
{
#if defined(__CUDA_ARCH__) && TM_SINGLE
  float y;
  asm("rcp.approx.ftz.f32 %0, %1;" : "=f"(y) : "f"(x));
  return y;
#elif defined(__CUDA_ARCH__)
  double y; /* 20 bits, then two steps of Newton's */
  asm("rcp.approx.ftz.f64 %0, %1;" : "=d"(y) : "d"(x));
  y = fma(y, fma(-x, y, 1.0), y);
  return fma(y, fma(-x, y, 1.0), y);
#else
  return 1 / x;
#endif
}
TM_FN tm_pair tm_pair_root(tm_pair x)
{
#if defined(__CUDA_ARCH__) && TM_SINGLE
  float y;
  asm("sqrt.approx.ftz.f32 %0, %1;" : "=f"(y) : "f"(x));
  return y;
#elif defined(__CUDA_ARCH__)
  double
      y; /* 1/sqrt(x) of 20 bits; root and half of 1/root come closer together (Goldschmidt), then one step of Newton's */
  asm("rsqrt.approx.ftz.f64 %0, %1;" : "=d"(y) : "d"(x));
  const double root = x * y, half = 0.5 * y, off = fma(-root, half, 0.5);
  const double closer = fma(root, off, root);
  return fma(fma(-closer, closer, x), fma(half, off, half), closer);
#else
  return tm_pair_sqrt(x);
#endif
}
TM_FN tm_real tm_clamp(tm_real x, tm_real lo, tm_real hi) { return tm_min(tm_max(x, lo), hi); }

#endif
