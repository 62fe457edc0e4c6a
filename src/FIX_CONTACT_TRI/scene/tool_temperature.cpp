#include "tool_temperature.h"

#include "error.h"
#include "input.h"
#include "lammps.h"
#include "update.h"
#include "variable.h"

#include <cmath>

namespace SPHTM_NS {

ToolTemperature::ToolTemperature(const ContactSettings &set) :
    value(set.temperature), capacity(set.lumped_capacity), variable(set.temperature_variable),
    given(set.temperature_given)
{
}

void ToolTemperature::restore(double T)
{
  value = T;
  given = true;
}

void ToolTemperature::set(double T)
{
  restore(T);
  variable.clear();
}

void ToolTemperature::evaluate(LAMMPS_NS::LAMMPS *lmp, const std::string &who)
{
  LAMMPS_NS::Variable *variables = lmp->input->variable;
  const int k = variables->find(variable.c_str());
  if (k < 0 || !variables->equalstyle(k))
    lmp->error->all(FLERR, "{} temperature: no equal-style variable {}", who, variable);
  value = variables->compute_equal(k);
  if (!(value > 0.0 && std::isfinite(value)))
    lmp->error->all(FLERR, "{} temperature: variable {} is {} at step {}; it must be a positive number", who, variable,
                    value, lmp->update->ntimestep);
}

}    // namespace SPHTM_NS
