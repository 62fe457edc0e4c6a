#include "search_loops.h"

#include <algorithm>

namespace SPHTM_NS {

// clang-format off
namespace isa_default { extern const SearchRanges search_ranges; }
namespace isa_avx2 { extern const SearchRanges search_ranges; }
namespace isa_avx512 { extern const SearchRanges search_ranges; }
// clang-format on

namespace {

const SearchRanges &ranges() { return SPHTM_FOR_INSTRUCTION_SET(search_ranges); }

void sort_into_cells(Backend &backend, const tm_cells &c)
{
  const int cells = tm_cells_number(&c);
  std::fill_n(c.begin, cells + 1, 0);
  backend.blocks(c.n, [&](int begin, int end) {
    for (int i = begin; i < end; i++) c.cell[i] = tm_cells_of(&c, c.x + 3 * (size_t) i);
  });
  // begin[k + 1] goes from the start of cell k to its end
  for (int i = 0; i < c.n; i++)
    if (c.cell[i] + 2 <= cells) c.begin[c.cell[i] + 2]++;
  for (int k = 2; k <= cells; k++) c.begin[k] += c.begin[k - 1];
  for (int i = 0; i < c.n; i++) tm_cells_put(&c, i, c.begin[c.cell[i] + 1]++);
  if (!c.radius) return;
  const auto of_cells = [&](tm_real *to, auto value) {
    backend.blocks(cells, [&](int begin, int end) {
      for (int k = begin; k < end; k++) to[k] = value(k);
    });
  };
  of_cells(c.look[1], [&](int k) { return tm_cells_radius(&c, k); });
  for (int axis = 0; axis < 3; axis++)
    of_cells(c.look[axis % 2], [&](int k) { return tm_cells_look(&c, k, axis, c.look[1 - axis % 2]); });
}

void count_marked(Backend &, const tm_cells &c, const unsigned char *marks)
{
  int sum = 0;
  for (int k = 0; k < c.n; k++) {
    c.marked[k] = sum;
    sum += marks[c.index[k]];
  }
  c.marked[c.n] = sum;
}

SEARCH_LOOPS(SPHTM_HOST_LOOP)

const SearchLoops host = {SEARCH_LOOPS(SPHTM_LOOP_NAME)};

}    // namespace

const SearchLoops *SearchLoops::kokkos = nullptr;
const SearchLoops &SearchLoops::of(const Backend &b) { return b.shared() ? host : *kokkos; }

}    // namespace SPHTM_NS
