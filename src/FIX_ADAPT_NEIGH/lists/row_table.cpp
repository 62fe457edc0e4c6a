#include "row_table.h"

namespace SPHTM_NS {

void RowTable::move_to(Backend &b)
{
  const ptrdiff_t wanted = b.shared() ? 1 : TM_ROW_SLICE_GPU;
  if (wanted != stride) {    // another order: rows that are there are given up
    capacity = particles = 0;
    stride = wanted;
  }
  index.move_to(b);
  first.move_to(b);
  for (auto &c : count) c.move_to(b);
}

bool RowTable::make_room(int n, int room)
{
  if (n <= particles && room == capacity) return true;
  const bool keep = room == capacity;
  if (!keep) {
    index.clear();
    for (auto &c : count) c.clear();
  }
  particles = n + n / 8 + 1;
  capacity = room;
  index.resize(slots() + TM_COLUMN_MOST);
  std::vector<ptrdiff_t> begin(particles);
  for (ptrdiff_t i = 0; i < particles; i++) begin[i] = i / stride * stride * capacity + i % stride;
  first.assign(begin.data(), begin.size());
  for (auto &c : count) c.resize(particles);
  return keep;
}

tm_rows RowTable::loop_rows()
{
  return {index.loop_read(),
          first.loop_read(),
          count[0].loop_read(),
          count[1].loop_read(),
          count[2].loop_read(),
          stride,
          nullptr,
          0};
}

tm_rows RowTable::host_rows()
{
  return {index.host_read(),
          first.host_read(),
          count[0].host_read(),
          count[1].host_read(),
          count[2].host_read(),
          stride,
          nullptr,
          0};
}

double RowTable::bytes() const
{
  double sum = index.bytes() + first.bytes();
  for (const auto &c : count) sum += c.bytes();
  return sum;
}

}    // namespace SPHTM_NS
