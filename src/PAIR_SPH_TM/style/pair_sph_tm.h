/* -*- c++ -*- ----------------------------------------------------------
   SPH-TM: pair style sph/tm. Reads settings, materials and how types meet
   into the model, and computes: (model, state, rows) to results. The state
   belongs to fix sph/tm.
------------------------------------------------------------------------- */
#ifndef LMP_PAIR_SPH_TM_H
#define LMP_PAIR_SPH_TM_H

#include "interior.h"
#include "pair.h"
#include "scene.h"

#include <memory>

namespace SPHTM_NS {
class ModelRestart;
}

namespace LAMMPS_NS {

class PairSPHTM : public Pair {
 public:
  PairSPHTM(class LAMMPS *, SPHTM_NS::Backend & = SPHTM_NS::Backend::host());
  ~PairSPHTM() override;
  void compute(int, int) override;
  void settings(int, char **) override;
  void coeff(int, char **) override;
  void init_style() override;
  void init_list(int, class NeighList *) override;
  double init_one(int, int) override;
  int pack_forward_comm(int, int *, double *, int, int *) override;
  void unpack_forward_comm(int, int, double *) override;
  void write_restart(FILE *) override;
  void read_restart(FILE *) override;
  void write_restart_settings(FILE *) override;
  void read_restart_settings(FILE *) override;
  void *extract(const char *, int &) override;
  double memory_usage() override;

 protected:
  SPHTM_NS::Backend &backend;
  const SPHTM_NS::PairLoops &loops;
  std::shared_ptr<SPHTM_NS::Scene> scene;
  SPHTM_NS::Model model;
  std::unique_ptr<SPHTM_NS::NeighborRows> rows;
  SPHTM_NS::StepResults results;
  SPHTM_NS::Conduction conduction;
  SPHTM_NS::Interior interior;
  SPHTM_NS::ParticleState *state = nullptr;                // of fix sph/tm, from init_style on
  bool rates_begun = false;                                // those of the interior run, while records travel
  virtual bool records_travel() const { return false; }    // while loops run
  virtual void take_ghost_positions();                     // into their records

 private:
  std::unique_ptr<SPHTM_NS::ModelRestart> restart;
  double spacing = 0.0, h = 0.0;    // for extract()

  void allocate();
  void predict(const tm_state &, bool renewed);
  bool overlaps() const;
  double *clear_forces(const tm_state &, tm_rates_args &);
  SPHTM_NS::LoopArray<double> &pair_force(SPHTM_NS::StepAudit *);
  void begin_rates(const tm_rates_args &, bool renewed);
  void exchange_records();
  void correct_gradients(int, tm_rates_args &);
  void correct_first(tm_rates_args &);
  void control_hourglass(const tm_rates_args &);
  void rates(const tm_state &, tm_rates_args &, double *internal);
  void body_contact(const tm_rates_args &);
  void audit(SPHTM_NS::StepAudit &, SPHTM_NS::LoopArray<double> &);
  void tally_virial_energy();
};

}    // namespace LAMMPS_NS

#endif
