/* SPH-TM: the interior and the boundary of a processor's particles (tm_boundary.h): rates of the interior are computed while
   records of ghosts travel. */
#ifndef SPHTM_INTERIOR_H
#define SPHTM_INTERIOR_H

#include "active_loops.h"
#include "loop_array.h"
#include "pair_loops.h"

namespace SPHTM_NS {

class Interior {
 public:
  explicit Interior(Backend &);
  void sort(const tm_rows &, int owned);    // at renewed lists
  void forget() { sorted = -1; }
  bool known(int owned) const { return sorted == owned; }
  // loops over the one and the other
  Backend &inside() { return interior; }
  Backend &boundary() { return edge; }
  double bytes() const { return of_interior.bytes() + of_edge.bytes() + marks.bytes(); }

 private:
  Backend &loops;
  ActiveLoops interior, edge;
  LoopArray<int> of_interior, of_edge;
  LoopArray<unsigned char> marks;
  int sorted = -1;

  void list(const tm_boundary_args &, ActiveLoops &, LoopArray<int> &);
};

}    // namespace SPHTM_NS

#endif
