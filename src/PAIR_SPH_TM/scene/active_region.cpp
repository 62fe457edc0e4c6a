#include "active_region.h"

#include "argument.h"
#include "contact_probe.h"
#include "scene.h"

#include "atom.h"
#include "comm.h"
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
constexpr int EVERY = 20;    // steps
}    // namespace

ActiveRegion::ActiveRegion(LAMMPS *lmp, ParticleState &s, Backend &where) :
    Pointers(lmp), state(s), loops(where), active(where), which(where), edge(where), flag(where), marks(where),
    tools(where)
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

// marks particles and ghosts with at least this flag
void ActiveRegion::look_for(tm_active_args &a, const Scene &scene, Pair *pair, tm_real least)
{
  scene.results().communicate(pair, flag, 1);
  a.flag = flag.loop_write();
  a.marks = marks.loop_write();
  a.least = least;
  PairLoops::of(loops).active_mark(loops, atom->nlocal + atom->nghost, a, 0u);
  a.cells = finder->cells_with(a.marks);
}

void ActiveRegion::decide(const Scene &scene, Pair *pair)
{
  check_way();
  const PairLoops &of = PairLoops::of(loops);
  const int n = atom->nlocal;
  std::vector<tm_tool_box> boxes;
  for (const ContactProbe *p : scene.contact_probes()) boxes.push_back(p->box());
  tools.assign(boxes.data(), boxes.size());
  const size_t all = (size_t) n + atom->nghost + 1;
  flag.make_room(true, all);
  marks.make_room(true, all);
  tm_active_args a = {};
  a.state = state.arrays();
  Region *region = region_id.empty() ? nullptr : domain->get_region_by_id(region_id);
  a.inside = region ? state.atoms().inside(*region) : nullptr;
  a.tool = tools.loop_read();
  a.tools = (int) boxes.size();
  a.dimension = domain->dimension;
  a.from_tool = region ? reach() : std::max(distance, reach());
  a.still2 = still * still;
  a.radius = reach();
  a.flag = flag.loop_write();
  of.active_flag(loops, n, a, 0u);
  look_for(a, scene, pair, TM_MOVING);
  of.active_wake(loops, n, a, 0u);
  look_for(a, scene, pair, TM_AWAKE);
  const double energy = of.active_sort(loops, n, a, 0u);
  state.atoms().velocities_changed();
  state.energy().add(EnergyBalance::ARTIFICIAL, energy);
  at_rest += energy;
  known = true;
}

const tm_real *ActiveRegion::kinds() { return state.fields()[TM_F_ACTIVE].loop_read(); }

// of a restart file
void ActiveRegion::take_up_known()
{
  const double mine = PairLoops::of(loops).active_known(loops, atom->nlocal, {kinds(), 0}, 0u);
  double all;
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  known = all > 0.0;
}

// of this rank, from the field
void ActiveRegion::list()
{
  const int n = atom->nlocal;
  const PairLoops &of = PairLoops::of(loops);
  which.make_room(true, (size_t) n + 1);
  edge.make_room(true, (size_t) n + 1);
  awake = of.active_list(loops, n, {kinds(), 0}, which.loop_write());
  at_edge = of.active_list(loops, n, {kinds(), 1}, edge.loop_write());
  active.set(which.loop_read(), awake, n);
}

void ActiveRegion::renew(const Scene &scene, Pair *pair)
{
  if (!finder) finder = std::make_unique<RowSearch>(lmp, loops);
  finder->sort(reach(), state.arrays());
  if (!known && update->setupflag) take_up_known();
  if (!update->setupflag && due(update->ntimestep)) decide(scene, pair);
  list();
  scene.rows().build(*finder, which.loop_read(), awake, state.has(TM_FX_CONDUCTION));
}

/* ---------------------------------------------------------------------- in a step */

void ActiveRegion::insulate(const tm_records &rec)
{
  if (on() && rec.heat) PairLoops::of(loops).active_insulate(loops, atom->nlocal, {state.arrays(), rec}, 0u);
}

void ActiveRegion::hold(double *force)
{
  if (on() && at_edge) PairLoops::of(loops).active_hold(loops, at_edge, {force, edge.loop_read()}, 0u);
}

void ActiveRegion::moved(const Scene &scene, double speed2, double dt)
{
  double tool_speed = 0.0;
  for (const ContactProbe *p : scene.contact_probes()) tool_speed = std::max(tool_speed, p->box().top_speed);
  if (!warned_speed && tool_speed > 0.0 && still > 0.2 * tool_speed) {
    warned_speed = true;
    if (comm->me == 0)
      error->warning(
          FLERR,
          "Fix sph/tm {} active: speed {:.6g} is {:.2g} times that of the tool; what moves at less may sleep, and "
          "forces came out 11 % too large with 0.8 times. Take 0.05 to 0.1 times",
          state.id(), still, still / tool_speed);
  }
  way += sqrt(speed2) * dt;
  tool_way += tool_speed * dt;
  steps++;
  sum_moving += awake - at_edge;
  sum_edge += at_edge;
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
  return flag.bytes() + marks.bytes() + which.bytes() + edge.bytes() + (finder ? finder->bytes() : 0.0);
}

}    // namespace SPHTM_NS
