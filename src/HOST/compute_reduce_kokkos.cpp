#ifdef LMP_KOKKOS
#include "compute_reduce_kokkos.h"

#include "arg_info.h"
#include "atom_kokkos.h"
#include "atom_masks.h"
#include "backend_kokkos.h"
#include "modify.h"
#include "values_of_loops.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace SPHTM_NS;

namespace {

// how values are put together: what none of them gives, what one gives, and two, as LAMMPS does on the host
struct Sum {
  static double nothing() { return 0.0; }
  KOKKOS_FUNCTION static double of(double v) { return v; }
  KOKKOS_FUNCTION static double join(double a, double b) { return a + b; }
};
struct SumOfSquares : Sum {
  KOKKOS_FUNCTION static double of(double v) { return v * v; }
};
struct SumOfSizes : Sum {
  KOKKOS_FUNCTION static double of(double v) { return fabs(v); }
};
constexpr double BEYOND = 1e20;    // BIG of ComputeReduce
struct Largest {
  static double nothing() { return -BEYOND; }
  KOKKOS_FUNCTION static double of(double v) { return v; }
  KOKKOS_FUNCTION static double join(double a, double b) { return b > a ? b : a; }
};
struct LargestSize : Largest {
  static double nothing() { return 0.0; }
  KOKKOS_FUNCTION static double of(double v) { return fabs(v); }
};
struct Least {
  static double nothing() { return BEYOND; }
  KOKKOS_FUNCTION static double of(double v) { return v; }
  KOKKOS_FUNCTION static double join(double a, double b) { return b < a ? b : a; }
};

template <class HOW> struct Value {
  const double *value;
  const int *mask;
  int columns, column, group;
  double outside = HOW::nothing();
  KOKKOS_FUNCTION double operator()(int i) const
  {
    return mask[i] & group ? HOW::of(value[(ptrdiff_t) i * columns + column]) : outside;
  }
};
template <class HOW> struct Join {
  KOKKOS_FUNCTION void operator()(double *sum, const double *one) const { *sum = HOW::join(*sum, *one); }
};

}    // namespace

ComputeReduceKokkos::ComputeReduceKokkos(LAMMPS *lmp, int narg, char **arg) : ComputeReduce(lmp, narg, arg)
{
  atomKK = (AtomKokkos *) atom;
}

bool ComputeReduceKokkos::needs_particles() const
{
  return region || std::any_of(values.begin(), values.end(), [this](const value_t &v) {
           const Compute *c = v.which == ArgInfo::COMPUTE ? modify->get_compute_by_id(v.id) : nullptr;
           return !c || !utils::strmatch(c->style, "^sph/tm/atom");
         });
}

double ComputeReduceKokkos::compute_one(int m, int flag)
{
  int columns;
  const value_t &v = values[m];
  auto *source = v.which == ArgInfo::COMPUTE && !replace && !region ? dynamic_cast<ValuesOfLoops *>(v.val.c) : nullptr;
  const double *there = source && flag < 0 && mode != MINABS ? source->values_of_loops(columns) : nullptr;
  if (!there) {
    atomKK->sync(Host, MASK_MASK);    // groups are looked at there
    return ComputeReduce::compute_one(m, flag);
  }
  const ExecutionSpace space = ExecutionSpaceFromDevice<LMPDeviceType>::space;
  atomKK->sync(space, MASK_MASK);
  const int *mask = atomKK->k_mask.view<LMPDeviceType>().data();
  const int column = v.argindex > 0 ? v.argindex - 1 : 0;
  if (mode == MINN) return reduce<Least>(there, columns, column, mask);
  if (mode == MAXX) return reduce<Largest>(there, columns, column, mask);
  if (mode == MAXABS) return reduce<LargestSize>(there, columns, column, mask);
  if (mode == SUMSQ || mode == AVESQ) return reduce<SumOfSquares>(there, columns, column, mask);
  if (mode == SUMABS || mode == AVEABS) return reduce<SumOfSizes>(there, columns, column, mask);
  return reduce<Sum>(there, columns, column, mask);
}

template <class HOW> double ComputeReduceKokkos::reduce(const double *value, int columns, int column, const int *mask)
{
  return kokkos_sum("sph/tm reduce", atom->nlocal, HOW::nothing(), Value<HOW>{value, mask, columns, column, groupbit},
                    Join<HOW>());
}
#endif
