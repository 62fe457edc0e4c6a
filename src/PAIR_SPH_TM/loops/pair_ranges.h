/* SPH-TM: the hot loops of a step, for particles begin to end - 1; included once per instruction set with SPHTM_ISA set
   to its namespace, and SPHTM_FEW_SETS for one that few processors need. */
#include "effect_sets.h"
#include "pair_loops.h"

#include <utility>

namespace {

using namespace SPHTM_NS;

typedef void (*rate_range_t)(int begin, int end, const tm_rates_args *args);

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

template <unsigned EFFECTS> void rates_of_set(int begin, int end, const tm_rates_args *args)
{
  const int *which = args->which;
  for (int k = begin; k < end; k++) {
    if (which && k + 2 < end) ask_for(which[k + 2], args);
    tm_rates(which ? which[k] : k, args, EFFECTS);
  }
}
template <int... INDEX> rate_range_t rates_of(int index, std::integer_sequence<int, INDEX...>)
{
#if defined(SPHTM_FEW_SETS)
  static const rate_range_t range[] = {rates_of_set<few_rate_set(INDEX)>...};
#else
  static const rate_range_t range[] = {rates_of_set<most_rate_set(INDEX)>...};
#endif
  return range[index];
}
void rates_in_double(int begin, int end, const tm_rates_args *args, unsigned effects)
{
#if defined(SPHTM_FEW_SETS)
  rates_of(few_rate_set_index(effects), std::make_integer_sequence<int, FEW_RATE_SETS>())(begin, end, args);
#else
  rates_of(most_rate_set_index(effects), std::make_integer_sequence<int, MOST_RATE_SETS>())(begin, end, args);
#endif
}

template <unsigned EFFECTS> void correction_of_set(int begin, int end, const tm_rates_args *args)
{
  for (int i = begin; i < end; i++) tm_moment(args->which ? args->which[i] : i, args, EFFECTS);
}
template <int... INDEX> rate_range_t correction_of(int index, std::integer_sequence<int, INDEX...>)
{
  static const rate_range_t range[] = {correction_of_set<kernel_set(INDEX)>...};
  return range[index];
}
void correction(int begin, int end, const tm_rates_args *args, unsigned effects)
{
  correction_of(kernel_set_index(effects), std::make_integer_sequence<int, KERNEL_SETS>())(begin, end, args);
}

template <unsigned EFFECTS> void hourglass_of_set(int begin, int end, const tm_rates_args *args)
{
  for (int i = begin; i < end; i++) tm_hourglass(i, args, EFFECTS);
}
template <int... INDEX> rate_range_t hourglass_of(int index, std::integer_sequence<int, INDEX...>)
{
  static const rate_range_t range[] = {hourglass_of_set<kernel_set(INDEX)>...};
  return range[index];
}
void hourglass(int begin, int end, const tm_rates_args *args, unsigned effects)
{
  hourglass_of(kernel_set_index(effects), std::make_integer_sequence<int, KERNEL_SETS>())(begin, end, args);
}

// few instructions of prediction and update depend on these: tested at run time, by loops for scenes that have one of them
constexpr unsigned TESTED = TM_FX_CORRECTION | TM_FX_ARTSTRESS | TM_FX_HOURGLASS | TM_FX_ONE_PASS | TM_FX_BALSARA |
                            TM_FX_XSPH | TM_FX_EXPANSION | TM_FX_COMPRESSION_HEAT | TM_FX_ARTIFICIAL_HEAT;

// in chunks, so that the records are still in the cache for the artificial stress
template <unsigned SET, unsigned ASK> void predict_set(int begin, int end, const tm_predict_args *args, unsigned given)
{
  const unsigned effects = SET | (given & ASK);
  for (; begin < end; begin += TM_CHUNK) {
    const int last = end - begin < TM_CHUNK ? end : begin + TM_CHUNK;
    for (int i = begin; i < last; i++) tm_predict(i, args, effects);
    if (effects & TM_FX_PRESENT & TM_FX_ARTSTRESS) tm_predict_artstress(begin, last, args, effects);
    for (int i = begin; args->single.main && i < last; i++) tm_predict_single(i, args, given);
  }
}

template <unsigned ASK> void predict_usual(int begin, int end, const tm_predict_args *args, unsigned effects)
{
  if (effects & TM_FX_HEAT) predict_set<TM_FX_HEAT, ASK>(begin, end, args, effects);
  else predict_set<0u, ASK>(begin, end, args, effects);
}

void predict(int begin, int end, const tm_predict_args *args, unsigned effects)
{
  if (effects & RARE_IN_PREDICTION) predict_usual<~unsigned(TM_FX_HEAT)>(begin, end, args, effects);
  else if (effects & TESTED) predict_usual<TESTED | TM_FX_PLASTICITY | TM_FX_3D>(begin, end, args, effects);
  else predict_usual<TM_FX_3D>(begin, end, args, effects);
}

typedef tm_update_result (*update_range_t)(int begin, int end, const tm_update_args *args, unsigned effects);

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
template <unsigned ASK, unsigned SET> update_range_t update_of(unsigned) { return update_set<SET, ASK>; }
template <unsigned ASK, unsigned SET, unsigned BIT, unsigned... BITS> update_range_t update_of(unsigned effects)
{
  if (effects & BIT) return update_of<ASK, SET | BIT, BITS...>(effects);
  return update_of<ASK, SET, BITS...>(effects);
}
template <unsigned ASK> update_range_t update_usual(unsigned effects)
{
  constexpr unsigned HEAT = TM_FX_HEAT, CONDUCTION = TM_FX_CONDUCTION, FLOW = TM_FX_PLASTICITY;
  return (effects & HEAT) ? update_of<ASK, HEAT, CONDUCTION, FLOW, TM_FX_LEDGER, TM_FX_3D>(effects)
                          : update_of<ASK, 0u, FLOW, TM_FX_LEDGER, TM_FX_3D>(effects);
}

tm_update_result update(int begin, int end, const tm_update_args *args, unsigned effects)
{
  constexpr unsigned HEAT = TM_FX_HEAT, DIM = TM_FX_3D;    // literals of loops for rare effects
  const update_range_t run = (effects & RARE_IN_UPDATE) ? update_of<~(HEAT | DIM), 0u, HEAT, DIM>(effects)
                             : (effects & TESTED)       ? update_usual<TESTED>(effects)
                                                        : update_usual<0u>(effects);
  return run(begin, end, args, effects);
}

}    // namespace

namespace SPHTM_NS {
namespace SPHTM_ISA {

void rates_in_single(int begin, int end, const tm_rates_args *args, unsigned effects);    // single_ranges.h

extern const PairRanges pair_ranges;
const PairRanges pair_ranges = {PAIR_LOOPS(SPHTM_RANGE_NAME)};

}    // namespace SPHTM_ISA
}    // namespace SPHTM_NS
