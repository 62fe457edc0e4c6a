/* SPH-TM: rows of neighbors of static length: entry k of particle i is index[first[i] + k stride]. */
#ifndef SPHTM_ROW_TABLE_H
#define SPHTM_ROW_TABLE_H

#include "loop_array.h"
#include "tm_neighbors.h"

namespace SPHTM_NS {

struct RowTable {
  LoopArray<int> index, count[TM_SEGMENTS];
  LoopArray<ptrdiff_t> first;
  int capacity = 0, particles = 0;
  ptrdiff_t stride = 1;

  void move_to(Backend &);
  // keeps rows that are there, where the room is the same, and answers true; false: they are lost
  bool make_room(int n, int room);
  ptrdiff_t slots() const { return (particles + stride - 1) / stride * stride * capacity; }
  tm_rows loop_rows();
  tm_rows host_rows();
  double bytes() const;
};

}    // namespace SPHTM_NS

#endif
