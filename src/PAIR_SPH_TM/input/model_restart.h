/* SPH-TM: the model in restart files, and what differs from that of the run that wrote one. */
#ifndef SPHTM_MODEL_RESTART_H
#define SPHTM_MODEL_RESTART_H

#include "model.h"

#include "pointers.h"

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace SPHTM_NS {

class ModelRestart : protected LAMMPS_NS::Pointers {
 public:
  explicit ModelRestart(LAMMPS_NS::LAMMPS *lmp) : Pointers(lmp) {}

  // on the first rank; behind the settings materials and laws, with the ID of fix sph/tm
  static void write_settings(FILE *, const Settings &);
  static void write(FILE *, const Model &, const std::string &fix_id, uint64_t fix_names, int **setflag);
  // on every rank
  const std::string &name_of_file(FILE *);    // that is open
  Settings read_settings(FILE *);
  void read(FILE *, Model &, int **setflag);

  const std::string &fix_id() const { return fix; }    // the fix whose state the file holds, or empty
  void compare(const Model &);                         // once, before the first run after read_restart

 private:
  std::string fix, file;
  struct Written {    // what the run had that wrote the file
    Settings settings;
    std::vector<tm_material> material;
    std::vector<PairLaw> laws;
  };
  std::unique_ptr<Written> written;

  void refuse_damaged(const std::string &fault);
  std::string name_of_parts() const;
};

}    // namespace SPHTM_NS

#endif
