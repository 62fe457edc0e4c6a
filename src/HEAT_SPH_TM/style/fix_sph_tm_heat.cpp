/* SPH-TM: fix sph/tm/heat. See doc/fix_sph_tm_heat.rst. The physics is in tm_surface_flux.h. */
#include "fix_sph_tm_heat.h"

#include "argument.h"
#include "heat_loops.h"
#include "material_constants.h"
#include "restart_block.h"

#include "atom.h"
#include "atom_masks.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "group.h"
#include "modify.h"
#include "update.h"
#include "utils.h"

using namespace LAMMPS_NS;
using namespace SPHTM_NS;
using namespace FixConst;

static constexpr double LEAST_AREA = 0.1, AREAS_APART = 3.0;
static constexpr double STEFAN_BOLTZMANN = 5.670374419e-8;    // W/(m^2 K^4)

// the modes, and how many values each takes: the strength, the surroundings
// clang-format off
static const struct { const char *name; bool strength, surroundings; } MODES[] = {
    {"temperature", true, false}, {"flux", true, false}, {"source", true, false},
    {"convection", true, true}, {"radiation", false, true}};
// clang-format on

FixSPHTMHeat::FixSPHTMHeat(LAMMPS *lmp, int narg, char **arg) : Fix(lmp, narg, arg), scene(Scene::of(lmp))
{
  scalar_flag = 1;
  vector_flag = 1;
  size_vector = 3;
  global_freq = 1;
  extscalar = 0;
  extvector = 0;
  nevery = 1;
  restart_global = 1;
  dynamic_group_allow = 1;
  datamask_read = TYPE_MASK | MASK_MASK | RMASS_MASK;    // with Kokkos
  datamask_modify = EMPTY_MASK;

  Keywords k(lmp, "Fix sph/tm/heat", narg - 3, arg + 3);
  const bool given = k.next();
  int m = 0;
  while (m < 5 && !k.is(MODES[m].name)) m++;
  if (m == 5)
    error->all(FLERR,
               "Fix sph/tm/heat needs a mode: temperature T, flux q, source q, convection hc Tinf or "
               "radiation Tinf; got {}",
               given ? k.name() : "none");
  mode = static_cast<Mode>(m);
  static const char *const strengths[] = {"T", "q", "q", "hc", ""};
  if (MODES[m].strength) read(strength, strengths[m], k);
  if (MODES[m].surroundings) read(T_inf, "Tinf", k);
  read_keywords(k);
  state = scene->state();
  if (state) ask();
}

// a value of the mode
void FixSPHTMHeat::read(EqualValue &value, const char *which, Keywords &k)
{
  const std::string what = k.what(which);
  if (k.rest() < 1) error->all(FLERR, "Fix sph/tm/heat {} needs {}, a number or v_name", k.name(), which);
  value.set(lmp, what, k.value());
  const double v = value.varies() ? 1.0 : value.now();
  if (mode == TEMPERATURE && !(v > 0.0)) error->all(FLERR, "{} must be > 0, got {}", what, v);
  if ((mode == CONVECTION || mode == RADIATION) && !(v >= 0.0)) error->all(FLERR, "{} must be >= 0, got {}", what, v);
  if (!value.varies() && (mode == TEMPERATURE || &value == &T_inf)) warn_of_celsius(lmp, what, v);
}

void FixSPHTMHeat::read_keywords(Keywords &k)
{
  std::vector<std::string> known;
  if (on_surface()) known = {"facing", "area", "threshold"};
  if (mode == RADIATION) known.emplace_back("emissivity");
  while (k.option(known)) {
    if (k.is("emissivity")) emissivity = k.within(0.0, 1.0);
    else if (k.is("area")) known_area = k.positive();
    else if (k.is("threshold")) {
      threshold = k.not_negative();
      if (!(threshold < 1.0))
        error->all(FLERR, "{} must be >= 0 and < 1, a share of what a particle of a flat face carries; got {}",
                   k.what(), k.given());
    } else {
      k.need(3);
      for (double *d : {&direction.x, &direction.y, &direction.z}) *d = k.number();
      const double size = tm_vec_norm(direction);
      if (!(size > 0.0) || (domain->dimension == 2 && direction.z != 0.0))
        error->all(FLERR, "{} needs an outward direction other than 0{}, got {} {} {}", k.what(),
                   domain->dimension == 2 ? " in the xy plane" : "", direction.x, direction.y, direction.z);
      direction = tm_vec_scale(1.0 / size, direction);
      facing = true;
    }
  }
  if (k.rest())
    error->all(FLERR, "Unknown fix sph/tm/heat {} keyword {}: known are {}", MODES[mode].name, k.value(),
               known.empty() ? "none" : utils::join_words(known, ", "));
}

