/* SPH-TM: what a script gets wrong: other fixes and commands, groups, particles that overlap or have another spacing
   than their masses, what changes between runs. */
#ifndef SPHTM_START_CHECKS_H
#define SPHTM_START_CHECKS_H

#include "tm_neighbors.h"

#include "lmptype.h"
#include "pointers.h"

#include <cstdint>
#include <array>
#include <string>
#include <vector>

namespace LAMMPS_NS {
class Fix;
class Pair;
}    // namespace LAMMPS_NS

namespace SPHTM_NS {

class Model;
class ParticleState;
class Scene;

class StartChecks : protected LAMMPS_NS::Pointers {
 public:
  StartChecks(LAMMPS_NS::LAMMPS *, const LAMMPS_NS::Fix &, ParticleState &, const Scene &);

  // at init
  void check_company(const LAMMPS_NS::Pair *);    // of the pair style: other fixes and commands
  void check_begun(bool begin_anew);              // a fix that is written again would begin with an unstressed body
  // before new particles get their state: which are new, and whether others have changed what they are made of
  void look_at_changes();
  // at the set-up, with forces
  void check_start();      // of the first run
  void check_changes();    // of a run that goes on: what came or was moved since the last one
  // at the end of a run
  void remember_particles();

 private:
  const LAMMPS_NS::Fix &fix;    // fix sph/tm
  ParticleState &state;
  const Scene &scene;
  struct Filling {    // of the particles of this rank
    double particles = 0, off = 0, right = 0, densest = 0.0, thinnest = 1e300;
    double inside = 0, sum = 0.0, square = 0.0;    // those with neighbors all around, and of their lattice sums
    int dense_at = -1, thin_at = -1;
  };
  struct {
    std::vector<LAMMPS_NS::bigint> types;        // how many particles of each; empty: there was no run
    std::vector<uint64_t> tags, positions;       // of each, [0] of all: hash over its particles, in any order
    std::vector<double> density, bulk, shear;    // of each: reference density, elastic moduli
    std::vector<bool> flows;
    double nearest = 0.0;                                         // the smallest distance of two
    double mean_nearest = 0.0, pair_density = 0.0, mass = 0.0;    // means (tm_nearest) and sum over all
    double depth = 0.0;                                           // of bodies of particles in each other
    uint64_t places = 0;
    std::vector<std::array<double, 3>> arms;    // of each: from the particle of the lowest tag to that of the highest
    LAMMPS_NS::bigint particles = 0;
  } last_run;
  std::vector<LAMMPS_NS::tagint> fresh;    // of all ranks: those that came since then

  const Model &model() const;
  void check_integrators();
  void check_materials_kept(const std::vector<LAMMPS_NS::bigint> &particles_of_types);
  std::vector<LAMMPS_NS::bigint> particles_of_types(bool old_only);
  std::vector<uint64_t> hash_of_types(bool positions);    // else tags
  void check_types_kept(const std::vector<LAMMPS_NS::bigint> &particles_of_types);
  uint64_t places_hash();
  double total_mass();
  std::vector<std::array<double, 3>> arms_of_types();
  void check_strain(const tm_nearest &);
  void check_turned();
  void check_values();
  void check_temperature() const;
  void check_overlap(const tm_nearest &, double least);
  void check_bodies(double before, bool first);
  void check_still();
  void check_filling(bool of_fresh);
  std::string spacing_in_words(double) const;
  void judge_spacing(const Filling &, double of_lattice);
  void judge_filling(const Filling &, double of_lattice, bool sizes);
};

}    // namespace SPHTM_NS

#endif
