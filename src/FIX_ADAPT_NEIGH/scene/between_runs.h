/* SPH-TM: what commands do to particles between two runs. delete_atoms and reset_atoms give particles other IDs,
   displace_atoms, change_box and set other positions, and no style is told. Parts of fix adapt/neigh that know
   particles by them learn it here. */
#ifndef SPHTM_BETWEEN_RUNS_H
#define SPHTM_BETWEEN_RUNS_H

#include "adapt_parts.h"

namespace SPHTM_NS {

class BetweenRuns {
 public:
  explicit BetweenRuns(AdaptParts &all) : parts(all) {}
  void begin();                                        // particles are those of the end of a run
  void begin_read(int i, int tag, const double *x);    // particle i is in a restart file
  void end();                                          // collective: compares and calls AdaptPart::changed()
  void stop() { on = false; }                          // particles get other indices unseen
  bool is_on() const { return on; }
  // calls of LAMMPS
  void copy(int from, int to);
  void set_new(int i);
  void leave(int i);
  void arrive(int i);

 private:
  AdaptParts &parts;
  bool on = false, moved = false, renamed = false;
  double least = 0.0;           // displacement that counts
  std::vector<int> tag_then;    // of owned particles; 0: not known
  std::vector<double> x_then;

  void clear();
  void remember(int i, int tag, const double *x);
  void compare(int i, int tag, const double *x);
};

}    // namespace SPHTM_NS

#endif
