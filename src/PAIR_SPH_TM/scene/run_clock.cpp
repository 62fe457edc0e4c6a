#include "run_clock.h"

#include <algorithm>
#include <chrono>
#include <ctime>

namespace SPHTM_NS {

double RunClock::now()
{
  using namespace std::chrono;
  return duration<double>(steady_clock::now().time_since_epoch()).count();
}

double RunClock::processor_time()
{
  timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return t.tv_sec + 1e-9 * t.tv_nsec;
}

void RunClock::restart()
{
  parts.assign(PARTS, Sum());
  others.clear();
  taken.clear();
  marks = 0;
  steps = renewals = samples_taken = 0;
  sampling = renewing = false;
  began = now();
}

void RunClock::begin_step()
{
  if (!samples()) return;
  settle();
  sampling = samples_taken == 0 || steps % SAMPLE == 0;
  renewing = false;
  steps++;
}

void RunClock::lists_renewed()
{
  if (!samples() || renewing) return;
  renewing = sampling = true;
  renewals++;
}

void RunClock::settle()
{
  if (sampling && !renewing) samples_taken++;
  for (const Taken &t : taken) (renewing ? t.to->renewed : t.to->of_samples) += loops.seconds_between(t.begin, t.end);
  taken.clear();
  marks = 0;
  sampling = false;
}

double RunClock::begin_span(How how)
{
  if (how != BY_MARKS) return how == BY_HOST ? now() : 0.0;
  loops.mark(marks);
  return marks++;
}

void RunClock::end_span(Sum &sum, How how, double began)
{
  if (how == BY_MARKS) {
    loops.mark(marks);
    taken.push_back({&sum, (int) began, marks++});
  } else if (how == BY_HOST) {
    if (waits || !loops.shared()) loops.wait();
    sum.seconds += now() - began;
  }
}

double RunClock::of(const void *fix) const
{
  const auto it = others.find(fix);
  return it == others.end() ? 0.0 : total_of(it->second);
}

double RunClock::total_of(const Sum &s) const
{
  return s.seconds + s.renewed + s.of_samples * (steps - renewals) / std::max(samples_taken, 1l);
}

}    // namespace SPHTM_NS
