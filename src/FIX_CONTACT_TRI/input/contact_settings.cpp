#include "contact_settings.h"

#include "argument.h"
#include "friction_table.h"
#include "restart_block.h"

#include "atom.h"
#include "error.h"
#include "force.h"
#include "lammps.h"
#include "utils.h"

#include <cstring>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

static const char *const KEYWORDS =
    "file, input, scale, move, rotate, friction, friction/table, friction/shear, penalty, layer, damping, "
    "approach, method, sides, heat, temperature, lumped, share, effusivity, material, particles, reference, "
    "vtk, stl, local, flip, merge, smooth, maxsize, overlap";

// as of LAMMPS's fix surface/global: stl TYPE MOL FILE; its types and molecule IDs tell surfaces apart, and here is one
void ContactSettings::read_input(Keywords &k)
{
  if (!k.take("stl"))
    lmp->error->all(FLERR, "{} must read: input stl type mol file, got {}", k.what(), k.rest() ? k.value() : "nothing");
  k.need(3);
  k.integer(1, MAXSMALLINT, "type");
  surface = k.integer(1, MAXSMALLINT, "mol");
  read_file(k);
}

void ContactSettings::read_file(Keywords &k)
{
  const std::string name = k.value();
  if (!shape.file.empty())
    lmp->error->all(FLERR,
                    "{}: a tool has one mesh, and {} comes behind {}; give each file a fix contact/tri of its own",
                    k.what(), name, shape.file);
  shape.file = name;
}

bool ContactSettings::read_mesh(Keywords &k)
{
  if (k.is("file")) read_file(k);
  else if (k.is("input")) read_input(k);
  else if (k.is("flip")) shape.flip = k.yes();
  else if (k.is("merge")) shape.options.tolerance = k.between(0.0, 0.01);
  else if (k.is("maxsize")) shape.max_bytes = 1000000 * (size_t) k.integer(1, 1000000, "(MB)");
  else if (k.is("smooth")) shape.options.smooth_angle = k.between(0.0, 90.0);
  else return false;
  return true;
}

bool ContactSettings::read_placement(Keywords &k)
{
  TriTool::Placement p = {};
  if (k.is("scale")) {
    p.kind = TriTool::Placement::SCALE;
    const bool three = k.number_ahead(1);
    k.need(three ? 3 : 1);
    p.value[0] = p.value[1] = p.value[2] = k.number();
    for (int d = 1; three && d < 3; d++) p.value[d] = k.number();
    if (p.value[0] * p.value[1] * p.value[2] == 0.0) lmp->error->all(FLERR, "{} must not be 0", k.what());
  } else if (k.is("move")) {
    p.kind = TriTool::Placement::MOVE;
    k.need(3);
    for (int d = 0; d < 3; d++) p.value[d] = k.number();
  } else if (k.is("rotate")) {
    p.kind = TriTool::Placement::ROTATE;
    if (k.rest() < 6 || strcmp(k.ahead(0), "axis") != 0 || strcmp(k.ahead(4), "angle") != 0)
      lmp->error->all(FLERR, "{} must read: rotate axis ax ay az angle degrees", k.what());
    k.take("axis");
    for (int d = 0; d < 3; d++) p.value[d] = k.number("axis");
    if (p.value[0] == 0.0 && p.value[1] == 0.0 && p.value[2] == 0.0)
      lmp->error->all(FLERR, "{} axis must not be zero", k.what());
    k.take("angle");
    p.value[3] = k.number("angle");
  } else return false;
  shape.placement.push_back(p);
  return true;
}

bool ContactSettings::read_law(Keywords &k)
{
  if (k.is("friction") || k.is("friction/table")) {
    if (friction_given)
      lmp->error->all(
          FLERR, "{}: the friction of this tool has been given before; give it once, by friction or by friction/table",
          k.what());
    friction_given = true;
    friction = {};
    if (k.is("friction")) friction.value = k.not_negative();
    else friction = SPHTM_NS::read_friction_table(lmp, k);
  } else if (k.is("friction/shear")) shear = k.share();
  else if (k.is("penalty")) penalty = k.take("material") ? TM_PENALTY_MATERIAL : k.positive();
  else if (k.is("layer")) layer = k.second("rigid", "strains") ? LAYER_STRAINS : LAYER_RIGID;
  else if (k.is("damping")) damping = k.not_negative();
  else if (k.is("approach")) approach = k.yes();
  else if (k.is("method")) f15 = k.second("closest", "f15");
  else if (k.is("sides")) two_sided = k.second("one", "two");
  else if (k.is("overlap")) overlap_allowed = k.second("stop", "allow");
  else return false;
  return true;
}

