// Loops over some of the particles: which of the first n they run over, on the host and where loops have a memory of
// their own.
// with PAIR_SPH_TM/scene/active_loops.cpp BACKEND/backend.cpp BACKEND/instruction_set.cpp
#include "active_loops.h"
#include "ut.h"

#include <cstring>

using namespace SPHTM_NS;

namespace {

// memory of its own, in words
class Elsewhere : public Backend {
 public:
  int copies = 0;
  bool shared() const override { return false; }
  void to_host(void *here, const void *there, size_t bytes) override
  {
    memcpy(here, there, bytes);
    copies++;
  }
};

const std::vector<int> AWAKE = {3, 4, 5, 900, 901, 2000};
constexpr int ALL = 2500;

int number(const ActiveLoops &loops, int n)
{
  loops.some(n);
  return n;
}

}    // namespace

static void list_ends_where_the_particles_asked_for_end()
{
  Elsewhere there;
  ActiveLoops loops(there);
  loops.set(AWAKE.data(), (int) AWAKE.size(), ALL);
  UT_TRUE(number(loops, ALL) == 6);
  UT_TRUE(there.copies == 0);    // in every loop of a step
  UT_TRUE(number(loops, 901) == 4);
  UT_TRUE(number(loops, 901) == 4);
  UT_TRUE(there.copies == 1);
  UT_TRUE(number(loops, 3) == 0);
  UT_TRUE(number(loops, ALL) == 6);
  loops.set(AWAKE.data(), 2, ALL);
  UT_TRUE(number(loops, 901) == 2);
}

static void host_runs_over_the_same()
{
  ActiveLoops loops(Backend::host());
  loops.set(AWAKE.data(), (int) AWAKE.size(), ALL);
  for (int n : {ALL, 901, 3}) {
    std::vector<int> seen;
    loops.blocks(n, [&](int begin, int end) {
      for (int i = begin; i < end; i++) seen.push_back(i);
    });
    std::vector<int> below;
    for (int i : AWAKE)
      if (i < n) below.push_back(i);
    UT_TRUE(seen == below);
    UT_TRUE(number(loops, n) == (int) below.size());
  }
}

int main()
{
  list_ends_where_the_particles_asked_for_end();
  host_runs_over_the_same();
  return ut_summary();
}
