/* SPH-TM: fix contact/tri. See doc/fix_contact_tri.rst. */
#include "fix_contact_tri.h"

#include "argument.h"
#include "fix_sph_tm.h"
#include "pair_sph_tm.h"
#include "tm_eos.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "input.h"
#include "memory.h"
#include "modify.h"
#include "update.h"
#include "variable.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;
using namespace SPHTM_NS;
using namespace FixConst;

FixContactTri::FixContactTri(LAMMPS *lmp, int narg, char **arg) : Fix(lmp, narg, arg), motion(lmp)
{
  scalar_flag = 1;
  vector_flag = 1;
  size_vector = 13;
  extscalar = 0;
  extvector = 0;
  global_freq = 1;
  restart_global = 1;
  comm_forward = 1;
  sums = tm_contact_nothing();
  std::fill(totals, totals + 14, 0.0);
  shape.options = tm_mesh_defaults();

  parse(narg - 3, arg + 3);
  const std::string wrong = tool.load(world, shape, request.two_sided);
  if (!wrong.empty()) error->all(FLERR, "Fix contact/tri {}: {}", id, wrong);
  reference_local = request.reference_given
      ? tm_vec(request.reference[0], request.reference[1], request.reference[2])
      : tool.origin();
  nevery = 1;
}

FixContactTri::~FixContactTri()
{
  if (copymode) return;
  memory->destroy(local_rows);
  memory->destroy(image_rows);
}

int FixContactTri::setmask()
{
  int mask = POST_FORCE | FINAL_INTEGRATE;
  if (motion.by_variable() || request.body_type || !temperature_variable.empty())
    mask |= INITIAL_INTEGRATE;
  if (vtk.every || stl.every || local_every || request.lumped_capacity > 0.0) mask |= END_OF_STEP;
  return mask;
}

int FixContactTri::modify_param(int narg, char **arg)
{
  if (strcmp(arg[0], "move") == 0) {
    const int used = motion.parse(narg - 1, arg + 1, clock);
    modify->fmask[modify->find_fix(id)] = setmask();
    return 1 + used;
  }
  if (strcmp(arg[0], "temperature") == 0) {
    if (narg < 2)
      utils::missing_cmd_args(FLERR, "fix_modify temperature of fix contact/tri", error);
    temperature = positive(lmp, "Fix_modify temperature of fix contact/tri", arg[1]);
    temperature_given = true;
    temperature_variable.clear();
    return 2;
  }
  return 0;
}

/* ---------------------------------------------------------------------- start of a run */

void FixContactTri::init()
{
  state = FixSPHTM::of(lmp, fmt::format("Fix contact/tri {}", id));
  if (modify->find_fix(id) < modify->find_fix(state->id))
    error->all(FLERR, "Fix contact/tri {} must come after fix {} sph/tm in the input", id, state->id);
  pair = state->pair();
  loop_laws.live_in(state->loops());
  tool_heat.live_in(state->loops());
  for (auto *a : {&tri_force, &tri_heat}) a->live_in(state->loops());
  tri_count.live_in(state->loops());
  warn_of_empty_group();
  ask_for_heat();
  if (!temperature_given) temperature = state->start_temperature();
  motion.init();
  check_dimension();
  const double reach = pair->settings_in_use().spacing;
  if (reach != indexed_reach) {
    const std::string wrong = tool.index(world, reach);
    if (!wrong.empty()) error->all(FLERR, "Fix contact/tri {}: {}", id, wrong);
    const bool first = indexed_reach == 0.0;
    indexed_reach = reach;
    loop_tool.copy(state->loops(), tool);
    make_laws();
    if (first) report();
  } else {
    make_laws();
  }
  limit_time_step();    // the first step of the run knows the tool
}

