/* SPH-TM: fix sph/tm, states that cannot go on. See doc/fix_sph_tm.rst. */
#include "fix_sph_tm.h"

#include "pair_sph_tm.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "modify.h"
#include "update.h"
#include "utils.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace SPHTM_NS;

// a particle beyond a fixed boundary is deleted at the next reneighbouring
tm_drift_args FixSPHTM::drift_args()
{
  enum { FIXED = 1 };    // of Domain
  tm_drift_args a;
  a.state = state();
  a.group = groupbit;
  a.half = dt_ahead;
  for (int d = 0; d < 3; d++) {
    for (int side = 0; side < 2; side++)
      a.closed[d][side] = !domain->triclinic && domain->boundary[d][side] == FIXED;
    a.lo[d] = domain->boxlo[d];
    a.hi[d] = domain->boxhi[d];
  }
  return a;
}

// asked before LAMMPS would delete the particle, and before the forces; whether there is one that may go
bool FixSPHTM::check_lost()
{
  if (drifted == 0) return false;
  backend.wait();
  const bool some = *lost < drifted;
  if (some && stop_on_lost) stop_on_lost_particle(*lost);
  drifted = 0;
  return some;
}

void FixSPHTM::stop_on_lost_particle(int i)
{
  atoms_to_host();
  const tm_drift_args a = drift_args();
  const double *x = atom->x[i], *v = atom->v[i];
  int d = 0;
  while ((!a.closed[d][0] || x[d] >= a.lo[d]) && (!a.closed[d][1] || x[d] <= a.hi[d])) d++;
  error->one(FLERR,
             "Fix sph/tm stops at step {}: particle {} (type {}) at {:.6g} {:.6g} {:.6g} with "
             "velocity {:.6g} {:.6g} {:.6g} leaves the box through its {} {} boundary. Likely "
             "cause: a box too small for the motion, or a particle shot out{}. Make the box "
             "larger, use boundary m or s, or let it go with 'lost ignore' of fix "
             "sph/tm and 'thermo_modify lost ignore'",
             update->ntimestep, atom->tag[i], atom->type[i], x[0], x[1], x[2], v[0], v[1], v[2],
             "xyz"[d], x[d] < a.lo[d] ? "lower" : "upper",
             scene_has("^contact/tri") || has(TM_FX_BODIES) ? " by an unstable contact" : "");
}

double FixSPHTM::find_hottest() const
{
  constexpr double TIMES = 10.0, WITHOUT_MELTING = 1e5;    // K
  if (hottest_given > 0.0) return hottest_given;
  double melting = 0.0;
  for (int t = 1; t <= atom->ntypes; t++) {
    const tm_material &m = pair_sph->materials()[t];
    if (tm_strength_flow(m.strength) == TM_FLOW_THERMAL) melting = std::max(melting, m.t_melt);
  }
  return melting > 0.0 ? TIMES * melting : WITHOUT_MELTING;
}

// once a rank; nothing in the laws knows of a liquid
void FixSPHTM::report_melting(int i)
{
  melt_reported = true;
  atoms_to_host();
  const double *x = atom->x[i];
  error->warning(FLERR,
                 "Fix sph/tm: at step {} particle {} (type {}) at {:.6g} {:.6g} {:.6g} is the "
                 "first above the melting "
                 "temperature {:.6g} of {}: {:.6g} K; it has no strength from there on",
                 update->ntimestep, atom->tag[i], atom->type[i], x[0], x[1], x[2],
                 pair_sph->materials()[atom->type[i]].t_melt,
                 pair_sph->material_name(atom->type[i]), temperature(i));
}

bool FixSPHTM::scene_has(const char *fix_style) const { return !modify->get_fix_by_style(fix_style).empty(); }

