/* SPH-TM: the energy balance summed over all ranks, for the output vector of fix sph/tm and the warnings of a run. */
#ifndef SPHTM_ENERGY_REPORT_H
#define SPHTM_ENERGY_REPORT_H

#include "energy_watch.h"

#include "lmptype.h"
#include "pointers.h"

namespace SPHTM_NS {

class ParticleState;
class Scene;

class EnergyReport : protected LAMMPS_NS::Pointers {
 public:
  // entries of the output vector
  // clang-format off
  enum Entry {
    KINETIC, ELASTIC, PLASTIC, HEAT, CONTACT, FRICTION, ARTIFICIAL, EXTERNAL, SUM, DT, CAUSE, NEIGHBORS,
    UNEXPLAINED, FAILURE, TORN, ENTRIES,
    EXCHANGED = ENTRIES, SHOCK, LEFT, SUMS    // heat from outside, bulk viscosity of shocks, what left the box: no entries
  };
  // clang-format on
  static bool is_of_balance(int entry) { return entry <= SUM || entry == UNEXPLAINED || entry == FAILURE; }
  EnergyReport(LAMMPS_NS::LAMMPS *, ParticleState &, const Scene &);

  double value(int entry);                          // now; collective
  void forget() { summed_at = counted_at = -1; }    // velocities and particles may have changed

  void set_drift_allowed(double d) { drift_allowed = d; }    // of what went in
  // at the start of a run, every so many steps, at its end; a glance does not count
  enum Look { FIRST, REGULAR, LAST, GLANCE };
  // warns and stops in the name of fix sph/tm
  void look(Look);
  // before and after LAMMPS moves particles to other ranks and deletes those that have left the box; some: of this rank
  void before_exchange(bool some);
  void after_exchange();
  EnergyWatch &watch() { return energy_watch; }

 private:
  ParticleState &state;
  const Scene &scene;
  double now[SUMS] = {};
  double unstored = 0.0;    // see EnergyWatch
  double near = 0.0;        // neighbors of a particle on the mean
  LAMMPS_NS::bigint summed_at = -1, counted_at = -1;
  EnergyWatch energy_watch;
  double drift_allowed = 0.1;
  bool leaving = false;    // some particle of all leaves

  void sum();
  void count_leaving(double sign);
  double neighbors();
  double least_energy();
  std::string likely_cause() const;
};

}    // namespace SPHTM_NS

#endif
