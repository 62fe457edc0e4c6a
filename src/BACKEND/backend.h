/* SPH-TM: where the loops over particles run and where their arrays live.

   The host's, or that of Kokkos on threads or a GPU (backend_kokkos.h). What runs there stands in the loop tables of
   the packages (loop_table.h). */
#ifndef SPHTM_BACKEND_H
#define SPHTM_BACKEND_H

#include "tm_candidates.h"
#include "tm_tag_map.h"
#include "tm_tl_correction.h"
#include "tm_tl_interface.h"
#include "tm_tl_proximity.h"
#include "tm_smoothing.h"

#include <functional>
#include <string>
#include <vector>

namespace SPHTM_NS {

constexpr int LOOP_BLOCK = 8 * 96;    // particles; a multiple of the host's TM_CHUNK

class Backend {
 public:
  static Backend &host();
  virtual ~Backend() = default;
  virtual std::string name() const;    // for the log

  // memory of the loops; shared: it is the host's
  virtual bool shared() const { return true; }
  virtual int block() const { return 1; }    // particles of a block, see tm_layout.h
  virtual void *allocate(size_t) { return nullptr; }
  virtual void release(void *) {}
  virtual void to_loops(void * /*there*/, const void * /*here*/, size_t) {}
  virtual void to_host(void * /*here*/, const void * /*there*/, size_t) {}
  virtual void copy(void *to, const void *from, size_t bytes);    // within it
  virtual void zero(void *, size_t bytes);
  virtual void fill(unsigned char *, unsigned char value, size_t n);
  virtual bool equal(int n, const int *a, const int *b);
  virtual void wait() {}    // until all loops are done

  // for results of loops that are not waited for: memory that host and loops see
  virtual void *allocate_result(size_t);
  virtual void release_result(void *);

  // search of neighbors: the box of n particles at x, their order by cells, rows of n (the longest)
  virtual tm_bounds bounds(int n, const double *x);
  virtual void bin(const tm_cells &);
  virtual int search(int n, const tm_search_args &);
  virtual int mark(const tm_cells &, const unsigned char *marks);    // counts those marked in order of cells
  virtual int moved(int n, const tm_moved_args &);
  virtual int near_moved(int n, const tm_near_moved_args &, int *which);    // which are, in order; how many
  // rows that are kept, and those at their border
  virtual int border_change(int n, const tm_interface_args &);
  virtual void border_touch(int n, const tm_interface_args &);
  virtual void border(int n, const tm_interface_args &);
  virtual int of_kind(int n, const tm_kind_args &, int *which);    // which are, in order; how many
  virtual void kept_moments(int n, const tm_tl_correction_args &, unsigned effects);
  virtual void kept_show(int n, const tm_tl_args &, tm_real *shown);
  virtual void kept_rates(int n, const tm_tl_args &, unsigned effects);
  virtual int settle_leaps(int n, const tm_freeze_args &);    // how many
  virtual void settle_tell(int n, const tm_freeze_args &, unsigned effects);
  virtual void settle(int n, const tm_freeze_args &, unsigned effects);
  virtual int watch(int n, const tm_proximity_args &);
  // and when particles get new places: tm_tl_migration.h
  virtual int largest(int n, const int *);    // at least 0
  virtual void hold_tags(int n, const tm_tag_map_args &);
  virtual void searched(int n, const tm_real *history, tm_real *next_ul);
  virtual int places(int n, const tm_tag_map_args &);    // how many entries are nowhere
  virtual void reorder(int n, const tm_tl_store &from, const int *order, const tm_tl_store &to);
  virtual void kept_send(int n, const tm_tl_migration_args &);
  virtual void kept_receive(int n, const tm_tl_migration_args &);

  virtual tm_size_range smoothing(int n, const tm_smoothing_args &, unsigned effects);

  // loops on the host: f(begin, end) for the blocks that make up 0..n-1
  virtual void blocks(int n, const std::function<void(int, int)> &f);

  // the sum of part(begin, end) over the blocks
  template <class RESULT, class PART, class JOIN>
  RESULT sum_blocks(int n, const RESULT &nothing, PART part, JOIN join)
  {
    std::vector<RESULT> parts((n + LOOP_BLOCK - 1) / LOOP_BLOCK, nothing);
    blocks(n, [&](int begin, int end) { parts[begin / LOOP_BLOCK] = part(begin, end); });
    RESULT sum = nothing;
    for (const RESULT &p : parts) join(&sum, &p);
    return sum;
  }
};

}    // namespace SPHTM_NS

#endif
