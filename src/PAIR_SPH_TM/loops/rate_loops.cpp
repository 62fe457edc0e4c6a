#include "rate_loops.h"

#include <cstdlib>
#include <cstring>

namespace SPHTM_NS {

namespace {
enum Isa { ISA_DEFAULT, ISA_AVX2, ISA_AVX512 };

Isa detect()
{
#if defined(SPHTM_X86_ISAS)
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl"))
    return ISA_AVX512;
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return ISA_AVX2;
#endif
  return ISA_DEFAULT;
}

// SPHTM_ISA=default|avx2|avx512 lowers the choice, for tests and comparisons
Isa chosen()
{
  static const Isa isa = [] {
    const Isa best = detect();
    const char *want = getenv("SPHTM_ISA");
    if (want && !strcmp(want, "default")) return ISA_DEFAULT;
    if (want && !strcmp(want, "avx2") && best >= ISA_AVX2) return ISA_AVX2;
    return best;
  }();
  return isa;
}
}    // namespace

const char *rate_loop_isa()
{
  static const char *const names[] = {"default", "avx2", "avx512"};
  return names[chosen()];
}

static const ParticleLoops &loops()
{
#if defined(SPHTM_X86_ISAS)
  if (chosen() == ISA_AVX512) return isa_avx512::loops;
  if (chosen() == ISA_AVX2) return isa_avx2::loops;
#endif
  return isa_default::loops;
}

static const SingleLoops &single_loops()
{
#if defined(SPHTM_X86_ISAS)
  if (chosen() == ISA_AVX512) return isa_avx512::single_loops;
  if (chosen() == ISA_AVX2) return isa_avx2::single_loops;
#endif
  return isa_default::single_loops;
}

rate_loop_t rate_loop(unsigned effects)
{
  if (effects & TM_FX_MIXED) return single_loops().rates[few_rate_loop_index(effects)];
  return loops().rates[rate_loop_index(effects)];
}
rate_loop_t moment_loop(unsigned effects)
{
  return loops().moments[2 * tm_fx_kernel(effects) + ((effects & TM_FX_3D) ? 1 : 0)];
}
rate_loop_t hourglass_loop(unsigned effects)
{
  return loops().hourglass[2 * tm_fx_kernel(effects) + ((effects & TM_FX_3D) ? 1 : 0)];
}
predict_loop_t predict_loop() { return loops().predict; }
update_loop_t update_loop() { return loops().update; }

}    // namespace SPHTM_NS
