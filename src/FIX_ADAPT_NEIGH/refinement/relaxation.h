/* SPH-TM: refinement, relaxation of positions about a split or merge (option settle).

   Where particles of two sizes meet, sum_j V_j gradW is not 0, and uniform stress makes forces. In a fluid, pressure
   would relax the positions; so do a few sweeps of x_i -= 0.3 h_i^2 sum_j V_j gradW_ij. State moves with its gradient.
   Linear momentum is conserved; the angular momentum that the displacements would add is taken out as a rotation. */
#ifndef SPHTM_RELAXATION_H
#define SPHTM_RELAXATION_H

#include "refine_step.h"

namespace SPHTM_NS {

class Relaxation : public RefineStep {
 public:
  using RefineStep::RefineStep;
  void run();    // of fresh particles, which are then no longer so

 private:
  struct Moved;
  std::vector<tm_vec3> displacements(std::vector<char> &moves);
  Moved measure(const std::vector<char> &moves, const std::vector<tm_vec3> &shift);
};

}    // namespace SPHTM_NS

#endif
