/* SPH-TM: LAMMPS's arrays of particles, where the loops run: the host's, or those of Kokkos (a class of its own). */
#ifndef SPHTM_ATOM_ARRAYS_H
#define SPHTM_ATOM_ARRAYS_H

#include "tm_state.h"

#include "pointers.h"

#include <vector>

namespace LAMMPS_NS {
class Region;
}

namespace SPHTM_NS {

class AtomArrays : protected LAMMPS_NS::Pointers {
 public:
  explicit AtomArrays(LAMMPS_NS::LAMMPS *lmp) : Pointers(lmp) {}
  virtual ~AtomArrays() = default;
  virtual void point_to(tm_state &);    // for the loops
  void point_to_host(tm_state &);
  virtual void velocities_changed() {}    // by loops outside of the turns of a fix
  // for the loops: which owned particles are in a region now, good until it is asked again
  virtual const int *inside(LAMMPS_NS::Region &);
  // all arrays on the host: in the middle of a step, to be read; between steps, to be read and written; back again
  virtual void to_host_in_step() {}
  virtual void to_host() {}
  virtual void host_changed() {}

 protected:
  void match(LAMMPS_NS::Region &, int *inside) const;    // on the host

 private:
  std::vector<int> matches;
};

}    // namespace SPHTM_NS

#endif
