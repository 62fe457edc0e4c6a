/* SPH-TM: what the neighbors of an audit's particles show with effects on that are off: corrections of their gradients, and
   smoothing lengths as they should be. Both need the neighbors of the neighbors, on whatever rank. */
#ifndef SPHTM_AUDIT_SURROUNDINGS_H
#define SPHTM_AUDIT_SURROUNDINGS_H

#include "audit_patch.h"
#include "row_source.h"

#include "pointers.h"

#include <vector>

namespace SPHTM_NS {

class ParticleState;
class Scene;

class AuditSurroundings : protected LAMMPS_NS::Pointers {
 public:
  // of a particle: K, and with faces its antisymmetric part and the normal; P K
  struct Correction {
    double K[6], turn[3], normal[3], PK[TM_REC_CORRECTION];
  };
  struct Around {    // of a particle: its corrections, and its smoothing length as it should be
    double tag, size[TM_REC_SIZE];
    Correction linear, second;    // of linear order and, with one pass, of second order at faces
  };
  struct Stabilized {    // records of one pass with corrections of this force point, K and its antisymmetric part
    std::vector<double> stab, K, turn;
  };

  AuditSurroundings(LAMMPS_NS::LAMMPS *, ParticleState &, const Scene &);
  std::vector<Around> of_members(AuditSearch &, const AuditPatch &, unsigned effects);
  // of second order at faces, or of linear order
  static Stabilized stabilized(const AuditPatch &, const std::vector<Around> &, bool faces, double alpha);

  double moments = 0.0;    // processor time of the corrections of one particle, summed over the audits

 private:
  ParticleState &state;
  const Scene &scene;
  std::vector<double> gradient_factors;    // tm_gradient_table
  std::vector<Around> of_centers(AuditPatch &, unsigned effects, const SmoothingRule &);
  void corrections(AuditPatch &, tm_rates_args, unsigned effects, std::vector<Around> &);
};

}    // namespace SPHTM_NS

#endif
