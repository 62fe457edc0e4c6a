/* SPH-TM: fix sph/tm. See doc/fix_sph_tm.rst. */
#include "fix_sph_tm.h"

#include "effect_plan.h"
#include "pair_sph_tm.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "force.h"
#include "group.h"
#include "lammps.h"
#include "modify.h"
#include "output.h"
#include "update.h"
#include "utils.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;
using namespace SPHTM_NS;
using namespace FixConst;

enum { ENERGY_KINETIC, ENERGY_ELASTIC, ENERGY_PLASTIC, ENERGY_HEAT, ENERGY_CONTACT,
       ENERGY_FRICTION, ENERGY_ARTIFICIAL, ENERGY_EXTERNAL, ENERGY_SUM, VECTOR_DT, VECTOR_CAUSE,
       VECTOR_NEIGHBORS, VECTOR_SIZE };

static const char *const DT_CAUSE_NAMES[TM_DT_CAUSES] = {
    "sound speed", "acceleration", "heat conduction", "contact stiffness", "tool motion",
    "dt/max"};

FixSPHTM::FixSPHTM(LAMMPS *lmp, int narg, char **arg) : Fix(lmp, narg, arg)
{
  time_integrate = 1;
  create_attribute = 1;
  restart_global = 1;
  restart_peratom = 1;
  scalar_flag = 1;
  vector_flag = 1;
  size_vector = VECTOR_SIZE;
  global_freq = 1;
  extscalar = 0;
  extvector = 0;
  dynamic_group_allow = 1;

  for (int iarg = 3; iarg < narg;) {
    const std::string key = arg[iarg];
    auto value = [&](int n) {
      if (iarg + n >= narg)
        error->all(FLERR, "Fix sph/tm keyword {} needs {} value{}", key, n, n == 1 ? "" : "s");
    };
    auto number = [&](const char *text, double lo, double hi) {
      const double v = utils::numeric(FLERR, text, false, lmp);
      if (!(v > lo && v <= hi))
        error->all(FLERR, "Fix sph/tm {} must be > {} and <= {}, got {}", key, lo, hi, text);
      return v;
    };
    if (key == "temperature") {
      value(1);
      temperature0 = number(arg[iarg + 1], 0.0, 1e6);
      temperature_given = true;
      iarg += 2;
    } else if (key == "courant") {
      value(1);
      courant = number(arg[iarg + 1], 0.0, 1.0);
      iarg += 2;
    } else if (key == "dt") {
      value(1);
      fixed_dt = strcmp(arg[iarg + 1], "auto") == 0 ? 0.0 : number(arg[iarg + 1], 0.0, 1e300);
      iarg += 2;
    } else if (key == "dt/max") {
      value(1);
      dt_max = number(arg[iarg + 1], 0.0, 1e300);
      iarg += 2;
    } else if (key == "lost") {
      value(1);
      const std::string what = arg[iarg + 1];
      if (what != "error" && what != "ignore")
        error->all(FLERR, "Fix sph/tm lost must be error or ignore, got {}", what);
      stop_on_lost = what == "error";
      iarg += 2;
    } else if (key == "energy") {
      value(1);
      if (utils::logical(FLERR, arg[iarg + 1], false, lmp)) forced_on |= TM_FX_LEDGER;
      iarg += 2;
    } else if (key == "effects") {
      value(1);
      if (strcmp(arg[iarg + 1], "auto") == 0) {
        iarg += 2;
        continue;
      }
      value(2);
      const unsigned bit = effect_by_name(arg[iarg + 1]);
      if (!bit)
        error->all(FLERR, "Unknown fix sph/tm effect {}: known are {}", arg[iarg + 1],
                   effect_names());
      if (utils::logical(FLERR, arg[iarg + 2], false, lmp)) forced_on |= bit;
      else forced_off |= bit;
      iarg += 3;
    } else
      error->all(FLERR, "Unknown fix sph/tm keyword {}: known are temperature, courant, dt, dt/max, "
                        "energy, lost, effects", key);
  }

  if (forced_on & forced_off)
    error->all(FLERR, "Fix sph/tm: effect {} is forced both on and off",
               effect_name(forced_on & forced_off));

  std::fill(dt_limits, dt_limits + TM_DT_CAUSES, 1e300);
  std::fill(energy_now, energy_now + VECTOR_SIZE, 0.0);
  fields.enable(0, atom->nmax);
  maxexchange = fields.columns();
  atom->add_callback(Atom::GROW);
  atom->add_callback(Atom::RESTART);
}

