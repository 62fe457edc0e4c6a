#include "active_region.h"

#include "argument.h"
#include "scene.h"

#include "atom.h"
#include "domain.h"
#include "error.h"
#include "force.h"
#include "modify.h"
#include "neighbor.h"
#include "pair.h"
#include "region.h"
#include "update.h"
#include "utils.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

namespace {
constexpr int EVERY = 20;                          // steps
constexpr int RESTS = 0, AWAKE = 1, MOVING = 2;    // flags of particles and their ghosts
}    // namespace

ActiveRegion::ActiveRegion(LAMMPS *lmp, ParticleState &s, Backend &where) :
    Pointers(lmp), state(s), loops(where), active(where), flag(Backend::host())
{
}

// active region ID speed V [every N] | near D speed V [every N] | no
void ActiveRegion::read(Keywords &k)
{
  every = 0;
  if (k.take("no")) return;
  k.need(4);
  region_id.clear();
  distance = 0.0;
  if (k.second("region", "near")) distance = k.positive("near");
  else region_id = k.value();
  if (!k.take("speed"))
    error->all(FLERR, "{} needs 'speed V' behind its region or distance: slower particles outside may sleep", k.what());
  still = k.positive("speed");
  every = k.take("every") ? k.integer(1, 1000000, "every") : EVERY;
  state.need(TM_FX_ACTIVE, "fix sph/tm active");
}

void ActiveRegion::check(const Scene &scene, bool audits)
{
  if (!on()) return;
  const auto refuse = [this](const std::string &what) {
    error->all(FLERR, "Fix sph/tm {} active does not work with {}", state.id(), what);
  };
  if (!loops.shared())
    refuse("the loops of a GPU, which run over all particles; leave 'active' out, or run on the host");
  if (sizeof(tagint) != sizeof(int)) refuse("a LAMMPS built with BIGBIG: rows sort by tags of 32 bits");
  if (atom->molecular != Atom::ATOMIC) refuse("atoms with bonds, whose pairs its rows do not leave out");
  if (utils::strmatch(force->pair_style, "^hybrid"))
    refuse("pair_style " + std::string(force->pair_style) +
           ", whose choice of pairs its rows know nothing of; say with 'pair_coeff i j none' which types do not meet");
  if (!modify->get_fix_by_style("^adapt/neigh").empty()) refuse("fix adapt/neigh");
  if (neighbor->nex_type || neighbor->nex_group || neighbor->nex_mol)
    refuse("'neigh_modify exclude', which its rows know nothing of; say with 'pair_coeff i j none' which types do not "
           "meet");
  if (audits) refuse("audit");
  if (state.has(TM_FX_BODIES)) refuse("pair_coeff contact");
  if (state.has(TM_FX_XSPH)) refuse("pair_style xsph");
  if ((state.has(TM_FX_CORRECTION) || state.has(TM_FX_HOURGLASS)) && !state.has(TM_FX_ONE_PASS))
    refuse("gradient correction or hourglass control in passes of their own; use both, without artstress, as is the "
           "default");
  if (!region_id.empty() && !domain->get_region_by_id(region_id))
    error->all(FLERR, "Fix sph/tm {} active: there is no region {}", state.id(), region_id);
  if (region_id.empty() && scene.contact_probes().empty())
    error->all(FLERR, "Fix sph/tm {} active near {}: there is no fix contact/tri to be near to", state.id(), distance);
}

double ActiveRegion::reach() const { return state.model().support() + neighbor->skin; }

/* ---------------------------------------------------------------------- who sleeps */

// none may come within reach of one that has no row yet
void ActiveRegion::check_way()
{
  double mine = std::max(way, tool_way), all;
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_MAX, world);
  way = tool_way = 0.0;
  if (all > neighbor->skin)
    error->all(FLERR,
               "Fix sph/tm {} active: particles or tools move by up to {:.4g} in {} steps, more than the skin {:.4g}; "
               "lower 'every'",
               state.id(), all, every, neighbor->skin);
}

// not for its neighbors' sake
bool ActiveRegion::wants(const std::vector<ContactProbe::Box> &tools, Region *region, int i) const
{
  const double *x = atom->x[i];
  if (state.model().materials()[atom->type[i]].body != TM_BODY_SOLID) return true;
  if (region && region->match(x[0], x[1], x[2])) return true;
  const double from_tool = region ? reach() : std::max(distance, reach());
  return std::any_of(tools.begin(), tools.end(),
                     [&](const ContactProbe::Box &t) { return t.is_near(x, from_tool, domain->dimension); });
}

// particles that have one with at least this flag within reach
void ActiveRegion::find_near(const Scene &scene, Pair *pair, tm_real least)
{
  scene.results().communicate(pair, flag, 1);
  tm_active_args a;
  a.flag = flag.host_read();
  a.cells = finder->cells_with(a.flag, least);
  a.least = least;
  a.radius = reach();
  a.found = found.data();
  PairLoops::of(loops).active_near(loops, atom->nlocal, a, 0u);
}

