/* SPH-TM: included once per instruction set with SPHTM_ISA set to the namespace. */
#include "rate_loops.h"

namespace {

// the record and the row of a particle, which do not follow those before
void ask_for(int i, const tm_rates_args *args)
{
  const int *row = args->rows.index + args->rows.first[i];
  const tm_real *record = args->rec.main ? tm_main_record(&args->rec, i) : nullptr;
  __builtin_prefetch(row);
  __builtin_prefetch(row + 16);
  __builtin_prefetch(record);
  __builtin_prefetch(record + 8);
}

template <unsigned EFFECTS> void loop(int begin, int end, const tm_rates_args *args)
{
  const int *which = args->which;
  for (int k = begin; k < end; k++) {
    if (which && k + 2 < end) ask_for(which[k + 2], args);
    tm_rates(which ? which[k] : k, args, EFFECTS);
  }
}

template <unsigned EFFECTS> void moments(int begin, int end, const tm_rates_args *args)
{
  for (int i = begin; i < end; i++) tm_moment(args->which ? args->which[i] : i, args, EFFECTS);
}

template <unsigned EFFECTS> void hourglass(int begin, int end, const tm_rates_args *args)
{
  for (int i = begin; i < end; i++) tm_hourglass(i, args, EFFECTS);
}

// Prediction and update: scenes without the rare effects have loops for just their set; with one of
// those all effects are tested at run time.
constexpr unsigned RARE = TM_FX_DAMAGE | TM_FX_ENERGY | TM_FX_BALSARA | TM_FX_XSPH | TM_FX_PLANE_STRESS |
    TM_FX_SMOOTHING | TM_FX_FORM_F14 | TM_FX_HOURGLASS;
// of the correction update needs one constant, of the others prediction and update need nothing
constexpr unsigned TESTED = TM_FX_CORRECTION | TM_FX_ARTSTRESS;

// in chunks, so that the records are still in the cache for the artificial stress
template <unsigned SET, unsigned ASK>
void predict_set(int begin, int end, const tm_predict_args *args, unsigned given)
{
  const unsigned effects = SET | (given & ASK);
  for (; begin < end; begin += TM_CHUNK) {
    const int last = end - begin < TM_CHUNK ? end : begin + TM_CHUNK;
    for (int i = begin; i < last; i++) tm_predict(i, args, effects);
    if (effects & TM_FX_PRESENT & TM_FX_ARTSTRESS) tm_predict_artstress(begin, last, args, effects);
  }
}

void predict(int begin, int end, const tm_predict_args *args, unsigned effects)
{
  if (effects & RARE) predict_set<0u, ~0u>(begin, end, args, effects);
  else if (effects & TM_FX_HEAT) predict_set<TM_FX_HEAT, TESTED | TM_FX_3D>(begin, end, args, effects);
  else predict_set<0u, TESTED | TM_FX_3D>(begin, end, args, effects);
}

template <unsigned SET, unsigned ASK>
tm_update_result update_set(int begin, int end, const tm_update_args *args, unsigned given)
{
  const unsigned effects = SET | (given & ASK);
  tm_update_result sum = tm_update_nothing();
  for (int i = begin; i < end && sum.status == TM_OK; i++) {
    const tm_update_result r = tm_update(i, args, effects);
    tm_update_sum(&sum, &r, (effects & TM_FX_PRESENT & TM_FX_LEDGER) != 0);
  }
  return sum;
}

// each of the bits is in the set, or not
template <unsigned SET> SPHTM_NS::update_loop_t update_of(unsigned) { return update_set<SET, TESTED>; }
template <unsigned SET, unsigned BIT, unsigned... BITS> SPHTM_NS::update_loop_t update_of(unsigned effects)
{
  if (effects & BIT) return update_of<SET | BIT, BITS...>(effects);
  return update_of<SET, BITS...>(effects);
}

tm_update_result update(int begin, int end, const tm_update_args *args, unsigned effects)
{
  constexpr unsigned HEAT = TM_FX_HEAT, CONDUCTION = TM_FX_CONDUCTION, FLOW = TM_FX_PLASTICITY;
  const SPHTM_NS::update_loop_t run = (effects & RARE) ? update_set<0u, ~0u>
      : (effects & HEAT) ? update_of<HEAT, CONDUCTION, FLOW, TM_FX_LEDGER, TM_FX_3D>(effects)
                         : update_of<0u, FLOW, TM_FX_LEDGER, TM_FX_3D>(effects);
  return run(begin, end, args, effects);
}

}    // namespace

namespace SPHTM_NS {
namespace SPHTM_ISA {

#define TM_LOOP(I) loop<rate_loop_effects(I)>
#define TM_LOOPS_2(I) TM_LOOP(I), TM_LOOP(I + 1)
#define TM_LOOPS_6(I) TM_LOOPS_2(I), TM_LOOPS_2(I + 2), TM_LOOPS_2(I + 4)
#define TM_LOOPS_26(I) TM_LOOPS_6(I), TM_LOOPS_6(I + 6), TM_LOOPS_6(I + 12), TM_LOOPS_6(I + 18), TM_LOOPS_2(I + 24)

#define TM_OF_KERNEL(F, K)                           \
  F<(unsigned) TM_KERNEL_##K << TM_FX_KERNEL_SHIFT>, \
      F<(unsigned) TM_KERNEL_##K << TM_FX_KERNEL_SHIFT | (unsigned) TM_FX_3D>
#define TM_OF_ALL(F)                                                                                    \
  TM_OF_KERNEL(F, HYPERBOLIC), TM_OF_KERNEL(F, CUBIC), TM_OF_KERNEL(F, QUINTIC), TM_OF_KERNEL(F, WENDLAND_C2), \
      TM_OF_KERNEL(F, WENDLAND_C4)

extern const ParticleLoops loops;
const ParticleLoops loops = {
    {TM_LOOPS_26(0), TM_LOOPS_26(26), TM_LOOPS_26(52), TM_LOOPS_26(78), TM_LOOPS_26(104)},
    {TM_OF_ALL(moments)}, {TM_OF_ALL(hourglass)},
    predict, update};

}    // namespace SPHTM_ISA
}    // namespace SPHTM_NS
