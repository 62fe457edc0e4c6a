#include "atom_arrays.h"

#include "atom.h"
#include "region.h"

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

void AtomArrays::match(LAMMPS_NS::Region &region, int *inside) const
{
  double **x = atom->x;
  for (int i = 0; i < atom->nlocal; i++) inside[i] = region.match(x[i][0], x[i][1], x[i][2]);
}

const int *AtomArrays::inside(LAMMPS_NS::Region &region)
{
  matches.resize(atom->nlocal + 1);
  region.prematch();
  match(region, matches.data());
  return matches.data();
}

}    // namespace SPHTM_NS
