/* SPH-TM: threads of a GPU that share the work for one particle, side by side in a warp. Each takes a part of its neighbors
   or triangles; then they put together what they found. Elsewhere a thread is alone. */
#ifndef TM_GROUP_H
#define TM_GROUP_H

#include "tm_real.h"

typedef struct {
  int lane, size; /* this thread of so many: a power of two, at most 32 */
} tm_group;

TM_FN tm_group tm_group_alone(void)
{
  const tm_group g = {0, 1};
  return g;
}

#if defined(__CUDA_ARCH__)
/* The threads of the group as bits of the warp. */
TM_FN unsigned tm_group_mask(tm_group g)
{
  unsigned lane;
  asm("mov.u32 %0, %%laneid;" : "=r"(lane));
  return (g.size < 32 ? (1u << g.size) - 1u : ~0u) << (lane & ~(g.size - 1u));
}
#define TM_GROUP_SHUFFLE(v, far, g) __shfl_xor_sync(tm_group_mask(g), v, far)
#else
#define TM_GROUP_SHUFFLE(v, far, g) ((void) (far), (void) (g), v)
#endif

/* The value of the thread whose number differs in the bits `far`. All threads of the group must ask. */
TM_FN tm_real tm_group_other(tm_real v, int far, tm_group g) { return TM_GROUP_SHUFFLE(v, far, g); }
TM_FN int tm_group_other_int(int v, int far, tm_group g) { return TM_GROUP_SHUFFLE(v, far, g); }

/* The sum over the group, for each of its threads. */
TM_FN tm_real tm_group_sum_real(tm_real v, tm_group g)
{
  for (int far = g.size / 2; far > 0; far /= 2) v += tm_group_other(v, far, g);
  return v;
}

#endif
