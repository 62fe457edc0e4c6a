#include "list_loops.h"

namespace SPHTM_NS {

// clang-format off
namespace isa_default { extern const ListRanges list_ranges; }
namespace isa_avx2 { extern const ListRanges list_ranges; }
namespace isa_avx512 { extern const ListRanges list_ranges; }
// clang-format on

namespace {

const ListRanges &ranges() { return SPHTM_FOR_INSTRUCTION_SET(list_ranges); }

void chain_tags(Backend &, int n, const tm_tag_map_args &a)
{
  for (int j = 0; j < n; j++) {
    a.next[j] = a.first[a.tag[j]];
    a.first[a.tag[j]] = j + 1;
  }
}

LIST_LOOPS(SPHTM_HOST_LOOP)

const ListLoops host = {LIST_LOOPS(SPHTM_LOOP_NAME)};

}    // namespace

const ListLoops *ListLoops::kokkos = nullptr;
const ListLoops &ListLoops::of(const Backend &b) { return b.shared() ? host : *kokkos; }

}    // namespace SPHTM_NS
