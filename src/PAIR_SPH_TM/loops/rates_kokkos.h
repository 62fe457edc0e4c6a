/* SPH-TM: the rate pass where Kokkos has a memory of its own: particles 0 to n - 1, or those of
   tm_rates_args.which.

   It is compiled apart from the other kernels: next to those that share its functions the compiler
   gave it up to a quarter more registers, and the pass took a third longer. */
#ifndef SPHTM_RATES_KOKKOS_H
#define SPHTM_RATES_KOKKOS_H

#include "effect_sets.h"
#include "tm_rates.h"

#include "kokkos_type.h"

namespace SPHTM_NS {

struct KokkosRates {
  int n, all;    // so many rows; of so many particles, by which threads share a row
  LMPDeviceType queue;
};
void kokkos_rates(const KokkosRates &, const tm_rates_args &, unsigned effects);
void kokkos_rates_in_single(const KokkosRates &, const tm_rates_args &, unsigned effects);    // hyperbolic kernel

}    // namespace SPHTM_NS

#endif
