/* -*- c++ -*- ----------------------------------------------------------
   SPH-TM: fix sph/tm/relax. Dynamic relaxation of a group to its static
   equilibrium, and how far from it the group is.
------------------------------------------------------------------------- */
#ifndef LMP_FIX_SPH_TM_RELAX_H
#define LMP_FIX_SPH_TM_RELAX_H

#include "fix.h"

#include "equal_value.h"
#include "scene.h"
#include "tm_relax.h"

#include <vector>

namespace LAMMPS_NS {

class FixSPHTMRelax : public Fix {
 public:
  FixSPHTMRelax(class LAMMPS *, int, char **);
  int setmask() override;
  void init() override;
  void setup(int) override;
  void post_force(int) override;
  double compute_scalar() override;
  double compute_vector(int) override;
  void write_restart(FILE *) override;
  void restart(char *) override;

 private:
  std::shared_ptr<SPHTM_NS::Scene> scene;
  SPHTM_NS::ParticleState *state = nullptr;    // of fix sph/tm
  bool adapts = true;                          // damping auto
  SPHTM_NS::EqualValue given;
  int driven[3] = {0, 0, 0};            // bits of the groups of fix sph/tm/drive, by direction
  double damping = 0.0, taken = 0.0;    // of all ranks: of the next step; energy so far
  tm_relax_mode mode = {};
  tm_relax_result sums = {};    // of all ranks, of the last step

  std::vector<class FixSPHTMDrive *> drives;    // of this run
  bool warned_motion = false;

  void sum(bool act);
  void warn_of_motion();
  double elastic_energy();
};

}    // namespace LAMMPS_NS

#endif
