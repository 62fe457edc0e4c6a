#include "tool_temperature.h"

#include "error.h"
#include "input.h"
#include "lammps.h"
#include "update.h"
#include "variable.h"

#include <cmath>

namespace SPHTM_NS {

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
