/* SPH-TM: how a tool moves: the formulas of tm_motion.h on a clock of its own, which began when the fix was made, or
   the values of equal-style variables. */
#ifndef SPHTM_TOOL_MOTION_H
#define SPHTM_TOOL_MOTION_H

#include "motion_command.h"

#include <cstdio>
#include <string>
#include <vector>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace SPHTM_NS {

class ToolMotion {
 public:
  explicit ToolMotion(LAMMPS_NS::LAMMPS *lmp);

  void set(const MotionCommand &);
  // find the variables (start of a run)
  void init();
  bool by_variable() const { return !names.empty(); }

  // variables: at set-up (dt = 0), and for the end of the step of length dt that begins
  void evaluate(double dt);
  void end_of_step(double dt);

  // pose at `ahead` after the start of the step; dt: the step's length
  tm_pose pose(double ahead, double dt) const;
  tm_pose pose_now() const { return pose(0.0, 0.0); }
  double clock() const { return time; }
  // largest speed of the points of a box (in the tool's frame)
  double top_speed(const double *lo, const double *hi) const;
  bool under_way(const double *lo, const double *hi) const;    // it has moved, and would go on
  bool goes_on(const tm_motion &given) const;                  // of a restart file, and given again
  // variables of displacement and of velocity that do not agree, on a way of this length: said once
  bool contradicts(double length);

  std::vector<double> pack() const;
  // of a restart file: valid until another motion is given; false: they cannot be
  bool unpack(double clock, const double *values);
  static constexpr int PACKED = 30;

 private:
  LAMMPS_NS::LAMMPS *lmp;
  tm_motion motion;
  double time = 0.0;                 // of the clock
  tm_pose base;                      // when the motion was given
  double start = 0.0;                // clock then
  std::vector<std::string> names;    // x y z vx vy vz, empty: NULL
  int variable[6];
  tm_vec3 moved, moved_next, rate;        // by variables
  double apart = 0.0, travelled = 0.0;    // way between both, and the way, where both are given
  bool contradicted = false;

  double value(int k) const;
  tm_vec3 displacement(tm_vec3 otherwise) const;
  void evaluate_now();
  void evaluate_next(double dt);
  void keep_if_restarted(const tm_motion &given);
  bool restarted = false, restarted_variable = false;
};

}    // namespace SPHTM_NS

#endif
