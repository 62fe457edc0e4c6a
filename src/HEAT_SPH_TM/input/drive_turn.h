/* SPH-TM: the turn of fix sph/tm/drive: an axis, the point that it goes through and an angular velocity. */
#ifndef SPHTM_DRIVE_TURN_H
#define SPHTM_DRIVE_TURN_H

#include "equal_value.h"
#include "tm_dirichlet.h"

#include <vector>

namespace SPHTM_NS {

class DriveTurn {
 public:
  // of the words after the keyword rotate, Px Py Pz Rx Ry Rz omega; given: which components of the velocity are; who: of messages
  void set(LAMMPS_NS::LAMMPS *lmp, const std::string &who, int words, char **word, const bool *given);
  bool turns() const { return to.turns; }
  bool varies() const { return rate.varies(); }
  void init() { rate.init(); }
  double now() { return turns() ? rate.now() : 0.0; }    // angular velocity, radians per time

  // of the group in LAMMPS's positions (collective): the largest distance from the axis
  double radius(int groupbit) const;

  // as the axis is before the step, and at its end: dt later, with its velocity and the angular velocity there
  tm_drive_turn at_start() const;
  tm_drive_turn step(double dt, const double *velocity, double omega);
  double angle() const { return turned; }    // radians so far

  // what a restart needs
  static constexpr int NUMBERS = 8;
  void append_to(std::vector<double> &) const;
  void take_from(const double *);

 private:
  LAMMPS_NS::LAMMPS *lmp = nullptr;
  EqualValue rate;
  tm_drive_turn to = {};
  double turned = 0.0, path[3] = {0.0, 0.0, 0.0};    // angle, and way of the point, so far
  double last[4] = {0.0, 0.0, 0.0, 0.0};             // velocity and angular velocity at the end of the last step
};

}    // namespace SPHTM_NS

#endif
