/* SPH-TM: arguments of the loops that move the particles, from their state and the results of a step. */
#ifndef SPHTM_STEP_ARGS_H
#define SPHTM_STEP_ARGS_H

#include "tm_drift.h"
#include "tm_update.h"

namespace LAMMPS_NS {
class Domain;
}

namespace SPHTM_NS {

class ParticleState;
class StepResults;

tm_drift_args drift_args(ParticleState &, const LAMMPS_NS::Domain &);
// limits of what goes on (hottest, densest) are infinite, and nothing watches for melting
tm_update_args update_args(ParticleState &, StepResults &);

}    // namespace SPHTM_NS

#endif
