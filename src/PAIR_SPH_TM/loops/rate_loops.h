/* SPH-TM: the loops over particles, compiled once per instruction set; the one in use is the best
   that the processor has.

   rate_loop(effects) returns the rate pass for `effects`, see rate_loop_sets.h. Prediction and update
   find the loop for their effects by themselves. */
#ifndef SPHTM_RATE_LOOPS_H
#define SPHTM_RATE_LOOPS_H

#include "rate_loop_sets.h"
#include "tm_moment.h"
#include "tm_predict.h"
#include "tm_update.h"

namespace SPHTM_NS {

typedef void (*predict_loop_t)(int begin, int end, const tm_predict_args *args, unsigned effects);
typedef tm_update_result (*update_loop_t)(int begin, int end, const tm_update_args *args,
                                          unsigned effects);

rate_loop_t rate_loop(unsigned effects);
rate_loop_t moment_loop(unsigned effects);    // the correction, before the rate pass
rate_loop_t hourglass_loop(unsigned effects);    // after it
predict_loop_t predict_loop();
update_loop_t update_loop();
const char *rate_loop_isa();    // name of the instruction set in use

// one table per instruction set; rates by rate_loop_index(), moments and hourglass by kernel and dimension
struct ParticleLoops {
  rate_loop_t rates[RATE_LOOPS];
  rate_loop_t moments[2 * TM_KERNEL_COUNT], hourglass[2 * TM_KERNEL_COUNT];
  predict_loop_t predict;
  update_loop_t update;
};
namespace isa_default { extern const ParticleLoops loops; extern const SingleLoops single_loops; }
namespace isa_avx2 { extern const ParticleLoops loops; extern const SingleLoops single_loops; }
namespace isa_avx512 { extern const ParticleLoops loops; extern const SingleLoops single_loops; }

}    // namespace SPHTM_NS

#endif
