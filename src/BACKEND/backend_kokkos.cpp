#ifdef LMP_KOKKOS
#include "backend_kokkos.h"

#include "lists_kokkos.h"
#include "rate_loops.h"
#include "rates_kokkos.h"
#include "tm_thermal.h"

#include <cstdlib>
#include <cstring>
#include <type_traits>
#include <utility>

namespace SPHTM_NS {

namespace {

using Memory = LMPDeviceType::memory_space;
using Unmanaged = Kokkos::MemoryTraits<Kokkos::Unmanaged>;
template <class SPACE> using Bytes = Kokkos::View<char *, SPACE, Unmanaged>;
template <class SPACE> Bytes<SPACE> bytes_at(const void *p, size_t n)
{
  return Bytes<SPACE>((char *) p, n);
}

/* ---------------------------------------------------------------------- kernels of a GPU */

template <unsigned EFFECTS> struct Moments {
  tm_rates_args a;
  KOKKOS_FUNCTION void operator()(int i) const { tm_moment(a.which ? a.which[i] : i, &a, EFFECTS); }
};

template <unsigned EFFECTS> void run_moments(int n, const tm_rates_args &a)
{
  kokkos_each("sph/tm moments", n, Moments<EFFECTS>{a});
}

template <unsigned EFFECTS> struct Hourglass {
  tm_rates_args a;
  KOKKOS_FUNCTION void operator()(int i) const { tm_hourglass(i, &a, EFFECTS); }
};

template <unsigned EFFECTS> void run_hourglass(int n, const tm_rates_args &a)
{
  kokkos_each("sph/tm hourglass", n, Hourglass<EFFECTS>{a});
}

typedef void (*device_moment_loop_t)(int, const tm_rates_args &);

constexpr unsigned moment_effects(int index)
{
  return ((unsigned) index / 2) << TM_FX_KERNEL_SHIFT | ((index & 1) ? unsigned(TM_FX_3D) : 0u);
}
template <int... INDEX>
device_moment_loop_t find_moments(int index, std::integer_sequence<int, INDEX...>)
{
  static const device_moment_loop_t table[] = {run_moments<moment_effects(INDEX)>...};
  return table[index];
}
template <int... INDEX>
device_moment_loop_t find_hourglass(int index, std::integer_sequence<int, INDEX...>)
{
  static const device_moment_loop_t table[] = {run_hourglass<moment_effects(INDEX)>...};
  return table[index];
}

// What the update of a step finds, lowered by each particle; the same in any order. Positive reals are
// in the order of their bits.
struct Limits {
  unsigned long long dt[3], trouble;    // trouble: particle and status
  int melted;                           // a particle
};
KOKKOS_INLINE_FUNCTION void lower(unsigned long long *least, unsigned long long value)
{
#if defined(__CUDA_ARCH__)    // one of a warp asks
  const unsigned warp = __activemask(), high = __reduce_min_sync(warp, (unsigned) (value >> 32));
  const unsigned low = __reduce_min_sync(warp, (unsigned) (value >> 32) == high ? (unsigned) value : ~0u);
  unsigned lane;
  asm("mov.u32 %0, %%laneid;" : "=r"(lane));
  value = (unsigned long long) high << 32 | low;
  if (lane != (unsigned) __ffs(warp) - 1u) return;
#endif
  if (value < *(volatile unsigned long long *) least) Kokkos::atomic_min(least, value);
}

struct Predict {
  tm_predict_args a;
  unsigned fx;
  Limits *limits;    // of the step that begins
  KOKKOS_FUNCTION void operator()(int i) const
  {
    if (i == 0)
    {
      for (unsigned long long *p : {limits->dt, limits->dt + 1, limits->dt + 2, &limits->trouble}) *p = ~0ull;
      limits->melted = INT_MAX;
    }
    tm_predict(i, &a, fx);
    if (fx & TM_FX_ARTSTRESS) tm_predict_artstress(i, i + 1, &a, fx);
  }
};
struct Round {
  tm_single_args a;
  unsigned fx;
  KOKKOS_FUNCTION void operator()(int i) const { tm_single(i, &a, fx); }
};
struct Thermal {
  tm_rates_args a;
  unsigned fx;
  KOKKOS_FUNCTION void operator()(int i) const
  {
    if (a.rows.thermal[i]) tm_thermal(i, &a, fx);
  }
};
struct InitialOfNew {
  tm_initial_args a;
  KOKKOS_FUNCTION void operator()(int i) const { tm_initial_of_new(i, &a); }
};
struct Add {
  double *to;
  const double *from;
  KOKKOS_FUNCTION void operator()(int k) const { to[k] += from[k]; }
};

struct FillBytes {
  unsigned char *p, value;
  KOKKOS_FUNCTION void operator()(int i) const { p[i] = value; }
};
struct Drift {
  tm_drift_args a;
  unsigned fx;
  int *lost;
  KOKKOS_FUNCTION void operator()(int i) const
  {
    if (tm_drift(i, &a, fx)) Kokkos::atomic_min(lost, i);
  }
};
struct BodyContact {
  tm_rates_args a;
  tm_body_contact_args b;
  unsigned fx;
  KOKKOS_FUNCTION tm_body_contact_result operator()(int i) const
  {
    return a.rows.contact[i] ? tm_body_contact(i, &a, &b, fx) : tm_body_contact_nothing();
  }
};
struct SumBodyContact {
  KOKKOS_FUNCTION void operator()(tm_body_contact_result *sum, const tm_body_contact_result *r) const
  {
    tm_body_contact_sum(sum, r);
  }
};
// The update, with effects that are known to be off; the others are tested at run time. It waits for
// memory: the more threads the better, as long as registers do not run out by far.
template <unsigned OFF> struct Update {
  tm_update_args a;
  unsigned fx;
  Limits *limits;
  KOKKOS_FUNCTION void operator()(int i) const
  {
    const tm_update_result r = tm_update(i, &a, fx & ~(OFF | TM_FX_LEDGER));
    for (int k = 0; k < 3; k++) lower(limits->dt + k, Kokkos::bit_cast<unsigned long long>(r.dt[k]));
    if (r.status != TM_OK) Kokkos::atomic_min(&limits->trouble, (unsigned long long) i << 8 | r.status);
    if (r.melted < INT_MAX) Kokkos::atomic_min(&limits->melted, r.melted);
  }
};
template <unsigned OFF> void run_update(int n, const tm_update_args &a, unsigned fx, Limits *limits)
{
  using Bounds = std::conditional_t<OFF != 0, Kokkos::LaunchBounds<64, 8>, Kokkos::LaunchBounds<>>;
  kokkos_each<Bounds>("sph/tm update", n, Update<OFF>{a, fx, limits});
}
struct UpdateWithLedger {
  tm_update_args a;
  unsigned fx;
  KOKKOS_FUNCTION tm_update_result operator()(int i) const { return tm_update(i, &a, fx | TM_FX_LEDGER); }
};
struct SumUpdate {
  int ledger;
  KOKKOS_FUNCTION void operator()(tm_update_result *sum, const tm_update_result *r) const
  {
    tm_update_sum(sum, r, ledger);
  }
};
struct Exchange {
  tm_exchange_args a;
  int area_only;
  KOKKOS_FUNCTION tm_exchange_result operator()(int i) const { return tm_exchange_of_group(i, &a, area_only); }
};
struct SumExchange {
  KOKKOS_FUNCTION void operator()(tm_exchange_result *sum, const tm_exchange_result *r) const
  {
    tm_exchange_sum(sum, r);
  }
};
struct Hold {
  tm_hold_args a;
  KOKKOS_FUNCTION double operator()(int i) const { return tm_hold(i, &a); }
};
struct Drive {
  tm_drive_args a;
  KOKKOS_FUNCTION tm_drive_result operator()(int i) const { return tm_drive(i, &a); }
};
struct SumDrive {
  KOKKOS_FUNCTION void operator()(tm_drive_result *sum, const tm_drive_result *r) const { tm_drive_sum(sum, r); }
};
struct InitialLimits {
  tm_update_args a;
  unsigned fx;
  int seed;
  KOKKOS_FUNCTION tm_update_result operator()(int i) const { return tm_initial_limits(i, &a, fx, seed); }
};
struct KineticEnergy {
  tm_state s;
  KOKKOS_FUNCTION double operator()(int i) const { return tm_kinetic_energy(i, &s); }
};
struct SumReal {
  KOKKOS_FUNCTION void operator()(double *sum, const double *r) const { *sum += *r; }
};
struct Tally {
  tm_tally_args a;
  unsigned fx;
  KOKKOS_FUNCTION tm_tally_result operator()(int i) const { return tm_tally(i, &a, fx); }
};
struct SumTally {
  KOKKOS_FUNCTION void operator()(tm_tally_result *sum, const tm_tally_result *r) const { tm_tally_sum(sum, r); }
};
struct SizeOf {
  tm_state s;
  KOKKOS_FUNCTION tm_size_range operator()(int i) const { return tm_size_of(i, &s); }
};
struct Smoothing {
  tm_smoothing_args a;
  unsigned fx;
  KOKKOS_FUNCTION tm_size_range operator()(int i) const { return tm_smoothing(i, &a, fx); }
};
struct SumSizes {
  KOKKOS_FUNCTION void operator()(tm_size_range *sum, const tm_size_range *r) const { tm_size_sum(sum, r); }
};
struct NearCount {
  tm_near_args a;
  KOKKOS_FUNCTION double operator()(int i) const { return tm_near_count(i, &a); }
};
struct Nearest {
  tm_near_args a;
  KOKKOS_FUNCTION tm_nearest operator()(int i) const { return tm_nearest_neighbor(i, &a); }
};
struct SumNearest {
  KOKKOS_FUNCTION void operator()(tm_nearest *sum, const tm_nearest *r) const { tm_nearest_sum(sum, r); }
};

class DeviceBackend : public KokkosLists {
 public:
  std::string name() const override { return std::string("kernels of Kokkos ") + LMPDeviceType::name(); }

