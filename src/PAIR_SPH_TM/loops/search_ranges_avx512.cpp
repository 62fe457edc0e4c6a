// SPH-TM: the loops for the instruction set "avx512"; the flags are set in CMakeLists.txt.
#if defined(SPHTM_X86_ISAS)
#define SPHTM_ISA isa_avx512
#include "search_ranges.h"
#endif
