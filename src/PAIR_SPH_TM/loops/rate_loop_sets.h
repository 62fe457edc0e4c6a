/* SPH-TM: for which effects the rate pass is instantiated: literal are the bits of TM_FX_RATE_MASK and
   the kernel; with TM_FX_EXTENDED all other effects are tested at run time.

   All sets exist for all kernels in double on the host. In single, and on a GPU, the kernels but the
   default one have only the set that tests them all, so that the compiler is done in minutes. */
#ifndef SPHTM_RATE_LOOP_SETS_H
#define SPHTM_RATE_LOOP_SETS_H

#include "tm_rates.h"

namespace SPHTM_NS {

// particles begin to end - 1
typedef void (*rate_loop_t)(int begin, int end, const tm_rates_args *args);

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

constexpr int FEW_RATE_LOOPS = RATE_LOOPS_PER_KERNEL + 2 * (TM_KERNEL_COUNT - 1);

constexpr unsigned few_rate_loop_effects(int index)
{
  if (index < RATE_LOOPS_PER_KERNEL) return rate_loop_effects(index);
  const unsigned k = index - RATE_LOOPS_PER_KERNEL;
  return ((k / 2 + 1) << TM_FX_KERNEL_SHIFT) | unsigned(TM_FX_EXTENDED) | ((k & 1u) ? unsigned(TM_FX_3D) : 0u);
}

constexpr int few_rate_loop_index(unsigned fx)
{
  const int kernel = (fx >> TM_FX_KERNEL_SHIFT) & 7u;
  return kernel == 0 ? rate_loop_index(fx)
                     : RATE_LOOPS_PER_KERNEL + 2 * (kernel - 1) + ((fx & TM_FX_3D) ? 1 : 0);
}

// in single, by few_rate_loop_index()
struct SingleLoops {
  rate_loop_t rates[FEW_RATE_LOOPS];
};

}    // namespace SPHTM_NS

#endif
