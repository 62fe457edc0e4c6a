/* test_rates.c for AVX-512 */
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#pragma GCC target("avx2,fma,avx512f,avx512dq,avx512vl,prefer-vector-width=512")
#define UT_NEEDS (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && \
                  __builtin_cpu_supports("avx512vl"))
#else
#define UT_NEEDS 0
#endif
#include "test_rates.c"
