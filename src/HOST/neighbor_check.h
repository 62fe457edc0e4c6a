/* SPH-TM: LAMMPS looks in every step whether a particle has moved by half of the skin since the lists were made. Where
   the largest speed says that none can have, the look is left out: on a GPU the host waits for it. The lists are
   renewed in the same steps as without. */
#ifndef SPHTM_NEIGHBOR_CHECK_H
#define SPHTM_NEIGHBOR_CHECK_H

#include "pointers.h"

namespace SPHTM_NS {

class NeighborCheck : protected LAMMPS_NS::Pointers {
 public:
  explicit NeighborCheck(LAMMPS_NS::LAMMPS *l) : Pointers(l) {}
  ~NeighborCheck() override { end_run(); }

  void begin_run();    // after the set-up has made the lists
  void end_run();      // particles may be moved from now on

  // In this order in a step. way: no particle goes further
  void before_lists(double way);    // on the way to where the lists are used
  void of_tool(double way);         // the same, of particles that are moved with a tool
  void lists_renewed();
  void after_lists(double way);

 private:
  bool watching = false;     // in this run
  int delay_of_user = 0;     // neigh_modify delay
  double particles = 0.0;    // their way since the lists were made, at most; infinite: not known
  double tools = 0.0;

  bool others_move() const;
  void decide();
};

}    // namespace SPHTM_NS

#endif
