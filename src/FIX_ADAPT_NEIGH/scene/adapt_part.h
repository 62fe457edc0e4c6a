/* SPH-TM: a part of fix adapt/neigh: adaptive lists, smoothing length, refinement. Each owns its keywords, its values
   of particles and its outputs; the fix passes every call of LAMMPS on to the parts in use. */
#ifndef SPHTM_ADAPT_PART_H
#define SPHTM_ADAPT_PART_H

#include "adapt_parts.h"
#include "particle_values.h"

#include <cstddef>
#include <string>
#include <vector>

namespace SPHTM_NS {

class Keywords;

class AdaptPart {
 public:
  explicit AdaptPart(AdaptParts &all) : parts(all) {}
  virtual ~AdaptPart() = default;

  // reads the values of the keyword, where it is one of its own; false: it is not
  virtual bool keyword(Keywords &) = 0;
  virtual std::vector<std::string> keywords() const = 0;
  virtual std::vector<std::string> options() const { return {}; }    // that may follow the first keyword
  virtual bool in_use() const = 0;
  virtual bool on_host() const { return false; }    // works on LAMMPS's particles of the host in any step
  virtual void ready() {}    // once, when all keywords are read and the fix is LAMMPS's; may add other fixes

  // the calls of LAMMPS, in the order of a step; AdaptParts::state() and the others are known from init on
  virtual void init() {}
  virtual void setup_pre_exchange() {}
  virtual void setup_pre_force() {}
  virtual void setup() {}
  virtual void pre_exchange() {}    // before particles migrate; only in steps that renew the lists
  virtual void pre_force() {}
  virtual void end_of_step() {}
  virtual void post_run() {}

  virtual ParticleValues *values() { return nullptr; }
  // before a run: since the last one particles were moved, or have got other IDs, by other commands
  virtual void changed(bool /*moved*/, bool /*renamed*/) {}
  // values of the whole, for restart files
  virtual std::vector<double> state() { return {}; }
  virtual bool restore(const double *, size_t) { return true; }    // false: they cannot be of this part

  // outputs: entries of the fix's vector, with their names for the doc and messages
  virtual std::vector<std::string> outputs() const { return {}; }
  virtual double output(int) { return 0.0; }
  virtual double bytes() const { return 0.0; }
  virtual void offer(Scene::Adaptation &) {}    // to other styles

 protected:
  AdaptParts &parts;
};

}    // namespace SPHTM_NS

#endif
