/* SPH-TM: the time step: what limits it, how it grows, and when it stops a run. */
#ifndef SPHTM_TIME_STEP_H
#define SPHTM_TIME_STEP_H

#include "tm_update.h"

#include "pointers.h"

#include <string>

namespace LAMMPS_NS {
class Fix;
}

namespace SPHTM_NS {

class ParticleState;

class TimeStep : protected LAMMPS_NS::Pointers {
 public:
  TimeStep(LAMMPS_NS::LAMMPS *, ParticleState &);

  // of the script
  static constexpr double COURANT_WARNED = 0.65;
  void set_courant(double c) { courant = c; }        // of h/c; without viscosity 0.6 is stable, 0.7 is not
  void set_fixed(double value) { fixed = value; }    // the user's constant step; 0: automatic
  void set_most(double value) { most = value; }      // 0: no limit
  // stages: conduction takes them in longer steps; tolerance: of steps that heat alone sets
  static constexpr double HEAT_TOLERANCE = 0.005;
  void set_conduction(bool stages, double tolerance)
  {
    stages_allowed = stages;
    heat_tolerance = tolerance;
  }
  bool is_fixed() const { return fixed > 0.0; }
  double fixed_value() const { return fixed; }

  double now() const { return dt; }
  double ahead() const { return dt_ahead; }    // from the state to the force point
  double next() const { return dt_next; }
  int cause() const { return dt_cause; }    // enum tm_dt_cause
  // conduction takes stages in this step, which is longer than one evaluation bears
  bool conducts_in_stages() const { return in_stages; }
  bool has_stages() const { return stages_allowed && stages_possible; }    // conduction may take them
  void set_heat_error(double e) { heat_error = e; }    // of this step, over the range of temperatures

  // upper limit of the next step, already with its safety factor; by: whose it is, for messages
  void limit(double value, int cause, const LAMMPS_NS::Fix *by = nullptr);
  void limit(const tm_real *of_particles);    // by sound, force, conduction, without safety factor
  void lower_next(double value);
  // false: some pairs have no stages (of fix adapt/neigh threshold), and conduction limits the steps
  void set_stages_possible(bool p) { stages_possible = p; }

  void init();
  void begin_setup();
  void end_setup(bool first);    // first: no step has been taken yet
  void begin_step();
  void end_step();
  // refinement: the step that particle i would allow with another h
  double of_size(int i, double h);
  // of restart files
  void restore(double now, double next, int cause);

 private:
  ParticleState &state;
  double courant = 0.4, fixed = 0.0, most = 0.0;
  double dt = 0.0, dt_ahead = 0.0, dt_next = 0.0;
  double dt_largest = 0.0;    // of this run
  bool stages_allowed = true, stages_possible = true, in_stages = false;
  double heat_tolerance = HEAT_TOLERANCE, heat_error = -1.0;    // negative: not known
  double of_conduction = 1e300;                                 // limit of one evaluation, of all ranks
  double my_conduction = 1e300;                                 // of this rank, since the last reduction
  bool first_of_run = false;                                    // the step that begins is
  int dt_cause = TM_DT_SOUND;
  double limits[TM_DT_CAUSES];                            // of this rank, since the last reduction
  const LAMMPS_NS::Fix *limited_by[TM_DT_CAUSES] = {};    // the fixes that set them, where fixes did

  void clear();
  double of_sound_speed();
  void limit_by_bodies();
  void reduce();
  double longest_conduction(bool mechanics) const;
  void apply(double value, LAMMPS_NS::bigint done);
  void check_fixed(const double *of_causes);
  void check_stall(const double *of_all_ranks);
  std::string cause_in_words(int cause) const;
  std::string limiting_particle();
};

}    // namespace SPHTM_NS

#endif
