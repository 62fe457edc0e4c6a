/* SPH-TM: particles that lose their neighbors on one side though nothing has failed, tm_fracture.h: counted every so
   many steps; the first one is reported, and the number of all at the end of a run. The first time that faces of one body meet
   is reported too. */
#ifndef SPHTM_FRACTURE_WATCH_H
#define SPHTM_FRACTURE_WATCH_H

#include "loop_array.h"
#include "pair_loops.h"

#include "lmptype.h"
#include "pointers.h"

#include <string>

namespace LAMMPS_NS {
class Pair;
}

namespace SPHTM_NS {

class ParticleState;
class Scene;

class FractureWatch : protected LAMMPS_NS::Pointers {
 public:
  FractureWatch(LAMMPS_NS::LAMMPS *, ParticleState &, const Scene &);

  // collective, after the forces of a step. begin: at a set-up, references alone, where there are none
  void begin(LAMMPS_NS::Pair *);
  void look(LAMMPS_NS::Pair *);
  double torn();    // how many particles; collective
  std::string in_words();
  std::string failed_in_words();    // how many particles damage has failed; collective

 private:
  ParticleState &state;
  const Scene &scene;
  LoopArray<tm_real> known;
  double period[3] = {};
  LAMMPS_NS::bigint particles = -1;    // when the references were taken
  long remapped = 0;
  bool reported = false, meeting_reported = false;
  std::string first;    // of the first one

  tm_fracture_args args();
  void tell(LAMMPS_NS::Pair *);
  bool refer(LAMMPS_NS::Pair *);    // anew, where particles came or went; whether
  std::string particle(int tag);    // when and where, for all ranks
  void report(int tag);
  void report_meeting(int tag, int other);
};

}    // namespace SPHTM_NS

#endif
