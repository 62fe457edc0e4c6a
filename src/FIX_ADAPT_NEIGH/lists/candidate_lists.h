/* SPH-TM: rows of neighbors within the support radius and a skin, from a search in cells. A row is searched
   again when a particle near it has moved by half the skin (tm_candidates.h); without a skin in every step. */
#ifndef SPHTM_CANDIDATE_LISTS_H
#define SPHTM_CANDIDATE_LISTS_H

#include "cell_search.h"
#include "list_loops.h"
#include "tag_map.h"

namespace SPHTM_NS {

class CandidateLists {
 public:
  explicit CandidateLists(AdaptParts &all) : parts(all), cells(all) {}
  void set_skin(double over_radius) { skin_over_radius = over_radius; }
  void set_rows(int n) { given_room = n; }
  // total_lagrangian: rows are also those of total-Lagrangian pairs, which fixes their room
  void init(bool total_lagrangian);
  void move_to(Backend &);
  int room() const { return room_of_row; }
  void set_room(int n) { room_of_row = n; }    // of a restart file
  void make_room(int n) { good = table.make_room(n, room_of_row) && good; }
  bool exist() const { return table.capacity > 0; }
  bool fits(int n) const { return table.particles >= n; }    // there are rows of so many particles
  void forget() { good = false; }                            // all are searched again
  double radius() const { return widest; }
  bool has_skin() const { return skin > 0.0; }
  bool may_remain() const { return skin > 0.0 || own_radii(); }    // rows can outlive a step

  // particles have other indices: room, types, reach; rows of heat-only and contact pairs
  void renumbered();
  void search_all();    // rows of this step, without a skin
  // rows that are out of date, or all; true: there were some, and changed() marks them
  bool search_moved(bool all_rows);
  bool are_good() const { return good; }    // but for particles that have moved
  void none(int n) { backend->zero(table.count[0].loop_write(), n * sizeof(int)); }    // rows of n particles are empty
  LoopArray<unsigned char> &changed() { return dirty; }    // rows since they were last looked at

  tm_rows rows() { return table.loop_rows(); }
  tm_rows host_rows() { return table.host_rows(); }
  tm_rows other_rows() { return other.loop_rows(); }
  double entries();    // in all rows of this rank
  double bytes() const;
  [[noreturn]] void stop_on_long_row(int capacity, int longest) const;

 private:
  AdaptParts &parts;
  Backend *backend = nullptr;
  const ListLoops *loops = nullptr;
  CellSearch cells;
  RowTable table, other;    // mechanical neighbors; heat-only and contact pairs
  int given_room = 0;       // keyword rows; 0: by the kernel
  int room_of_row = 0, room_of_other = 0;
  bool fixed_room = false, total_lagrangian = false;
  double skin_over_radius = -1.0;     // keyword margin; negative: by default
  double widest = 0.0, skin = 0.0;    // the largest search radius; skin: a distance
  bool good = false;                  // rows are valid but for particles that have moved
  LoopArray<double> place, radii;     // at the last search of a row
  LoopArray<unsigned char> marks, dirty;
  LoopArray<int> which;

  bool own_radii() const;
  double spare() const;
  void cover_radius();
  void search(RowTable &, int &room, int segments, double radius, int n, const int *which = nullptr);
};

}    // namespace SPHTM_NS

#endif
