#include "stop_report.h"

#include "scene.h"
#include "step_args.h"

#include "atom.h"
#include "domain.h"
#include "error.h"
#include "modify.h"
#include "update.h"
#include "utils.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

StopReport::StopReport(LAMMPS *lmp, ParticleState &s, const Scene &sc) : Pointers(lmp), state(s), scene(sc) {}

void StopReport::init()
{
  constexpr double TIMES = 10.0, WITHOUT_MELTING = 1e5;    // K
  double melting = 0.0;
  for (int t = 1; t <= atom->ntypes; t++) {
    const tm_material &m = state.model().materials()[t];
    if (tm_strength_flow(m.strength) == TM_FLOW_THERMAL) melting = std::max(melting, m.t_melt);
  }
  hottest = hottest_given > 0.0 ? hottest_given : melting > 0.0 ? TIMES * melting : WITHOUT_MELTING;
}

void StopReport::limit(tm_update_args &a) const
{
  a.hottest = hottest;
  a.densest = densest;
  a.watch_melt = state.has(TM_FX_HEAT) && !melt_reported;
}

bool StopReport::scene_has(const char *fix_style) const { return !modify->get_fix_by_style(fix_style).empty(); }

// gone: time since the half step, where it left
void StopReport::stop_on_lost(int i, double gone)
{
  state.atoms().to_host_in_step();
  const tm_drift_args a = drift_args(state, *domain);
  const double *v = atom->v[i];
  double x[3], beyond = -1e300;    // the face that it is farthest beyond
  int d = 0, upper = 0;
  for (int k = 0; k < 3; k++) {
    x[k] = atom->x[i][k] - gone * v[k];
    for (int side = 0; side < 2; side++) {
      const double by = side ? x[k] - a.hi[k] : a.lo[k] - x[k];
      if (!a.closed[k][side] || by <= beyond) continue;
      beyond = by;
      d = k;
      upper = side;
    }
  }
  error->one(FLERR,
             "Fix sph/tm stops at step {}: particle {} (type {}) at {:.6g} {:.6g} {:.6g} with "
             "velocity {:.6g} {:.6g} {:.6g} leaves the box through its {} {} boundary. Likely "
             "cause: a box too small for the motion, or a particle shot out{}. Make the box "
             "larger, use boundary m or s, or let it go with 'lost ignore' of fix "
             "sph/tm and 'thermo_modify lost ignore'",
             update->ntimestep, atom->tag[i], atom->type[i], x[0], x[1], x[2], v[0], v[1], v[2], "xyz"[d],
             upper ? "upper" : "lower",
             scene_has("^contact/tri") || state.has(TM_FX_BODIES) ? " by an unstable contact" : "");
}

// once a rank; nothing in the laws knows of a liquid
void StopReport::warn_of_melting(int i)
{
  melt_reported = true;
  state.atoms().to_host_in_step();
  const double *x = atom->x[i];
  error->warning(FLERR,
                 "Fix sph/tm: at step {} particle {} (type {}) at {:.6g} {:.6g} {:.6g} is the "
                 "first above the melting "
                 "temperature {:.6g} of {}: {:.6g} K; it has no strength from there on",
                 update->ntimestep, atom->tag[i], atom->type[i], x[0], x[1], x[2],
                 state.model().materials()[atom->type[i]].t_melt, state.model().material_name(atom->type[i]),
                 state.temperature(i));
}

// how particle i stands among its neighbors, in words; torn: it has lost most of them
std::string StopReport::surroundings(int i, bool &torn)
{
  const tm_rows rows = scene.rows().host_rows();
  const tm_real *main = scene.results().host_records().main, *p = main + tm_record(i, TM_REC);
  const double reach = tm_kernel_support(state.model().settings_in_use().kernel) * state.model().covered_h();
  const double dp = state.model().smallest_spacing();
  int near = 0, failed = 0;
  double closest = 1e300;
  const double *damage = state.field(TM_F_DAMAGE);
  for (int k = 0; k < rows.mechanical[i]; k++) {
    const int j = rows.index[rows.first[i] + k * rows.stride];
    const tm_real *q = main + tm_record(j, TM_REC);
    const double r = sqrt((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]) +
                          (p[tm_part(2)] - q[tm_part(2)]) * (p[tm_part(2)] - q[tm_part(2)]));
    if (!(r < reach)) continue;
    near++;
    closest = std::min(closest, r);
    failed += damage && j < atom->nlocal && damage[2 * (size_t) j + 1] > 0.5;
  }
  const bool itself = damage && damage[2 * (size_t) i + 1] > 0.5;
  torn = near < 2 * domain->dimension;
  std::string text = fmt::format("it has {} neighbors within reach", near);
  if (near) text += fmt::format(", the closest at {:.3g} of the spacing", closest / dp);
  if (itself) text += ", and has failed by damage";
  else if (failed) text += fmt::format(", {} of them failed by damage", failed);
  return text;
}

// at least half of what the temperature of particle i fell by in this step
bool StopReport::most_by_conduction(int i)
{
  const double *heat = state.has(TM_FX_CONDUCTION) ? scene.results().host_heat() : nullptr;
  if (!heat) return false;
  const double *T = state.field(TM_F_TEMP) + 3 * (size_t) i;
  const double rho = scene.results().host_records().main[tm_record(i, TM_REC) + tm_part(TM_REC_RHO)];
  const double conducted = heat[i] / (rho * tm_capacity(state.model().materials() + atom->type[i], T[0]));
  return conducted < 0.5 * T[1] && T[1] < 0.0;
}

