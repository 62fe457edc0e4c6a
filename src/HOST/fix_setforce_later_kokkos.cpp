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
  KOKKOS_FUNCTION bool holds(int i) const { return mask[i] & group; }
  KOKKOS_FUNCTION Sum operator()(int i) const
  {
    Sum replaced = {};
    if (!holds(i)) return replaced;
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

// the sum of each warp, where it has a particle of the group
struct Ahead {
  KOKKOS_FUNCTION Sum operator()(const KokkosWarp &warp, const Sum &mine, int step) const
  {
    return {{warp.from(mine.of[0], step), warp.from(mine.of[1], step), warp.from(mine.of[2], step)}};
  }
};
struct SetForceByWarp {
  SetForce one;
  int n;
  Sum *warps;
  KOKKOS_FUNCTION void operator()(int i) const
  {
    const KokkosWarp warp(i, n);
    Sum sum = {};
    if (warp.any(one.holds(i))) {
      sum = one(i);
      kokkos_sum_warp(warp, &sum, Ahead(), Add());
    }
    if (warp.lane == 0) warps[i / KOKKOS_SUMMED] = sum;
  }
};
struct SumOfWarp {
  const Sum *warps;
  KOKKOS_FUNCTION Sum operator()(int w) const { return warps[w]; }
};
}    // namespace

FixSetForceLaterKokkos::FixSetForceLaterKokkos(LAMMPS *lmp, int narg, char **arg) :
    FixSetForceKokkos<LMPDeviceType>(lmp, narg, arg), replaced((Sum *) kokkos_backend().allocate_result(sizeof(Sum)))
{
  of_warps.live_in(kokkos_backend());
  of_warps.call("forces that setforce replaces");
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
  const int n = atom->nlocal;
  warps = kokkos_warps(n);
  of_warps.make_room(true, warps + 1);
  kokkos_each("sph/tm setforce", n, SetForceByWarp{one, n, of_warps.loop_write()});
  atomKK->modified(execution_space, F_MASK);
  force_flag = 0;
}

double FixSetForceLaterKokkos::compute_vector(int n)
{
  if (pending) {    // nobody has asked for it since
    kokkos_sum_later("sph/tm setforce sums", warps, Sum{}, SumOfWarp{of_warps.loop_read()}, Add(), replaced);
    kokkos_backend().wait();
    std::copy_n(replaced->of, 3, foriginal);
    pending = false;
  }
  return FixSetForceKokkos<LMPDeviceType>::compute_vector(n);
}
#endif
