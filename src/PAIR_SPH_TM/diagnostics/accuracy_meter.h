/* SPH-TM: how far the rates in use are from those of a fresh search in double with every effect on, on a sample
   of the particles, what the difference comes from, and what the artificial terms that are on add to them. The loops are those of the run, on the host, over copies
   of the records of the samples and their neighbors. See doc/fix_sph_tm.rst. */
#ifndef SPHTM_ACCURACY_METER_H
#define SPHTM_ACCURACY_METER_H

#include "audit_patch.h"
#include "audit_surroundings.h"
#include "step_audit.h"

#include "lmptype.h"
#include "pointers.h"

#include <string>

namespace SPHTM_NS {

class ParticleState;
class Scene;

class AccuracyMeter : public StepAudit, protected LAMMPS_NS::Pointers {
 public:
  // then one for each line of EFFECTS
  enum Cause { ALL, ROWS, PRECISION, SMOOTHING, FIRST_EFFECT };
  // an effect whose share of the rates is a cause: where it is off what it would add, where it is on what it adds
  struct Compared {
    bool on;
    unsigned effect;
    const char *name;
  };
  static constexpr Compared EFFECTS[] = {{false, TM_FX_VISCOSITY, "no viscosity"},
                                         {false, TM_FX_ARTSTRESS, "no artstress"},
                                         {false, TM_FX_CORRECTION, "no correction"},
                                         {false, TM_FX_FACES, "no faces"},
                                         {false, TM_FX_XSPH, "no xsph"},
                                         {false, TM_FX_CONDUCTION, "no conduction"},
                                         {true, TM_FX_VISCOSITY, "artificial: viscosity"},
                                         {true, TM_FX_ARTSTRESS, "artificial: artstress"},
                                         {true, TM_FX_HOURGLASS, "artificial: hourglass"},
                                         {true, TM_FX_XSPH, "artificial: xsph"},
                                         {true, TM_FX_FACES, "second order at faces"}};
  static constexpr int CAUSES = FIRST_EFFECT + (int) (sizeof(EFFECTS) / sizeof(Compared));
  enum Quantity { ACCELERATION, GRADIENT, HEAT, MOTION, QUANTITIES };
  static constexpr int EVERY = 1000, SAMPLE = 50;    // of 'audit yes'

  AccuracyMeter(LAMMPS_NS::LAMMPS *, ParticleState &, const Scene &, int every, int sample);
  void init();
  void restart();    // a new run
  bool due(LAMMPS_NS::bigint step) const { return step % every == 0; }

  void audit(const InUse &) override;
  LoopArray<double> &pair_force() override { return force; }

  double now(int cause) const { return last[cause]; }
  // lines for the end of the run; rates, lists: seconds of the run that went into them
  std::string report(double rates, double lists, LAMMPS_NS::bigint steps);

 private:
  ParticleState &state;
  const Scene &scene;
  const int every, sample;
  LoopArray<double> force;    // of the neighbors alone, in a step of an audit
  double last[CAUSES] = {}, largest[CAUSES] = {};
  // sums over the audits of squares: of the rates, and of their differences; of processor times
  double size[QUANTITIES] = {}, difference[CAUSES][QUANTITIES] = {};
  struct Times {
    double in_use, full, cause[CAUSES], moments, tensile, sorting, rows;    // per particle
  } times = {};
  int audits = 0;
  bool measured[CAUSES] = {};
  AuditSurroundings surroundings;

  struct Rates {
    std::vector<double> force, gradient, heat, xsph;
    double seconds;
  };
  unsigned missing() const;
  void undo_balance(const AuditPatch &, const tm_records &, std::vector<double> &main) const;
  std::vector<int> choose() const;
  Rates rates(AuditPatch &, const tm_records &, unsigned effects, const double *K, const double *turn) const;
  void add_differences(const AuditPatch &, const InUse &, const Rates *const of[], const bool shown[]);
};

}    // namespace SPHTM_NS

#endif
