/* SPH-TM: the keywords refine and coarsen of fix adapt/neigh. See doc/fix_adapt_neigh_refine.rst. */
#ifndef SPHTM_REFINE_INPUT_H
#define SPHTM_REFINE_INPUT_H

#include "refine_criterion.h"
#include "tm_split_pattern.h"

namespace SPHTM_NS {

class RefineInput {
 public:
  explicit RefineInput(AdaptParts &all) : when(all, "refine"), coarsen_when(all, "coarsen"), parts(all) {}
  bool keyword(Keywords &);
  static std::vector<std::string> options()
  {
    return {"epsilon", "alpha", "when", "level", "every", "velocity", "settle"};
  }
  void check() const;
  void make_pattern(int kernel);    // masses of the children, S13 (6) to (9)

  int kind = -1;                        // enum tm_split_kind, or -1: no refinement
  double epsilon = 0.0, alpha = 0.0;    // in h of the parent
  int most_level = 1, every = 100;
  int sweeps = 0;         // of the relaxation of positions after a split, keyword settle
  bool linear = false;    // children take the velocity field, not the parent's velocity
  enum { NEVER, FALLEN, WHEN } coarsen = NEVER;
  RefineCriteria when, coarsen_when;
  tm_split_pattern pattern = {};

 private:
  AdaptParts &parts;
  void read_refine(Keywords &);
  void read_epsilon(Keywords &);
  void read_pattern(Keywords &);
};

}    // namespace SPHTM_NS

#endif
