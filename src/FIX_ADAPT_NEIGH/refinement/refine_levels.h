/* SPH-TM: values of particles for refinement: levels, families, and which particles are new. */
#ifndef SPHTM_REFINE_LEVELS_H
#define SPHTM_REFINE_LEVELS_H

#include "adapt_parts.h"
#include "particle_values.h"
#include "refine_input.h"

namespace SPHTM_NS {

class RefineLevels : public ParticleValues {
 public:
  RefineLevels(AdaptParts &all, const RefineInput &input) : parts(all), in(input) {}
  void grow(int nmax) override;
  void copy(int from, int to) override;
  void set_new(int i) override;
  int most_packed() const override { return 2 + in.most_level; }
  int pack(int i, double *) override;
  int unpack(int i, const double *) override;
  int check(const double *, int n, std::string &why) const override;

  double level(int i) const { return level_of[i]; }
  double family(int i) const { return level_of[i] > 0 ? family_of[at(i, (int) level_of[i])] : 0.0; }
  void split(int parent, double family);    // to the next level
  void merged(int i);                       // to the level below
  bool is_fresh(int i) const { return fresh[i] > 0.0; }
  void set_fresh(int i, bool now) { fresh[i] = now; }
  bool any() const;    // particle of a level above 0, on any rank
  void forget_families();
  const double *levels() const { return level_of.data(); }
  double bytes() const { return sizeof(double) * (level_of.size() + family_of.size()); }

 private:
  AdaptParts &parts;
  const RefineInput &in;
  // level 0 and up; the family at every level from 1: the tag of the parent
  std::vector<double> level_of, family_of;
  std::vector<double> fresh;    // 1: made, or next to what was made, in this step

  size_t at(int i, int level) const { return (size_t) i * in.most_level + level - 1; }
};

}    // namespace SPHTM_NS

#endif
