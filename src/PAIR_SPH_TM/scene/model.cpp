#include "model.h"

#include "body_contact_laws.h"

#include "comm.h"
#include "domain.h"
#include "error.h"
#include "lattice.h"
#include "utils.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

const char *kernel_name(int kernel)
{
  static const char *const names[TM_KERNEL_COUNT] = {"hyperbolic", "cubic", "quintic", "wendland/c2", "wendland/c4"};
  return names[kernel];
}

Model::Tables::Tables(Backend &loops)
{
  material.live_in(loops);
  for (auto *a : {&conductance, &effusivity, &gradient, &share}) a->live_in(loops);
  law.live_in(loops);
  side.live_in(loops);
  strains.live_in(loops);
}

Model::Model(LAMMPS *lmp, Backend &loops) : Pointers(lmp), tables(loops) {}

/* ---------------------------------------------------------------------- what the pair style reads */

void Model::resize(int types)
{
  atom_types = types;
  const size_t n = (size_t) types + 1;
  material.assign(n, tm_material{});
  given = material;
  names.assign(n, "");
  laws.resize(types);
}

void Model::set_material(int type, const tm_material &m, const std::string &name)
{
  unit = unit_scale(lmp);
  material[type] = given[type] = m;
  names[type] = name;
}

void Model::set_time_scale(double s)
{
  times_as_fast = s;
  for (size_t t = 0; t < material.size(); t++) {
    tm_material &m = material[t];
    m = given[t];
    if (s == 1.0) continue;
    m.conductivity.value *= s;
    for (int k = 0; k < m.conductivity.n; k++) m.conductivity.y[k] *= s;
    m.jc_rate0 *= s;
    m.za_rate0 *= s;
  }
}

// pairs of elastic types whose contact is softer than the half spacing on either side of it, in words
static std::string soft_contacts(const Model &model)
{
  std::string soft;
  const tm_material *material = model.materials();
  for (int i = 1; i <= model.types(); i++)
    for (int j = i; j <= model.types(); j++) {
      const PairLaw &l = model.pair_laws()(i, j);
      if (l.meeting != CONTACT) continue;
      double right = 0.0, layers = 0.0;    // compliance per area and spacing
      bool elastic = true;
      for (const int t : {i, j}) {
        elastic = elastic && tm_strength_flow(material[t].strength) == TM_FLOW_NONE;
        right += 1.0 / model.contact_modulus(t, TM_PENALTY_MATERIAL);
        layers += 1.0 / model.contact_modulus(t, l.penalty);
      }
      if (elastic && layers > TM_SOFT_CONTACT * right)
        soft += fmt::format("{}{} and {} ({:.2g} times)", soft.empty() ? "" : ", ", i, j, layers / right);
    }
  return soft;
}

void Model::complete_laws()
{
  for (int i = 1; i <= atom_types; i++)
    for (int j = i; j <= atom_types; j++) {
      const Meeting m = laws(i, j).meeting;
      const bool heat = material[i].body == TM_BODY_HEAT || material[j].body == TM_BODY_HEAT;
      if (heat && (m == BOND || m == CONTACT))
        error->all(FLERR,
                   "Pair sph/tm coeff {} {}: a conduction-only material (body heat) takes no part in mechanics; use "
                   "'heat' or 'none'",
                   i, j);
    }
  const auto listed = [](const std::vector<std::pair<int, int>> &pairs) {
    std::string text;
    for (const auto &ij : pairs) text += fmt::format("{}{} and {}", text.empty() ? "" : ", ", ij.first, ij.second);
    return text;
  };
  const std::string welded = listed(laws.complete(material.data())), passing = listed(laws.that_pass(material.data()));
  if (!passing.empty() && comm->me == 0)
    utils::logmesg(lmp,
                   "sph/tm: types {} pass through each other (none or heat: no forces); 'pair_coeff i j contact' "
                   "makes two bodies of them that do not\n",
                   passing);
  if (!welded.empty() && comm->me == 0)
    utils::logmesg(lmp,
                   "sph/tm: types {} are one body where they touch (bond, the default); 'pair_coeff i j contact' "
                   "makes two bodies of them\n",
                   welded);
  const std::string soft = said_soft_contact ? "" : soft_contacts(*this);
  if (soft.empty() || comm->me) return;
  said_soft_contact = true;
  utils::logmesg(lmp,
                 "sph/tm: contact of types {} is softer than the elastic material at it: where few spacings touch, "
                 "'penalty material' is as stiff as elastic contact is\n",
                 soft);
}

/* ---------------------------------------------------------------------- before a run */

void Model::prepare()
{
  unit = unit_scale(lmp);
  lattice = tm_lattice_sums(settings.kernel, domain->dimension, settings.ratio);
  heat_rate = lattice.heat_rate;
  list_h = settings.h;
  least_spacing = settings.spacing;
  of_bodies = tm_body_surface_make(domain->dimension, tm_kernel_support(settings.kernel) * settings.ratio);
  surface = tm_surface_make(settings.kernel, domain->dimension, settings.spacing, settings.h, TM_SURFACE_THRESHOLD);
}

