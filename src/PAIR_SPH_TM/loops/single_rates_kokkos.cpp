#ifdef LMP_KOKKOS
#define TM_PAIR_SINGLE
#include "rates_kokkos_table.h"

namespace SPHTM_NS {

void kokkos_rates_in_single(const KokkosRates &r, const tm_rates_args &a, unsigned effects)
{
  find(rate_set_index(effects), std::make_integer_sequence<int, RATE_SETS_PER_KERNEL>())(r, a);
}

}    // namespace SPHTM_NS
#endif
