/* SPH-TM: the loops of fix adapt/neigh over rows, compiled once per instruction set. */
#ifndef SPHTM_LIST_LOOPS_H
#define SPHTM_LIST_LOOPS_H

#include "tm_search.h"
#include "tm_tl_correction.h"
#include "tm_freeze.h"
#include "tm_tl_proximity.h"

namespace SPHTM_NS {

constexpr int KEPT_LOOPS = 8;    // 3D x viscosity x conduction
constexpr unsigned kept_loop_effects(int k)
{
  return (k & 1 ? unsigned(TM_FX_3D) : 0u) | (k & 2 ? unsigned(TM_FX_VISCOSITY) : 0u) |
      (k & 4 ? unsigned(TM_FX_CONDUCTION) : 0u);
}
constexpr int kept_loop_index(unsigned fx)
{
  return (fx & TM_FX_3D ? 1 : 0) + (fx & TM_FX_VISCOSITY ? 2 : 0) + (fx & TM_FX_CONDUCTION ? 4 : 0);
}

// one table per instruction set; particles begin to end - 1
struct ListLoops {
  int (*search)(int begin, int end, const tm_search_args *);    // the longest row
  void (*kept[KEPT_LOOPS])(int begin, int end, const tm_tl_args *);
  void (*show)(int begin, int end, const tm_tl_args *, tm_real *shown);
  void (*moments)(int begin, int end, const tm_tl_correction_args *, unsigned effects);
  void (*settle)(int begin, int end, const tm_freeze_args *, unsigned effects);
  int (*watch)(int begin, int end, const tm_proximity_args *);
};
namespace isa_default { extern const ListLoops list_loops; }
namespace isa_avx2 { extern const ListLoops list_loops; }
namespace isa_avx512 { extern const ListLoops list_loops; }

const ListLoops &list_loops();    // those of the best that the processor has

}    // namespace SPHTM_NS

#endif
