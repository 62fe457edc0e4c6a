/* SPH-TM: the rate pass in single where Kokkos has a memory of its own. */
#ifndef SPHTM_SINGLE_RATES_KOKKOS_H
#define SPHTM_SINGLE_RATES_KOKKOS_H

#include "rate_loop_sets.h"

namespace SPHTM_NS {

// particles 0 to n - 1, hyperbolic kernel
void kokkos_rates_in_single(int n, const tm_rates_args &, unsigned effects);

}    // namespace SPHTM_NS

#endif
