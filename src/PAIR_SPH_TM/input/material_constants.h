/* SPH-TM: the constants of a material by name: unit, range, and the keyword that they follow. */
#ifndef SPHTM_MATERIAL_CONSTANTS_H
#define SPHTM_MATERIAL_CONSTANTS_H

#include "tm_material.h"

#include <string>
#include <vector>

namespace SPHTM_NS {

// SI value of the units of a LAMMPS style; temperature is K in all of them
struct StyleUnits {
  const char *style;
  double mass, length, time, energy, pressure, density;
  const char *pressure_name, *density_name;
};
const StyleUnits *find_style_units(const std::string &style);    // nullptr: lj and unknown ones

namespace Material {

enum Unit { PLAIN, DENSITY, STRESS, SPEED, RATE, TEMPERATURE, PER_TEMPERATURE, CONDUCTIVITY, CAPACITY };

double si_value(Unit unit, const StyleUnits &u);
const char *si_name(Unit unit);
std::string style_name(Unit unit, const StyleUnits &u);    // of the unit in the style

enum Range { ANY, POSITIVE, NOT_NEGATIVE, SHARE, POISSON };
bool in_range(Range range, double x);
const char *range_text(Range range);

// every constant: its name for 'set' and messages, where it goes, its unit and its range
struct Constant {
  const char *name;
  tm_real tm_material::*number;
  tm_table tm_material::*table;
  Unit unit;
  Range range;
};
const std::vector<Constant> &constants();
const Constant *find_constant(const std::string &name);    // nullptr: no such

// every keyword with its option, what it selects and the constants that follow
struct Group {
  const char *keyword, *option;
  int tm_material::*selector;
  int choice;
  std::vector<std::string> constants;
};
const std::vector<Group> &groups();
const Group &strength_of(const tm_material &);
bool uses(const Group &, const std::string &constant);
bool is_keyword(const std::string &word);    // of a group, or 'set'

// lists for messages
std::string join(const std::vector<std::string> &words);
std::string known_keywords();
std::string known_options(const std::string &keyword);
std::string known_constants();
std::string known_flow_laws();    // the laws of strength with plastic flow

}    // namespace Material
}    // namespace SPHTM_NS

#endif
