/* SPH-TM: pair style sph/tm with Kokkos. See doc/pair_sph_tm.rst. */
#ifdef LMP_KOKKOS
#include "pair_sph_tm_kokkos.h"

#include "backend_kokkos.h"
#include "neighbor_rows_kokkos.h"

#include "atom_kokkos.h"
#include "atom_masks.h"
#include "comm.h"
#include "error.h"
#include "kokkos.h"
#include "lammps.h"
#include "neigh_request.h"
#include "neighbor_kokkos.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace SPHTM_NS;

PairSPHTMKokkos::PairSPHTMKokkos(LAMMPS *lmp) : PairSPHTM(lmp, kokkos_backend())
{
  rows = std::make_unique<NeighborRowsKokkos>(lmp, this, backend, model);
  scene->enter(&model, rows.get(), &results, &conduction);
  kokkosable = 1;
  fuse_force_clear_flag = 1;
  atomKK = (AtomKokkos *) atom;
  execution_space = ExecutionSpaceFromDevice<LMPDeviceType>::space;
  datamask_read = X_MASK | V_MASK | F_MASK | TYPE_MASK | MASK_MASK | TAG_MASK | RMASS_MASK;
  datamask_modify = F_MASK | ENERGY_MASK | VIRIAL_MASK;
}

void PairSPHTMKokkos::init_style()
{
  PairSPHTM::init_style();
  auto *request = neighbor->find_request(this);
  if (!request) {    // rows come from fix adapt/neigh; LAMMPS looks for those that have moved where the particles are
    static_cast<NeighborKokkos *>(neighbor)->device_flag = 1;
    return;
  }
  request->set_kokkos_device(true);
  request->set_kokkos_host(false);
}

// At a set-up LAMMPS takes what the host has for newer whenever something is asked for on a GPU. It has brought all of it
// there before this call; asked for once more, it would go over the forces that were made meanwhile.
void PairSPHTMKokkos::compute(int eflag, int vflag)
{
  const int as_before = lmp->kokkos->auto_sync;
  lmp->kokkos->auto_sync = 0;
  PairSPHTM::compute(eflag, vflag);
  lmp->kokkos->auto_sync = as_before;
}

/* ---------------------------------------------------------------------- communication */

namespace {

struct PackGhosts {
  tm_ghost_args ghosts;
  const int *list;
  double *buf;
  KOKKOS_FUNCTION void operator()(int k) const
  {
    tm_ghost_pack(list[k], &ghosts, buf + (ptrdiff_t) k * tm_ghost_width(&ghosts));
  }
};
struct UnpackGhosts {
  tm_ghost_args ghosts;
  int first;
  const double *buf;
  KOKKOS_FUNCTION void operator()(int k) const
  {
    tm_ghost_unpack(first + k, &ghosts, buf + (ptrdiff_t) k * tm_ghost_width(&ghosts));
  }
};
struct TakePositions {
  double *rec;
  const double *x;
  int first;
  KOKKOS_FUNCTION void operator()(int k) const
  {
    const int i = first + k;
    for (int d = 0; d < 3; d++) rec[tm_record(i, TM_REC) + tm_part(d)] = x[3 * (ptrdiff_t) i + d];
  }
};

}    // namespace

// other GPUs take what is packed here: then the host waits for these loops and for messages alone
bool PairSPHTMKokkos::records_travel() const
{
#if defined(LMP_KOKKOS_GPU)
  return comm->nprocs > 1 && !lmp->kokkos->forward_pair_comm_classic;
#else
  return false;
#endif
}

// LAMMPS waits for its own queue, so while rates run in another what it asks for is done at its return
template <class ONE> void PairSPHTMKokkos::each_of_message(const char *label, int n, const ONE &one)
{
  if (!rates_begun) return kokkos_each(label, n, one);
  const LMPDeviceType queue = kokkos_urgent();
  kokkos_each(label, n, one, queue);
  queue.fence(label);
}

int PairSPHTMKokkos::pack_forward_comm_kokkos(int n, DAT::tdual_int_1d k_sendlist, ForwardBuffer &buf, int, int *)
{
  const tm_ghost_args ghosts = results.ghosts();
  each_of_message("sph/tm send to ghosts", n,
                  PackGhosts{ghosts, k_sendlist.view<LMPDeviceType>().data(), buf.view<LMPDeviceType>().data()});
  return n * tm_ghost_width(&ghosts);
}

void PairSPHTMKokkos::unpack_forward_comm_kokkos(int n, int first, ForwardBuffer &buf)
{
  each_of_message("sph/tm receive ghosts", n, UnpackGhosts{results.ghosts(), first, buf.view<LMPDeviceType>().data()});
}

void PairSPHTMKokkos::take_ghost_positions()
{
  atomKK->sync(execution_space, X_MASK);
  kokkos_each("sph/tm ghost positions", atom->nghost,
              TakePositions{results.main_record().loop_write(), atomKK->k_x.view<LMPDeviceType>().data(),
                            atom->nlocal});
}
#endif