int FixSPHTMHeat::setmask() { return POST_FORCE | (mode == TEMPERATURE ? END_OF_STEP : 0); }

/* ---------------------------------------------------------------------- */

void FixSPHTMHeat::ask()
{
  const std::string reason = fmt::format("fix {} ({})", id, style);
  state->need(TM_FX_HEAT, reason);
  if (on_surface()) state->need(TM_FX_SURFACE, reason);
}

void FixSPHTMHeat::init()
{
  state = &scene->state("Fix sph/tm/heat");
  for (const auto &f : modify->get_fix_list()) {
    if (f->id == state->id()) break;
    if (f == this) error->all(FLERR, "Fix sph/tm/heat must stand after fix sph/tm {} in the script", state->id());
  }
  strength.init();
  T_inf.init();
  ask();
  if (!state->has(TM_FX_HEAT) || (on_surface() && !state->has(TM_FX_SURFACE)))
    error->all(FLERR, "Fix sph/tm/heat {} needs the effect{} of fix sph/tm, which 'effects ... off' forbids",
               MODES[mode].name, on_surface() ? "s heat and surface" : " heat");
  const Settings &set = scene->model().settings_in_use();
  surface = tm_surface_make(set.kernel, domain->dimension, set.spacing, set.h, threshold);
  if (mode == RADIATION && !find_style_units(update->unit_style))
    error->all(FLERR,
               "Fix sph/tm/heat radiation needs units with a known Stefan-Boltzmann constant, not {}; "
               "convection with a variable coefficient does the same",
               update->unit_style);
}

void FixSPHTMHeat::setup(int)
{
  check_group();
  power = 0.0;
  if (mode == TEMPERATURE) {
    set_temperature(temperature_now());    // from the start; what that takes belongs to the initial state
    return;
  }
  add_flux();
  if (on_surface()) check_area();
}

