#include "contact_loops.h"

#include <algorithm>

namespace SPHTM_NS {

namespace {

void look(Backend &backend, int n, const tm_contact_args &a, unsigned effects)
{
  *a.found.taken = 0;
  backend.blocks(n, [&a, effects](int begin, int end) {
    for (int i = begin; i < end; i++) tm_contact_look(i, tm_group_alone(), &a, effects);
  });
}

struct Contact {
  Backend &backend;
  int n;
  const tm_contact_args &a;
  unsigned given;
  tm_contact_result *result;
  template <unsigned SET> void with() const
  {
    *result = backend.sum_blocks(
        n, tm_contact_nothing(),
        [this](int begin, int end) {
          const tm_contact_args &args = a;
          const unsigned effects = given;
          tm_contact_result sum = tm_contact_nothing();
          for (int i = begin; i < end; i++) {
            const tm_contact_result one = tm_contact_tri(i, &args, SET ? SET : effects);
            if (one.depth > 0.0) tm_contact_sum(&sum, &one);
          }
          return sum;
        },
        tm_contact_sum);
  }
};
void contact(Backend &backend, int n, const tm_contact_args &a, unsigned effects, tm_contact_result *result)
{
  // sums per triangle are not for several threads
  for_contact_set(effects, Contact{effects & TM_CT_OUTPUT ? Backend::host() : backend, n, a, effects, result});
}

void late(Backend &backend, int n, const tm_contact_args &a, unsigned effects, tm_contact_result *result)
{
  *result = backend.sum_blocks(
      n, tm_contact_nothing(),
      [&a, effects](int begin, int end) {
        tm_contact_result sum = tm_contact_nothing();
        for (int i = begin; i < end; i++) {
          const tm_contact_result one = tm_contact_late(i, &a, effects);
          tm_contact_sum(&sum, &one);
        }
        return sum;
      },
      tm_contact_sum);
}

void divide_heat(Backend &backend, int n, const tm_spread_args &a, unsigned, int *first)
{
  *first = backend.sum_blocks(
      n, n,
      [&a, n](int begin, int end) {
        int found = n;
        for (int i = begin; i < end; i++)
          if (tm_spread_divide(i, &a) && i < found) found = i;
        return found;
      },
      [](int *sum, const int *part) { *sum = std::min(*sum, *part); });
}

void collect_heat(Backend &backend, int n, const tm_spread_args &a, unsigned)
{
  backend.blocks(n, [&a](int begin, int end) {
    for (int i = begin; i < end; i++) tm_spread_collect(i, tm_group_alone(), &a);
  });
}

CONTACT_LOOPS(SPHTM_HOST_LOOP)

const ContactLoops host = {CONTACT_LOOPS(SPHTM_LOOP_NAME)};

}    // namespace

const ContactLoops *ContactLoops::kokkos = nullptr;
const ContactLoops &ContactLoops::of(const Backend &b) { return b.shared() ? host : *kokkos; }

}    // namespace SPHTM_NS
