/* SPH-TM: what a run is made of, for all styles of one LAMMPS: the model, the state of the particles, the rows of
   neighbors and the results of a step. Pair style sph/tm and fix sph/tm enter what they own; other styles ask here. */
#ifndef SPHTM_SCENE_H
#define SPHTM_SCENE_H

#include "conduction.h"
#include "model.h"
#include "neighbor_check.h"
#include "neighbor_rows.h"
#include "particle_state.h"
#include "row_source.h"
#include "step_results.h"

#include <memory>
#include <string>
#include <vector>

namespace SPHTM_NS {

class ContactProbe;

class Scene {
 public:
  // that of a LAMMPS; it lives as long as one of its styles holds it
  static std::shared_ptr<Scene> of(LAMMPS_NS::LAMMPS *);
  explicit Scene(LAMMPS_NS::LAMMPS *l) : lmp(l), check(l) {}

  // of fix sph/tm; where there is none nullptr, or an error in the name of the style that needs it
  ParticleState *state() const { return states.empty() ? nullptr : states.front(); }
  ParticleState &state(const std::string &style) const;
  // of pair style sph/tm; valid from a fix's init() on
  Model &model() const { return *pair.model; }
  NeighborRows &rows() const { return *pair.rows; }
  StepResults &results() const { return *pair.results; }
  Conduction &conduction() const { return *pair.conduction; }
  bool has_pair() const { return pair.model != nullptr; }
  NeighborCheck &neighbor_check() const { return check; }

  // between runs: is what `known` holds that of this run, set up and with its pair style?
  bool is_current(ParticleState *known) const;
  // the same as an error in the name of the style: its values are not current
  void check_current(ParticleState *known, const std::string &style) const;

  // how many times as fast as the process the run is, of fix sph/tm
  void set_time_scale(double s) { times_as_fast = s; }
  double time_scale() const { return times_as_fast; }

  // owners enter and leave
  void enter(ParticleState *s) { states.push_back(s); }
  void leave(ParticleState *s);
  void enter(Model *m, NeighborRows *r, StepResults *s, Conduction *c) { pair = {m, r, s, c}; }
  void leave(Model *m);
  void bind();    // pair style sph/tm, at its init: it works with this state
  bool is_bound() const { return bound && bound == state(); }

  // what fix adapt/neigh and tools offer; nullptr takes an offer back
  struct TlHistory {    // rows of history variables, and the columns of outputs
    const tm_real *values;
    int columns, was_ul, ul_steps;
  };
  struct Adaptation {
    RowSource *rows = nullptr;                   // rows of neighbors in place of LAMMPS's list
    const SmoothingRule *smoothing = nullptr;    // of the smoothing lengths
    std::function<const double *()> levels;      // of refinement, of owned particles, on the host
    std::function<TlHistory()> tl_history;       // of total-Lagrangian pairs, of owned particles, of the loops
  };
  void set_adaptation(const Adaptation &a) { adapt = a; }
  const Adaptation &adaptation() const { return adapt; }
  void enter(ContactProbe *p) { probes.push_back(p); }
  void leave(ContactProbe *p);
  const std::vector<ContactProbe *> &contact_probes() const { return probes; }

 private:
  LAMMPS_NS::LAMMPS *lmp;
  mutable NeighborCheck check;            // of this LAMMPS's lists, in whatever the run is made of
  std::vector<ParticleState *> states;    // in order of creation; a run has one
  struct {
    Model *model = nullptr;
    NeighborRows *rows = nullptr;
    StepResults *results = nullptr;
    Conduction *conduction = nullptr;
  } pair;
  const ParticleState *bound = nullptr;
  double times_as_fast = 1.0;
  Adaptation adapt;
  std::vector<ContactProbe *> probes;
};

}    // namespace SPHTM_NS

#endif
