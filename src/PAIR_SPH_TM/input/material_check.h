/* SPH-TM: constants of a metal that no metal has: mostly numbers in other units than those of the run. */
#ifndef SPHTM_MATERIAL_CHECK_H
#define SPHTM_MATERIAL_CHECK_H

#include "tm_material.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace SPHTM_NS {

// A warning for each; of materials with strength plastic or johnson/cook, in styles of units with SI values. m is in
// the units of the style
void warn_of_units(LAMMPS_NS::LAMMPS *, const char *style, const tm_material &m);

}    // namespace SPHTM_NS

#endif
