/* SPH-TM: the stored pairs of total-Lagrangian particles: rows, weights and history variables, their way through
   renumbering, migration and restart files. See tm_tl_rows.h, tm_tl_migration.h. */
#ifndef SPHTM_TL_PAIRS_H
#define SPHTM_TL_PAIRS_H

#include "candidate_lists.h"
#include "particle_values.h"

namespace SPHTM_NS {

class TlPairs : public ParticleValues {
 public:
  TlPairs(AdaptParts &all, CandidateLists &lists, TagMap &tags) : parts(all), candidates(lists), map(tags) {}
  // the loops run elsewhere, or rows have another room: pairs are moved there
  void reshape(Backend &);
  void make_room(int n);
  bool exist() const { return table.capacity > 0; }
  int capacity() const { return table.capacity; }
  void check_kernel(double threshold);    // gradients are those of one kernel and one h
  void forget();                          // all pairs and histories

  tm_tl_rows rows(bool on_host = false);    // where the loops run, or on the host
  tm_tl_store store(bool on_host = false);
  tm_rows mechanical();    // the total-Lagrangian pairs alone
  tm_rates_args interface_rows(const tm_rates_args &, const int *which);
  const int *numbers() { return number.loop_read(); }
  tm_real *history() { return history_of.loop_write(); }
  const tm_real *history_read() { return history_of.loop_read(); }

  // values of particles
  void grow(int nmax) override;
  void copy(int from, int to) override;
  void set_new(int i) override;
  int most_packed() const override;
  int pack(int i, double *) override;
  int unpack(int i, const double *) override;
  int check(const double *, int n, std::string &why) const override;
  void reorder(int n, const int *order) override;
  void send(int n, const int *sent, const int *filled_by, double *) override;
  void receive(int n, const int *index, double *) override;

  int kernel() const { return stored_kernel; }
  double h() const { return stored_h; }
  void restore(int kernel, double h);
  double bytes() const;

 private:
  AdaptParts &parts;
  CandidateLists &candidates;
  TagMap &map;
  Backend *backend = nullptr;
  const ListLoops *loops = nullptr;
  RowTable table;           // total-Lagrangian pairs, and updated-Lagrangian ones behind them
  LoopArray<int> number;    // of total-Lagrangian pairs
  LoopArray<ptrdiff_t> ul_first;
  LoopArray<short> weight;
  LoopArray<tm_real> history_of;
  double unit = 1.0;    // of gradients
  int stored_kernel = -1;
  double stored_h = 0.0;

  std::vector<std::vector<double>> take_rows(const Backend &);
  void put_rows(const std::vector<std::vector<double>> &);
};

}    // namespace SPHTM_NS

#endif
