/* SPH-TM: a tool that starts inside the work would throw its particles away: the run stops, and says where they are and
   the shortest way along an axis that clears all of them. And whether an open one has its back to them. */
#ifndef SPHTM_OVERLAP_CHECK_H
#define SPHTM_OVERLAP_CHECK_H

#include "tool_query.h"

#include <string>

namespace SPHTM_NS {

class OverlapCheck {
 public:
  // of the particles of all ranks; penetrations up to `allowed` spacings pass
  OverlapCheck(LAMMPS_NS::LAMMPS *, const ToolQuery &, double spacing, double allowed);
  // an error in the name of who, where there is an overlap; collective. closed: a mesh that may have particles deeper
  // inside than contact sees, or nullptr; flipped: by 'flip yes'
  void stop(const std::string &who, const tm_mesh *closed, bool flipped) const;
  // does an open mesh turn its back to all particles? Some of them are asked; collective
  bool faces_away() const;

 private:
  LAMMPS_NS::LAMMPS *lmp;
  const ToolQuery &query;
  double spacing, allowed;

  bool overlaps(tm_vec3 shift, int *worst) const;
  double way_out(tm_vec3 direction, double limit) const;
  std::string remedy() const;
  int samples() const;    // of the particles of this rank: as many as some tenths of a second allow
  int sample_inside(const tm_mesh &) const;
};

}    // namespace SPHTM_NS

#endif
