/* SPH-TM: the sets of effects that loops are instantiated for, on the host and with Kokkos alike.

   Rate pass: literal are the bits of TM_FX_RATE_MASK and the kernel; with TM_FX_EXTENDED all other effects are tested
   at run time, on the host once for each chunk of neighbors, so that what is on costs its arithmetic. With one pass, the default,
   Balsara's switch and XSPH have loops of their own. All sets exist for the default kernel; for the others those of one pass, in
   double on the host. In single, on a GPU and for processors without AVX2 the other kernels have only the sets that test all, so that
   the compiler is done in minutes.

   Prediction and update: scenes without the rare effects have loops for just their set; with one of those the rare ones
   are tested at run time. */
#ifndef SPHTM_EFFECT_SETS_H
#define SPHTM_EFFECT_SETS_H

#include "tm_effects.h"
#include "tm_kernel.h"

namespace SPHTM_NS {

// kernel (5) x dimension (2) x {viscosity, artificial stress, conduction} (8) + extended (1)
// + smoothing and viscosity x {artificial stress, conduction} (4)
// + one pass: viscosity x {conduction, smoothing} (4) + extended (1) + viscosity and faces (1)
//   + Balsara, alone and with XSPH, x {conduction} (4)
constexpr int RATE_SETS_PER_KERNEL = 2 * 23;

// of the default kernel, which is number 0
static constexpr unsigned rate_set(int index)
{
  const unsigned set = index / 2;
  unsigned effects = (index & 1) ? unsigned(TM_FX_3D) : 0u;
  if (set > 18) {    // of a particle without the switch it is 1
    effects |= unsigned(TM_FX_ONE_PASS) | unsigned(TM_FX_VISCOSITY) | unsigned(TM_FX_BALSARA);
    if ((set - 19) & 1u) effects |= unsigned(TM_FX_CONDUCTION);
    if ((set - 19) & 2u) effects |= unsigned(TM_FX_XSPH);
    return effects;
  }
  if (set == 18) return effects | unsigned(TM_FX_ONE_PASS) | unsigned(TM_FX_VISCOSITY) | unsigned(TM_FX_FACES);
  if (set == 17) return effects | unsigned(TM_FX_ONE_PASS) | unsigned(TM_FX_EXTENDED);
  if (set > 12) {
    effects |= unsigned(TM_FX_ONE_PASS) | unsigned(TM_FX_VISCOSITY);
    if ((set - 13) & 1u) effects |= unsigned(TM_FX_CONDUCTION);
    if ((set - 13) & 2u) effects |= unsigned(TM_FX_SMOOTHING);
    return effects;
  }
  if (set == 8) return effects | unsigned(TM_FX_EXTENDED);
  if (set > 8) {
    effects |= unsigned(TM_FX_SMOOTHING) | unsigned(TM_FX_VISCOSITY);
    if ((set - 9) & 1u) effects |= unsigned(TM_FX_ARTSTRESS);
    if ((set - 9) & 2u) effects |= unsigned(TM_FX_CONDUCTION);
    return effects;
  }
  if (set & 1u) effects |= unsigned(TM_FX_VISCOSITY);
  if (set & 2u) effects |= unsigned(TM_FX_ARTSTRESS);
  if (set & 4u) effects |= unsigned(TM_FX_CONDUCTION);
  return effects;
}

static constexpr int kernel_of(unsigned effects) { return (effects >> TM_FX_KERNEL_SHIFT) & 7u; }
static constexpr int is_3d(unsigned effects) { return (effects & TM_FX_3D) ? 1 : 0; }

// of the effects, whatever the kernel
static constexpr int rate_set_index(unsigned effects)
{
  int set = 0;
  constexpr unsigned rare =
      (TM_FX_EXTENDED_MASK | unsigned(TM_FX_ARTSTRESS)) & ~(unsigned(TM_FX_SMOOTHING) | unsigned(TM_FX_CORRECTION));
  constexpr unsigned varied = unsigned(TM_FX_VISCOSITY) | unsigned(TM_FX_CONDUCTION) | unsigned(TM_FX_SMOOTHING);
  constexpr unsigned switches = unsigned(TM_FX_CONDUCTION) | unsigned(TM_FX_BALSARA) | unsigned(TM_FX_XSPH);
  const unsigned asked = effects & (rare | varied);
  if ((effects & TM_FX_ONE_PASS) && asked == (unsigned(TM_FX_FACES) | unsigned(TM_FX_VISCOSITY))) set = 18;
  else if ((effects & TM_FX_ONE_PASS) && (asked & rare) && (asked & ~switches) == unsigned(TM_FX_VISCOSITY))
    set = 19 + ((effects & TM_FX_CONDUCTION) ? 1 : 0) + ((effects & TM_FX_XSPH) ? 2 : 0);
  else if (effects & TM_FX_ONE_PASS)
    set = (effects & rare) || !(effects & TM_FX_VISCOSITY)
              ? 17
              : 13 + ((effects & TM_FX_CONDUCTION) ? 1 : 0) + ((effects & TM_FX_SMOOTHING) ? 2 : 0);
  else if ((effects & TM_FX_EXTENDED_MASK) == TM_FX_SMOOTHING && (effects & TM_FX_VISCOSITY))
    set = 9 + ((effects & TM_FX_ARTSTRESS) ? 1 : 0) + ((effects & TM_FX_CONDUCTION) ? 2 : 0);
  else if (effects & TM_FX_EXTENDED_MASK) set = 8;
  else
    set = ((effects & TM_FX_VISCOSITY) ? 1 : 0) + ((effects & TM_FX_ARTSTRESS) ? 2 : 0) +
          ((effects & TM_FX_CONDUCTION) ? 4 : 0);
  return 2 * set + is_3d(effects);
}

// other kernels: without one pass the set that tests all, number 8, and those of one pass, from number 13 on
constexpr int OTHER_SETS_PER_KERNEL = 2 * (1 + 23 - 13);
constexpr int MOST_RATE_SETS = RATE_SETS_PER_KERNEL + (TM_KERNEL_COUNT - 1) * OTHER_SETS_PER_KERNEL;
static constexpr unsigned most_rate_set(int index)
{
  if (index < RATE_SETS_PER_KERNEL) return rate_set(index);
  const int k = index - RATE_SETS_PER_KERNEL, of_kernel = k % OTHER_SETS_PER_KERNEL;
  const int of_default = of_kernel < 2 ? 2 * 8 + of_kernel : 2 * 12 + of_kernel;
  return unsigned(k / OTHER_SETS_PER_KERNEL + 1) << TM_FX_KERNEL_SHIFT | rate_set(of_default);
}
static constexpr int most_rate_set_index(unsigned effects)
{
  const int kernel = kernel_of(effects), of_default = rate_set_index(effects);
  if (kernel == 0) return of_default;
  return RATE_SETS_PER_KERNEL + (kernel - 1) * OTHER_SETS_PER_KERNEL +
         (of_default < 2 * 13 ? is_3d(effects) : of_default - 2 * 12);
}

constexpr int FEW_RATE_SETS = RATE_SETS_PER_KERNEL + 4 * (TM_KERNEL_COUNT - 1);

static constexpr unsigned few_rate_set(int index)
{
  if (index < RATE_SETS_PER_KERNEL) return rate_set(index);
  const unsigned k = index - RATE_SETS_PER_KERNEL;
  return ((k / 4 + 1) << TM_FX_KERNEL_SHIFT) | unsigned(TM_FX_EXTENDED) | ((k & 1u) ? unsigned(TM_FX_3D) : 0u) |
         ((k & 2u) ? unsigned(TM_FX_ONE_PASS) : 0u);
}

static constexpr int few_rate_set_index(unsigned effects)
{
  const int kernel = kernel_of(effects);
  return kernel == 0 ? rate_set_index(effects)
                     : RATE_SETS_PER_KERNEL + 4 * (kernel - 1) + ((effects & TM_FX_ONE_PASS) ? 2 : 0) + is_3d(effects);
}

// of the gradient correction and of hourglass control: kernel and dimension
constexpr int KERNEL_SETS = 2 * TM_KERNEL_COUNT;
static constexpr unsigned kernel_set(int index)
{
  return ((unsigned) index / 2) << TM_FX_KERNEL_SHIFT | ((index & 1) ? unsigned(TM_FX_3D) : 0u);
}
static constexpr int kernel_set_index(unsigned effects) { return 2 * kernel_of(effects) + is_3d(effects); }

// of the update; the prediction tells the forms of the momentum equation apart too
constexpr unsigned RARE_IN_UPDATE = TM_FX_DAMAGE | TM_FX_ENERGY | TM_FX_PLANE_STRESS | TM_FX_SMOOTHING | TM_FX_FACES;
constexpr unsigned RARE_IN_PREDICTION = RARE_IN_UPDATE | TM_FX_FORM_F14;
// faces alone, of what is elastic: the update of a GPU has a loop of its own for it
static constexpr bool faces_alone(unsigned effects, unsigned rare)
{
  return (effects & rare) == unsigned(TM_FX_FACES) &&
         !(effects & (unsigned(TM_FX_HEAT) | unsigned(TM_FX_CONDUCTION) | unsigned(TM_FX_PLASTICITY)));
}

}    // namespace SPHTM_NS

#endif
