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

// largest stable step of body contact for a type: 0.2 of the period of the stiffest pair
double PairSPHTM::contact_stiffness_limit(int t) const
{
  double limit = 0.0;
  for (int u = 1; u <= atom_types; u++) {
    const PairLaw &l = law(t, u);
    if (l.meeting != CONTACT) continue;
    const double e1 = material[t].young, e2 = material[u].young;
    const double k = tm_body_contact_stiffness(l.contact.penalty, e1, e2, set.spacing, least_spacing,
                                               domain->dimension == 3);
    const double mass = pow(least_spacing, domain->dimension) *
        std::min(material[t].rho0, material[u].rho0) * 0.5;
    const double dt = sqrt(mass / k);
    limit = limit > 0.0 ? std::min(limit, dt) : dt;
  }
  return limit;
}
