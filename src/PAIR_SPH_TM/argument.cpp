#include "argument.h"

#include "error.h"
#include "lammps.h"
#include "utils.h"

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
  if (!(v > lo && v <= hi))
    lmp->error->all(FLERR, "{} must be a number > {} and <= {}, got {}", what, lo, hi, text);
  return v;
}

int integer_within(LAMMPS *lmp, const std::string &what, const char *text, int lo, int hi)
{
  const double v = utils::is_integer(text) ? strtod(text, nullptr) : NAN;
  if (!(v >= lo && v <= hi))
    lmp->error->all(FLERR, "{} must be an integer from {} to {}, got {}", what, lo, hi, text);
  return (int) v;
}

bool yes_no(LAMMPS *lmp, const std::string &what, const char *text)
{
  const std::string word = text;
  for (const char *yes : {"yes", "on", "true"})
    if (word == yes) return true;
  for (const char *no : {"no", "off", "false"})
    if (word == no) return false;
  lmp->error->all(FLERR, "{} must be yes or no, got {}", what, text);
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
  if (left < 1) return false;
  key = value();
  return true;
}

void Keywords::need(int values) const
{
  if (left < values)
    lmp->error->all(FLERR, "{} keyword {} needs {} value{}", style, key, values, values == 1 ? "" : "s");
}

bool Keywords::take(const char *word)
{
  if (left < 1 || strcmp(*arg, word) != 0) return false;
  value();
  return true;
}

double Keywords::share(const char *part)
{
  const char *text = value();
  const double x = SPHTM_NS::not_negative(lmp, what(part), text);
  if (x > 1.0) lmp->error->all(FLERR, "{} must be 0 to 1, got {}", what(part), text);
  return x;
}

bool Keywords::second(const char *one, const char *two)
{
  const char *text = value();
  if (strcmp(text, one) != 0 && strcmp(text, two) != 0)
    lmp->error->all(FLERR, "{} must be {} or {}, got {}", what(), one, two, text);
  return strcmp(text, two) == 0;
}

}    // namespace SPHTM_NS
