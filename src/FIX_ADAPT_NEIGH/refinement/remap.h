/* SPH-TM: transfer of the state of particles where they are split, merged or moved, S13 section 4, and what that
   changes of the sums over all particles. */
#ifndef SPHTM_REMAP_H
#define SPHTM_REMAP_H

#include "cloud.h"

namespace SPHTM_NS {

class Remap {
 public:
  Remap(AdaptParts &all, Cloud &table) : parts(all), cloud(table), error(tm_content_nothing()) {}
  // neighbors of i of the same material, failed or not as i
  std::vector<int> kin(int i);
  // adds to n rows, which hold the state of i, what their places (times size) from it give
  void spread(int i, const double *place, int n, double size, double *rows);
  // velocity, mass and state of particle i from a row of the cloud; its position is the caller's
  void write_row(int i, const double *row);
  // sign times the row to the sums; angular momentum about a point near
  void add_content(tm_content &, double sign, const double *row, const double *about, int type) const;
  // a change of the sums, and energy that becomes heat
  void tally(const tm_content &change, double heat);
  const tm_content &errors() const { return error; }    // all changes of the run, of this rank
  void restore(const tm_content &c) { error = c; }

 private:
  AdaptParts &parts;
  Cloud &cloud;
  tm_content error;
  double elastic_energy(const double *row, int type) const;
};

}    // namespace SPHTM_NS

#endif