FixSPHTM::~FixSPHTM()
{
  if (copymode) return;
  atom->delete_callback(id, Atom::GROW);
  atom->delete_callback(id, Atom::RESTART);
}

int FixSPHTM::setmask()
{
  return INITIAL_INTEGRATE | PRE_FORCE | FINAL_INTEGRATE | POST_NEIGHBOR;
}

int FixSPHTM::modify_param(int narg, char **arg)
{
  if (strcmp(arg[0], "temperature") == 0) {
    if (narg < 3)
      error->all(FLERR, "Fix_modify temperature of fix sph/tm needs a group and a temperature");
    const int igroup2 = group->find(arg[1]);
    if (igroup2 < 0) error->all(FLERR, "Fix_modify temperature of fix sph/tm: no group {}", arg[1]);
    const double T = utils::numeric(FLERR, arg[2], false, lmp);
    if (!(T > 0.0))
      error->all(FLERR, "Fix_modify temperature of fix sph/tm must be > 0 K, got {}", arg[2]);
    preset.push_back({group->bitmask[igroup2], T});
    need(TM_FX_HEAT, fmt::format("temperature of group {} is set", arg[1]));
    return 3;
  }
  return 0;
}

/* ---------------------------------------------------------------------- effects */

void FixSPHTM::need(unsigned effect, const std::string &reason)
{
  if ((asked & effect) == effect) return;
  asked |= effect;
  asked_reasons.push_back({effect, reason});
  if (pair_sph) derive_effects();
}

void FixSPHTM::derive_effects()
{
  EffectPlan plan;
  plan.dimension = domain->dimension;
  plan.forced_on = forced_on;
  plan.forced_off = forced_off;
  plan.asked = asked_reasons;
  plan.derive(*pair_sph, atom->ntypes);
  if (!plan.contradiction.empty()) error->all(FLERR, "Fix sph/tm: {}", plan.contradiction);
  if (plan.effects & TM_FX_HEAT)
    for (int t = 1; t <= atom->ntypes; t++)
      if (!pair_sph->materials()[t].heat)
        error->all(FLERR, "Fix sph/tm: heat is on ({}), but type {} ({}) has no heat constants; add "
                          "'heat k cp chi' to its pair_coeff, with k 0 where it does not conduct, or "
                          "force the effect off with 'effects heat off'", plan.heat_reason, t,
                   pair_sph->material_name(t));
  const unsigned before = fx;
  fx = plan.effects;
  const unsigned had = fields.mask();
  fields.enable(fx, atom->nmax);
  maxexchange = fields.columns();
  // a field that appears now starts from its initial value
  const unsigned fresh = fields.mask() & ~had;
  for (int i = 0; i < atom->nlocal; i++) initialise_fields(i, fresh);
  if (comm->me == 0 && (before != fx || !reported)) {
    for (const auto &line : plan.report) utils::logmesg(lmp, "{}\n", line);
    for (const auto &w : plan.warnings) error->warning(FLERR, w);
    reported = true;
  }
}

void FixSPHTM::init()
{
  pair_sph = dynamic_cast<PairSPHTM *>(force->pair_match("^sph/tm", 0));
  if (!pair_sph) error->all(FLERR, "Fix sph/tm needs pair style sph/tm");
  if (modify->get_fix_by_style("^sph/tm$").size() > 1) error->all(FLERR, "More than one fix sph/tm");
  if (utils::strmatch(update->integrate_style, "^respa"))
    error->all(FLERR, "Fix sph/tm does not work with run_style respa");
  for (const auto &f : modify->get_fix_list())
    if (f != this && f->time_integrate && (utils::strmatch(f->style, "^nve") || utils::strmatch(f->style, "^nvt")))
      if (comm->me == 0)
        error->warning(FLERR, "Fix {} also integrates positions; fix sph/tm does it for its own group", f->style);
  derive_effects();
  std::fill(dt_limits, dt_limits + TM_DT_CAUSES, 1e300);
}

