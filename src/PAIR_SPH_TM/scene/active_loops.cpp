#include "active_loops.h"

#include <algorithm>

namespace SPHTM_NS {

void ActiveLoops::set(const int *particles, int n, int of)
{
  list = particles;
  listed = n;
  all = of;
  asked = -1;
  if (!shared()) return;
  runs.clear();
  first_run.assign(1, 0);
  for (int k = 0; k < n; k++) {
    const int i = particles[k];
    while ((int) first_run.size() <= i / LOOP_BLOCK) first_run.push_back(runs.size());
    if (i % LOOP_BLOCK != 0 && !runs.empty() && runs.back().end == i) runs.back().end++;
    else runs.push_back({i, i + 1});
  }
  first_run.push_back(runs.size());
}

const int *ActiveLoops::some(int &n) const
{
  if (n < all && n != asked) {
    std::vector<int> copy(shared() ? 0 : listed);
    if (!copy.empty()) loops.to_host(copy.data(), list, listed * sizeof(int));
    const int *here = shared() ? list : copy.data();
    below = std::lower_bound(here, here + listed, n) - here;
    asked = n;
  }
  n = n < all ? below : listed;
  return list;
}

void ActiveLoops::blocks(int n, const std::function<void(int, int)> &f)
{
  loops.blocks(n, [&](int begin, int) {
    const size_t block = begin / LOOP_BLOCK;
    for (size_t k = block + 1 < first_run.size() ? first_run[block] : runs.size();
         k < runs.size() && k < first_run[block + 1] && runs[k].begin < n; k++)
      f(runs[k].begin, std::min(n, runs[k].end));
  });
}

}    // namespace SPHTM_NS
