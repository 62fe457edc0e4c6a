/* -*- c++ -*- ----------------------------------------------------------
   SPH-TM: LAMMPS's fix setforce/kk with constants: the sum of the forces that
   it replaces is summed and waited for where it is asked for, not in every step.
------------------------------------------------------------------------- */
#ifndef LMP_FIX_SETFORCE_LATER_KOKKOS_H
#define LMP_FIX_SETFORCE_LATER_KOKKOS_H

#include "fix_setforce_kokkos.h"

#include "loop_array.h"

namespace LAMMPS_NS {

class FixSetForceLaterKokkos : public FixSetForceKokkos<LMPDeviceType> {
 public:
  FixSetForceLaterKokkos(class LAMMPS *, int, char **);
  ~FixSetForceLaterKokkos() override;
  void post_force(int) override;
  double compute_vector(int) override;

  struct Sum {
    double of[3];
  };

 private:
  SPHTM_NS::LoopArray<Sum> of_warps;    // of the last step
  int warps = 0;
  Sum *replaced;           // their sum, once the loop is through
  bool pending = false;    // not taken up yet
};

}    // namespace LAMMPS_NS

#endif
