#ifdef LMP_KOKKOS
#include "compute_reduce_kokkos.h"

#include "arg_info.h"
#include "atom_kokkos.h"
#include "atom_masks.h"
#include "modify.h"

#include <algorithm>

using namespace LAMMPS_NS;

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

// groups are looked at on the host
double ComputeReduceKokkos::compute_one(int m, int flag)
{
  atomKK->sync(Host, MASK_MASK);
  return ComputeReduce::compute_one(m, flag);
}
#endif
