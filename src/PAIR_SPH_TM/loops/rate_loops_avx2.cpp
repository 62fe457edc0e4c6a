// SPH-TM: the rate loops for the instruction set "avx2"; the flags are set in CMakeLists.txt.
#if defined(SPHTM_X86_ISAS)
#define SPHTM_ISA isa_avx2
#include "rate_loops_table.h"
#endif
