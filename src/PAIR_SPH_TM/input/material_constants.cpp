/* SPH-TM: the constants of a material by name: unit, range, and the keyword that they follow. */
#include "material_constants.h"

#include "utils.h"

#include <algorithm>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

static constexpr double MOL = 1.0 / 6.02214129e23;    // as in LAMMPS

static const StyleUnits STYLE_UNITS[] = {
    // style     mass              length            time   energy             pressure density
    {"si", 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, "Pa", "kg/m3"},
    {"cgs", 1e-3, 1e-2, 1.0, 1e-7, 0.1, 1e3, "dyn/cm2", "g/cm3"},
    {"real", 1e-3 * MOL, 1e-10, 1e-15, 4184.0 * MOL, 101325.0, 1e3, "atm", "g/cm3"},
    {"metal", 1e-3 * MOL, 1e-10, 1e-12, 1.6021765e-19, 1e5, 1e3, "bar", "g/cm3"},
    {"electron", 1.66053906660e-27, 5.29177210903e-11, 1e-15, 4.3597447222e-18, 1.0,
     1.66053906660e-27 / (5.29177210903e-11 * 5.29177210903e-11 * 5.29177210903e-11), "Pa", "amu/bohr3"},
    {"micro", 1e-15, 1e-6, 1e-6, 1e-15, 1e3, 1e3, "pg/(um us2)", "pg/um3"},
    {"nano", 1e-21, 1e-9, 1e-9, 1e-21, 1e6, 1e6, "ag/(nm ns2)", "ag/nm3"},
};

const StyleUnits *find_style_units(const std::string &style)
{
  for (const StyleUnits &u : STYLE_UNITS)
    if (style == u.style) return &u;
  return nullptr;
}

