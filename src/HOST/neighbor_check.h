/* SPH-TM: LAMMPS looks in every step whether a particle has moved by half of the skin since the lists were made. Where
   the largest speed says that none can have, the look is left out: on a GPU the host waits for it. The lists are
   renewed in the same steps as without. Where LAMMPS is told not to look, lists that come too late are warned of. */
#ifndef SPHTM_NEIGHBOR_CHECK_H
#define SPHTM_NEIGHBOR_CHECK_H

#include "pointers.h"

namespace SPHTM_NS {

class NeighborCheck : protected LAMMPS_NS::Pointers {
 public:
  explicit NeighborCheck(LAMMPS_NS::LAMMPS *l) : Pointers(l) {}
  ~NeighborCheck() override { end_run(); }

  // after the set-up has made the lists; speed2: square of the largest speed on this rank; shifted: particles also move
  // otherwise than with their velocity
  void begin_run(double speed2, bool shifted);
  void end_run();    // particles may be moved from now on

  // in this order in a step
  void before_lists(double time);    // which particles move to where the lists are used
  void of_tool(double way);          // the same, of particles that are moved with a tool
  void lists_renewed();
  void after_lists(double speed2, double time);    // with the new velocities

 private:
  bool watching = false;               // in this run
  bool blind = false, told = false;    // LAMMPS is told not to look (neigh_modify check no); that the lists were late
  int delay_of_user = 0;               // neigh_modify delay
  double particles = 0.0;              // their way since the lists were made, at most; infinite: not known
  double tools = 0.0;

  double speed = 0.0;    // of the fastest particle, of all ranks

  void set_speed(double speed2);
  bool others_move() const;
  void decide();
};

}    // namespace SPHTM_NS

#endif
