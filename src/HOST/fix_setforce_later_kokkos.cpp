#ifdef LMP_KOKKOS
#include "fix_setforce_later_kokkos.h"

#include "backend_kokkos.h"

#include "atom_kokkos.h"
#include "atom_masks.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace SPHTM_NS;

namespace {

using Sum = FixSetForceLaterKokkos::Sum;

struct SetForce {
  double *force;    // 3 per particle
  const int *mask;
  int group, sets[3];
  double value[3];
  KOKKOS_FUNCTION Sum operator()(int i) const
  {
    Sum replaced = {};
    if (!(mask[i] & group)) return replaced;
    for (int k = 0; k < 3; k++) {
      double &f = force[3 * (ptrdiff_t) i + k];
      replaced.of[k] = f;
      if (sets[k]) f = value[k];
    }
    return replaced;
  }
};
struct Add {
  KOKKOS_FUNCTION void operator()(Sum *sum, const Sum *one) const
  {
    for (int k = 0; k < 3; k++) sum->of[k] += one->of[k];
  }
};

}    // namespace

FixSetForceLaterKokkos::FixSetForceLaterKokkos(LAMMPS *lmp, int narg, char **arg) :
    FixSetForceKokkos<LMPDeviceType>(lmp, narg, arg), replaced((Sum *) kokkos_backend().allocate_result(sizeof(Sum)))
{
}

FixSetForceLaterKokkos::~FixSetForceLaterKokkos()
{
  if (copymode) return;
  kokkos_backend().wait();
  kokkos_backend().release_result(replaced);
}

void FixSetForceLaterKokkos::post_force(int vflag)
{
  enum { NONE, CONSTANT };    // of FixSetForce
  pending = varflag == CONSTANT && !region;
  if (!pending) return FixSetForceKokkos<LMPDeviceType>::post_force(vflag);
  atomKK->sync(execution_space, F_MASK | MASK_MASK);
  SetForce one{atomKK->k_f.view<LMPDeviceType>().data(),
               atomKK->k_mask.view<LMPDeviceType>().data(),
               groupbit,
               {xstyle == CONSTANT, ystyle == CONSTANT, zstyle == CONSTANT},
               {xvalue, yvalue, zvalue}};
  kokkos_sum_later("sph/tm setforce", atom->nlocal, Sum{}, one, Add(), replaced);
  atomKK->modified(execution_space, F_MASK);
  force_flag = 0;
}

double FixSetForceLaterKokkos::compute_vector(int n)
{
  if (pending) {
    kokkos_backend().wait();
    std::copy_n(replaced->of, 3, foriginal);
    pending = false;
  }
  return FixSetForceKokkos<LMPDeviceType>::compute_vector(n);
}
#endif
