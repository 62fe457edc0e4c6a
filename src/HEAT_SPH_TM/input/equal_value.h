/* SPH-TM: a value of a fix command that is a number or an equal-style variable. */
#ifndef SPHTM_EQUAL_VALUE_H
#define SPHTM_EQUAL_VALUE_H

#include <string>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace SPHTM_NS {

class EqualValue {
 public:
  // what names the value in messages, e.g. "Fix sph/tm/heat flux"
  void set(LAMMPS_NS::LAMMPS *lmp, const std::string &what, const char *text);
  void init();     // finds the variable; stops when there is none of equal style
  double now();    // between clearstep_compute and addstep_compute when it varies
  bool varies() const { return !name.empty(); }

 private:
  LAMMPS_NS::LAMMPS *lmp = nullptr;
  std::string what, name;
  double number = 0.0;
  int index = -1;
};

}    // namespace SPHTM_NS

#endif
