/* SPH-TM: fix contact/tri. See doc/fix_contact_tri.rst. */
#include "fix_contact_tri.h"

#include "argument.h"
#include "contact_report.h"
#include "overlap_check.h"
#include "scene.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "modify.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;
using namespace SPHTM_NS;
using namespace FixConst;

FixContactTri::FixContactTri(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), ContactProbe(id), set(lmp, narg - 3, arg + 3), particles(this, set.body_type),
    scene(Scene::of(lmp)), motion(lmp), temperature(set), output(lmp, id, set, tool), checks(lmp, *this, set, tool)
{
  scalar_flag = vector_flag = restart_global = 1;
  size_vector = ContactResults::SIZE;
  extscalar = extvector = 0;
  nevery = global_freq = comm_forward = 1;
  if (set.local_every) {
    local_flag = 1;
    local_freq = set.local_every;
    size_local_cols = ToolOutput::LOCAL_COLUMNS;
    size_local_rows = 0;
  }
  const std::string wrong = tool.load(world, set.shape, set.two_sided);
  if (!wrong.empty()) error->all(FLERR, "Fix contact/tri {}: {}", id, wrong);
  reference = set.reference_given ? tm_load3(set.reference) : tool.origin();
  scene->enter(this);
}

// its springs go with it: what they hold leaves the balance
FixContactTri::~FixContactTri()
{
  if (state && scene->is_current(state)) results.take_springs(state->energy(), -1.0);
  scene->leave(this);
}

int FixContactTri::setmask()
{
  int mask = POST_FORCE | FINAL_INTEGRATE;
  if (motion.by_variable() || set.body_type || temperature.by_variable()) mask |= INITIAL_INTEGRATE;
  if (set.vtk.every || set.stl.every || set.local_every || set.lumped_capacity > 0.0) mask |= END_OF_STEP;
  return mask;
}

int FixContactTri::modify_param(int narg, char **arg)
{
  if (strcmp(arg[0], "move") == 0) {
    const MotionCommand command = read_motion(lmp, set.surface, narg - 1, arg + 1);
    if (command.motion.ramp > 0.0 && !motion.goes_on(command.motion) &&
        motion.under_way(tool.mesh().lo, tool.mesh().hi) && comm->me == 0)
      error->warning(
          FLERR,
          "Fix_modify move of fix contact/tri {}: the tool moves, and a motion with 'ramp' begins at rest: its "
          "velocity jumps to 0",
          id);
    motion.set(command);
    motion_given = true;
    modify->fmask[modify->find_fix(id)] = setmask();
    return 1 + command.words;
  }
  if (strcmp(arg[0], "temperature") == 0) {
    if (narg < 2) utils::missing_cmd_args(FLERR, "fix_modify temperature of fix contact/tri", error);
    const std::string what = "Fix_modify temperature of fix contact/tri";
    temperature.set(positive(lmp, what, arg[1]));
    warn_of_celsius(lmp, what, temperature.now());
    return 2;
  }
  return 0;
}

/* ---------------------------------------------------------------------- start of a run */

