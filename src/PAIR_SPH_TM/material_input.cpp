/* SPH-TM: material constants from the input script or from a card file. */
#include "material_input.h"

#include "comm.h"
#include "error.h"
#include "lammps.h"
#include "platform.h"
#include "tokenizer.h"
#include "update.h"
#include "utils.h"

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <mpi.h>
#include <set>
#include <vector>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

// --- data: units, constants, keywords ---------------------------------------------------------

static constexpr double MOL = 1.0 / 6.02214129e23;    // as in LAMMPS

static const StyleUnits STYLE_UNITS[] = {
    // style     mass              length            time   energy             pressure density
    {"si",       1.0,              1.0,              1.0,   1.0,               1.0,      1.0},
    {"cgs",      1e-3,             1e-2,             1.0,   1e-7,              0.1,      1e3},
    {"real",     1e-3 * MOL,       1e-10,            1e-15, 4184.0 * MOL,      101325.0, 1e3},
    {"metal",    1e-3 * MOL,       1e-10,            1e-12, 1.6021765e-19,     1e5,      1e3},
    {"electron", 1.66053906660e-27, 5.29177210903e-11, 1e-15, 4.3597447222e-18, 1.0,
     1.66053906660e-27 / (5.29177210903e-11 * 5.29177210903e-11 * 5.29177210903e-11)},
    {"micro",    1e-15,            1e-6,             1e-6,  1e-15,             1e3,      1e3},
    {"nano",     1e-21,            1e-9,             1e-9,  1e-21,             1e6,      1e6},
};

const StyleUnits *find_style_units(const std::string &style)
{
  for (const StyleUnits &u : STYLE_UNITS)
    if (style == u.style) return &u;
  return nullptr;
}

enum Unit { PLAIN, DENSITY, STRESS, SPEED, RATE, TEMPERATURE, CONDUCTIVITY, CAPACITY };

static double si_value(Unit unit, const StyleUnits &u)
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

enum Range { ANY, POSITIVE, NOT_NEGATIVE, SHARE, POISSON };

static bool in_range(Range range, double x)
{
  switch (range) {
    case POSITIVE: return x > 0.0;
    case NOT_NEGATIVE: return x >= 0.0;
    case SHARE: return x >= 0.0 && x <= 1.0;
    case POISSON: return x > -1.0 && x < 0.5;
    default: return true;
  }
}
static const char *const RANGE_TEXT[] = {"finite", "finite and > 0", "finite and >= 0",
                                         "from 0 to 1", "above -1 and below 0.5"};

// every constant: its name for 'set' and messages, where it goes, its unit and its range
struct Constant {
  const char *name;
  tm_real tm_material::*number;
  tm_table tm_material::*table;
  Unit unit;
  Range range;
};
using M = tm_material;
static const Constant CONSTANTS[] = {
    {"density", &M::rho0, nullptr, DENSITY, POSITIVE},
    {"young", &M::young, nullptr, STRESS, POSITIVE},
    {"poisson", &M::poisson, nullptr, PLAIN, POISSON},
    {"eos_c0", &M::eos_c0, nullptr, SPEED, POSITIVE},
    {"eos_s", &M::eos_s, nullptr, PLAIN, NOT_NEGATIVE},
    {"eos_gamma", &M::eos_gamma, nullptr, PLAIN, NOT_NEGATIVE},
    {"eos_n", &M::eos_n, nullptr, PLAIN, POSITIVE},
    {"yield", &M::yield, nullptr, STRESS, NOT_NEGATIVE},
    {"hardening", &M::hardening, nullptr, STRESS, NOT_NEGATIVE},
    {"jc_a", &M::jc_a, nullptr, STRESS, NOT_NEGATIVE},
    {"jc_b", &M::jc_b, nullptr, STRESS, NOT_NEGATIVE},
    {"jc_n", &M::jc_n, nullptr, PLAIN, NOT_NEGATIVE},
    {"jc_c", &M::jc_c, nullptr, PLAIN, NOT_NEGATIVE},
    {"jc_m", &M::jc_m, nullptr, PLAIN, POSITIVE},
    {"t_ref", &M::t_ref, nullptr, TEMPERATURE, NOT_NEGATIVE},
    {"t_melt", &M::t_melt, nullptr, TEMPERATURE, POSITIVE},
    {"jc_rate0", &M::jc_rate0, nullptr, RATE, POSITIVE},
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
};

