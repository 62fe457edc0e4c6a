/* SPH-TM: material constants from the input script or from a card file. */
#include "material_input.h"

#include "material_card.h"
#include "material_check.h"
#include "material_constants.h"
#include "tm_damage.h"

#include "comm.h"
#include "error.h"
#include "lammps.h"
#include "update.h"
#include "utils.h"

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <set>
#include <vector>

using namespace LAMMPS_NS;

namespace SPHTM_NS {
using namespace Material;

// --- reading a list of words ------------------------------------------------------------------

namespace {
struct Words {
  const std::vector<std::string> &word;
  std::size_t at;
  bool done() const { return at >= word.size(); }
};

class MaterialReader {
 public:
  MaterialReader(LAMMPS *l, const char *s) : lmp(l), error(l->error), style(s) {}

  // source names the place for messages: empty for the input script
  void read(const std::vector<std::string> &list, const std::string &source);
  void start_override() { seen.clear(); }
  void from_si(const StyleUnits &units);
  tm_material finish(const std::string &source);

 private:
  struct Change {
    const Constant *constant;
    tm_real value;
  };
  LAMMPS *lmp;
  Error *error;
  std::string style, where;
  tm_material m = {};
  std::set<std::string> seen, ever;
  std::vector<Change> changes;

  const Group &find_group(Words &w);
  double number(Words &w, const std::string &what, Range range);
  void table(Words &w, const std::string &what, const Constant &c);
  void group(Words &w);
  void change(Words &w);
  void apply_changes();
  void check_damage();
  void check_expansion();
  void check_sound();
};

double MaterialReader::number(Words &w, const std::string &what, Range range)
{
  if (w.done()) error->all(FLERR, "{}: {} is missing", where, what);
  const std::string &text = w.word[w.at];
  if (!utils::is_double(text))
    error->all(FLERR, "{}: {} must be a number, got '{}'{}", where, what, text,
               is_keyword(text) ? ": too few values" : "");
  const double x = std::strtod(text.c_str(), nullptr);
  if (!std::isfinite(x) || !in_range(range, x))
    error->all(FLERR, "{}: {} must be {}, got {}", where, what, range_text(range), text);
  w.at++;
  return x;
}

// number, or table/N T1 y1 ... TN yN
void MaterialReader::table(Words &w, const std::string &what, const Constant &c)
{
  tm_table t = {};
  if (w.done() || !utils::strmatch(w.word[w.at], "^table/")) {
    t.value = number(w, what, c.range);
    m.*c.table = t;
    return;
  }
  const std::string count = w.word[w.at].substr(6);
  t.n = utils::is_integer(count) && count.size() < 4 ? std::stoi(count) : 0;
  if (t.n < 1 || t.n > TM_TABLE_MAX)
    error->all(FLERR, "{}: {} takes table/N with N from 1 to {}, got '{}'", where, what, TM_TABLE_MAX, w.word[w.at]);
  w.at++;
  for (int i = 0; i < t.n; i++) {
    const std::string which = fmt::format("{} of {}", i + 1, t.n);
    t.t[i] = number(w, fmt::format("{} table temperature {}", what, which), NOT_NEGATIVE);
    if (i > 0 && t.t[i] <= t.t[i - 1])
      error->all(FLERR, "{}: {} table/{} takes {} pairs T y with T increasing, got {} after {}", where, what, t.n, t.n,
                 t.t[i], t.t[i - 1]);
    t.y[i] = number(w, fmt::format("{} table value {}", what, which), c.range);
  }
  m.*c.table = t;
}

const Group &MaterialReader::find_group(Words &w)
{
  const std::string &keyword = w.word[w.at++];
  if (!is_keyword(keyword))
    error->all(FLERR, "{}: unknown keyword '{}'; known are {}", where, keyword, known_keywords());
  const Group *only = nullptr;
  for (const Group &g : groups())
    if (keyword == g.keyword) {
      if (g.option && !w.done() && w.word[w.at] == g.option) {
        w.at++;
        return g;
      }
      only = &g;
    }
  if (only->option)
    error->all(FLERR, "{}: {} must be one of {}, got {}", where, keyword, known_options(keyword),
               w.done() ? "nothing" : "'" + w.word[w.at] + "'");
  return *only;
}

void MaterialReader::group(Words &w)
{
  const Group &g = find_group(w);
  const std::string name = g.option ? fmt::format("{} {}", g.keyword, g.option) : g.keyword;
  if (!seen.insert(g.keyword).second) error->all(FLERR, "{}: {} is given twice", where, g.keyword);
  ever.insert(g.keyword);
  if (g.selector) m.*g.selector = g.choice;
  int k = 0;
  for (const std::string &id : g.constants) {
    const Constant &c = *find_constant(id);
    const std::string what = fmt::format("{} value {} of {} ({})", name, ++k, g.constants.size(), c.name);
    if (c.table) table(w, what, c);
    else m.*c.number = number(w, what, c.range);
  }
  if (!w.done() && utils::is_double(w.word[w.at]))
    error->all(FLERR, "{}: {} takes {} values, got one more: {}", where, name, g.constants.size(), w.word[w.at]);
}

// set constant value: kept until all keywords are known
void MaterialReader::change(Words &w)
{
  w.at++;
  if (w.done()) error->all(FLERR, "{}: set needs a constant and a value", where);
  const std::string name = w.word[w.at++];
  const Constant *c = find_constant(name);
  if (!c) error->all(FLERR, "{}: set knows no constant '{}'; known are {}", where, name, known_constants());
  for (const Change &old : changes)
    if (old.constant == c) error->all(FLERR, "{}: set {} is given twice", where, name);
  changes.push_back({c, number(w, "set " + name + " value", c->range)});
}

void MaterialReader::read(const std::vector<std::string> &list, const std::string &source)
{
  where = source.empty() ? style : style + ", " + source;
  Words w = {list, 0};
  while (!w.done()) {
    if (list[w.at] == "set") change(w);
    else group(w);
  }
}

// --- units and completion ---------------------------------------------------------------------

void MaterialReader::from_si(const StyleUnits &units)
{
  for (const Constant &c : constants()) {
    const double factor = 1.0 / si_value(c.unit, units);
    if (c.number) m.*c.number *= factor;
    if (!c.table) continue;
    tm_table &t = m.*c.table;
    t.value *= factor;
    for (int i = 0; i < t.n; i++) t.y[i] *= factor;
  }
}

void MaterialReader::apply_changes()
{
  for (const Change &x : changes) {
    const Group *owner = nullptr;
    bool active = false;
    for (const Group &g : groups()) {    // laws may share a constant
      if (active || !uses(g, x.constant->name)) continue;
      if (!owner) owner = &g;
      active = g.selector ? m.*g.selector == g.choice : ever.count(g.keyword) > 0;
    }
    if (!active)
      error->all(FLERR, "{}: set {} needs {}{}{}, which this material does not have", where, x.constant->name,
                 owner->keyword, owner->option ? " " : "", owner->option ? owner->option : "");
    if (x.constant->number) m.*x.constant->number = x.value;
    else {
      m.*x.constant->table = tm_table{};
      (m.*x.constant->table).value = x.value;
    }
  }
}

// a strain at fracture that is not positive: the material would fail with the first plastic strain
void MaterialReader::check_damage()
{
  if (m.damage != TM_DAMAGE_JOHNSON_COOK) return;
  const auto fracture = [this](double s) { return m.d1 + m.d2 * exp(m.d3 * s); };
  const std::string what =
      fmt::format("{}: damage johnson/cook {:.6g} {:.6g} {:.6g}: the strain at fracture", where, m.d1, m.d2, m.d3);
  if (!(fracture(1.0 / 3.0) > TM_FRACTURE_STRAIN_MIN))
    error->all(FLERR,
               "{} in tension, d1 + d2 exp(d3 s) at s = 1/3, is {:.6g}, and must be above 0; for no damage "
               "write 'damage none'",
               what, fracture(1.0 / 3.0));
  if (lmp->comm->me) return;
  for (const double s : {TM_TRIAXIALITY_MIN, TM_TRIAXIALITY_MAX})
    if (!(fracture(s) > TM_FRACTURE_STRAIN_MIN))
      error->warning(FLERR,
                     "{} d1 + d2 exp(d3 s) is {:.6g} at s = {:.6g} (mean stress over von Mises stress): there "
                     "it fails at once",
                     what, fracture(s), s);
  if (m.d2 * m.d3 > 0.0)
    error->warning(FLERR,
                   "{} grows with tension, since d2 d3 is above 0: of metals d3 is below 0 here, where tension is "
                   "positive",
                   what);
  if (m.d5 <= -1.0)
    error->warning(FLERR,
                   "{} goes with 1 + d5 T*, d5 = {:.6g}, and is not above 0 at the melting temperature: hot "
                   "material fails at once",
                   what, m.d5);
}

// c0 of a shock equation of state is the bulk sound speed
void MaterialReader::check_sound()
{
  if (m.body != TM_BODY_SOLID || m.eos != TM_EOS_SHOCK || lmp->comm->me) return;
  const StyleUnits *u = find_style_units(lmp->update->unit_style);
  const double speed = u ? u->length / u->time : 1.0, unit = u ? u->density * speed * speed / u->pressure : 1.0;
  const double ratio = unit * m.rho0 * m.eos_c0 * m.eos_c0 / (m.young / (3.0 * (1.0 - 2.0 * m.poisson)));
  if (ratio < 0.5 || ratio > 2.0)
    error->warning(
        FLERR,
        "{}: eos shock c0 {:.6g}: density c0^2 is {:.3g} times the bulk modulus that elastic gives, of a metal "
        "they are the same within a tenth; is c0 in the units of the run?",
        where, m.eos_c0, ratio);
}

// with a shock equation of state the internal energy expands: 3 alpha = gamma c_p/c0^2
void MaterialReader::check_expansion()
{
  if (!ever.count("expansion")) return;
  if (!m.heat) error->all(FLERR, "{}: expansion needs 'heat k cp chi'", where);
  if (m.eos != TM_EOS_SHOCK || lmp->comm->me) return;
  const auto first = [](const tm_table &t) { return t.n ? t.y[0] : t.value; };
  const double alpha = m.eos_gamma * first(m.capacity) / (3.0 * m.eos_c0 * m.eos_c0), given = first(m.expansion);
  if (fabs(alpha - given) > 0.25 * given)
    error->warning(FLERR,
                   "{}: with eos shock thermal expansion is gamma cp/(3 c0^2) = {:.4g}; the expansion {:.4g} is not "
                   "read",
                   where, alpha, given);
}

// what follows from the constants, and what must hold between them
tm_material MaterialReader::finish(const std::string &source)
{
  where = source.empty() ? style : style + ", " + source;
  apply_changes();
  const bool solid = m.body == TM_BODY_SOLID;
  if (!ever.count("density")) error->all(FLERR, "{}: missing 'density rho'", where);
  if (solid && !ever.count("elastic")) error->all(FLERR, "{}: missing 'elastic E nu'", where);
  if (!solid && !m.heat) error->all(FLERR, "{}: body heat needs 'heat k cp chi'", where);
  if (m.emissivity > 0.0 && !m.heat) error->all(FLERR, "{}: emissivity needs 'heat k cp chi'", where);
  const Group &strength = strength_of(m);
  if (uses(strength, "t_ref") && !(m.t_melt > m.t_ref))
    error->all(FLERR, "{}: strength {} needs t_melt above t_ref, got {} and {}", where, strength.option, m.t_melt,
               m.t_ref);
  if (m.damage != TM_DAMAGE_NONE && tm_strength_flow(m.strength) == TM_FLOW_NONE)
    error->all(FLERR, "{}: damage needs a strength with plastic flow: {}", where, known_flow_laws());
  if (m.damage == TM_DAMAGE_JOHNSON_COOK && !uses(strength, "jc_rate0") && (m.d4 != 0.0 || m.d5 != 0.0))
    error->all(FLERR,
               "{}: damage johnson/cook with d4 or d5 needs the reference rate and the "
               "temperatures of strength johnson/cook; use 0 for both",
               where);
  check_sound();
  check_expansion();
  check_damage();
  m.shear = m.young / (2.0 * (1.0 + m.poisson));
  m.bulk = m.young / (3.0 * (1.0 - 2.0 * m.poisson));
  return m;
}

std::vector<std::string> word_list(int narg, char **arg, int first)
{
  return narg > first ? std::vector<std::string>(arg + first, arg + narg) : std::vector<std::string>();
}
}    // namespace

// --- what the styles call ---------------------------------------------------------------------

tm_material material_from_args(LAMMPS *lmp, const char *style, int narg, char **arg, int first)
{
  MaterialReader reader(lmp, style);
  reader.read(word_list(narg, arg, first), "");
  return reader.finish("");
}

tm_material material_from_card(LAMMPS *lmp, const char *style, const char *file, const char *name, int narg, char **arg,
                               int first)
{
  const StyleUnits *units = find_style_units(lmp->update->unit_style);
  if (!units)
    lmp->error->all(FLERR,
                    "{}: material cards are in SI and cannot be converted to units {}; give "
                    "the constants inline",
                    style, lmp->update->unit_style);
  MaterialReader reader(lmp, style);
  const std::string card = fmt::format("material {} of {}", name, file);
  for (const CardLine &line : find_card(lmp, style, file, name)) {
    if (line.words[0] == "set")
      lmp->error->all(FLERR, "{}, {} line {}: set belongs into the input script", style, card, line.number);
    reader.read(line.words, fmt::format("{} line {}", card, line.number));
  }
  reader.from_si(*units);
  reader.start_override();
  reader.read(word_list(narg, arg, first), card);
  return reader.finish(card);
}

tm_material read_material(LAMMPS *lmp, const char *style, int narg, char **arg)
{
  if (narg < 1) lmp->error->all(FLERR, "{}: needs {}, or a file and a material name", style, known_keywords());
  if (is_keyword(arg[0])) {
    const tm_material m = material_from_args(lmp, style, narg, arg);
    warn_of_units(lmp, style, m);
    return m;
  }
  if (narg < 2)
    lmp->error->all(FLERR,
                    "{}: '{}' is neither a keyword ({}) nor a material file followed by the "
                    "name of a material",
                    style, arg[0], known_keywords());
  const tm_material m = material_from_card(lmp, style, arg[0], arg[1], narg, arg, 2);
  warn_of_units(lmp, style, m);
  return m;
}

std::string material_title(int narg, char **arg) { return narg > 1 && !is_keyword(arg[0]) ? arg[1] : "inline"; }

}    // namespace SPHTM_NS
