/* -*- c++ -*- ----------------------------------------------------------
   SPH-TM: fix sph/tm. Owns the state of every particle, integrates it,
   decides which effects are on, sets the time step and keeps the energy book.
------------------------------------------------------------------------- */
#ifndef LMP_FIX_SPH_TM_H
#define LMP_FIX_SPH_TM_H

#include "fix.h"
#include "energy_watch.h"
#include "pair_loops.h"
#include "particle_fields.h"
#include "run_clock.h"

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace SPHTM_NS {
class AccuracyMeter;
class AuditSearch;
class EffectProbe;
class Keywords;
}

namespace LAMMPS_NS {

class PairSPHTM;

class FixSPHTM : public Fix {
 public:
  FixSPHTM(class LAMMPS *, int, char **, SPHTM_NS::Backend & = SPHTM_NS::Backend::host());
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
  void reset_dt() override;
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

  // --- for pair sph/tm, fix contact/tri, the heat fixes and the computes ---

  // the one of this run; where there is none an error in the name of who needs it, or nullptr
  static FixSPHTM *of(class LAMMPS *, const std::string &who = "");
  // for what is asked between runs: the one of this run, set up and with its pair style. Where that is not so, or it is
  // not the known one any more, an error in the name of who is asked: its values are not current
  static FixSPHTM *current(class LAMMPS *, const FixSPHTM *known, const std::string &who);
  bool is_current() const;
  unsigned effects() const { return fx; }
  bool has(unsigned effect) const { return (fx & effect) != 0; }
  // asked for by now, by the user or another fix
  bool wants(unsigned effect) const { return ((fx | forced_on | asked) & effect) != 0; }
  SPHTM_NS::Backend &loops() { return backend; }
  // pointers valid until the next reneighbouring: of the particle loops, and of the host
  tm_state state();
  tm_state host_state();
  // rows of one state field (tm_fields.h) on the host, or nullptr when it is off
  const double *field(int id) { return fields[id].host_read(); }
  double time_ahead() const { return dt_ahead; }   // from the state to the force point
  double step_dt() const { return dt; }
  // particles came, went or were moved between the last run and this one; known from its set-up on
  bool moved_since_last_run() const { return moved_between; }
  bool begun() const { return started; }           // has taken a step, here or before a restart
  bool restored() const { return in_file; }        // from a restart file
  double start_temperature() const { return temperature0; }
  // sizes of all particles; collective. Where all are the same, those of the pair style
  tm_size_range sizes();
  double temperature(int i);                       // of owned particle i, K; on the host
  PairSPHTM *pair() { return pair_sph; }
  SPHTM_NS::AccuracyMeter *audit_now();             // in a step that is audited, else nullptr
  void begin_forces();                             // before the pair style's
  // power (mass length^2/time^3) given to owned particles this step by contact and heat fixes; added
  // to in post_force, taken in final_integrate, which leaves 0; nullptr when heat is off
  double *heat_source() { return has(TM_FX_HEAT) ? source.loop_write() : nullptr; }
  double *host_heat_source() { return has(TM_FX_HEAT) ? source.host_write() : nullptr; }
  // another fix asks for heat as a state (called from its init(), or earlier)
  void need(unsigned effect, const std::string &reason);
  // time of the run's parts: of the pair style's by name, of another fix's by its address
  SPHTM_NS::RunClock run_clock;
  // all of LAMMPS's arrays of particles on the host, to be read and written; back to where the loops run
  virtual void host_particles() {}
  virtual void host_particles_changed() {}
  // refinement: the step that particle i would allow with another h; the next step is at most limit
  double dt_of_size(int i, double h);
  void lower_next_dt(double limit);
  // what splits and merges change, in mass length^2/time^2; heat: kinetic energy that has become heat
  void book_remap(double kinetic, double elastic, double heat);
  // upper limit of the time step, already with its safety factor; valid for the next step. by: whose it is, for
  // messages
  void limit_dt(double limit, int cause, const Fix *by = nullptr);

  // the energy book, in mass length^2/time^2, summed over the run on this rank
  struct Ledger {
    double elastic = 0, plastic = 0, plastic_heat = 0, artificial = 0, heat = 0;
    double kinetic_work = 0, internal_work = 0;
    double contact_damping = 0;   // dissipated by contact damping
    double friction = 0;          // friction work that did not go into particles
    double friction_heat = 0;     // friction work given to particles as heat
    double heat_exchanged = 0;    // other heat given to particles (conduction from tools, fluxes)
    double contact_work = 0;      // work of contact forces on particles
    double tool_work = 0;         // work of the tool drives on the particles and contacts
  };
  Ledger ledger;
  double contact_spring = 0.0;    // energy stored in contact springs now, on this rank

 protected:
  virtual void delete_lost() {}    // LAMMPS does, in the exchange that follows
  SPHTM_NS::Backend &backend;
  const SPHTM_NS::PairLoops &particle_loops;
  SPHTM_NS::ParticleFields fields;
  PairSPHTM *pair_sph = nullptr;
  unsigned fx = 0;                 // effects in use
  virtual void derive_effects();
  virtual void point_to_atoms(tm_state &);    // LAMMPS's arrays, where the loops run
  virtual void atoms_to_host() {}             // bring them up to date on the host

 private:
  // entries of the output vector
  enum {
    ENERGY_KINETIC, ENERGY_ELASTIC, ENERGY_PLASTIC, ENERGY_HEAT, ENERGY_CONTACT, ENERGY_FRICTION,
    ENERGY_ARTIFICIAL, ENERGY_EXTERNAL, ENERGY_SUM, VECTOR_DT, VECTOR_CAUSE, VECTOR_NEIGHBORS,
    VECTOR_SIZE
  };

