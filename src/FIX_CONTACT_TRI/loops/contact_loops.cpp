#include "contact_loops.h"

#include <algorithm>

namespace SPHTM_NS {

namespace {

// EFFECTS: bits as literals; where they are 0, those given are tested at run time
template <unsigned EFFECTS> tm_contact_result range(int begin, int end, const tm_contact_args &a, unsigned given)
{
  tm_contact_result sum = tm_contact_nothing();
  for (int i = begin; i < end; i++) {
    const tm_contact_result one = tm_contact_tri(i, &a, EFFECTS ? EFFECTS : given);
    if (one.depth > 0.0) tm_contact_sum(&sum, &one);
  }
  return sum;
}

void contact(Backend &loops, int n, const tm_contact_args &a, unsigned effects, tm_contact_result *result)
{
  constexpr unsigned D = TM_CT_3D, H = TM_CT_HEAT, F = TM_CT_FRICTION;
  const auto part = effects == F ? range<F>
      : effects == (H | F)       ? range<H | F>
      : effects == (D | F)       ? range<D | F>
      : effects == (D | H | F)   ? range<D | H | F>
                                 : range<0>;
  // sums per triangle are not for several threads
  Backend &where = effects & TM_CT_OUTPUT ? Backend::host() : loops;
  *result = where.sum_blocks(
      n, tm_contact_nothing(), [&](int begin, int end) { return part(begin, end, a, effects); }, tm_contact_sum);
}

void move(Backend &loops, int n, const tm_tool_move_args &a)
{
  loops.blocks(n, [&](int begin, int end) {
    for (int i = begin; i < end; i++) tm_tool_move(i, &a);
  });
}

int divide(Backend &loops, int n, const tm_spread_args &a)
{
  return loops.sum_blocks(
      n, n,
      [&](int begin, int end) {
        for (int i = begin; i < end; i++)
          if (tm_spread_divide(i, &a)) return i;
        return n;
      },
      [](int *first, const int *i) { *first = std::min(*first, *i); });
}

void collect(Backend &loops, int n, const tm_spread_args &a)
{
  loops.blocks(n, [&](int begin, int end) {
    for (int i = begin; i < end; i++) tm_spread_collect(i, &a);
  });
}

const ContactLoops host = {contact, move, divide, collect};

}    // namespace

const ContactLoops *ContactLoops::kokkos = nullptr;
const ContactLoops &ContactLoops::of(const Backend &b) { return b.shared() ? host : *kokkos; }

}    // namespace SPHTM_NS
