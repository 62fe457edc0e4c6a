/* SPH-TM: the particle loops run by Kokkos, for a LAMMPS with the KOKKOS package. */
#ifndef SPHTM_BACKEND_KOKKOS_H
#define SPHTM_BACKEND_KOKKOS_H

#include "backend.h"
#include "tm_group.h"

#include "kokkos_type.h"

namespace SPHTM_NS {

// threads of the host take blocks of particles through the loops of the host; a GPU has kernels of
// its own, in its own memory. SPHTM_KOKKOS_LOOPS=device lets the host run the GPU's, for tests.
Backend &kokkos_backend();

// threads of a warp: a block takes a multiple of so many, and groups of threads stay in one warp
constexpr int KOKKOS_WARP = 32;

// Particles 0..n-1. The arguments of a loop go with its launch, up to 4 kB. Kokkos would keep those over 512 bytes in one
// place, and the host would wait there for the loop before.
template <class BOUNDS = Kokkos::LaunchBounds<>> auto kokkos_range(int n)
{
  using Property = Kokkos::Experimental::WorkItemProperty::HintLightWeight_t;
  return Kokkos::RangePolicy<LMPDeviceType, BOUNDS, Property>(0, n, Kokkos::ChunkSize(KOKKOS_WARP));
}

// one(i) for i = 0..n-1
template <class BOUNDS = Kokkos::LaunchBounds<>, class ONE> void kokkos_each(const char *label, int n, const ONE &one)
{
  Kokkos::parallel_for(label, kokkos_range<BOUNDS>(n), one);
}

// Threads for each of n particles, a power of two up to `most`: as many as keep a GPU busy.
inline int kokkos_threads_of_one(int n, int most)
{
#if defined(LMP_KOKKOS_GPU)
  constexpr int OCCUPIED = 8;    // of so many threads that the GPU can hold, one is enough
  static const long threads = LMPDeviceType().concurrency() / OCCUPIED;
  int group = 1;
  while (group < most && 2l * group * n <= threads) group *= 2;
  return group;
#else
  (void) n;
  (void) most;
  return 1;
#endif
}

// for loops in which few particles have a row, and that a long one
#if defined(LMP_KOKKOS_GPU)
constexpr int ROW_THREADS = 8;
#else
constexpr int ROW_THREADS = 1;
#endif

// one(i, group) for i = 0..n-1 by GROUP threads side by side
template <int GROUP, class ONE> struct KokkosShared {
  ONE one;
  KOKKOS_FUNCTION void operator()(int thread) const { one(thread / GROUP, tm_group{thread % GROUP, GROUP}); }
};
template <int GROUP, class BOUNDS = Kokkos::LaunchBounds<>, class ONE>
void kokkos_each_shared(const char *label, int n, const ONE &one)
{
  kokkos_each<BOUNDS>(label, n * GROUP, KokkosShared<GROUP, ONE>{one});
}

// the sum of one(i), i = 0..n-1; JOIN()(&sum, &value) adds
template <class RESULT, class ONE, class JOIN> struct KokkosSum {
  using value_type = RESULT;
  RESULT nothing;
  ONE one;
  JOIN add;
  KOKKOS_FUNCTION void operator()(int i, RESULT &sum) const
  {
    const RESULT r = one(i);
    add(&sum, &r);
  }
  KOKKOS_FUNCTION void init(RESULT &sum) const { sum = nothing; }
  KOKKOS_FUNCTION void join(RESULT &sum, const RESULT &r) const { add(&sum, &r); }
};

template <class RESULT, class ONE, class JOIN>
RESULT kokkos_sum(const char *label, int n, const RESULT &nothing, const ONE &one, const JOIN &join)
{
  RESULT sum = nothing;
  if (n > 0) Kokkos::parallel_reduce(label, kokkos_range(n), KokkosSum<RESULT, ONE, JOIN>{nothing, one, join}, sum);
  return sum;
}

// the same into memory that the host sees, without waiting for it
template <class BOUNDS = Kokkos::LaunchBounds<>, class RESULT, class ONE, class JOIN>
void kokkos_sum_later(const char *label, int n, const RESULT &nothing, const ONE &one, const JOIN &join, RESULT *result)
{
  using Result = Kokkos::View<RESULT, Kokkos::SharedHostPinnedSpace, Kokkos::MemoryTraits<Kokkos::Unmanaged>>;
  if (n > 0)
    Kokkos::parallel_reduce(label, kokkos_range<BOUNDS>(n), KokkosSum<RESULT, ONE, JOIN>{nothing, one, join},
                            Result(result));
  else *result = nothing;
}

}    // namespace SPHTM_NS

#endif