void FixContactTri::init()
{
  state = &scene->state(fmt::format("Fix contact/tri {}", id));
  if (modify->find_fix(id) < modify->find_fix(state->id()))
    error->all(
        FLERR,
        "Fix contact/tri {} must come after fix {} sph/tm in the input (which takes the state of the particles with "
        "it where it is removed and written again)",
        id, state->id());
  model = &state->model();
  laws.live_in(state->loops());
  particles.live_in(lmp, *scene);
  triangles.live_in(state->loops());
  results.live_in(state->loops());
  for (int t = 1; t <= atom->ntypes; t++)
    if (layer_strains(set, *model, t))
      state->need(TM_FX_LAYER, fmt::format("fix contact/tri {}, type {} ({})", id, t, model->material_name(t)));
  if (set.approach && state->effect_plan().go_without_shock(
                          fmt::format("fix contact/tri {} has 'approach yes', which makes energy with it", id)))
    state->plan_changed();
  earlier.live_in(state->loops());
  places.live_in(state->loops());
  checks.empty_group();
  checks.heat(*state);
  temperature.begin(state->start_temperatures().of_all());
  motion.init();
  checks.extent(model->settings_in_use().spacing);
  const bool first = spacing == 0.0;
  if (spacing != model->settings_in_use().spacing) {
    spacing = model->settings_in_use().spacing;
    const std::string wrong = tool.index(world, spacing);
    if (!wrong.empty()) error->all(FLERR, "Fix contact/tri {}: {}", id, wrong);
    loop_tool.copy(state->loops(), tool);
  }
  checks.body_material(*model);
  laws.make(set, *model, state->start_temperatures().of_all(), domain->dimension);
  if (first) {
    report_tool();
    checks.far_from_box(motion.pose_now(), spacing);
    checks.periodic(motion.pose_now());
  }
  std::vector<int> fillings;    // types of the particles that fill tools
  int groups = 0;               // of tools with the same
  for (Fix *fix : modify->get_fix_list())
    if (const auto *of = dynamic_cast<FixContactTri *>(fix)) {
      fillings.push_back(of->set.body_type);
      if (of->set.body_type == set.body_type) groups |= of->groupbit;
    }
  if (set.body_type) checks.filling(groups);
  checks.conductors(*model, fillings);
  limit_time_step();    // the first step of the run keeps to it too
}

// of an ID, from 1: the same in every run
static double number_of(const char *id)
{
  unsigned number = 1;
  for (const char *c = id; *c; c++) number = 31u * number + (unsigned char) *c;
  return number % 1000003u + 1.0;
}

// where forces come behind it, for an energy balance that knows all forces on a particle: of other tools, or of other fixes
void FixContactTri::find_first_tool()
{
  FixContactTri *first = nullptr, *last = nullptr;
  bool others = false;
  for (int k = 0; k < modify->nfix; k++) {
    if (auto *tool = dynamic_cast<FixContactTri *>(modify->fix[k])) {
      last = tool;
      if (!first) first = tool;
    } else others = others || (first && (modify->fmask[k] & POST_FORCE));
  }
  const bool needed = state->has(TM_FX_LEDGER) && (first != last || others);
  first_tool = needed ? first : nullptr;
  corrects_late = needed && others && this == last;
}

void FixContactTri::limit_time_step()
{
  // sqrt(m/k): m follows the volume of a particle, k its area
  const double smallest = model->smallest_spacing();
  state->time_step().limit(laws.stable_dt() * sqrt(smallest / spacing), TM_DT_CONTACT, this);
  if (state->has(TM_FX_CONDUCTION) && state->time_step().has_stages())
    state->time_step().limit(laws.heat_dt() * (smallest / spacing) * (smallest / spacing), TM_DT_CONDUCTION, this);
  // no point of the tool moves by more than a fifth of the smallest spacing in a step
  const double speed = motion.top_speed(tool.mesh().lo, tool.mesh().hi);
  checks.speed(speed, laws.sound_speed());
  checks.inertia(*model, scene->time_scale(), speed, state->start_temperatures().of_all());
  if (speed > 0.0) state->time_step().limit(0.2 * smallest / speed, TM_DT_MOTION, this);
}

void FixContactTri::report_tool() const
{
  if (comm->me) return;
  if (restored && !motion_given && motion.top_speed(tool.mesh().lo, tool.mesh().hi) > 0.0)
    utils::logmesg(lmp, "contact/tri {}: goes on with the motion of the restart file\n", id);
  if (!restored && state->history().restored())
    error->warning(
        FLERR,
        "Fix contact/tri {}: the restart file has no tool of this ID: it begins where its mesh file and 'move' "
        "place it, at rest",
        id);
  utils::logmesg(lmp, "contact/tri {}: {}: {}\n", id, set.shape.file, tool.summary());
  for (const auto &line : tool.flaws(set.two_sided)) error->warning(FLERR, "Fix contact/tri {}: {}", id, line);
  report_contact_laws(lmp, id, set, laws, *state);
}

