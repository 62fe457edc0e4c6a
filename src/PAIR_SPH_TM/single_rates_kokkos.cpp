#ifdef LMP_KOKKOS
#define TM_PAIR_SINGLE
#include "single_rates_kokkos.h"

#include "kokkos_type.h"

#include <utility>

namespace SPHTM_NS {

namespace {

template <unsigned EFFECTS> struct Rates {
  tm_rates_args a;
  KOKKOS_FUNCTION void operator()(int i) const { tm_rates(i, &a, EFFECTS); }
};
template <unsigned EFFECTS> void run(int n, const tm_rates_args &a)
{
  Kokkos::parallel_for("sph/tm rates", Kokkos::RangePolicy<LMPDeviceType>(0, n), Rates<EFFECTS>{a});
}

typedef void (*loop_t)(int, const tm_rates_args &);
template <int... INDEX> loop_t find(int index, std::integer_sequence<int, INDEX...>)
{
  static const loop_t table[] = {run<rate_loop_effects(INDEX)>...};
  return table[index];
}

}    // namespace

void kokkos_rates_in_single(int n, const tm_rates_args &a, unsigned fx)
{
  find(rate_loop_index(fx), std::make_integer_sequence<int, RATE_LOOPS_PER_KERNEL>())(n, a);
}

}    // namespace SPHTM_NS
#endif
