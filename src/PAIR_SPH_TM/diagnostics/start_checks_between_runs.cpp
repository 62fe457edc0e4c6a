// Of the checks at the start those that compare with the end of the last run: what a script has changed in between
#include "start_checks.h"

#include "all_ranks.h"
#include "restart_block.h"
#include "scene.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

// a fix that is written again would begin with an unstressed body
void StartChecks::check_begun(bool begin_anew)
{
  if (state.history().begun() || begin_anew || !scene.results().has_stepped()) return;
  error->all(FLERR,
             "Fix sph/tm {}: the state of the particles (stress, plastic strain, temperature) was "
             "lost with the fix "
             "that was removed or written again after its first step; change settings with "
             "fix_modify, or begin "
             "from an unstressed body with the keyword 'state new'",
             state.id());
}

std::vector<bigint> StartChecks::particles_of_types(bool old_only)
{
  const double *rho = state.fields()[TM_F_RHO].host_read();
  std::vector<bigint> mine(atom->ntypes + 1, 0), all(atom->ntypes + 1, 0);
  for (int i = 0; i < atom->nlocal; i++) mine[atom->type[i]] += !old_only || rho[i] != 0.0;
  MPI_Allreduce(mine.data(), all.data(), atom->ntypes + 1, MPI_LMP_BIGINT, MPI_SUM, world);
  return all;
}

// where LAMMPS has them in the next step
static std::array<double, 3> place_of(Domain *domain, const double *x, imageint image)
{
  std::array<double, 3> p = {x[0], x[1], x[2]};
  domain->remap(p.data(), image);
  return p;
}

std::vector<uint64_t> StartChecks::hash_of_types(bool positions)
{
  std::vector<uint64_t> mine(atom->ntypes + 1, 0), all(atom->ntypes + 1, 0);
  for (int i = 0; i < atom->nlocal; i++) {
    const int64_t tag = atom->tag[i];
    const std::array<double, 3> p = place_of(domain, atom->x[i], atom->image[i]);
    const uint64_t hash = positions ? hash_bytes(&p, sizeof(p)) : hash_bytes(&tag, sizeof(tag));
    mine[0] += hash;
    mine[atom->type[i]] += hash;
  }
  MPI_Allreduce(mine.data(), all.data(), atom->ntypes + 1, MPI_UINT64_T, MPI_SUM, world);
  return all;
}

// of the places of all particles, in any order
uint64_t StartChecks::places_hash()
{
  uint64_t mine = 0, all;
  for (int i = 0; i < atom->nlocal; i++) {
    const struct {
      std::array<double, 3> x;
      int64_t tag;
    } p = {place_of(domain, atom->x[i], atom->image[i]), atom->tag[i]};
    mine += hash_bytes(&p, sizeof(p));
  }
  MPI_Allreduce(&mine, &all, 1, MPI_UINT64_T, MPI_SUM, world);
  return all;
}

std::vector<std::array<double, 3>> StartChecks::arms_of_types()
{
  const int types = atom->ntypes + 1;
  std::vector<tagint> mine(2 * types, MAXTAGINT), ends(2 * types);    // the lowest, and less the highest
  for (int i = 0; i < atom->nlocal; i++) {
    tagint *of = mine.data() + 2 * (ptrdiff_t) atom->type[i];
    of[0] = std::min(of[0], atom->tag[i]);
    of[1] = std::min(of[1], -atom->tag[i]);
  }
  MPI_Allreduce(mine.data(), ends.data(), 2 * types, MPI_LMP_TAGINT, MPI_MIN, world);
  std::vector<std::array<double, 3>> part(types), arms(types);
  for (int i = 0; i < atom->nlocal; i++) {
    const int t = atom->type[i];
    double x[3];
    domain->unmap(atom->x[i], atom->image[i], x);
    for (int k = 0; k < 3; k++) {
      if (atom->tag[i] == ends[2 * t]) part[t][k] -= x[k];
      if (atom->tag[i] == -ends[2 * t + 1]) part[t][k] += x[k];
    }
  }
  MPI_Allreduce(part.data(), arms.data(), 3 * types, MPI_DOUBLE, MPI_SUM, world);
  return arms;
}