// zeroed rows of new particles get the reference density and the start temperature
void FixSPHTM::initialise_fields(int i, unsigned mask)
{
  const int t = atom->type[i];
  if (mask & (1u << TM_F_TEMP)) {
    double *row = fields.data(TM_F_TEMP) + 3 * (size_t) i;
    row[0] = temperature0;
    row[1] = row[2] = 0.0;
  }
  if (mask & (1u << TM_F_CORRECTION)) {
    double *K = fields.data(TM_F_CORRECTION) + 9 * (size_t) i;
    for (int k = 0; k < 9; k++) K[k] = k % 4 == 0 ? 1.0 : 0.0;
  }
  if (mask & (1u << TM_F_BALSARA)) fields.data(TM_F_BALSARA)[i] = 1.0;
  if (mask & (1u << TM_F_THICKNESS)) fields.data(TM_F_THICKNESS)[i] = 1.0;
  if (mask & (1u << TM_F_RHO)) fields.data(TM_F_RHO)[i] = pair_sph->materials()[t].rho0;
}

void FixSPHTM::initialise_particles()
{
  const double *rho = fields.data(TM_F_RHO);
  for (int i = 0; i < atom->nlocal; i++)
    if (rho[i] == 0.0) initialise_fields(i, fields.mask());
  for (const auto &p : preset)
    for (int i = 0; i < atom->nlocal; i++)
      if (atom->mask[i] & p.bit) fields.data(TM_F_TEMP)[3 * (size_t) i] = p.temperature;
  preset.clear();
}

tm_state FixSPHTM::state()
{
  tm_state s;
  for (int id = 0; id < TM_F_COUNT; id++) s.field[id] = fields.data(id);
  s.x = atom->nmax ? &atom->x[0][0] : nullptr;
  s.v = atom->nmax ? &atom->v[0][0] : nullptr;
  s.force = atom->nmax ? &atom->f[0][0] : nullptr;
  s.type = atom->type;
  s.material = pair_sph->materials();
  s.mass = atom->mass;
  s.rmass = atom->rmass_flag ? atom->rmass : nullptr;
  return s;
}

double FixSPHTM::temperature(int i)
{
  return has(TM_FX_HEAT) ? fields.data(TM_F_TEMP)[3 * (size_t) i] : temperature0;
}

/* ---------------------------------------------------------------------- one step */

void FixSPHTM::setup_pre_force(int vflag)
{
  initialise_particles();
  dt_ahead = 0.0;
  dt = fixed_dt > 0.0 ? fixed_dt : (dt_next > 0.0 ? dt_next : 0.0);
  if (dt == 0.0) setup_dt();
  pre_force(vflag);
}

// the first step's limit, from the sound speed alone; the rates are not known yet
void FixSPHTM::setup_dt()
{
  double limit = 1e300;
  const double h = pair_sph->settings_in_use().h;
  for (int t = 1; t <= atom->ntypes; t++) {
    const tm_material &m = pair_sph->materials()[t];
    if (m.body != TM_BODY_SOLID) continue;
    limit = std::min(limit, h / tm_eos_sound_speed(&m, m.rho0, 0.0) /
                         (1.0 + 0.6 * pair_sph->settings_in_use().visc_alpha));
  }
  dt = limit < 1e300 ? courant * limit : update->dt;
  if (dt_max > 0.0) dt = std::min(dt, dt_max);
}

