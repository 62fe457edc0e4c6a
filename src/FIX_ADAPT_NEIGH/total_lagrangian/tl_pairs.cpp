#include "tl_pairs.h"

#include "atom.h"
#include "error.h"
#include "lammps.h"

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

void TlPairs::make_room(int n)
{
  const int room = candidates.room();
  if (room != table.capacity) number.clear();
  candidates.make_room(n);
  table.make_room(n, room);
  number.resize(table.particles);
  ul_first.resize(table.particles);
  weight.resize(table.slots() * TM_WEIGHTS);
  history_of.resize((size_t) table.particles * TM_TL_HISTORY);
}

// rows of particles, packed, where they must go to a table of another shape; then into it
std::vector<std::vector<double>> TlPairs::take_rows(const Backend &b)
{
  const int stride = b.shared() ? 1 : TM_ROW_SLICE_GPU, room = candidates.room();
  const bool same = room == table.capacity && stride == table.stride;
  std::vector<std::vector<double>> packed(same || !exist() ? 0 : std::min(parts.owned(), (int) number.size()));
  std::vector<int> entry(map.in_use() ? map.entries() : parts.owned_and_ghosts());
  std::iota(entry.begin(), entry.end(), 0);
  for (size_t i = 0; i < packed.size(); i++) {
    const tm_tl_store s = store(true);
    if (s.rows.tl[i] > room) candidates.stop_on_long_row(room, s.rows.tl[i]);
    packed[i].resize(tm_tl_packed(s.rows.tl[i]));
    tm_tl_pack((int) i, &s, entry.data(), packed[i].data());
  }
  return packed;
}

void TlPairs::put_rows(const std::vector<std::vector<double>> &packed)
{
  std::vector<int> entry(candidates.room());
  for (size_t i = 0; i < packed.size(); i++) {
    const tm_tl_store s = store(true);
    tm_tl_unpack((int) i, &s, packed[i].data(), 0, entry.data());
    int *row = s.rows.index + s.rows.first[i];
    for (int e = 0; e < s.rows.tl[i]; e++) row[e * s.rows.stride] = entry[e];
  }
}

void TlPairs::reshape(Backend &b)
{
  const std::vector<std::vector<double>> packed = take_rows(b);
  backend = &b;
  loops = &ListLoops::of(b);
  table.move_to(b);
  number.move_to(b);
  ul_first.move_to(b);
  weight.move_to(b);
  history_of.move_to(b);
  make_room(parts.host()->atom->nmax);
  put_rows(packed);
  unit = tm_tl_unit(parts.model().settings_in_use().kernel);
}

void TlPairs::check_kernel(double threshold)
{
  const Settings &set = parts.model().settings_in_use();
  const bool stored = exist() && stored_kernel >= 0;
  if (stored && (stored_kernel != set.kernel || std::fabs(stored_h - set.h) > 1e-9 * set.h))
    parts.host()->error->all(FLERR,
                             "Fix adapt/neigh threshold {}: gradients were stored with the {} kernel and the "
                             "smoothing length {:.6g}, pair_style sph/tm now has {} and {:.6g}; write the same, "
                             "or remove the fix and write it again: then all pairs are updated-Lagrangian at "
                             "first",
                             threshold, kernel_name(stored_kernel), stored_h, kernel_name(set.kernel), set.h);
  stored_kernel = set.kernel;
  stored_h = set.h;
}

void TlPairs::restore(int kernel, double h)
{
  stored_kernel = kernel;
  stored_h = h;
}

tm_tl_rows TlPairs::rows(bool on_host)
{
  const auto write = [on_host](auto &a) { return on_host ? a.host_write() : a.loop_write(); };
  tm_tl_rows r;
  r.index = write(table.index);
  r.tl = write(number);
  r.ul = write(table.count[0]);
  r.first = on_host ? table.first.host_read() : table.first.loop_read();
  r.ul_first = write(ul_first);
  r.stride = table.stride;
  r.capacity = table.capacity;
  r.unit = unit;
  r.weight = write(weight);
  return r;
}

tm_tl_store TlPairs::store(bool on_host)
{
  return {rows(on_host), on_host ? history_of.host_write() : history_of.loop_write()};
}

tm_rows TlPairs::mechanical()
{
  tm_rows r = table.loop_rows();
  r.mechanical = number.loop_read();
  return r;
}

