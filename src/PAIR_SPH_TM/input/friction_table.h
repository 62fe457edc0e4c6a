/* SPH-TM: mu(T) of contact, as pairs of numbers on the command line: T1 mu1 T2 mu2 ... */
#ifndef SPHTM_FRICTION_TABLE_H
#define SPHTM_FRICTION_TABLE_H

#include "tm_material.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace SPHTM_NS {

class Keywords;

tm_table read_friction_table(LAMMPS_NS::LAMMPS *, Keywords &);    // of the keyword that was read last

// what is said of a friction/shear with nothing that it limits
constexpr const char *FRICTION_SHEAR_ALONE =
    "limits friction, and there is none: give friction or friction/table too; with friction 10 the limit alone is left";

// above it, without friction/shear, a percentage was most likely meant; and what is said then
constexpr double HIGH_FRICTION = 1.5;
constexpr const char *FRICTION_HIGH =
    "is a ratio of forces: 0.3 for 30 %; where the limit of the shear flow stress is meant, give friction/shear too";

}    // namespace SPHTM_NS

#endif
