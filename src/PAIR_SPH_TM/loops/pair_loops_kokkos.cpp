#ifdef LMP_KOKKOS
#include "effect_sets.h"
#include "loop_table_kokkos.h"
#include "pair_loops.h"
#include "rates_kokkos.h"
#include "thermal_rows_kokkos.h"

#include <utility>

namespace SPHTM_NS {

namespace {

/* ---------------------------------------------------------------------- kernels for sets of effects */

typedef void (*device_rate_loop_t)(int, const tm_rates_args &);

template <unsigned EFFECTS> struct Correction {
  tm_rates_args a;
  KOKKOS_FUNCTION void operator()(int i) const { tm_moment(a.which ? a.which[i] : i, &a, EFFECTS); }
};
template <unsigned EFFECTS> void run_correction(int n, const tm_rates_args &a)
{
  kokkos_each("sph/tm correction", n, Correction<EFFECTS>{a});
}
template <int... INDEX> device_rate_loop_t correction_of(int index, std::integer_sequence<int, INDEX...>)
{
  static const device_rate_loop_t table[] = {run_correction<kernel_set(INDEX)>...};
  return table[index];
}
// the rows of a backend's particles, for loops that take a list in their arguments
tm_rates_args of_list(const KokkosParticles &p, tm_rates_args a)
{
  if (p.which) a.which = p.which;
  return a;
}
void correction(Backend &backend, int n, const tm_rates_args &a, unsigned effects)
{
  const KokkosParticles p(backend, n);
  correction_of(kernel_set_index(effects), std::make_integer_sequence<int, KERNEL_SETS>())(p.number, of_list(p, a));
}

template <unsigned EFFECTS> struct Hourglass {
  tm_rates_args a;
  KOKKOS_FUNCTION void operator()(int i) const { tm_hourglass(i, &a, EFFECTS); }
};
template <unsigned EFFECTS> void run_hourglass(int n, const tm_rates_args &a)
{
  kokkos_each("sph/tm hourglass", n, Hourglass<EFFECTS>{a});
}
template <int... INDEX> device_rate_loop_t hourglass_of(int index, std::integer_sequence<int, INDEX...>)
{
  static const device_rate_loop_t table[] = {run_hourglass<kernel_set(INDEX)>...};
  return table[index];
}
void hourglass(Backend &, int n, const tm_rates_args &a, unsigned effects)
{
  hourglass_of(kernel_set_index(effects), std::make_integer_sequence<int, KERNEL_SETS>())(n, a);
}

void rates_in_double(Backend &backend, int n, const tm_rates_args &a, unsigned effects)
{
  const KokkosParticles p(backend, n);
  kokkos_rates({p.number, p.number, LMPDeviceType()}, of_list(p, a), effects);
}
void rates_in_single(Backend &backend, int n, const tm_rates_args &a, unsigned effects)
{
  const KokkosParticles p(backend, n);
  kokkos_rates_in_single({p.number, p.number, LMPDeviceType()}, of_list(p, a), effects);
}
void rates_of_some(Backend &backend, int n, const tm_rates_args &a, unsigned effects, const LMPDeviceType &queue)
{
  const KokkosParticles p(backend, n);
  if (p.number)
    (effects & TM_FX_MIXED ? kokkos_rates_in_single : kokkos_rates)({p.number, n, queue}, of_list(p, a), effects);
}
void begin_rates(Backend &backend, int n, const tm_rates_args &a, unsigned effects)
{
  rates_of_some(backend, n, a, effects, kokkos_fork());
}
void end_rates(Backend &backend, int n, const tm_rates_args &a, unsigned effects)
{
  rates_of_some(backend, n, a, effects, LMPDeviceType());
  kokkos_join();
}

struct Thermal {
  tm_rates_args a;
  unsigned effects;
  KOKKOS_FUNCTION void operator()(int i, tm_group group) const
  {
    if (a.rows.thermal[i]) tm_thermal(i, group, &a, effects);
  }
};
// what is begun beside the rates, which write the same heats: that of each particle of the list, until it is added
struct ThermalBegun {
  tm_rates_args a;
  unsigned effects;
  const int *which;
  tm_real *heat;
  KOKKOS_FUNCTION void operator()(int k, tm_group group) const
  {
    const int i = which ? which[k] : k;
    tm_vec3 normal;
    const tm_real sum = a.rows.thermal[i] ? tm_thermal_sum(i, group, &a, effects, &normal) : 0.0;
    if (group.lane == 0) heat[k] = sum;
  }
};
struct ThermalAdd {
  const tm_real *heat;
  const int *which;
  tm_real *to;
  KOKKOS_FUNCTION void operator()(int k) const { to[which ? which[k] : k] += heat[k]; }
};
tm_real *thermal_begun = nullptr;
void begin_thermal(Backend &backend, int n, const tm_rates_args &a, unsigned effects)
{
  thermal_begun = nullptr;
#if defined(KOKKOS_ENABLE_CUDA)
  static KokkosRows<tm_real> rows;
  if (effects & TM_FX_SURFACE) return;
  const KokkosParticles p = kokkos_with_thermal(backend, n, a.rows);
  thermal_begun = rows.of(p.number + 1, "heat of a step");
  kokkos_each_shared<ROW_THREADS>("sph/tm thermal", p.number, ThermalBegun{a, effects, p.which, thermal_begun},
                                  kokkos_fork());
#else
  (void) backend, (void) n, (void) a, (void) effects;
#endif
}
void thermal(Backend &backend, int n, const tm_rates_args &a, unsigned effects)
{
  if (thermal_begun) {
    const KokkosParticles p = kokkos_with_thermal(backend, n, a.rows);
    kokkos_join();
    kokkos_each("sph/tm thermal heat", p.number, ThermalAdd{thermal_begun, p.which, a.heat});
    thermal_begun = nullptr;
    return;
  }
  kokkos_each_shared<ROW_THREADS>("sph/tm thermal", kokkos_with_thermal(backend, n, a.rows), Thermal{a, effects});
}

/* ---------------------------------------------------------------------- one step */

// What the update of a step finds, lowered by each particle; the same in any order. Positive reals are
// in the order of their bits.
struct Limits {
  unsigned long long dt[3], slow,
      trouble;    // slow: all bits of the square of the speed but those set; trouble: particle and status
  int melted;     // a particle
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

// The energies of the particles of a warp, with the ledger, and of all
struct Energies {
  static constexpr int NUMBER = 10;
  double of[NUMBER];
};
KOKKOS_INLINE_FUNCTION Energies energies_of(const tm_update_result &r)
{
  return {{r.stress_work, r.plastic, r.plastic_heat, r.failure, r.thermal_pressure, r.compression, r.artificial,
           r.kinetic_work, r.internal_work, r.heat}};
}
void put_energies(const Energies &e, tm_update_result *r)
{
  tm_real *const to[] = {&r->stress_work, &r->plastic,    &r->plastic_heat, &r->failure,       &r->thermal_pressure,
                         &r->compression, &r->artificial, &r->kinetic_work, &r->internal_work, &r->heat};
  for (int k = 0; k < Energies::NUMBER; k++) *to[k] = e.of[k];
}
struct EnergiesAhead {
  KOKKOS_FUNCTION Energies operator()(const KokkosWarp &warp, const Energies &mine, int step) const
  {
    Energies other;
    for (int k = 0; k < Energies::NUMBER; k++) other.of[k] = warp.from(mine.of[k], step);
    return other;
  }
};
struct SumEnergies {
  KOKKOS_FUNCTION void operator()(Energies *sum, const Energies *e) const
  {
    for (int k = 0; k < Energies::NUMBER; k++) sum->of[k] += e->of[k];
  }
};

// where the particles lower and sum them, and where the host reads them; until Kokkos ends
struct ResultsOfStep {
  Limits *there = nullptr, *here = nullptr;
  Energies *energies = nullptr;
} of_step;
Energies *rows_of(int n)
{
  static KokkosRows<Energies> rows;
  return rows.of(kokkos_warps(n), "energies of a step");
}
Limits *limits()
{
  if (!of_step.there) {
    of_step.there = (Limits *) kokkos_backend().allocate(sizeof(Limits), "limits");
    of_step.here = (Limits *) kokkos_backend().allocate_result(sizeof(Limits));
    of_step.energies = (Energies *) kokkos_backend().allocate_result(sizeof(Energies));
    Kokkos::push_finalize_hook([] {
      kokkos_backend().release(of_step.there);
      kokkos_backend().release_result(of_step.here);
      kokkos_backend().release_result(of_step.energies);
      of_step = {};
    });
  }
  return of_step.there;
}
struct Predict {
  tm_predict_args a;
  unsigned effects;
  const int *which;
  Limits *limits;    // of the step that begins
  KOKKOS_FUNCTION void operator()(int k) const
  {
    const int i = which ? which[k] : k;
    if (k == 0) {
      for (unsigned long long *p : {limits->dt, limits->dt + 1, limits->dt + 2, &limits->slow, &limits->trouble})
        *p = ~0ull;
      limits->melted = INT_MAX;
    }
    tm_predict(i, &a, effects);
    if (effects & TM_FX_ARTSTRESS) tm_predict_artstress(i, i + 1, &a, effects);
    tm_predict_single(i, &a, effects);
  }
};
void predict(Backend &backend, int n, const tm_predict_args &a, unsigned effects)
{
  const KokkosParticles p(backend, n);
  kokkos_each("sph/tm predict", p.number, Predict{a, effects, p.which, limits()});
}

struct Drift {
  tm_drift_args a;
  unsigned effects;
  int *lost;
  KOKKOS_FUNCTION void operator()(int i) const
  {
    if (tm_drift(i, &a, effects)) Kokkos::atomic_min(lost, i);
  }
};
void drift(Backend &backend, int n, const tm_drift_args &a, unsigned effects, int *lost)
{
  *lost = n;
  kokkos_each("sph/tm drift", KokkosParticles(backend, n), Drift{a, effects, lost});
}

// The update, with effects that are known to be off; the others are tested at run time. It waits for memory: a thread has the
// registers for all that it reads at once. With 168, three warps instead of two to a part of a multiprocessor, the kernel
// alone is 5 % faster for a million particles, and a whole step 1 to 2 % slower.
template <unsigned OFF, unsigned LEDGER> struct Update {
  tm_update_args a;
  unsigned effects;
  KokkosParticles particles;
  Limits *limits;
  Energies *warps;
  KOKKOS_FUNCTION void operator()(int k) const
  {
    const int i = particles.which ? particles.which[k] : k;
    const tm_update_result r = tm_update(i, &a, (effects & ~(OFF | TM_FX_LEDGER)) | LEDGER);
    for (int d = 0; d < 3; d++) lower(limits->dt + d, Kokkos::bit_cast<unsigned long long>(r.dt[d]));
    lower(&limits->slow, ~Kokkos::bit_cast<unsigned long long>(r.speed2));
    if (r.status != TM_OK) Kokkos::atomic_min(&limits->trouble, (unsigned long long) i << 8 | r.status);
    if (r.melted < INT_MAX) Kokkos::atomic_min(&limits->melted, r.melted);
    if (!LEDGER) return;
    Energies e = energies_of(r);
    const KokkosWarp warp(k, particles.number);
    kokkos_sum_warp(warp, &e, EnergiesAhead(), SumEnergies());
    if (warp.lane == 0) warps[k / KOKKOS_SUMMED] = e;
  }
};
template <unsigned OFF, unsigned LEDGER = 0u>
void run_update(const KokkosParticles &p, const tm_update_args &a, unsigned effects)
{
  using Bounds = Kokkos::LaunchBounds<64, 4>;
  kokkos_each<Bounds>("sph/tm update", p.number,
                      Update<OFF, LEDGER>{a, effects, p, limits(), LEDGER ? rows_of(p.number) : nullptr});
}
struct EnergiesOfWarp {
  const Energies *warps;
  KOKKOS_FUNCTION Energies operator()(int w) const { return warps[w]; }
};
tm_update_result update(Backend &backend, int all, const tm_update_args &a, unsigned effects)
{
  const KokkosParticles p(backend, all);
  const int n = p.number;
  constexpr unsigned RARE = RARE_IN_UPDATE, HEAT = TM_FX_HEAT | TM_FX_CONDUCTION, FLOW = TM_FX_PLASTICITY;
  const bool ledger = effects & TM_FX_LEDGER, usual = !(effects & RARE) && effects & HEAT && effects & FLOW;
  tm_update_result r = tm_update_nothing();
  if (n == 0) return r;
  if (ledger && usual) run_update<RARE, TM_FX_LEDGER>(p, a, effects);
  else if (ledger) run_update<0u, TM_FX_LEDGER>(p, a, effects);
  else if (faces_alone(effects, RARE)) run_update<(RARE & ~unsigned(TM_FX_FACES)) | HEAT | FLOW>(p, a, effects);
  else if (effects & RARE) run_update<0u>(p, a, effects);
  else if (usual) run_update<RARE>(p, a, effects);
  else if (effects & HEAT) run_update<RARE | FLOW>(p, a, effects);
  else if (effects & FLOW) run_update<RARE | HEAT>(p, a, effects);
  else run_update<RARE | HEAT | FLOW>(p, a, effects);
  if (ledger)
    kokkos_sum_later("sph/tm update energies", kokkos_warps(n), Energies{}, EnergiesOfWarp{rows_of(n)}, SumEnergies(),
                     of_step.energies);
  backend.copy_to_result(of_step.here, of_step.there, sizeof(Limits));
  backend.wait();
  const Limits &found = *of_step.here;
  for (int k = 0; k < 3; k++) r.dt[k] = Kokkos::bit_cast<double>(found.dt[k]);
  if (found.trouble != ~0ull) {
    r.status = (int) (found.trouble & 255u);
    r.particle = (int) (found.trouble >> 8);
  }
  r.melted = found.melted;
  r.speed2 = Kokkos::bit_cast<double>(~found.slow);
  if (ledger) put_energies(*of_step.energies, &r);
  return r;
}

PAIR_LOOPS(SPHTM_KOKKOS_LOOP)

const PairLoops kernels = {PAIR_LOOPS(SPHTM_LOOP_NAME)};
[[maybe_unused]] const bool known = (PairLoops::kokkos = &kernels, true);

}    // namespace

}    // namespace SPHTM_NS
#endif
