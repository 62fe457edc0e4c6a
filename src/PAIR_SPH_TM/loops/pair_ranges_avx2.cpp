// SPH-TM: the loops for the instruction set "avx2"; the flags are set in CMakeLists.txt.
#if defined(SPHTM_X86_ISAS)
#define SPHTM_ISA isa_avx2
#include "pair_ranges.h"
#endif