namespace Material {

double si_value(Unit unit, const StyleUnits &u)
{
  switch (unit) {
    case DENSITY: return u.density;
    case STRESS: return u.pressure;
    case SPEED: return u.length / u.time;
    case RATE: return 1.0 / u.time;
    case CONDUCTIVITY: return u.energy / (u.time * u.length);
    case CAPACITY: return u.energy / u.mass;
    default: return 1.0;
  }
}

const char *si_name(Unit unit)
{
  static const char *const NAME[] = {"", "kg/m3", "Pa", "m/s", "1/s", "K", "1/K", "W/(m K)", "J/(kg K)"};
  return NAME[unit];
}

std::string style_name(Unit unit, const StyleUnits &u)
{
  const bool si = std::string(u.style) == "si" || unit == TEMPERATURE;
  if (unit == DENSITY) return u.density_name;
  if (unit == STRESS) return u.pressure_name;
  if (si) return si_name(unit);
  return unit == CAPACITY ? "energy/(mass K)" : "energy/(time length K)";
}

bool in_range(Range range, double x)
{
  switch (range) {
    case POSITIVE: return x > 0.0;
    case NOT_NEGATIVE: return x >= 0.0;
    case SHARE: return x >= 0.0 && x <= 1.0;
    case POISSON: return x > -1.0 && x < 0.5;
    default: return true;
  }
}

const char *range_text(Range range)
{
  static const char *const TEXT[] = {"finite", "finite and > 0", "finite and >= 0", "from 0 to 1",
                                     "above -1 and below 0.5"};
  return TEXT[range];
}

using M = tm_material;
static const std::vector<Constant> CONSTANTS = {
    {"density", &M::rho0, nullptr, DENSITY, POSITIVE},
    {"young", &M::young, nullptr, STRESS, POSITIVE},
    {"poisson", &M::poisson, nullptr, PLAIN, POISSON},
    {"eos_c0", &M::eos_c0, nullptr, SPEED, POSITIVE},
    {"eos_s", &M::eos_s, nullptr, PLAIN, NOT_NEGATIVE},
    {"eos_gamma", &M::eos_gamma, nullptr, PLAIN, NOT_NEGATIVE},
    {"eos_n", &M::eos_n, nullptr, PLAIN, POSITIVE},
#define TM_CONSTANT(name, unit, range) {#name, &M::name, nullptr, unit, range},
    TM_STRENGTH_CONSTANTS(TM_CONSTANT)
#undef TM_CONSTANT
        {"d1", &M::d1, nullptr, PLAIN, ANY},
    {"d2", &M::d2, nullptr, PLAIN, ANY},
    {"d3", &M::d3, nullptr, PLAIN, ANY},
    {"d4", &M::d4, nullptr, PLAIN, ANY},
    {"d5", &M::d5, nullptr, PLAIN, ANY},
    {"strain_max", &M::strain_max, nullptr, PLAIN, POSITIVE},
    {"conductivity", nullptr, &M::conductivity, CONDUCTIVITY, NOT_NEGATIVE},
    {"capacity", nullptr, &M::capacity, CAPACITY, POSITIVE},
    {"taylor_quinney", &M::taylor_quinney, nullptr, PLAIN, SHARE},
    {"emissivity", &M::emissivity, nullptr, PLAIN, SHARE},
    {"expansion", nullptr, &M::expansion, PER_TEMPERATURE, NOT_NEGATIVE},
};

static const std::vector<Group> GROUPS = {
    {"density", nullptr, nullptr, 0, {"density"}},
    {"elastic", nullptr, nullptr, 0, {"young", "poisson"}},
    {"eos", "linear", &M::eos, TM_EOS_LINEAR, {}},
    {"eos", "shock", &M::eos, TM_EOS_SHOCK, {"eos_c0", "eos_s", "eos_gamma"}},
    {"eos", "tait", &M::eos, TM_EOS_TAIT, {"eos_n"}},
#define TM_LAW(id, number, name, flow, names) {"strength", name, &M::strength, id, utils::split_words(names)},
    TM_STRENGTH_LAWS(TM_LAW)
#undef TM_LAW
        {"damage", "johnson/cook", &M::damage, TM_DAMAGE_JOHNSON_COOK, {"d1", "d2", "d3", "d4", "d5"}},
    {"damage", "strain", &M::damage, TM_DAMAGE_STRAIN, {"strain_max"}},
    {"damage", "none", &M::damage, TM_DAMAGE_NONE, {}},
    {"heat", nullptr, &M::heat, 1, {"conductivity", "capacity", "taylor_quinney"}},
    {"emissivity", nullptr, nullptr, 0, {"emissivity"}},
    {"expansion", nullptr, nullptr, 0, {"expansion"}},
    {"body", "solid", &M::body, TM_BODY_SOLID, {}},
    {"body", "heat", &M::body, TM_BODY_HEAT, {}},
};

const std::vector<Constant> &constants() { return CONSTANTS; }
const std::vector<Group> &groups() { return GROUPS; }

const Group &strength_of(const tm_material &m)
{
  for (const Group &g : GROUPS)
    if (g.selector == &M::strength && g.choice == m.strength) return g;
  return GROUPS.front();    // no such law
}

bool uses(const Group &g, const std::string &constant)
{
  return std::find(g.constants.begin(), g.constants.end(), constant) != g.constants.end();
}

const Constant *find_constant(const std::string &name)
{
  for (const Constant &c : CONSTANTS)
    if (name == c.name) return &c;
  return nullptr;
}

bool is_keyword(const std::string &word)
{
  if (word == "set") return true;
  for (const Group &g : GROUPS)
    if (word == g.keyword) return true;
  return false;
}

// --- lists for messages -----------------------------------------------------------------------

std::string join(const std::vector<std::string> &words)
{
  std::string all;
  for (const auto &w : words) all += (all.empty() ? "" : ", ") + w;
  return all;
}

std::string known_keywords()
{
  std::vector<std::string> words;
  for (const Group &g : GROUPS)
    if (words.empty() || words.back() != g.keyword) words.emplace_back(g.keyword);
  words.emplace_back("set");
  return join(words);
}

std::string known_options(const std::string &keyword)
{
  std::vector<std::string> words;
  for (const Group &g : GROUPS)
    if (keyword == g.keyword) words.emplace_back(g.option);
  return join(words);
}

std::string known_constants()
{
  std::vector<std::string> words;
  for (const Constant &c : CONSTANTS) words.emplace_back(c.name);
  return join(words);
}

std::string known_flow_laws()
{
  std::vector<std::string> words;
  for (const Group &g : GROUPS)
    if (g.selector == &M::strength && tm_strength_flow(g.choice) != TM_FLOW_NONE) words.emplace_back(g.option);
  return join(words);
}

}    // namespace Material
}    // namespace SPHTM_NS
