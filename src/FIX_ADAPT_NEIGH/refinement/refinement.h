/* SPH-TM: the part of fix adapt/neigh that splits particles into smaller ones and merges them again, S13
   section 4. See doc/fix_adapt_neigh.rst.

   At the end of every M-th step the criteria are looked at and what is to be made is worked out, from the
   state at the full step alone, so that a run and its restart decide alike. The particles are made in
   pre_exchange of the next step, in which the lists are renewed. */
#ifndef SPHTM_REFINEMENT_H
#define SPHTM_REFINEMENT_H

#include "adapt_part.h"
#include "cloud.h"
#include "contact_probe.h"
#include "refine_criterion.h"
#include "tm_split_pattern.h"

#include "lmptype.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace SPHTM_NS {

class Refinement : public AdaptPart {
 public:
  explicit Refinement(LAMMPS_NS::FixAdaptNeigh &);
  bool keyword(Keywords &) override;
  std::vector<std::string> keywords() const override { return {"refine", "coarsen"}; }
  std::vector<std::string> options() const override
  {
    return {"epsilon", "alpha", "when", "level", "every", "velocity", "settle"};
  }
  bool in_use() const override { return kind >= 0 || coarsen != NEVER; }
  bool on_host() const override { return true; }
  void ready() override;
  void init() override;
  void setup() override;
  void pre_exchange() override;
  void end_of_step() override;

  bool has_values() const override { return true; }
  void grow(int nmax) override;
  void copy(int from, int to) override;
  void set_new(int i) override;
  int most_packed() const override { return 2 + most_level; }
  int pack(int i, double *) override;
  int unpack(int i, const double *) override;
  int look(const double *, int n, std::string &why) const override;
  void changed(bool moved, bool renamed) override;
  std::vector<double> state() override;
  bool restore(const double *, size_t) override;

  std::vector<std::string> outputs() const override;
  double output(int) override;
  void *extract(const char *name) override { return std::string(name) == "level" ? level.data() : nullptr; }
  double bytes() const override { return sizeof(double) * (level.size() + family.size()); }

 private:
  // input
  int kind = -1;                       // enum tm_split_kind, or -1: no refinement
  double epsilon = 0.0, alpha = 0.0;   // in h of the parent
  int most_level = 1, every = 100;
  int sweeps = 0;                      // of settling
  bool linear = false;                 // children take the velocity field, not the parent's velocity
  enum { NEVER, FALLEN, WHEN } coarsen = NEVER;
  RefineCriteria when, coarsen_when;
  tm_split_pattern pattern = {};

  // of particles: level 0 and up; the family at every level from 1, the tag of its parent
  std::vector<double> level, family;
  std::vector<double> fresh;           // 1: made, or next to what was made, in this step

  // what the next pre_exchange does
  struct Split {
    int i;
    LAMMPS_NS::tagint tag;
    std::vector<double> place;         // of the children, x, y, z each, in h of the parent
    std::vector<double> children;      // rows of the cloud
    tm_content change;
  };
  struct Merge {
    int i;                             // who stays
    LAMMPS_NS::tagint tag;
    std::vector<double> row;
    double x[3];                       // where it was then
    double heat;                       // kinetic energy that leaves the motion
    tm_content change;
  };
  std::vector<Split> splits;
  std::vector<Merge> merges;
  std::vector<std::pair<int, LAMMPS_NS::tagint>> leaving;    // into a merged particle
  std::vector<int> touched;            // those whose neighbors change
  bool pending = false;                // on any rank
  Cloud cloud;
  std::vector<ContactProbe *> tools;

  // sums over the run, of this rank
  double n_splits = 0, n_merges = 0, n_outside = 0;
  tm_content error;                    // what splits and merges changed
  double next_tag = 0;                 // of all ranks
  bool asked_levels = false;           // whether those of particles are known
  int levels_told = 0;                 // the log has said what the first split to this level costs
  std::vector<double> summed;          // the outputs of step summed_at
  LAMMPS_NS::bigint summed_at = -1;
  LAMMPS_NS::bigint apply_at = -1;     // the step in which the plans are carried out
  LAMMPS_NS::bigint settle_at = -1;    // the step at whose end particles settle

  LAMMPS_NS::LAMMPS *lmp() const;
  void read_refine(Keywords &);
  void read_epsilon(Keywords &);
  void read_pattern(Keywords &);
  void make_pattern(int kernel);
  LAMMPS_NS::bigint next_check() const;
  void forget_plans();
  void warn_of_lost_levels();
  void decide();
  enum { NOTHING, SPLIT, FALLEN_BACK, STAYS };    // marks
  std::vector<char> mark();
  std::vector<int> kin(int i);
  void spread(int i, const double *place, int n, double size, double *rows);
  std::vector<double> places(int i);
  void plan_split(int i);
  std::vector<int> members(int i, const std::vector<int> &by_family);
  void plan_merges();
  void plan_leaving();
  void foresee_time_step();
  double elastic_energy(const double *row, int type) const;
  void add_content(tm_content &, double sign, const double *row, const double *about, int type) const;
  bool inside_box(const Split &) const;
  void drop_outside();
  std::vector<LAMMPS_NS::tagint> new_tags();
  void make_children();
  void make_merged();
  void remove_leaving();
  struct Moved;
  std::vector<tm_vec3> even_out(std::vector<char> &moves);
  Moved measure(const std::vector<char> &moves, const std::vector<tm_vec3> &shift);
  void settle();
  void write_row(int i, const double *row);
  double &family_at(int i, int of_level) { return family[(size_t) i * most_level + of_level - 1]; }
  void report_levels();
  std::vector<double> sums() const;    // of all ranks
  void sum_outputs();
};

}    // namespace SPHTM_NS

#endif
