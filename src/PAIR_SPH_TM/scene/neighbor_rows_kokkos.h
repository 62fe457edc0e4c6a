/* SPH-TM: rows of neighbors from LAMMPS's list, made where the loops of Kokkos run. */
#ifndef SPHTM_NEIGHBOR_ROWS_KOKKOS_H
#define SPHTM_NEIGHBOR_ROWS_KOKKOS_H

#include "neighbor_rows.h"

namespace LAMMPS_NS {
class AtomKokkos;
}

namespace SPHTM_NS {

class NeighborRowsKokkos : public NeighborRows {
 public:
  NeighborRowsKokkos(LAMMPS_NS::LAMMPS *, LAMMPS_NS::Pair *, Backend &, Model &);
  void build(LAMMPS_NS::NeighList *, bool conduction) override;
  const int *loop_tags() override;

 private:
  LAMMPS_NS::AtomKokkos *atoms;
  LoopArray<unsigned char> meets;    // segments of a type pair
};

}    // namespace SPHTM_NS

#endif
