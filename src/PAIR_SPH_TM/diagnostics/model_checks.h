/* SPH-TM: what is checked before a run about the model of pair style sph/tm: materials, masses, spacing and box. */
#ifndef SPHTM_MODEL_CHECKS_H
#define SPHTM_MODEL_CHECKS_H

#include <string>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace SPHTM_NS {

class Backend;
class Model;
class ParticleState;

void check_materials(LAMMPS_NS::LAMMPS *, const Model &, const char *hybrid_style);    // every type has one
// other styles; restart_fix: whose state the restart file holds, or empty
void check_styles(LAMMPS_NS::LAMMPS *, const Model &, const std::string &restart_fix, ParticleState &);
void check_volume(LAMMPS_NS::LAMMPS *, const Model &, const ParticleState &);
void check_masses(LAMMPS_NS::LAMMPS *, const Model &, const ParticleState &);
void give_masses(LAMMPS_NS::LAMMPS *, const Model &);    // to particles that have none
void check_bins(LAMMPS_NS::LAMMPS *, const Model &);
void set_skin(LAMMPS_NS::LAMMPS *, const Model &);                        // where it is the default of the unit style
void check_mixed(LAMMPS_NS::LAMMPS *, const Model &, const Backend &);    // precision mixed

}    // namespace SPHTM_NS

#endif
