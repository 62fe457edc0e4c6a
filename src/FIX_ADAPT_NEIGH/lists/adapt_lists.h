/* SPH-TM: adaptive neighbor lists, a part of fix adapt/neigh, F14: rows of neighbors from a cell search of its own.
   With a threshold above 0 pairs of particles that deform little are total-Lagrangian: neither searched again nor with
   kernels and artificial stress of their own; all others are updated-Lagrangian. See doc/fix_adapt_neigh.rst. */
#ifndef SPHTM_ADAPT_LISTS_H
#define SPHTM_ADAPT_LISTS_H

#include "adapt_part.h"
#include "total_lagrangian.h"

namespace SPHTM_NS {

class AdaptLists : public AdaptPart, public RowSource {
 public:
  explicit AdaptLists(AdaptParts &all) : AdaptPart(all), lists(all), stored(all, lists, map) {}
  bool keyword(Keywords &) override;
  std::vector<std::string> keywords() const override { return {"threshold", "rows", "margin", "stretch", "approach"}; }
  bool in_use() const override { return threshold >= 0.0; }
  void init() override;
  void setup_pre_exchange() override;
  void pre_exchange() override { begin_renumbering(); }
  void setup_pre_force() override { stored.begin_steps(false); }
  void pre_force() override { stored.begin_steps(true); }
  void setup() override;
  void end_of_step() override;
  void post_run() override;

  ParticleValues *values() override { return has_tl() ? &stored.pairs() : nullptr; }
  void changed(bool moved, bool renamed) override;
  std::vector<double> state() override { return stored.state(); }
  bool restore(const double *, size_t) override;

  std::vector<std::string> outputs() const override { return {"fraction", "searches", "entries in rows"}; }
  double output(int) override;
  double bytes() const override { return lists.bytes() + map.bytes() + stored.bytes(); }
  void offer(Scene::Adaptation &) override;

  // for pair sph/tm
  bool has_tl() const override { return threshold > 0.0; }
  bool keeps_all() const override { return has_tl() && stored.permanent(); }
  void renew(bool renumbered) override;
  tm_rows mechanical() override;
  tm_rows others() override { return lists.other_rows(); }
  tm_rows host_mechanical() override { return lists.host_rows(); }
  int ul_rows(tm_rates_args &) override;
  void tl_corrections(const tm_rates_args &, unsigned effects) override;
  void tl_export(const tm_records &) override;
  void tl_rates(const tm_rates_args &, unsigned effects) override;

 private:
  double threshold = -1.0;    // of plastic strain; 0: all particles are updated-Lagrangian; negative: not in use
  double stretch = -1.0;      // of strain since the freezing; negative: by default
  double approach = -1.0;     // of a distance, in reaches; negative: by default
  bool warned_slow = false, warned_tools = false;
  CandidateLists lists;
  TagMap map;
  TotalLagrangian stored;

  void begin_renumbering();
  void warn_of_tools();
};

}    // namespace SPHTM_NS

#endif
