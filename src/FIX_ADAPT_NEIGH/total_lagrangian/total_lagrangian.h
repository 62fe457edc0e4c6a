/* SPH-TM: total-Lagrangian pairs beside updated-Lagrangian ones, F14: the freezing of pairs where the deformation is
   small, the TL/UL interface, the proximity check, and the rates of the pairs. See tm_tl_rates.h and
   doc/fix_adapt_neigh.rst. */
#ifndef SPHTM_TOTAL_LAGRANGIAN_H
#define SPHTM_TOTAL_LAGRANGIAN_H

#include "tl_pairs.h"

namespace SPHTM_NS {

class TotalLagrangian {
 public:
  TotalLagrangian(AdaptParts &all, CandidateLists &lists, TagMap &tags) :
      parts(all), candidates(lists), map(tags), tl_pairs(all, lists, tags)
  {
  }
  // keywords: increments of plastic strain and of strain, approach in reaches; negative: by default
  void init(double threshold, double stretch, double approach);
  TlPairs &pairs() { return tl_pairs; }
  void begin_steps(bool steps) { stepping = steps; }    // false: the set-up of a run

  void renew(bool renumbered);                            // rows of this step
  bool permanent() const;                                 // pairs are kept from the start on
  bool only() const { return !active && permanent(); }    // no particle is updated-Lagrangian
  int ul_particles(const int **which);                    // number and list
  void communicate(const tm_records &);                   // what particles export to total-Lagrangian pairs
  void correct(const tm_rates_args &, unsigned effects);
  void rates(const tm_rates_args &, unsigned effects);
  void end_of_step();
  void post_run();
  void changed(bool moved, bool renamed);

  double share_of_last_step() const { return last_ul; }    // updated-Lagrangian particles of this rank
  double steps_of_all() const { return sum_ul; }
  std::vector<double> state();
  bool restore(const double *, size_t);
  double bytes() const;

 private:
  AdaptParts &parts;
  CandidateLists &candidates;
  TagMap &map;
  TlPairs tl_pairs;
  Backend *backend = nullptr;
  const ListLoops *loops = nullptr;
  double threshold = 0.0, strain = 0.0, approach = 0.0;
  LoopArray<int> which, which_interface;
  LoopArray<tm_real> exported, pull_back, next_ul, correction;
  LoopArray<unsigned char> was_ul, is_ul;
  int active = 0, at_interface = 0;    // updated-Lagrangian particles; those at the interface
  bool any_changed = false;            // kinds or rows
  bool first_step = true;              // all pairs may be frozen at its end, without artificial stress
  bool decided = true;                 // in the last step, which particles are updated-Lagrangian
  bool came_near = false;              // particles, in this step
  bool stepping = false;
  double sum_ul = 0.0, last_ul = 0.0;
  double time = 0.0, time_checked = 0.0, next_check = 0.0;    // of steps taken; of the proximity checks
  double dropped = 0.0;                                       // pairs of deleted particles in this run, on this rank

  void limit_time_step(const tm_tl_args &, unsigned effects);
  bool corrects() const;
  void check_effects() const;
  tm_tl_args rate_args(const tm_records &);
  tm_interface_args interface_args();
  tm_freeze_args freeze_args();
  bool is_urgent(const tm_freeze_args &);
  void find_particles();
  int resolve_tags(bool same_indices);
  void drop_gone(int pairs);
  void proximity_check();
};

}    // namespace SPHTM_NS

#endif
