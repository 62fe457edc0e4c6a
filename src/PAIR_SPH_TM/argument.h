/* SPH-TM: values of a command, with messages that name the command, the keyword and what was given.
   what is "<style> <keyword>", e.g. "Pair style sph/tm spacing". Infinite and NaN are refused. */
#ifndef SPHTM_ARGUMENT_H
#define SPHTM_ARGUMENT_H

#include <string>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace SPHTM_NS {

double number(LAMMPS_NS::LAMMPS *lmp, const std::string &what, const char *text);
double positive(LAMMPS_NS::LAMMPS *lmp, const std::string &what, const char *text);
double not_negative(LAMMPS_NS::LAMMPS *lmp, const std::string &what, const char *text);
// above lo, at most hi
double number_within(LAMMPS_NS::LAMMPS *lmp, const std::string &what, const char *text, double lo,
                     double hi);
int integer_within(LAMMPS_NS::LAMMPS *lmp, const std::string &what, const char *text, int lo, int hi);
bool yes_no(LAMMPS_NS::LAMMPS *lmp, const std::string &what, const char *text);

}    // namespace SPHTM_NS

#endif
