/* SPH-TM: what the contact forces of a step add up to: on this rank, once the loop over the particles has ended, and over
   all ranks, once it is asked for. */
#ifndef SPHTM_CONTACT_RESULTS_H
#define SPHTM_CONTACT_RESULTS_H

#include "tm_contact_tri.h"
#include "unit_scale.h"

#include <mpi.h>

namespace SPHTM_NS {

class Backend;

class ContactResults {
 public:
  // entries of the sums over ranks, in the unit style; at REFERENCE stands the point of the torques
  enum { FORCE = 0, TORQUE = 3, REFERENCE = 6, FRICTION_POWER = 9, HEAT, CONTACTS, DEPTH, SIZE };

  ContactResults() : sums(tm_contact_nothing()) {}
  ~ContactResults();
  ContactResults(const ContactResults &) = delete;
  ContactResults &operator=(const ContactResults &) = delete;
  void live_in(Backend &);
  tm_contact_result *begin();    // where the loop of a new step leaves its sums
  bool finish();                 // waits for it; whether there was one that had not been waited for
  // mass-length-time units, of this rank
  const tm_contact_result &mine() const { return sums; }
  double heat_into_tool(MPI_Comm world) const;    // of all ranks
  double depth(MPI_Comm world) const;
  // collective, where they are not known yet; depths are over spacing
  const double *over_ranks(MPI_Comm world, const UnitScale &, double spacing);

 private:
  Backend *loops = nullptr;
  tm_contact_result *result = nullptr;    // of the loop on its way
  tm_contact_result sums;
  bool pending = false, reduced = false;
  double totals[SIZE] = {};
};

}    // namespace SPHTM_NS

#endif
