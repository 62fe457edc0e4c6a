#include "step_results.h"

#include "model.h"
#include "particle_state.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "neighbor.h"
#include "pair.h"

#include <cmath>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

StepResults::StepResults(LAMMPS *lmp, Backend &where, Model &m) :
    Pointers(lmp), backend(where), loops(PairLoops::of(where)), model(m)
{
  rec_main.live_in(where, TM_REC, 2);
  rec_stress.live_in(where, TM_REC_STRESS, 2);
  rec_stab.live_in(where, TM_REC_STAB, 2);
  gradient.live_in(where, 9);
  correction.live_in(where, 6);
  moment.live_in(where, TM_MOMENT_COLUMNS);
  face_next.live_in(where, TM_FACE_COLUMNS);
  for (auto *a : {&uneven, &hourglass_rate, &turn}) a->live_in(where, 3);
  for (auto *a : {&rec_heat, &rec_correction, &rec_size, &rec_hourglass, &heat, &xsph_v, &surface, &artificial,
                  &near_count, &tally, &sides, &ahead, &thin, &force_internal})
    a->live_in(where);
  single_main.live_in(where, TM_REC, 4);
  single_more.live_in(where, TM_MORE, 4);
  single_stab.live_in(where, TM_REC_STAB, 4);
  for (auto *a : {&single_correction, &single_size}) a->live_in(where);
  for (auto *a : {&rec_main, &rec_stress, &rec_stab, &rec_heat, &rec_correction, &rec_size, &rec_hourglass})
    a->call("records");
  for (auto *a : {&single_main, &single_more, &single_stab, &single_correction, &single_size})
    a->call("records in single");
  for (auto *a : {&gradient, &heat, &correction, &xsph_v, &uneven, &hourglass_rate, &moment, &turn, &face_next,
                  &surface, &artificial, &force_internal})
    a->call("rates");
}

void StepResults::resize(const ParticleState &state)
{
  const size_t all = (size_t) atom->nlocal + atom->nghost + 1, own = (size_t) atom->nlocal + 1;
  rec_main.make_room(true, all * TM_REC);
  rec_stress.make_room(state.has(TM_FX_ARTSTRESS), all * TM_REC_STRESS);
  rec_heat.make_room(state.has(TM_FX_HEAT), all * TM_REC_HEAT);
  const bool one_pass = state.has(TM_FX_ONE_PASS), passes = !one_pass;
  rec_stab.make_room(one_pass, all * TM_REC_STAB);
  moment.make_room(one_pass, own * TM_MOMENT_COLUMNS);
  turn.make_room(state.has(TM_FX_FACES), own * 3);
  face_next.make_room(state.has(TM_FX_FACES), own * TM_FACE_COLUMNS);
  rec.faces = state.has(TM_FX_FACES);
  rec_correction.make_room(passes && state.has(TM_FX_CORRECTION), all * TM_REC_CORRECTION);
  rec_size.make_room(state.has(TM_FX_SMOOTHING), all * TM_REC_SIZE);
  rec_hourglass.make_room(passes && state.has(TM_FX_HOURGLASS), all * TM_REC_HOURGLASS);
  gradient.make_room(true, own * 9);
  heat.make_room(state.has(TM_FX_CONDUCTION), own);
  correction.make_room(state.has(TM_FX_CORRECTION), own * 6);
  xsph_v.make_room(state.has(TM_FX_XSPH), own * 3);
  uneven.make_room(state.has(TM_FX_SHIFTING), own * 3);
  hourglass_rate.make_room(state.has(TM_FX_HOURGLASS), own * 3);
  surface.make_room(state.has(TM_FX_SURFACE), own * 3);
  sides.make_room(state.has(TM_FX_BODIES), all * TM_BODY_SIDE * model.sides());
  artificial.make_room(state.has(TM_FX_LEDGER) || state.has(TM_FX_ENERGY) || state.has(TM_FX_ARTIFICIAL_HEAT), own);
  force_internal.make_room(state.has(TM_FX_LEDGER), own * 3);
  take_up_ghosts();
  rec.correction = rec_correction.loop_write();
  rec.hourglass = rec_hourglass.loop_write();
}

void StepResults::take_up_ghosts()
{
  rec.main = rec_main.loop_write();
  rec.stress = rec_stress.loop_write();
  rec.heat = rec_heat.loop_write();
  rec.size = rec_size.loop_write();
  rec.stab = rec_stab.loop_write();
}

tm_records StepResults::host_records()
{
  tm_records r;
  r.main = const_cast<tm_real *>(rec_main.host_read());
  r.stress = const_cast<tm_real *>(rec_stress.host_read());
  r.heat = const_cast<tm_real *>(rec_heat.host_read());
  r.correction = const_cast<tm_real *>(rec_correction.host_read());
  r.size = const_cast<tm_real *>(rec_size.host_read());
  r.hourglass = const_cast<tm_real *>(rec_hourglass.host_read());
  r.stab = const_cast<tm_real *>(rec_stab.host_read());
  r.faces = rec.faces;
  return r;
}

