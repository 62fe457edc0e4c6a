/* SPH-TM: the parts of fix adapt/neigh, and what they ask of it and of the run. */
#ifndef SPHTM_ADAPT_PARTS_H
#define SPHTM_ADAPT_PARTS_H

#include "scene.h"

#include <memory>
#include <string>
#include <vector>

namespace LAMMPS_NS {
class Fix;
class LAMMPS;
}    // namespace LAMMPS_NS

namespace SPHTM_NS {

class AdaptPart;
class Keywords;
class ParticleValues;

class AdaptParts {
 public:
  AdaptParts(LAMMPS_NS::LAMMPS *, LAMMPS_NS::Fix &);
  ~AdaptParts();
  void add(std::unique_ptr<AdaptPart>);
  void read(Keywords);
  void find_run();    // from init on state(), model(), rows(), results() are known

  const std::vector<std::unique_ptr<AdaptPart>> &all() const { return parts; }
  const std::vector<AdaptPart *> &used() const { return in_use; }
  const std::vector<ParticleValues *> &values() const { return moving; }    // of those in use
  bool uses(const std::string &keyword) const;                              // the part that has it is in use
  bool on_host() const;    // a part works on LAMMPS's particles of the host in any step

  // for the parts
  LAMMPS_NS::LAMMPS *host() const { return lmp; }
  Scene &scene() const { return *run; }
  ParticleState &state() const { return *particles; }
  Model &model() const { return run->model(); }
  NeighborRows &rows() const { return run->rows(); }
  StepResults &results() const { return run->results(); }
  ParticleState *known() const { return particles; }
  bool is_complete() const { return particles && particles == run->state() && run->has_pair(); }
  void offer() const;    // to the scene what the parts in use have for others
  int owned() const;     // particles of this rank
  int owned_and_ghosts() const;
  std::string id() const;    // of the fix
  int group_bit() const;
  void renew_lists();           // in the next step
  void update_packed_size();    // when the most a particle packs has changed
  // values of owned particles to their ghosts, where the loops run
  void communicate(LoopArray<tm_real> &, int columns);
  // the same on the host, rows of any width; the first three columns are the position
  void forward(double *rows, int columns);
  double *forwarded() const { return forward_rows; }
  int forwarded_columns() const { return forward_columns; }

 private:
  LAMMPS_NS::LAMMPS *lmp;
  LAMMPS_NS::Fix &fix;
  std::vector<std::unique_ptr<AdaptPart>> parts;
  std::vector<AdaptPart *> in_use;
  std::vector<ParticleValues *> moving;
  std::shared_ptr<Scene> run;
  ParticleState *particles = nullptr;
  double *forward_rows = nullptr;
  int forward_columns = 0;
};

}    // namespace SPHTM_NS

#endif
