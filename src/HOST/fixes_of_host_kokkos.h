/* SPH-TM: fixes of LAMMPS's that look at values, with Kokkos. LAMMPS brings all particles to the host and back whenever
   such a fix takes its turn; values that no particle on the host has a part in, such as forces on a tool, are taken
   without that. */
#ifndef SPHTM_FIXES_OF_HOST_KOKKOS_H
#define SPHTM_FIXES_OF_HOST_KOKKOS_H

#include "host_inputs_kokkos.h"

#include "atom_masks.h"

#include <cstring>
#include <string>
#include <vector>

namespace SPHTM_NS {

template <class STYLE> class FixOfHostKokkos : public STYLE {
 public:
  FixOfHostKokkos(LAMMPS_NS::LAMMPS *lmp, int narg, char **arg) : STYLE(lmp, narg, arg), words(arg, arg + narg) {}
  void init() override
  {
    STYLE::init();
    const bool needs = needs_particles();
    this->kokkosable = !needs;    // or LAMMPS takes the host's particles for the newer ones while values are asked for
    this->datamask_read = needs ? ALL_MASK : EMPTY_MASK;
    this->datamask_modify = EMPTY_MASK;
  }

 private:
  std::vector<std::string> words;    // the command

  // inputs c_ID, f_ID and v_name; keywords follow them. Fix halt looks at bonds too, fix print has a text.
  bool needs_particles() const
  {
    const bool halts = words[2].compare(0, 4, "halt") == 0, prints = words[2].compare(0, 5, "print") == 0;
    if (halts && words[4] == "bondmax") return true;
    if (prints && text_needs_particles(this->lmp, words[4])) return true;
    bool begun = false;
    for (size_t k = 3; k < words.size(); k++) {
      const std::string &word = words[k];
      const bool input = word.size() > 2 && word[1] == '_' && strchr("cfv", word[0]);
      if (input && input_needs_particles(this->lmp, word)) return true;
      if (begun && !input) break;
      begun |= input || prints;
    }
    return false;
  }
};

}    // namespace SPHTM_NS

#endif
