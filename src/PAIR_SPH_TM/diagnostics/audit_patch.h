/* SPH-TM: some particles with their neighbors of a fresh search, in an order and arrays of their own, so that
   the loops of the host can take their rates apart from those of the run. */
#ifndef SPHTM_AUDIT_PATCH_H
#define SPHTM_AUDIT_PATCH_H

#include "search_loops.h"

#include "pointers.h"

#include <vector>

namespace SPHTM_NS {

class ParticleState;

struct AuditPatch {
  std::vector<int> member;    // places in the arrays of the run: the centers first, then their neighbors
  int centers = 0;
  std::vector<int> index, mechanical, none;
  std::vector<ptrdiff_t> first;
  std::vector<double> main, stress, heat, size, correction, hourglass, stab;    // records of the members
  int faces = 0;                                                                // stab has normals of faces

  tm_rows rows() const
  {
    return {index.data(), first.data(), mechanical.data(), none.data(), none.data(), 1, nullptr, 0};
  }
  tm_records records();
};

// all particles in cells, to find the mechanical neighbors of some owned ones
class AuditSearch : protected LAMMPS_NS::Pointers {
 public:
  AuditSearch(LAMMPS_NS::LAMMPS *, const ParticleState &, const tm_records &);
  AuditPatch around(const std::vector<int> &centers, double within);
  AuditPatch alone(const std::vector<int> &centers) const;    // without neighbors
  double seconds_of_sorting = 0.0, seconds_of_rows = 0.0;     // processor time
  double radius, farthest;                                    // of the rates; how far neighbors can be looked for
  int rows = 0;                                               // how many were searched

 private:
  void gather(AuditPatch &) const;
  tm_records rec;
  tm_search_args args = {};
  std::vector<unsigned char> meets;
  std::vector<double> x, column[3];
  std::vector<int> cell, begin, index;
  std::vector<ptrdiff_t> first;     // by owned particle
  std::vector<int> count, place;    // of all particles: place in the patch, or -1
  int room;
};

}    // namespace SPHTM_NS

#endif
