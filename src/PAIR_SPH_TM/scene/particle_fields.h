/* SPH-TM: storage of the state fields of tm_fields.h. What no effect calls for has no memory. */
#ifndef SPHTM_PARTICLE_FIELDS_H
#define SPHTM_PARTICLE_FIELDS_H

#include "loop_array.h"
#include "tm_fields.h"

namespace SPHTM_NS {

class ParticleFields {
 public:
  explicit ParticleFields(Backend &);
  // allocate what the effects call for, free the rest; returns the mask of fields in use
  unsigned enable(unsigned effects, int nmax);
  static unsigned needed(unsigned effects);    // mask of the fields that effects need
  // allocate exactly the fields of a mask (a restart file's)
  void enable_mask(unsigned mask, int nmax);
  void grow(int nmax);
  LoopArray<double> &operator[](int id) { return values[id]; }
  unsigned mask() const { return used; }
  int columns() const { return width; }    // doubles per particle over all fields in use
  // on the host
  void copy(int from, int to);
  void zero(int i);
  int pack(int i, double *buf);
  int unpack(int i, const double *buf);
  double bytes() const;

 private:
  LoopArray<double> values[TM_F_COUNT];
  unsigned used = 0;
  int width = 0, rows = 0;
};

}    // namespace SPHTM_NS

#endif
