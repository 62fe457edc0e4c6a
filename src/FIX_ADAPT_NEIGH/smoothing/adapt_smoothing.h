/* SPH-TM: part of fix adapt/neigh: the smoothing length of each particle follows its neighborhood (ASPH), S13
   section 3. The values live in the state of fix sph/tm. */
#ifndef SPHTM_ADAPT_SMOOTHING_H
#define SPHTM_ADAPT_SMOOTHING_H

#include "adapt_part.h"

#include "loop_array.h"
#include "row_source.h"

namespace SPHTM_NS {

class AdaptSmoothing : public AdaptPart {
 public:
  explicit AdaptSmoothing(AdaptParts &all) : AdaptPart(all) {}
  bool keyword(Keywords &) override;
  std::vector<std::string> keywords() const override { return {"asph"}; }
  std::vector<std::string> options() const override { return {"every", "limits"}; }
  bool in_use() const override { return mode != NONE; }
  void init() override;
  void setup() override;
  void pre_exchange() override;
  void end_of_step() override;
  std::vector<std::string> outputs() const override { return {"smallest h", "largest h", "lists widened"}; }
  double output(int) override;
  void offer(Scene::Adaptation &) override;

 private:
  enum { NONE, PSI, DENSITY } mode = NONE;
  int every = 10;
  double least = 0.5, most = 2.0;
  double smallest_h = 0.0, largest_h = 0.0, widened = 0.0;
  LoopArray<tm_asph_table> table;
  SmoothingRule rule;    // for others

  void follow(bool first);
};

}    // namespace SPHTM_NS

#endif
