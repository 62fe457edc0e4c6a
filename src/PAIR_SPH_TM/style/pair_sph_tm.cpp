/* SPH-TM: pair style sph/tm. See doc/pair_sph_tm.rst. No physics here: tm_rates.h and its kin. */
#include "pair_sph_tm.h"

#include "body_loops.h"
#include "contact_probe.h"
#include "model_checks.h"
#include "model_input.h"
#include "model_restart.h"
#include "restart_scan.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "force.h"
#include "memory.h"
#include "modify.h"
#include "neighbor.h"
#include "utils.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

using namespace LAMMPS_NS;
using namespace SPHTM_NS;

PairSPHTM::PairSPHTM(LAMMPS *lmp, Backend &where) :
    Pair(lmp), backend(where), loops(PairLoops::of(where)), scene(Scene::of(lmp)), model(lmp, where),
    rows(new NeighborRows(lmp, this, where, model)), results(lmp, where, model), conduction(lmp, this, where, results),
    interior(where), restart(new ModelRestart(lmp))
{
  restartinfo = 1;
  single_enable = 0;
  one_coeff = 0;
  manybody_flag = 1;    // forces depend on the state, not on pair distance alone
  no_virial_fdotr_compute = 1;
  centroidstressflag = CENTROID_NOTAVAIL;
  // the most a record can hold: Comm::init() sizes its buffers by it, before the effects are known
  comm_forward = TM_REC - 3 + TM_REC_STRESS + TM_REC_HEAT + TM_REC_SIZE + TM_REC_STAB;
  scene->enter(&model, rows.get(), &results, &conduction);
}

PairSPHTM::~PairSPHTM()
{
  scene->leave(&model);
  if (allocated) {
    memory->destroy(setflag);
    memory->destroy(cutsq);
  }
}

void *PairSPHTM::extract(const char *what, int &dim)
{
  dim = 0;
  spacing = model.settings_in_use().spacing;
  h = model.settings_in_use().h;
  if (strcmp(what, "spacing") == 0) return &spacing;
  if (strcmp(what, "h") == 0) return &h;
  return nullptr;
}

/* ---------------------------------------------------------------------- commands */

void PairSPHTM::allocate()
{
  allocated = 1;
  const int n = atom->ntypes + 1;
  memory->create(setflag, n, n, "pair:setflag");
  memory->create(cutsq, n, n, "pair:cutsq");
  for (int i = 1; i < n; i++)
    for (int j = 1; j < n; j++) setflag[i][j] = 1;    // init_style names the type without material
  model.resize(atom->ntypes);
}

void PairSPHTM::settings(int narg, char **arg)
{
  const Settings before = model.settings_in_use();
  model.set(read_settings(lmp, narg, arg));
  if (results.has_stepped()) check_spacing_kept(lmp, before, model.settings_in_use());
}

void PairSPHTM::coeff(int narg, char **arg)
{
  if (model.settings_in_use().spacing <= 0.0) error->all(FLERR, "Pair_coeff of sph/tm before pair_style sph/tm");
  if (!allocated) allocate();
  read_coefficients(lmp, narg, arg, model);
}

void PairSPHTM::init_style()
{
  check_materials(lmp, model, force->pair == this ? "" : "sph/tm ");
  model.prepare();
  model.complete_laws();
  std::vector<int> side;
  comm_forward = std::max(comm_forward, (int) TM_BODY_SIDE * model.pair_laws().contact_sides(side));
  restart->compare(model);

  state = &scene->state("Pair style sph/tm");
  scene->bind();
  check_styles(lmp, model, restart->fix_id(), *state);
  check_volume(lmp, model, *state);
  check_masses(lmp, model, *state);
  if (model.settings_in_use().mixed) check_mixed(lmp, model, backend);
  set_skin(lmp, model);
  check_bins(lmp, model);
  rows->init(*state, scene->adaptation().rows);
  model.set_time_scale(scene->time_scale());
  model.make_tables(state->start_temperatures().of_all());
  if (!rows->source() && !state->active().on()) neighbor->add_request(this, NeighConst::REQ_FULL);
}

void PairSPHTM::init_list(int, NeighList *ptr) { list = ptr; }

double PairSPHTM::init_one(int i, int j)
{
  if (setflag[i][j] == 0) error->all(FLERR, "Pair sph/tm: no law for types {} and {}", i, j);
  return model.support();
}

/* ---------------------------------------------------------------------- ghosts */

