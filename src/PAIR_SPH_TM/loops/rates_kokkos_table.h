/* SPH-TM: the rate pass of a GPU for sets of effects; in single where TM_PAIR_SINGLE is defined. */
#include "rates_kokkos.h"

#include "kokkos_type.h"

#include <utility>

namespace SPHTM_NS {

namespace {

template <unsigned EFFECTS> struct Rates {
  tm_rates_args a;
  KOKKOS_FUNCTION void operator()(int i) const { tm_rates(a.which ? a.which[i] : i, &a, EFFECTS); }
};
// How many threads share a multiprocessor decides: most of the time a warp waits for its neighbors' records. 6 blocks
// of 64 leave a thread 168 registers, 4 of 128 leave 128: just enough without spills, but for loops that test effects
// at run time.
constexpr int RATE_THREADS = sizeof(tm_pair) == sizeof(double) ? 64 : 128;
constexpr int rate_blocks(unsigned effects) { return (effects & TM_FX_EXTENDED) ? 1 : RATE_THREADS == 64 ? 6 : 4; }

template <unsigned EFFECTS> void run(int n, const tm_rates_args &a)
{
  using Policy = Kokkos::RangePolicy<LMPDeviceType, Kokkos::LaunchBounds<RATE_THREADS, rate_blocks(EFFECTS)>>;
  Kokkos::parallel_for("sph/tm rates", Policy(0, n), Rates<EFFECTS>{a});
}

typedef void (*device_rate_loop_t)(int, const tm_rates_args &);

// the loop of set number `index` of few_rate_set()
template <int... INDEX> device_rate_loop_t find(int index, std::integer_sequence<int, INDEX...>)
{
  static const device_rate_loop_t table[] = {run<few_rate_set(INDEX)>...};
  return table[index];
}

}    // namespace

}    // namespace SPHTM_NS
