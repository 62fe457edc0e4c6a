#ifdef LMP_KOKKOS
#include "rates_kokkos_table.h"

namespace SPHTM_NS {

void kokkos_rates(const KokkosRates &r, const tm_rates_args &a, unsigned effects)
{
  find(few_rate_set_index(effects), std::make_integer_sequence<int, FEW_RATE_SETS>())(r, a);
}

}    // namespace SPHTM_NS
#endif
