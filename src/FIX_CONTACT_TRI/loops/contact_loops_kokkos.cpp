#ifdef LMP_KOKKOS
#include "contact_loops.h"
#include "loop_table_kokkos.h"

namespace SPHTM_NS {

namespace {

template <unsigned SET> struct ContactKernel {
  tm_contact_args a;
  unsigned given;
  KOKKOS_FUNCTION tm_contact_result operator()(int i) const { return tm_contact_tri(i, &a, SET ? SET : given); }
};
struct SumContact {
  KOKKOS_FUNCTION void operator()(tm_contact_result *sum, const tm_contact_result *r) const
  {
    if (r->depth > 0.0) tm_contact_sum(sum, r);
  }
};
struct Contact {
  int n;
  const tm_contact_args &a;
  unsigned given;
  tm_contact_result *result;
  template <unsigned SET> void with() const
  {
    using Bounds = Kokkos::LaunchBounds<128, 4>;    // few particles touch: the others should not wait for registers
    kokkos_sum_later<Bounds>("sph/tm contact", n, tm_contact_nothing(), ContactKernel<SET>{a, given}, SumContact(),
                             result);
  }
};
void contact(Backend &, int n, const tm_contact_args &a, unsigned effects, tm_contact_result *result)
{
  for_contact_set(effects, Contact{n, a, effects, result});
}

struct DivideHeat {
  tm_spread_args a;
  int *first;
  KOKKOS_FUNCTION void operator()(int i) const
  {
    if (tm_spread_divide(i, &a)) Kokkos::atomic_min(first, i);
  }
};
void divide_heat(Backend &, int n, const tm_spread_args &a, unsigned, int *first)
{
  *first = n;
  kokkos_each("sph/tm divide_heat", n, DivideHeat{a, first});
}

CONTACT_LOOPS(SPHTM_KOKKOS_LOOP)

const ContactLoops kernels = {CONTACT_LOOPS(SPHTM_LOOP_NAME)};
[[maybe_unused]] const bool known = (ContactLoops::kokkos = &kernels, true);

}    // namespace

}    // namespace SPHTM_NS
#endif
