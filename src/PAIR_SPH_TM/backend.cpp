#include "backend.h"

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

void Backend::add(double *to, const double *from, size_t n)
{
  for (size_t k = 0; k < n; k++) to[k] += from[k];
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