int PairSPHTM::pack_forward_comm(int n, int *sendlist, double *buf, int, int *)
{
  const tm_ghost_args a = results.host_ghosts(false);
  const int width = tm_ghost_width(&a);
  for (int k = 0; k < n; k++) tm_ghost_pack(sendlist[k], &a, buf + (size_t) k * width);
  return n * width;
}

void PairSPHTM::unpack_forward_comm(int n, int first, double *buf)
{
  const tm_ghost_args a = results.host_ghosts(true);
  const int width = tm_ghost_width(&a);
  for (int k = 0; k < n; k++) tm_ghost_unpack(first + k, &a, buf + (size_t) k * width);
}

void PairSPHTM::take_ghost_positions()
{
  double **x = atom->x;
  for (int i = atom->nlocal; i < atom->nlocal + atom->nghost; i++)
    std::copy_n(x[i], 3, results.records().main + (size_t) i * TM_REC);
}

/* ---------------------------------------------------------------------- one step */

void PairSPHTM::predict(const tm_state &s, bool renewed)
{
  const auto timed = state->clock().timed(RunClock::PREDICT);
  Backend &those = renewed ? backend : state->active().stepping();    // what sleeps has the same record until then
  loops.predict(those, atom->nlocal, results.predict_args(*state, s), state->effects());
  if (renewed) state->active().insulate(results.records());
}

void PairSPHTM::exchange_records()
{
  const auto timed = state->clock().timed(RunClock::COMMUNICATION);
  results.communicate_records(this);
  take_ghost_positions();
  results.take_up_ghosts();
}

// Whether rates of the interior can run beside the exchange. SPHTM_OVERLAP=1 has it wherever it is possible, 0 nowhere, for
// tests
bool PairSPHTM::overlaps() const
{
  constexpr int FEW = 20000;    // particles, whose rates take less time than to launch them in two parts
  const char *want = getenv("SPHTM_OVERLAP");
  if (want ? want[0] == '0' : !records_travel() || atom->nlocal < FEW) return false;
  const bool one_pass = state->has(TM_FX_ONE_PASS) && state->time_step().ahead() > 0.0;
  return one_pass && atom->nghost > 0 && !rows->source() && !state->active().on() && !state->owner().audit_now() &&
         (!state->has(TM_FX_MIXED) || results.rounds_in_prediction(*state));
}

void PairSPHTM::begin_rates(const tm_rates_args &args, bool renewed)
{
  if (renewed) interior.forget();
  rates_begun = overlaps();
  if (!rates_begun) return;
  const auto timed = state->clock().timed(RunClock::RATES);
  if (!interior.known(atom->nlocal)) interior.sort(args.rows, atom->nlocal);
  PairLoops::run_rates(loops.begin_rates, interior.inside(), atom->nlocal, args, state->effects());
}

// needs the positions of all neighbors; what it makes of the stress, the ghosts need
void PairSPHTM::correct_gradients(int n, tm_rates_args &ul)
{
  const auto timed = state->clock().timed(RunClock::MOMENTS);
  loops.correction(backend, n, ul, state->effects());
  if (rows->source()) rows->source()->tl_corrections(results.rate_args(), state->effects());
  results.communicate_correction(this);
  ul.rec.correction = results.rate_args().rec.correction;
}

// at the set-up of a run there is no force point before it
void PairSPHTM::correct_first(tm_rates_args &args)
{
  const auto timed = state->clock().timed(RunClock::MOMENTS);
  loops.correction(state->active().stepping(), atom->nlocal, args, state->effects());
  results.communicate_records(this);
  take_ghost_positions();
  results.take_up_ghosts();
  args.rec = results.records();
}

void PairSPHTM::control_hourglass(const tm_rates_args &rates)
{
  results.communicate_hourglass(this);
  const auto timed = state->clock().timed(RunClock::HOURGLASS);
  loops.hourglass(backend, atom->nlocal, rates, state->effects());
}