// of what the scene has
std::string StopReport::likely_cause(int i, int status)
{
  const bool tool = scene_has("^contact/tri"), bodies = state.has(TM_FX_BODIES);
  const char *contact = tool && bodies ? "a tool or body" : tool ? "a tool" : "a body";
  bool torn = false;
  const std::string around = surroundings(i, torn);
  std::vector<std::string> causes;
  auto may = [&causes](bool is, const std::string &text) {
    if (is) causes.push_back(text);
  };
  const bool fixed = state.time_step().is_fixed();
  switch (status) {
    case TM_BAD_NAN:
      may(true, "a force, velocity or position that is no number from another fix or command");
      may(true, "overlapping particles");
      break;
    case TM_BAD_DENSITY:
    case TM_BAD_VOLUME:
      may(torn, "a particle torn out of the body that has lost its neighbors");
      may(!torn, "a body that is compressed or stretched beyond what its material bears");
      may(tool || bodies, fmt::format("{} that presses too hard: check penalty and speed", contact));
      may(!fixed, "a step too large for the deformation: lower courant");
      break;
    case TM_BAD_VELOCITY:
      may(true, "overlapping particles");
      may(tool || bodies, fmt::format("{} that starts inside another: check penalty and positions", contact));
      may(true, "a force or velocity given by another command");
      break;
    case TM_BAD_STRAIN:
      may(torn, "a particle that has lost its neighbors");
      may(!fixed, "a step too large for the deformation: lower courant");
      may(tool || bodies, fmt::format("{} that is too fast for the spacing", contact));
      break;
    case TM_BAD_HEAT:
      may(scene_has("^sph/tm/heat"), "a heat source or flux (fix sph/tm/heat) larger than meant");
      may(temperature_set, "a temperature given by fix_modify");
      may(tool || bodies, "friction heat of a speed or pressure out of range");
      may(state.has(TM_FX_ENERGY), "a shock: particles at the face where bodies meet get far hotter than those behind, "
                                   "raise temperature/max");
      may(state.has(TM_FX_PLASTICITY), "plastic work of a material whose constants are in another unit");
      break;
    default:
      if (most_by_conduction(i)) {
        may(true, "conduction faster than the step between particles far closer or lighter than the "
                  "spacing says: lower "
                  "dt/max or courant");
        may(!state.has(TM_FX_ARTSTRESS) && !state.has(TM_FX_HOURGLASS),
            "tension that draws particles together: use artstress or "
            "hourglass of pair_style");
        break;
      }
      may(scene_has("^sph/tm/heat"), "a heat sink (fix sph/tm/heat) stronger than the particle can feed in one step");
      may(tool || bodies, fmt::format("heat that {} took", contact));
      may(state.has(TM_FX_COMPRESSION_HEAT),
          "cooling by expansion: check the constant expansion, or those of eos shock, and the strain");
  }
  may(fixed, fmt::format("the constant dt {:.6g}: use 'dt auto'", state.time_step().fixed_value()));
  return causes.empty() ? around : around + ". Likely cause: " + utils::join_words(causes, ", or ");
}

// a state that cannot go on: say where and why, leave the last restart file as it is
void StopReport::stop_on(const tm_update_result &r)
{
  const int i = r.particle;
  state.atoms().to_host_in_step();
  const double *x = atom->x[i], *v = atom->v[i];
  if (!std::isfinite(x[0] + x[1] + x[2]))
    x = scene.results().host_records().main + (size_t) i * TM_REC;    // half a step ago
  const tm_material &m = state.model().materials()[atom->type[i]];
  const double rho = state.field(TM_F_RHO)[i], T = state.temperature(i), *pstrain = state.field(TM_F_PSTRAIN);
  std::string what;
  switch (r.status) {
    case TM_BAD_NAN: what = "state is not a number"; break;
    case TM_BAD_DENSITY:
      what = fmt::format("density {:.6g} is not positive", rho / state.model().units().density);
      break;
    case TM_BAD_VOLUME:
      what = fmt::format("density is {:.4g} times that of the material, beyond the factor {:.4g} of density/max",
                         rho / m.rho0, densest);
      break;
    case TM_BAD_VELOCITY:
      what = fmt::format("velocity {:.6g} is above ten times the speed of sound",
                         sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]));
      break;
    case TM_BAD_STRAIN:
      what = fmt::format("plastic strain grew by {:.4g} in one step",
                         pstrain ? state.time_step().now() * pstrain[3 * (size_t) i + 1] : 0.0);
      break;
    case TM_BAD_HEAT:
      what = fmt::format("temperature {:.6g} is above the {:.6g} of temperature/max", T, hottest);
      break;
    default: what = fmt::format("temperature {:.6g} is not positive", T);
  }
  error->one(FLERR,
             "Fix sph/tm stops at step {}: particle {} (type {}) at {:.6g} {:.6g} {:.6g}: {}; {}. "
             "Restart files written before remain valid.",
             update->ntimestep, atom->tag[i], atom->type[i], x[0], x[1], x[2], what, likely_cause(i, r.status));
}

}    // namespace SPHTM_NS
