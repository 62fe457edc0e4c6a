/* SPH-TM: values of particles that LAMMPS moves with them, of one part of fix adapt/neigh. */
#ifndef SPHTM_PARTICLE_VALUES_H
#define SPHTM_PARTICLE_VALUES_H

#include <cmath>
#include <string>

namespace SPHTM_NS {

// a value of a restart file is an integer in that range
inline bool is_whole(double v, double lo, double hi) { return v >= lo && v <= hi && v == std::floor(v); }

class ParticleValues {
 public:
  virtual ~ParticleValues() = default;
  virtual void grow(int nmax) = 0;
  virtual void copy(int from, int to) = 0;
  virtual void set_new(int i) = 0;
  virtual int most_packed() const = 0;    // values of one particle, at most
  virtual int pack(int i, double *) = 0;
  virtual int unpack(int i, const double *) = 0;
  // how many of the n values of a particle in a restart file are of this part; -1 and the reason where they cannot be
  virtual int check(const double *, int n, std::string &why) const = 0;
  // the same where the loops run, with Kokkos: particle order[i] to index i; particles sent to another rank, with the
  // index of the one that takes its place (or -1); received ones, to an index (or -1): most_packed() values each
  virtual void reorder(int /*n*/, const int * /*order*/) {}
  virtual void send(int /*n*/, const int * /*sent*/, const int * /*filled_by*/, double *) {}
  virtual void receive(int /*n*/, const int * /*index*/, double *) {}
};

}    // namespace SPHTM_NS

#endif