// penetration at the start that passes, in spacings: rounding of positions and of tessellated arcs; and what particles
// that were moved between runs may have more than before
static constexpr double OVERLAP_ALLOWED = 0.01, OVERLAP_GROWS = 0.05;

void FixContactTri::check_overlap()
{
  if (set.overlap_allowed) return;
  double allowed = OVERLAP_ALLOWED;
  if (overlap_checked) {
    if (!state->history().moved_since_last_run()) return;
    allowed =
        OVERLAP_ALLOWED + OVERLAP_GROWS + results.within(world) / spacing;    // that deep contact has brought them
  } else if (restored || motion.clock() != 0.0) return;
  const bool closed = tool.mesh().closed && !set.two_sided;
  const ToolQuery asked = query();
  const OverlapCheck check(lmp, asked, spacing, allowed);
  check.stop(fmt::format("Fix contact/tri {}", id), closed ? &tool.mesh() : nullptr, set.shape.flip == 1);
  if (!overlap_checked && !tool.mesh().closed && !set.two_sided && check.faces_away() && comm->me == 0)
    error->warning(FLERR,
                   "Fix contact/tri {}: all particles lie behind its triangles, whose normals are away from them, and "
                   "never touch them; {}, or use 'sides two'",
                   id, set.shape.flip == 1 ? "leave out 'flip yes'" : "use 'flip yes'");
}

void FixContactTri::setup(int vflag)
{
  find_first_tool();
  evaluate_variables(0.0);
  checks.jump(motion.pose_now(), motion.by_variable(), state->time_step().now(), model->smallest_spacing());
  check_overlap();
  const bool comes = !overlap_checked && !restored;
  overlap_checked = true;
  post_force(vflag);
  finish_contact();
  if (comes) results.take_springs(state->energy(), 1.0);
  write_output();
}

/* ---------------------------------------------------------------------- one step */

// values of variables at the end of the step that begins, or now where dt is 0
void FixContactTri::evaluate_variables(double dt)
{
  if (!motion.by_variable() && !temperature.by_variable()) return;
  modify->clearstep_compute();
  motion.evaluate(dt);
  if (motion.contradicts(spacing) && comm->me == 0)
    error->warning(FLERR,
                   "Fix contact/tri {}: the velocity variables of fix_modify move are not the rate of its displacement "
                   "variables: forces of damping and friction, and work of the tool, are wrong",
                   id);
  if (temperature.by_variable()) temperature.evaluate(lmp, fmt::format("Fix contact/tri {}", id));
  modify->addstep_compute(update->ntimestep + 1);
}

void FixContactTri::initial_integrate(int)
{
  const double dt = state->time_step().now();
  evaluate_variables(dt);
  if (set.body_type) particles.move(motion.pose(0.0, dt), motion.pose(state->time_step().ahead(), dt));
}

static unsigned effects_of(const ContactSettings &set, const ParticleState &state, int dimension, bool of_triangles)
{
  unsigned effects = 0;
  if (dimension == 3) effects |= TM_CT_3D;
  if (state.has(TM_FX_HEAT)) effects |= TM_CT_HEAT;
  if (set.has_friction()) effects |= TM_CT_FRICTION;
  if (set.approach) effects |= TM_CT_APPROACH;
  if (set.f15) effects |= TM_CT_F15;
  if (set.two_sided) effects |= TM_CT_TWO_SIDED;
  if (of_triangles) effects |= TM_CT_OUTPUT;
  return effects;
}

