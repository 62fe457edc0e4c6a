#include "step_args.h"

#include "model.h"
#include "particle_state.h"
#include "step_results.h"

#include "domain.h"
#include "fix.h"
#include "modify.h"

#include <cstring>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

// a particle beyond a fixed boundary is deleted at the next reneighboring
tm_drift_args drift_args(ParticleState &state, const Domain &box)
{
  enum { FIXED = 1 };    // of Domain
  tm_drift_args a;
  a.state = state.arrays();
  a.group = state.group_bit();
  a.half = state.time_step().ahead();
  for (int d = 0; d < 3; d++) {
    for (int side = 0; side < 2; side++) a.closed[d][side] = !box.triclinic && box.boundary[d][side] == FIXED;
    a.lo[d] = box.boxlo[d];
    a.hi[d] = box.boxhi[d];
  }
  return a;
}

int held_groups(Modify &fixes)
{
  static const char *const styles[] = {"sph/tm/drive", "setforce", "move", "rigid"};
  int groups = 0;
  for (const Fix *f : fixes.get_fix_list())
    for (const char *style : styles)
      if (!strncmp(f->style, style, strlen(style))) groups |= f->groupbit;
  return groups;
}

tm_update_args update_args(ParticleState &state, StepResults &results)
{
  Model &model = state.model();
  const Settings &set = model.settings_in_use();
  const tm_rates_args &rates = results.rate_args();
  tm_update_args a;
  a.state = state.arrays();
  a.rec = rates.rec;
  a.gradient = rates.gradient;
  a.heat = rates.heat;
  a.xsph_v = rates.xsph_v;
  a.uneven = rates.uneven;
  a.held = 0;
  a.hourglass_rate = rates.hourglass_rate;
  a.artificial = rates.artificial;
  a.moment = rates.moment;
  a.face_next = rates.face_next;
  a.correction = rates.correction;
  a.share = model.loop_tables().share.loop_read();
  a.ratio = set.ratio;
  a.force_internal = results.internal_force();
  a.source = state.heat_source();
  a.group = state.group_bit();
  a.dt = state.time_step().now();
  a.h = set.h;
  a.visc_alpha = set.visc_alpha;
  a.shock = state.effect_plan().shock;
  a.hourglass = set.hourglass;
  a.accel_unit = model.units().force;
  a.temperature = state.start_temperatures().of_all();
  a.heat_rate = model.fastest_heat_rate();
  a.k_max = model.largest_conductivity();
  a.hottest = a.densest = 1e300;
  a.watch_melt = 0;
  return a;
}

}    // namespace SPHTM_NS
