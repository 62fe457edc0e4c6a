// SPH-TM: the loops over rows for the instruction set "default"; the flags are set in CMakeLists.txt.
#define SPHTM_ISA isa_default
#include "list_loops_table.h"
