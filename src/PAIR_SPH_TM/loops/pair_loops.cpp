#include "pair_loops.h"

#include <algorithm>

namespace SPHTM_NS {

// clang-format off
namespace isa_default { extern const PairRanges pair_ranges; }
namespace isa_avx2 { extern const PairRanges pair_ranges; }
namespace isa_avx512 { extern const PairRanges pair_ranges; }
// clang-format on

namespace {

const PairRanges &ranges() { return SPHTM_FOR_INSTRUCTION_SET(pair_ranges); }

void drift(Backend &backend, int n, const tm_drift_args &a, unsigned effects, int *lost)
{
  *lost = backend.sum_blocks(
      n, n,
      [&](int begin, int end) {
        int first = n;
        for (int i = begin; i < end; i++)
          if (tm_drift(i, &a, effects)) first = std::min(first, i);
        return first;
      },
      [](int *first, const int *i) { *first = std::min(*first, *i); });
}

void begin_rates(Backend &backend, int n, const tm_rates_args &a, unsigned effects)
{
  PairLoops::of(backend).rates_of_precision(effects)(backend, n, a, effects);
}
void end_rates(Backend &backend, int n, const tm_rates_args &a, unsigned effects)
{
  begin_rates(backend, n, a, effects);
}

void begin_thermal(Backend &, int, const tm_rates_args &, unsigned) {}

void thermal(Backend &backend, int n, const tm_rates_args &a, unsigned effects)
{
  backend.blocks(n, [&](int begin, int end) {
    for (int i = begin; i < end; i++)
      if (a.rows.thermal[i]) tm_thermal(i, tm_group_alone(), &a, effects);
  });
}

PAIR_LOOPS(SPHTM_HOST_LOOP)

const PairLoops host = {PAIR_LOOPS(SPHTM_LOOP_NAME)};

}    // namespace

const PairLoops *PairLoops::kokkos = nullptr;
const PairLoops &PairLoops::of(const Backend &b) { return b.shared() ? host : *kokkos; }

}    // namespace SPHTM_NS
