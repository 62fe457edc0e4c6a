/* SPH-TM: wall time of the parts of a step on this rank, for the table at the end of a run.

   Loops that run beside the host are timed where they run, by marks between them, in some steps: in every SAMPLE-th, and
   in those that renew the lists, which take much longer. Nothing is waited for. */
#ifndef SPHTM_RUN_CLOCK_H
#define SPHTM_RUN_CLOCK_H

#include "backend.h"

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

 private:
  struct Sum {
    double seconds = 0.0;                      // by the clock of the host
    double of_samples = 0.0, renewed = 0.0;    // by marks: in sampled steps, and in all that renewed the lists
  };
  enum How { BY_HOST, BY_MARKS, NOT };

 public:
  explicit RunClock(Backend &l) : loops(l) {}

  // adds the time until it goes out of scope
  class Span {
   public:
    Span(RunClock &c, Sum &to, How h) : clock(c), sum(to), how(h), began(c.begin_span(h)) {}
    Span(const Span &) = delete;
    Span &operator=(const Span &) = delete;
    ~Span() { clock.end_span(sum, how, began); }

   private:
    RunClock &clock;
    Sum &sum;
    How how;
    double began;    // time, or number of the mark
  };

  static double now();
  static double processor_time();    // of this thread alone

  void set_waits(bool w) { waits = w; }    // at the end of each span, which tells all apart and slows the run
  bool samples() const { return !waits && !loops.shared(); }

  void restart();
  void begin_step();
  void lists_renewed();    // in this step
  void settle();           // waits for the marks of the last step; the times are known then

  Span timed(Part p) { return Span(*this, parts[p], samples() ? (sampling ? BY_MARKS : NOT) : BY_HOST); }
  Span timed(const void *fix) { return Span(*this, others[fix], samples() ? (sampling ? BY_MARKS : NOT) : BY_HOST); }
  // what is done now and then, for which the loops are waited for in any case
  Span timed_rarely(Part p) { return Span(*this, parts[p], BY_HOST); }
  Span timed_rarely(const void *fix) { return Span(*this, others[fix], BY_HOST); }
  double of(Part p) const { return total_of(parts[p]); }
  double of(const void *fix) const;
  double total() const { return now() - began; }

 private:
  static constexpr int SAMPLE = 61;
  struct Taken {
    Sum *to;
    int begin, end;    // marks
  };
  Backend &loops;
  bool waits = false;
  std::vector<Sum> parts = std::vector<Sum>(PARTS);
  std::map<const void *, Sum> others;
  double began = now();
  std::vector<Taken> taken;    // in this step
  int marks = 0;
  long steps = 0, renewals = 0, samples_taken = 0;
  bool sampling = false, renewing = false;

  double begin_span(How);
  void end_span(Sum &, How, double began);
  double total_of(const Sum &) const;
};

}    // namespace SPHTM_NS

#endif
