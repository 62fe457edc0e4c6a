/* SPH-TM: the loops of pair sph/tm, fix sph/tm and the computes over particles. See loop_table.h.

   A step runs drift, predict, (correction,) rates, (hourglass, thermal,) update; contact of bodies, before
   the update, is in body_loops.h. */
#ifndef SPHTM_PAIR_LOOPS_H
#define SPHTM_PAIR_LOOPS_H

#include "loop_table.h"
#include "tm_active.h"
#include "tm_boundary.h"
#include "tm_conduct.h"
#include "tm_drift.h"
#include "tm_fracture.h"
#include "tm_hourglass.h"
#include "tm_initial.h"
#include "tm_moment.h"
#include "tm_neighbors.h"
#include "tm_predict.h"
#include "tm_rates.h"
#include "tm_single.h"
#include "tm_size.h"
#include "tm_tally.h"
#include "tm_thermal.h"
#include "tm_update.h"

namespace SPHTM_NS {

struct AddLoop {
  double *to;
  const double *from;
};
struct ActiveKindLoop {
  const tm_real *kind;
  int edge;    // those at the edge, or all that do not sleep
};
struct InsulateLoop {
  tm_state state;
  tm_records rec;
};
struct HoldLoop {
  double *force;
  const int *which;
};
struct InitialLimitsLoop {
  tm_update_args update;
  int seed;
};

// families of sums
TM_FN tm_update_result tm_step_nothing(void) { return tm_update_nothing(); }
TM_FN void tm_step_sum(tm_update_result *sum, const tm_update_result *r) { tm_update_sum(sum, r, 1); }
TM_FN double tm_number_nothing(void) { return 0.0; }
TM_FN void tm_number_sum(double *sum, const double *value) { *sum += *value; }
TM_FN tm_tally_result tm_tally_nothing(void)
{
  const tm_tally_result r = {};
  return r;
}

#define PAIR_LOOPS(LOOP)                                                                               \
  /* a step; drift: *lost is the first particle lost, or n, once the loop is waited for */             \
  LOOP(OWN, drift, void, int n, const tm_drift_args &, unsigned effects, int *lost)                    \
  LOOP(RANGE, predict, tm_predict_args)                                                                \
  LOOP(EACH, round_to_single, tm_single_args, tm_single(a.first + i, &a, effects))                     \
  LOOP(RANGE, correction, tm_rates_args)                                                               \
  LOOP(RANGE, rates_in_double, tm_rates_args)                                                          \
  LOOP(RANGE, rates_in_single, tm_rates_args)                                                          \
  /* rates of some, beside what follows, then of the others */                                         \
  LOOP(OWN, begin_rates, void, int n, const tm_rates_args &, unsigned effects)                         \
  LOOP(OWN, end_rates, void, int n, const tm_rates_args &, unsigned effects)                           \
  LOOP(RANGE, hourglass, tm_rates_args)                                                                \
  /* thermal, behind the rates, may have been begun before them, to run beside */                      \
  LOOP(OWN, begin_thermal, void, int n, const tm_rates_args &, unsigned effects)                       \
  LOOP(OWN, thermal, void, int n, const tm_rates_args &, unsigned effects)                             \
  LOOP(EACH, add, AddLoop, a.to[i] += a.from[i])                                                       \
  LOOP(RANGE_SUM, update, tm_update_args, tm_update_result, tm_step)                                   \
  /* conduction in stages, before the update of a step that is longer than it bears */                 \
  LOOP(SUM, conduct_room, tm_conduct_args, int, tm_conduct_room, tm_conduct_room(i, &a))               \
  LOOP(SUM, conduct_row, tm_conduct_args, tm_real, tm_conduct_rate, tm_conduct_row(i, &a, effects))    \
  LOOP(EACH, conduct_stage, tm_conduct_args, tm_conduct_stage(i, &a))                                  \
  LOOP(SUM, conduct_end, tm_conduct_args, tm_conduct_result, tm_conduct_result, tm_conduct_end(i, &a)) \
  /* who has ghosts among its neighbors */                                                             \
  LOOP(EACH, boundary_mark, tm_boundary_args, tm_boundary_mark(i, &a))                                 \
  LOOP(LIST, boundary_list, tm_boundary_args, tm_boundary_wanted(i, &a))                               \
  /* set-up and output */                                                                              \
  LOOP(EACH, initial_of_new, tm_initial_args, tm_initial_of_new(i, &a))                                \
  LOOP(SUM, initial_limits, InitialLimitsLoop, tm_update_result, tm_step,                              \
       tm_initial_limits(i, &a.update, effects, a.seed))                                               \
  LOOP(SUM, energy_sums, tm_state, tm_energies, tm_energies, tm_energies_of(i, &a, effects))           \
  LOOP(SUM, tally, tm_tally_args, tm_tally_result, tm_tally, tm_tally(i, &a, effects))                 \
  /* particles that sleep */                                                                           \
  LOOP(EACH, active_flag, tm_active_args, a.flag[i] = tm_active_flag(i, &a))                           \
  LOOP(EACH, active_mark, tm_active_args, a.marks[i] = a.flag[i] >= a.least)                           \
  LOOP(EACH, active_wake, tm_active_args, tm_active_wake(i, &a))                                       \
  LOOP(SUM, active_sort, tm_active_args, double, tm_number, tm_active_sort(i, &a))                     \
  LOOP(SUM, active_known, ActiveKindLoop, double, tm_number, (int) a.kind[i] > TM_ACTIVE_UNKNOWN)      \
  LOOP(LIST, active_list, ActiveKindLoop,                                                              \
       a.edge ? (int) a.kind[i] == TM_ACTIVE_EDGE : (int) a.kind[i] != TM_ACTIVE_ASLEEP)               \
  LOOP(EACH, active_insulate, InsulateLoop, tm_active_insulate(i, &a.state, &a.rec))                   \
  LOOP(EACH, active_hold, HoldLoop, tm_active_hold(a.which[i], a.force))                               \
  /* numerical fracture */                                                                             \
  LOOP(SUM, fracture_unknown, tm_fracture_args, double, tm_number, tm_fracture_is_unknown(i, &a))      \
  LOOP(SUM, fracture_torn, tm_fracture_args, double, tm_number, tm_fracture_is_torn(i, &a))            \
  LOOP(EACH, fracture_refer, tm_fracture_args, tm_fracture_refer(i, &a))                               \
  LOOP(EACH, fracture_tell, tm_fracture_args, tm_fracture_tell(i, &a))                                 \
  LOOP(EACH, fracture_normal, tm_fracture_args, tm_fracture_normal(i, &a))                             \
  LOOP(EACH, fracture_bonds, tm_fracture_args, tm_fracture_bonds(i, &a))                               \
  LOOP(SUM, fracture_look, tm_fracture_args, tm_fracture_result, tm_fracture, tm_fracture_look(i, &a)) \
  LOOP(SUM, size_range, tm_state, tm_size_range, tm_size, tm_size_of(i, &a))                           \
  LOOP(SUM, near_count, tm_near_args, double, tm_number, tm_near_count(i, &a))                         \
  LOOP(SUM, nearest, tm_near_args, tm_nearest, tm_nearest, tm_nearest_neighbor(i, &a))

struct PairLoops {
  SPHTM_LOOP_POINTERS(PAIR_LOOPS)

  void rates(Backend &b, int n, const tm_rates_args &a, unsigned effects) const
  {
    run_rates(rates_of_precision(effects), b, n, a, effects);
  }
  typedef void (*RatesLoop)(Backend &, int n, const tm_rates_args &, unsigned effects);
  RatesLoop rates_of_precision(unsigned effects) const
  {
    return effects & TM_FX_MIXED ? rates_in_single : rates_in_double;
  }
  static void run_rates(RatesLoop loop, Backend &b, int n, const tm_rates_args &args, unsigned effects)
  {
    tm_rates_args a = args;
    if (a.surface_of_pass && effects & TM_FX_ONE_PASS) {    // no sum of pairs
      effects &= ~unsigned(TM_FX_SURFACE);
      a.effects &= ~unsigned(TM_FX_SURFACE);
    }
    loop(b, n, a, effects);
  }
  static bool has_single(const Backend &b, int kernel) { return b.shared() || kernel == TM_KERNEL_HYPERBOLIC; }

  static const PairLoops &of(const Backend &);
  static const PairLoops *kokkos;    // where this build has them
};

struct PairRanges {
  SPHTM_RANGE_POINTERS(PAIR_LOOPS)
};

}    // namespace SPHTM_NS

#endif
