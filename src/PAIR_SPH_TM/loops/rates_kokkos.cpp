#ifdef LMP_KOKKOS
#include "rates_kokkos_table.h"

namespace SPHTM_NS {

void kokkos_rates(int n, const tm_rates_args &a, unsigned fx)
{
  find(few_rate_loop_index(fx), std::make_integer_sequence<int, FEW_RATE_LOOPS>())(n, a);
}

}    // namespace SPHTM_NS
#endif
