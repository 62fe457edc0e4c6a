#include "body_loops.h"

namespace SPHTM_NS {

namespace {
BODY_LOOPS(SPHTM_HOST_LOOP)
const BodyLoops host = {BODY_LOOPS(SPHTM_LOOP_NAME)};
}    // namespace

const BodyLoops *BodyLoops::kokkos = nullptr;
const BodyLoops &BodyLoops::of(const Backend &b) { return b.shared() ? host : *kokkos; }

}    // namespace SPHTM_NS
