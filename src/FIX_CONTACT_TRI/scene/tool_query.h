/* SPH-TM: which surfaces of a tool particles touch, asked on the host outside the contact loop. */
#ifndef SPHTM_TOOL_QUERY_H
#define SPHTM_TOOL_QUERY_H

#include "contact_laws.h"
#include "tm_motion.h"
#include "tm_touch.h"

#include "atom.h"

namespace SPHTM_NS {

struct ToolQuery {
  const LAMMPS_NS::Atom &atom;
  int groupbit;
  const ContactLaws &laws;
  tm_tri_view mesh;
  tm_grid_view grid;
  tm_pose pose;
  double deep;    // how far behind the surface particles are found
  bool two_sided;

  bool in_contact(int i) const { return laws.of(atom.type[i]).active && (atom.mask[i] & groupbit); }
  double radius(int i) const { return laws.of(atom.type[i]).radius; }    // of owned particle i
  tm_vec3 local(tm_vec3 x) const { return tm_pose_to_local(&pose, x); }
  // contacts of a sphere about x, in the frame of the mesh; how many
  int touch(tm_vec3 x, double radius, tm_touch found[TM_TOUCH_MAX]) const
  {
    return tm_touch_find(&mesh, &grid, local(x), radius, deep, two_sided, tm_group_alone(), found);
  }
};

}    // namespace SPHTM_NS

#endif
