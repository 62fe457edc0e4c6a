/* SPH-TM: rows of neighbors from a search in cells (tm_cells.h, tm_search.h), of some particles of this rank. On the
   host. */
#ifndef SPHTM_ROW_SEARCH_H
#define SPHTM_ROW_SEARCH_H

#include "loop_array.h"
#include "search_loops.h"

#include "pointers.h"

#include <vector>

namespace SPHTM_NS {

class RowSearch : protected LAMMPS_NS::Pointers {
 public:
  RowSearch(LAMMPS_NS::LAMMPS *, Backend &);

  // all particles, owned and ghost, in cells for a search radius
  void sort(double radius);
  // of these, how many in the order of cells have at least this flag: what a search for them needs
  const tm_cells &cells_with(const tm_real *flag, tm_real least);
  const tm_cells &cells() const { return grid; }
  // rows of these particles, entries by segment and tag; `meets` and the places of results as in tm_search_args
  struct Rows {
    std::vector<unsigned char> meets;    // empty: all are mechanical neighbors
    LoopArray<int> *index, *count[TM_SEGMENTS];
    LoopArray<ptrdiff_t> *first;
  };
  void search(const Rows &, const std::vector<int> &which, double spacing, const int *tag);
  double bytes() const;

 private:
  Backend &loops;
  tm_cells grid = {};
  double radius = 0.0;
  std::vector<int> cell, begin, index, marked;
  std::vector<tm_real> column[3];
};

}    // namespace SPHTM_NS

#endif
