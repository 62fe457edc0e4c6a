#include "argument.h"

#include "comm.h"
#include "error.h"
#include "lammps.h"
#include "update.h"
#include "utils.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <cstring>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

// NaN where the text is no finite number
static double value(const char *text)
{
  if (!utils::is_double(text)) return NAN;
  const double v = strtod(text, nullptr);
  return std::isfinite(v) ? v : NAN;
}

double number(LAMMPS *lmp, const std::string &what, const char *text)
{
  const double v = value(text);
  if (std::isnan(v)) lmp->error->all(FLERR, "{} must be a finite number, got {}", what, text);
  return v;
}

double positive(LAMMPS *lmp, const std::string &what, const char *text)
{
  const double v = value(text);
  if (!(v > 0.0)) lmp->error->all(FLERR, "{} must be a positive number, got {}", what, text);
  return v;
}

double not_negative(LAMMPS *lmp, const std::string &what, const char *text)
{
  const double v = value(text);
  if (!(v >= 0.0)) lmp->error->all(FLERR, "{} must be a number >= 0, got {}", what, text);
  return v;
}

double number_within(LAMMPS *lmp, const std::string &what, const char *text, double lo, double hi)
{
  const double v = value(text);
  if (!(v > lo && v <= hi)) lmp->error->all(FLERR, "{} must be a number > {} and <= {}, got {}", what, lo, hi, text);
  return v;
}

int integer_within(LAMMPS *lmp, const std::string &what, const char *text, int lo, int hi)
{
  const double v = utils::is_integer(text) ? strtod(text, nullptr) : NAN;
  if (!(v >= lo && v <= hi)) lmp->error->all(FLERR, "{} must be an integer from {} to {}, got {}", what, lo, hi, text);
  return (int) v;
}

void warn_of_celsius(LAMMPS *lmp, const std::string &what, double temperature)
{
  constexpr double COLD = 100.0;    // K
  if (!(temperature < COLD) || lmp->comm->me || strcmp(lmp->update->unit_style, "lj") == 0) return;
  lmp->error->warning(FLERR, "{} is {:.6g} K; temperatures are in kelvin", what, temperature);
}

bool yes_no(LAMMPS *lmp, const std::string &what, const char *text, const char *choice)
{
  const std::string word = text;
  for (const char *yes : {"yes", "on", "true"})
    if (word == yes) return true;
  for (const char *no : {"no", "off", "false"})
    if (word == no) return false;
  lmp->error->all(FLERR, "{} must be {}, got {}", what, choice, text);
  return false;
}

// --- keywords

const char *Keywords::value()
{
  need(1);
  left--;
  return *arg++;
}

bool Keywords::next()
{
  opt.clear();
  if (left < 1) return false;
  key = value();
  return true;
}

bool Keywords::option(const std::vector<std::string> &of)
{
  opt.clear();
  if (left < 1 || std::find(of.begin(), of.end(), *arg) == of.end()) return false;
  opt = value();
  return true;
}

void Keywords::unknown(const std::string &known) const
{
  std::string lower = style;
  lower[0] = (char) tolower(lower[0]);
  lmp->error->all(FLERR, "Unknown {} keyword {}: known are {}", lower, name(), known);
}

std::string Keywords::what(const std::string &part) const
{
  std::string all = style;
  for (const std::string &word : {key, opt, part})
    if (!word.empty()) all += " " + word;
  return all;
}

void Keywords::need(int values) const
{
  if (left >= values) return;
  lmp->error->all(FLERR, "{}{} keyword {} needs {} value{}", style, opt.empty() ? "" : " " + key, name(), values,
                  values == 1 ? "" : "s");
}

bool Keywords::number_ahead(int k) const { return k < left && utils::is_double(arg[k]); }

bool Keywords::take(const char *word)
{
  if (left < 1 || strcmp(*arg, word) != 0) return false;
  value();
  return true;
}

double Keywords::between(double lo, double hi, const char *part)
{
  const char *text = value();
  const double x = SPHTM_NS::value(text);
  if (!(x >= lo && x <= hi))
    lmp->error->all(FLERR, "{} must be a number from {} to {}, got {}", what(part), lo, hi, text);
  return x;
}

bool Keywords::second(const char *one, const char *two)
{
  const char *text = left ? value() : "nothing";
  if (strcmp(text, one) != 0 && strcmp(text, two) != 0)
    lmp->error->all(FLERR, "{} must be {} or {}, got {}", what(), one, two, text);
  return strcmp(text, two) == 0;
}

}    // namespace SPHTM_NS
