/* SPH-TM: the loops of fix adapt/neigh over particles. See loop_table.h. */
#ifndef SPHTM_LIST_LOOPS_H
#define SPHTM_LIST_LOOPS_H

#include "search_loops.h"
#include "tm_candidates.h"
#include "tm_tag_map.h"
#include "tm_tl_correction.h"
#include "tm_tl_interface.h"
#include "tm_tl_proximity.h"

namespace SPHTM_NS {

struct NumbersLoop {
  const int *a, *b;
};
struct ExportLoop {
  tm_tl_args rates;
  tm_real *exported;
};
struct KindLoop {
  const tm_real *history;
  tm_real *next_ul;
};
struct ReorderLoop {
  tm_tl_store from, to;
  const int *order;
};

// families of sums
TM_FN tm_real tm_fastest_nothing(void) { return 0.0; }
TM_FN void tm_fastest_sum(tm_real *most, const tm_real *speed) { *most = tm_max(*most, *speed); }
TM_FN int tm_count_nothing(void) { return 0; }
TM_FN void tm_count_sum(int *sum, const int *n) { *sum += *n; }

#define LIST_LOOPS(LOOP)                                                                              \
  /* candidate lists */                                                                               \
  LOOP(SUM, moved, tm_moved_args, int, tm_count, tm_moved(i, &a))                                     \
  LOOP(LIST, near_moved, tm_near_moved_args, tm_near_moved(i, &a))                                    \
  /* the TL/UL interface */                                                                           \
  LOOP(EACH, kinds, KindLoop, a.next_ul[i] = tm_is_ul(a.history + (ptrdiff_t) i * TM_TL_HISTORY))     \
  LOOP(SUM, switch_kinds, tm_interface_args, int, tm_count, tm_interface_switch(i, &a))               \
  LOOP(EACH, mark_interface, tm_interface_args, tm_interface_mark(i, &a))                             \
  LOOP(EACH, interface_rows, tm_interface_args, tm_interface_row(i, &a))                              \
  LOOP(LIST, of_kind, tm_kind_args, tm_is_of_kind(i, &a))                                             \
  /* rates of total-Lagrangian pairs; the end of a step */                                            \
  LOOP(HOT_EACH, tl_correction, tm_tl_correction_args, tm_tl_correction(i, &a, effects))              \
  LOOP(HOT_EACH, tl_export, ExportLoop, tm_tl_export(i, &a.rates, a.exported))                        \
  LOOP(SUM, tl_fastest, tm_tl_args, tm_real, tm_fastest, tm_tl_fastest(i, &a, effects))               \
  LOOP(RANGE, tl_rates, tm_tl_args)                                                                   \
  LOOP(SUM, urgent, tm_freeze_args, int, tm_count, tm_freeze_is_urgent(i, &a))                        \
  LOOP(EACH, decide, tm_freeze_args, tm_freeze_decide(i, &a, effects))                                \
  LOOP(HOT_EACH, freeze, tm_freeze_args, tm_freeze(a.which ? a.which[i] : i, &a, effects))            \
  LOOP(HOT_SUM, proximity_check, tm_proximity_args, int, tm_count, tm_proximity_check(i, &a))         \
  /* new indices and migration */                                                                     \
  LOOP(SUM, differing, NumbersLoop, int, tm_count, a.a[i] != a.b[i])                                  \
  LOOP(SUM, largest, NumbersLoop, int, tm_largest, a.a[i])                                            \
  LOOP(OWN, chain_tags, void, int n, const tm_tag_map_args &)                                         \
  LOOP(SUM, resolve_tags, tm_tag_map_args, int, tm_count, tm_tag_map_resolve(i, &a)) /* pairs lost */ \
  LOOP(EACH, reorder, ReorderLoop, tm_tl_copy(&a.from, a.order[i], &a.to, i))                         \
  LOOP(EACH, send, tm_tl_migration_args, tm_tl_send(i, &a))                                           \
  LOOP(EACH, receive, tm_tl_migration_args, tm_tl_receive(i, &a))

struct ListLoops {
  SPHTM_LOOP_POINTERS(LIST_LOOPS)

  static const ListLoops &of(const Backend &);
  static const ListLoops *kokkos;    // where this build has them
};

struct ListRanges {
  SPHTM_RANGE_POINTERS(LIST_LOOPS)
};

// the sets of effects that tl_rates() is instantiated for: dimension, viscosity, conduction
constexpr int TL_SETS = 8;
static constexpr unsigned tl_set(int k)
{
  return (k & 1 ? unsigned(TM_FX_3D) : 0u) | (k & 2 ? unsigned(TM_FX_VISCOSITY) : 0u) |
         (k & 4 ? unsigned(TM_FX_CONDUCTION) : 0u);
}
static constexpr int tl_set_index(unsigned effects)
{
  return (effects & TM_FX_3D ? 1 : 0) + (effects & TM_FX_VISCOSITY ? 2 : 0) + (effects & TM_FX_CONDUCTION ? 4 : 0);
}

}    // namespace SPHTM_NS

#endif