void PairSPHTM::compute(int eflag, int vflag)
{
  ev_init(eflag, vflag);
  state->owner().begin_forces();
  const bool renewed = neighbor->ago == 0;
  RowSource *source = rows->source();
  state->time_step().set_stages_possible(!source || !source->has_tl());
  if (!source && (renewed || !rows->cover(atom->nlocal))) {
    const auto timed = state->clock().timed(RunClock::ROWS);
    if (state->active().on()) state->active().renew(*scene, this);
    else rows->build(list, state->has(TM_FX_CONDUCTION));
  }
  results.resize(*state);
  const tm_state s = state->arrays();
  predict(s, renewed);
  tm_rates_args &args = results.fill_args(*state, s);
  if (!source) args.rows = rows->loop_rows();
  double *internal = clear_forces(s, args);
  begin_rates(args, renewed);
  exchange_records();
  args.rec = results.records();
  if (source) {
    const auto timed = state->clock().timed(RunClock::ROWS);
    source->renew(renewed);
    args.rows = source->mechanical();
  }
  const bool counts = !state->time_step().conducts_in_stages() || state->has(TM_FX_SURFACE);
  const bool thermal = counts && state->has(TM_FX_CONDUCTION) && model.pair_laws().has_thermal();
  tm_rates_args others = args;
  if (source) others.rows = source->others();
  for (ContactProbe *tool : scene->contact_probes()) tool->before_forces();
  if (thermal) loops.begin_thermal(state->active().stepping(), atom->nlocal, others, state->effects());
  rates(s, args, internal);
  others = args;
  if (source) others.rows = source->others();
  conduction.set_rows(args.rows, others.rows);
  if (thermal) {
    const auto timed = state->clock().timed(RunClock::THERMAL);
    loops.thermal(state->active().stepping(), atom->nlocal, others, state->effects());
  }
  if (state->has(TM_FX_BODIES)) body_contact(others);
  if (eflag || vflag) tally_virial_energy();
}

// The forces of the pairs go apart from others for the energy balance or an audit, into the array that is returned, or
// to the others. LAMMPS has not cleared these where it leaves that to the pair style.
double *PairSPHTM::clear_forces(const tm_state &s, tm_rates_args &args)
{
  const int nlocal = atom->nlocal;
  backend.zero(args.artificial, args.artificial ? nlocal * sizeof(double) : 0);
  const bool source = rows->source();
  StepAudit *audited = state->owner().audit_now();
  if (audited) audited->pair_force().make_room(!state->has(TM_FX_LEDGER), 3 * (size_t) nlocal + 3);
  double *internal = pair_force(audited).loop_write();
  const bool clear = fuse_force_clear_flag && force->pair == this && !modify->n_pre_force;
  const bool some = source || state->active().on();    // of the forces are written by the rates
  if (clear && (internal || force->newton || some))    // with newton LAMMPS adds those of ghosts to their owners'
    backend.zero(s.force, 3 * ((size_t) nlocal + atom->nghost) * sizeof(double));
  if (internal && some) backend.zero(internal, 3 * nlocal * sizeof(double));
  if (internal) args.force = internal;
  args.force_begins = (clear || internal) && !source;    // parts of rows add theirs
  return internal;
}

LoopArray<double> &PairSPHTM::pair_force(StepAudit *audited)
{
  return audited && !state->has(TM_FX_LEDGER) ? audited->pair_force() : results.pair_force();
}

// of mechanical pairs: gradients, forces, conduction
void PairSPHTM::rates(const tm_state &s, tm_rates_args &args, double *internal)
{
  const int nlocal = atom->nlocal;
  const unsigned effects = state->effects();
  RowSource *source = rows->source();
  tm_rates_args ul = args;    // of updated-Lagrangian pairs
  const int n_ul = source ? source->ul_rows(ul) : nlocal;
  if (effects & TM_FX_ONE_PASS) {
    if (state->time_step().ahead() == 0.0) correct_first(args);
  } else if (effects & TM_FX_CORRECTION) correct_gradients(n_ul, ul);
  if (source) source->tl_export(results.records());
  if (effects & TM_FX_MIXED) {
    const auto timed = state->clock().timed(RunClock::RATES);
    const auto round = [&](Backend &those, int first, int n) {
      if (n) loops.round_to_single(those, n, {args.rec, args.single, first}, effects);
    };
    if (!results.rounds_in_prediction(*state))
      round(neighbor->ago == 0 ? backend : state->active().stepping(), 0, nlocal);
    round(backend, nlocal, atom->nghost);
  }
  {
    const auto timed = state->clock().timed(RunClock::RATES);
    if (rates_begun) PairLoops::run_rates(loops.end_rates, interior.boundary(), nlocal, ul, effects);
    else loops.rates(state->active().stepping(), n_ul, ul, effects);
    rates_begun = false;
    if (source) source->tl_rates(args, effects);
  }
  if ((effects & TM_FX_HOURGLASS) && !(effects & TM_FX_ONE_PASS)) control_hourglass(args);
  StepAudit *audited = state->owner().audit_now();
  if (audited) audit(*audited, pair_force(audited));
  args.force = s.force;
  if (internal) loops.add(backend, 3 * nlocal, {s.force, internal}, effects);
}

void PairSPHTM::audit(StepAudit &audited, LoopArray<double> &force)
{
  const auto timed = state->clock().timed_rarely(&audited);
  const StepResults::Rates r = results.host_rates();
  audited.audit({force.host_read(), r.gradient, r.heat, r.xsph, r.turn, r.correction});
}