// at the force point of the step, with what to tell per triangle
tm_contact_args FixContactTri::contact_args(bool of_triangles)
{
  tm_contact_args a = {};
  const tm_pose pose = motion.pose(state->time_step().ahead(), state->time_step().now());
  const tm_state s = state->arrays();
  const tm_records &rec = scene->results().rate_args().rec;
  a.mesh = loop_tool.mesh();
  a.grid = loop_tool.grid();
  a.pose = pose;
  a.reference = tm_pose_to_world(&pose, reference);
  a.deep = spacing;
  a.dt = state->time_step().now();
  a.after = state->time_step().ahead() > 0.0 ? a.dt - state->time_step().ahead() : 0.0;
  a.force_unit = 1.0 / model->units().force;
  a.tool_temperature = temperature.now();
  a.law = laws.loop_read();
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
  a.start = state->start_temperatures().all();
  if (state->has(TM_FX_HEAT)) {
    a.temperature = rec.heat + TM_REC_T;
    a.temperature_stride = TM_REC_HEAT;
    a.source = state->heat_source();
    a.tool_heat = set.body_type ? particles.heat_of_contact() : nullptr;
  }
  a.uneven = scene->results().rate_args().uneven;
  a.xsph_v = scene->results().rate_args().xsph_v;
  if (state->has(TM_FX_LAYER)) {
    a.layer = s.field[TM_F_LAYER];
    a.gradient = scene->results().rate_args().gradient;
    a.tool = number_of(id);
    a.layer_dt = state->time_step().ahead() > 0.0 ? a.dt : 0.0;
  }
  if (state->has(TM_FX_PLASTICITY) && set.shear > 0.0) a.pstrain = s.field[TM_F_PSTRAIN];
  if (first_tool) {
    first_tool->earlier.resize((size_t) TM_EARLIER * std::max(atom->nmax, 1));
    a.earlier = first_tool->earlier.loop_write();
    a.first = first_tool == this;
  }
  if (of_triangles) triangles.hand_to(a, tool.mesh().nt);
  return a;
}

// where the loops run beside each other, the places of contact are looked for while the rates are made
void FixContactTri::before_forces()
{
  if (!state) checks.left_out();
  if (!state || update->setupflag || state->loops().shared()) return;
  tm_contact_args a = contact_args(false);
  a.found = places.begin(atom->nlocal);
  ContactLoops::of(state->loops())
      .look(state->active().stepping(), atom->nlocal, a, effects_of(set, *state, domain->dimension, false));
}

void FixContactTri::post_force(int)
{
  const auto timed = state->clock().timed(this);
  const double dt = state->time_step().now();
  const bool of_triangles = output.needs_values();
  if (!update->setupflag) checks.jump(motion.pose(dt, dt), motion.by_variable(), dt, model->smallest_spacing());
  tm_contact_args a = contact_args(of_triangles);
  a.found = places.take();
  ContactLoops::of(state->loops())
      .contact(state->active().stepping(), atom->nlocal, a, effects_of(set, *state, domain->dimension, of_triangles),
               results.begin());
  if (set.body_type && state->has(TM_FX_CONDUCTION)) particles.take_heat();
  limit_time_step();
}

// what the sums are for; a GPU is not waited for before the end of the step
void FixContactTri::finish_contact()
{
  if (!results.finish()) return;
  particles.check_heat();
  if (state->time_step().ahead() > 0.0) results.add_to(state->energy(), state->time_step().now(), set.body_type != 0);
  const tm_contact_result &sums = results.mine();
  checks.pressed(sums, spacing);
  state->energy().add_spring(sums.spring);
}

void FixContactTri::final_integrate()
{
  const double dt = state->time_step().now();
  const tm_pose half = motion.pose(state->time_step().ahead(), dt);
  if (corrects_late)
    ContactLoops::of(state->loops())
        .late(state->active().stepping(), atom->nlocal, contact_args(false),
              effects_of(set, *state, domain->dimension, false), results.late());
  finish_contact();
  if (corrects_late) results.add_late(state->energy(), dt);
  motion.end_of_step(dt);
  if (set.body_type) particles.move(half, motion.pose_now());
}

