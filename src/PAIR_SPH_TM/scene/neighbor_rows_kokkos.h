/* SPH-TM: rows of neighbors from LAMMPS's list, made where the loops of Kokkos run: in the list itself where no pair
   stands in two segments of a row. */
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
  tm_rows loop_rows() override;
  tm_rows host_rows() override;
  const int *loop_tags() override;

 private:
  int *in_list = nullptr;    // LAMMPS's, if rows are there, of so many values
  size_t list_size = 0;
  LAMMPS_NS::AtomKokkos *atoms;
  LoopArray<unsigned char> meets;    // segments of a type pair
};

}    // namespace SPHTM_NS

#endif
