#include "friction_table.h"

#include "argument.h"

#include "error.h"
#include "lammps.h"
#include "utils.h"

using namespace LAMMPS_NS;

namespace SPHTM_NS {

tm_table read_friction_table(LAMMPS *lmp, Keywords &k)
{
  tm_table t = {};
  for (; k.number_ahead(); t.n++) {
    if (t.n == TM_TABLE_MAX) lmp->error->all(FLERR, "{} takes at most {} pairs", k.what(), TM_TABLE_MAX);
    t.t[t.n] = k.number("temperature");
    if (t.n && t.t[t.n] <= t.t[t.n - 1])
      lmp->error->all(FLERR, "{}: temperatures must increase, got {} after {}", k.what(), t.t[t.n], t.t[t.n - 1]);
    t.y[t.n] = k.not_negative("coefficient");
  }
  if (t.n == 0) lmp->error->all(FLERR, "{} must read: T1 mu1 T2 mu2 ...", k.what());
  if (t.n > 1 && t.t[0] > 0.0) warn_of_celsius(lmp, k.what() + ": the first temperature", t.t[0]);
  return t;
}

}    // namespace SPHTM_NS
