/* -*- c++ -*- ----------------------------------------------------------
   SPH-TM: fix sph/tm/drive. Prescribed velocity of a group that fix sph/tm
   integrates, a turn about an axis with it, and the force and work this takes.
------------------------------------------------------------------------- */
#ifndef LMP_FIX_SPH_TM_DRIVE_H
#define LMP_FIX_SPH_TM_DRIVE_H

#include "fix.h"

#include "drive_turn.h"
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
  SPHTM_NS::DriveTurn turn;
  double radius = 0.0;                          // of the group about the axis of the turn
  double sum[5] = {0.0, 0.0, 0.0, 0.0, 0.0};    // of this rank: force on the drive, work of the drive so far, torque

  void check_group();
  void warn_of_later_forces();
  void now(double *target, double &omega);
  void limit_time_step(const double *target, double omega);
  void drive(const double *velocity, const tm_drive_turn &, bool act);
};

}    // namespace LAMMPS_NS

#endif
