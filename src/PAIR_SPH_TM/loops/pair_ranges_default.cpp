// SPH-TM: the loops for the instruction set "default"; the flags are set in CMakeLists.txt.
#define SPHTM_ISA isa_default
#define SPHTM_FEW_SETS
#include "pair_ranges.h"
