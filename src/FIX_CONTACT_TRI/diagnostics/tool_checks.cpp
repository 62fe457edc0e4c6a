#include "tool_checks.h"

#include "model.h"
#include "particle_state.h"
#include "tool_query.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix.h"
#include "group.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

ToolChecks::ToolChecks(LAMMPS *l, const Fix &f, const ContactSettings &s, const TriTool &t) :
    lmp(l), fix(f), set(s), tool(t), who(fmt::format("Fix contact/tri {}", f.id))
{
}

void ToolChecks::body_material(const Model &model) const
{
  if (set.body_type && model.materials()[set.body_type].body != TM_BODY_HEAT)
    lmp->error->all(FLERR, "{} particles: type {} must be a material that only conducts heat", who, set.body_type);
}

// in 2d the sides of the tool must reach beyond the plane of the particles
void ToolChecks::extent(double spacing) const
{
  if (lmp->domain->dimension == 3) return;
  const tm_mesh &m = tool.mesh();
  const double need = 2.0 * spacing;
  if (m.lo[2] > -need || m.hi[2] < need)
    lmp->error->all(FLERR,
                    "{}: the mesh of file {} spans z from {:.6g} to {:.6g}; in 2d it must be "
                    "extruded along z to at least {:.6g} on both sides of z = 0: use 'scale' with "
                    "three factors or 'move'",
                    who, set.shape.file, m.lo[2], m.hi[2], need);
}

// --- motion

static constexpr double TOO_FAST = 10.0;    // times the speed of sound
static constexpr double TOO_FAR = 0.5;      // in one step, times the smallest spacing

void ToolChecks::speed(double speed, double sound_speed) const
{
  const char *remedy = "check its motion (fix_modify move) and the units";
  if (!std::isfinite(speed))
    lmp->error->all(FLERR, "{}: the speed of the tool, {}, is not a finite number; {}", who, speed, remedy);
  if (sound_speed > 0.0 && speed > TOO_FAST * sound_speed)
    lmp->error->all(FLERR,
                    "{}: the tool moves at up to {:.6g}, more than ten times the speed of sound in "
                    "the particles ({:.6g}); {}",
                    who, speed, sound_speed, remedy);
}

void ToolChecks::corners(const tm_pose &pose, tm_vec3 *corner) const
{
  const double *lo = tool.mesh().lo, *hi = tool.mesh().hi;
  for (int c = 0; c < 8; c++)
    corner[c] = tm_pose_to_world(&pose, tm_vec(c & 1 ? hi[0] : lo[0], c & 2 ? hi[1] : lo[1], c & 4 ? hi[2] : lo[2]));
}

// of eight corners along axis k: lowest, highest
static std::pair<double, double> range(const tm_vec3 *corner, int k)
{
  double least = 1e300, most = -1e300;
  for (int c = 0; c < 8; c++) {
    const double x = k == 0 ? corner[c].x : k == 1 ? corner[c].y : corner[c].z;
    least = std::min(least, x);
    most = std::max(most, x);
  }
  return {least, most};
}

void ToolChecks::jump(const tm_pose &end, bool by_variable, double dt, double dp)
{
  tm_vec3 corner[8];
  corners(end, corner);
  const bool step = !lmp->update->setupflag;
  double moved = 0.0;
  for (int c = 0; c < 8; c++) {
    double d = tm_vec_norm(tm_vec_sub(corner[c], seen ? last_corner[c] : corner[c]));    // NaN where it is nowhere
    // on a closed path it may be back where it was
    if (step && !by_variable) d = std::max(d, dt * tm_vec_norm(tm_pose_velocity_at(&end, corner[c])));
    if (!(d <= moved)) moved = d;
    if (std::isnan(d)) break;
  }
  std::copy_n(corner, 8, last_corner);
  seen = true;
  if (moved <= TOO_FAR * dp) return;
  const std::string stops = fmt::format("{} stops at step {}:", who, lmp->update->ntimestep);
  if (!std::isfinite(moved))
    lmp->error->all(FLERR, "{} the place of the tool is not a finite number; check {}", stops,
                    by_variable ? "the variables of fix_modify move" : "its motion");
  const std::string far =
      fmt::format("the tool has moved by {:.6g}, {:.3g} times the smallest particle spacing,", moved, moved / dp);
  if (step)
    lmp->error->all(FLERR,
                    "{} {} in one step of {:.6g}, a speed of {:.6g}; beyond {} times the spacing it passes particles "
                    "unseen. Lower the time step (dt/max of fix sph/tm, or its dt), or check the {}",
                    stops, far, dt, moved / dt, TOO_FAR,
                    by_variable ? "variables of fix_modify move: one may jump" : "speed of the tool");
  lmp->error->all(FLERR,
                  "{} {} since the {}; it must not jump between runs. Check the variables of fix_modify move, let the "
                  "tool travel there in a run, or give a new fix contact/tri with another 'move'",
                  stops, far, restored ? "last step or the restart file" : "last step");
}

