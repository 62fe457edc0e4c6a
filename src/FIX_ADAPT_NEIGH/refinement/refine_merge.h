/* SPH-TM: refinement, a family back into one particle.

   A merge is found on the rank of the child that has kept the parent's tag: it knows the others, its own or ghosts. A
   second communication tells the others, which are then removed. */
#ifndef SPHTM_REFINE_MERGE_H
#define SPHTM_REFINE_MERGE_H

#include "refine_step.h"

#include "lmptype.h"

namespace SPHTM_NS {

enum { REFINE_NOTHING, REFINE_SPLIT, REFINE_BACK, REFINE_STAYS };    // marks of particles in the cloud

class RefineMerge : public RefineStep {
 public:
  using RefineStep::RefineStep;
  void clear();
  void plan();
  size_t planned() const { return merges.size(); }
  std::vector<int> plan_leaving();    // returns particles near those that are split or merged
  void make();
  void remove_leaving();
  double made() const { return n_merges; }    // of this rank
  void restore(double merges_made) { n_merges = merges_made; }

 private:
  struct Merge {
    int i;    // the particle that stays
    std::vector<double> row;
    double x[3];    // its position then
    double heat;    // kinetic energy that leaves the motion
    tm_content change;
  };
  std::vector<Merge> merges;
  std::vector<std::pair<int, LAMMPS_NS::tagint>> leaving;    // into a merged particle
  double n_merges = 0;

  std::vector<int> members(int i, const std::vector<int> &by_family);
};

}    // namespace SPHTM_NS

#endif
