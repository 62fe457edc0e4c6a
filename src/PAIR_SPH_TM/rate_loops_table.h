/* SPH-TM: included once per instruction set with SPHTM_ISA set to the namespace. */
#include "rate_loops.h"

namespace {

template <unsigned EFFECTS> void loop(int begin, int end, const tm_rates_args *args)
{
  for (int i = begin; i < end; i++) tm_rates(i, args, EFFECTS);
}

template <unsigned EFFECTS> void moments(int begin, int end, const tm_rates_args *args)
{
  for (int i = begin; i < end; i++) tm_moment(i, args, EFFECTS);
}

// in chunks, so that the records are still in the cache for the artificial stress
void predict(int begin, int end, const tm_predict_args *args, unsigned effects)
{
  for (; begin < end; begin += TM_CHUNK) {
    const int last = end - begin < TM_CHUNK ? end : begin + TM_CHUNK;
    for (int i = begin; i < last; i++) tm_predict(i, args, effects);
    if (effects & TM_FX_ARTSTRESS) tm_predict_artstress(begin, last, args, effects);
  }
}

tm_update_result update(int begin, int end, const tm_update_args *args, unsigned effects)
{
  tm_update_result sum = tm_update_nothing();
  for (int i = begin; i < end && sum.status == TM_OK; i++) {
    const tm_update_result r = tm_update(i, args, effects);
    tm_update_sum(&sum, &r, (effects & TM_FX_LEDGER) != 0);
  }
  return sum;
}

}    // namespace

namespace SPHTM_NS {
namespace SPHTM_ISA {

#define TM_LOOP(I) loop<rate_loop_effects(I)>
#define TM_LOOPS_2(I) TM_LOOP(I), TM_LOOP(I + 1)
#define TM_LOOPS_6(I) TM_LOOPS_2(I), TM_LOOPS_2(I + 2), TM_LOOPS_2(I + 4)
#define TM_LOOPS_26(I) TM_LOOPS_6(I), TM_LOOPS_6(I + 6), TM_LOOPS_6(I + 12), TM_LOOPS_6(I + 18), TM_LOOPS_2(I + 24)

#define TM_MOMENTS(K)                                      \
  moments<(unsigned) TM_KERNEL_##K << TM_FX_KERNEL_SHIFT>, \
      moments<(unsigned) TM_KERNEL_##K << TM_FX_KERNEL_SHIFT | (unsigned) TM_FX_3D>

extern const ParticleLoops loops;
const ParticleLoops loops = {
    {TM_LOOPS_26(0), TM_LOOPS_26(26), TM_LOOPS_26(52), TM_LOOPS_26(78), TM_LOOPS_26(104)},
    {TM_MOMENTS(HYPERBOLIC), TM_MOMENTS(CUBIC), TM_MOMENTS(QUINTIC), TM_MOMENTS(WENDLAND_C2),
     TM_MOMENTS(WENDLAND_C4)},
    predict, update};

}    // namespace SPHTM_ISA
}    // namespace SPHTM_NS
