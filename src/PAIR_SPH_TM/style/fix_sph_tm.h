/* -*- c++ -*- ----------------------------------------------------------
   SPH-TM: fix sph/tm. Owns the state of every particle and moves it:
   (model, results) to state, predictor and corrector both.
------------------------------------------------------------------------- */
#ifndef LMP_FIX_SPH_TM_H
#define LMP_FIX_SPH_TM_H

#include "fix.h"

#include "energy_report.h"
#include "fracture_watch.h"
#include "run_table.h"
#include "scene.h"
#include "start_checks.h"
#include "state_restart.h"
#include "stop_report.h"

#include <memory>

namespace SPHTM_NS {
class AccuracyMeter;
class Keywords;
}    // namespace SPHTM_NS

namespace LAMMPS_NS {

class FixSPHTM : public Fix, public SPHTM_NS::StepOwner {
 public:
  FixSPHTM(class LAMMPS *, int, char **);
  ~FixSPHTM() override;
  int setmask() override;
  void init() override;
  void setup(int) override;
  void initial_integrate(int) override;
  void final_integrate() override;
  void end_of_step() override;
  void pre_exchange() override;
  void post_neighbor() override;
  void post_run() override;
  void reset_dt() override {}
  double compute_scalar() override;
  double compute_vector(int) override;
  double compute_array(int, int) override;
  int modify_param(int, char **) override;

  void grow_arrays(int) override;
  void copy_arrays(int, int, int) override;
  void set_arrays(int) override;
  int pack_exchange(int, double *) override;
  int unpack_exchange(int, double *) override;
  int pack_restart(int, double *) override;
  void unpack_restart(int, int) override;
  int size_restart(int) override;
  int maxsize_restart() override;
  void write_restart(FILE *) override;
  void write_data_header(FILE *, int) override;
  void restart(char *) override;
  double memory_usage() override;

  void begin_forces() override;
  SPHTM_NS::StepAudit *audit_now() override;

 protected:
  FixSPHTM(class LAMMPS *, int, char **, SPHTM_NS::Backend &, std::unique_ptr<SPHTM_NS::AtomArrays>);
  bool leaves = false;    // there is a particle that LAMMPS deletes in the exchange of this step
  std::shared_ptr<SPHTM_NS::Scene> scene;
  SPHTM_NS::ParticleState state;

 private:
  bool check_lost(double gone = 0.0);    // whether some has left the box; a stop where none may
  SPHTM_NS::StartChecks start;
  SPHTM_NS::StopReport stops;
  SPHTM_NS::EnergyReport energies;
  SPHTM_NS::FractureWatch fracture;
  SPHTM_NS::RunTable table;
  SPHTM_NS::StateRestart file;
  std::unique_ptr<SPHTM_NS::AccuracyMeter> meter;    // with the keyword audit
  bool begin_anew = false;                           // though steps were taken
  bool stop_on_lost = true;                          // a particle beyond a fixed boundary stops the run
  bool source_of_setup = false;                      // the heat source holds what the set-up's forces left
  bool looked = false;                               // at the energies, since the last set-up
  bool data_warned = false;
  int *lost = nullptr;    // what the drift of so many particles found, once it is through
  int drifted = 0;

  void read_keywords(SPHTM_NS::Keywords &&);
  bool read_setting(SPHTM_NS::Keywords &);
};

}    // namespace LAMMPS_NS

#endif
