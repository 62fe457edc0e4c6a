#include "list_loops.h"

#include "instruction_set.h"

namespace SPHTM_NS {

const ListLoops &list_loops()
{
  return SPHTM_FOR_INSTRUCTION_SET(list_loops);
}

}    // namespace SPHTM_NS