void Model::make_tables(double temperature)
{
  const int n = atom_types + 1;
  std::vector<double> conductance(n * n), effusivity(n);
  std::vector<tm_body_law> contact(n * n);
  std::vector<int> side;
  most_sides = laws.contact_sides(side);
  bool conducts = false;
  for (int k = 0; k < n * n; k++) {
    const PairLaw &law = laws(k / n, k % n);
    conductance[k] = law.conductance > 0.0 ? times_as_fast * law.conductance * lattice.interface * lattice.gradient
                                           : 0.0;
    conducts = conducts || conductance[k] > 0.0;
    contact[k] = law.contact;
    if (law.meeting == CONTACT) contact[k].modulus = contact_modulus_of_two(*this, k / n, k % n);
  }
  std::vector<int> strains((size_t) n * most_sides, 0);
  bool any = false;
  for (int k = 0; k < n * n; k++) {
    if (!side[k] || !layer_strains(*this, k / n, laws(k / n, k % n))) continue;
    strains[k / n * most_sides + side[k] - 1] = 1;
    any = true;
  }
  for (int t = 1; t < n; t++) {
    const tm_material &m = material[t];
    effusivity[t] =
        m.heat ? tm_effusivity(tm_conductivity(&m, temperature), tm_table_at(&m.capacity, temperature), m.rho0) : 0.0;
  }
  tables.material.assign(material.data(), n);
  tables.conductance.assign(conductance.data(), conducts ? n * n : 0);
  tables.law.assign(contact.data(), n * n);
  tables.side.assign(side.data(), n * n);
  tables.strains.assign(strains.data(), any ? strains.size() : 0);
  tables.effusivity.assign(effusivity.data(), n);
  std::vector<double> share(settings.art_balanced && settings.art_eps > 0.0 ? TM_GRADIENT_ENTRIES : 0);
  if (!share.empty()) tm_tensile_table(settings.kernel, domain->dimension, settings.art_n, share.data());
  tables.share.assign(share.data(), share.size());
}

void Model::set_compression_heat(bool heats, double temperature)
{
  for (tm_material &m : material) tm_set_compression_heat(&m, heats, temperature);
  tables.material.assign(material.data(), material.size());
}

void Model::cover_sizes(double h, double dp)
{
  const int dim = domain->dimension;
  list_h = h;
  least_spacing = dp;
  // of a lattice that is fine within the kernel, the limit of large h/spacing
  heat_rate = std::max(lattice.heat_rate, tm_lattice_sums(settings.kernel, dim, 3.0).heat_rate);
  if (!tables.gradient.empty()) return;
  double table[TM_GRADIENT_ENTRIES];
  tm_gradient_table(settings.kernel, dim, table);
  tables.gradient.assign(table, TM_GRADIENT_ENTRIES);
}

/* ---------------------------------------------------------------------- what follows from it */

double Model::particle_mass(int type) const { return material[type].rho0 * pow(settings.spacing, domain->dimension); }

double Model::contact_modulus(int type, double penalty) const
{
  const tm_material &m = material[type];
  const double c = tm_eos_sound_speed(&m, m.rho0, 0.0);
  const double confined = settings.plane_stress ? m.young / (1.0 - m.poisson * m.poisson) : m.rho0 * c * c;
  return tm_contact_modulus(penalty, m.young, tm_contact_half_layer(confined), m.strength == TM_STRENGTH_ELASTIC);
}

double Model::largest_conductivity() const
{
  double k = 0.0;
  for (const tm_material &m : material) {
    const tm_table &t = m.conductivity;
    k = std::max(k, t.n ? *std::max_element(t.y, t.y + t.n) : t.value);
  }
  return k;
}

double Model::contact_time_step(int t) const
{
  double least = TM_DT_NO_LIMIT;
  for (int u = 1; u <= atom_types; u++) {
    const PairLaw &l = laws(t, u);
    if (l.meeting != CONTACT) continue;
    const double of_two = contact_modulus_of_two(*this, t, u);
    const double k = tm_contact_stiffness(of_two, settings.spacing, least_spacing, domain->dimension == 3);
    const bool strains = layer_strains(*this, t, l) ||
                         layer_strains(*this, u, l);    // then the force acts on the next rows too
    const double mass = pow(least_spacing, domain->dimension) * std::min(material[t].rho0, material[u].rho0) * 0.5 /
                        (strains ? TM_LAYER_MOBILITY : 1.0);
    least = std::min(least, tm_contact_time_step(k, mass, 0.0));
  }
  return least;
}

double Model::lattice_spacing(LAMMPS *lmp)
{
  Lattice *lattice = lmp->domain->lattice;
  if (!lattice || lattice->style == Lattice::NONE) return 0.0;
  tm_vec3 edge[3], origin = tm_vec(0, 0, 0);
  lattice->lattice2box(origin.x, origin.y, origin.z);
  for (int k = 0; k < 3; k++) {
    edge[k] = tm_vec(k == 0, k == 1, k == 2);
    lattice->lattice2box(edge[k].x, edge[k].y, edge[k].z);
    edge[k] = tm_vec_sub(edge[k], origin);
  }
  const tm_vec3 face = tm_vec_cross(edge[0], edge[1]);
  if (lmp->domain->dimension == 2) return sqrt(fabs(face.z) / lattice->nbasis);
  return cbrt(fabs(tm_vec_dot(face, edge[2])) / lattice->nbasis);
}

}    // namespace SPHTM_NS
