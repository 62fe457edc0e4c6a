/* SPH-TM: the hot loops of fix adapt/neigh, for particles begin to end - 1; included once per instruction set with
   SPHTM_ISA set to its namespace. */
#include "list_loops.h"

#include <utility>

namespace {

using namespace SPHTM_NS;

typedef void (*tl_range_t)(int begin, int end, const tm_tl_args *);

template <unsigned EFFECTS> void tl_rates_of_set(int begin, int end, const tm_tl_args *args)
{
  for (int i = begin; i < end; i++)
    if (args->rows.tl[i]) tm_tl_rates(i, args, EFFECTS);
}
template <int... INDEX> tl_range_t tl_rates_of(int index, std::integer_sequence<int, INDEX...>)
{
  static const tl_range_t range[] = {tl_rates_of_set<tl_set(INDEX)>...};
  return range[index];
}
void tl_rates(int begin, int end, const tm_tl_args *args, unsigned effects)
{
  tl_rates_of(tl_set_index(effects), std::make_integer_sequence<int, TL_SETS>())(begin, end, args);
}

LIST_LOOPS(SPHTM_RANGE_LOOP)

}    // namespace

namespace SPHTM_NS {
namespace SPHTM_ISA {

extern const ListRanges list_ranges;
const ListRanges list_ranges = {LIST_LOOPS(SPHTM_RANGE_NAME)};

}    // namespace SPHTM_ISA
}    // namespace SPHTM_NS
