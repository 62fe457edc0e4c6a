/* SPH-TM: the rate pass of a GPU for sets of effects; in single where TM_PAIR_SINGLE is defined. */
#include "rates_kokkos.h"

#include "backend_kokkos.h"

#include <utility>

namespace SPHTM_NS {

namespace {

template <unsigned EFFECTS> struct Rates {
  tm_rates_args a;
  KOKKOS_FUNCTION void operator()(int k, tm_group group) const
  {
    tm_rates_shared(a.which ? a.which[k] : k, group, &a, EFFECTS);
  }
};
// How many threads share a multiprocessor decides: most of the time a warp waits for its neighbors' records. In double 6
// blocks of 64 leave a thread 168 registers, in two dimensions 8 leave 128: just enough without spills, but for loops that test
// effects at run time. In single 5 blocks of 128 leave 96; what is spilled is behind the pairs (doc/performance.rst).
constexpr bool RATES_IN_DOUBLE = sizeof(tm_pair) == sizeof(double);
constexpr int RATE_THREADS = RATES_IN_DOUBLE ? 64 : 128;
constexpr int rate_blocks(unsigned effects)
{
  if (effects & TM_FX_EXTENDED) return 1;
  if (effects & TM_FX_FACES) return 4;
  return !RATES_IN_DOUBLE ? 5 : is_3d(effects) ? 6 : 8;
}

template <unsigned EFFECTS, int GROUP> void run_in_groups(int n, const tm_rates_args &a)
{
  using Bounds = Kokkos::LaunchBounds<RATE_THREADS, rate_blocks(EFFECTS)>;
  kokkos_each_shared<GROUP, Bounds>("sph/tm rates", n, Rates<EFFECTS>{a});
}
template <unsigned EFFECTS> void run(int n, const tm_rates_args &a)
{
#if defined(LMP_KOKKOS_GPU)    // few particles, with the usual effects: threads share rows
  constexpr bool usual = (EFFECTS & TM_FX_ONE_PASS) && (EFFECTS & TM_FX_VISCOSITY) && !(EFFECTS & TM_FX_SMOOTHING);
  if constexpr (usual) {
    const int group = kokkos_threads_of_one(n, 8);
    if (group == 2) return run_in_groups<EFFECTS, 2>(n, a);
    if (group == 4) return run_in_groups<EFFECTS, 4>(n, a);
    if (group == 8) return run_in_groups<EFFECTS, 8>(n, a);
  }
#endif
  run_in_groups<EFFECTS, 1>(n, a);
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
