#ifdef LMP_KOKKOS
#include "host_inputs_kokkos.h"

#include "compute_reduce_kokkos.h"

#include "compute.h"
#include "fix.h"
#include "info.h"
#include "input.h"
#include "lammps.h"
#include "modify.h"
#include "utils.h"
#include "variable.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <set>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

namespace {

// words of a formula that stand for themselves, and functions of numbers
const std::set<std::string> KNOWN_ON_HOST = {
    "step",       "elapsed",    "elaplong", "dt",        "time",    "cpu",     "tpcpu",   "spcpu",   "cpuremain",
    "part",       "timeremain", "atoms",    "lx",        "ly",      "lz",      "xlo",     "xhi",     "ylo",
    "yhi",        "zlo",        "zhi",      "vol",       "PI",      "version", "yes",     "no",      "on",
    "off",        "true",       "false",    "xy",        "xz",      "yz",      "sqrt",    "exp",     "ln",
    "log",        "abs",        "sign",     "sin",       "cos",     "tan",     "asin",    "acos",    "atan",
    "atan2",      "ceil",       "floor",    "round",     "ternary", "ramp",    "stagger", "logfreq", "logfreq2",
    "logfreq3",   "stride",     "stride2",  "vdisplace", "swiggle", "cwiggle", "random",  "normal",  "is_timeout",
    "is_defined", "is_active"};

bool is_of_word(char c) { return std::isalnum((unsigned char) c) || c == '_'; }

// variables that refer to themselves are for LAMMPS to find
constexpr int DEEPEST = 20;
int depth = 0;
struct Deeper {
  Deeper() { depth++; }
  ~Deeper() { depth--; }
};

bool variable_needs_particles(LAMMPS *lmp, const std::string &name)
{
  const Deeper here;
  const int number = depth > DEEPEST ? -1 : lmp->input->variable->find(name.c_str());
  if (number < 0) return true;
  const std::string said =
      Info(lmp).get_variable_info(number);    // Variable[  0]: name,  style = equal,  def = formula
  const size_t style = said.find("style = "), value = said.find("def =");
  if (style == std::string::npos || value == std::string::npos) return true;
  const std::string of = said.substr(style + 8, said.find(',', style) - style - 8);
  for (const char *plain :
       {"index", "loop", "world", "universe", "uloop", "string", "getenv", "file", "internal", "timer"})
    if (of == plain) return false;
  if (of == "format") {    // its data begin with the name of the variable that is written
    const auto words = utils::split_words(said.substr(value + 5));
    return words.empty() || variable_needs_particles(lmp, words[0]);
  }
  std::string formula = said.substr(value + 5);
  if (of == "equal") formula.resize(formula.rfind(' '));    // its last value follows
  return (of != "equal" && of != "vector") || formula_needs_particles(lmp, formula);
}

}    // namespace

// styles with Kokkos bring what they need to where they work; a force on a tool is a sum
bool input_needs_particles(LAMMPS *lmp, const std::string &input)
{
  if (input.size() < 3 || input[1] != '_') return true;
  const std::string name = input.substr(2, input.find('[') - 2);
  if (input[0] == 'v') return variable_needs_particles(lmp, name);
  if (input[0] == 'c') {
    const Compute *c = lmp->modify->get_compute_by_id(name);
    if (const auto *reduce = dynamic_cast<const ComputeReduceKokkos *>(c)) return reduce->needs_particles();
    return !c || !(c->kokkosable || utils::strmatch(c->style, "^cutting/force"));
  }
  const Fix *f = input[0] == 'f' ? lmp->modify->get_fix_by_id(name) : nullptr;
  return !f || !f->kokkosable;
}

bool formula_needs_particles(LAMMPS *lmp, const std::string &formula)
{
  for (size_t k = 0; k < formula.size();) {
    if (!is_of_word(formula[k])) {
      k++;
      continue;
    }
    if (std::isdigit((unsigned char) formula[k])) {    // a number, with its exponent
      char *end;
      std::strtod(formula.c_str() + k, &end);
      k = end - formula.c_str();
      continue;
    }
    const size_t begin = k;
    while (k < formula.size() && is_of_word(formula[k])) k++;
    const std::string word = formula.substr(begin, k - begin);
    const bool input = word.size() > 2 && word[1] == '_' && strchr("cfv", word[0]);
    if (input ? input_needs_particles(lmp, word) : !KNOWN_ON_HOST.count(word)) return true;
  }
  return false;
}

bool text_needs_particles(LAMMPS *lmp, const std::string &text)
{
  for (size_t k = text.find('$'); k != std::string::npos && k + 1 < text.size(); k = text.find('$', k + 1)) {
    const char next = text[k + 1];
    if (next == '(') {
      size_t end = k + 2;
      for (int open = 1; end < text.size() && open > 0; end++) open += (text[end] == '(') - (text[end] == ')');
      // a format follows behind a colon
      if (formula_needs_particles(lmp, text.substr(k + 2, std::min(end - 1, text.find(':', k)) - k - 2))) return true;
    } else {
      const std::string name = next == '{' ? text.substr(k + 2, text.find('}', k) - k - 2) : std::string(1, next);
      if (variable_needs_particles(lmp, name.substr(0, name.find(':')))) return true;
    }
  }
  return false;
}

}    // namespace SPHTM_NS
#endif
