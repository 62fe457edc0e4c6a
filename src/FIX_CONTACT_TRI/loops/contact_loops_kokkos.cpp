#ifdef LMP_KOKKOS
#include "contact_loops.h"
#include "loop_table_kokkos.h"
#include "thermal_rows_kokkos.h"

namespace SPHTM_NS {

namespace {

// Of a warp: whether a thread has a contact, and the sum where one has
struct WarpContacts {
  tm_contact_result *sum;
  unsigned char *touches;
};
struct ContactAhead {
  KOKKOS_FUNCTION tm_vec3 vector(const KokkosWarp &warp, tm_vec3 v, int step) const
  {
    return tm_vec(warp.from(v.x, step), warp.from(v.y, step), warp.from(v.z, step));
  }
  KOKKOS_FUNCTION tm_contact_result operator()(const KokkosWarp &warp, const tm_contact_result &mine, int step) const
  {
    tm_contact_result r;
    r.force = vector(warp, mine.force, step);
    r.torque = vector(warp, mine.torque, step);
    r.friction_power = warp.from(mine.friction_power, step);
    r.friction_heat = warp.from(mine.friction_heat, step);
    r.conducted = warp.from(mine.conducted, step);
    r.heat_tool = warp.from(mine.heat_tool, step);
    r.spring = warp.from(mine.spring, step);
    r.damping_power = warp.from(mine.damping_power, step);
    r.particle_power = warp.from(mine.particle_power, step);
    r.tool_power = warp.from(mine.tool_power, step);
    r.late_friction = warp.from(mine.late_friction, step);
    r.depth = warp.from(mine.depth, step);
    r.inner = warp.from(mine.inner, step);
    r.within = warp.from(mine.within, step);
    r.contacts = warp.from(mine.contacts, step);
    r.faced = warp.from(mine.faced, step);
    return r;
  }
};
struct SumContact {
  KOKKOS_FUNCTION void operator()(tm_contact_result *sum, const tm_contact_result *r) const { tm_contact_sum(sum, r); }
};

// GROUP threads look for the contacts of a particle
template <unsigned SET, int GROUP> struct ContactKernel {
  tm_contact_args a;
  unsigned given;
  const int *which;
  int threads;
  WarpContacts warps;
  KOKKOS_FUNCTION void operator()(int thread) const
  {
    const int i = which ? which[thread / GROUP] : thread / GROUP;
    tm_contact_result r = tm_contact_tri_shared(i, tm_group{thread % GROUP, GROUP}, &a, SET ? SET : given);
    const KokkosWarp warp(thread, threads);
    const bool touches = warp.any(r.depth > 0.0);
    if (touches) kokkos_sum_warp(warp, &r, ContactAhead(), SumContact());
    if (warp.lane != 0) return;
    warps.touches[thread / KOKKOS_SUMMED] = touches;
    if (touches) warps.sum[thread / KOKKOS_SUMMED] = r;
  }
};
struct ContactOfWarp {
  WarpContacts warps;
  KOKKOS_FUNCTION tm_contact_result operator()(int w) const
  {
    return warps.touches[w] ? warps.sum[w] : tm_contact_nothing();
  }
};
struct SumContactOfWarps {
  KOKKOS_FUNCTION void operator()(tm_contact_result *sum, const tm_contact_result *r) const
  {
    if (r->depth > 0.0) tm_contact_sum(sum, r);
  }
};
#if defined(LMP_KOKKOS_GPU)
constexpr int MANY = 100000;    // particles: with more of them those that do not touch count
#endif
using ContactBounds = Kokkos::LaunchBounds<128, 4>;    // few particles touch: the others should not wait for registers

struct Look {
  tm_contact_args a;
  unsigned effects;
  KOKKOS_FUNCTION void operator()(int i, tm_group group) const { tm_contact_look(i, group, &a, effects); }
  KOKKOS_FUNCTION void operator()(int i) const { tm_contact_look(i, tm_group_alone(), &a, effects); }
};
void look(Backend &backend, int n, const tm_contact_args &a, unsigned effects)
{
  const KokkosParticles particles(backend, n);
  const LMPDeviceType queue = kokkos_fork();
  using Taken = Kokkos::View<int, LMPDeviceType::memory_space, Kokkos::MemoryTraits<Kokkos::Unmanaged>>;
  Kokkos::deep_copy(queue, Taken(a.found.taken), 0);
  const KokkosOfList<Look> one{Look{a, effects}, particles.which};
#if defined(LMP_KOKKOS_GPU)
  if (particles.number < MANY)
    return kokkos_each<ContactBounds>("sph/tm look for contact", particles.number * 8,
                                      KokkosShared<8, KokkosOfList<Look>>{one}, queue);
#endif
  kokkos_each<ContactBounds>("sph/tm look for contact", particles.number, one, queue);
}

struct Contact {
  KokkosParticles particles;
  const tm_contact_args &a;
  unsigned given;
  tm_contact_result *result;
  template <unsigned SET, int GROUP> void in_groups() const
  {
    static KokkosRows<tm_contact_result> sums;
    static KokkosRows<unsigned char> touches;
    const int threads = particles.number * GROUP, warps = kokkos_warps(threads);
    const WarpContacts of_warps = {sums.of(warps, "contacts of a step"), touches.of(warps, "contacts of a step")};
    kokkos_join();
    kokkos_each<ContactBounds>("sph/tm contact", threads,
                               ContactKernel<SET, GROUP>{a, given, particles.which, threads, of_warps});
    kokkos_sum_later("sph/tm contact sums", warps, tm_contact_nothing(), ContactOfWarp{of_warps}, SumContactOfWarps(),
                     result, kokkos_fork());
  }
  template <unsigned SET> void with() const
  {
#if defined(LMP_KOKKOS_GPU)    // those that touch take long, whatever else there is
    if (particles.number < MANY && !a.found.place) return in_groups<SET, 8>();
#endif
    in_groups<SET, 1>();
  }
};
void contact(Backend &backend, int n, const tm_contact_args &a, unsigned effects, tm_contact_result *result)
{
  for_contact_set(effects, Contact{KokkosParticles(backend, n), a, effects, result});
}

struct Late {
  tm_contact_args a;
  unsigned effects;
  const int *which;
  KOKKOS_FUNCTION tm_contact_result operator()(int k) const
  {
    return tm_contact_late(which ? which[k] : k, &a, effects);
  }
};
void late(Backend &backend, int n, const tm_contact_args &a, unsigned effects, tm_contact_result *result)
{
  const KokkosParticles particles(backend, n);
  kokkos_sum_later("sph/tm contact late", particles.number, tm_contact_nothing(), Late{a, effects, particles.which},
                   SumContact(), result);
}

struct DivideHeat {
  tm_spread_args a;
  int *first;
  KOKKOS_FUNCTION void operator()(int i) const
  {
    if (tm_spread_divide(i, &a)) Kokkos::atomic_min(first, i);
  }
};
void divide_heat(Backend &, int n, const tm_spread_args &a, unsigned, int *first)
{
  *first = n;
  kokkos_each("sph/tm divide_heat", n, DivideHeat{a, first});
}

struct CollectHeat {
  tm_spread_args a;
  KOKKOS_FUNCTION void operator()(int i, tm_group group) const { tm_spread_collect(i, group, &a); }
};
void collect_heat(Backend &backend, int n, const tm_spread_args &a, unsigned)
{
  kokkos_each_shared<ROW_THREADS>("sph/tm collect_heat", kokkos_with_thermal(backend, n, a.rows), CollectHeat{a});
}

CONTACT_LOOPS(SPHTM_KOKKOS_LOOP)

const ContactLoops kernels = {CONTACT_LOOPS(SPHTM_LOOP_NAME)};
[[maybe_unused]] const bool known = (ContactLoops::kokkos = &kernels, true);

}    // namespace

}    // namespace SPHTM_NS
#endif