void FixSPHTM::setup(int)
{
  const double to_acc = pair_sph->units().force;
  double limits[3] = {1e300, 1e300, 1e300};
  const double h = pair_sph->settings_in_use().h;
  const tm_state s = state();
  for (int i = 0; i < atom->nlocal; i++) {
    const tm_material &m = pair_sph->materials()[atom->type[i]];
    if (!started) seed_history(i, to_acc);
    if (m.body == TM_BODY_SOLID) {
      const double c = pair_sph->records().main[(size_t) i * TM_REC + TM_REC_C];
      limits[0] = std::min(limits[0], h / (c * (1.0 + 0.6 * pair_sph->settings_in_use().visc_alpha)));
      const double a = to_acc / tm_particle_mass(&s, i) *
          sqrt(atom->f[i][0] * atom->f[i][0] + atom->f[i][1] * atom->f[i][1] + atom->f[i][2] * atom->f[i][2]);
      if (a > 0.0 && (atom->mask[i] & groupbit)) limits[1] = std::min(limits[1], sqrt(h / a));
    }
    if (has(TM_FX_CONDUCTION)) {
      const double T = temperature(i), k = tm_conductivity(&m, T);
      if (k > 0.0)
        limits[2] = std::min(limits[2], tm_heat_time_step(fields.data(TM_F_RHO)[i], tm_capacity(&m, T), h, k,
                                                          pair_sph->largest_conductivity(),
                                                          pair_sph->lattice_sums().heat_rate));
    }
  }
  for (int k = 0; k < 3; k++) dt_limits[k] = std::min(dt_limits[k], limits[k]);
  if (!started || dt_next <= 0.0) {
    reduce_dt();
    if (!started && comm->me == 0) {
      utils::logmesg(lmp, "sph/tm: time step {:.6g}, limited by {}; rate loops: {}\n",
                     fixed_dt > 0.0 ? fixed_dt : dt_next, DT_CAUSE_NAMES[dt_cause], rate_loop_isa());
    }
  }
  if (fixed_dt > 0.0) {
    double all[TM_DT_CAUSES];
    MPI_Allreduce(dt_limits, all, TM_DT_CAUSES, MPI_DOUBLE, MPI_MIN, world);
    // 1.0 in units of h/c is the stability limit found for the half-step prediction
    if (fixed_dt > 1.0 * all[TM_DT_SOUND] || fixed_dt > all[TM_DT_CONDUCTION])
      error->all(FLERR, "Fix sph/tm dt {:.6g} is not stable: sound speed allows {:.6g}, conduction "
                        "{:.6g}; use 'dt auto' or a smaller value", fixed_dt, all[TM_DT_SOUND],
                 all[TM_DT_CONDUCTION]);
  }
  dt = fixed_dt > 0.0 ? fixed_dt : dt_next;
  apply_dt(dt, update->ntimestep);
}

// rates of the set-up, as history of the first prediction
void FixSPHTM::seed_history(int i, double to_acc)
{
  const tm_state s = state();
  double *h1 = tm_field_row(&s, TM_F_HISTORY, i), *h2 = h1 + TM_H_STEP;
  const double c = to_acc / tm_particle_mass(&s, i);
  const tm_material &m = pair_sph->materials()[atom->type[i]];
  if (m.body != TM_BODY_SOLID) return;
  if (atom->mask[i] & groupbit)
    for (int k = 0; k < domain->dimension; k++) h1[TM_H_V + k] = c * atom->f[i][k];
  const tm_mat3 L = tm_mat_load(&pair_sph->gradients()[9 * (size_t) i]);
  h1[TM_H_RHO] = -fields.data(TM_F_RHO)[i] * tm_mat_trace(L);
  if (m.strength != TM_STRENGTH_NONE)
    tm_sym_store(h1 + TM_H_S, tm_jaumann_rate(tm_sym_load(tm_field_row(&s, TM_F_STRESS, i)), L, m.shear));
  std::copy_n(h1, (int) TM_H_STEP, h2);
}

// the steps up to and with step number done had the old size
void FixSPHTM::apply_dt(double value, bigint done)
{
  if (update->dt == value) return;
  update->atime += (done - update->atimestep) * update->dt;
  update->atimestep = done;
  update->dt = value;
  update->dt_default = 0;
  if (force->pair) force->pair->reset_dt();
  for (const auto &f : modify->get_fix_list())
    if (f != this) f->reset_dt();
  output->reset_dt();
}

void FixSPHTM::reset_dt() {}

