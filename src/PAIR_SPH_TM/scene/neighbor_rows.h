/* SPH-TM: rows of neighbors of the owned particles: made from LAMMPS's list, or those of fix adapt/neigh. */
#ifndef SPHTM_NEIGHBOR_ROWS_H
#define SPHTM_NEIGHBOR_ROWS_H

#include "loop_array.h"
#include "row_source.h"

#include "pointers.h"

namespace LAMMPS_NS {
class NeighList;
class Pair;
}    // namespace LAMMPS_NS

namespace SPHTM_NS {

class Model;
class ParticleState;
class RowSearch;

class NeighborRows : protected LAMMPS_NS::Pointers {
 public:
  NeighborRows(LAMMPS_NS::LAMMPS *, LAMMPS_NS::Pair *, Backend &, Model &);    // of a pair style with this model

  // before a run; source: of fix adapt/neigh, or nullptr
  void init(const ParticleState &, RowSource *source);
  RowSource *source() const { return row_source; }
  bool has_tl() const { return row_source && row_source->has_tl(); }          // total-Lagrangian pairs
  bool keeps_all() const { return row_source && row_source->keeps_all(); }    // these alone, at any distance
  bool cover(int n) const { return (int) row_first.size() >= n; }             // so many particles
  virtual void build(LAMMPS_NS::NeighList *, bool conduction);
  // rows of the n particles of a list alone, from a search that has sorted all; the others have none
  virtual void build(RowSearch &, const int *which, int n, bool conduction);
  virtual tm_rows loop_rows();
  virtual tm_rows host_rows();
  virtual const int *loop_tags();    // IDs of owned and ghost particles, where the loops run
  double bytes() const;

  // smoothing lengths up to h will be in the rows, and particles with edges down to dp. Collective; from init() on,
  // before LAMMPS makes its lists
  void cover_sizes(double h, double dp);
  void make_room_for(double share);    // in LAMMPS's lists, for spacings down to that share of the smallest

 protected:
  Backend &backend;
  Model &model;
  LoopArray<int> row_index, row_mechanical, row_thermal, row_contact;
  LoopArray<ptrdiff_t> row_first;
  LoopArray<unsigned char> meets;    // segments of a type pair
  ptrdiff_t row_stride = 1;
  void make_room();

 private:
  LAMMPS_NS::Pair *pair;
  RowSource *row_source = nullptr;
  bool sizes_differ = false;
  void check_list_size(double dp);
};

}    // namespace SPHTM_NS

#endif
