/* SPH-TM: material constants from the input script or from a card file.

   Inline, in the units of the run:
     density rho | elastic E nu | eos linear | eos shock c0 s gamma | eos tait n |
     strength <law> with the constants of the law, see TM_STRENGTH_LAWS in tm_material.h | damage johnson/cook D1 D2 D3 D4 D5 | damage strain emax | damage none |
     heat k cp chi | emissivity e | body solid | body heat
   in any order; k and cp may be 'table/N T1 y1 ... TN yN'. Then, or after the name of a card,
   'set <constant> <value>' changes one constant. Cards are in SI: see material_card.h. */
#ifndef SPHTM_MATERIAL_INPUT_H
#define SPHTM_MATERIAL_INPUT_H

#include "tm_material.h"

#include <string>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace SPHTM_NS {

// style is the command for messages, e.g. "Pair sph/tm coeff"; the constants start at arg[first]
tm_material material_from_args(LAMMPS_NS::LAMMPS *lmp, const char *style, int narg, char **arg, int first = 0);

// the card of this name, looked for in the file as given, in LAMMPS_POTENTIALS, then in
// SPHTM_MATERIALS; the keywords from arg[first] on override it, in the units of the run
tm_material material_from_card(LAMMPS_NS::LAMMPS *lmp, const char *style, const char *file, const char *name,
                               int narg = 0, char **arg = nullptr, int first = 0);

// either: constants when arg[0] is one of the keywords, else file and card name
tm_material read_material(LAMMPS_NS::LAMMPS *lmp, const char *style, int narg, char **arg);

// name of the card, or "inline"
std::string material_title(int narg, char **arg);

}    // namespace SPHTM_NS

#endif