// what a particle of a flat face has is the least that is a surface; less is the unevenness of a lattice
void FixSPHTMHeat::check_area()
{
  double all = 0.0;
  MPI_Allreduce(&area_found, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  const double one = pow(scene->model().smallest_spacing(), domain->dimension - 1);
  if (!(all > LEAST_AREA * one)) {
    const auto text = fmt::format("Fix sph/tm/heat {}: group {} has no free surface{}", MODES[mode].name,
                                  group->names[igroup], facing ? " that faces this way" : "");
    if (known_area > 0.0) error->all(FLERR, "{}: area {:g} cannot be spread over it", text, known_area);
    if (comm->me == 0) error->warning(FLERR, "{}", text);
  } else if (known_area > 0.0 && comm->me == 0 && (known_area > AREAS_APART * all || known_area * AREAS_APART < all))
    error->warning(FLERR,
                   "Fix sph/tm/heat {}: area {:g} is {:.3g} times the {:g} that the particles of group {} have{}; "
                   "is it in the units of the script (in 2d a length)?",
                   MODES[mode].name, known_area, known_area / all, all, group->names[igroup],
                   facing ? " facing this way" : "");
}

void FixSPHTMHeat::check_group()
{
  if (mode != RADIATION || emissivity > 0.0) return;
  int dark = 0, worst = 0;
  const tm_material *material = scene->model().materials();
  for (int i = 0; i < atom->nlocal; i++)
    if ((atom->mask[i] & groupbit) && !(material[atom->type[i]].emissivity > 0.0)) dark = atom->type[i];
  MPI_Allreduce(&dark, &worst, 1, MPI_INT, MPI_MAX, world);
  if (worst)
    error->all(FLERR,
               "Fix sph/tm/heat radiation: type {} ({}) has no emissivity; add 'emissivity e' to its "
               "pair_coeff or to this fix",
               worst, scene->model().material_name(worst));
}

/* ---------------------------------------------------------------------- fixed temperature */

double FixSPHTMHeat::temperature_now()
{
  if (strength.varies()) modify->clearstep_compute();
  const double T = strength.now();
  if (strength.varies()) modify->addstep_compute(update->ntimestep + 1);
  if (!(T > 0.0)) error->all(FLERR, "Fix sph/tm/heat temperature must be > 0, the variable gave {}", T);
  return T;
}

// returns the heat this took
double FixSPHTMHeat::set_temperature(double T)
{
  return HeatLoops::of(state->loops()).dirichlet(state->loops(), atom->nlocal, {state->arrays(), groupbit, T}, 0);
}

void FixSPHTMHeat::end_of_step()
{
  const auto timed = state->clock().timed(this);
  const double heat = set_temperature(temperature_now());
  const double supply = held >= 0 ? state->source().held.supply(held) : 0.0;    // during the stages of conduction
  power = (heat + supply) / state->time_step().now();
  energy += heat + supply;
  state->energy().add(EnergyBalance::HEAT, heat);
  state->energy().add(EnergyBalance::HEAT_EXCHANGED, heat + supply);
}

/* ---------------------------------------------------------------------- surface flux and source */

tm_surface_flux_args FixSPHTMHeat::flux_args()
{
  static const int modes[] = {0, TM_FLUX_GIVEN, TM_FLUX_SOURCE, TM_FLUX_CONVECTION, TM_FLUX_RADIATION};
  tm_surface_flux_args a;
  a.mode = modes[mode];
  const bool varies = strength.varies() || T_inf.varies();
  if (varies) modify->clearstep_compute();
  a.strength = strength.now() * scene->model().units().energy * scene->model().time_scale();
  a.T_inf = T_inf.now();
  if (varies) modify->addstep_compute(update->ntimestep + 1);
  if (mode == RADIATION) {
    const StyleUnits &u = *find_style_units(update->unit_style);
    a.strength = STEFAN_BOLTZMANN * u.time * u.time * u.time / u.mass * scene->model().time_scale();
  }
  a.emissivity = emissivity;
  a.surface = surface;
  a.dim3 = domain->dimension == 3;
  a.facing = facing;
  a.d = direction;
  a.area_factor = 1.0;
  a.dt = update->setupflag ? 0.0 : state->time_step().now();
  const tm_state s = state->arrays();
  const tm_rates_args &rates = scene->results().rate_args();
  a.rec = rates.rec;
  a.normal = rates.surface;
  a.type = s.type;
  a.mask = s.mask;
  a.group = groupbit;
  a.material = s.material;
  a.source = state->heat_source();
  return a;
}

// power into the particles at the half step, added to their source
void FixSPHTMHeat::add_flux()
{
  tm_surface_flux_args a = flux_args();
  Backend &loops = state->active().stepping();
  const HeatLoops &heat = HeatLoops::of(state->loops());
  area_found = 0.0;
  if (known_area > 0.0) {
    area_found = heat.surface_area(loops, atom->nlocal, a, 0);
    double all = 0.0;
    MPI_Allreduce(&area_found, &all, 1, MPI_DOUBLE, MPI_SUM, world);
    a.area_factor = all > 0.0 ? known_area / all : 0.0;
  }
  const tm_surface_flux_result r = heat.surface_flux(loops, atom->nlocal, a, 0);
  power = r.power;
  area = r.area;
  if (!(known_area > 0.0)) area_found = area;
  state->time_step().limit(tm_decay_time_step(r.rate), TM_DT_CONDUCTION, this);
}

void FixSPHTMHeat::post_force(int)
{
  const auto timed = state->clock().timed(this);
  if (mode == TEMPERATURE) {
    held = -1;
    if (!state->time_step().conducts_in_stages()) return;
    held = state->source().held.hold(groupbit, temperature_now());
    if (held < 0)
      error->all(FLERR, "Fix sph/tm/heat temperature: at most {} of these fixes where conduction takes stages",
                 (int) TM_HELD_MOST);
    return;
  }
  add_flux();
  energy += power * state->time_step().now();
  state->energy().add(EnergyBalance::HEAT_EXCHANGED, power * state->time_step().now());
}

/* ---------------------------------------------------------------------- output and restart */

double FixSPHTMHeat::compute_scalar() { return compute_vector(0); }

double FixSPHTMHeat::compute_vector(int n)
{
  scene->check_current(state, fmt::format("Fix sph/tm/heat {}", id));
  const double mine = n == 0 ? power : n == 1 ? energy : area;
  double all = 0.0;
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return n < 2 ? all / scene->model().units().energy : all;
}

void FixSPHTMHeat::write_restart(FILE *fp) { write_restart_sum(lmp, energy, fp); }

void FixSPHTMHeat::restart(char *buf) { read_restart_sum(lmp, "Fix sph/tm/heat " + std::string(id), energy, buf); }
