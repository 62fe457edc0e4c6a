/* -*- c++ -*- ----------------------------------------------------------
   SPH-TM: fix adapt/neigh with Kokkos: total-Lagrangian pairs migrate and are sorted where the loops run.
------------------------------------------------------------------------- */
#ifndef LMP_FIX_ADAPT_NEIGH_KOKKOS_H
#define LMP_FIX_ADAPT_NEIGH_KOKKOS_H

#include "fix_adapt_neigh.h"

#include "host_versions_kokkos.h"
#include "on_loops_kokkos.h"

namespace LAMMPS_NS {

class FixAdaptNeighKokkos : public SPHTM_NS::OnLoopsKokkos<FixAdaptNeigh>, public KokkosBase {
 public:
  FixAdaptNeighKokkos(class LAMMPS *, int, char **);
  int pack_exchange_kokkos(const int &, SPHTM_NS::ExchangeBuffer &, DAT::tdual_int_1d, DAT::tdual_int_1d,
                           ExecutionSpace) override;
  void unpack_exchange_kokkos(SPHTM_NS::ExchangeBuffer &, DAT::tdual_int_1d &, int, int, int, ExecutionSpace) override;
  void sort_kokkos(Kokkos::BinSort<KeyViewType, BinOp> &) override;
};

}    // namespace LAMMPS_NS

#endif
