#include "atom_arrays.h"

#include "atom.h"

namespace SPHTM_NS {

void AtomArrays::point_to(tm_state &s) { point_to_host(s); }

void AtomArrays::point_to_host(tm_state &s)
{
  s.x = atom->nmax ? &atom->x[0][0] : nullptr;
  s.v = atom->nmax ? &atom->v[0][0] : nullptr;
  s.force = atom->nmax ? &atom->f[0][0] : nullptr;
  s.type = atom->type;
  s.mask = atom->mask;
  s.mass = atom->mass;
  s.rmass = atom->rmass_flag ? atom->rmass : nullptr;
}

}    // namespace SPHTM_NS
