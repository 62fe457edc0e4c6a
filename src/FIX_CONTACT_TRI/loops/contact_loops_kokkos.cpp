#ifdef LMP_KOKKOS
#include "backend_kokkos.h"
#include "contact_loops.h"

namespace SPHTM_NS {

namespace {

// effects as literals, or all tested at run time
template <unsigned EFFECTS> struct Contact {
  tm_contact_args a;
  unsigned given;
  KOKKOS_FUNCTION tm_contact_result operator()(int i) const
  {
    return tm_contact_tri(i, &a, EFFECTS ? EFFECTS : given);
  }
};
struct SumContact {
  KOKKOS_FUNCTION void operator()(tm_contact_result *sum, const tm_contact_result *r) const
  {
    if (r->depth > 0.0) tm_contact_sum(sum, r);
  }
};
template <unsigned EFFECTS>
void run_contact(int n, const tm_contact_args &a, unsigned given, tm_contact_result *result)
{
  using Bounds = Kokkos::LaunchBounds<128, 4>;    // few particles touch: the others should not wait for registers
  kokkos_sum_later<Bounds>("contact/tri", n, tm_contact_nothing(), Contact<EFFECTS>{a, given}, SumContact(), result);
}
void contact(Backend &, int n, const tm_contact_args &a, unsigned effects, tm_contact_result *result)
{
  constexpr unsigned D = TM_CT_3D, H = TM_CT_HEAT, F = TM_CT_FRICTION;
  switch (effects) {
    case F: run_contact<F>(n, a, effects, result); break;
    case H | F: run_contact<H | F>(n, a, effects, result); break;
    case D | F: run_contact<D | F>(n, a, effects, result); break;
    case D | H | F: run_contact<D | H | F>(n, a, effects, result); break;
    default: run_contact<0>(n, a, effects, result); break;
  }
}

struct Move {
  tm_tool_move_args a;
  KOKKOS_FUNCTION void operator()(int i) const { tm_tool_move(i, &a); }
};
void move(Backend &, int n, const tm_tool_move_args &a) { kokkos_each("contact/tri move", n, Move{a}); }

struct Divide {
  tm_spread_args a;
  int n;
  KOKKOS_FUNCTION int operator()(int i) const { return tm_spread_divide(i, &a) ? i : n; }
};
struct Least {
  KOKKOS_FUNCTION void operator()(int *least, const int *i) const { *least = *i < *least ? *i : *least; }
};
int divide(Backend &, int n, const tm_spread_args &a)
{
  return kokkos_sum("contact/tri divide heat", n, n, Divide{a, n}, Least());
}

struct Collect {
  tm_spread_args a;
  KOKKOS_FUNCTION void operator()(int j) const { tm_spread_collect(j, &a); }
};
void collect(Backend &, int n, const tm_spread_args &a) { kokkos_each("contact/tri collect heat", n, Collect{a}); }

const ContactLoops kernels = {contact, move, divide, collect};
[[maybe_unused]] const bool known = (ContactLoops::kokkos = &kernels, true);

}    // namespace

}    // namespace SPHTM_NS
#endif
