/* test_search.c for AVX2 */
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#pragma GCC target("avx2,fma")
#define UT_NEEDS (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
#else
#define UT_NEEDS 0
#endif
#include "test_search.c"
