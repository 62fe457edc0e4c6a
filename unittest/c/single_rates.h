/* The rate pass in single, compiled apart (TM_PAIR_SINGLE holds for a whole file): particles 0 to n - 1
   with the effects of args->effects, for each instruction set. */
#ifndef SINGLE_RATES_H
#define SINGLE_RATES_H

#include "tm_rates.h"

typedef void single_rates(int kernel, int dim3, int n, const tm_rates_args *args);

single_rates single_rates_default, single_rates_avx2, single_rates_avx512;

/* the body of each */
#define SINGLE_CASE(KERNEL)                                                            \
  case TM_KERNEL_##KERNEL:                                                             \
    for (int i = 0; i < n; i++) {                                                      \
      const unsigned k = (unsigned) TM_KERNEL_##KERNEL << TM_FX_KERNEL_SHIFT;          \
      if (dim3) tm_rates(i, args, k | (unsigned) TM_FX_3D | (unsigned) TM_FX_EXTENDED); \
      else tm_rates(i, args, k | (unsigned) TM_FX_EXTENDED);                           \
    }                                                                                  \
    break
#define SINGLE_RATES(name)                                               \
  void name(int kernel, int dim3, int n, const tm_rates_args *args)      \
  {                                                                      \
    switch (kernel) {                                                    \
      SINGLE_CASE(HYPERBOLIC);                                           \
      SINGLE_CASE(CUBIC);                                                \
      SINGLE_CASE(QUINTIC);                                              \
      SINGLE_CASE(WENDLAND_C2);                                          \
      SINGLE_CASE(WENDLAND_C4);                                          \
    }                                                                    \
  }

#endif
