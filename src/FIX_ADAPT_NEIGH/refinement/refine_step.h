/* SPH-TM: what the steps of refinement (split, merge, relaxation) work with. */
#ifndef SPHTM_REFINE_STEP_H
#define SPHTM_REFINE_STEP_H

#include "refine_levels.h"
#include "remap.h"

namespace SPHTM_NS {

class RefineStep {
 public:
  RefineStep(AdaptParts &all, const RefineInput &input, Cloud &table, Remap &r, RefineLevels &l) :
      parts(all), in(input), cloud(table), remap(r), levels(l)
  {
  }

 protected:
  AdaptParts &parts;
  const RefineInput &in;
  Cloud &cloud;
  Remap &remap;
  RefineLevels &levels;
};

}    // namespace SPHTM_NS

#endif
