/* SPH-TM: the search of neighbors for particles begin to end - 1; included once per instruction set with SPHTM_ISA set
   to its namespace. */
#include "search_loops.h"

namespace {

using namespace SPHTM_NS;

int search(int begin, int end, const tm_search_args *args, unsigned)
{
  int longest = 0;
  for (int k = begin; k < end; k++) {
    const int n = tm_search(args->which ? args->which[k] : k, args);
    longest = n > longest ? n : longest;
  }
  return longest;
}

SEARCH_LOOPS(SPHTM_RANGE_LOOP)

}    // namespace

namespace SPHTM_NS {
namespace SPHTM_ISA {

extern const SearchRanges search_ranges;
const SearchRanges search_ranges = {SEARCH_LOOPS(SPHTM_RANGE_NAME)};

}    // namespace SPHTM_ISA
}    // namespace SPHTM_NS
