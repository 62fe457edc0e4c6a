/* -*- c++ -*- ----------------------------------------------------------
   SPH-TM: LAMMPS's compute reduce with Kokkos: of values of compute
   sph/tm/atom it reads just these, and no particle data has to come to the
   host with them. Everything else is LAMMPS's.
------------------------------------------------------------------------- */
#ifndef LMP_COMPUTE_REDUCE_KOKKOS_H
#define LMP_COMPUTE_REDUCE_KOKKOS_H

#include "compute_reduce.h"

namespace LAMMPS_NS {

class ComputeReduceKokkos : public ComputeReduce {
 public:
  ComputeReduceKokkos(class LAMMPS *, int, char **);
  bool needs_particles() const;    // on the host

 protected:
  double compute_one(int, int) override;
};

}    // namespace LAMMPS_NS

#endif
