/* SPH-TM: what single effects cost inside the loops that hold them all. Prediction, rates and update
   are run again on copies, with and without each effect. */
#ifndef SPHTM_EFFECT_PROBE_H
#define SPHTM_EFFECT_PROBE_H

#include "loop_array.h"
#include "tm_fields.h"
#include "tm_predict.h"
#include "tm_rates.h"
#include "tm_update.h"

#include <map>

namespace SPHTM_NS {

class ParticleState;
class StepResults;

class EffectProbe {
 public:
  EffectProbe(ParticleState &, StepResults &, int particles);
  // effect -> its share of the time of prediction, rates and update; the fastest of so many rounds
  std::map<unsigned, double> shares(int rounds);

 private:
  ParticleState &particles_state;
  StepResults &results;
  Backend &loops;
  int n;
  LoopArray<double> state[TM_F_COUNT], x, v;    // copies the update changes
  LoopArray<double> main, stress, heat_record, size, hourglass, stab, correction, turn, face_next,
      moment;                                                                      // written by the prediction
  LoopArray<double> force, gradient, heat, xsph_v, uneven, surface, artificial;    // and by the rate pass

  struct Arguments {    // of the particles themselves; to ask for them again can copy all from the host
    tm_state state;
    tm_rates_args rates;
    tm_predict_args predict;
    tm_update_args update;
  };
  double step(const Arguments &, unsigned effects);
};

}    // namespace SPHTM_NS

#endif
