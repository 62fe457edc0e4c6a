/* SPH-TM: arguments of the loops that move the particles, from their state and the results of a step. */
#ifndef SPHTM_STEP_ARGS_H
#define SPHTM_STEP_ARGS_H

#include "tm_drift.h"
#include "tm_update.h"

namespace LAMMPS_NS {
class Domain;
class Modify;
}    // namespace LAMMPS_NS

namespace SPHTM_NS {

class ParticleState;
class StepResults;

tm_drift_args drift_args(ParticleState &, const LAMMPS_NS::Domain &);
// limits of what goes on (hottest, densest) are infinite, nothing watches for melting, and no groups are held
tm_update_args update_args(ParticleState &, StepResults &);
// groups whose particles another fix moves or holds: their positions are its own, and are not shifted
int held_groups(LAMMPS_NS::Modify &);

}    // namespace SPHTM_NS

#endif