void FixSPHTM::initial_integrate(int)
{
  started = true;
  dt = fixed_dt > 0.0 ? fixed_dt : dt_next;
  apply_dt(dt, update->ntimestep - 1);    // this step is counted already
  dt_ahead = 0.5 * dt;
  const bool xsph = has(TM_FX_XSPH);
  const double *u = xsph ? fields.data(TM_F_XSPH) : nullptr;
  double **x = atom->x, **v = atom->v;
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    for (int k = 0; k < domain->dimension; k++) x[i][k] += dt_ahead * (v[i][k] + (xsph ? u[3 * (size_t) i + k] : 0.0));
  }
  if (stop_on_lost) check_inside_box();
}

// a particle beyond a fixed boundary would be deleted at the next reneighbouring
void FixSPHTM::check_inside_box()
{
  const int(*b)[2] = domain->boundary;
  enum { FIXED = 1 };
  bool fixed[3][2], any = false;
  for (int d = 0; d < 3; d++)
    for (int side = 0; side < 2; side++) {
      fixed[d][side] = b[d][side] == FIXED && (d < 2 || domain->dimension == 3);
      any = any || fixed[d][side];
    }
  if (!any || domain->triclinic) return;
  for (int i = 0; i < atom->nlocal; i++)
    for (int d = 0; d < 3; d++) {
      const double x = atom->x[i][d];
      if ((!fixed[d][0] || x >= domain->boxlo[d]) && (!fixed[d][1] || x <= domain->boxhi[d])) continue;
      const double *v = atom->v[i];
      error->one(FLERR, "Fix sph/tm stops at step {}: particle {} (type {}) at {:.6g} {:.6g} {:.6g} with "
                        "velocity {:.6g} {:.6g} {:.6g} leaves the box through its {} {} boundary. Likely "
                        "cause: a box too small for the motion, or a particle shot out by an unstable "
                        "contact. Make the box larger, use boundary m or s, or 'lost ignore' to let it go",
                 update->ntimestep, atom->tag[i], atom->type[i], atom->x[i][0], atom->x[i][1],
                 atom->x[i][2], v[0], v[1], v[2], "xyz"[d], x < domain->boxlo[d] ? "lower" : "upper");
    }
}

void FixSPHTM::post_neighbor() { initialise_particles(); }

void FixSPHTM::pre_force(int)
{
  if (has(TM_FX_HEAT)) {
    source.resize(std::max(atom->nmax, 1));
    std::fill_n(source.begin(), atom->nlocal, 0.0);
  }
  contact_spring = 0.0;
}

tm_update_args FixSPHTM::update_args()
{
  auto ptr = [](const auto &v) { return v.empty() ? nullptr : v.data(); };
  tm_update_args a;
  a.state = state();
  a.rec = pair_sph->records();
  a.gradient = ptr(pair_sph->gradients());
  a.heat = ptr(pair_sph->conduction());
  a.moment = ptr(pair_sph->moments());
  a.xsph_v = ptr(pair_sph->xsph_velocities());
  a.artificial = ptr(pair_sph->artificial_heating());
  a.force_internal = ptr(pair_sph->internal_forces());
  a.source = heat_source();
  a.mask = atom->mask;
  a.group = groupbit;
  a.dt = dt;
  a.h = pair_sph->settings_in_use().h;
  a.visc_alpha = pair_sph->settings_in_use().visc_alpha;
  a.accel_unit = pair_sph->units().force;
  a.temperature = temperature0;
  a.heat_rate = pair_sph->lattice_sums().heat_rate;
  a.k_max = pair_sph->largest_conductivity();
  a.min_det = 0.1;
  return a;
}

void FixSPHTM::final_integrate()
{
  const tm_update_args a = update_args();
  double limits[3] = {1e300, 1e300, 1e300};
  for (int i = 0; i < atom->nlocal; i++) {
    const tm_update_result r = tm_update(i, &a, fx);
    if (r.status != TM_OK) stop_on(i, r);
    for (int k = 0; k < 3; k++) limits[k] = tm_min(limits[k], r.dt[k]);
    if (has(TM_FX_LEDGER)) {
      ledger.elastic += r.elastic;
      ledger.plastic += r.plastic;
      ledger.plastic_heat += r.plastic_heat;
      ledger.artificial += r.artificial;
      ledger.kinetic_work += r.kinetic_work;
      ledger.internal_work += r.internal_work;
      ledger.heat += r.heat;
    }
  }
  for (int k = 0; k < 3; k++) dt_limits[k] = tm_min(dt_limits[k], limits[k]);
  if (fixed_dt <= 0.0) reduce_dt();
}

