/* SPH-TM: rows of neighbors from a search in cells (tm_cells.h, tm_search.h), of some particles of this rank. All arrays
   are where the loops run. */
#ifndef SPHTM_ROW_SEARCH_H
#define SPHTM_ROW_SEARCH_H

#include "loop_array.h"
#include "search_loops.h"
#include "tm_state.h"

#include "pointers.h"

namespace SPHTM_NS {

class RowSearch : protected LAMMPS_NS::Pointers {
 public:
  RowSearch(LAMMPS_NS::LAMMPS *, Backend &);

  // all particles, owned and ghost, in cells for a search radius
  void sort(double radius, const tm_state &);
  // the same with how many before each of the order are marked: what a search for these needs
  const tm_cells &cells_with(const unsigned char *marks);
  // rows of the n particles of a list, entries by segment and tag; the others have none. `meets` and the places of results
  // as in tm_search_args
  struct Rows {
    const unsigned char *meets;    // or nullptr: all are mechanical neighbors
    LoopArray<int> *index, *count[TM_SEGMENTS];
    LoopArray<ptrdiff_t> *first;
  };
  void search(const Rows &, const int *which, int n, double spacing, const int *tag);
  ptrdiff_t stride() const { return loops.shared() ? 1 : TM_ROW_SLICE_GPU; }    // of the entries of a row
  double bytes() const;

 private:
  Backend &loops;
  tm_cells grid = {};
  double radius = 0.0;
  const int *type = nullptr;
  LoopArray<int> cell, begin, index, marked;
  LoopArray<tm_real> column[3];
};

}    // namespace SPHTM_NS

#endif
