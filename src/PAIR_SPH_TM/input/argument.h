/* SPH-TM: values of a command, with messages that name the command, the keyword and what was given.
   what is "<style> <keyword>", e.g. "Pair style sph/tm spacing". Infinite and NaN are refused. */
#ifndef SPHTM_ARGUMENT_H
#define SPHTM_ARGUMENT_H

#include <string>
#include <vector>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace SPHTM_NS {

double number(LAMMPS_NS::LAMMPS *lmp, const std::string &what, const char *text);
double positive(LAMMPS_NS::LAMMPS *lmp, const std::string &what, const char *text);
double not_negative(LAMMPS_NS::LAMMPS *lmp, const std::string &what, const char *text);
// above lo, at most hi
double number_within(LAMMPS_NS::LAMMPS *lmp, const std::string &what, const char *text, double lo, double hi);
int integer_within(LAMMPS_NS::LAMMPS *lmp, const std::string &what, const char *text, int lo, int hi);
// of a temperature that is most likely in degrees Celsius: a warning
void warn_of_celsius(LAMMPS_NS::LAMMPS *lmp, const std::string &what, double temperature);
bool yes_no(LAMMPS_NS::LAMMPS *lmp, const std::string &what, const char *text, const char *choice = "yes or no");

// The keywords of a style, their options and their values, read from left to right; an option stands behind its
// keyword. part names one of several values.
class Keywords {
 public:
  Keywords(LAMMPS_NS::LAMMPS *l, const std::string &s, int n, char **a) : lmp(l), style(s), left(n), arg(a) {}
  bool next();                                        // to the next keyword; false: there is none
  bool option(const std::vector<std::string> &of);    // to the next word, where it is one of these options
  const std::string &name() const { return opt.empty() ? key : opt; }
  bool is(const char *word) const { return name() == word; }
  [[noreturn]] void unknown(const std::string &known) const;
  void need(int values) const;    // an error where fewer are left
  int rest() const { return left; }
  const char *ahead(int k) const { return k < left ? arg[k] : nullptr; }    // word k of those to come
  bool number_ahead(int k = 0) const;                                       // it is a number
  bool take(const char *word);                                              // this one, where it comes next
  const char *value();
  const char *given() const { return arg[-1]; }    // the value that was read last
  double number(const char *part = "") { return SPHTM_NS::number(lmp, what(part), value()); }
  double positive(const char *part = "") { return SPHTM_NS::positive(lmp, what(part), value()); }
  double not_negative(const char *part = "") { return SPHTM_NS::not_negative(lmp, what(part), value()); }
  double between(double lo, double hi, const char *part = "");    // either may be reached
  double share(const char *part = "") { return between(0.0, 1.0, part); }
  double within(double lo, double hi, const char *part = "") { return number_within(lmp, what(part), value(), lo, hi); }
  int integer(int lo, int hi, const char *part = "") { return integer_within(lmp, what(part), value(), lo, hi); }
  bool yes(const char *part = "") { return yes_no(lmp, what(part), value()); }
  bool on(const char *part = "") { return yes_no(lmp, what(part), value(), "on or off"); }
  bool second(const char *one, const char *two);    // of these words: one false, two true
  std::string what(const std::string &part = "") const;

 private:
  LAMMPS_NS::LAMMPS *lmp;
  std::string style, key, opt;
  int left;
  char **arg;    // of those to come
};

}    // namespace SPHTM_NS

#endif
