/* SPH-TM: adaptive neighbor lists, a part of fix adapt/neigh: rows of neighbors from a cell search of its
   own, searched again where the deformation asks for it and kept elsewhere. F14; see tm_tl_rates.h and
   doc/fix_adapt_neigh.rst. */
#ifndef SPHTM_ADAPT_LISTS_H
#define SPHTM_ADAPT_LISTS_H

#include "adapt_part.h"
#include "row_source.h"
#include "row_table.h"

namespace SPHTM_NS {

class AdaptLists : public AdaptPart, public RowSource {
 public:
  using AdaptPart::AdaptPart;
  bool keyword(Keywords &) override;
  std::vector<std::string> keywords() const override { return {"threshold", "rows", "margin", "stretch", "approach"}; }
  bool in_use() const override { return threshold >= 0.0; }
  void init() override;
  void setup_pre_exchange() override
  {
    to_tags();
    rows_good = false;    // types may have changed since the last run
  }
  void pre_exchange() override { to_tags(); }
  void setup_pre_force() override { stepping = false; }
  void pre_force() override { stepping = true; }
  void end_of_step() override;
  void post_run() override;

  bool has_values() const override { return keeps(); }
  void grow(int) override;
  void copy(int, int) override;
  void set_new(int) override;
  int most_packed() const override;
  int pack(int, double *) override;
  int unpack(int, const double *) override;
  int look(const double *, int, std::string &) const override;
  void reorder(int, const int *) override;
  void send(int, const int *, const int *, double *) override;
  void receive(int, const int *, double *) override;
  void changed(bool moved, bool renamed) override;
  std::vector<double> state() override;
  bool restore(const double *, size_t) override;

  std::vector<std::string> outputs() const override { return {"fraction", "searches", "entries in rows"}; }
  double output(int) override;
  double bytes() const override;
  void *extract(const char *) override;

  // for pair sph/tm
  bool keeps() const override { return threshold > 0.0; }
  void show(const tm_records &) override;
  void renew(bool) override;
  tm_rows mechanical() override;
  tm_rows others() override { return other.loop_rows(); }
  tm_rows host_mechanical() override { return table.host_rows(); }
  int searched(tm_rates_args &) override;
  void kept_moments(const tm_rates_args &, unsigned) override;
  void kept_rates(const tm_rates_args &, unsigned) override;

 private:
  double threshold = -1.0;    // of plastic strain; 0: every step; negative: not in use
  double strain = -1.0;       // since the last search; negative: by default
  double approach = -1.0;     // of a distance, in reaches; negative: by default
  int rows = 0;               // room in a row; 0: by the kernel
  Backend *backend = nullptr;
  double reach = 0.0;         // the largest
  int room = 0;
  bool first_search = true;   // pairs of the first search of all have no artificial stress
  bool by_tag = false;        // entries of kept rows are places in names
  double sum_searched = 0.0, last_searched = 0.0;    // of this rank
  double time_now = 0.0, time_watched = 0.0, next_watch = 0.0;    // of steps taken; of the last and next watch
  bool came_near = false;     // particles, in this step
  bool looked = true;         // in the last step, who is searched
  bool stepping = false;      // not the set-up of a run

  RowTable table, other;      // mechanical neighbors; those for heat and in contact
  double wide = -1.0;         // keyword margin; negative: by default
  double margin = 0.0;        // the same, a distance; 0: rows are made in every step
  bool all_mechanical = true; // all types share one continuum
  struct Cells {
    LoopArray<int> cell, begin, index, marked;
    LoopArray<tm_real> column[4], look[2];
    tm_cells grid = {};
  } cells;
  LoopArray<unsigned char> meets;

  // with rows that are kept
  RowTable quiet;             // kept entries, and those at the border
  LoopArray<int> kept, which, which_border, which_near;
  LoopArray<ptrdiff_t> ul_first;
  LoopArray<short> weight;
  double weight_unit = 1.0;
  int kept_kernel = -1;       // that rows were kept with
  double kept_h = 0.0;
  LoopArray<tm_real> history, exported, pull_back, next_ul, correction;
  LoopArray<double> place, reaches;    // at the last search
  LoopArray<unsigned char> marks, was_ul, is_ul, dirty;
  LoopArray<int> tag_head, other_holder;    // see tm_tl_migration.h
  LoopArray<int> names;       // tags of what entries of kept rows mean, while particles get new places
  int n_names = 0;
  LoopArray<unsigned char> gone;    // of each name: the particle is nowhere near
  double dropped = 0.0;       // pairs of such in this run, on this rank
  bool any_dirty = false, rows_good = false;
  int active = 0, at_border = 0;

  int own() const;
  int all() const;
  void check_effects();
  bool own_reach() const;
  double spare() const;
  void cover_reach();
  void make_room(int);
  void move_to(Backend &);
  std::vector<std::vector<double>> take_rows();
  void put_rows(const std::vector<std::vector<double>> &);
  void check_kernel();
  tm_tl_rows kept_rows(bool on_host = false);
  tm_tl_store kept_store(bool on_host = false);
  tm_tl_args kept_args(const tm_records &);
  tm_interface_args border_args();
  bool blind() const;
  bool corrects() const;
  bool leaps(const tm_freeze_args &);
  tm_rates_args border_rates(const tm_rates_args &);
  void to_tags();
  int to_indices(bool same);
  void drop_gone(int pairs);
  bool same_places();
  int room_for_names(int);
  void tell_searched();
  void make_grid(double widest, const double *x, const double *reaches = nullptr);
  void sort_into_cells(const double *x);
  tm_search_args search_args(int segments, double within);
  void search(RowTable &, int segments, double within, int n, const int *of = nullptr);
  void search_others();
  void search_again(bool renumbered);
  void search_moved(bool all_of_them);
  void watch();
  double entries();
  void stop_on_long_row(int capacity, int longest);
};

}    // namespace SPHTM_NS

#endif
