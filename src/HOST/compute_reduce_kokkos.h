/* -*- c++ -*- ----------------------------------------------------------
   SPH-TM: LAMMPS's compute reduce with Kokkos: of values of compute
   sph/tm/atom it takes where the loops run, and no particle data has to come
   to the host. Everything else is LAMMPS's.
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

 private:
  template <class HOW> double reduce(const double *value, int columns, int column, const int *mask);
};

}    // namespace LAMMPS_NS

#endif
