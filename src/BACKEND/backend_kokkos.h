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

// A second queue of a GPU beside the one that LAMMPS's kernels are in, for loops that others do not wait for: few particles
// do not keep a GPU busy with one loop. Elsewhere they take their turn.
// fork(): the queue; what is launched there begins when all that was launched before is done, here and there
// join(): what is launched later waits for what is in that queue
// A third one goes before the others, whatever they have waiting, and begins when all that was launched before in LAMMPS's is
// done: for messages while rates run. The host waits for it (fence()).
LMPDeviceType kokkos_fork();
void kokkos_join();
LMPDeviceType kokkos_urgent();

// Particles 0..n-1. The arguments of a loop go with its launch, up to 4 kB. Kokkos would keep those over 512 bytes in one
// place, and the host would wait there for the loop before.
template <class BOUNDS = Kokkos::LaunchBounds<>> auto kokkos_range(int n, const LMPDeviceType &queue = LMPDeviceType())
{
  using Property = Kokkos::Experimental::WorkItemProperty::HintLightWeight_t;
  return Kokkos::RangePolicy<LMPDeviceType, BOUNDS, Property>(queue, 0, n, Kokkos::ChunkSize(KOKKOS_WARP));
}

// one(i) for i = 0..n-1
template <class BOUNDS = Kokkos::LaunchBounds<>, class ONE>
void kokkos_each(const char *label, int n, const ONE &one, const LMPDeviceType &queue = LMPDeviceType())
{
  Kokkos::parallel_for(label, kokkos_range<BOUNDS>(n, queue), one);
}

// The particles a loop runs over: all of the first n, or those that a backend says (Backend::some). One kernel for both: a
// test that all threads take the same way costs nothing beside what a loop reads.
struct KokkosParticles {
  int number;
  const int *which;
  KokkosParticles(const Backend &b, int n) : number(n), which(b.some(number)) {}
  KokkosParticles(int n, const int *list) : number(n), which(list) {}
};
// one(i) of these, or one(i, what a thread is told besides)
template <class ONE> struct KokkosOfList {
  ONE one;
  const int *which;
  template <class... MORE> KOKKOS_FUNCTION auto operator()(int k, const MORE &...more) const
  {
    return one(which ? which[k] : k, more...);
  }
};
template <class BOUNDS = Kokkos::LaunchBounds<>, class ONE>
void kokkos_each(const char *label, const KokkosParticles &p, const ONE &one)
{
  kokkos_each<BOUNDS>(label, p.number, KokkosOfList<ONE>{one, p.which});
}

// the numbers i of 0..n-1 for which takes(i), in rising order; returns how many
template <class TAKES> struct KokkosList {
  TAKES takes;
  int *list;
  KOKKOS_FUNCTION void operator()(int i, int &m, bool last) const
  {
    if (!takes(i)) return;
    if (last) list[m] = i;
    m++;
  }
};
template <class TAKES> int kokkos_list(const char *label, int n, const TAKES &takes, int *list)
{
  int m = 0;
  Kokkos::parallel_scan(label, Kokkos::RangePolicy<LMPDeviceType>(0, n), KokkosList<TAKES>{takes, list}, m);
  return m;
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
void kokkos_each_shared(const char *label, int n, const ONE &one, const LMPDeviceType &queue = LMPDeviceType())
{
  kokkos_each<BOUNDS>(label, n * GROUP, KokkosShared<GROUP, ONE>{one}, queue);
}
template <int GROUP, class BOUNDS = Kokkos::LaunchBounds<>, class ONE>
void kokkos_each_shared(const char *label, const KokkosParticles &p, const ONE &one)
{
  kokkos_each_shared<GROUP, BOUNDS>(label, p.number, KokkosOfList<ONE>{one, p.which});
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

template <class RESULT, class ONE, class JOIN>
RESULT kokkos_sum(const char *label, const KokkosParticles &p, const RESULT &nothing, const ONE &one, const JOIN &join)
{
  return kokkos_sum(label, p.number, nothing, KokkosOfList<ONE>{one, p.which}, join);
}

// the same into memory that the host sees, without waiting for it
template <class RESULT, class ONE, class JOIN>
void kokkos_sum_later(const char *label, int n, const RESULT &nothing, const ONE &one, const JOIN &join, RESULT *result,
                      const LMPDeviceType &queue = LMPDeviceType())
{
  using Result = Kokkos::View<RESULT, Kokkos::SharedHostPinnedSpace, Kokkos::MemoryTraits<Kokkos::Unmanaged>>;
  if (n > 0)
    Kokkos::parallel_reduce(label, kokkos_range(n, queue), KokkosSum<RESULT, ONE, JOIN>{nothing, one, join},
                            Result(result));
  else *result = nothing;
}

/* ---------------------------------------------------------------------- sums of a warp */

// A reduction of Kokkos moves a long result through all its steps, whatever is in it. Where few particles have one, or the
// result is long, the threads of a warp are summed first, and then what the warps have: rows, one for each.
#if defined(KOKKOS_ENABLE_CUDA)
constexpr int KOKKOS_SUMMED = KOKKOS_WARP;    // threads that make a row
#else
constexpr int KOKKOS_SUMMED = 1;
#endif
inline int kokkos_warps(int threads) { return (threads + KOKKOS_SUMMED - 1) / KOKKOS_SUMMED; }

// the warp of thread i of n
struct KokkosWarp {
  int lane, threads;
  unsigned all;
  KOKKOS_INLINE_FUNCTION KokkosWarp(int i, int n) : lane(i % KOKKOS_SUMMED), threads(n - (i - lane)), all(~0u)
  {
    if (threads >= KOKKOS_SUMMED) threads = KOKKOS_SUMMED;
    else all = (1u << threads) - 1u;
  }
  KOKKOS_INLINE_FUNCTION bool any(bool one) const
  {
#if defined(__CUDA_ARCH__)
    return __any_sync(all, one);
#else
    return one;
#endif
  }
  // of the thread that is so many steps ahead
  template <class NUMBER> KOKKOS_INLINE_FUNCTION NUMBER from(NUMBER mine, [[maybe_unused]] int step) const
  {
#if defined(__CUDA_ARCH__)
    return __shfl_down_sync(all, mine, step);
#else
    return mine;
#endif
  }
};
// in the first thread the sum of all: other(warp, value, step) is the value of the thread so many steps ahead, add(&sum, &value)
template <class RESULT, class OTHER, class ADD>
KOKKOS_INLINE_FUNCTION void kokkos_sum_warp(const KokkosWarp &warp, RESULT *value, const OTHER &other, const ADD &add)
{
  for (int step = KOKKOS_SUMMED / 2; step > 0; step /= 2) {
    const RESULT of_other = other(warp, *value, step);
    if (warp.lane + step < warp.threads) add(value, &of_other);
  }
}

// memory of the loops for rows, until Kokkos ends
template <class ROW> class KokkosRows {
 public:
  ROW *of(int n, const char *what)
  {
    if (n > room) {
      if (!rows) Kokkos::push_finalize_hook([this] { release(); });
      release();
      room = n + n / 8;
      rows = (ROW *) kokkos_backend().allocate(room * sizeof(ROW), what);
    }
    return rows;
  }

 private:
  ROW *rows = nullptr;
  int room = 0;

  void release()
  {
    if (rows) kokkos_backend().wait();
    kokkos_backend().release(rows);
    rows = nullptr;
    room = 0;
  }
};

}    // namespace SPHTM_NS

#endif
