#ifdef LMP_KOKKOS
#include "list_loops.h"
#include "loop_table_kokkos.h"

#include <utility>

namespace SPHTM_NS {

namespace {

struct ChainTags {
  tm_tag_map_args a;
  KOKKOS_FUNCTION void operator()(int j) const { a.next[j] = Kokkos::atomic_exchange(a.first + a.tag[j], j + 1); }
};
void chain_tags(Backend &, int n, const tm_tag_map_args &a) { kokkos_each("sph/tm chain tags", n, ChainTags{a}); }

/* ---------------------------------------------------------------------- rates, for sets of effects */

template <unsigned EFFECTS> struct TlRates {
  tm_tl_args a;
  KOKKOS_FUNCTION void operator()(int i) const
  {
    if (a.rows.tl[i]) tm_tl_rates(i, &a, EFFECTS);
  }
};
typedef void (*tl_loop_t)(int, const tm_tl_args &);
template <unsigned EFFECTS> void run_tl_rates(int n, const tm_tl_args &a)
{
  kokkos_each("sph/tm tl rates", n, TlRates<EFFECTS>{a});
}
template <int... INDEX> tl_loop_t tl_rates_of(int index, std::integer_sequence<int, INDEX...>)
{
  static const tl_loop_t table[] = {run_tl_rates<tl_set(INDEX)>...};
  return table[index];
}
void tl_rates(Backend &, int n, const tm_tl_args &a, unsigned effects)
{
  tl_rates_of(tl_set_index(effects), std::make_integer_sequence<int, TL_SETS>())(n, a);
}

LIST_LOOPS(SPHTM_KOKKOS_LOOP)

const ListLoops kernels = {LIST_LOOPS(SPHTM_LOOP_NAME)};
[[maybe_unused]] const bool known = (ListLoops::kokkos = &kernels, true);

}    // namespace

}    // namespace SPHTM_NS
#endif
