/* SPH-TM: refinement, one particle into several, S13 section 4. */
#ifndef SPHTM_REFINE_SPLIT_H
#define SPHTM_REFINE_SPLIT_H

#include "refine_step.h"

#include "lmptype.h"

namespace SPHTM_NS {

class RefineSplit : public RefineStep {
 public:
  using RefineStep::RefineStep;
  void clear() { splits.clear(); }
  void plan(int i);
  size_t planned() const { return splits.size(); }
  void foresee_time_step();
  void report_levels();
  void drop_outside();
  void make();

  double made() const { return n_splits; }    // of this rank
  double kept_at_box() const { return n_outside; }
  double tag_of_next() const { return next_tag; }
  int reported() const { return levels_reported; }
  void restore(double next, int reported_levels);
  void restore_counts(double splits_made, double outside);

 private:
  struct Split {
    int i;
    LAMMPS_NS::tagint tag;
    std::vector<double> place;       // of the children, x, y, z each, in h of the parent
    std::vector<double> children;    // rows of the cloud
    tm_content change;
  };
  std::vector<Split> splits;
  double n_splits = 0, n_outside = 0;
  double next_tag = 0;        // of all ranks
  int levels_reported = 0;    // the log has said what the first split to this level costs

  std::vector<double> places(int i);
  bool inside_box(const Split &) const;
  std::vector<LAMMPS_NS::tagint> new_tags();
};

}    // namespace SPHTM_NS

#endif
