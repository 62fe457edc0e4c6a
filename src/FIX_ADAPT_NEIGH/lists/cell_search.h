/* SPH-TM: search of neighbors in cells (tm_cells.h, tm_search.h), for rows of particles of this rank. */
#ifndef SPHTM_CELL_SEARCH_H
#define SPHTM_CELL_SEARCH_H

#include "adapt_parts.h"
#include "loop_array.h"
#include "row_table.h"
#include "search_loops.h"

namespace SPHTM_NS {

class CellSearch {
 public:
  explicit CellSearch(AdaptParts &all) : parts(all) {}
  void move_to(Backend &);
  // where in a row particles of two types meet; true: some pairs exchange heat only or are in contact
  bool take_types();
  // grid of all particles at x, for a radius up to `widest`; radii: of each particle, or nullptr: all the widest;
  // marks: moved particles are counted
  void make_grid(double widest, const double *x, const double *radii = nullptr, bool marks = false);
  void sort_into_cells(const double *x);
  const tm_cells &grid() const { return cells; }
  // rows of these n particles (which: or the first n); returns the longest
  int search(RowTable &, int segments, double radius, int n, const int *which = nullptr);
  double bytes() const;

 private:
  AdaptParts &parts;
  Backend *backend = nullptr;
  const SearchLoops *loops = nullptr;
  LoopArray<unsigned char> meets;    // segments of each pair of types
  bool all_mechanical = true;        // all types are one continuum
  LoopArray<int> cell, begin, index, marked;
  LoopArray<tm_real> column[4], look[2];
  tm_cells cells = {};
};

}    // namespace SPHTM_NS

#endif
