/* SPH-TM: included once per instruction set with SPHTM_ISA set to the namespace. */
#include "list_loops.h"

namespace {

int search(int begin, int end, const tm_search_args *args)
{
  int longest = 0;
  for (int k = begin; k < end; k++) {
    const int n = tm_search(args->which ? args->which[k] : k, args);
    longest = n > longest ? n : longest;
  }
  return longest;
}

template <unsigned EFFECTS> void kept(int begin, int end, const tm_tl_args *args)
{
  for (int i = begin; i < end; i++)
    if (args->rows.tl[i]) tm_tl_rates(i, args, EFFECTS);
}

void show(int begin, int end, const tm_tl_args *args, tm_real *shown)
{
  for (int i = begin; i < end; i++) tm_tl_export(i, args, shown);
}

void moments(int begin, int end, const tm_tl_correction_args *args, unsigned effects)
{
  for (int i = begin; i < end; i++) tm_tl_correction(i, args, effects);
}

void settle(int begin, int end, const tm_freeze_args *args, unsigned effects)
{
  for (int k = begin; k < end; k++) tm_freeze(args->which ? args->which[k] : k, args, effects);
}

int watch(int begin, int end, const tm_proximity_args *args)
{
  int sum = 0;
  for (int i = begin; i < end; i++) sum += tm_proximity_check(i, args);
  return sum;
}

}    // namespace

namespace SPHTM_NS {
namespace SPHTM_ISA {

#define TM_KEPT_4(K) \
  kept<kept_loop_effects(K)>, kept<kept_loop_effects(K + 1)>, kept<kept_loop_effects(K + 2)>, \
      kept<kept_loop_effects(K + 3)>

extern const ListLoops list_loops;
const ListLoops list_loops = {search, {TM_KEPT_4(0), TM_KEPT_4(4)}, show, moments, settle, watch};

}    // namespace SPHTM_ISA
}    // namespace SPHTM_NS