// every keyword with its option, what it selects and the constants that follow
struct Group {
  const char *keyword, *option;
  int tm_material::*selector;
  int choice;
  std::vector<const char *> constants;
};
static const std::vector<Group> GROUPS = {
    {"density", nullptr, nullptr, 0, {"density"}},
    {"elastic", nullptr, nullptr, 0, {"young", "poisson"}},
    {"eos", "linear", &M::eos, TM_EOS_LINEAR, {}},
    {"eos", "shock", &M::eos, TM_EOS_SHOCK, {"eos_c0", "eos_s", "eos_gamma"}},
    {"eos", "tait", &M::eos, TM_EOS_TAIT, {"eos_n"}},
    {"strength", "elastic", &M::strength, TM_STRENGTH_ELASTIC, {}},
    {"strength", "plastic", &M::strength, TM_STRENGTH_PLASTIC, {"yield", "hardening"}},
    {"strength", "johnson/cook", &M::strength, TM_STRENGTH_JOHNSON_COOK,
     {"jc_a", "jc_b", "jc_n", "jc_c", "jc_m", "t_ref", "t_melt", "jc_rate0"}},
    {"strength", "none", &M::strength, TM_STRENGTH_NONE, {}},
    {"damage", "johnson/cook", &M::damage, TM_DAMAGE_JOHNSON_COOK, {"d1", "d2", "d3", "d4", "d5"}},
    {"damage", "strain", &M::damage, TM_DAMAGE_STRAIN, {"strain_max"}},
    {"damage", "none", &M::damage, TM_DAMAGE_NONE, {}},
    {"heat", nullptr, &M::heat, 1, {"conductivity", "capacity", "taylor_quinney"}},
    {"emissivity", nullptr, nullptr, 0, {"emissivity"}},
    {"body", "solid", &M::body, TM_BODY_SOLID, {}},
    {"body", "heat", &M::body, TM_BODY_HEAT, {}},
};

static const Constant *find_constant(const std::string &name)
{
  for (const Constant &c : CONSTANTS)
    if (name == c.name) return &c;
  return nullptr;
}
static bool is_keyword(const std::string &word)
{
  if (word == "set") return true;
  for (const Group &g : GROUPS)
    if (word == g.keyword) return true;
  return false;
}

// --- lists for messages -----------------------------------------------------------------------

static std::string join(const std::vector<std::string> &words)
{
  std::string all;
  for (const auto &w : words) all += (all.empty() ? "" : ", ") + w;
  return all;
}
static std::string known_keywords()
{
  std::vector<std::string> words;
  for (const Group &g : GROUPS)
    if (words.empty() || words.back() != g.keyword) words.emplace_back(g.keyword);
  words.emplace_back("set");
  return join(words);
}
static std::string known_options(const std::string &keyword)
{
  std::vector<std::string> words;
  for (const Group &g : GROUPS)
    if (keyword == g.keyword) words.emplace_back(g.option);
  return join(words);
}
static std::string known_constants()
{
  std::vector<std::string> words;
  for (const Constant &c : CONSTANTS) words.emplace_back(c.name);
  return join(words);
}

// --- reading a list of words ------------------------------------------------------------------

