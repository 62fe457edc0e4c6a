/* -*- c++ -*- ----------------------------------------------------------
   SPH-TM: fix adapt/neigh. What follows the deformation: adaptive neighbor
   lists (F14), smoothing length and refinement (S13). Each is a part.
------------------------------------------------------------------------- */
#ifndef LMP_FIX_ADAPT_NEIGH_H
#define LMP_FIX_ADAPT_NEIGH_H

#include "fix.h"

#include "adapt_parts.h"
#include "between_runs.h"

#include <cstdint>

namespace LAMMPS_NS {

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
  void pre_force(int) override;
  void end_of_step() override;
  void post_run() override;
  double compute_vector(int) override;
  double memory_usage() override;

  void grow_arrays(int) override;
  void copy_arrays(int, int, int) override;
  void set_arrays(int) override;
  int pack_exchange(int, double *) override;
  int unpack_exchange(int, double *) override;
  void reorder_arrays(int n, const int *order);
  void send_arrays(int n, const int *sent, const int *filled_by, double *buf);
  void receive_arrays(int n, const int *index, double *buf);
  int pack_forward_comm(int, int *, double *, int, int *) override;
  void unpack_forward_comm(int, int, double *) override;

  int pack_restart(int, double *) override;
  void unpack_restart(int, int) override;
  int size_restart(int) override;
  int maxsize_restart() override;
  void write_restart(FILE *) override;
  void restart(char *) override;

 protected:
  SPHTM_NS::AdaptParts parts;

 private:
  SPHTM_NS::BetweenRuns between;
  struct {
    uint64_t rows = 0, hash = 0, rows_written = 0, hash_written = 0;
  } read;    // from a restart file, until it is checked

  void check_restart();
  const double *restart_row(int i, int nth);
  void check_lengths();
  [[noreturn]] void refuse_restart();
};

}    // namespace LAMMPS_NS

#endif