// updated-Lagrangian pairs of total-Lagrangian particles
tm_rates_args TlPairs::interface_rows(const tm_rates_args &rates, const int *which)
{
  tm_rates_args a = rates;
  a.rows = table.loop_rows();
  a.rows.first = ul_first.loop_read();
  a.which = which;
  return a;
}

void TlPairs::forget()
{
  backend->zero(number.loop_write(), number.bytes());
  backend->zero(history_of.loop_write(), history_of.bytes());
}

/* ---------------------------------------------------------------------- values of particles */

void TlPairs::grow(int nmax)
{
  if (exist()) make_room(nmax);
}

void TlPairs::copy(int from, int to)
{
  if (!exist()) return;
  const tm_tl_store s = store(true);
  tm_tl_copy(&s, from, &s, to);
}

void TlPairs::set_new(int i)
{
  if (!exist()) return;
  number.host_write()[i] = 0;
  std::fill_n(history_of.host_write() + (size_t) i * TM_TL_HISTORY, (int) TM_TL_HISTORY, 0.0);
}

int TlPairs::most_packed() const { return tm_tl_packed(candidates.room() ? candidates.room() : table.capacity); }

int TlPairs::pack(int i, double *buf)
{
  if (!exist()) return 0;
  const tm_tl_store s = store(true);
  return tm_tl_pack(i, &s, map.in_use() ? map.host_tags() : parts.host()->atom->tag, buf);
}

int TlPairs::unpack(int i, const double *buf)
{
  if (!exist()) return 0;
  const tm_tl_store s = store(true);
  const int first = map.append((int) buf[0]);
  return tm_tl_unpack(i, &s, buf, first, map.host_write());
}

// the row of tm_tl_pack()
int TlPairs::check(const double *row, int n, std::string &why) const
{
  if (!exist()) return 0;
  const int most = table.capacity;
  if (n < tm_tl_packed(0) || !is_whole(row[0], 0, most) || n < tm_tl_packed((int) row[0])) {
    why = fmt::format("{} total-Lagrangian pairs in {} values, 0 to {} pairs expected", n ? row[0] : 0.0, n, most);
    return -1;
  }
  const double *value = row + 1, *end = row + tm_tl_packed((int) row[0]);
  for (int c = 0; c < TM_TL_HISTORY; c++, value++)
    if (!std::isfinite(*value)) why = fmt::format("{} in its history", *value);
  for (; why.empty() && value < end; value += 1 + TM_WEIGHTS) {
    if (!is_whole(*value, 1, MAXSMALLINT)) why = fmt::format("a total-Lagrangian neighbor {}", *value);
    for (int c = 1; c <= TM_WEIGHTS; c++)
      if (!is_whole(value[c], -32768, 32767)) why = fmt::format("a weight {} of a total-Lagrangian pair", value[c]);
  }
  return why.empty() ? tm_tl_packed((int) row[0]) : -1;
}

void TlPairs::reorder(int n, const int *order)
{
  if (!exist()) return;
  const tm_tl_store to = store();
  LoopArray<int> index(*backend), numbers(*backend);
  LoopArray<short> weights(*backend);
  LoopArray<tm_real> histories(*backend);
  const auto copied = [this](auto &copy, auto &of) {
    copy.resize(of.size());
    backend->copy(copy.loop_write(), of.loop_read(), of.bytes());
    return copy.loop_write();
  };
  tm_tl_store from = to;
  from.rows.index = copied(index, table.index);
  from.rows.tl = copied(numbers, number);
  from.rows.weight = copied(weights, weight);
  from.history = copied(histories, history_of);
  loops->reorder(*backend, n, {from, to, order}, 0u);
  backend->wait();
}

void TlPairs::send(int n, const int *sent, const int *filled_by, double *buf)
{
  if (exist()) loops->send(*backend, n, {store(), map.loop_write(), sent, filled_by, buf, most_packed(), 0}, 0u);
}

void TlPairs::receive(int n, const int *index, double *buf)
{
  if (!exist()) return;
  const int first = map.append(n * table.capacity);
  loops->receive(*backend, n, {store(), map.loop_write(), index, nullptr, buf, most_packed(), first}, 0u);
}

double TlPairs::bytes() const
{
  return table.bytes() + number.bytes() + ul_first.bytes() + weight.bytes() + history_of.bytes();
}

}    // namespace SPHTM_NS
