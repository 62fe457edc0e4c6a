/* -*- c++ -*- ----------------------------------------------------------
   SPH-TM: compute sph/tm/atom with Kokkos: values are made where the loops
   run, and one packed copy of them goes to the host.
------------------------------------------------------------------------- */
#ifndef LMP_COMPUTE_SPH_TM_ATOM_KOKKOS_H
#define LMP_COMPUTE_SPH_TM_ATOM_KOKKOS_H

#include "compute_sph_tm_atom.h"
#include "loop_array.h"

namespace LAMMPS_NS {

class ComputeSPHTMAtomKokkos : public ComputeSPHTMAtom {
 public:
  ComputeSPHTMAtomKokkos(class LAMMPS *, int, char **);

 protected:
  void run_output(double *) override;

 private:
  SPHTM_NS::LoopArray<int> columns;
  SPHTM_NS::LoopArray<double> values;
};

}    // namespace LAMMPS_NS

#endif
