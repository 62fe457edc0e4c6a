/* SPH-TM: a part of fix adapt/neigh: adaptive lists, smoothing length, refinement. Each owns its keywords, its
   values of particles and its outputs; the fix hands every call of LAMMPS on to the parts that are in use. */
#ifndef SPHTM_ADAPT_PART_H
#define SPHTM_ADAPT_PART_H

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace LAMMPS_NS {
class FixSPHTM;
class PairSPHTM;
class FixAdaptNeigh;
}    // namespace LAMMPS_NS

namespace SPHTM_NS {

class Keywords;

// a value of a restart file is a whole number in that range
inline bool is_whole(double v, double lo, double hi) { return v >= lo && v <= hi && v == std::floor(v); }

class AdaptPart {
 public:
  explicit AdaptPart(LAMMPS_NS::FixAdaptNeigh &owner) : fix(owner) {}
  virtual ~AdaptPart() = default;

  // reads the values of the keyword, where it is one of its own; false: it is not
  virtual bool keyword(Keywords &) = 0;
  virtual std::vector<std::string> keywords() const = 0;
  virtual std::vector<std::string> options() const { return {}; }    // that may follow the first keyword
  virtual bool in_use() const = 0;
  virtual bool on_host() const { return false; }    // works on LAMMPS's particles of the host in any step

  virtual void ready() {}    // once, when all keywords are read and the fix is LAMMPS's; may add other fixes

  // the calls of LAMMPS, in the order of a step; body and pair of the fix are known from init on
  virtual void init() {}
  virtual void setup_pre_exchange() {}
  virtual void setup_pre_force() {}
  virtual void setup() {}
  virtual void pre_exchange() {}      // before particles migrate; only in steps that renew the lists
  virtual void post_neighbor() {}     // after they have
  virtual void pre_force() {}
  virtual void end_of_step() {}
  virtual void post_run() {}

  // refinement, in pre_exchange: owned particle i has come out of a split or a merge, its h is that factor of
  // what it was; the neighbors of i have changed, i not
  virtual void remade(int /*i*/, double /*factor*/) {}
  virtual void neighborhood_changed(int /*i*/) {}

  // values of particles, that LAMMPS moves with them
  virtual bool has_values() const { return false; }
  virtual void grow(int /*nmax*/) {}
  virtual void copy(int /*from*/, int /*to*/) {}
  virtual void set_new(int /*i*/) {}
  virtual int most_packed() const { return 0; }    // values of one particle, at most
  virtual int pack(int /*i*/, double *) { return 0; }
  virtual int unpack(int /*i*/, const double *) { return 0; }
  // how many of the n values of a particle in a restart file are this part's; -1 and why where they cannot be
  virtual int look(const double *, int /*n*/, std::string & /*why*/) const { return 0; }
  // the same where the loops run, with Kokkos: particle order[i] to place i; those that go to another rank, with who
  // takes their places (or -1), and those that come from one, to a place (or -1), as most_packed() values each
  virtual void reorder(int /*n*/, const int * /*order*/) {}
  virtual void send(int /*n*/, const int * /*sent*/, const int * /*filled_by*/, double *) {}
  virtual void receive(int /*n*/, const int * /*place*/, double *) {}
  // before a run: since the last one particles were moved, or have got other IDs, by other commands
  virtual void changed(bool /*moved*/, bool /*renamed*/) {}
  // values of the whole, for restart files
  virtual std::vector<double> state() { return {}; }
  virtual bool restore(const double *, size_t) { return true; }    // false: they cannot be this part's

  // outputs: entries of the fix's vector, with their names for the doc and messages
  virtual std::vector<std::string> outputs() const { return {}; }
  virtual double output(int) { return 0.0; }
  virtual double bytes() const { return 0.0; }
  virtual void *extract(const char *) { return nullptr; }    // what other styles ask for by name

 protected:
  LAMMPS_NS::FixAdaptNeigh &fix;
};

}    // namespace SPHTM_NS

#endif
