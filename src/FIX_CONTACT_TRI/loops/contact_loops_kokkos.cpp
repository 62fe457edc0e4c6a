#ifdef LMP_KOKKOS
#include "contact_loops.h"
#include "loop_table_kokkos.h"

namespace SPHTM_NS {

namespace {

// GROUP threads look for the contacts of a particle
template <unsigned SET, int GROUP> struct ContactKernel {
  tm_contact_args a;
  unsigned given;
  KOKKOS_FUNCTION tm_contact_result operator()(int thread) const
  {
    return tm_contact_tri_shared(thread / GROUP, tm_group{thread % GROUP, GROUP}, &a, SET ? SET : given);
  }
};
struct SumContact {
  KOKKOS_FUNCTION void operator()(tm_contact_result *sum, const tm_contact_result *r) const
  {
    if (r->depth > 0.0) tm_contact_sum(sum, r);
  }
};
#if defined(LMP_KOKKOS_GPU)
constexpr int MANY = 100000;    // particles: with more of them those that do not touch count
#endif

struct Contact {
  int n;
  const tm_contact_args &a;
  unsigned given;
  tm_contact_result *result;
  template <unsigned SET, int GROUP> void in_groups() const
  {
    using Bounds = Kokkos::LaunchBounds<128, 4>;    // few particles touch: the others should not wait for registers
    kokkos_sum_later<Bounds>("sph/tm contact", n * GROUP, tm_contact_nothing(), ContactKernel<SET, GROUP>{a, given},
                             SumContact(), result);
  }
  template <unsigned SET> void with() const
  {
#if defined(LMP_KOKKOS_GPU)    // those that touch take long, whatever else there is
    if (n < MANY) return in_groups<SET, 8>();
#endif
    in_groups<SET, 1>();
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

struct CollectHeat {
  tm_spread_args a;
  KOKKOS_FUNCTION void operator()(int i, tm_group group) const { tm_spread_collect(i, group, &a); }
};
void collect_heat(Backend &, int n, const tm_spread_args &a, unsigned)
{
  kokkos_each_shared<ROW_THREADS>("sph/tm collect_heat", n, CollectHeat{a});
}

CONTACT_LOOPS(SPHTM_KOKKOS_LOOP)

const ContactLoops kernels = {CONTACT_LOOPS(SPHTM_LOOP_NAME)};
[[maybe_unused]] const bool known = (ContactLoops::kokkos = &kernels, true);

}    // namespace

}    // namespace SPHTM_NS
#endif
