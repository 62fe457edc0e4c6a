/* SPH-TM: the rate pass in single, included once per instruction set with SPHTM_ISA set to the namespace. */
#define TM_PAIR_SINGLE
#include "rate_loop_sets.h"

namespace {
template <unsigned EFFECTS> void loop(int begin, int end, const tm_rates_args *args)
{
  for (int i = begin; i < end; i++) tm_rates(i, args, EFFECTS);
}
}    // namespace

namespace SPHTM_NS {
namespace SPHTM_ISA {

#define TM_LOOPS_2(I) loop<few_rate_loop_effects(I)>, loop<few_rate_loop_effects(I + 1)>
#define TM_LOOPS_6(I) TM_LOOPS_2(I), TM_LOOPS_2(I + 2), TM_LOOPS_2(I + 4)

extern const SingleLoops single_loops;
const SingleLoops single_loops = {
    {TM_LOOPS_6(0), TM_LOOPS_6(6), TM_LOOPS_6(12), TM_LOOPS_6(18), TM_LOOPS_6(24), TM_LOOPS_2(30), TM_LOOPS_2(32)}};

}    // namespace SPHTM_ISA
}    // namespace SPHTM_NS
