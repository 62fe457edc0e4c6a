/* SPH-TM: which values that fixes of LAMMPS's ask for need particles on the host. A force on a tool, an energy, the time
   do not; LAMMPS would bring all particles from a GPU for them. */
#ifndef SPHTM_HOST_INPUTS_KOKKOS_H
#define SPHTM_HOST_INPUTS_KOKKOS_H

#include <string>
#include <vector>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace SPHTM_NS {

// of an input c_ID, f_ID or v_name, with or without [index]; what is not known needs them
bool input_needs_particles(LAMMPS_NS::LAMMPS *, const std::string &input);
// of a formula of a variable
bool formula_needs_particles(LAMMPS_NS::LAMMPS *, const std::string &formula);
// of a text with $x, ${name} and $(formula)
bool text_needs_particles(LAMMPS_NS::LAMMPS *, const std::string &text);

}    // namespace SPHTM_NS

#endif
