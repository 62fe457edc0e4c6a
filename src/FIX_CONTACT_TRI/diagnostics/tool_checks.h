/* SPH-TM: what fix contact/tri checks: extent, speed and jumps of the tool, its group, where its heat goes. */
#ifndef SPHTM_TOOL_CHECKS_H
#define SPHTM_TOOL_CHECKS_H

#include "contact_settings.h"
#include "tm_contact_sums.h"
#include "tool_motion.h"

namespace LAMMPS_NS {
class Fix;
}

namespace SPHTM_NS {

class Model;
class ParticleState;
struct ToolQuery;

class ToolChecks {
 public:
  ToolChecks(LAMMPS_NS::LAMMPS *, const LAMMPS_NS::Fix &, const ContactSettings &, const TriTool &);
  // start of a run
  void body_material(const Model &) const;
  void extent(double spacing) const;    // in 2d
  void empty_group();
  // particles that fill the tool are those in the groups of a tool of this filling
  void filling(int groups) const;
  // particles that only conduct heat, but for the fillings of tools (types): the tool does not reach them
  void conductors(const Model &, const std::vector<int> &fillings);
  void far_from_box(const tm_pose &, double spacing) const;    // or far larger, or lost in it: a unit is wrong
  void periodic(const tm_pose &) const;                        // in a box whose faces let particles through
  void heat_without_contact(bool moves, bool pressed);         // at the end of a run
  // at the end of a run in which nothing touched it; says whether metal outside of its group lies in its mesh
  void untouched(const ToolQuery &, const Model &) const;
  // where the process runs s times as fast: inertia of what the tool moves, over the flow stress
  void inertia(const Model &, double s, double speed, double temperature);
  // turns heat on as a state where the tool needs it, and warns where it cannot be
  void heat(ParticleState &);
  // a step: largest speed of the tool, sound speed of the particles (0: there are none)
  void speed(double speed, double sound_speed) const;
  // A tool that moves far in one step of length dt, whose end is given here, passes particles unseen or finds them deep
  // inside; dp: the smallest spacing
  void jump(const tm_pose &end, bool by_variable, double dt, double dp);
  void restarted_at(const tm_pose &);
  void left_out();    // of a run with 'pre no', since it was made after the last set-up
  // behind a step: particles too deep in the tool, or in it from two sides
  void pressed(const tm_contact_result &, double spacing);

 private:
  LAMMPS_NS::LAMMPS *lmp;
  const LAMMPS_NS::Fix &fix;
  const ContactSettings &set;
  const TriTool &tool;
  std::string who;
  bool warned_empty = false, warned_heat = false, warned_conductors = false, warned_no_contact = false,
       warned_inertia = false, warned_deep = false, warned_faced = false, warned_left_out = false;
  tm_vec3 last_corner[8];                 // of the mesh's box after the last step, here or before a restart
  bool seen = false, restored = false;    // there was one; before a restart

  void corners(const tm_pose &, tm_vec3 *) const;
  std::vector<int> types_in_group(const Model &, int body) const;
};

}    // namespace SPHTM_NS

#endif