void ToolChecks::left_out()
{
  if (!warned_left_out && lmp->comm->me == 0)
    lmp->error->warning(FLERR, "{}: made after the last set-up: a run with 'pre no' goes on without it", who);
  warned_left_out = true;
}

void ToolChecks::pressed(const tm_contact_result &sums, double spacing)
{
  const double thickness = tool.mesh().closed && !set.two_sided ? tool.thickness(lmp->domain->dimension) : 1e300;
  if (sums.inner > std::min(0.5 * spacing, 0.4 * thickness) && !warned_deep) {
    warned_deep = true;
    const bool thin = thickness < 2.0 * spacing;
    lmp->error->warning(FLERR,
                        "{}: a particle's center lies {:.2f} spacings behind the "
                        "surface; beyond {} it is {}: raise penalty or lower the speed{}",
                        who, sums.inner / spacing, thin ? fmt::format("{:.2f}", 0.5 * thickness / spacing) : "1",
                        thin ? "pushed out on the other side of the tool, which is too thin here"
                             : "no longer pushed out",
                        set.overlap_allowed ? ", or start without overlap" : "");
  }
  if (sums.faced && !warned_faced) {
    warned_faced = true;
    lmp->error->warning(FLERR,
                        "{}: pressed from two opposite sides: {} particles in step {}; a sheet of one row has no "
                        "strain across and resists several times too much: give it 6 rows or more",
                        who, sums.faced, lmp->update->ntimestep);
  }
}

void ToolChecks::restarted_at(const tm_pose &pose)
{
  restored = seen = true;
  corners(pose, last_corner);
}

// --- the particles it acts on

void ToolChecks::empty_group()
{
  Group *group = lmp->group;
  if (warned_empty || group->count(fix.igroup) > 0) return;
  warned_empty = true;
  if (lmp->comm->me == 0)
    lmp->error->warning(FLERR, "{}: its group {} has no particles; the tool touches nothing", who,
                        group->names[fix.igroup]);
}

void ToolChecks::filling(int groups) const
{
  const Atom *atom = lmp->atom;
  bigint mine[2] = {0, 0}, all[2];
  for (int i = 0; i < atom->nlocal; i++) {
    if (atom->type[i] != set.body_type) continue;
    mine[0]++;
    mine[1] += !(atom->mask[i] & groups);
  }
  MPI_Allreduce(mine, all, 2, MPI_LMP_BIGINT, MPI_SUM, lmp->world);
  if (all[1])
    lmp->error->all(
        FLERR,
        "{} particles {}: {} of the {} particles of type {} are not in its group {}: they would stay where they "
        "are while the tool moves; give it a group that has them and what it touches, for example all",
        who, set.body_type, all[1], all[0], set.body_type, lmp->group->names[fix.igroup]);
}

void ToolChecks::conductors(const Model &model, const std::vector<int> &fillings)
{
  if (warned_conductors) return;
  for (const int t : types_in_group(model, TM_BODY_HEAT)) {
    if (std::count(fillings.begin(), fillings.end(), t)) continue;
    warned_conductors = true;
    if (lmp->comm->me == 0)
      lmp->error->warning(FLERR,
                          "{}: particles of type {} ({}) only conduct heat (body heat): the tool neither touches nor "
                          "heats them. Heat them with fix sph/tm/heat, or leave out 'body heat'",
                          who, t, model.material_name(t));
    return;
  }
}

