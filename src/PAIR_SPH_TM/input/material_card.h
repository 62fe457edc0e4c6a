/* SPH-TM: a card in a file of material cards.

   A card file holds 'material <name>', keywords with their constants in SI, one per line, and 'end';
   # begins a comment, a final & continues a line. */
#ifndef SPHTM_MATERIAL_CARD_H
#define SPHTM_MATERIAL_CARD_H

#include <string>
#include <vector>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace SPHTM_NS {

struct CardLine {
  int number;    // in the file, from 1
  std::vector<std::string> words;
};

// the lines between 'material name' and 'end'; the file is looked for as given, in LAMMPS_POTENTIALS,
// in SPHTM_MATERIALS, then with the plugin. Rank 0 reads. Stops, with the names there are, when the card is not there.
std::vector<CardLine> find_card(LAMMPS_NS::LAMMPS *lmp, const char *style, const char *file, const char *name);

}    // namespace SPHTM_NS

#endif