  bool shared() const override { return false; }
  int block() const override { return TM_BLOCK; }
  void *allocate(size_t n) override { return Kokkos::kokkos_malloc<Memory>("sph/tm", n); }
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
  void add(double *to, const double *from, size_t n) override
  {
    kokkos_each("sph/tm add", (int) n, Add{to, from});
  }

  void *allocate_result(size_t n) override { return Kokkos::kokkos_malloc<Kokkos::SharedHostPinnedSpace>("sph/tm", n); }
  void release_result(void *p) override
  {
    if (p) Kokkos::kokkos_free<Kokkos::SharedHostPinnedSpace>(p);
  }
  void wait() override { LMPDeviceType().fence("sph/tm wait"); }

  void drift(int n, const tm_drift_args &a, unsigned fx, int *lost) override
  {
    *lost = n;
    kokkos_each("sph/tm drift", n, Drift{a, fx, lost});
  }
  void predict(int n, const tm_predict_args &a, unsigned fx) override
  {
    kokkos_each("sph/tm predict", n, Predict{a, fx, limits()});
  }
  void moments(int n, const tm_rates_args &a, unsigned fx) override
  {
    const int index = 2 * tm_fx_kernel(fx) + ((fx & TM_FX_3D) ? 1 : 0);
    find_moments(index, std::make_integer_sequence<int, 2 * TM_KERNEL_COUNT>())(n, a);
  }
  void hourglass(int n, const tm_rates_args &a, unsigned fx) override
  {
    const int index = 2 * tm_fx_kernel(fx) + ((fx & TM_FX_3D) ? 1 : 0);
    find_hourglass(index, std::make_integer_sequence<int, 2 * TM_KERNEL_COUNT>())(n, a);
  }
  void round(int n, const tm_single_args &a, unsigned fx) override
  {
    kokkos_each("sph/tm round", n, Round{a, fx});
  }
  bool rates_in_single(int kernel) const override { return kernel == TM_KERNEL_HYPERBOLIC; }
  void rates(int n, const tm_rates_args &a, unsigned fx) override
  {
    if (fx & TM_FX_MIXED) kokkos_rates_in_single(n, a, fx);
    else kokkos_rates(n, a, fx);
  }
  void thermal(int n, const tm_rates_args &a, unsigned fx) override
  {
    kokkos_each("sph/tm thermal", n, Thermal{a, fx});
  }
  tm_body_contact_result body_contact(int n, const tm_rates_args &a, const tm_body_contact_args &b,
                                      unsigned fx) override
  {
    return kokkos_sum("sph/tm body contact", n, tm_body_contact_nothing(), BodyContact{a, b, fx},
                      SumBodyContact());
  }
  tm_update_result update(int n, const tm_update_args &a, unsigned fx) override
  {
    constexpr unsigned RARE = TM_FX_PLANE_STRESS | TM_FX_ENERGY | TM_FX_DAMAGE | TM_FX_BALSARA | TM_FX_XSPH |
        TM_FX_SMOOTHING | TM_FX_HOURGLASS;
    constexpr unsigned HEAT = TM_FX_HEAT | TM_FX_CONDUCTION, FLOW = TM_FX_PLASTICITY;
    if (fx & TM_FX_LEDGER)
      return kokkos_sum("sph/tm update", n, tm_update_nothing(), UpdateWithLedger{a, fx}, SumUpdate{1});
    tm_update_result r = tm_update_nothing();
    if (n == 0) return r;
    if (fx & RARE) run_update<0>(n, a, fx, limits());
    else if (fx & HEAT && fx & FLOW) run_update<RARE>(n, a, fx, limits());
    else if (fx & HEAT) run_update<RARE | FLOW>(n, a, fx, limits());
    else if (fx & FLOW) run_update<RARE | HEAT>(n, a, fx, limits());
    else run_update<RARE | HEAT | FLOW>(n, a, fx, limits());
    Limits found;
    to_host(&found, limits(), sizeof(found));
    for (int k = 0; k < 3; k++) r.dt[k] = Kokkos::bit_cast<double>(found.dt[k]);
    if (found.trouble != ~0ull) {
      r.status = (int) (found.trouble & 255u);
      r.particle = (int) (found.trouble >> 8);
    }
    r.melted = found.melted;
    return r;
  }

