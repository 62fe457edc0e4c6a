/* SPH-TM: what the triangles of a tool receive in one step: force, heat and the number of contacts. */
#ifndef SPHTM_TRIANGLE_VALUES_H
#define SPHTM_TRIANGLE_VALUES_H

#include "loop_array.h"
#include "tm_contact_tri.h"

#include <mpi.h>

namespace SPHTM_NS {

class TriangleValues {
 public:
  void live_in(Backend &);
  void hand_to(tm_contact_args &, size_t triangles);         // zeros, to which the loop adds
  void sum_over_ranks(MPI_Comm world, double power_unit);    // on the first one; collective
  // of the host, after that; in the unit style
  const double *force() { return tri_force.host_read(); }    // 3 of each, on the tool
  const double *heat() { return tri_heat.host_read(); }      // power into the tool
  const int *contacts() { return tri_count.host_read(); }
  double bytes() const { return (double) (tri_force.bytes() + tri_heat.bytes() + tri_count.bytes()); }

 private:
  Backend *loops = nullptr;
  LoopArray<double> tri_force, tri_heat;
  LoopArray<int> tri_count;
};

}    // namespace SPHTM_NS

#endif
