/* -*- c++ -*- ----------------------------------------------------------
   SPH-TM: compute cutting/force. Forces of a tool in the terms of cutting.
------------------------------------------------------------------------- */
#ifndef LMP_COMPUTE_CUTTING_FORCE_H
#define LMP_COMPUTE_CUTTING_FORCE_H

#include "compute.h"

#include <string>

namespace LAMMPS_NS {

class ComputeCuttingForce : public Compute {
 public:
  ComputeCuttingForce(class LAMMPS *, int, char **);
  ~ComputeCuttingForce() override;
  void init() override;
  void compute_vector() override;
  double compute_scalar() override;

 private:
  class FixContactTri *tool() const;          // looked up each time: it may be gone
  bool is_along(const double *unit) const;    // away

  std::string tool_id;
  bool direction_given = false;
  double direction[3] = {-1, 0, 0};    // of cutting: the way the tool goes through the work
  double away[3] = {0, 1, 0};          // out of the work
  bool warned = false;                 // that the tool moves along it
  double width = 1.0;
};

}    // namespace LAMMPS_NS

#endif