static constexpr double FAR_AWAY = 3.0, FAR_LARGER = 100.0;    // over the diagonal of the simulation box

void ToolChecks::far_from_box(const tm_pose &pose, double spacing) const
{
  tm_vec3 corner[8];
  corners(pose, corner);
  const double *lo = lmp->domain->boxlo_bound, *hi = lmp->domain->boxhi_bound;
  if (lmp->domain->triclinic == 0) lo = lmp->domain->boxlo, hi = lmp->domain->boxhi;
  double gap2 = 0.0, box2 = 0.0, tool2 = 0.0;
  for (int k = 0; k < lmp->domain->dimension; k++) {
    const auto [least, most] = range(corner, k);
    const double gap = std::max({0.0, lo[k] - most, least - hi[k]});
    gap2 += gap * gap;
    box2 += (hi[k] - lo[k]) * (hi[k] - lo[k]);
    tool2 += (most - least) * (most - least);
  }
  const double gap = sqrt(gap2 / box2), size = sqrt(tool2 / box2);
  const char *remedy = "check 'scale', 'move' and the units of the file";
  if (lmp->comm->me) return;
  if (gap > FAR_AWAY)
    lmp->error->warning(FLERR, "{}: the tool is {:.6g} away from the simulation box, {:.3g} times its diagonal; {}",
                        who, sqrt(gap2), gap, remedy);
  else if (size > FAR_LARGER)
    lmp->error->warning(FLERR, "{}: the tool is {:.3g} times as large as the simulation box; {}", who, size, remedy);
  else if (tool2 < spacing * spacing)
    lmp->error->warning(FLERR, "{}: the tool is {:.3g} across, {:.3g} of the spacing of the particles; {}", who,
                        sqrt(tool2), sqrt(tool2) / spacing, remedy);
}

// a tool has no images: it ends where a face of the box lets particles through
void ToolChecks::periodic(const tm_pose &pose) const
{
  tm_vec3 corner[8];
  corners(pose, corner);
  const Domain *domain = lmp->domain;
  for (int k = 0; k < domain->dimension; k++) {
    const auto [least, most] = range(corner, k);
    const double lo = domain->boxlo[k], hi = domain->boxhi[k], small = 1e-6 * (hi - lo);
    const bool below = least<lo - small, above = most> hi + small, inside = most > lo && least < hi;
    if (!domain->periodicity[k] || domain->triclinic || !inside || below == above) continue;
    if (lmp->comm->me == 0)
      lmp->error->warning(
          FLERR,
          "{}: the tool goes from {:.6g} to {:.6g} along {} and crosses a periodic face of the box ({:.6g} "
          "to {:.6g}); a tool has no periodic images, so what lies beyond the face touches nothing: move "
          "it inside, or let it reach beyond both faces",
          who, least, most, "xyz"[k], lo, hi);
  }
}

void ToolChecks::heat_without_contact(bool moves, bool pressed)
{
  if (!set.conducts() || moves || pressed || warned_no_contact) return;
  warned_no_contact = true;
  if (lmp->comm->me == 0)
    lmp->error->warning(
        FLERR,
        "{}: no particle has pressed on the tool in this run, so no heat has passed ('heat' needs a contact force, and "
        "particles that only touch, or shrink away, have none); let it press, or heat with fix sph/tm/heat",
        who);
}

void ToolChecks::untouched(const ToolQuery &q, const Model &model) const
{
  Atom *atom = lmp->atom;
  bigint mine = 0, within;
  for (int i = 0; tool.mesh().closed && i < atom->nlocal; i++) {
    if (atom->mask[i] & fix.groupbit || model.materials()[atom->type[i]].body != TM_BODY_SOLID) continue;
    tm_touch touch[TM_TOUCH_MAX];
    const int n = q.touch(tm_load3(atom->x[i]), 0.5 * q.deep, touch);
    for (int k = 0; k < n; k++)
      if (touch[k].distance < 0.0) {
        mine++;
        break;
      }
  }
  MPI_Allreduce(&mine, &within, 1, MPI_LMP_BIGINT, MPI_SUM, lmp->world);
  if (lmp->comm->me) return;
  utils::logmesg(lmp, "contact/tri {}: no particle has touched it in this run\n", fix.id);
  if (within)
    lmp->error->warning(
        FLERR,
        "{}: {} particles of metal that are not in its group ({}) lie within its mesh: the tool does not "
        "act on them",
        who, within, lmp->group->names[fix.igroup]);
}