double StartChecks::total_mass()
{
  double mine = 0.0, all;
  for (int i = 0; i < atom->nlocal; i++) mine += atom->rmass_flag ? atom->rmass[i] : atom->mass[atom->type[i]];
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return all;
}

void StartChecks::remember_particles()
{
  if (!scene.is_current(&state)) return;
  state.atoms().to_host();
  last_run.types = particles_of_types(false);
  last_run.tags = hash_of_types(false);
  last_run.positions = hash_of_types(true);
  for (auto *values : {&last_run.density, &last_run.bulk, &last_run.shear}) values->clear();
  last_run.flows.clear();
  for (int t = 0; t <= atom->ntypes; t++) {
    const tm_material &m = model().materials()[t];
    last_run.density.push_back(m.rho0);
    last_run.bulk.push_back(m.bulk);
    last_run.shear.push_back(m.shear);
    last_run.flows.push_back(tm_strength_flow(m.strength) != TM_FLOW_NONE);
  }
  const tm_nearest c = scene.results().nearest();
  const double mine[4] = {c.sum, c.count, c.density, (double) atom->nlocal};
  double all[4];
  MPI_Allreduce(mine, all, 4, MPI_DOUBLE, MPI_SUM, world);
  MPI_Allreduce(&c.distance, &last_run.nearest, 1, MPI_DOUBLE, MPI_MIN, world);
  last_run.mean_nearest = all[0] / std::max(all[1], 1.0);
  last_run.pair_density = all[2] / std::max(all[3], 1.0);
  last_run.mass = total_mass();
  const double depth = state.energy().deepest_of_bodies();
  MPI_Allreduce(&depth, &last_run.depth, 1, MPI_DOUBLE, MPI_MAX, world);
  last_run.places = places_hash();
  last_run.arms = arms_of_types();
  last_run.particles = (bigint) all[3];
}

// particles that a command moved against each other: their stress and density know nothing of it
void StartChecks::check_strain(const tm_nearest &c)
{
  state.atoms().to_host();
  state.history().set_moved(places_hash() != last_run.places);
  if (!state.history().moved_since_last_run()) return;
  const double mine[4] = {c.sum, c.count, c.density, (double) atom->nlocal};
  double all[4];
  MPI_Allreduce(mine, all, 4, MPI_DOUBLE, MPI_SUM, world);
  if ((bigint) all[3] != last_run.particles) return;
  const double near = all[0] / std::max(all[1], 1.0) / std::max(last_run.mean_nearest, 1e-300);
  const double dense = all[2] / std::max(all[3], 1.0) / std::max(last_run.pair_density, 1e-300);
  constexpr double STOPS = 0.1, WARNS = 0.001;
  const double worst = std::max(fabs(near - 1.0), fabs(dense - 1.0));
  if (worst < WARNS) return check_turned();
  const std::string text = fmt::format(
      "Fix sph/tm {}: particles were moved against each other after the last run (nearest neighbors on the mean {:.4g} "
      "times as far apart, {:.4g} times as dense); their stress and density know nothing of it. Bodies are moved "
      "as a whole, and strained by velocities in a run",
      state.id(), near, dense);
  if (worst > STOPS) error->all(FLERR, text);
  if (comm->me == 0) error->warning(FLERR, text);
}

// bodies that a command turned: their stress keeps its directions
void StartChecks::check_turned()
{
  const std::vector<std::array<double, 3>> now = arms_of_types();
  for (int t = 1; t <= atom->ntypes; t++) {
    double a2 = 0.0, b2 = 0.0, turn2 = 0.0;
    for (int k = 0; k < 3; k++) {
      const double a = last_run.arms[t][k], b = now[t][k];
      a2 += a * a;
      b2 += b * b;
      turn2 += (b - a) * (b - a);
    }
    constexpr double AS_LONG = 1e-9, TURNED = 1e-3;
    if (comm->me || a2 == 0.0 || fabs(b2 - a2) > AS_LONG * a2 || turn2 < TURNED * TURNED * a2) continue;
    error->warning(
        FLERR,
        "Fix sph/tm {}: the particles of type {} ({}) were turned after the last run, by displace_atoms rotate or "
        "the like; their stress keeps its directions, and springs back in those. Turn bodies before "
        "their first run, or by velocities in a run",
        state.id(), t, model().material_name(t));
  }
}