void ActiveRegion::decide(const Scene &scene, Pair *pair)
{
  check_way();
  const int n = atom->nlocal;
  const tm_state s = state.arrays();
  Region *region = region_id.empty() ? nullptr : domain->get_region_by_id(region_id);
  if (region) region->prematch();
  std::vector<ContactProbe::Box> tools;
  for (const ContactProbe *p : scene.contact_probes()) tools.push_back(p->box());
  flag.make_room(true, (size_t) n + atom->nghost + 1);
  found.resize(n + 1);
  tm_real *f = flag.host_write();
  for (int i = 0; i < n; i++) {
    const double *v = atom->v[i];
    const bool moves = v[0] * v[0] + v[1] * v[1] + v[2] * v[2] >= still * still;
    f[i] = moves ? MOVING : wants(tools, region, i) ? AWAKE : RESTS;
  }
  find_near(scene, pair, MOVING);
  f = flag.host_write();
  for (int i = 0; i < n; i++)
    if (found[i]) f[i] = std::max(f[i], (tm_real) AWAKE);
  find_near(scene, pair, AWAKE);
  double energy = 0.0;
  tm_real *kind = state.fields()[TM_F_ACTIVE].host_write();
  for (int i = 0; i < n; i++) {
    const double *v = atom->v[i];
    const int now = f[i] > RESTS ? TM_ACTIVE_MOVES : found[i] ? TM_ACTIVE_EDGE : TM_ACTIVE_ASLEEP;
    if (now != TM_ACTIVE_MOVES && (now != kind[i] || v[0] != 0.0 || v[1] != 0.0 || v[2] != 0.0))
      energy += tm_active_rest(i, &s);
    kind[i] = now;
  }
  state.energy().add(EnergyBalance::ARTIFICIAL, energy);
  at_rest += energy;
  known = true;
}

// of this rank, from the field
void ActiveRegion::list()
{
  const tm_real *kind = state.fields()[TM_F_ACTIVE].host_read();
  which.clear();
  edge.clear();
  asleep.clear();
  for (int i = 0; i < atom->nlocal; i++) {
    const int now = (int) kind[i];
    if (now == TM_ACTIVE_EDGE) edge.push_back(i);
    (now == TM_ACTIVE_ASLEEP ? asleep : which).push_back(i);
  }
  active.set(which);
}

void ActiveRegion::renew(const Scene &scene, Pair *pair)
{
  if (!finder) finder = std::make_unique<RowSearch>(lmp, loops);
  finder->sort(reach());
  if (!known) {    // of a restart file
    const tm_real *kind = state.fields()[TM_F_ACTIVE].host_read();
    const double mine = atom->nlocal ? *std::max_element(kind, kind + atom->nlocal) : 0.0;
    double most;
    MPI_Allreduce(&mine, &most, 1, MPI_DOUBLE, MPI_MAX, world);
    if (update->setupflag) known = most > 0.0;
  }
  if (!update->setupflag && due(update->ntimestep)) decide(scene, pair);
  list();
  scene.rows().build(*finder, which, state.has(TM_FX_CONDUCTION));
}

/* ---------------------------------------------------------------------- in a step */

void ActiveRegion::insulate(const tm_records &rec)
{
  for (size_t k = 0; rec.heat && k < asleep.size(); k++) tm_heat_record(&rec, asleep[k])[tm_part(TM_REC_K)] = 0.0;
}

void ActiveRegion::hold(double *force) const
{
  for (const int i : edge) std::fill_n(force + 3 * (size_t) i, 3, 0.0);
}

void ActiveRegion::moved(const Scene &scene, double speed2, double dt)
{
  double tools = 0.0;
  for (const ContactProbe *p : scene.contact_probes()) tools = std::max(tools, p->box().top_speed);
  way += sqrt(speed2) * dt;
  tool_way += tools * dt;
  steps++;
  sum_moving += (double) (which.size() - edge.size());
  sum_edge += (double) edge.size();
}

std::string ActiveRegion::in_words()
{
  if (!on()) return "";
  const double mine[3] = {sum_moving, sum_edge, at_rest};
  double all[3];
  MPI_Allreduce(mine, all, 3, MPI_DOUBLE, MPI_SUM, world);
  const double whole = std::max(steps * atom->natoms, 1.0);
  return fmt::format(
      "{:.1f} % of the particles, and {:.1f} % at its edge; kinetic energy of those that came to rest {:.4g}",
      100.0 * all[0] / whole, 100.0 * all[1] / whole, all[2] / state.model().units().energy);
}

double ActiveRegion::bytes() const
{
  return flag.bytes() + found.size() + sizeof(int) * (double) (which.size() + edge.size() + asleep.size()) +
         (finder ? finder->bytes() : 0.0);
}

}    // namespace SPHTM_NS
