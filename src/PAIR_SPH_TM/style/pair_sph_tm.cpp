/* SPH-TM: pair style sph/tm, the force step. See doc/pair_sph_tm.rst. No physics here: tm_rates.h and its kin. */
#include "pair_sph_tm.h"

#include "accuracy_meter.h"
#include "fix_sph_tm.h"

#include "atom.h"
#include "domain.h"
#include "force.h"
#include "memory.h"
#include "modify.h"
#include "neighbor.h"

#include <cstring>

using namespace LAMMPS_NS;
using namespace SPHTM_NS;

PairSPHTM::PairSPHTM(LAMMPS *lmp, Backend &where) : Pair(lmp), backend(where), loops(PairLoops::of(where))
{
  tables.live_in(where);
  for (auto *a : {&row_index, &row_mechanical, &row_thermal, &row_contact}) a->live_in(where);
  row_first.live_in(where);
  rec_main.live_in(where, TM_REC, 2);
  rec_stress.live_in(where, TM_REC_STRESS, 2);
  gradient.live_in(where, 9);
  for (auto *a : {&rec_heat, &rec_correction, &rec_size, &rec_hourglass, &heat, &correction, &xsph_v, &hourglass_rate,
                  &surface, &artificial, &near_count, &tally, &force_internal})
    a->live_in(where);
  single_main.live_in(where, TM_REC, 4);
  single_more.live_in(where, TM_MORE, 4);
  for (auto *a : {&single_correction, &single_size}) a->live_in(where);
  restartinfo = 1;
  single_enable = 0;
  one_coeff = 0;
  manybody_flag = 1;    // forces depend on the state, not on pair distance alone
  no_virial_fdotr_compute = 1;
  centroidstressflag = CENTROID_NOTAVAIL;
  // the most a record can hold: Comm::init() sizes its buffers by it, before the effects are known
  comm_forward = TM_REC - 3 + TM_REC_STRESS + TM_REC_HEAT;
}

PairSPHTM::~PairSPHTM()
{
  if (allocated) {
    memory->destroy(setflag);
    memory->destroy(cutsq);
  }
}

void *PairSPHTM::extract(const char *what, int &dim)
{
  dim = 0;
  if (strcmp(what, "spacing") == 0) return &set.spacing;
  if (strcmp(what, "h") == 0) return &set.h;
  return nullptr;
}

bool PairSPHTM::has_fix() const { return fix && FixSPHTM::of(lmp) == fix; }

const int *PairSPHTM::loop_tags() { return (const int *) atom->tag; }

void PairSPHTM::fill_args(const tm_state &s)
{
  if (!row_source)
    args.rows = {row_index.loop_read(),   row_first.loop_read(),   row_mechanical.loop_read(),
                 row_thermal.loop_read(), row_contact.loop_read(), row_stride};
  args.rec = rec;
  args.single = single_records();
  args.effects = fix->effects();
  args.h = set.h;
  const double reach = tm_kernel_support(set.kernel) * set.h;
  args.reach2 = reach * reach;
  args.norm = tm_kernel_norm(set.kernel, domain->dimension, set.h);
  args.slope_norm = args.norm / (set.h * lattice.gradient);
  args.support2 = tm_kernel_support(set.kernel) * tm_kernel_support(set.kernel);
  args.norm_of_one = tm_kernel_norm(set.kernel, domain->dimension, 1.0);
  args.visc_alpha = set.visc_alpha;
  args.visc_beta = set.visc_beta;
  args.art_n = set.art_n;
  args.art_inv_w = 1.0 / tm_kernel_shape(set.kernel, set.spacing / set.h);
  args.xsph = set.xsph;
  args.force_unit = 1.0 / unit.force;
  args.conductance = tables.conductance.loop_read();
  args.type = s.type;
  args.ntypes = atom_types;
  args.force = s.force;
  args.gradient = gradient.loop_write();
  args.heat = heat.loop_write();
  args.correction = correction.loop_write();
  args.xsph_v = xsph_v.loop_write();
  args.hourglass_rate = hourglass_rate.loop_write();
  args.surface = surface.loop_write();
  args.artificial = artificial.loop_write();
}

// needs the positions of all neighbours; what it makes of the stress, the ghosts need
void PairSPHTM::correct_gradients(int n, tm_rates_args &search)
{
  const auto timed = fix->run_clock.timed(RunClock::MOMENTS);
  loops.correction(backend, n, search, fix->effects());
  if (row_source) row_source->kept_moments(args, fix->effects());
  forward(rec_correction, TM_REC_CORRECTION);
  search.rec.correction = args.rec.correction = rec.correction = rec_correction.loop_write();
}

void PairSPHTM::resist_hourglass(const tm_rates_args &rates)
{
  forward(rec_hourglass, TM_REC_HOURGLASS);
  const auto timed = fix->run_clock.timed(RunClock::HOURGLASS);
  tm_rates_args a = rates;
  a.rec.hourglass = rec_hourglass.loop_write();    // the host may have filled those of ghosts
  loops.hourglass(backend, atom->nlocal, a, fix->effects());
}