StepResults::Rates StepResults::host_rates()
{
  return {gradient.host_read(), heat.host_read(), xsph_v.host_read(), correction.host_read(), turn.host_read()};
}

/* ---------------------------------------------------------------------- arguments of the loops */

// what the gradient correction makes of the stress comes behind the prediction, at the set-up of a run too, and so does
// what keeps heat from particles that sleep
bool StepResults::rounds_in_prediction(ParticleState &state)
{
  const bool corrects = state.has(TM_FX_CORRECTION);
  const bool later = corrects && (!state.has(TM_FX_ONE_PASS) || state.time_step().ahead() == 0.0);
  return state.has(TM_FX_MIXED) && !later && !state.active().on();
}

tm_predict_args StepResults::predict_args(ParticleState &state, const tm_state &s)
{
  const Settings &set = model.settings_in_use();
  tm_predict_args a;
  a.state = s;
  a.rec = rec;
  a.dt_ahead = state.time_step().ahead();
  a.art_eps = set.art_eps;
  a.art_component = set.art_component;
  a.share = model.loop_tables().share.loop_read();
  a.ratio = set.ratio;
  a.hourglass = set.hourglass;
  a.visc_alpha = set.visc_alpha;
  a.shock = state.effect_plan().shock;
  a.h = state.has(TM_FX_SMOOTHING) ? set.ratio * model.smallest_spacing() : set.h;
  a.correction = correction.loop_write();
  a.turn = turn.loop_write();
  a.gradient = model.loop_tables().gradient.loop_read();
  a.single = {};
  if (rounds_in_prediction(state)) a.single = single_records(state);
  return a;
}

tm_rates_args &StepResults::fill_args(ParticleState &state, const tm_state &s)
{
  const Settings &set = model.settings_in_use();
  args.rec = rec;
  args.single = single_records(state);
  args.effects = state.effects();
  args.h = set.h;
  args.support_radius2 = model.support() * model.support();
  args.norm = tm_kernel_norm(set.kernel, domain->dimension, set.h);
  args.slope_norm = args.norm / (set.h * model.lattice_sums().gradient);
  args.support2 = tm_kernel_support(set.kernel) * tm_kernel_support(set.kernel);
  args.norm_of_one = tm_kernel_norm(set.kernel, domain->dimension, 1.0);
  args.visc_alpha = set.visc_alpha;
  args.visc_beta = set.visc_beta;
  args.art_n = set.art_n;
  args.art_inv_w = 1.0 / tm_kernel_shape(set.kernel, set.spacing / set.h);
  args.xsph = set.xsph;
  args.force_unit = 1.0 / model.units().force;
  args.conductance = model.loop_tables().conductance.loop_read();
  args.type = s.type;
  args.ntypes = model.types();
  args.force = s.force;
  args.gradient = gradient.loop_write();
  args.heat = heat.loop_write();
  args.correction = correction.loop_write();
  args.xsph_v = xsph_v.loop_write();
  args.uneven = uneven.loop_write();
  args.hourglass_rate = hourglass_rate.loop_write();
  args.moment = moment.loop_write();
  args.turn = turn.loop_write();
  args.face_next = face_next.loop_write();
  args.surface = surface.loop_write();
  args.surface_of_pass = model.pair_laws().of_one_density(model.materials());
  args.artificial = artificial.loop_write();
  return args;
}

double single_position_unit(const Model &model, double skin)
{
  const Settings &set = model.settings_in_use();
  return tm_single_position_unit(tm_kernel_support(set.kernel) * model.covered_h() + skin, set.spacing);
}

tm_records_single StepResults::single_records(const ParticleState &state)
{
  const bool mixed = state.has(TM_FX_MIXED), more = state.has(TM_FX_ARTSTRESS) || state.has(TM_FX_CONDUCTION);
  const size_t all = (size_t) atom->nlocal + atom->nghost + 1;
  const double spacing = model.settings_in_use().spacing;
  single_main.make_room(mixed, all * TM_REC);
  single_more.make_room(mixed && more, all * TM_MORE);
  single_stab.make_room(mixed && state.has(TM_FX_ONE_PASS), all * TM_REC_STAB);
  single_correction.make_room(mixed && state.has(TM_FX_CORRECTION) && !state.has(TM_FX_ONE_PASS),
                              all * TM_REC_CORRECTION);
  single_size.make_room(mixed && state.has(TM_FX_SMOOTHING), all * TM_REC_SIZE);
  tm_records_single s = {};
  s.main = single_main.loop_write();
  s.more = single_more.loop_write();
  s.correction = single_correction.loop_write();
  s.size = single_size.loop_write();
  s.stab = single_stab.loop_write();
  s.length = spacing;
  s.volume = pow(spacing, domain->dimension);
  s.position = (float) single_position_unit(model, neighbor->skin);
  s.visc_alpha = (float) model.settings_in_use().visc_alpha;
  s.visc_beta = (float) model.settings_in_use().visc_beta;
  return s;
}

