/* -*- c++ -*- ----------------------------------------------------------
   SPH-TM: fix contact/tri with Kokkos.
------------------------------------------------------------------------- */
#ifndef LMP_FIX_CONTACT_TRI_KOKKOS_H
#define LMP_FIX_CONTACT_TRI_KOKKOS_H

#include "fix_contact_tri.h"

#include "host_versions_kokkos.h"

namespace LAMMPS_NS {

class FixContactTriKokkos : public FixContactTri, public KokkosBase {
 public:
  FixContactTriKokkos(class LAMMPS *, int, char **);
  void init() override;
  void setup(int) override;
  int pack_forward_comm_kokkos(int, DAT::tdual_int_1d, SPHTM_NS::ForwardBuffer &, int, int *) override;
  void unpack_forward_comm_kokkos(int, int, SPHTM_NS::ForwardBuffer &) override;
};

}    // namespace LAMMPS_NS

#endif
