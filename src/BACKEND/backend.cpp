#include "backend.h"

#include "list_loops.h"
#include "rate_loops.h"
#include "tm_thermal.h"

#include <algorithm>
#include <cstring>
#include <new>

namespace SPHTM_NS {

Backend &Backend::host()
{
  static Backend backend;
  return backend;
}

std::string Backend::name() const { return rate_loop_isa(); }

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

void Backend::add(double *to, const double *from, size_t n)
{
  for (size_t k = 0; k < n; k++) to[k] += from[k];
}

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

static void add_to(double *sum, const double *value) { *sum += *value; }

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

/* ---------------------------------------------------------------------- one step */

void Backend::drift(int n, const tm_drift_args &a, unsigned effects, int *lost)
{
  *lost = sum_particles(
      *this, n, n, [&](int i) { return tm_drift(i, &a, effects) ? i : n; },
      [](int *first, const int *i) { *first = std::min(*first, *i); });
}

void Backend::predict(int n, const tm_predict_args &a, unsigned effects)
{
  const predict_loop_t loop = predict_loop();
  blocks(n, [&](int begin, int end) { loop(begin, end, &a, effects); });
}

void Backend::moments(int n, const tm_rates_args &a, unsigned effects)
{
  const rate_loop_t loop = moment_loop(effects);
  blocks(n, [&](int begin, int end) { loop(begin, end, &a); });
}

void Backend::hourglass(int n, const tm_rates_args &a, unsigned effects)
{
  const rate_loop_t loop = hourglass_loop(effects);
  blocks(n, [&](int begin, int end) { loop(begin, end, &a); });
}

void Backend::round(int n, const tm_single_args &a, unsigned effects)
{
  blocks(n, [&](int begin, int end) {
    for (int i = begin; i < end; i++) tm_single(i, &a, effects);
  });
}

void Backend::rates(int n, const tm_rates_args &a, unsigned effects)
{
  const rate_loop_t loop = rate_loop(effects);
  blocks(n, [&](int begin, int end) { loop(begin, end, &a); });
}

void Backend::thermal(int n, const tm_rates_args &a, unsigned effects)
{
  blocks(n, [&](int begin, int end) {
    for (int i = begin; i < end; i++)
      if (a.rows.thermal[i]) tm_thermal(i, &a, effects);
  });
}

tm_body_contact_result Backend::body_contact(int n, const tm_rates_args &a,
                                             const tm_body_contact_args &b, unsigned effects)
{
  return sum_particles(
      *this, n, tm_body_contact_nothing(),
      [&](int i) {
        return a.rows.contact[i] ? tm_body_contact(i, &a, &b, effects) : tm_body_contact_nothing();
      },
      tm_body_contact_sum);
}

tm_update_result Backend::update(int n, const tm_update_args &a, unsigned effects)
{
  const update_loop_t loop = update_loop();
  const bool ledger = effects & TM_FX_LEDGER;
  return sum_blocks(
      n, tm_update_nothing(), [&](int begin, int end) { return loop(begin, end, &a, effects); },
      [=](tm_update_result *sum, const tm_update_result *r) { tm_update_sum(sum, r, ledger); });
}

tm_exchange_result Backend::exchange(int n, const tm_exchange_args &a, bool area_only)
{
  return sum_particles(
      *this, n, tm_exchange_nothing(), [&](int i) { return tm_exchange_of_group(i, &a, area_only); },
      tm_exchange_sum);
}

double Backend::hold(int n, const tm_hold_args &a)
{
  return sum_particles(*this, n, 0.0, [&](int i) { return tm_hold(i, &a); }, add_to);
}

tm_drive_result Backend::drive(int n, const tm_drive_args &a)
{
  return sum_particles(
      *this, n, tm_drive_nothing(), [&](int i) { return tm_drive(i, &a); }, tm_drive_sum);
}

/* ---------------------------------------------------------------------- set-up and output */

void Backend::initial_of_new(int n, const tm_initial_args &a)
{
  blocks(n, [&](int begin, int end) {
    for (int i = begin; i < end; i++) tm_initial_of_new(i, &a);
  });
}

tm_update_result Backend::initial_limits(int n, const tm_update_args &a, unsigned effects, bool seed)
{
  return sum_particles(
      *this, n, tm_update_nothing(), [&](int i) { return tm_initial_limits(i, &a, effects, seed); },
      [](tm_update_result *sum, const tm_update_result *r) { tm_update_sum(sum, r, 0); });
}

double Backend::kinetic_energy(int n, const tm_state &s)
{
  return sum_particles(*this, n, 0.0, [&](int i) { return tm_kinetic_energy(i, &s); }, add_to);
}

tm_tally_result Backend::tally(int n, const tm_tally_args &a, unsigned effects)
{
  return sum_particles(
      *this, n, tm_tally_result{}, [&](int i) { return tm_tally(i, &a, effects); }, tm_tally_sum);
}

tm_size_range Backend::smoothing(int n, const tm_smoothing_args &a, unsigned effects)
{
  return sum_particles(
      *this, n, tm_size_nothing(), [&](int i) { return tm_smoothing(i, &a, effects); }, tm_size_sum);
}

tm_size_range Backend::size_range(int n, const tm_state &s)
{
  return sum_particles(*this, n, tm_size_nothing(), [&](int i) { return tm_size_of(i, &s); }, tm_size_sum);
}

double Backend::near_count(int n, const tm_near_args &a)
{
  return sum_particles(*this, n, 0.0, [&](int i) { return tm_near_count(i, &a); }, add_to);
}

tm_nearest Backend::nearest(int n, const tm_near_args &a)
{
  return sum_particles(
      *this, n, tm_nearest_nothing(), [&](int i) { return tm_nearest_neighbor(i, &a); },
      tm_nearest_sum);
}

}    // namespace SPHTM_NS