void FixContactTri::end_of_step()
{
  if (set.lumped_capacity > 0.0)
    temperature.absorb(state->time_step().now() * results.heat_into_tool(world), model->units().energy);
  write_output();
}

/* ---------------------------------------------------------------------- values */

void FixContactTri::write_output()
{
  if (output.needs_values()) triangles.sum_over_ranks(world, model->units().energy);
  output.write(motion.pose_now(), temperature.now(), triangles, restored);
  array_local = output.local_rows();
  if (array_local) size_local_rows = tool.mesh().nt;
}

const double *FixContactTri::results_now()
{
  scene->check_current(state, fmt::format("Fix contact/tri {}", id));    // of a set-up or step
  finish_contact();
  return results.over_ranks(world, model->units(), spacing);
}

double FixContactTri::compute_vector(int n)
{
  if (n < ContactResults::REFERENCE || n >= ContactResults::FRICTION_POWER) return results_now()[n];
  const tm_pose p = motion.pose_now();
  const tm_vec3 r = tm_pose_to_world(&p, reference);
  return n == 6 ? r.x : n == 7 ? r.y : r.z;
}

double FixContactTri::compute_scalar()
{
  if (temperature.now() == 0.0) scene->check_current(state, fmt::format("Fix contact/tri {}", id));
  return temperature.now();
}

int FixContactTri::image(int *&kinds, double **&rows) { return output.image(motion.pose_now(), kinds, rows); }

std::string FixContactTri::write_surface(const std::string &path, double time)
{
  return output.write_surface(path, motion.pose_now(), temperature.now(), time);
}

ToolQuery FixContactTri::query() const
{
  return {*atom, groupbit, laws, tool.view(), tool.grid(), motion.pose_now(), spacing, set.two_sided};
}

void FixContactTri::touched(int i, double radius, std::vector<Surface> &found)
{
  const ToolQuery q = query();
  if (!q.in_contact(i)) return;
  tm_touch touch[TM_TOUCH_MAX];
  const int n = q.touch(tm_load3(atom->x[i]), std::min(radius, spacing), touch);
  for (int k = 0; k < n; k++) {
    tm_vec3 normal = tm_mat_mul_vec(q.pose.turn, touch[k].normal);
    if (domain->dimension == 2) normal.z = 0.0;
    const double length = tm_vec_norm(normal);
    if (length > 0.0) found.push_back({tm_vec_scale(1.0 / length, normal), touch[k].distance});
  }
}

tm_tool_box FixContactTri::box() const
{
  const double *lo = tool.mesh().lo, *hi = tool.mesh().hi;
  const tm_pose pose = motion.pose_now();
  const tm_mat3 &t = pose.turn;
  return {pose.shift,
          {tm_vec(t.xx, t.yx, t.zx), tm_vec(t.xy, t.yy, t.zy), tm_vec(t.xz, t.yz, t.zz)},
          {lo[0], lo[1], lo[2]},
          {hi[0], hi[1], hi[2]},
          motion.top_speed(lo, hi)};
}

int FixContactTri::pack_forward_comm(int n, int *list, double *buf, int, int *)
{
  particles.pack(n, list, buf);
  return n;
}

void FixContactTri::unpack_forward_comm(int n, int first, double *buf) { particles.unpack(n, first, buf); }

void FixContactTri::post_run()
{
  if (!state || !scene->is_current(state)) return;
  finish_contact();
  const bool pressed = results.pressed(world);
  checks.heat_without_contact(motion.top_speed(tool.mesh().lo, tool.mesh().hi) > 0.0, pressed);
  if (pressed || update->nsteps == 0) return;
  state->atoms().to_host();
  checks.untouched(query(), *model);
}

double FixContactTri::memory_usage()
{
  return tool.bytes() + particles.bytes() + triangles.bytes() + earlier.bytes() + places.bytes();
}
