/* SPH-TM: temperature of a tool (K): a number, the value of an equal-style variable, or that of a lumped heat
   capacity. */
#ifndef SPHTM_TOOL_TEMPERATURE_H
#define SPHTM_TOOL_TEMPERATURE_H

#include "contact_settings.h"

namespace SPHTM_NS {

class ToolTemperature {
 public:
  explicit ToolTemperature(const ContactSettings &set) :
      value(set.temperature), capacity(set.lumped_capacity), variable(set.temperature_variable),
      given(set.temperature_given)
  {
  }
  double now() const { return value; }    // 0: not known yet
  bool by_variable() const { return !variable.empty(); }
  // that of the particles at the start, where none was given
  void begin(double T) { value = given ? value : T; }
  // the number of a restart file
  void restore(double T)
  {
    value = T;
    given = true;
  }
  // that of a command, instead of the variable
  void set(double T)
  {
    restore(T);
    variable.clear();
  }
  void evaluate(LAMMPS_NS::LAMMPS *, const std::string &who);    // of the variable
  // lumped: heat in mass length^2/time^2, its unit over that of the unit style
  void absorb(double heat, double unit) { value += heat / (capacity * unit); }

 private:
  double value, capacity;
  std::string variable;
  bool given;
};

}    // namespace SPHTM_NS

#endif