void FixContactTri::limit_time_step()
{
  // sqrt(m/k): m follows the volume of a particle, k its area
  const double dp = pair->settings_in_use().spacing;
  state->limit_dt(dt_limit * sqrt(pair->smallest_spacing() / dp), TM_DT_CONTACT, this);
  // no point of the tool moves by more than a fifth of the smallest spacing in a step
  const double speed = motion.top_speed(tool.mesh().lo, tool.mesh().hi);
  check_speed(speed);
  if (speed > 0.0) state->limit_dt(0.2 * pair->smallest_spacing() / speed, TM_DT_MOTION, this);
}

// friction heat of a type in words
std::string FixContactTri::heat_in_words(int type) const
{
  const tm_material &m = pair->materials()[type];
  const double T = state->start_temperature();
  const double e = tm_effusivity(tm_conductivity(&m, T), m.rho0, tm_capacity(&m, T));
  const bool said = request.share >= 0.0 || request.effusivity >= 0.0 || request.body_type;
  return fmt::format(", {:.3f} of the friction heat into the particles{}",
                     tm_contact_share(&laws[type], e),
                     said ? "" : " (give 'effusivity' or 'share' to change that)");
}

void FixContactTri::report()
{
  if (comm->me) return;
  utils::logmesg(lmp, "contact/tri {}: {}: {}\n", id, shape.file, tool.summary());
  for (const auto &line : tool.flaws(request.two_sided))
    error->warning(FLERR, "Fix contact/tri {}: {}", id, line);
  for (int t = 1; t <= atom->ntypes; t++) {
    const tm_contact_law &w = laws[t];
    if (!w.active) continue;
    const std::string mu = w.friction.n ? "by table" : fmt::format("{:.4g}", w.friction.value);
    utils::logmesg(lmp,
                   "contact/tri {}: type {}: stiffness {:.6g}, damping {:.4g} of critical, "
                   "friction {}{}\n",
                   id, t, w.stiffness / pair->units().force, w.damping, mu,
                   state->has(TM_FX_HEAT) && rubs() ? heat_in_words(t) : "");
  }
}

tm_contact_law FixContactTri::make_law(int type)
{
  const tm_material &m = pair->materials()[type];
  const UnitScale &u = pair->units();
  const double dp = pair->settings_in_use().spacing;
  const bool dim3 = domain->dimension == 3;
  tm_contact_law w = {};
  w.active = m.body == TM_BODY_SOLID;
  w.radius = 0.5 * dp;
  w.stiffness = tm_contact_stiffness(request.penalty, m.young, 0.0, dp, dp, dim3);
  w.damping = request.damping;
  w.area = dim3 ? dp * dp : dp;
  w.friction = request.friction;
  w.shear = request.shear;
  w.share = request.share;
  w.tool_effusivity = request.effusivity * u.energy;
  w.conductance = request.conductance > 0.0 ? request.conductance * u.energy : request.conductance;
  if (request.body_type) {
    const tm_material &b = pair->materials()[request.body_type];
    const double T = state->start_temperature();
    w.tool_effusivity = tm_effusivity(tm_conductivity(&b, T), b.rho0, tm_capacity(&b, T));
    w.conductance = 0.0;    // conduction goes from particle to particle
  } else if (request.share < 0.0 && request.effusivity < 0.0) {
    w.share = 0.5;
  }
  return w;
}

void FixContactTri::make_laws()
{
  if (request.body_type && pair->materials()[request.body_type].body != TM_BODY_HEAT)
    error->all(FLERR, "Fix contact/tri {} particles: type {} must be a material that only conducts heat", id,
               request.body_type);
  const double dp = pair->settings_in_use().spacing;
  laws.assign(atom->ntypes + 1, tm_contact_law{});
  dt_limit = 1e300;
  sound_speed = 0.0;
  for (int t = 1; t <= atom->ntypes; t++) {
    laws[t] = make_law(t);
    if (!laws[t].active) continue;
    const tm_material &m = pair->materials()[t];
    sound_speed = std::max(sound_speed, tm_eos_sound_speed(&m, m.rho0, 0.0));
    const double mass = m.rho0 * pow(dp, domain->dimension);
    // 0.35: stability of the half-step prediction, 0.78 without and 0.70 with damping, of 2
    dt_limit =
        std::min(dt_limit, 0.35 * tm_contact_time_step(laws[t].stiffness, mass, laws[t].damping));
  }
  loop_laws.assign(laws.data(), laws.size());
}

