/* SPH-TM: the instruction set of the host's loops. Hot loops are compiled once for each (files *_default.cpp, *_avx2.cpp,
   *_avx512.cpp); in use is the best that the processor has. */
#ifndef SPHTM_INSTRUCTION_SET_H
#define SPHTM_INSTRUCTION_SET_H

namespace SPHTM_NS {

enum InstructionSet { ISA_DEFAULT, ISA_AVX2, ISA_AVX512 };

// SPHTM_ISA=default|avx2|avx512 in the environment lowers the choice, for tests and comparisons
InstructionSet instruction_set();
const char *instruction_set_name();

}    // namespace SPHTM_NS

// the object of that name in the namespace of the instruction set in use
#if defined(SPHTM_X86_ISAS)
#define SPHTM_FOR_INSTRUCTION_SET(object)                                   \
  (SPHTM_NS::instruction_set() == SPHTM_NS::ISA_AVX512 ? isa_avx512::object \
   : SPHTM_NS::instruction_set() == SPHTM_NS::ISA_AVX2 ? isa_avx2::object   \
                                                       : isa_default::object)
#else
#define SPHTM_FOR_INSTRUCTION_SET(object) (isa_default::object)
#endif

#endif
