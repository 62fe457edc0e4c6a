#include "instruction_set.h"

#include <cstdlib>
#include <cstring>

namespace SPHTM_NS {

static InstructionSet best_of_processor()
{
#if defined(SPHTM_X86_ISAS)
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))
    return ISA_AVX512;
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return ISA_AVX2;
#endif
  return ISA_DEFAULT;
}

InstructionSet instruction_set()
{
  static const InstructionSet chosen = [] {
    const InstructionSet best = best_of_processor();
    const char *want = getenv("SPHTM_ISA");
    if (want && !strcmp(want, "default")) return ISA_DEFAULT;
    if (want && !strcmp(want, "avx2") && best >= ISA_AVX2) return ISA_AVX2;
    return best;
  }();
  return chosen;
}

const char *instruction_set_name()
{
  static const char *const names[] = {"default", "avx2", "avx512"};
  return names[instruction_set()];
}

}    // namespace SPHTM_NS
