#ifdef LMP_KOKKOS
#include "body_loops.h"
#include "loop_table_kokkos.h"

namespace SPHTM_NS {

namespace {
BODY_LOOPS(SPHTM_KOKKOS_LOOP)
const BodyLoops kernels = {BODY_LOOPS(SPHTM_LOOP_NAME)};
[[maybe_unused]] const bool known = (BodyLoops::kokkos = &kernels, true);
}    // namespace

}    // namespace SPHTM_NS
#endif
