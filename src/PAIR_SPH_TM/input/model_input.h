/* SPH-TM: arguments of pair_style sph/tm and its pair_coeff. See doc/pair_sph_tm.rst. */
#ifndef SPHTM_MODEL_INPUT_H
#define SPHTM_MODEL_INPUT_H

namespace LAMMPS_NS {
class LAMMPS;
}

namespace SPHTM_NS {

class Model;
struct Settings;

Settings read_settings(LAMMPS_NS::LAMMPS *, int narg, char **arg);
void check_spacing_kept(LAMMPS_NS::LAMMPS *, const Settings &before, const Settings &now);    // after a run
void read_coefficients(LAMMPS_NS::LAMMPS *, int narg, char **arg, Model &);    // a material, or how types meet

}    // namespace SPHTM_NS

#endif
