/* -*- c++ -*- ----------------------------------------------------------
   SPH-TM: compute sph/tm/atom with Kokkos: values are made where the loops
   run, and one packed copy of them goes to the host.
------------------------------------------------------------------------- */
#ifndef LMP_COMPUTE_SPH_TM_ATOM_KOKKOS_H
#define LMP_COMPUTE_SPH_TM_ATOM_KOKKOS_H

#include "compute_sph_tm_atom.h"
#include "loop_array.h"
#include "values_of_loops.h"

namespace LAMMPS_NS {

class ComputeSPHTMAtomKokkos : public ComputeSPHTMAtom, public SPHTM_NS::ValuesOfLoops {
 public:
  ComputeSPHTMAtomKokkos(class LAMMPS *, int, char **);
  const double *values_of_loops(int &columns) override;

 protected:
  void run_output(double *) override;

 private:
  SPHTM_NS::LoopArray<int> columns;
  SPHTM_NS::LoopArray<double> values;

  const double *make_values();    // where the loops run
};

}    // namespace LAMMPS_NS

#endif