// a state that cannot go on: say where and why, leave the last restart file as it is
void FixSPHTM::stop_on(int i, const tm_update_result &r)
{
  const double *x = atom->x[i], *v = atom->v[i];
  const double rho = fields.data(TM_F_RHO)[i], T = temperature(i);
  std::string what, cause;
  switch (r.status) {
    case TM_BAD_NAN:
      what = "state is not a number";
      cause = "overlapping particles, a time step above the limit of another fix, or bad input values";
      break;
    case TM_BAD_DENSITY:
      what = fmt::format("density {:.6g} is not positive", rho);
      cause = "a particle torn out of the body in one step; lower courant, or check the contact stiffness";
      break;
    case TM_BAD_VELOCITY:
      what = fmt::format("velocity {:.6g} is above ten times the speed of sound",
                         sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]));
      cause = "overlapping particles or a tool that starts inside the body; lower the penalty factor or courant";
      break;
    default:
      what = fmt::format("temperature {:.6g} is not positive", T);
      cause = "a heat sink stronger than the particle can feed in one step";
  }
  error->one(FLERR, "Fix sph/tm stops at step {}: particle {} (type {}) at {:.6g} {:.6g} {:.6g}: {}. "
                    "Likely cause: {}. Restart files written before remain valid.",
             update->ntimestep, atom->tag[i], atom->type[i], x[0], x[1], x[2], what, cause);
}

/* ---------------------------------------------------------------------- time step */

void FixSPHTM::limit_dt(double limit, int cause)
{
  dt_limits[cause] = std::min(dt_limits[cause], limit);
}

void FixSPHTM::reduce_dt()
{
  if (pair_sph->has_contact_pairs())
    for (int t = 1; t <= atom->ntypes; t++) {
      const double l = pair_sph->contact_stiffness_limit(t);
      if (l > 0.0) limit_dt(0.4 * l, TM_DT_CONTACT);
    }
  double mine[TM_DT_CAUSES], all[TM_DT_CAUSES];
  std::copy_n(dt_limits, (int) TM_DT_CAUSES, mine);
  mine[TM_DT_SOUND] *= courant;
  mine[TM_DT_FORCE] *= courant;
  mine[TM_DT_MAXIMUM] = dt_max > 0.0 ? dt_max : 1e300;
  MPI_Allreduce(mine, all, TM_DT_CAUSES, MPI_DOUBLE, MPI_MIN, world);
  dt_cause = (int) (std::min_element(all, all + TM_DT_CAUSES) - all);
  double next = all[dt_cause];
  if (next >= 1e300) next = update->dt;
  // grow slowly: the half-step prediction assumes steps of like size
  if (dt_next > 0.0 && next > 1.05 * dt_next) next = 1.05 * dt_next;
  dt_next = next;
  std::fill(dt_limits, dt_limits + TM_DT_CAUSES, 1e300);
}

/* ---------------------------------------------------------------------- output */

void FixSPHTM::sum_energies()
{
  if (energy_step == update->ntimestep) return;
  energy_step = update->ntimestep;
  const tm_state s = state();
  double kinetic = 0.0, neighbors = 0.0;
  for (int i = 0; i < atom->nlocal; i++) {
    const double *v = atom->v[i];
    kinetic += 0.5 * tm_particle_mass(&s, i) * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  }
  neighbors = pair_sph ? pair_sph->neighbors_per_particle() * atom->nlocal : 0.0;
  const Ledger &l = ledger;
  double mine[VECTOR_SIZE] = {};
  mine[ENERGY_KINETIC] = kinetic;
  mine[ENERGY_ELASTIC] = l.elastic;
  mine[ENERGY_PLASTIC] = l.plastic - l.plastic_heat;
  mine[ENERGY_HEAT] = l.heat - l.heat_exchanged;
  mine[ENERGY_CONTACT] = contact_spring + l.contact_damping;
  mine[ENERGY_FRICTION] = l.friction;
  mine[ENERGY_ARTIFICIAL] = l.artificial;
  mine[ENERGY_EXTERNAL] = -(l.kinetic_work - l.internal_work - l.contact_work + l.tool_work);
  mine[VECTOR_NEIGHBORS] = neighbors;
  MPI_Allreduce(mine, energy_now, VECTOR_SIZE, MPI_DOUBLE, MPI_SUM, world);
  const double unit = pair_sph->units().energy;
  double sum = 0.0;
  for (int k = 0; k < ENERGY_SUM; k++) {
    energy_now[k] /= unit;
    sum += energy_now[k];
  }
  energy_now[ENERGY_SUM] = sum;
  energy_now[VECTOR_DT] = dt;
  energy_now[VECTOR_CAUSE] = dt_cause;
  energy_now[VECTOR_NEIGHBORS] /= std::max((double) atom->natoms, 1.0);
}

