/* SPH-TM: between the unit style of the input and the mass-length-time units of the physics.

   The C headers compute in units made of the style's own mass, length and time, so that
   stress = mass/(length time^2) and energy = mass length^2/time^2. What a LAMMPS user writes and
   reads (pressure, energy, force, density of the style) is converted once, on the way in and out. */
#ifndef SPHTM_UNIT_SCALE_H
#define SPHTM_UNIT_SCALE_H

#include "tm_material.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace SPHTM_NS {

struct UnitScale {
  double stress = 1.0;     // user pressure unit -> mass/(length time^2)
  double energy = 1.0;     // user energy unit   -> mass length^2/time^2
  double density = 1.0;    // user density unit  -> mass/length^dim
  double force = 1.0;      // user force unit    -> mass length/time^2
};

UnitScale unit_scale(LAMMPS_NS::LAMMPS *lmp);

// material constants given in the units of the style, turned into mass-length-time units
void scale_material(tm_material &m, const UnitScale &u);

}    // namespace SPHTM_NS

#endif
