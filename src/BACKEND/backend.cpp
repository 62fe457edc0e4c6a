#include "backend.h"

#include "list_loops.h"
#include "instruction_set.h"

#include <algorithm>
#include <cstring>
#include <new>

namespace SPHTM_NS {

Backend &Backend::host()
{
  static Backend backend;
  return backend;
}

std::string Backend::name() const { return instruction_set_name(); }

void Backend::copy(void *to, const void *from, size_t bytes)
{
  if (bytes) memcpy(to, from, bytes);    // pointers to nothing may be null
}

void Backend::zero(void *p, size_t bytes)
{
  if (bytes) memset(p, 0, bytes);
}

void Backend::fill(unsigned char *p, unsigned char value, size_t n)
{
  if (n) memset(p, value, n);
}

bool Backend::equal(int n, const int *a, const int *b) { return std::equal(a, a + n, b); }

int Backend::largest(int n, const int *v)
{
  int most = 0;
  for (int i = 0; i < n; i++) most = std::max(most, v[i]);
  return most;
}

void Backend::hold_tags(int n, const tm_tag_map_args &a)
{
  for (int j = 0; j < n; j++) {
    a.next[j] = a.first[a.tag[j]];
    a.first[a.tag[j]] = j + 1;
  }
}

void Backend::searched(int n, const tm_real *history, tm_real *next_ul)
{
  for (int i = 0; i < n; i++) next_ul[i] = tm_is_ul(history + (ptrdiff_t) i * TM_TL_HISTORY);
}

int Backend::places(int n, const tm_tag_map_args &a)
{
  int lost = 0;
  for (int i = 0; i < n; i++) lost += tm_tag_map_resolve(i, &a);
  return lost;
}

void Backend::reorder(int n, const tm_tl_store &from, const int *order, const tm_tl_store &to)
{
  for (int i = 0; i < n; i++) tm_tl_copy(&from, order[i], &to, i);
}

void Backend::kept_send(int n, const tm_tl_migration_args &a)
{
  for (int k = 0; k < n; k++) tm_tl_send(k, &a);
}

void Backend::kept_receive(int n, const tm_tl_migration_args &a)
{
  for (int k = 0; k < n; k++) tm_tl_receive(k, &a);
}

void Backend::blocks(int n, const std::function<void(int, int)> &f)
{
  for (int begin = 0; begin < n; begin += LOOP_BLOCK) f(begin, std::min(n, begin + LOOP_BLOCK));
}

// the sum of one(i) over particles
template <class RESULT, class ONE, class JOIN>
static RESULT sum_particles(Backend &b, int n, const RESULT &nothing, ONE one, JOIN join)
{
  return b.sum_blocks(
      n, nothing,
      [&](int begin, int end) {
        RESULT sum = nothing;
        for (int i = begin; i < end; i++) {
          const RESULT r = one(i);
          join(&sum, &r);
        }
        return sum;
      },
      join);
}

void *Backend::allocate_result(size_t bytes) { return ::operator new(bytes); }
void Backend::release_result(void *p) { ::operator delete(p); }

/* ---------------------------------------------------------------------- search */

tm_bounds Backend::bounds(int n, const double *x)
{
  return sum_particles(
      *this, n, tm_bounds_nothing(), [&](int i) { return tm_bounds_of(x + 3 * (size_t) i); }, tm_bounds_sum);
}

void Backend::bin(const tm_cells &c)
{
  const int cells = tm_cells_number(&c);
  std::fill_n(c.begin, cells + 1, 0);
  blocks(c.n, [&](int begin, int end) {
    for (int i = begin; i < end; i++) c.cell[i] = tm_cells_of(&c, c.x + 3 * (size_t) i);
  });
  // begin[k + 1] walks from the start of cell k to its end
  for (int i = 0; i < c.n; i++)
    if (c.cell[i] + 2 <= cells) c.begin[c.cell[i] + 2]++;
  for (int k = 2; k <= cells; k++) c.begin[k] += c.begin[k - 1];
  for (int i = 0; i < c.n; i++) tm_cells_put(&c, i, c.begin[c.cell[i] + 1]++);
  if (!c.reach) return;
  const auto of_cells = [&](tm_real *to, auto value) {
    blocks(cells, [&](int begin, int end) {
      for (int k = begin; k < end; k++) to[k] = value(k);
    });
  };
  of_cells(c.look[1], [&](int k) { return tm_cells_reach(&c, k); });
  for (int axis = 0; axis < 3; axis++)
    of_cells(c.look[axis % 2], [&](int k) { return tm_cells_look(&c, k, axis, c.look[1 - axis % 2]); });
}

int Backend::search(int n, const tm_search_args &a)
{
  const auto loop = list_loops().search;
  return sum_blocks(
      n, 0, [&](int begin, int end) { return loop(begin, end, &a); },
      [](int *longest, const int *m) { *longest = std::max(*longest, *m); });
}

int Backend::mark(const tm_cells &c, const unsigned char *marks)
{
  int sum = 0;
  for (int k = 0; k < c.n; k++) {
    c.marked[k] = sum;
    sum += marks[c.index[k]];
  }
  return c.marked[c.n] = sum;
}

static void add_count(int *sum, const int *n) { *sum += *n; }

int Backend::moved(int n, const tm_moved_args &a)
{
  return sum_particles(*this, n, 0, [&](int i) { return tm_moved(i, &a); }, add_count);
}

int Backend::near_moved(int n, const tm_near_moved_args &a, int *which)
{
  int m = 0;
  for (int i = 0; i < n; i++)
    if (tm_near_moved(i, &a)) which[m++] = i;
  return m;
}

int Backend::of_kind(int n, const tm_kind_args &a, int *which)
{
  int m = 0;
  for (int i = 0; i < n; i++)
    if (tm_is_of_kind(i, &a)) which[m++] = i;
  return m;
}

int Backend::border_change(int n, const tm_interface_args &a)
{
  return sum_particles(*this, n, 0, [&](int i) { return tm_interface_switch(i, &a); }, add_count);
}

void Backend::border_touch(int n, const tm_interface_args &a)
{
  for (int i = 0; i < n; i++) tm_interface_mark(i, &a);
}

void Backend::border(int n, const tm_interface_args &a)
{
  blocks(n, [&](int begin, int end) {
    for (int i = begin; i < end; i++) tm_interface_row(i, &a);
  });
}

void Backend::kept_moments(int n, const tm_tl_correction_args &a, unsigned effects)
{
  const auto loop = list_loops().moments;
  blocks(n, [&](int begin, int end) { loop(begin, end, &a, effects); });
}

void Backend::kept_show(int n, const tm_tl_args &a, tm_real *shown)
{
  const auto loop = list_loops().show;
  blocks(n, [&](int begin, int end) { loop(begin, end, &a, shown); });
}

void Backend::kept_rates(int n, const tm_tl_args &a, unsigned effects)
{
  const auto loop = list_loops().kept[kept_loop_index(effects)];
  blocks(n, [&](int begin, int end) { loop(begin, end, &a); });
}

int Backend::settle_leaps(int n, const tm_freeze_args &a)
{
  return sum_particles(*this, n, 0, [&](int i) { return tm_freeze_is_urgent(i, &a); }, add_count);
}

void Backend::settle_tell(int n, const tm_freeze_args &a, unsigned effects)
{
  blocks(n, [&](int begin, int end) {
    for (int i = begin; i < end; i++) tm_freeze_decide(i, &a, effects);
  });
}

void Backend::settle(int n, const tm_freeze_args &a, unsigned effects)
{
  const auto loop = list_loops().settle;
  blocks(n, [&](int begin, int end) { loop(begin, end, &a, effects); });
}

int Backend::watch(int n, const tm_proximity_args &a)
{
  const auto loop = list_loops().watch;
  return sum_blocks(n, 0, [&](int begin, int end) { return loop(begin, end, &a); }, add_count);
}

tm_size_range Backend::smoothing(int n, const tm_smoothing_args &a, unsigned effects)
{
  return sum_particles(
      *this, n, tm_size_nothing(), [&](int i) { return tm_smoothing(i, &a, effects); }, tm_size_sum);
}

}    // namespace SPHTM_NS
