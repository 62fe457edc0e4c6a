/* -*- c++ -*- ----------------------------------------------------------
   SPH-TM: fix sph/tm with Kokkos: the state lives where the loops run, and
   migrates and is sorted there. LAMMPS knows it by the name of the plain fix,
   since restart files are matched by name.
------------------------------------------------------------------------- */
#ifndef LMP_FIX_SPH_TM_KOKKOS_H
#define LMP_FIX_SPH_TM_KOKKOS_H

#include "fix_sph_tm.h"

#include "host_versions_kokkos.h"

namespace LAMMPS_NS {

class FixSPHTMKokkos : public FixSPHTM, public KokkosBase {
 public:
  FixSPHTMKokkos(class LAMMPS *, int, char **);
  void init() override;
  void setup(int) override;
  void setup_pre_exchange() override;
  void pre_exchange() override;
  void post_neighbor() override;
  int pack_exchange_kokkos(const int &, SPHTM_NS::ExchangeBuffer &, DAT::tdual_int_1d, DAT::tdual_int_1d,
                           ExecutionSpace) override;
  void unpack_exchange_kokkos(SPHTM_NS::ExchangeBuffer &, DAT::tdual_int_1d &, int, int, int, ExecutionSpace) override;
  void sort_kokkos(Kokkos::BinSort<KeyViewType, BinOp> &) override;

 private:
  void delete_lost();
  void exchange_as_before();
  bool exchanges_on_host = false;    // this time
};

}    // namespace LAMMPS_NS

#endif
