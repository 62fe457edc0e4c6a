/* -*- c++ -*- ----------------------------------------------------------
   SPH-TM: fix contact/tri with Kokkos.
------------------------------------------------------------------------- */
#ifndef LMP_FIX_CONTACT_TRI_KOKKOS_H
#define LMP_FIX_CONTACT_TRI_KOKKOS_H

#include "fix_contact_tri.h"

#include "kokkos_base.h"

namespace LAMMPS_NS {

class FixContactTriKokkos : public FixContactTri, public KokkosBase {
 public:
  FixContactTriKokkos(class LAMMPS *, int, char **);
  ~FixContactTriKokkos() override;
  void init() override;
  void setup(int) override;
  int pack_forward_comm_kokkos(int, DAT::tdual_int_1d, DAT::tdual_xfloat_1d &, int, int *) override;
  void unpack_forward_comm_kokkos(int, int, DAT::tdual_xfloat_1d &) override;

 protected:
  void start_contact(const tm_contact_args &, unsigned) override;
  void wait_for_contact() override;
  void run_carry(const tm_carry_args &) override;
  int run_divide(const tm_spread_args &) override;
  void run_collect(const tm_spread_args &) override;

 private:
  tm_contact_result *result = nullptr;    // of the loop on its way
  SPHTM_NS::Backend *owner = nullptr;     // of its memory
};

}    // namespace LAMMPS_NS

#endif
