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
  int select(int n, const tm_select_args &a, int *which) override;
  int border_change(int n, const tm_border_args &a) override;
  void border_touch(int n, const tm_border_args &a) override;
  void border(int n, const tm_border_args &a) override;
  void kept_moments(int n, const tm_kept_moment_args &a, unsigned fx) override;
  void kept_show(int n, const tm_kept_args &a, tm_real *shown) override;
  void kept_rates(int n, const tm_kept_args &a, unsigned fx) override;
  int settle_leaps(int n, const tm_settle_args &a) override;
  void settle_tell(int n, const tm_settle_args &a, unsigned fx) override;
  void settle(int n, const tm_settle_args &a, unsigned fx) override;
  int watch(int n, const tm_watch_args &a) override;
  int largest(int n, const int *) override;
  void hold_tags(int n, const tm_places_args &a) override;
  void searched(int n, const tm_real *memory, tm_real *next) override;
  int places(int n, const tm_places_args &a) override;
  void reorder(int n, const tm_kept_store &from, const int *order, const tm_kept_store &to) override;
  void kept_send(int n, const tm_kept_send_args &a) override;
  void kept_receive(int n, const tm_kept_send_args &a) override;
};

}    // namespace SPHTM_NS

#endif
