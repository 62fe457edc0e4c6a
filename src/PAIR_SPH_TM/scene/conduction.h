/* SPH-TM: heat conduction over a step that is longer than the explicit scheme bears, in stages (tm_conduct.h). Pair
   style sph/tm owns it and gives it the rows of each step; fix sph/tm runs it before the update. */
#ifndef SPHTM_CONDUCTION_H
#define SPHTM_CONDUCTION_H

#include "loop_array.h"
#include "pair_loops.h"

#include "pointers.h"

namespace LAMMPS_NS {
class Pair;
}

namespace SPHTM_NS {

class ParticleState;
class StepResults;

class Conduction : protected LAMMPS_NS::Pointers {
 public:
  Conduction(LAMMPS_NS::LAMMPS *, LAMMPS_NS::Pair *, Backend &, StepResults &);

  // rows of this step: mechanical neighbors; those that only exchange heat
  void set_rows(const tm_rows &mechanical, const tm_rows &others);
  void advance(ParticleState &);                // the mean conduction over the step becomes its result
  int stages() const { return last_stages; }    // of the last step that had any, else 1
  void begin_run() { last_stages = 1; }

 private:
  LAMMPS_NS::Pair *pair;
  Backend &backend;
  const PairLoops &loops;
  StepResults &results;
  tm_rows mechanical = {}, others = {};
  LoopArray<int> index, count;
  LoopArray<tm_real> g, capacity, power, first, F[2], T[2];
  int last_stages = 1;

  void make_room(tm_conduct_args &);
  void communicate(LoopArray<tm_real> &);
};

}    // namespace SPHTM_NS

#endif
