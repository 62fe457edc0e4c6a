/* SPH-TM: the loops of neighbor lists as kernels of Kokkos: cells, search, and rows that are kept. */
#ifndef SPHTM_LISTS_KOKKOS_H
#define SPHTM_LISTS_KOKKOS_H

#include "backend.h"

namespace SPHTM_NS {

class KokkosLists : public Backend {
 public:
  bool equal(int n, const int *a, const int *b) override;
  tm_bounds bounds(int n, const double *x) override;
  void bin(const tm_cells &c) override;
  int search(int n, const tm_search_args &a) override;
  int mark(const tm_cells &c, const unsigned char *marks) override;
  int moved(int n, const tm_moved_args &a) override;
  int near_moved(int n, const tm_near_moved_args &a, int *which) override;
  int of_kind(int n, const tm_kind_args &a, int *which) override;
  int border_change(int n, const tm_interface_args &a) override;
  void border_touch(int n, const tm_interface_args &a) override;
  void border(int n, const tm_interface_args &a) override;
  void kept_moments(int n, const tm_tl_correction_args &a, unsigned fx) override;
  void kept_show(int n, const tm_tl_args &a, tm_real *shown) override;
  void kept_rates(int n, const tm_tl_args &a, unsigned fx) override;
  int settle_leaps(int n, const tm_freeze_args &a) override;
  void settle_tell(int n, const tm_freeze_args &a, unsigned fx) override;
  void settle(int n, const tm_freeze_args &a, unsigned fx) override;
  int watch(int n, const tm_proximity_args &a) override;
  int largest(int n, const int *) override;
  void hold_tags(int n, const tm_tag_map_args &a) override;
  void searched(int n, const tm_real *history, tm_real *next_ul) override;
  int places(int n, const tm_tag_map_args &a) override;
  void reorder(int n, const tm_tl_store &from, const int *order, const tm_tl_store &to) override;
  void kept_send(int n, const tm_tl_migration_args &a) override;
  void kept_receive(int n, const tm_tl_migration_args &a) override;
};

}    // namespace SPHTM_NS

#endif
