/* SPH-TM: the tag map of rows that remain while particles are renumbered or migrate. See tm_tag_map.h. */
#ifndef SPHTM_TAG_MAP_H
#define SPHTM_TAG_MAP_H

#include "list_loops.h"
#include "loop_array.h"

namespace SPHTM_NS {

class TagMap {
 public:
  void move_to(Backend &);
  bool in_use() const { return on; }    // entries of rows are indices into the map
  int entries() const { return n; }
  // particles are about to get other indices: entries are those of now, owned and ghost
  void begin(const int *loop_tags, int owned, int owned_and_ghosts);
  void end() { on = false; }
  int append(int entries);    // room for so many more; the index of the first
  // the indices are those of before, of particles without images that were owned before: ghosts of before have no rows
  bool same_indices(const int *loop_tags, int owned) const;
  const int *host_tags() { return tag.host_read(); }
  int *host_write() { return tag.host_write(); }
  int *loop_write() { return tag.loop_write(); }
  // where each tag is now, into the arguments; finds_gone: entries whose particle is nowhere are to be marked
  void locate(tm_tag_map_args &, int owned_and_ghosts, bool finds_gone);
  std::vector<int> gone_tags();    // of marked entries
  double bytes() const;

 private:
  Backend *backend = nullptr;
  const ListLoops *loops = nullptr;
  mutable LoopArray<int> tag;    // of each entry
  LoopArray<int> first, next;    // as in tm_tag_map_args
  LoopArray<unsigned char> gone;
  int n = 0, owned_before = 0;
  bool on = false;
};

}    // namespace SPHTM_NS

#endif
