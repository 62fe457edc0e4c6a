#include "equal_value.h"

#include "error.h"
#include "input.h"
#include "lammps.h"
#include "utils.h"
#include "variable.h"

#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

void EqualValue::set(LAMMPS *l, const std::string &title, const char *text)
{
  lmp = l;
  what = title;
  name.clear();
  if (strncmp(text, "v_", 2) == 0) {
    name = text + 2;
    init();    // a missing variable is an error of this line
    return;
  }
  if (!utils::is_double(text)) lmp->error->all(FLERR, "{} must be a number or v_name, got {}", what, text);
  number = utils::numeric(FLERR, text, false, lmp);
  if (!std::isfinite(number)) lmp->error->all(FLERR, "{} must be finite, got {}", what, text);
}

void EqualValue::init()
{
  if (!varies()) return;
  index = lmp->input->variable->find(name.c_str());
  if (index < 0) lmp->error->all(FLERR, "{}: there is no variable {}", what, name);
  if (!lmp->input->variable->equalstyle(index))
    lmp->error->all(FLERR, "{}: variable {} is not of equal style", what, name);
}

double EqualValue::now()
{
  if (!varies()) return number;
  const double value = lmp->input->variable->compute_equal(index);
  if (!std::isfinite(value)) lmp->error->all(FLERR, "{}: variable {} is not finite", what, name);
  return value;
}

}    // namespace SPHTM_NS
