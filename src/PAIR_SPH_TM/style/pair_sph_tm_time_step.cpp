/* SPH-TM: pair style sph/tm, what of the materials limits the time step. See fix_sph_tm_time_step.cpp. */
#include "pair_sph_tm.h"

#include "domain.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

bool PairSPHTM::has_contact_pairs() const
{
  return std::any_of(laws.begin(), laws.end(),
                     [](const PairLaw &l) { return l.meeting == CONTACT; });
}

double PairSPHTM::largest_conductivity() const
{
  double k = 0.0;
  for (const tm_material &m : material) {
    const tm_table &t = m.conductivity;
    k = std::max(k, t.n ? *std::max_element(t.y, t.y + t.n) : t.value);
  }
  return k;
}

// the largest stable step of the stiffest pair of particles in contact, of a type with all others
double PairSPHTM::contact_time_step(int t) const
{
  double limit = TM_DT_NO_LIMIT;
  for (int u = 1; u <= atom_types; u++) {
    const PairLaw &l = law(t, u);
    if (l.meeting != CONTACT) continue;
    const double e1 = material[t].young, e2 = material[u].young;
    const double k = tm_contact_stiffness(l.contact.penalty, e1, e2, set.spacing, least_spacing,
                                          domain->dimension == 3);
    const double mass = pow(least_spacing, domain->dimension) *
        std::min(material[t].rho0, material[u].rho0) * 0.5;
    limit = std::min(limit, tm_contact_time_step(k, mass, 0.0));
  }
  return limit;
}
