/* SPH-TM: the loops over particles of the rate pass, one instantiation per set of effects.

   rate_loop(effects) returns the loop for the literal bits of `effects` (TM_FX_RATE_MASK, the
   kernel, and TM_FX_EXTENDED when any extended effect is on), compiled for the best instruction
   set of the processor that runs it. */
#ifndef SPHTM_RATE_LOOPS_H
#define SPHTM_RATE_LOOPS_H

#include "tm_rates.h"

namespace SPHTM_NS {

typedef void (*rate_loop_t)(int nlocal, const tm_rates_args *args);

rate_loop_t rate_loop(unsigned effects);
const char *rate_loop_isa();    // name of the instruction set in use

// one table per instruction set; index from rate_loop_index()
namespace isa_default { extern const rate_loop_t table[]; }
namespace isa_avx2 { extern const rate_loop_t table[]; }
namespace isa_avx512 { extern const rate_loop_t table[]; }

// kernel (5) x dimension (2) x {viscosity, artificial stress, conduction} (8) + extended (1)
constexpr int RATE_LOOPS_PER_KERNEL = 2 * 9;
constexpr int RATE_LOOPS = TM_KERNEL_COUNT * RATE_LOOPS_PER_KERNEL;

constexpr unsigned rate_loop_effects(int index)
{
  const unsigned kernel = index / RATE_LOOPS_PER_KERNEL;
  const unsigned rest = index % RATE_LOOPS_PER_KERNEL;
  const unsigned set = rest / 2;
  unsigned fx = (kernel << TM_FX_KERNEL_SHIFT) | ((rest & 1u) ? unsigned(TM_FX_3D) : 0u);
  if (set == 8) return fx | unsigned(TM_FX_EXTENDED);
  if (set & 1u) fx |= unsigned(TM_FX_VISCOSITY);
  if (set & 2u) fx |= unsigned(TM_FX_ARTSTRESS);
  if (set & 4u) fx |= unsigned(TM_FX_CONDUCTION);
  return fx;
}

constexpr int rate_loop_index(unsigned fx)
{
  const int kernel = (fx >> TM_FX_KERNEL_SHIFT) & 7u;
  int set = 0;
  if (fx & TM_FX_EXTENDED_MASK)
    set = 8;
  else
    set = ((fx & TM_FX_VISCOSITY) ? 1 : 0) + ((fx & TM_FX_ARTSTRESS) ? 2 : 0) +
        ((fx & TM_FX_CONDUCTION) ? 4 : 0);
  return kernel * RATE_LOOPS_PER_KERNEL + 2 * set + ((fx & TM_FX_3D) ? 1 : 0);
}

}    // namespace SPHTM_NS

#endif
