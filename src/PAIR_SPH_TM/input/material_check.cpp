#include "material_check.h"

#include "material_constants.h"

#include "comm.h"
#include "error.h"
#include "input.h"
#include "lammps.h"
#include "update.h"
#include "utils.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;

namespace SPHTM_NS {
using namespace Material;

namespace {
// units that are taken for those of the run: of a stress MPa and so on, in SI
struct Other {
  Unit unit;
  const char *name;
  double si;
};
// clang-format off
const Other OTHERS[] = {
    {DENSITY, "g/cm3", 1e3},      {DENSITY, "kg/m3", 1.0},      {DENSITY, "t/mm3", 1e12},
    {STRESS, "MPa", 1e6},         {STRESS, "GPa", 1e9},         {STRESS, "Pa", 1.0},
    {CAPACITY, "J/(g K)", 1e3},   {CAPACITY, "J/(kg K)", 1.0},  {CAPACITY, "mJ/(t K)", 1e-6},
    {CONDUCTIVITY, "W/(m K)", 1.0}, {CONDUCTIVITY, "mW/(m K)", 1e-3}};
// clang-format on

class MetalCheck {
 public:
  MetalCheck(LAMMPS *l, const std::string &w, const StyleUnits &u) : lmp(l), where(w), units(u) {}
  double si(Unit unit, double x) const { return x * si_value(unit, units); }
  // x in the units of the style, expected from lo to hi in SI
  void expect(const std::string &name, Unit unit, double x, double lo, double hi) const
  {
    const double in_si = si(unit, x);
    if (in_si >= lo && in_si <= hi) return;
    std::string range = hi < 1e100 ? fmt::format("{:.6g} to {:.6g}", lo, hi) : fmt::format("at least {:.6g}", lo);
    if (lo <= 0.0) range = fmt::format("at most {:.6g}", hi);
    lmp->error->warning(FLERR, "{}: {} {:.6g} in units {} is {:.6g} {}, of a metal {} is expected{}", where, name, x,
                        units.style, in_si, si_name(unit), range, guess(unit, x, lo, hi));
  }

  void expect_at_most(const std::string &name, double x, double hi) const
  {
    if (x > hi)
      lmp->error->warning(FLERR, "{}: {} is {:.6g}, of a metal at most {:.6g} is expected", where, name, x, hi);
  }

 private:
  LAMMPS *lmp;
  std::string where;
  const StyleUnits &units;

  std::string guess(Unit unit, double x, double lo, double hi) const
  {
    for (const Other &o : OTHERS)
      if (o.unit == unit && x * o.si >= lo && x * o.si <= hi)
        return fmt::format("; was it given in {}? units {} takes {}", o.name, units.style, style_name(unit, units));
    return "";
  }
};

double largest(const tm_table &t) { return t.n ? *std::max_element(t.y, t.y + t.n) : t.value; }
double least(const tm_table &t) { return t.n ? *std::min_element(t.y, t.y + t.n) : t.value; }

// the command that is being read, where it is one of LAMMPS's script
std::string command(LAMMPS *lmp, const char *style)
{
  const Input *input = lmp->input;
  if (!input || !input->command || strcmp(input->command, "pair_coeff") != 0 || input->narg < 2) return style;
  return fmt::format("pair_coeff {} {}", input->arg[0], input->arg[1]);
}
}    // namespace

// elastic: jelly to diamond by the speed of sound alone
static void warn_of_sound(LAMMPS *lmp, const char *style, const tm_material &m, const StyleUnits &units)
{
  constexpr double SLOWEST = 0.5, FASTEST = 3e4;    // m/s
  const double sound =
      sqrt(m.young * si_value(Material::STRESS, units) / (m.rho0 * si_value(Material::DENSITY, units)));
  if (sound >= SLOWEST && sound <= FASTEST) return;
  lmp->error->warning(
      FLERR,
      "{}: young {:.6g} and density {:.6g} make a speed of sound of {:.3g} m/s; are they in the units {} "
      "of the run?",
      command(lmp, style), m.young, m.rho0, sound, units.style);
}

void warn_of_units(LAMMPS *lmp, const char *style, const tm_material &m)
{
  const StyleUnits *units = find_style_units(lmp->update->unit_style);
  if (!units || lmp->comm->me || m.body != TM_BODY_SOLID) return;
  if (m.strength == TM_STRENGTH_ELASTIC) warn_of_sound(lmp, style, m, *units);
  if (tm_strength_flow(m.strength) == TM_FLOW_NONE) return;
  const MetalCheck check(lmp, command(lmp, style), *units);

  // mass scaling: the heat of a volume stays
  const double heat = check.si(DENSITY, m.rho0) * check.si(CAPACITY, largest(m.capacity));
  const bool scaled = m.heat && check.si(DENSITY, m.rho0) > 25000.0 && heat >= 1e6 && heat <= 1e7;
  if (!scaled) check.expect("density", DENSITY, m.rho0, 100.0, 25000.0);
  check.expect("young", STRESS, m.young, 1e8, 1e13);
  const double young = check.si(STRESS, m.young), most = young >= 1e8 && young <= 1e13 ? 0.1 * young : 1e10;
  // the stresses of the law together: the flow stress at a strain of about 1, cold
  std::vector<std::string> names;
  double flow = 0.0;
  for (const std::string &id : strength_of(m).constants) {
    const Constant &c = *find_constant(id);
    if (id == "jc_n") check.expect_at_most(id, m.*c.number, 3.0);
    if (id == "jc_c") check.expect_at_most(id, m.*c.number, 0.5);
    if (c.unit != STRESS || id == "hardening") continue;    // a slope
    names.push_back(id);
    flow += m.*c.number;
  }
  check.expect(utils::join_words(names, " + "), STRESS, flow, 1e4, most);
  const bool yields_first = !names.empty() && names[0] == "jc_a" && m.jc_a > 0.0;
  if (yields_first && check.si(STRESS, flow) >= 1e4) check.expect("jc_a", STRESS, m.jc_a, 1e4, 1e300);
  if (tm_strength_flow(m.strength) == TM_FLOW_THERMAL) {
    check.expect("t_melt", TEMPERATURE, m.t_melt, 200.0, 1e300);
    if (m.t_ref > 0.0 && m.t_ref < 200.0 && m.t_melt < 4000.0)
      lmp->error->warning(FLERR, "{}: t_ref is {:.6g} K; temperatures are in kelvin", command(lmp, style), m.t_ref);
  }
  if (!m.heat) return;
  if (!scaled) {
    check.expect("capacity", CAPACITY, least(m.capacity), 10.0, 1e5);
    if (m.capacity.n) check.expect("capacity", CAPACITY, largest(m.capacity), 10.0, 1e5);
  }
  check.expect("conductivity", CONDUCTIVITY, largest(m.conductivity), 0.0, 1e4);
  check.expect("expansion", PER_TEMPERATURE, largest(m.expansion), 0.0, 1e-3);
}

}    // namespace SPHTM_NS
