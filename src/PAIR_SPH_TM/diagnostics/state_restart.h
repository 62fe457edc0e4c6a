/* SPH-TM: the state of the particles in restart files. */
#ifndef SPHTM_STATE_RESTART_H
#define SPHTM_STATE_RESTART_H

#include "energy_watch.h"

#include "pointers.h"

#include <cstdint>
#include <cstdio>

namespace SPHTM_NS {

class ParticleState;
class Scene;

class StateRestart : protected LAMMPS_NS::Pointers {
 public:
  StateRestart(LAMMPS_NS::LAMMPS *, ParticleState &, const Scene &);

  // values of a particle
  int size() const;
  int pack(int i, double *buf);
  void unpack(int nlocal, int nth);    // from LAMMPS's extra values of owned particle nlocal
  // global values: the rows of all particles, which fields they hold, who made their sizes, time step, energies
  void write(FILE *, EnergyWatch &);
  void read(char *buf, EnergyWatch &);

  // before a run
  void check_rows();     // the rows that were written have been read, as they were written
  void check_sizes();    // a run that goes on without what made its sizes would have others

 private:
  ParticleState &state;
  const Scene &scene;
  struct {
    uint64_t rows = 0, hash = 0, rows_written = 0, hash_written = 0;
  } read_;    // from a restart file, until it is checked
  enum { SIZED_BY_ASPH = 1, SIZED_BY_REFINE = 2 };
  int sized_in_file = 0;    // what gave the particles of the file their sizes, until it is checked
  int sized_by() const;
};

}    // namespace SPHTM_NS

#endif
