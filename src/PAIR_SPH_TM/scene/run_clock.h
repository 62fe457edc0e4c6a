/* SPH-TM: wall time of the parts of a step on this rank, for the table at the end of a run. */
#ifndef SPHTM_RUN_CLOCK_H
#define SPHTM_RUN_CLOCK_H

#include "backend.h"

#include <chrono>
#include <ctime>
#include <map>
#include <vector>

namespace SPHTM_NS {

class RunClock {
 public:
  enum Part {
    ROWS,
    PREDICT,
    COMMUNICATION,
    MOMENTS,
    RATES,
    HOURGLASS,
    THERMAL,
    BODIES,
    DRIFT,
    UPDATE,
    FRACTURE,
    PARTS
  };

  // adds the time until it goes out of scope
  class Span {
   public:
    Span(double &to, Backend *waits) : sum(to), loops(waits), begin(now()) {}
    Span(const Span &) = delete;
    Span &operator=(const Span &) = delete;
    ~Span()
    {
      if (loops) loops->wait();
      sum += now() - begin;
    }

   private:
    double &sum;
    Backend *loops;
    double begin;
  };

  static double now()
  {
    using namespace std::chrono;
    return duration<double>(steady_clock::now().time_since_epoch()).count();
  }

  // of this thread alone
  static double processor_time()
  {
    timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return t.tv_sec + 1e-9 * t.tv_nsec;
  }

  void wait_for(Backend *loops) { waits = loops; }    // at the end of each span, or nullptr
  bool is_waiting() const { return waits != nullptr; }

  void restart()
  {
    seconds.assign(PARTS, 0.0);
    others.clear();
    began = now();
  }
  Span timed(Part p) { return Span(seconds[p], waits); }
  Span timed(const void *fix) { return Span(others[fix], waits); }    // one of another fix
  double of(Part p) const { return seconds[p]; }
  double of(const void *fix) const
  {
    const auto it = others.find(fix);
    return it == others.end() ? 0.0 : it->second;
  }
  double total() const { return now() - began; }

 private:
  Backend *waits = nullptr;
  std::vector<double> seconds = std::vector<double>(PARTS, 0.0);
  std::map<const void *, double> others;
  double began = now();
};

}    // namespace SPHTM_NS

#endif