  tm_exchange_result exchange(int n, const tm_exchange_args &a, bool area_only) override
  {
    return kokkos_sum("sph/tm/heat", n, tm_exchange_nothing(), Exchange{a, area_only}, SumExchange());
  }
  double hold(int n, const tm_hold_args &a) override
  {
    return kokkos_sum("sph/tm/heat temperature", n, 0.0, Hold{a}, SumReal());
  }
  tm_drive_result drive(int n, const tm_drive_args &a) override
  {
    return kokkos_sum("sph/tm/drive", n, tm_drive_nothing(), Drive{a}, SumDrive());
  }

  void initial_of_new(int n, const tm_initial_args &a) override
  {
    kokkos_each("sph/tm new particles", n, InitialOfNew{a});
  }
  tm_update_result initial_limits(int n, const tm_update_args &a, unsigned fx, bool seed) override
  {
    return kokkos_sum("sph/tm set-up", n, tm_update_nothing(), InitialLimits{a, fx, seed}, SumUpdate{0});
  }
  double kinetic_energy(int n, const tm_state &s) override
  {
    return kokkos_sum("sph/tm kinetic energy", n, 0.0, KineticEnergy{s}, SumReal());
  }
  tm_tally_result tally(int n, const tm_tally_args &a, unsigned fx) override
  {
    return kokkos_sum("sph/tm tally", n, tm_tally_result{}, Tally{a, fx}, SumTally());
  }
  tm_size_range smoothing(int n, const tm_smoothing_args &a, unsigned fx) override
  {
    return kokkos_sum("sph/tm smoothing length", n, tm_size_nothing(), Smoothing{a, fx}, SumSizes());
  }
  tm_size_range size_range(int n, const tm_state &s) override
  {
    return kokkos_sum("sph/tm sizes", n, tm_size_nothing(), SizeOf{s}, SumSizes());
  }
  double near_count(int n, const tm_near_args &a) override
  {
    return kokkos_sum("sph/tm neighbors", n, 0.0, NearCount{a}, SumReal());
  }
  tm_nearest nearest(int n, const tm_near_args &a) override
  {
    return kokkos_sum("sph/tm nearest", n, tm_nearest_nothing(), Nearest{a}, SumNearest());
  }

 private:
  Limits *limits_ = nullptr;    // until Kokkos ends
  Limits *limits()
  {
    if (!limits_) {
      limits_ = (Limits *) allocate(sizeof(Limits));
      Kokkos::push_finalize_hook([this] {
        release(limits_);
        limits_ = nullptr;
      });
    }
    return limits_;
  }
};

/* ---------------------------------------------------------------------- threads of the host */

#if !defined(LMP_KOKKOS_GPU)
class ThreadBackend : public Backend {
 public:
  std::string name() const override
  {
    return std::string(rate_loop_isa()) + ", Kokkos " + LMPDeviceType::name();
  }
  void blocks(int n, const std::function<void(int, int)> &f) override
  {
    Kokkos::parallel_for("sph/tm blocks",
                         Kokkos::RangePolicy<LMPDeviceType>(0, (n + LOOP_BLOCK - 1) / LOOP_BLOCK),
                         [&](int b) { f(b * LOOP_BLOCK, std::min(n, (b + 1) * LOOP_BLOCK)); });
  }
};
#endif

}    // namespace

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
