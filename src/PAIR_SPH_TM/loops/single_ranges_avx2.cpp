// SPH-TM: the rate pass in single for the instruction set "avx2"; the flags are set in CMakeLists.txt.
#if defined(SPHTM_X86_ISAS)
#define SPHTM_ISA isa_avx2
#include "single_ranges.h"
#endif
