/* SPH-TM: a fix that leaves all its particles to the loops of fix sph/tm needs no Kokkos version of its own: Kokkos
   only has to know where the loops run. Its checks at the set-up look at particles on the host. */
#ifndef SPHTM_ON_LOOPS_KOKKOS_H
#define SPHTM_ON_LOOPS_KOKKOS_H

#include "atom_kokkos.h"
#include "atom_masks.h"
#include "kokkos_type.h"

namespace SPHTM_NS {

template <class STYLE> class OnLoopsKokkos : public STYLE {
 public:
  OnLoopsKokkos(LAMMPS_NS::LAMMPS *lmp, int narg, char **arg) : STYLE(lmp, narg, arg)
  {
    this->kokkosable = 1;
    this->atomKK = (LAMMPS_NS::AtomKokkos *) this->atom;
    this->execution_space = ExecutionSpaceFromDevice<LMPDeviceType>::space;
  }
  void setup(int vflag) override
  {
    this->atomKK->sync(LAMMPS_NS::Host, ALL_MASK);
    STYLE::setup(vflag);
  }
};

}    // namespace SPHTM_NS

#endif
