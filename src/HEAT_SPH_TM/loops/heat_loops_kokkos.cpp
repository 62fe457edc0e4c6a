#ifdef LMP_KOKKOS
#include "heat_loops.h"
#include "loop_table_kokkos.h"

namespace SPHTM_NS {

namespace {
HEAT_LOOPS(SPHTM_KOKKOS_LOOP)
const HeatLoops kernels = {HEAT_LOOPS(SPHTM_LOOP_NAME)};
[[maybe_unused]] const bool known = (HeatLoops::kokkos = &kernels, true);
}    // namespace

}    // namespace SPHTM_NS
#endif
