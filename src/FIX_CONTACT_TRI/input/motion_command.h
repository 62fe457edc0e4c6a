/* SPH-TM: the arguments of fix_modify move of a tool. */
#ifndef SPHTM_MOTION_COMMAND_H
#define SPHTM_MOTION_COMMAND_H

#include "tm_motion.h"

#include <string>
#include <vector>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace SPHTM_NS {

struct MotionCommand {
  tm_motion motion;
  std::vector<std::string> variables;    // x y z vx vy vz, empty: NULL; none: the motion is a formula
  int words;                             // that were read
};

// those after `move`; a list of surfaces, as fix surface/global has it there, must have the number of this one
MotionCommand read_motion(LAMMPS_NS::LAMMPS *, int surface, int narg, char **arg);

}    // namespace SPHTM_NS

#endif
