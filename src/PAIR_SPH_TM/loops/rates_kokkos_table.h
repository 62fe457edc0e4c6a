/* SPH-TM: the rate pass of a GPU for sets of effects; in single where TM_PAIR_SINGLE is defined. */
#include "rates_kokkos.h"

#include "backend_kokkos.h"

#include <utility>

namespace SPHTM_NS {

namespace {

template <unsigned EFFECTS, int WHOSE> struct Rates {
  tm_rates_args a;
  KOKKOS_FUNCTION void operator()(int k, tm_group group) const
  {
    tm_rates_of(a.which ? a.which[k] : k, group, &a, EFFECTS, WHOSE);
  }
};
// How many threads share a multiprocessor decides: most of the time a warp waits for its neighbors' records. In double 6
// blocks of 64 leave a thread 168 registers, in two dimensions 8 leave 128: just enough without spills, but for loops that test
// effects at run time. In single 5 blocks of 128 leave 96; what is spilled is behind the pairs (doc/performance.rst).
constexpr bool RATES_IN_DOUBLE = sizeof(tm_pair) == sizeof(double);
constexpr int RATE_THREADS = RATES_IN_DOUBLE ? 64 : 128;
constexpr int rate_blocks(unsigned effects, int whose)
{
  if (effects & TM_FX_EXTENDED) return 1;
  if ((effects & TM_FX_FACES) && (whose != TM_RATES_INSIDE || !RATES_IN_DOUBLE)) return 4;
  return !RATES_IN_DOUBLE ? 5 : is_3d(effects) ? 6 : 8;
}

template <unsigned EFFECTS, int GROUP, int WHOSE = TM_RATES_ALL>
void run_in_groups(const KokkosRates &r, const tm_rates_args &a)
{
  using Bounds = Kokkos::LaunchBounds<RATE_THREADS, rate_blocks(EFFECTS, WHOSE)>;
  kokkos_each_shared<GROUP, Bounds>("sph/tm rates", r.n, Rates<EFFECTS, WHOSE>{a}, r.queue);
}

#if defined(LMP_KOKKOS_GPU)
/* Particles at free faces are few, and their sums want a third more registers than those of others: they have a kernel of
   their own, over a list. How long it is stays on the GPU; threads beyond it have nothing to do. */
struct ListAtFace {
  const tm_real *stab;
  const int *which;
  int *list;
  KOKKOS_FUNCTION void operator()(int k, int &m, bool last) const
  {
    const int i = which ? which[k] : k;
    const tm_real *b = stab + tm_record(i, TM_REC_STAB);
    const tm_real x = b[tm_part(TM_STAB_FACE)], y = b[tm_part(TM_STAB_FACE + 1)], z = b[tm_part(TM_STAB_FACE + 2)];
    if (!tm_face_is_there((tm_pair) x, (tm_pair) y, (tm_pair) z)) return;
    if (last) list[m] = i;
    m++;
  }
};
template <unsigned EFFECTS> struct RatesAtFace {
  tm_rates_args a;
  const int *list, *number;
  KOKKOS_FUNCTION void operator()(int k) const
  {
    if (k < *number) tm_rates_of(list[k], tm_group_alone(), &a, EFFECTS, TM_RATES_AT_FACE);
  }
};
template <unsigned EFFECTS> void run_faces_apart(const KokkosRates &r, const tm_rates_args &a)
{
  static KokkosRows<int> room[2];    // of LAMMPS's queue and of the one beside
  int *list = room[r.queue == LMPDeviceType() ? 0 : 1].of(r.n + 1, "particles at faces"), *number = list + r.n;
  using Number = Kokkos::View<int, LMPDeviceType::memory_space, Kokkos::MemoryTraits<Kokkos::Unmanaged>>;
  Number total(number);
  Kokkos::parallel_scan("sph/tm rates: particles at faces", Kokkos::RangePolicy<LMPDeviceType>(r.queue, 0, r.n),
                        ListAtFace{a.rec.stab, a.which, list}, total);
  run_in_groups<EFFECTS, 1, TM_RATES_INSIDE>(r, a);
  using Bounds = Kokkos::LaunchBounds<RATE_THREADS, rate_blocks(EFFECTS, TM_RATES_AT_FACE)>;
  kokkos_each<Bounds>("sph/tm rates at faces", r.n, RatesAtFace<EFFECTS>{a, list, number}, r.queue);
}
#endif

template <unsigned EFFECTS> void run(const KokkosRates &r, const tm_rates_args &a)
{
#if defined(LMP_KOKKOS_GPU)    // few particles, with the usual effects: threads share rows
  constexpr bool usual = (EFFECTS & TM_FX_ONE_PASS) && (EFFECTS & TM_FX_VISCOSITY) && !(EFFECTS & TM_FX_SMOOTHING);
  if constexpr (usual) {
    const int group = kokkos_threads_of_one(r.all, 8);
    if (group == 2) return run_in_groups<EFFECTS, 2>(r, a);
    if (group == 4) return run_in_groups<EFFECTS, 4>(r, a);
    if (group == 8) return run_in_groups<EFFECTS, 8>(r, a);
    if constexpr ((EFFECTS & TM_FX_FACES) != 0) return run_faces_apart<EFFECTS>(r, a);
  }
#endif
  run_in_groups<EFFECTS, 1>(r, a);
}

typedef void (*device_rate_loop_t)(const KokkosRates &, const tm_rates_args &);

// the loop of set number `index` of few_rate_set()
template <int... INDEX> device_rate_loop_t find(int index, std::integer_sequence<int, INDEX...>)
{
  static const device_rate_loop_t table[] = {run<few_rate_set(INDEX)>...};
  return table[index];
}

}    // namespace

}    // namespace SPHTM_NS