double FixSPHTM::compute_scalar()
{
  sum_energies();
  return energy_now[ENERGY_SUM];
}

double FixSPHTM::compute_vector(int n)
{
  if (n <= ENERGY_SUM && n != ENERGY_KINETIC && !has(TM_FX_LEDGER) && pair_sph)
    error->all(FLERR, "Fix sph/tm output {} needs the keyword 'energy yes'", n + 1);
  sum_energies();
  return energy_now[n];
}

/* ---------------------------------------------------------------------- per-atom storage */

void FixSPHTM::grow_arrays(int nmax) { fields.grow(nmax); }
void FixSPHTM::copy_arrays(int i, int j, int) { fields.copy(i, j); }
void FixSPHTM::set_arrays(int i) { fields.zero(i); }
int FixSPHTM::pack_exchange(int i, double *buf) { return fields.pack(i, buf); }
int FixSPHTM::unpack_exchange(int nlocal, double *buf) { return fields.unpack(nlocal, buf); }

int FixSPHTM::pack_restart(int i, double *buf)
{
  buf[0] = fields.columns() + 1;
  return 1 + fields.pack(i, buf + 1);
}

void FixSPHTM::unpack_restart(int nlocal, int nth)
{
  const double *extra = atom->extra[nlocal];
  int m = 0;
  for (int i = 0; i < nth; i++) m += static_cast<int>(extra[m]);
  if (static_cast<int>(extra[m]) != fields.columns() + 1)
    error->one(FLERR, "Fix sph/tm: restart file holds {} values per particle, {} expected",
               static_cast<int>(extra[m]) - 1, fields.columns());
  fields.unpack(nlocal, extra + m + 1);
}

int FixSPHTM::size_restart(int) { return fields.columns() + 1; }
int FixSPHTM::maxsize_restart() { return fields.columns() + 1; }

// global state: which fields the rows hold, the time step, the energy book (of all ranks)
namespace {
struct GlobalState {
  int version, fields, started, cause;
  double dt, dt_next;
  double book[sizeof(FixSPHTM::Ledger) / sizeof(double)];
};
}    // namespace

void FixSPHTM::write_restart(FILE *fp)
{
  GlobalState g = {};
  constexpr int n = sizeof(Ledger) / sizeof(double);
  MPI_Reduce(&ledger, g.book, n, MPI_DOUBLE, MPI_SUM, 0, world);
  if (comm->me) return;
  g.version = 1;
  g.fields = (int) fields.mask();
  g.started = started;
  g.cause = dt_cause;
  g.dt = dt;
  g.dt_next = dt_next;
  const int size = sizeof(g);
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(&g, sizeof(g), 1, fp);
}

void FixSPHTM::restart(char *buf)
{
  GlobalState g;
  memcpy(&g, buf, sizeof(g));
  if (g.version != 1) error->all(FLERR, "Fix sph/tm: restart data of version {}, 1 expected", g.version);
  fields.enable_mask((unsigned) g.fields, atom->nmax);
  maxexchange = fields.columns();
  started = g.started != 0;
  dt_cause = g.cause;
  dt = g.dt;
  dt_next = g.dt_next;
  if (comm->me == 0) memcpy(&ledger, g.book, sizeof(Ledger));
}

double FixSPHTM::memory_usage() { return fields.bytes() + source.capacity() * sizeof(double); }
