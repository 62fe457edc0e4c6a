/* SPH-TM: the state of all particles of this rank: its fields, LAMMPS's arrays of them, the effects in use, the time
   step, the energy balance, the heat that other fixes give, and the times of the parts of a step. Fix sph/tm owns it. */
#ifndef SPHTM_PARTICLE_STATE_H
#define SPHTM_PARTICLE_STATE_H

#include "active_region.h"
#include "atom_arrays.h"
#include "effect_plan.h"
#include "energy_balance.h"
#include "particle_fields.h"
#include "run_clock.h"
#include "run_history.h"
#include "step_audit.h"
#include "tm_conduct.h"
#include "tm_initial.h"
#include "tm_start_temperature.h"
#include "time_step.h"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace SPHTM_NS {

class Model;
class Scene;

// what fix sph/tm does for others in a step
class StepOwner {
 public:
  virtual void begin_forces() = 0;       // before the pair style's
  virtual StepAudit *audit_now() = 0;    // in a step that is audited, else nullptr

 protected:
  ~StepOwner() = default;
};

// temperatures that fixes prescribe for the end of a step, for conduction in stages
class HeldTemperatures {
 public:
  void forget() { all.n = 0; }
  int hold(int group_bit, double T);                              // its number; -1: there are too many
  double supply(int number) const { return supplied[number]; }    // heat it took in this step, on this rank
  void take_supply(const tm_real *heat) { std::copy_n(heat, (int) TM_HELD_MOST, supplied); }
  const tm_held &args() const { return all; }

 private:
  tm_held all = {};
  double supplied[TM_HELD_MOST] = {};
};

// power (mass length^2/time^3) given to owned particles this step by contact and heat fixes; added to in post_force,
// taken in final_integrate, which leaves 0
class HeatSource : public LoopArray<double> {
 public:
  using LoopArray<double>::LoopArray;
  void grow(bool wanted, int nmax);
  void set_zero(Backend &, bool wanted, int nmax);
  HeldTemperatures held;
};

// with what temperatures particles start, and stay at without the effect heat
class StartTemperatures {
 public:
  double of_all() const { return start.of_all; }    // K
  const tm_start_temperatures &all() const { return start; }
  void set_all(double T) { start.of_all = T; }
  void set_group(int bit, double T);    // at the next set-up
  // those of groups to the state, once: temperatures and, unless empty, those without thermal strain, which go along
  void apply(int n, const int *mask, LoopArray<double> &, LoopArray<double> &unstrained);

 private:
  tm_start_temperatures start = {293.15, 0, {}, {}};
};

class ParticleState : protected LAMMPS_NS::Pointers {
 public:
  ParticleState(LAMMPS_NS::LAMMPS *, Backend &, std::unique_ptr<AtomArrays>, StepOwner &, const std::string &fix_id,
                int igroup);
  ~ParticleState() override;

  const std::string &id() const { return fix_id; }    // of fix sph/tm
  int group_bit() const;
  Backend &loops() { return backend; }
  StepOwner &owner() { return step_owner; }

  // ---- model and effects
  void init(Model &);                             // before a run: derives the effects
  Model &model() const { return *used_model; }    // of the last init
  const Model *model_in_use() const { return used_model; }
  unsigned effects() const { return plan.effects; }
  bool has(unsigned effect) const { return (plan.effects & effect) != 0; }
  bool wants(unsigned effect) const { return plan.wants(effect); }    // asked for by now, by the user or another fix
  void plan_changed();                                                // by another fix, by effect_plan()
  void need(unsigned effect, const std::string &reason);              // another fix asks (from its init(), or earlier)
  EffectPlan &effect_plan() { return plan; }

  // ---- particles; pointers are valid until the next reneighboring
  tm_state arrays();    // of the loops
  tm_state host_arrays();
  const double *field(int id) { return values[id].host_read(); }    // rows on the host, or nullptr when it is off
  ParticleFields &fields() { return values; }
  AtomArrays &atoms() { return *lammps_arrays; }
  double temperature(int i);    // of owned particle i, K; on the host
  StartTemperatures &start_temperatures() { return temperatures; }
  tm_size_range sizes();    // of all particles; collective. Where all are the same, those of the model
  void initialize_new();    // particles that have no state yet
  void begin_setup();       // reports effects, drops fields that none of them calls for
  HeatSource &source() { return heat; }
  double *heat_source() { return has(TM_FX_HEAT) ? heat.loop_write() : nullptr; }

  // ---- parts
  TimeStep &time_step() { return step; }
  EnergyBalance &energy() { return balance; }
  RunClock &clock() { return run_clock; }
  RunHistory &history() { return run_history; }
  ActiveRegion &active() { return region; }    // who sleeps, and the loops of a step

 private:
  std::string fix_id;
  int igroup;
  Backend &backend;
  StepOwner &step_owner;
  std::shared_ptr<Scene> scene;
  std::unique_ptr<AtomArrays> lammps_arrays;
  ParticleFields values;
  Model *used_model = nullptr;
  EffectPlan plan;
  std::vector<std::string> reported;    // lines of effects that were printed
  HeatSource heat;
  StartTemperatures temperatures;
  TimeStep step;
  EnergyBalance balance;
  RunClock run_clock;
  RunHistory run_history;
  ActiveRegion region;

  void derive_effects();
  void report_effects();
  tm_initial_args initial_args(const tm_state &, unsigned fields) const;
};

}    // namespace SPHTM_NS

#endif
