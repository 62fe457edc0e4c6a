/* SPH-TM: the part of fix adapt/neigh that splits particles into smaller ones and merges them again, S13
   section 4. See doc/fix_adapt_neigh_refine.rst.

   At the end of every M-th step the criteria are evaluated and splits and merges are planned, from the state at the
   full step alone, so that a run and its restart decide alike. The particles are made in pre_exchange of the next
   step, in which the lists are renewed. */
#ifndef SPHTM_REFINEMENT_H
#define SPHTM_REFINEMENT_H

#include "adapt_part.h"
#include "refine_merge.h"
#include "refine_split.h"
#include "relaxation.h"

namespace SPHTM_NS {

class Refinement : public AdaptPart {
 public:
  explicit Refinement(AdaptParts &);
  bool keyword(Keywords &k) override { return in.keyword(k); }
  std::vector<std::string> keywords() const override { return {"refine", "coarsen"}; }
  std::vector<std::string> options() const override { return RefineInput::options(); }
  bool in_use() const override { return in.kind >= 0 || in.coarsen != RefineInput::NEVER; }
  bool on_host() const override { return true; }
  void ready() override;
  void init() override;
  void setup() override;
  void pre_exchange() override;
  void end_of_step() override;

  ParticleValues *values() override { return &levels; }
  void changed(bool moved, bool renamed) override;
  std::vector<double> state() override;
  bool restore(const double *, size_t) override;
  std::vector<std::string> outputs() const override;
  double output(int) override;
  void offer(Scene::Adaptation &a) override
  {
    a.levels = [this] { return levels.levels(); };
  }
  double bytes() const override { return levels.bytes(); }

 private:
  RefineInput in;
  Cloud cloud;
  Remap remap;
  RefineLevels levels;
  RefineSplit split;
  RefineMerge merge;
  Relaxation relaxation;
  std::vector<int> touched;      // particles whose neighbors change
  bool pending = false;          // splits or merges, on any rank
  bool asked_levels = false;     // whether those of particles are known
  std::vector<double> summed;    // the outputs of step summed_at
  LAMMPS_NS::bigint summed_at = -1;
  LAMMPS_NS::bigint apply_at = -1;    // the step in which the plans are carried out
  LAMMPS_NS::bigint relax_at = -1;    // the step at whose end positions are relaxed

  LAMMPS_NS::LAMMPS *lmp() const { return parts.host(); }
  LAMMPS_NS::bigint next_check() const;
  void forget_plans();
  void warn_of_tools();
  bool warned_tools = false;
  void warn_of_lost_levels();
  void decide();
  std::vector<char> mark();
  std::vector<double> sums() const;    // of all ranks
  void sum_outputs();
};

}    // namespace SPHTM_NS

#endif
