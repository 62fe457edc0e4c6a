/* SPH-TM: the particles with neighbors that only exchange heat, for the loops of Kokkos: a list of them, or all. */
#ifndef SPHTM_THERMAL_ROWS_KOKKOS_H
#define SPHTM_THERMAL_ROWS_KOKKOS_H

#include "backend_kokkos.h"
#include "tm_chunk.h"

namespace SPHTM_NS {

inline KokkosParticles kokkos_with_thermal(const Backend &backend, int n, const tm_rows &rows)
{
  return rows.with_thermal ? KokkosParticles(rows.n_with_thermal, rows.with_thermal) : KokkosParticles(backend, n);
}

}    // namespace SPHTM_NS

#endif
