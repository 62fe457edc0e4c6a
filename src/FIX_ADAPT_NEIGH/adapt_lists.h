/* SPH-TM: adaptive neighbor lists, a part of fix adapt/neigh: rows of neighbors from a cell search of its
   own, renewed where the deformation asks for it. F14. See doc/fix_adapt_neigh.rst. */
#ifndef SPHTM_ADAPT_LISTS_H
#define SPHTM_ADAPT_LISTS_H

#include "adapt_part.h"
#include "loop_array.h"
#include "row_source.h"

namespace SPHTM_NS {

// rows of static length: entry k of particle i is index[first[i] + k stride]
struct RowTable {
  LoopArray<int> index, count[TM_SEGMENTS];
  LoopArray<ptrdiff_t> first;
  int capacity = 0, particles = 0;
  ptrdiff_t stride = 1;

  void live_in(Backend &);
  void make_room(int n, int room);
  tm_rows loop_rows();
  tm_rows host_rows();
  double bytes() const;
};

class AdaptLists : public AdaptPart, public RowSource {
 public:
  using AdaptPart::AdaptPart;
  int keyword(int, char **) override;
  std::vector<std::string> keywords() const override { return {"threshold", "rows"}; }
  bool in_use() const override { return threshold >= 0.0; }
  void init() override;
  void *extract(const char *) override;
  double bytes() const override;

  void renew(bool) override;
  tm_rows mechanical() override { return mechanicals.loop_rows(); }
  tm_rows others() override { return other.loop_rows(); }
  tm_rows host_others() override { return other.host_rows(); }

 private:
  double threshold = -1.0;    // of plastic strain; negative: not in use
  int rows = 0;               // room in a row; 0: by the kernel
  Backend *backend = nullptr;
  double reach = 0.0;
  int room = 0;

  RowTable mechanicals, other;    // the latter: neighbors for heat and in contact
  bool all_mechanical = true;     // all types share one continuum
  struct Cells {
    LoopArray<int> cell, begin, index;
    LoopArray<tm_real> column[4];
    tm_cells grid = {};
  } cells;
  LoopArray<unsigned char> meets;

  void make_grid(double width);
  void sort_into_cells();
  void search(RowTable &, int segments, double within);
  void search_others();
  void stop_on_long_row(const RowTable &, int longest);
};

}    // namespace SPHTM_NS

#endif
