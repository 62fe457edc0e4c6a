/* -*- c++ -*- ----------------------------------------------------------
   SPH-TM: LAMMPS's fix setforce/kk with constants: the sum of the forces that
   it replaces is waited for where it is asked for, not in every step.
------------------------------------------------------------------------- */
#ifndef LMP_FIX_SETFORCE_LATER_KOKKOS_H
#define LMP_FIX_SETFORCE_LATER_KOKKOS_H

#include "fix_setforce_kokkos.h"

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
  Sum *replaced;           // once the loop is through
  bool pending = false;    // not taken up yet
};

}    // namespace LAMMPS_NS

#endif