static constexpr double INERT = 0.05;    // rho v^2 over the flow stress

void ToolChecks::inertia(const Model &model, double s, double speed, double temperature)
{
  if (s <= 1.0 || warned_inertia) return;
  for (int t = 1; t <= lmp->atom->ntypes; t++) {
    const tm_material &m = model.materials()[t];
    if (m.body != TM_BODY_SOLID || tm_strength_flow(m.strength) == TM_FLOW_NONE) continue;
    const double pressure = m.rho0 * speed * speed, share = pressure / tm_flow_stress(&m, 0.0, 0.0, temperature);
    if (!(share > INERT)) continue;
    warned_inertia = true;
    if (lmp->comm->me == 0)
      lmp->error->warning(
          FLERR,
          "{}: with time/scale {:.6g} the tool moves at {:.4g}, and the inertia rho v^2 of type {} ({}) is "
          "{:.2g} of its first flow stress; about 0.01 changes nothing, at 1 the force of a cut was 40 % too high: lower "
          "speed and time/scale",
          who, s, speed, t, model.material_name(t), share);
    return;
  }
}

// types of this kind of body (TM_BODY_SOLID ...) that have particles in the group, on any rank
std::vector<int> ToolChecks::types_in_group(const Model &model, int body) const
{
  Atom *atom = lmp->atom;
  std::vector<int> mine(atom->ntypes + 1, 0), all(mine), types;
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & fix.groupbit) mine[atom->type[i]] = 1;
  MPI_Allreduce(mine.data(), all.data(), (int) mine.size(), MPI_INT, MPI_MAX, lmp->world);
  for (int t = 1; t <= atom->ntypes; t++)
    if (all[t] && model.materials()[t].body == body) types.push_back(t);
  return types;
}

// the first of these types that has no heat constants, or 0
static int type_without_heat(const std::vector<int> &types, const tm_material *material)
{
  for (const int t : types)
    if (!material[t].heat) return t;
  return 0;
}

/* Friction heat needs heat as a state, which is on where the materials have what it takes. Where some of them have
   not, it cannot be: the heat is lost, with a warning. */
void ToolChecks::heat(ParticleState &state)
{
  const Model &model = state.model();
  if (set.heat_given) state.need(TM_FX_HEAT, fmt::format("fix contact/tri {} exchanges heat", fix.id));
  const char *keyword = set.share >= 0.0 ? "share" : set.effusivity >= 0.0 ? "effusivity" : nullptr;
  const bool friction = set.has_friction();
  const std::vector<int> touched = types_in_group(model, TM_BODY_SOLID);
  if ((!friction && !keyword) || touched.empty()) return;

  const tm_material *material = model.materials();
  std::vector<int> every(lmp->atom->ntypes);
  std::iota(every.begin(), every.end(), 1);
  const int bare = type_without_heat(touched, material), lacks = bare ? bare : type_without_heat(every, material);
  const bool some = std::any_of(touched.begin(), touched.end(), [&](int t) { return material[t].heat; });
  const std::string what = friction ? "friction" : keyword;
  if (!lacks) state.need(TM_FX_HEAT, fmt::format("{} of fix contact/tri {}", what, fix.id));
  if (state.has(TM_FX_HEAT) || warned_heat) return;
  warned_heat = true;
  if (lmp->comm->me) return;
  const std::string bare_type =
      lacks ? fmt::format("type {} ({}) has no heat constants", lacks, model.material_name(lacks)) : "";
  if (!lacks)
    lmp->error->warning(FLERR, "{}: heat is forced off in fix sph/tm: {}", who,
                        friction ? "the heat of its friction warms nothing" : what + " has no use");
  else if (keyword) lmp->error->warning(FLERR, "{}: {} has no use, heat is off: {}", who, keyword, bare_type);
  else if (some)
    lmp->error->warning(FLERR, "{}: the heat of its friction warms nothing, heat is off: {}", who, bare_type);
}

}    // namespace SPHTM_NS