// how particle i stands among its neighbors, in words; torn: it has lost most of them
std::string FixSPHTM::surroundings(int i, bool &torn)
{
  const tm_rows rows = pair_sph->host_rows();
  const tm_real *main = pair_sph->host_records().main, *p = main + tm_record(i, TM_REC);
  const double reach = tm_kernel_support(pair_sph->settings_in_use().kernel) * pair_sph->covered_h();
  const double dp = pair_sph->smallest_spacing();
  int near = 0, failed = 0;
  double closest = 1e300;
  const double *damage = field(TM_F_DAMAGE);
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
bool FixSPHTM::most_by_conduction(int i)
{
  const double *heat = has(TM_FX_CONDUCTION) ? pair_sph->host_heat() : nullptr;
  if (!heat) return false;
  const double *T = field(TM_F_TEMP) + 3 * (size_t) i;
  const double rho = pair_sph->host_records().main[tm_record(i, TM_REC) + tm_part(TM_REC_RHO)];
  const double conducted = heat[i] / (rho * tm_capacity(pair_sph->materials() + atom->type[i], T[0]));
  return conducted < 0.5 * T[1] && T[1] < 0.0;
}

// of what the scene has
std::string FixSPHTM::likely_cause(int i, int status)
{
  const bool tool = scene_has("^contact/tri"), bodies = has(TM_FX_BODIES);
  const char *contact = tool && bodies ? "a tool or body" : tool ? "a tool" : "a body";
  bool torn = false;
  const std::string around = surroundings(i, torn);
  std::vector<std::string> causes;
  auto may = [&causes](bool is, const std::string &text) {
    if (is) causes.push_back(text);
  };
  const bool fixed = fixed_dt > 0.0;
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
      may(has(TM_FX_PLASTICITY), "plastic work of a material whose constants are in another unit");
      break;
    default:
      if (most_by_conduction(i)) {
        may(true,
            "conduction faster than the step between particles far closer or lighter than the "
            "spacing says: lower "
            "dt/max or courant");
        may(!has(TM_FX_ARTSTRESS) && !has(TM_FX_HOURGLASS), "tension that draws particles together: use artstress or "
                                                            "hourglass of pair_style");
        break;
      }
      may(scene_has("^sph/tm/heat"), "a heat sink (fix sph/tm/heat) stronger than the particle can feed in one step");
      may(tool || bodies, fmt::format("heat that {} took", contact));
  }
  may(fixed, fmt::format("the constant dt {:.6g}: use 'dt auto'", fixed_dt));
  return around + ". Likely cause: " + utils::join_words(causes, ", or ");
}

// a state that cannot go on: say where and why, leave the last restart file as it is
void FixSPHTM::stop_on(int i, const tm_update_result &r)
{
  atoms_to_host();
  const double *x = atom->x[i], *v = atom->v[i];
  if (!std::isfinite(x[0] + x[1] + x[2]))
    x = pair_sph->host_records().main + (size_t) i * TM_REC;    // half a step ago
  const tm_material &m = pair_sph->materials()[atom->type[i]];
  const double rho = field(TM_F_RHO)[i], T = temperature(i), *pstrain = field(TM_F_PSTRAIN);
  std::string what;
  switch (r.status) {
    case TM_BAD_NAN:
      what = "state is not a number";
      break;
    case TM_BAD_DENSITY:
      what = fmt::format("density {:.6g} is not positive", rho / pair_sph->units().density);
      break;
    case TM_BAD_VOLUME:
      what = fmt::format(
          "density is {:.4g} times that of the material, beyond the factor {:.4g} of density/max",
          rho / m.rho0, densest);
      break;
    case TM_BAD_VELOCITY:
      what = fmt::format("velocity {:.6g} is above ten times the speed of sound",
                         sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]));
      break;
    case TM_BAD_STRAIN:
      what = fmt::format("plastic strain grew by {:.4g} in one step", pstrain ? dt * pstrain[3 * (size_t) i + 1] : 0.0);
      break;
    case TM_BAD_HEAT:
      what = fmt::format("temperature {:.6g} is above the {:.6g} of temperature/max", T, hottest);
      break;
    default:
      what = fmt::format("temperature {:.6g} is not positive", T);
  }
  error->one(FLERR, "Fix sph/tm stops at step {}: particle {} (type {}) at {:.6g} {:.6g} {:.6g}: {}; {}. "
                    "Restart files written before remain valid.",
             update->ntimestep, atom->tag[i], atom->type[i], x[0], x[1], x[2], what, likely_cause(i, r.status));
}
