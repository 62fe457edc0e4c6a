/* SPH-TM: sums of a step's contact over particles: of this rank, once the loop has ended, and over all ranks, where
   they are needed. */
#ifndef SPHTM_CONTACT_RESULTS_H
#define SPHTM_CONTACT_RESULTS_H

#include "backend.h"
#include "energy_balance.h"
#include "tm_contact_tri.h"
#include "unit_scale.h"

#include <mpi.h>

namespace SPHTM_NS {

class ContactResults {
 public:
  // entries of the sums over ranks, in the unit style; at REFERENCE stands the point of the torques
  enum { FORCE = 0, TORQUE = 3, REFERENCE = 6, FRICTION_POWER = 9, HEAT, CONTACTS, DEPTH, SIZE };

  ContactResults() : sums(tm_contact_nothing()) {}
  ~ContactResults();
  ContactResults(const ContactResults &) = delete;
  ContactResults &operator=(const ContactResults &) = delete;
  void live_in(Backend &);
  tm_contact_result *begin();                   // where the loop of a new step leaves its sums
  tm_contact_result *late() { return more; }    // the same for tm_contact_late()
  // a tool that comes in overlap brings the energy of its springs along (sign 1), one that goes takes it away (-1)
  void take_springs(EnergyBalance &, double sign) const;
  void add_late(EnergyBalance &, double dt);    // waits for it
  bool finish();                                // waits for it; whether there was one that had not been waited for
  // mass-length-time units: of this rank; over ranks (collective)
  const tm_contact_result &mine() const { return sums; }
  bool pressed(MPI_Comm world);    // in any step since this was asked last; collective
  double heat_into_tool(MPI_Comm world) const { return over(world, sums.heat_tool, MPI_SUM); }
  double depth(MPI_Comm world) const { return over(world, sums.depth, MPI_MAX); }
  double within(MPI_Comm world) const { return over(world, sums.within, MPI_MAX); }
  // work and heat of a step of length dt; with tool_particles the heat into the tool is heat of particles too
  void add_to(EnergyBalance &, double dt, bool tool_particles) const;
  // collective, where they are not known yet; the depth is over the spacing
  const double *over_ranks(MPI_Comm world, const UnitScale &, double spacing);

 private:
  Backend *loops = nullptr;
  tm_contact_result *result = nullptr, *more = nullptr;    // of the loops on their way
  tm_contact_result sums;
  bool pending = false, reduced = false, has_pressed = false;
  double totals[SIZE] = {};

  static double over(MPI_Comm world, double mine, MPI_Op);
};

}    // namespace SPHTM_NS

#endif
