#include "list_loops.h"

namespace SPHTM_NS {

// clang-format off
namespace isa_default { extern const ListRanges list_ranges; }
namespace isa_avx2 { extern const ListRanges list_ranges; }
namespace isa_avx512 { extern const ListRanges list_ranges; }
// clang-format on

namespace {

const ListRanges &ranges() { return SPHTM_FOR_INSTRUCTION_SET(list_ranges); }

void count_marked(Backend &, const tm_cells &c, const unsigned char *marks)
{
  int sum = 0;
  for (int k = 0; k < c.n; k++) {
    c.marked[k] = sum;
    sum += marks[c.index[k]];
  }
  c.marked[c.n] = sum;
}

template <class TAKES> int list(int n, int *which, TAKES takes)
{
  int m = 0;
  for (int i = 0; i < n; i++)
    if (takes(i)) which[m++] = i;
  return m;
}
int near_moved(Backend &, int n, const tm_near_moved_args &a, int *which)
{
  return list(n, which, [&](int i) { return tm_near_moved(i, &a); });
}
int of_kind(Backend &, int n, const tm_kind_args &a, int *which)
{
  return list(n, which, [&](int i) { return tm_is_of_kind(i, &a); });
}

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
