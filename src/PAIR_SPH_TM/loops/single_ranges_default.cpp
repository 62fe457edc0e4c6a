// SPH-TM: the rate pass in single for the instruction set "default"; the flags are set in CMakeLists.txt.
#define SPHTM_ISA isa_default
#include "single_ranges.h"
