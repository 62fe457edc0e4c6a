/* SPH-TM: loops over some of the particles. On the host those of another backend, over runs of indices that follow one
   another: the loops themselves know nothing of it. Elsewhere a loop gets the list. */
#ifndef SPHTM_ACTIVE_LOOPS_H
#define SPHTM_ACTIVE_LOOPS_H

#include "backend.h"

#include <vector>

namespace SPHTM_NS {

class ActiveLoops : public Backend {
 public:
  explicit ActiveLoops(Backend &all) : loops(all) {}
  std::string name() const override { return loops.name(); }
  bool shared() const override { return loops.shared(); }
  void wait() override { loops.wait(); }
  void zero(void *p, size_t bytes) override { loops.zero(p, bytes); }
  void copy_to_result(void *result, const void *of_loops, size_t bytes) override
  {
    loops.copy_to_result(result, of_loops, bytes);
  }

  void set(const int *particles, int n, int of);    // in rising order, of so many, where the loops run; they stay there
  const int *some(int &n) const override;
  void blocks(int n, const std::function<void(int, int)> &f) override;

 private:
  Backend &loops;
  const int *list = nullptr;
  int listed = 0, all = 0;
  mutable int asked = -1, below = 0;    // the last number that was less than all, and those listed below it
  struct Run {
    int begin, end;
  };
  std::vector<Run> runs;            // none of them is in two blocks
  std::vector<size_t> first_run;    // of each block, and the end of the last
};

}    // namespace SPHTM_NS

#endif
