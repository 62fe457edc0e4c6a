/* -*- c++ -*- ----------------------------------------------------------
   SPH-TM: pair style sph/tm with Kokkos: neighbor communication
   where the loops run.
------------------------------------------------------------------------- */
#ifndef LMP_PAIR_SPH_TM_KOKKOS_H
#define LMP_PAIR_SPH_TM_KOKKOS_H

#include "pair_sph_tm.h"

#include "host_versions_kokkos.h"

namespace LAMMPS_NS {

class PairSPHTMKokkos : public PairSPHTM, public KokkosBase {
 public:
  PairSPHTMKokkos(class LAMMPS *);
  void init_style() override;
  void compute(int, int) override;
  int pack_forward_comm_kokkos(int, DAT::tdual_int_1d, SPHTM_NS::ForwardBuffer &, int, int *) override;
  void unpack_forward_comm_kokkos(int, int, SPHTM_NS::ForwardBuffer &) override;

 protected:
  bool records_travel() const override;
  void take_ghost_positions() override;

 private:
  template <class ONE> void each_of_message(const char *label, int n, const ONE &);
};

}    // namespace LAMMPS_NS

#endif
