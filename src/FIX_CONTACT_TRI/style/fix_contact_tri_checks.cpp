/* SPH-TM: what fix contact/tri checks: extent, speed and jumps of the tool, its group, where its heat goes. */
#include "fix_contact_tri.h"

#include "fix_sph_tm.h"
#include "pair_sph_tm.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "group.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace SPHTM_NS;

// in 2d the sides of the tool must reach beyond the plane of the particles
void FixContactTri::check_dimension()
{
  if (domain->dimension == 3) return;
  const tm_mesh &m = tool.mesh();
  const double need = 2.0 * pair->settings_in_use().spacing;
  if (m.lo[2] > -need || m.hi[2] < need)
    error->all(FLERR,
               "Fix contact/tri {}: the mesh of file {} spans z from {:.6g} to {:.6g}; in 2d it must be "
               "extruded along z to at least {:.6g} on both sides of z = 0: use 'scale' with "
               "three factors or 'move'",
               id, shape.file, m.lo[2], m.hi[2], need);
}

// --- motion

static constexpr double TOO_FAST = 10.0;    // times the speed of sound
static constexpr double TOO_FAR = 0.5;      // in one step, times the smallest spacing

void FixContactTri::check_speed(double speed) const
{
  const char *remedy = "check its motion (fix_modify move) and the units";
  if (!std::isfinite(speed))
    error->all(FLERR, "Fix contact/tri {}: the speed of the tool, {}, is not a finite number; {}", id, speed, remedy);
  if (sound_speed > 0.0 && speed > TOO_FAST * sound_speed)
    error->all(FLERR, "Fix contact/tri {}: the tool moves at up to {:.6g}, more than ten times the speed of sound in "
                      "the particles ({:.6g}); {}", id, speed, sound_speed, remedy);
}

void FixContactTri::note_corners(const tm_pose &pose, tm_vec3 *corner) const
{
  const double *lo = tool.mesh().lo, *hi = tool.mesh().hi;
  for (int c = 0; c < 8; c++)
    corner[c] = tm_pose_to_world(&pose, tm_vec(c & 1 ? hi[0] : lo[0], c & 2 ? hi[1] : lo[1], c & 4 ? hi[2] : lo[2]));
}

// a tool that moves far in one step, whose end is given here, passes particles unseen or finds them deep inside
void FixContactTri::check_jump(const tm_pose &end)
{
  tm_vec3 corner[8];
  note_corners(end, corner);
  const bool step = !update->setupflag;
  double moved = 0.0;
  for (int c = 0; c < 8; c++) {
    double d = tm_vec_norm(tm_vec_sub(corner[c], seen ? last_corner[c] : corner[c]));    // NaN where it is nowhere
    // on a closed path it may be back where it was
    if (step && !motion.by_variable())
      d = std::max(d, state->step_dt() * tm_vec_norm(tm_pose_velocity_at(&end, corner[c])));
    if (!(d <= moved)) moved = d;
    if (std::isnan(d)) break;
  }
  std::copy_n(corner, 8, last_corner);
  seen = true;
  const double dp = pair->smallest_spacing(), dt = state->step_dt();
  if (moved <= TOO_FAR * dp) return;
  if (!std::isfinite(moved))
    error->all(FLERR, "Fix contact/tri {} stops at step {}: the place of the tool is not a finite number; check {}", id,
               update->ntimestep, motion.by_variable() ? "the variables of fix_modify move" : "its motion");
  const std::string far = fmt::format("the tool has moved by {:.6g}, {:.3g} times the smallest particle spacing,",
                                      moved, moved / dp);
  if (step)
    error->all(FLERR,
               "Fix contact/tri {} stops at step {}: {} in one step of {:.6g}, a speed of {:.6g}; beyond {} times the "
               "spacing it passes particles unseen. Lower the time step (dt/max of fix sph/tm, or its dt), or check "
               "the {}", id, update->ntimestep, far, dt, moved / dt, TOO_FAR,
               motion.by_variable() ? "variables of fix_modify move: one may jump" : "speed of the tool");
  error->all(FLERR,
             "Fix contact/tri {} stops at step {}: {} since the {}; it must not jump between runs. Check the "
             "variables of fix_modify move, let the tool travel there in a run, or give a new fix contact/tri with "
             "another 'move'", id, update->ntimestep, far, restored ? "last step or the restart file" : "last step");
}

// --- the particles it acts on

void FixContactTri::warn_of_empty_group()
{
  if (warned_empty || group->count(igroup) > 0) return;
  warned_empty = true;
  if (comm->me == 0)
    error->warning(FLERR, "Fix contact/tri {}: its group {} has no particles; the tool touches nothing", id,
                   group->names[igroup]);
}

// types of solids that have particles in the group, on any rank
std::vector<int> FixContactTri::types_in_reach() const
{
  std::vector<int> mine(atom->ntypes + 1, 0), all(mine), types;
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & groupbit) mine[atom->type[i]] = 1;
  MPI_Allreduce(mine.data(), all.data(), (int) mine.size(), MPI_INT, MPI_MAX, world);
  for (int t = 1; t <= atom->ntypes; t++)
    if (all[t] && pair->materials()[t].body == TM_BODY_SOLID) types.push_back(t);
  return types;
}

// the first of these types that has no heat constants, or 0
int FixContactTri::type_without_heat(const std::vector<int> &types) const
{
  for (const int t : types)
    if (!pair->materials()[t].heat) return t;
  return 0;
}

/* Friction heat needs heat as a state, which is on where the materials have what it takes. Where some of them have
   not, it cannot be: the heat is lost, and that is said. */
void FixContactTri::ask_for_heat()
{
  if (heat_given) state->need(TM_FX_HEAT, fmt::format("fix contact/tri {} exchanges heat", id));
  const char *keyword = request.share >= 0.0 ? "share" : request.effusivity >= 0.0 ? "effusivity" : nullptr;
  const std::vector<int> touched = types_in_reach();
  if ((!rubs() && !keyword) || touched.empty()) return;

  std::vector<int> every(atom->ntypes);
  for (int t = 1; t <= atom->ntypes; t++) every[t - 1] = t;
  const int bare = type_without_heat(touched), lacks = bare ? bare : type_without_heat(every);
  const bool some = std::any_of(touched.begin(), touched.end(), [&](int t) { return pair->materials()[t].heat; });
  const std::string what = rubs() ? "friction" : keyword;
  if (!lacks) state->need(TM_FX_HEAT, fmt::format("{} of fix contact/tri {}", what, id));
  if (state->has(TM_FX_HEAT) || warned_heat) return;
  warned_heat = true;
  if (comm->me) return;
  if (!lacks)
    error->warning(FLERR, "Fix contact/tri {}: heat is forced off in fix sph/tm: {}", id,
                   rubs() ? "the heat of its friction warms nothing" : what + " has no use");
  else if (keyword)
    error->warning(FLERR, "Fix contact/tri {}: {} has no use, heat is off: type {} ({}) has no heat constants", id,
                   keyword, lacks, pair->material_name(lacks));
  else if (some)
    error->warning(FLERR, "Fix contact/tri {}: the heat of its friction warms nothing, heat is off: type {} ({}) has "
                          "no heat constants", id, lacks, pair->material_name(lacks));
}