void PairSPHTM::compute(int eflag, int vflag)
{
  ev_init(eflag, vflag);
  fix->begin_forces();
  const int nlocal = atom->nlocal;
  const unsigned fx = fix->effects();
  RunClock &clock = fix->run_clock;
  if (!row_source && (neighbor->ago == 0 || (int) row_first.size() < nlocal)) {
    const auto timed = clock.timed(RunClock::ROWS);
    build_rows();
  }
  resize_arrays();
  const tm_state s = fix->state();
  predict(s);
  forward_records();
  rec.main = rec_main.loop_write();    // the host may have filled those of ghosts
  rec.stress = rec_stress.loop_write();
  rec.heat = rec_heat.loop_write();
  rec.size = rec_size.loop_write();
  fill_args(s);
  if (row_source) {
    const auto timed = clock.timed(RunClock::ROWS);
    row_source->renew(neighbor->ago == 0);
    args.rows = row_source->mechanical();
  }
  tm_rates_args search = args;
  const int searched = row_source ? row_source->searched(search) : nlocal;
  if (fx & TM_FX_CORRECTION) correct_gradients(searched, search);
  if (row_source) row_source->show(rec);
  if (fx & TM_FX_MIXED) round_records();
  search.single = args.single;
  backend.zero(args.artificial, args.artificial ? nlocal * sizeof(double) : 0);
  // the forces of the pairs apart from others, for the energy book or an audit
  AccuracyMeter *meter = fix->audit_now();
  if (meter) meter->force.make_room(!fix->has(TM_FX_LEDGER), 3 * (size_t) nlocal + 3);
  LoopArray<double> &apart = meter && !fix->has(TM_FX_LEDGER) ? meter->force : force_internal;
  double *internal = apart.loop_write();
  // LAMMPS has not cleared the forces where it leaves that to the pair style
  const bool clear = fuse_force_clear_flag && force->pair == this && !modify->n_pre_force;
  if (clear && (internal || force->newton || row_source))    // with newton LAMMPS adds those of ghosts to their owners'
    backend.zero(s.force, 3 * ((size_t) nlocal + atom->nghost) * sizeof(double));
  if (internal) args.force = internal;
  search.force = args.force;
  if (internal && row_source) backend.zero(internal, 3 * nlocal * sizeof(double));
  search.force_begins = args.force_begins = (clear || internal) && !row_source;    // parts of rows add theirs
  {
    const auto timed = clock.timed(RunClock::RATES);
    loops.rates(backend, searched, search, fx);
    if (row_source) row_source->kept_rates(args, fx);
  }
  if (fx & TM_FX_HOURGLASS) resist_hourglass(args);
  if (meter) audit(apart);
  args.force = s.force;
  if (internal) loops.add(backend, 3 * nlocal, {s.force, internal}, fx);
  tm_rates_args others = args;
  if (row_source) others.rows = row_source->others();
  if (meets_thermal) {
    const auto timed = clock.timed(RunClock::THERMAL);
    loops.thermal(backend, nlocal, others, fx);
  }
  if (fx & TM_FX_BODIES) body_contact(others);
  if (eflag || vflag) tally_virial_energy();
}

void PairSPHTM::audit(LoopArray<double> &force)
{
  AccuracyMeter *meter = fix->audit_now();
  const auto timed = fix->run_clock.timed(meter);
  meter->audit({force.host_read(), gradient.host_read(), heat.host_read(), xsph_v.host_read()});
}

void PairSPHTM::body_contact(const tm_rates_args &others)
{
  const auto timed = fix->run_clock.timed(RunClock::BODIES);
  tm_body_contact_args b;
  b.law = tables.law.loop_read();
  b.contact = tables.touch.loop_read();
  b.young = tables.young.loop_read();
  b.effusivity = tables.effusivity.loop_read();
  b.spacing = set.spacing;
  b.dt = fix->step_dt();
  b.source = fix->heat_source();
  const tm_body_contact_result r = loops.body_contact(backend, atom->nlocal, {others, b}, fix->effects());
  fix->contact_spring += r.spring;
  fix->ledger.contact_damping += b.dt * r.damping_power;
  fix->ledger.friction += b.dt * (r.friction_power - r.heat_power);
  fix->ledger.friction_heat += b.dt * r.heat_power;
  fix->ledger.contact_work += b.dt * r.work_power;
}

// virial of the stress, -V sigma, and the elastic energy stored in it; both in the units of the run
void PairSPHTM::tally_virial_energy()
{
  const bool per_atom = vflag_atom || eflag_atom;
  tally.make_room(per_atom, (size_t) TM_TALLY * (atom->nlocal + 1));
  tm_tally_args a;
  a.rec = rec;
  a.type = args.type;
  a.material = loop_materials();
  a.to_energy = 1.0 / unit.energy;
  a.per_particle = tally.loop_write();
  const tm_tally_result sum = loops.tally(backend, atom->nlocal, a, fix->effects());
  if (eflag_global) eng_vdwl += sum.value[0];
  if (vflag_global)
    for (int k = 0; k < 6; k++) virial[k] += sum.value[1 + k];
  const double *row = tally.host_read();
  for (int i = 0; per_atom && i < atom->nlocal; i++, row += TM_TALLY) {
    if (eflag_atom) eatom[i] += row[0];
    if (vflag_atom)
      for (int k = 0; k < 6; k++) vatom[i][k] += row[1 + k];
  }
}
