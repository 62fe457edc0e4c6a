#ifdef LMP_KOKKOS
#include "backend_kokkos.h"

#include "instruction_set.h"
#include "tm_layout.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <vector>

namespace SPHTM_NS {

namespace {

using Memory = LMPDeviceType::memory_space;
using Unmanaged = Kokkos::MemoryTraits<Kokkos::Unmanaged>;
template <class SPACE> using Bytes = Kokkos::View<char *, SPACE, Unmanaged>;
template <class SPACE> Bytes<SPACE> bytes_at(const void *p, size_t n) { return Bytes<SPACE>((char *) p, n); }

struct FillBytes {
  unsigned char *p, value;
  KOKKOS_FUNCTION void operator()(int i) const { p[i] = value; }
};
class DeviceBackend : public Backend {
 public:
  std::string name() const override { return std::string("kernels of Kokkos ") + LMPDeviceType::name(); }

  bool shared() const override { return false; }
  int block() const override { return TM_BLOCK; }
  void *allocate(size_t n, const char *what) override
  {
    return Kokkos::kokkos_malloc<Memory>(std::string("sph/tm: ") + what, n);
  }
  void release(void *p) override
  {
    if (p) Kokkos::kokkos_free<Memory>(p);
  }
  void to_loops(void *there, const void *here, size_t n) override
  {
    Kokkos::deep_copy(bytes_at<Memory>(there, n), bytes_at<Kokkos::HostSpace>(here, n));
  }
  void to_host(void *here, const void *there, size_t n) override
  {
    Kokkos::deep_copy(bytes_at<Kokkos::HostSpace>(here, n), bytes_at<Memory>(there, n));
  }
  void copy(void *to, const void *from, size_t n) override
  {
    Kokkos::deep_copy(LMPDeviceType(), bytes_at<Memory>(to, n), bytes_at<Memory>(from, n));
  }
  void zero(void *p, size_t n) override
  {
    if (n) Kokkos::deep_copy(LMPDeviceType(), bytes_at<Memory>(p, n), 0);
  }
  void fill(unsigned char *p, unsigned char value, size_t n) override
  {
    kokkos_each("sph/tm fill", (int) n, FillBytes{p, value});
  }
  void *allocate_result(size_t n) override { return Kokkos::kokkos_malloc<Kokkos::SharedHostPinnedSpace>("sph/tm", n); }
  void release_result(void *p) override
  {
    if (p) Kokkos::kokkos_free<Kokkos::SharedHostPinnedSpace>(p);
  }
  void copy_to_result(void *result, const void *of_loops, size_t n) override
  {
    Kokkos::deep_copy(LMPDeviceType(), bytes_at<Kokkos::SharedHostPinnedSpace>(result, n),
                      bytes_at<Memory>(of_loops, n));
  }
  void wait() override
  {
    kokkos_join();
    LMPDeviceType().fence("sph/tm wait");
  }
#if defined(KOKKOS_ENABLE_CUDA)
  double free_memory() const override
  {
    size_t free = 0, all = 0;
    return cudaMemGetInfo(&free, &all) == cudaSuccess ? (double) free : 1e300;
  }
  void mark(int k) override
  {
    while ((int) events.size() <= k) {
      events.emplace_back();
      cudaEventCreate(&events.back());
    }
    cudaEventRecord(events[k], LMPDeviceType().cuda_stream());
  }
  double seconds_between(int first, int second) override
  {
    float milliseconds = 0.0f;
    cudaEventSynchronize(events[second]);
    cudaEventElapsedTime(&milliseconds, events[first], events[second]);
    return 1e-3 * milliseconds;
  }

 private:
  std::vector<cudaEvent_t> events;    // until the process ends
#else                                 // where there are none, the loops are waited for
  void mark(int k) override
  {
    wait();
    if ((int) times.size() <= k) times.resize(k + 1);
    times[k] = std::chrono::steady_clock::now();
  }
  double seconds_between(int first, int second) override
  {
    return std::chrono::duration<double>(times[second] - times[first]).count();
  }

 private:
  std::vector<std::chrono::steady_clock::time_point> times;
#endif
};

/* ---------------------------------------------------------------------- threads of the host */

#if !defined(LMP_KOKKOS_GPU)
class ThreadBackend : public Backend {
 public:
  std::string name() const override
  {
    return std::string(instruction_set_name()) + ", Kokkos " + LMPDeviceType::name();
  }
  void blocks(int n, const std::function<void(int, int)> &f) override
  {
    Kokkos::parallel_for("sph/tm blocks", Kokkos::RangePolicy<LMPDeviceType>(0, (n + LOOP_BLOCK - 1) / LOOP_BLOCK),
                         [&](int b) { f(b * LOOP_BLOCK, std::min(n, (b + 1) * LOOP_BLOCK)); });
  }
};
#endif

}    // namespace

/* ---------------------------------------------------------------------- queues beside LAMMPS's */

#if defined(KOKKOS_ENABLE_CUDA)
namespace {

// until Kokkos ends
class Queue {
 public:
  explicit Queue(bool first) : urgent(first) {}
  const LMPDeviceType &behind_lammps()
  {
    if (!queue) make();
    cudaEventRecord(forked, LMPDeviceType().cuda_stream());
    cudaStreamWaitEvent(stream, forked, 0);
    used = true;
    return *queue;
  }
  void before_lammps()
  {
    if (!used) return;
    used = false;
    cudaEventRecord(done, stream);
    cudaStreamWaitEvent(LMPDeviceType().cuda_stream(), done, 0);
  }

 private:
  const bool urgent;
  cudaStream_t stream;
  cudaEvent_t forked, done;
  std::unique_ptr<LMPDeviceType> queue;
  bool used = false;
  void make()
  {
    int last = 0, first = 0;
    cudaDeviceGetStreamPriorityRange(&last, &first);
    cudaStreamCreateWithPriority(&stream, cudaStreamNonBlocking, urgent ? first : last);
    for (cudaEvent_t *e : {&forked, &done}) cudaEventCreateWithFlags(e, cudaEventDisableTiming);
    queue = std::make_unique<LMPDeviceType>(stream);
    Kokkos::push_finalize_hook([this] {
      queue->fence("sph/tm end");
      queue.reset();
      for (cudaEvent_t e : {forked, done}) cudaEventDestroy(e);
      cudaStreamDestroy(stream);
    });
  }
};
Queue beside(false), urgent(true);

}    // namespace

LMPDeviceType kokkos_fork() { return beside.behind_lammps(); }
void kokkos_join() { beside.before_lammps(); }
LMPDeviceType kokkos_urgent() { return urgent.behind_lammps(); }
#else
LMPDeviceType kokkos_fork() { return LMPDeviceType(); }
void kokkos_join() {}
LMPDeviceType kokkos_urgent() { return LMPDeviceType(); }
#endif

Backend &kokkos_backend()
{
  static DeviceBackend device;
#if defined(LMP_KOKKOS_GPU)
  return device;
#else
  static ThreadBackend threads;
  const char *want = getenv("SPHTM_KOKKOS_LOOPS");
  if (want && !strcmp(want, "device")) return device;
  return threads;
#endif
}

}    // namespace SPHTM_NS
#endif