// penetration at the start that passes, in spacings: rounding of positions and of tessellated arcs; and what particles
// that were moved between runs may have more than before
static constexpr double OVERLAP_ALLOWED = 0.01, OVERLAP_GROWS = 0.05;

void FixContactTri::setup(int vflag)
{
  evaluate_variables(0.0);
  check_jump(pose_now());
  if (!request.overlap_allowed) {
    if (!checked && !restored && clock == 0.0) check_overlap(OVERLAP_ALLOWED);
    else if (checked && state->moved_since_last_run()) {    // deeper than contact has brought them
      double depth;
      MPI_Allreduce(&sums.depth, &depth, 1, MPI_DOUBLE, MPI_MAX, world);
      check_overlap(OVERLAP_ALLOWED + OVERLAP_GROWS + depth / pair->settings_in_use().spacing);
    }
  }
  checked = true;
  post_force(vflag);
  finish_contact();
  write_files();
}

/* ---------------------------------------------------------------------- one step */

// values of variables at the end of the step that begins, or now where dt is 0
void FixContactTri::evaluate_variables(double dt)
{
  if (!motion.by_variable() && temperature_variable.empty()) return;
  modify->clearstep_compute();
  if (dt > 0.0)
    motion.evaluate_next(dt);
  else
    motion.evaluate_now();
  if (!temperature_variable.empty()) {
    const int k = input->variable->find(temperature_variable.c_str());
    if (k < 0 || !input->variable->equalstyle(k))
      error->all(FLERR, "Fix contact/tri {} temperature: no equal-style variable {}", id,
                 temperature_variable);
    temperature = input->variable->compute_equal(k);
    if (!(temperature > 0.0 && std::isfinite(temperature)))
      error->all(FLERR, "Fix contact/tri {} temperature: variable {} is {} at step {}; it must be a positive number",
                 id, temperature_variable, temperature, update->ntimestep);
  }
  modify->addstep_compute(update->ntimestep + 1);
}

void FixContactTri::initial_integrate(int)
{
  const double dt = state->step_dt();
  evaluate_variables(dt);
  if (request.body_type)
    place_body(motion.pose(clock, 0.0, dt), motion.pose(clock, state->time_ahead(), dt));
}

unsigned FixContactTri::effects(bool output) const
{
  unsigned fx = 0;
  if (domain->dimension == 3) fx |= TM_CT_3D;
  if (state->has(TM_FX_HEAT)) fx |= TM_CT_HEAT;
  if (rubs()) fx |= TM_CT_FRICTION;
  if (request.approach) fx |= TM_CT_APPROACH;
  if (request.f15) fx |= TM_CT_F15;
  if (request.two_sided) fx |= TM_CT_TWO_SIDED;
  if (output) fx |= TM_CT_OUTPUT;
  return fx;
}

