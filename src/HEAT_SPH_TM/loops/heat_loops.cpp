#include "heat_loops.h"

namespace SPHTM_NS {

namespace {
HEAT_LOOPS(SPHTM_HOST_LOOP)
const HeatLoops host = {HEAT_LOOPS(SPHTM_LOOP_NAME)};
}    // namespace

const HeatLoops *HeatLoops::kokkos = nullptr;
const HeatLoops &HeatLoops::of(const Backend &b) { return b.shared() ? host : *kokkos; }

}    // namespace SPHTM_NS
