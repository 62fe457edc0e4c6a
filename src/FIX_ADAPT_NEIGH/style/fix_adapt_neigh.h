/* -*- c++ -*- ----------------------------------------------------------
   SPH-TM: fix adapt/neigh. What follows the deformation: adaptive neighbour
   lists (F14), smoothing length and refinement (S13). Each is a part.
------------------------------------------------------------------------- */
#ifndef LMP_FIX_ADAPT_NEIGH_H
#define LMP_FIX_ADAPT_NEIGH_H

#include "fix.h"

#include "adapt_part.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace LAMMPS_NS {

class FixSPHTM;
class PairSPHTM;

class FixAdaptNeigh : public Fix {
 public:
  FixAdaptNeigh(class LAMMPS *, int, char **);
  ~FixAdaptNeigh() override;
  void post_constructor() override;
  int setmask() override;
  void init() override;
  void setup_pre_exchange() override;
  void setup_pre_force(int) override;
  void setup(int) override;
  void pre_exchange() override;
  void post_neighbor() override;
  void pre_force(int) override;
  void end_of_step() override;
  void post_run() override;
  double compute_vector(int) override;
  void *extract(const char *, int &) override;

  void grow_arrays(int) override;
  void copy_arrays(int, int, int) override;
  void set_arrays(int) override;
  int pack_exchange(int, double *) override;
  int unpack_exchange(int, double *) override;
  void reorder_arrays(int n, const int *order);
  void send_arrays(int n, const int *sent, const int *filled_by, double *buf);
  void receive_arrays(int n, const int *place, double *buf);
  int pack_restart(int, double *) override;
  void unpack_restart(int, int) override;
  int size_restart(int) override;
  int maxsize_restart() override;
  void write_restart(FILE *) override;
  void restart(char *) override;
  int pack_forward_comm(int, int *, double *, int, int *) override;
  void unpack_forward_comm(int, int, double *) override;
  double memory_usage() override;

  // for the parts; valid from init on
  FixSPHTM &body() { return *sph; }
  PairSPHTM &pair() { return *pair_sph; }
  LAMMPS *host() { return lmp; }
  void renew_lists();           // in the next step
  void update_packed_size();    // when the most a particle packs has changed
  // rows of owned particles to their ghosts; the first three columns are the position
  void forward(double *rows, int columns);
  bool uses(const std::string &keyword) const;    // the part that has it is in use
  void remade(int i, double factor);
  void neighborhood_changed(int i);
  bool on_host() const;         // a part works on LAMMPS's particles of the host in any step

 private:
  std::vector<std::unique_ptr<SPHTM_NS::AdaptPart>> parts;    // all that there are
  std::vector<SPHTM_NS::AdaptPart *> used;                    // those in use
  FixSPHTM *sph = nullptr;
  PairSPHTM *pair_sph = nullptr;
  double *forwarded = nullptr;
  int forwarded_columns = 0;
  bool has_values = false;    // that move with the particles
  struct {
    bool on = false, moved = false, renamed = false;
    double least = 0.0;       // way that counts
    std::vector<int> tag;     // of owned particles; 0: not known
    std::vector<double> x;
  } then;                     // at the end of the last run, and what was seen since
  void remember(int i, int tag, const double *x);
  void compare(int i, int tag, const double *x);
  void forget_places() { then.on = false; }    // particles get others unseen
  void begin_watch();
  void end_watch();
  struct {
    uint64_t rows = 0, hash = 0, rows_written = 0, hash_written = 0;
  } read;                     // from a restart file, until it is checked

  void read_keywords(SPHTM_NS::Keywords);
  void check_restart();
  void check_group();
  const double *restart_row(int i, int nth);
  void check_lengths();
  [[noreturn]] void refuse_restart();
  std::string known_words() const;
};

}    // namespace LAMMPS_NS

#endif
