/* SPH-TM: what pair style sph/tm hands its results to in a step that is audited. */
#ifndef SPHTM_STEP_AUDIT_H
#define SPHTM_STEP_AUDIT_H

#include "loop_array.h"

namespace SPHTM_NS {

class StepAudit {
 public:
  // results of the loops, on the host; nullptr: not in use
  struct InUse {
    const double *force, *gradient, *heat, *xsph;
    const double *turn;          // its antisymmetric part, with faces
    const double *correction;    // K of the force point, where the rate pass makes that of the next one
  };
  virtual LoopArray<double> &pair_force() = 0;    // room for the forces of the pairs alone
  virtual void audit(const InUse &) = 0;

 protected:
  ~StepAudit() = default;    // its owner knows what it is
};

}    // namespace SPHTM_NS

#endif
