/* SPH-TM: included once per instruction set with SPHTM_ISA set to the namespace. */
#include "rate_loops.h"

#include <utility>

namespace {

template <unsigned EFFECTS> void loop(int nlocal, const tm_rates_args *args)
{
  for (int i = 0; i < nlocal; i++) tm_rates(i, args, EFFECTS);
}

}    // namespace

namespace SPHTM_NS {
namespace SPHTM_ISA {

#define TM_LOOP(I) loop<rate_loop_effects(I)>
#define TM_LOOPS_2(I) TM_LOOP(I), TM_LOOP(I + 1)
#define TM_LOOPS_6(I) TM_LOOPS_2(I), TM_LOOPS_2(I + 2), TM_LOOPS_2(I + 4)
#define TM_LOOPS_18(I) TM_LOOPS_6(I), TM_LOOPS_6(I + 6), TM_LOOPS_6(I + 12)

extern const rate_loop_t table[RATE_LOOPS];
const rate_loop_t table[RATE_LOOPS] = {TM_LOOPS_18(0), TM_LOOPS_18(18), TM_LOOPS_18(36),
                                       TM_LOOPS_18(54), TM_LOOPS_18(72)};

}    // namespace SPHTM_ISA
}    // namespace SPHTM_NS
