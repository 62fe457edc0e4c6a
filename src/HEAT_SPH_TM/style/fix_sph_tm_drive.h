/* -*- c++ -*- ----------------------------------------------------------
   SPH-TM: fix sph/tm/drive. Prescribed velocity of a group that fix sph/tm
   integrates, and the force and work this takes.
------------------------------------------------------------------------- */
#ifndef LMP_FIX_SPH_TM_DRIVE_H
#define LMP_FIX_SPH_TM_DRIVE_H

#include "fix.h"

#include "equal_value.h"
#include "scene.h"

namespace LAMMPS_NS {

class FixSPHTMDrive : public Fix {
 public:
  FixSPHTMDrive(class LAMMPS *, int, char **);
  int setmask() override;
  void init() override;
  void setup(int) override;
  void post_force(int) override;
  double compute_scalar() override;
  double compute_vector(int) override;
  void write_restart(FILE *) override;
  void restart(char *) override;
  bool drives(int k) const { return given[k]; }    // x, y, z
  bool moves();                                    // its velocity is not 0, or varies

 private:
  std::shared_ptr<SPHTM_NS::Scene> scene;
  SPHTM_NS::ParticleState *state = nullptr;    // of fix sph/tm
  bool given[3] = {false, false, false};
  SPHTM_NS::EqualValue velocity[3];
  double sum[4] = {0.0, 0.0, 0.0, 0.0};    // of this rank: force on the drive, work of the drive so far

  void check_group();
  void warn_of_later_forces();
  void velocity_now(double *target);
  void limit_time_step(const double *target);
  void drive(const double *velocity, bool act);
};

}    // namespace LAMMPS_NS

#endif
