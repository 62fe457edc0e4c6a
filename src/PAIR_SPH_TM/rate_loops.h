/* SPH-TM: the loops over particles, compiled once per instruction set; the one in use is the best
   that the processor has.

   rate_loop(effects) returns the rate pass for the literal bits of `effects` (TM_FX_RATE_MASK, the
   kernel, and TM_FX_EXTENDED when any extended effect is on), one instantiation per set of bits.
   Prediction and update find the loop for their effects by themselves. */
#ifndef SPHTM_RATE_LOOPS_H
#define SPHTM_RATE_LOOPS_H

#include "tm_moment.h"
#include "tm_predict.h"
#include "tm_rates.h"
#include "tm_update.h"

namespace SPHTM_NS {

// particles begin to end - 1
typedef void (*rate_loop_t)(int begin, int end, const tm_rates_args *args);
typedef void (*predict_loop_t)(int begin, int end, const tm_predict_args *args, unsigned effects);
typedef tm_update_result (*update_loop_t)(int begin, int end, const tm_update_args *args,
                                          unsigned effects);

rate_loop_t rate_loop(unsigned effects);
rate_loop_t moment_loop(unsigned effects);    // the correction, before the rate pass
predict_loop_t predict_loop();
update_loop_t update_loop();
const char *rate_loop_isa();    // name of the instruction set in use

// kernel (5) x dimension (2) x {viscosity, artificial stress, conduction} (8) + extended (1)
// + smoothing and viscosity x {artificial stress, conduction} (4)
constexpr int RATE_LOOPS_PER_KERNEL = 2 * 13;
constexpr int RATE_LOOPS = TM_KERNEL_COUNT * RATE_LOOPS_PER_KERNEL;

constexpr unsigned rate_loop_effects(int index)
{
  const unsigned kernel = index / RATE_LOOPS_PER_KERNEL;
  const unsigned rest = index % RATE_LOOPS_PER_KERNEL;
  const unsigned set = rest / 2;
  unsigned fx = (kernel << TM_FX_KERNEL_SHIFT) | ((rest & 1u) ? unsigned(TM_FX_3D) : 0u);
  if (set == 8) return fx | unsigned(TM_FX_EXTENDED);
  if (set > 8) {
    fx |= unsigned(TM_FX_SMOOTHING) | unsigned(TM_FX_VISCOSITY);
    if ((set - 9) & 1u) fx |= unsigned(TM_FX_ARTSTRESS);
    if ((set - 9) & 2u) fx |= unsigned(TM_FX_CONDUCTION);
    return fx;
  }
  if (set & 1u) fx |= unsigned(TM_FX_VISCOSITY);
  if (set & 2u) fx |= unsigned(TM_FX_ARTSTRESS);
  if (set & 4u) fx |= unsigned(TM_FX_CONDUCTION);
  return fx;
}

constexpr int rate_loop_index(unsigned fx)
{
  const int kernel = (fx >> TM_FX_KERNEL_SHIFT) & 7u;
  int set = 0;
  if ((fx & TM_FX_EXTENDED_MASK) == TM_FX_SMOOTHING && (fx & TM_FX_VISCOSITY))
    set = 9 + ((fx & TM_FX_ARTSTRESS) ? 1 : 0) + ((fx & TM_FX_CONDUCTION) ? 2 : 0);
  else if (fx & TM_FX_EXTENDED_MASK)
    set = 8;
  else
    set = ((fx & TM_FX_VISCOSITY) ? 1 : 0) + ((fx & TM_FX_ARTSTRESS) ? 2 : 0) +
        ((fx & TM_FX_CONDUCTION) ? 4 : 0);
  return kernel * RATE_LOOPS_PER_KERNEL + 2 * set + ((fx & TM_FX_3D) ? 1 : 0);
}

// one table per instruction set; rates by rate_loop_index(), moments by kernel and dimension
struct ParticleLoops {
  rate_loop_t rates[RATE_LOOPS];
  rate_loop_t moments[2 * TM_KERNEL_COUNT];
  predict_loop_t predict;
  update_loop_t update;
};
namespace isa_default { extern const ParticleLoops loops; }
namespace isa_avx2 { extern const ParticleLoops loops; }
namespace isa_avx512 { extern const ParticleLoops loops; }

}    // namespace SPHTM_NS

#endif
