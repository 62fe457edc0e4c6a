/* SPH-TM: the loops of fix sph/tm/heat, sph/tm/drive and sph/tm/relax over particles. See loop_table.h. */
#ifndef SPHTM_HEAT_LOOPS_H
#define SPHTM_HEAT_LOOPS_H

#include "loop_table.h"
#include "tm_dirichlet.h"
#include "tm_relax.h"
#include "tm_surface_flux.h"

namespace SPHTM_NS {

TM_FN double tm_heat_nothing(void) { return 0.0; }
TM_FN void tm_heat_sum(double *sum, const double *value) { *sum += *value; }

#define HEAT_LOOPS(LOOP)                                                                                  \
  LOOP(SUM, surface_area, tm_surface_flux_args, double, tm_heat, tm_surface_flux_of_group(i, &a, 1).area) \
  LOOP(SUM, surface_flux, tm_surface_flux_args, tm_surface_flux_result, tm_surface_flux,                  \
       tm_surface_flux_of_group(i, &a, 0))                                                                \
  LOOP(SUM, dirichlet, tm_dirichlet_args, double, tm_heat, tm_dirichlet(i, &a))                           \
  LOOP(SUM, drive, tm_drive_args, tm_drive_result, tm_drive, tm_drive(i, &a))                             \
  LOOP(SUM, relax, tm_relax_args, tm_relax_result, tm_relax, tm_relax(i, &a, effects))

struct HeatLoops {
  SPHTM_LOOP_POINTERS(HEAT_LOOPS)

  static const HeatLoops &of(const Backend &);
  static const HeatLoops *kokkos;    // where this build has them
};

}    // namespace SPHTM_NS

#endif