bool ContactSettings::read_heat(Keywords &k)
{
  if (k.is("heat")) {
    heat_given = true;
    if (k.take("none")) {
      conductance = 0.0;
      heat_given = false;
    } else if (k.take("perfect")) conductance = -1.0;
    else if (k.take("conductance")) conductance = k.positive("conductance");
    else
      lmp->error->all(FLERR, "{} must be none, perfect or conductance hc, got {}", k.what(),
                      k.rest() ? k.value() : "nothing");
  } else if (k.is("temperature")) {
    temperature_given = true;
    k.need(1);
    if (utils::strmatch(k.ahead(0), "^v_")) temperature_variable = k.value() + 2;
    else warn_of_celsius(lmp, k.what(), temperature = k.positive());
  } else if (k.is("lumped")) {
    k.need(3);
    const double mass = k.positive("mass");
    lumped_capacity = mass * k.positive("heat capacity");
    warn_of_celsius(lmp, k.what("temperature"), temperature = k.positive("temperature"));
    temperature_given = heat_given = true;
  } else if (k.is("share")) share = k.share();
  else if (k.is("effusivity")) effusivity = k.not_negative();
  else if (k.is("material")) {
    k.need(3);
    const double conductivity = k.not_negative("conductivity"), density = k.positive("density");
    effusivity = tm_effusivity(conductivity, density / lmp->force->mv2d, k.positive("heat capacity"));
  } else if (k.is("particles")) {
    body_type = k.integer(1, lmp->atom->ntypes, "(an atom type)");
    heat_given = true;
  } else return false;
  return true;
}

bool ContactSettings::is_xml(const std::string &name) { return LAMMPS_NS::utils::strmatch(name, "\\.vtp$"); }

bool ContactSettings::read_output(Keywords &k)
{
  if (k.is("vtk") || k.is("stl")) {
    File &file = k.is("vtk") ? vtk : stl;
    k.need(2);
    file.every = k.integer(1, MAXSMALLINT, "number of steps");
    file.name = k.value();
    if (file.name.find('*') == std::string::npos)
      lmp->error->all(FLERR, "{}: file name {} needs a * for the step", k.what(), file.name);
  } else if (k.is("local")) {
    local_every = k.integer(1, MAXSMALLINT, "number of steps");
  } else if (k.is("reference") || k.is("reference_point")) {
    k.need(3);
    for (double &x : reference) x = k.number();
    reference_given = true;
  } else return false;
  return true;
}

ContactSettings::ContactSettings(LAMMPS *l, int narg, char **arg) : lmp(l)
{
  shape.options = tm_mesh_defaults();
  Keywords k(lmp, "Fix contact/tri", narg, arg);
  while (k.next()) {
    const bool known = read_mesh(k) || read_placement(k) || read_law(k) || read_heat(k) || read_output(k);
    if (!known && k.is("model"))    // of fix surface/global
      lmp->error->all(FLERR, "{}: the contact of a tool with metal is given by penalty, damping, friction and heat",
                      k.what());
    if (!known) k.unknown(KEYWORDS);
  }
  check();
}

void ContactSettings::check() const
{
  Error *error = lmp->error;
  if (shape.file.empty())
    error->all(FLERR, "Fix contact/tri needs a mesh: fix ID group contact/tri file insert.stl ...");
  if (shear > 0.0 && !friction_given)
    error->all(FLERR, "Fix contact/tri friction/shear {:.6g} {}", shear, FRICTION_SHEAR_ALONE);
  if (share >= 0.0 && effusivity >= 0.0)
    error->all(FLERR,
               "Fix contact/tri: give either share or effusivity (or the material that it follows from), not both");
  if (f15 && two_sided) error->all(FLERR, "Fix contact/tri: method f15 has no sides, leave the keyword out");
  if (f15 && layer == LAYER_STRAINS)
    error->all(FLERR, "Fix contact/tri: method f15 has rigid layers, leave the keyword layer out");
  if (approach && layer == LAYER_STRAINS)
    error->all(FLERR, "Fix contact/tri: approach yes has rigid layers, since the work of a layer that strains would "
                      "not come back where its force is dropped; leave out layer strains, or approach yes");
  if (body_type && (conductance != 0.0 || lumped_capacity > 0.0))
    error->all(FLERR, "Fix contact/tri: with particles the tool's heat is theirs; leave out heat "
                      "and lumped, and set the conductance in pair_coeff");
  if (lumped_capacity > 0.0 && !temperature_variable.empty())
    error->all(FLERR, "Fix contact/tri: a lumped tool has a temperature of its own, not a variable's");
}

std::vector<ContactSettings::Hash> ContactSettings::hashes() const
{
  std::vector<double> mu = {friction.value, (double) friction.n};
  mu.insert(mu.end(), friction.t, friction.t + friction.n);
  mu.insert(mu.end(), friction.y, friction.y + friction.n);
  const double number = lumped_capacity > 0.0 ? 0.0 : temperature, lumped = lumped_capacity > 0.0 ? temperature : 0.0;
  const double variable = (double) hash_bytes(temperature_variable.data(), temperature_variable.size());
  const auto of = [](const std::vector<double> &v) { return hash_bytes(v.data(), v.size() * sizeof(double)); };
  // clang-format off
  return {{"friction", of(mu)}, {"friction/shear", of({shear})}, {"penalty", of({penalty})}, {"layer", of({(double) layer})},
          {"damping", of({damping})}, {"approach", of({(double) approach})}, {"method", of({(double) f15})},
          {"sides", of({(double) two_sided})}, {"heat", of({conductance})}, {"share", of({share})},
          {"effusivity", of({effusivity})}, {"particles", of({(double) body_type})},
          {"reference", of({(double) reference_given, reference[0], reference[1], reference[2]})},
          {"temperature", of({number, variable})}, {"lumped", of({lumped_capacity, lumped})}};
  // clang-format on
}

}    // namespace SPHTM_NS