void PairSPHTM::body_contact(const tm_rates_args &others)
{
  const auto timed = state->clock().timed(RunClock::BODIES);
  const int nlocal = atom->nlocal;
  if (model.sides() == 0) return;    // forced on, without bodies
  const BodyLoops &of_bodies = BodyLoops::of(backend);
  Model::Tables &tables = model.loop_tables();
  tm_body_contact_args b;
  b.law = tables.law.loop_read();
  b.side = tables.side.loop_read();
  b.sides = model.sides();
  b.effusivity = tables.effusivity.loop_read();
  b.surface = model.body_surface();
  b.spacing = model.settings_in_use().spacing;
  b.dt = state->time_step().now();
  b.after = state->time_step().ahead() > 0.0 ? b.dt - state->time_step().ahead() : 0.0;
  b.mask = state->arrays().mask;
  b.start = state->start_temperatures().all();
  b.source = state->heat_source();
  LoopArray<tm_real> &ahead = results.body_ahead(model.pair_laws().has_friction());
  if (model.pair_laws().has_friction()) {
    of_bodies.ahead(backend, nlocal, {state->arrays(), b.dt, others.force_unit, ahead.loop_write()}, state->effects());
    results.communicate(this, ahead, TM_AHEAD);
  }
  b.ahead = ahead.loop_write();
  const bool layers = tables.strains.size() && state->has(TM_FX_LAYER);
  LoopArray<tm_real> &thin = results.body_thin(layers);
  b.layer = layers ? state->arrays().field[TM_F_LAYER] : nullptr;
  b.layer_dt = state->time_step().ahead() > 0.0 ? b.dt : 0.0;
  b.strains = tables.strains.loop_read();
  b.thin = thin.loop_write();
  if (layers) {
    of_bodies.thin(backend, nlocal, {others, b}, state->effects());
    results.communicate(this, thin, TM_THIN);
    b.thin = thin.loop_write();
  }
  b.sides_of = results.body_sides().loop_write();
  // springs and what friction dissipates; then forces, from the sides of both
  state->energy().add_body_contact(of_bodies.touch(backend, nlocal, {others, b}, state->effects()), b.dt);
  results.communicate(this, results.body_sides(), b.sides * TM_BODY_SIDE);
  b.sides_of = results.body_sides().loop_write();
  state->energy().add_body_contact(of_bodies.contact(backend, nlocal, {others, b}, state->effects()), b.dt);
}

// virial of the stress, -V sigma, and the elastic energy stored in it; both in the units of the run
void PairSPHTM::tally_virial_energy()
{
  const bool per_atom = vflag_atom || eflag_atom;
  tm_tally_args a;
  a.rec = results.records();
  a.state = state->arrays();
  a.to_energy = 1.0 / model.units().energy;
  a.per_particle = results.tally_rows(per_atom);
  const tm_tally_result sum = loops.tally(backend, atom->nlocal, a, state->effects());
  if (eflag_global) eng_vdwl += sum.value[0];
  if (vflag_global)
    for (int k = 0; k < 6; k++) virial[k] += sum.value[1 + k];
  const double *row = results.host_tally();
  for (int i = 0; per_atom && i < atom->nlocal; i++, row += TM_TALLY) {
    if (eflag_atom) eatom[i] += row[0];
    if (vflag_atom)
      for (int k = 0; k < 6; k++) vatom[i][k] += row[1 + k];
  }
}

/* ---------------------------------------------------------------------- restart, memory */

void PairSPHTM::write_restart(FILE *fp)
{
  write_restart_settings(fp);
  ModelRestart::write(fp, model, scene->is_bound() ? state->id() : "", fix_names_hash(lmp), setflag);
}

void PairSPHTM::read_restart(FILE *fp)
{
  read_restart_settings(fp);
  allocate();
  restart->read(fp, model, setflag);
}

void PairSPHTM::write_restart_settings(FILE *fp) { ModelRestart::write_settings(fp, model.settings_in_use()); }
void PairSPHTM::read_restart_settings(FILE *fp)
{
  model.set_restart_file(restart->name_of_file(fp));
  model.set(restart->read_settings(fp));
}

double PairSPHTM::memory_usage()
{
  double bytes = Pair::memory_usage() + rows->bytes() + interior.bytes();
  if (!scene->is_bound()) return bytes;
  bytes += state->active().bytes();
  for (const auto &b : results.bytes_by_effect(state->effects())) bytes += b.second;
  return bytes;
}
