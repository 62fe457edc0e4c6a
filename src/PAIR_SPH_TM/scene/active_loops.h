/* SPH-TM: loops over some of the particles: those of a backend of the host, over runs of indices that follow one another.
   The loops themselves know nothing of it. */
#ifndef SPHTM_ACTIVE_LOOPS_H
#define SPHTM_ACTIVE_LOOPS_H

#include "backend.h"

#include <vector>

namespace SPHTM_NS {

class ActiveLoops : public Backend {
 public:
  explicit ActiveLoops(Backend &all) : loops(all) {}
  std::string name() const override { return loops.name(); }
  void wait() override { loops.wait(); }
  void zero(void *p, size_t bytes) override { loops.zero(p, bytes); }

  void set(const std::vector<int> &particles);    // in rising order
  void blocks(int n, const std::function<void(int, int)> &f) override;

 private:
  Backend &loops;
  struct Run {
    int begin, end;
  };
  std::vector<Run> runs;            // none of them is in two blocks
  std::vector<size_t> first_run;    // of each block, and the end of the last
};

}    // namespace SPHTM_NS

#endif