tm_contact_args FixContactTri::make_args(const tm_pose &pose, bool output)
{
  tm_contact_args a = {};
  const tm_state s = state->state();
  const tm_records &rec = pair->rate_args().rec;
  a.mesh = loop_tool.mesh();
  a.grid = loop_tool.grid();
  a.pose = pose;
  a.reference = tm_pose_to_world(&pose, reference_local);
  a.deep = pair->settings_in_use().spacing;
  a.dt = state->step_dt();
  a.after = state->time_ahead() > 0.0 ? a.dt - state->time_ahead() : 0.0;
  a.force_unit = 1.0 / pair->units().force;
  a.tool_temperature = temperature;
  a.law = loop_laws.loop_read();
  a.size = rec.size;
  a.mask = s.mask;
  a.group = groupbit;
  a.type = s.type;
  a.x = s.x;
  a.v = s.v;
  a.record = rec.main;
  a.f = s.force;
  a.x_stride = a.v_stride = a.f_stride = 3;
  a.mass = s.mass;
  a.rmass = s.rmass;
  a.material = s.material;
  if (state->has(TM_FX_HEAT)) {
    a.temperature = rec.heat + TM_REC_T;
    a.temperature_stride = TM_REC_HEAT;
    a.source = state->heat_source();
    a.tool_heat = request.body_type ? tool_heat.loop_write() : nullptr;
  }
  if (state->has(TM_FX_PLASTICITY) && request.shear > 0.0) a.pstrain = s.field[TM_F_PSTRAIN];
  if (output) {
    a.tri_force = tri_force.loop_write();
    a.tri_heat = tri_heat.loop_write();
    a.tri_count = tri_count.loop_write();
  }
  return a;
}

void FixContactTri::start_contact(const tm_contact_args &a, unsigned fx)
{
  sums = contact_loop(state->loops(), atom->nlocal, a, fx);
}

void FixContactTri::post_force(int)
{
  const auto timed = state->run_clock.timed(this);
  const bool output = output_due();
  if (output) clear_triangles();
  if (request.body_type) tool_heat.resize(std::max(atom->nmax, 1));
  const tm_pose pose = motion.pose(clock, state->time_ahead(), state->step_dt());
  if (!update->setupflag) check_jump(motion.pose(clock, state->step_dt(), state->step_dt()));
  start_contact(make_args(pose, output), effects(output));
  unfinished = true;
  totals_step = -1;
  if (request.body_type && state->has(TM_FX_CONDUCTION)) heat_body();
  limit_time_step();
}

// what the sums are for; a GPU is not waited for before the end of the step
void FixContactTri::finish_contact()
{
  if (!unfinished) return;
  unfinished = false;
  wait_for_contact();
  if (state->time_ahead() > 0.0) book(state->step_dt());
  const double deep = pair->settings_in_use().spacing;
  if (sums.inner > 0.5 * deep && !warned_deep) {
    warned_deep = true;
    error->warning(FLERR,
                   "Fix contact/tri {}: a particle's centre lies {:.2f} spacings behind the "
                   "surface; beyond 1 it is no longer pushed out: raise penalty or lower the speed{}",
                   id, sums.inner / deep, request.overlap_allowed ? ", or start without overlap" : "");
  }
  state->contact_spring += sums.spring;
}

// the energy book of the state fix, in its units
void FixContactTri::book(double dt)
{
  FixSPHTM::Ledger &l = state->ledger;
  l.contact_damping += dt * sums.damping_power;
  // the tool's share is heat of particles too where it has some, and booked with theirs
  const double heat = sums.friction_heat + (request.body_type ? sums.heat_tool : 0.0);
  l.friction += dt * (sums.friction_power - heat);
  l.friction_heat += dt * heat;
  l.heat_exchanged += dt * sums.conducted;
  l.contact_work += dt * sums.particle_power;
  l.tool_work += dt * sums.tool_power;
}

void FixContactTri::final_integrate()
{
  finish_contact();
  const double dt = state->step_dt();
  const tm_pose half = motion.pose(clock, state->time_ahead(), dt);
  clock += dt;
  motion.end_of_step();
  if (request.body_type) place_body(half, pose_now());
}

void FixContactTri::end_of_step()
{
  if (request.lumped_capacity > 0.0) update_temperature();
  write_files();
}

void FixContactTri::update_temperature()
{
  double heat;
  MPI_Allreduce(&sums.heat_tool, &heat, 1, MPI_DOUBLE, MPI_SUM, world);
  temperature += state->step_dt() * heat / (request.lumped_capacity * pair->units().energy);
}
