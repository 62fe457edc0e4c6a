/* SPH-TM: what a step makes of the particles: their records, owned and ghost, and the rates of owned ones. Pair style
   sph/tm fills it; fix sph/tm and others read it. */
#ifndef SPHTM_STEP_RESULTS_H
#define SPHTM_STEP_RESULTS_H

#include "loop_array.h"
#include "pair_loops.h"
#include "tm_body_contact.h"
#include "tm_ghost.h"

#include "pointers.h"

#include <map>

namespace LAMMPS_NS {
class Pair;
}

namespace SPHTM_NS {

class Model;
class ParticleState;

class StepResults : protected LAMMPS_NS::Pointers {
 public:
  StepResults(LAMMPS_NS::LAMMPS *, Backend &, Model &);

  void begin_step() { stepped = true; }
  bool has_stepped() const { return stepped; }    // a fix sph/tm has taken steps with it

  // ---- of the loops; valid from one force computation to the next reneighboring
  const tm_rates_args &rate_args() const { return args; }
  tm_predict_args predict_args(ParticleState &, const tm_state &);
  static bool rounds_in_prediction(ParticleState &);                       // records into those in single
  const double *internal_force() { return force_internal.loop_read(); }    // of pairs alone, with the energy balance
  const tm_real *loop_neighbors();                                         // number of neighbors of each owned particle

  // ---- on the host
  tm_records host_records();
  const tm_real *host_heat() { return heat.host_read(); }    // conduction, power per volume, or nullptr
  bool has_surface(int n) const { return surface.size() > 3 * (size_t) n; }    // of n particles

  // ---- of the particles of this rank
  double neighbors(bool of_each = false);                                // how many are within the support radius
  tm_nearest nearest();                                                  // the closest mechanical neighbors
  std::map<unsigned, double> bytes_by_effect(unsigned effects) const;    // 0: what every scene has

  // ---- for pair style sph/tm: arrays for the effects in use, arguments of the loops
  void resize(const ParticleState &);
  tm_rates_args &fill_args(ParticleState &, const tm_state &);
  const tm_records &records() const { return rec; }
  void take_up_ghosts();    // the host may have filled their records
  LoopArray<double> &pair_force() { return force_internal; }
  LoopArray<tm_real> &body_sides() { return sides; }    // of contact between bodies, see tm_body_contact.h
  LoopArray<tm_real> &body_ahead(bool wanted);          // what friction between bodies needs of each
  LoopArray<tm_real> &body_thin(bool wanted);           // layers between bodies, see tm_body_layer.h
  tm_real *tally_rows(bool per_particle);
  const tm_real *host_tally() { return tally.host_read(); }
  struct Rates {
    const double *gradient, *heat, *xsph, *correction, *turn;
  };
  Rates host_rates();

  // ---- what ghosts get, through the pair style: their records, the gradient correction, the hourglass displacement
  void communicate_records(LAMMPS_NS::Pair *);
  void communicate_correction(LAMMPS_NS::Pair *);
  void communicate_hourglass(LAMMPS_NS::Pair *);
  void communicate(LAMMPS_NS::Pair *, LoopArray<tm_real> &, int columns);    // any values of particles
  tm_ghost_args ghosts();                                                    // where the loops run
  tm_ghost_args host_ghosts(bool to_write);
  LoopArray<tm_real> &main_record() { return rec_main; }

 private:
  Backend &backend;
  const PairLoops &loops;
  Model &model;
  LoopArray<tm_real> rec_main, rec_stress, rec_heat, rec_correction, rec_size, rec_hourglass, rec_stab;
  LoopArray<float> single_main, single_more, single_correction, single_size, single_stab;    // mixed precision
  LoopArray<tm_real> gradient, heat, correction, xsph_v, uneven, hourglass_rate, moment, turn, face_next, surface,
      artificial;
  LoopArray<tm_real> near_count, tally, sides, ahead, thin;
  LoopArray<double> force_internal;
  tm_records rec = {};
  tm_rates_args args = {};
  LoopArray<tm_real> *communicated = nullptr;    // or the records
  int communicated_columns = 0;
  bool stepped = false;

  tm_records_single single_records(const ParticleState &);
  tm_near_args near_args(bool of_each);
};

// the unit of positions in single, for rows with this support radius
double single_position_unit(const Model &, double skin);

}    // namespace SPHTM_NS

#endif