  unsigned forced_on = 0, forced_off = 0;
  unsigned asked = 0;              // by other fixes
  std::vector<std::pair<unsigned, std::string>> asked_reasons;
  std::vector<std::string> report, warnings, reported;    // of the effects; what was printed
  void report_effects();
  bool has_forces = false;         // of a set-up or step
  struct Preset {
    int bit;
    double temperature;
  };
  std::vector<Preset> preset;      // temperatures of groups, applied at the next set-up
  double temperature0 = 293.15;
  double hottest_given = 0.0, hottest = 1e300;    // above it a temperature stops the run
  double densest = 3.0;            // over the reference density or under it by more stops the run
  bool melt_reported = false;
  bool temperature_set = false;    // by fix_modify
  double find_hottest() const;
  void report_melting(int);
  bool temperature_given = false;
  double courant = 0.4;      // of h/c; without viscosity 0.6 is stable, 0.7 is not
  double fixed_dt = 0.0;           // > 0: the user's constant time step
  double dt_max = 0.0;             // 0: no limit
  bool stop_on_lost = true;        // a particle beyond a fixed boundary stops the run
  double dt = 0.0, dt_ahead = 0.0;
  double dt_limits[TM_DT_CAUSES];  // of this rank, since the last reduction
  const Fix *limited_by[TM_DT_CAUSES] = {};    // the fixes that set them, where fixes did
  double dt_next = 0.0;
  double dt_largest = 0.0;         // of this run
  int dt_cause = TM_DT_SOUND;
  bool started = false;            // the first step has been taken (also after a restart)
  SPHTM_NS::LoopArray<double> source;
  bool source_of_setup = false;    // holds what the set-up's forces left
  int *lost = nullptr;             // what the drift of so many particles found, once it is through
  int drifted = 0;
  double energy_now[VECTOR_SIZE];
  bigint energy_step = -1;

  struct {
    uint64_t rows = 0, hash = 0, rows_written = 0, hash_written = 0;
  } read;                          // from a restart file, until it is checked
  void check_restart();
  enum { SIZED_BY_ASPH = 1, SIZED_BY_REFINE = 2 };
  bool data_warned = false;
  bool in_file = false;            // this fix has been read from a restart file
  int sized_in_file = 0;           // what gave the particles of the file their sizes, until it is checked
  int sized_by() const;
  void check_sizes_of_file();
  bool want_table = true, timing = false;
  bigint clock_step = 0;           // when the clock was set to 0

  std::unique_ptr<SPHTM_NS::AccuracyMeter> meter;    // with the keyword audit

  friend class SPHTM_NS::AccuracyMeter;
  friend class SPHTM_NS::AuditSearch;
  friend class SPHTM_NS::EffectProbe;
  void read_keywords(int, char **);
  bool read_setting(SPHTM_NS::Keywords &);
  void read_audit(SPHTM_NS::Keywords &);
  void read_effect(SPHTM_NS::Keywords &);
  std::map<unsigned, double> bytes_by_effect();
  std::map<unsigned, double> probe_effects(double, bigint);
  tm_initial_args initial_args(const tm_state &, unsigned) const;
  void initialise_particles();
  void empty_source();
  void limit_by_bodies();
  void limit_dt_by(const tm_real *limits);
  void reduce_dt();
  void setup_dt();
  const char *dt_cause_name() const;
  std::string dt_cause_in_words(int cause) const;
  void check_fixed_dt(const double *limits);
  void check_stall(const double *all);
  std::string limiting_particle();
  // what a script gets wrong, fix_sph_tm_start.cpp
  struct Filling {                 // of the particles of this rank
    double particles = 0, off = 0, right = 0, densest = 0.0, thinnest = 1e300;
    int dense_at = -1, thin_at = -1;
  };
  struct {
    std::vector<bigint> types;     // how many particles of each; empty: there was no run
    std::vector<double> density;   // reference density of each
    double nearest = 0.0;          // the smallest distance of two
    double mean_nearest = 0.0, neighbors = 0.0, mass = 0.0;    // means and sum over all
    uint64_t places = 0;
    bigint particles = 0;
  } last_run;
  bool moved_between = false;      // particles came, went or were moved since the last run
  uint64_t places_hash();
  double total_mass();
  void check_strain(const tm_nearest &);
  std::vector<tagint> fresh;       // of all ranks: those that came since then
  bool begin_anew = false;         // though steps were taken
  void check_company();
  void check_integrators();
  void check_begun();
  std::vector<bigint> particles_of_types(bool old_only);
  void remember_particles();
  void look_at_changes();
  void check_values();
  void check_overlap(const tm_nearest &, double least);
  void check_filling(bool of_fresh);
  std::string spacing_in_words(double) const;
  void judge_filling(const Filling &, double of_lattice, bool sizes);
  void check_start();
  void check_changes();
  void apply_dt(double, bigint);
  tm_update_args update_args();
  void stop_on(int, const tm_update_result &);
  std::string likely_cause(int, int status);
  bool most_by_conduction(int);
  std::string surroundings(int, bool &torn);
  bool scene_has(const char *fix_style) const;
  tm_drift_args drift_args();
  bool check_lost();
  void stop_on_lost_particle(int);
  void sum_energies();
  SPHTM_NS::EnergyWatch energy_watch;
  double drift_allowed = 0.1;      // of what went in
  bool looked = false;             // since the last set-up
  enum Look { FIRST_LOOK, LOOK, LAST_LOOK, GLANCE };    // of a run; a glance does not count
  void watch_energy(Look);
  double audit_output(int);
};

}    // namespace LAMMPS_NS

#endif
