/* SPH-TM: fix contact/tri with Kokkos. See doc/fix_contact_tri.rst. */
#ifdef LMP_KOKKOS
#include "fix_contact_tri_kokkos.h"

#include "atom_kokkos.h"
#include "atom_masks.h"

using namespace LAMMPS_NS;
using namespace SPHTM_NS;

FixContactTriKokkos::FixContactTriKokkos(LAMMPS *lmp, int narg, char **arg) : FixContactTri(lmp, narg, arg)
{
  kokkosable = 1;
  atomKK = (AtomKokkos *) atom;
  execution_space = ExecutionSpaceFromDevice<LMPDeviceType>::space;
  datamask_read = X_MASK | V_MASK | F_MASK | TYPE_MASK | MASK_MASK | RMASS_MASK;
  datamask_modify = F_MASK;
  if (set.body_type) datamask_modify |= X_MASK | V_MASK;
  forward_comm_device = 1;
}

void FixContactTriKokkos::init()
{
  atomKK->sync(Host, TYPE_MASK | MASK_MASK);    // which types it can touch
  FixContactTri::init();
}

// the look for overlaps at the start is the host's
void FixContactTriKokkos::setup(int vflag)
{
  atomKK->sync(Host, ALL_MASK);
  FixContactTri::setup(vflag);
}

int FixContactTriKokkos::pack_forward_comm_kokkos(int n, DAT::tdual_int_1d k_sendlist, ForwardBuffer &buf, int, int *)
{
  particles.send(n, k_sendlist.view<LMPDeviceType>().data(), buf.view<LMPDeviceType>().data());
  return n;
}

void FixContactTriKokkos::unpack_forward_comm_kokkos(int n, int first, ForwardBuffer &buf)
{
  particles.receive(n, first, buf.view<LMPDeviceType>().data());
}
#endif
