/* SPH-TM: the rate pass in single for particles begin to end - 1; included once per instruction set with SPHTM_ISA set
   to its namespace. */
#define TM_PAIR_SINGLE
#include "effect_sets.h"
#include "tm_rates.h"

#include <utility>

namespace {

typedef void (*rate_range_t)(int begin, int end, const tm_rates_args *args);

template <unsigned EFFECTS> void rates_of_set(int begin, int end, const tm_rates_args *args)
{
  for (int i = begin; i < end; i++) tm_rates(i, args, EFFECTS);
}
template <int... INDEX> rate_range_t rates_of(int index, std::integer_sequence<int, INDEX...>)
{
  static const rate_range_t range[] = {rates_of_set<SPHTM_NS::few_rate_set(INDEX)>...};
  return range[index];
}

}    // namespace

namespace SPHTM_NS {
namespace SPHTM_ISA {

void rates_in_single(int begin, int end, const tm_rates_args *args, unsigned effects);
void rates_in_single(int begin, int end, const tm_rates_args *args, unsigned effects)
{
  rates_of(few_rate_set_index(effects), std::make_integer_sequence<int, FEW_RATE_SETS>())(begin, end, args);
}

}    // namespace SPHTM_ISA
}    // namespace SPHTM_NS
