#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#pragma GCC target("avx2,fma,avx512f,avx512dq,avx512vl")
#endif
#define TM_PAIR_SINGLE
#include "single_rates.h"

SINGLE_RATES(single_rates_avx512)
