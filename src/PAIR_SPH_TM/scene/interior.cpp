#include "interior.h"

namespace SPHTM_NS {

Interior::Interior(Backend &where) :
    loops(where), interior(where), edge(where), of_interior(where), of_edge(where), marks(where)
{
  for (auto *a : {&of_interior, &of_edge}) a->call("rows of neighbors");
}

void Interior::sort(const tm_rows &rows, int owned)
{
  const size_t blocks = (size_t) owned / loops.block() + 1;
  marks.make_room(true, blocks);
  tm_boundary_args a = {rows, owned, marks.loop_write(), 0};
  loops.zero(a.marks, blocks);
  PairLoops::of(loops).boundary_mark(loops, owned, a, 0);
  list(a, interior, of_interior);
  a.wanted = 1;
  list(a, edge, of_edge);
  sorted = owned;
}

void Interior::list(const tm_boundary_args &a, ActiveLoops &some, LoopArray<int> &particles)
{
  particles.make_room(true, (size_t) a.owned + 1);
  const int n = PairLoops::of(loops).boundary_list(loops, a.owned, a, particles.loop_write());
  some.set(particles.loop_read(), n, a.owned);
}

}    // namespace SPHTM_NS