static bool differs(double now, double before) { return fabs(now - before) > 1e-6 * before; }

void StartChecks::check_materials_kept(const std::vector<bigint> &particles)
{
  for (int t = 1; t <= atom->ntypes; t++) {
    if (particles[t] == 0) continue;
    const tm_material &m = model().materials()[t];
    if (differs(m.rho0, last_run.density[t]))
      error->all(FLERR,
                 "Fix sph/tm {}: the density of type {} ({}) changed from {:.6g} to {:.6g} after a run; the particles "
                 "keep theirs. Materials are given before the first run",
                 state.id(), t, model().material_name(t), last_run.density[t] / model().units().density,
                 m.rho0 / model().units().density);
    if (comm->me == 0 && (differs(m.bulk, last_run.bulk[t]) || differs(m.shear, last_run.shear[t])))
      error->warning(FLERR,
                     "Fix sph/tm {}: the elastic moduli of type {} ({}) changed after a run, bulk modulus {:.6g} to "
                     "{:.6g}, shear modulus {:.6g} to {:.6g}: strains stay, so under load the pressure and the stored "
                     "energy jump, and the energy sum with them",
                     state.id(), t, model().material_name(t), last_run.bulk[t] / model().units().stress,
                     m.bulk / model().units().stress, last_run.shear[t] / model().units().stress,
                     m.shear / model().units().stress);
    const bool flows = tm_strength_flow(m.strength) != TM_FLOW_NONE;
    if (comm->me == 0 && flows != last_run.flows[t] && !scene.contact_probes().empty())
      error->warning(
          FLERR,
          "Fix sph/tm {}: type {} ({}) {} after a run: tools meet it with another stiffness, so what touches one "
          "jumps to another force and depth",
          state.id(), t, model().material_name(t), flows ? "flows now" : "is elastic now");
  }
}

// a type has more particles than it had, or, where IDs and places are the same, others
void StartChecks::check_types_kept(const std::vector<bigint> &now)
{
  static const char *const text =
      "Fix sph/tm {}: {}particles became type {} ({}) after a run; their state belongs to another material. Set types before "
      "the first run, or delete and create the particles";
  for (int t = 1; t <= atom->ntypes; t++)
    if (now[t] > last_run.types[t])
      error->all(FLERR, text, state.id(), fmt::format("{} ", now[t] - last_run.types[t]), t, model().material_name(t));
  const std::vector<uint64_t> tags = hash_of_types(false), positions = hash_of_types(true);
  if (tags[0] != last_run.tags[0] || positions[0] != last_run.positions[0]) return;
  for (int t = 1; t <= atom->ntypes; t++)
    if (tags[t] != last_run.tags[t] && positions[t] != last_run.positions[t])
      error->all(FLERR, text, state.id(), "other ", t, model().material_name(t));
}

// before new particles get their state: which are new, and whether others have changed what they are made of
void StartChecks::look_at_changes()
{
  fresh.clear();
  if (!state.history().begun() || last_run.types.empty()) return;
  const double *rho = state.fields()[TM_F_RHO].host_read();
  std::vector<tagint> mine;
  for (int i = 0; i < atom->nlocal; i++)
    if (rho[i] == 0.0) mine.push_back(atom->tag[i]);
  fresh = of_all_ranks(mine, world);
  std::sort(fresh.begin(), fresh.end());
  const std::vector<bigint> now = particles_of_types(true);
  check_types_kept(now);
  check_materials_kept(now);
  const double mass = total_mass();
  const bigint mine_now = atom->nlocal;
  bigint particles;
  MPI_Allreduce(&mine_now, &particles, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  if (particles == last_run.particles && fresh.empty() && fabs(mass - last_run.mass) > 1e-6 * last_run.mass)
    error->all(FLERR,
               "Fix sph/tm {}: the mass of the particles changed from {:.8g} to {:.8g} after a run; it belongs to "
               "their density and volume. Masses are given before the first run",
               state.id(), last_run.mass, mass);
}

}    // namespace SPHTM_NS