namespace {
struct Words {
  const std::vector<std::string> &word;
  std::size_t at;
  bool done() const { return at >= word.size(); }
};

class MaterialReader {
 public:
  MaterialReader(LAMMPS *l, const char *s) : error(l->error), style(s) {}

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
    error->all(FLERR, "{}: {} must be {}, got {}", where, what, RANGE_TEXT[range], text);
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
    error->all(FLERR, "{}: {} takes table/N with N from 1 to {}, got '{}'", where, what,
               TM_TABLE_MAX, w.word[w.at]);
  w.at++;
  for (int i = 0; i < t.n; i++) {
    const std::string which = fmt::format("{} of {}", i + 1, t.n);
    t.t[i] = number(w, fmt::format("{} table temperature {}", what, which), NOT_NEGATIVE);
    if (i > 0 && t.t[i] <= t.t[i - 1])
      error->all(FLERR, "{}: {} table/{} takes {} pairs T y with T increasing, got {} after {}",
                 where, what, t.n, t.n, t.t[i], t.t[i - 1]);
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
  for (const Group &g : GROUPS)
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
  if (!seen.insert(g.keyword).second)
    error->all(FLERR, "{}: {} is given twice", where, g.keyword);
  ever.insert(g.keyword);
  if (g.selector) m.*g.selector = g.choice;
  int k = 0;
  for (const char *id : g.constants) {
    const Constant &c = *find_constant(id);
    const std::string what =
        fmt::format("{} value {} of {} ({})", name, ++k, g.constants.size(), c.name);
    if (c.table) table(w, what, c);
    else m.*c.number = number(w, what, c.range);
  }
  if (!w.done() && utils::is_double(w.word[w.at]))
    error->all(FLERR, "{}: {} takes {} values, got one more: {}", where, name, g.constants.size(),
               w.word[w.at]);
}

// set constant value: kept until all keywords are known
void MaterialReader::change(Words &w)
{
  w.at++;
  if (w.done()) error->all(FLERR, "{}: set needs a constant and a value", where);
  const std::string name = w.word[w.at++];
  const Constant *c = find_constant(name);
  if (!c)
    error->all(FLERR, "{}: set knows no constant '{}'; known are {}", where, name,
               known_constants());
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
  for (const Constant &c : CONSTANTS) {
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
    for (const Group &g : GROUPS)
      for (const char *id : g.constants)
        if (!strcmp(id, x.constant->name)) {
          owner = &g;
          active = g.selector ? m.*g.selector == g.choice : ever.count(g.keyword) > 0;
        }
    if (!active)
      error->all(FLERR, "{}: set {} needs {}{}{}, which this material does not have", where,
                 x.constant->name, owner->keyword, owner->option ? " " : "",
                 owner->option ? owner->option : "");
    if (x.constant->number) m.*x.constant->number = x.value;
    else {
      m.*x.constant->table = tm_table{};
      (m.*x.constant->table).value = x.value;
    }
  }
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
  if (m.emissivity > 0.0 && !m.heat)
    error->all(FLERR, "{}: emissivity needs 'heat k cp chi'", where);
  if (m.strength == TM_STRENGTH_JOHNSON_COOK && !(m.t_melt > m.t_ref))
    error->all(FLERR, "{}: strength johnson/cook needs t_melt above t_ref, got {} and {}", where,
               m.t_melt, m.t_ref);
  if (m.damage != TM_DAMAGE_NONE && m.strength != TM_STRENGTH_PLASTIC &&
      m.strength != TM_STRENGTH_JOHNSON_COOK)
    error->all(FLERR, "{}: damage needs strength plastic or johnson/cook", where);
  if (m.damage == TM_DAMAGE_JOHNSON_COOK && m.strength != TM_STRENGTH_JOHNSON_COOK &&
      (m.d4 != 0.0 || m.d5 != 0.0))
    error->all(FLERR, "{}: damage johnson/cook with d4 or d5 needs the reference rate and the "
               "temperatures of strength johnson/cook; use 0 for both", where);
  m.shear = m.young / (2.0 * (1.0 + m.poisson));
  m.bulk = m.young / (3.0 * (1.0 - 2.0 * m.poisson));
  return m;
}

// --- card files -------------------------------------------------------------------------------

std::string find_file(const char *name)
{
  std::string path = utils::get_potential_file_path(name);
  if (!path.empty()) return path;
  std::vector<std::string> folders = platform::list_pathenv("SPHTM_MATERIALS");
#ifdef SPHTM_MATERIALS_DIR
  folders.emplace_back(SPHTM_MATERIALS_DIR);
#endif
  for (const auto &folder : folders) {
    path = platform::path_join(folder, platform::path_basename(name));
    if (platform::file_is_readable(path)) return path;
  }
  return "";
}

// the whole file, read by rank 0
std::string read_file(LAMMPS *lmp, const char *style, const char *name)
{
  std::string text;
  int size = -1;
  if (lmp->comm->me == 0) {
    const std::string path = find_file(name);
    FILE *fp = path.empty() ? nullptr : fopen(path.c_str(), "rb");
    if (fp) {
      char buffer[4096];
      std::size_t n;
      while ((n = fread(buffer, 1, sizeof(buffer), fp)) > 0) text.append(buffer, n);
      fclose(fp);
      size = (int) text.size();
    }
  }
  MPI_Bcast(&size, 1, MPI_INT, 0, lmp->world);
  if (size < 0)
    lmp->error->all(FLERR, "{}: '{}' is neither a keyword ({}) nor a material file here, in the "
                    "folders of LAMMPS_POTENTIALS or in those of SPHTM_MATERIALS", style, name,
                    known_keywords());
  text.resize(size);
  MPI_Bcast(&text[0], size, MPI_CHAR, 0, lmp->world);
  return text;
}

struct Line {
  int number;
  std::vector<std::string> words;
};

// lines with words, without comments; a final & continues a line
std::vector<Line> split_lines(const std::string &text)
{
  std::vector<Line> lines;
  int number = 0;
  bool joined = false;
  for (std::size_t begin = 0; begin < text.size();) {
    std::size_t end = text.find('\n', begin);
    if (end == std::string::npos) end = text.size();
    std::string one = text.substr(begin, end - begin);
    one = one.substr(0, one.find('#'));
    begin = end + 1;
    number++;
    std::vector<std::string> words = Tokenizer(one, " \t\r\f").as_vector();
    if (words.empty()) continue;
    const bool more = words.back() == "&";
    if (more) words.pop_back();
    if (!joined) lines.push_back({number, {}});
    auto &all = lines.back().words;
    all.insert(all.end(), words.begin(), words.end());
    joined = more;
  }
  return lines;
}

// the lines of one card; names all cards of the file when it is not there
std::vector<Line> find_card(LAMMPS *lmp, const char *style, const char *file, const char *name)
{
  std::vector<Line> card;
  std::vector<std::string> names;
  bool inside = false;
  auto fail = [&](int line, const std::string &what) {
    lmp->error->all(FLERR, "{}, {} line {}: {}", style, file, line, what);
  };
  int last = 0;
  for (const Line &line : split_lines(read_file(lmp, style, file))) {
    const std::string &first = line.words[0];
    last = line.number;
    if (first == "material") {
      if (inside) fail(line.number, "material before the 'end' of '" + names.back() + "'");
      if (line.words.size() != 2) fail(line.number, "expected 'material <name>'");
      for (const auto &n : names)
        if (n == line.words[1]) fail(line.number, "second material named '" + n + "'");
      names.push_back(line.words[1]);
      inside = true;
    } else if (!inside) {
      fail(line.number, "expected 'material <name>', got '" + first + "'");
    } else if (first == "end") {
      inside = false;
    } else if (names.back() == name) {
      card.push_back(line);
    }
  }
  if (inside) fail(last, "material '" + names.back() + "' has no 'end'");
  bool found = false;
  for (const auto &n : names) found = found || n == name;
  if (!found)
    lmp->error->all(FLERR, "{}: no material '{}' in {}; it has {}", style, name, file,
                    names.empty() ? "none" : join(names));
  return card;
}

std::vector<std::string> word_list(int narg, char **arg, int first)
{
  return narg > first ? std::vector<std::string>(arg + first, arg + narg)
                      : std::vector<std::string>();
}
}    // namespace

// --- what the styles call ---------------------------------------------------------------------

tm_material material_from_args(LAMMPS *lmp, const char *style, int narg, char **arg, int first)
{
  MaterialReader reader(lmp, style);
  reader.read(word_list(narg, arg, first), "");
  return reader.finish("");
}

tm_material material_from_card(LAMMPS *lmp, const char *style, const char *file, const char *name,
                               int narg, char **arg, int first)
{
  const StyleUnits *units = find_style_units(lmp->update->unit_style);
  if (!units)
    lmp->error->all(FLERR, "{}: material cards are in SI and cannot be converted to units {}; give "
                    "the constants inline", style, lmp->update->unit_style);
  MaterialReader reader(lmp, style);
  const std::string card = fmt::format("material {} of {}", name, file);
  for (const Line &line : find_card(lmp, style, file, name)) {
    if (line.words[0] == "set")
      lmp->error->all(FLERR, "{}, {} line {}: set belongs into the input script", style, card,
                      line.number);
    reader.read(line.words, fmt::format("{} line {}", card, line.number));
  }
  reader.from_si(*units);
  reader.start_override();
  reader.read(word_list(narg, arg, first), card);
  return reader.finish(card);
}

tm_material read_material(LAMMPS *lmp, const char *style, int narg, char **arg)
{
  if (narg < 1) lmp->error->all(FLERR, "{}: needs {}, or a file and a material name", style,
                                known_keywords());
  if (is_keyword(arg[0])) return material_from_args(lmp, style, narg, arg);
  if (narg < 2)
    lmp->error->all(FLERR, "{}: '{}' is neither a keyword ({}) nor a material file followed by the "
                    "name of a material", style, arg[0], known_keywords());
  return material_from_card(lmp, style, arg[0], arg[1], narg, arg, 2);
}

std::string material_title(int narg, char **arg)
{
  return narg > 1 && !is_keyword(arg[0]) ? arg[1] : "inline";
}

}    // namespace SPHTM_NS
