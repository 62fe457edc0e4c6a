/* SPH-TM: LAMMPS's fix ave/time with Kokkos. */
#ifdef LMP_KOKKOS
#include "fix_ave_time_kokkos.h"

#include "atom_masks.h"
#include "compute.h"
#include "modify.h"

#include <algorithm>

using namespace LAMMPS_NS;

FixAveTimeKokkos::FixAveTimeKokkos(LAMMPS *lmp, int narg, char **arg) : FixAveTime(lmp, narg, arg)
{
  for (int k = 6; k < narg; k++) {
    const std::string word = arg[k];
    const bool input = word.size() > 2 && word[1] == '_' && std::string("cfv").find(word[0]) != std::string::npos;
    if (!input) break;    // keywords follow the values
    inputs.push_back(word.substr(0, word.find('[')));
  }
}

void FixAveTimeKokkos::init()
{
  FixAveTime::init();
  const bool host = std::any_of(inputs.begin(), inputs.end(), [this](const std::string &s) { return needs_host(s); });
  kokkosable = !host;    // or LAMMPS takes the host's particles for the newer ones while values are asked for
  datamask_read = host ? ALL_MASK : EMPTY_MASK;
  datamask_modify = EMPTY_MASK;
}

// styles with Kokkos bring what they need to where they work; a force on a tool is a sum
bool FixAveTimeKokkos::needs_host(const std::string &input) const
{
  const std::string name = input.substr(2);
  if (input[0] == 'c') {
    const Compute *c = modify->get_compute_by_id(name);
    return !c || !(c->kokkosable || utils::strmatch(c->style, "^cutting/force"));
  }
  if (input[0] == 'f') {
    const Fix *f = modify->get_fix_by_id(name);
    return !f || !f->kokkosable;
  }
  return true;
}
#endif
