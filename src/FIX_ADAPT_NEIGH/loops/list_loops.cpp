#include "list_loops.h"

#include "rate_loops.h"

#include <cstring>

namespace SPHTM_NS {

const ListLoops &list_loops()
{
#if defined(SPHTM_X86_ISAS)
  if (!strcmp(rate_loop_isa(), "avx512")) return isa_avx512::list_loops;
  if (!strcmp(rate_loop_isa(), "avx2")) return isa_avx2::list_loops;
#endif
  return isa_default::list_loops;
}

}    // namespace SPHTM_NS