/* ---------------------------------------------------------------------- ghosts */

tm_ghost_args StepResults::ghosts()
{
  return {rec, communicated ? communicated->loop_write() : nullptr, communicated_columns};
}

// only what travels is brought to the host and back
tm_ghost_args StepResults::host_ghosts(bool to_write)
{
  auto on_host = [to_write](LoopArray<tm_real> &a) {
    return to_write ? a.host_write() : const_cast<tm_real *>(a.host_read());
  };
  if (communicated) return {{}, on_host(*communicated), communicated_columns};
  tm_records r = {};
  r.main = on_host(rec_main);
  r.stress = on_host(rec_stress);
  r.heat = on_host(rec_heat);
  r.size = on_host(rec_size);
  r.stab = on_host(rec_stab);
  r.faces = rec.faces;
  return {r, nullptr, 0};
}

void StepResults::communicate(Pair *pair, LoopArray<tm_real> &values, int columns)
{
  communicated = &values;
  communicated_columns = columns;
  comm->forward_comm(pair, columns);
  communicated = nullptr;
}

void StepResults::communicate_records(Pair *pair)
{
  const tm_ghost_args a = {rec, nullptr, 0};
  comm->forward_comm(pair, tm_ghost_width(&a));
}

void StepResults::communicate_correction(Pair *pair)
{
  communicate(pair, rec_correction, TM_REC_CORRECTION);
  args.rec.correction = rec.correction = rec_correction.loop_write();
}

void StepResults::communicate_hourglass(Pair *pair)
{
  communicate(pair, rec_hourglass, TM_REC_HOURGLASS);
  args.rec.hourglass = rec.hourglass = rec_hourglass.loop_write();
}

/* ---------------------------------------------------------------------- neighbors, memory */

tm_near_args StepResults::near_args(bool of_each)
{
  near_count.make_room(of_each, (size_t) atom->nlocal + 1);
  tm_near_args a;
  a.rows = args.rows;
  a.main = rec.main;
  a.support_radius2 = rec.size ? args.support2 : args.support_radius2;
  a.size = rec.size;
  a.count = near_count.loop_write();
  a.dim = domain->dimension;
  return a;
}

double StepResults::neighbors(bool of_each)
{
  const bool rows = args.support_radius2 && args.rows.first;
  return loops.near_count(backend, rows ? atom->nlocal : 0, near_args(of_each), 0);
}

const tm_real *StepResults::loop_neighbors()
{
  neighbors(true);
  return near_count.loop_read();
}

tm_nearest StepResults::nearest() { return loops.nearest(backend, atom->nlocal, near_args(false), 0); }

LoopArray<tm_real> &StepResults::body_ahead(bool wanted)
{
  ahead.make_room(wanted, TM_AHEAD * ((size_t) atom->nlocal + atom->nghost + 1));
  return ahead;
}

LoopArray<tm_real> &StepResults::body_thin(bool wanted)
{
  thin.make_room(wanted, TM_THIN * ((size_t) atom->nlocal + atom->nghost + 1));
  return thin;
}

tm_real *StepResults::tally_rows(bool per_particle)
{
  tally.make_room(per_particle, (size_t) TM_TALLY * (atom->nlocal + 1));
  return tally.loop_write();
}

std::map<unsigned, double> StepResults::bytes_by_effect(unsigned effects) const
{
  std::map<unsigned, double> bytes;
  bytes[0] = rec_main.bytes() + gradient.bytes();
  for (auto *a : {&single_main, &single_more, &single_correction, &single_size, &single_stab}) bytes[0] += a->bytes();
  bytes[TM_FX_ARTSTRESS] = rec_stress.bytes();
  bytes[TM_FX_HEAT] = rec_heat.bytes();
  bytes[TM_FX_CONDUCTION] = heat.bytes();
  bytes[TM_FX_CORRECTION] = rec_correction.bytes() + correction.bytes() + moment.bytes() + rec_stab.bytes();
  bytes[TM_FX_FACES] = turn.bytes() + face_next.bytes();
  bytes[TM_FX_SMOOTHING] = rec_size.bytes();
  bytes[TM_FX_XSPH] = xsph_v.bytes();
  bytes[TM_FX_SHIFTING] = uneven.bytes();
  bytes[TM_FX_HOURGLASS] = rec_hourglass.bytes() + hourglass_rate.bytes();
  bytes[TM_FX_SURFACE] = surface.bytes();
  bytes[TM_FX_BODIES] = sides.bytes() + ahead.bytes() + thin.bytes();
  bytes[TM_FX_LEDGER] = force_internal.bytes();
  bytes[effects & TM_FX_LEDGER   ? TM_FX_LEDGER
        : effects & TM_FX_ENERGY ? TM_FX_ENERGY
                                 : TM_FX_ARTIFICIAL_HEAT] += artificial.bytes();
  return bytes;
}

}    // namespace SPHTM_NS
