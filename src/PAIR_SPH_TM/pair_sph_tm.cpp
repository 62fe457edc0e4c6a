/* SPH-TM: pair style sph/tm. See doc/pair_sph_tm.rst. No physics here: tm_rates.h and its kin. */
#include "pair_sph_tm.h"

#include "accuracy_meter.h"
#include "fix_sph_tm.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "force.h"
#include "memory.h"
#include "modify.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "update.h"
#include "utils.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;
using namespace SPHTM_NS;

PairSPHTM::PairSPHTM(LAMMPS *lmp, Backend &loops) : Pair(lmp), backend(loops)
{
  tables.live_in(loops);
  for (auto *a : {&row_index, &row_mechanical, &row_thermal, &row_contact}) a->live_in(loops);
  row_first.live_in(loops);
  rec_main.live_in(loops, TM_REC, 2);
  rec_stress.live_in(loops, TM_REC_STRESS, 2);
  gradient.live_in(loops, 9);
  for (auto *a : {&rec_heat, &rec_correction, &rec_size, &heat, &correction, &xsph_v, &surface, &artificial, &near_count,
                  &tally, &force_internal})
    a->live_in(loops);
  single_main.live_in(loops, TM_REC, 4);
  single_more.live_in(loops, TM_MORE, 4);
  for (auto *a : {&single_correction, &single_size}) a->live_in(loops);
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

/* ---------------------------------------------------------------------- */

void PairSPHTM::init_style()
{
  for (int i = 1; i <= atom->ntypes; i++)
    if (material[i].rho0 <= 0.0)
      error->all(FLERR, "Pair sph/tm: no material for atom type {0}; write 'pair_coeff {0} {0} {1}"
                        "<file> <card>' or the constants inline", i,
                 force->pair == this ? "" : "sph/tm ");
  unit = unit_scale(lmp);
  lattice = tm_lattice_sums(set.kernel, domain->dimension, set.ratio);
  heat_rate = lattice.heat_rate;
  list_h = set.h;
  least_spacing = set.spacing;
  surface_scale = tm_surface_make(set.kernel, domain->dimension, set.spacing, set.h, TM_SURFACE_THRESHOLD);
  complete_laws();

  auto fixes = modify->get_fix_by_style("^sph/tm$");
  if (fixes.empty())
    error->all(FLERR, "Pair style sph/tm needs a fix sph/tm that owns the particle state; write "
                      "'fix body all sph/tm'");
  if (fixes.size() > 1)
    error->all(FLERR, "More than one fix sph/tm: one owns the state of all particles of pair style sph/tm; remove "
                      "the others");
  fix = dynamic_cast<FixSPHTM *>(fixes[0]);
  if (!restart_fix.empty() && restart_fix != fix->id && !fix->restored())
    error->all(FLERR, "Fix {} sph/tm: the restart file holds the state of the particles under the fix ID {}; "
                      "write 'fix {} ... sph/tm ...'", fix->id, restart_fix, restart_fix);
  if (set.plane_stress && domain->dimension != 2)
    error->all(FLERR, "Pair style sph/tm plane stress needs dimension 2");

  check_volume();
  check_masses();
  if (set.mixed) check_mixed();

  // the skin of the unit style's default is meant for molecules: take a tenth of the reach
  const double reach = tm_kernel_support(set.kernel) * set.h;
  static const struct { const char *style; double skin; } defaults[] = {
      {"lj", 0.3}, {"real", 2.0}, {"metal", 2.0}, {"si", 0.001}, {"cgs", 0.1}, {"electron", 2.0},
      {"micro", 2.0}, {"nano", 2.0}};
  for (const auto &d : defaults)
    if (strcmp(update->unit_style, d.style) == 0 && neighbor->skin == d.skin) {
      neighbor->skin = 0.1 * reach;
      if (comm->me == 0)
        utils::logmesg(lmp, "sph/tm: neighbor skin {:.6g}, a tenth of the reach\n", neighbor->skin);
    }
  check_list_size(least_spacing);
  make_tables();
  find_row_source();
  if (!row_source) neighbor->add_request(this, NeighConst::REQ_FULL);
}

// fix adapt/neigh with lists of its own
void PairSPHTM::find_row_source()
{
  row_source = nullptr;
  int dim;
  for (Fix *f : modify->get_fix_by_style("^adapt/neigh"))
    if (auto *source = (RowSource *) f->extract(RowSource::NAME, dim)) row_source = source;
}

void PairSPHTM::init_list(int, NeighList *ptr) { list = ptr; }

double PairSPHTM::init_one(int i, int j)
{
  if (setflag[i][j] == 0) error->all(FLERR, "Pair sph/tm: no law for types {} and {}", i, j);
  return tm_kernel_support(set.kernel) * set.h;
}

void PairSPHTM::Tables::live_in(Backend &loops)
{
  material.live_in(loops);
  for (auto *a : {&conductance, &young, &effusivity, &gradient, &share}) a->live_in(loops);
  law.live_in(loops);
  touch.live_in(loops);
}

void PairSPHTM::make_tables()
{
  const int n = atom_types + 1;
  const double T = fix->start_temperature();
  std::vector<double> conductance(n * n), young(n), effusivity(n);
  std::vector<tm_body_law> contact(n * n);
  std::vector<int> touch(n * n);
  bool conducts = false;
  for (int k = 0; k < n * n; k++) {
    conductance[k] = laws[k].conductance > 0.0 ? laws[k].conductance * lattice.interface * lattice.gradient : 0.0;
    conducts = conducts || conductance[k] > 0.0;
    contact[k] = laws[k].contact;
    touch[k] = laws[k].meeting == CONTACT;
  }
  for (int t = 1; t < n; t++) {
    const tm_material &m = material[t];
    young[t] = m.young;
    effusivity[t] = m.heat ? sqrt(tm_conductivity(&m, T) * tm_capacity(&m, T) * m.rho0) : 0.0;
  }
  tables.material.assign(material.data(), n);
  tables.conductance.assign(conductance.data(), conducts ? n * n : 0);
  tables.law.assign(contact.data(), n * n);
  tables.touch.assign(touch.data(), n * n);
  tables.young.assign(young.data(), n);
  tables.effusivity.assign(effusivity.data(), n);
  std::vector<double> share(set.art_balanced && set.art_eps > 0.0 ? TM_GRADIENT_ENTRIES : 0);
  if (!share.empty()) tm_tensile_table(set.kernel, domain->dimension, set.art_n, share.data());
  tables.share.assign(share.data(), share.size());
}

void PairSPHTM::resize_arrays()
{
  const size_t all = (size_t) atom->nlocal + atom->nghost + 1, own = (size_t) atom->nlocal + 1;
  rec_main.make_room(true, all * TM_REC);
  rec_stress.make_room(fix->has(TM_FX_ARTSTRESS), all * TM_REC_STRESS);
  rec_heat.make_room(fix->has(TM_FX_HEAT), all * TM_REC_HEAT);
  rec_correction.make_room(fix->has(TM_FX_CORRECTION), all * TM_REC_CORRECTION);
  rec_size.make_room(fix->has(TM_FX_SMOOTHING), all * TM_REC_SIZE);
  gradient.make_room(true, own * 9);
  heat.make_room(fix->has(TM_FX_CONDUCTION), own);
  correction.make_room(fix->has(TM_FX_CORRECTION), own * 6);
  xsph_v.make_room(fix->has(TM_FX_XSPH), own * 3);
  surface.make_room(fix->has(TM_FX_SURFACE), own * 3);
  artificial.make_room(fix->has(TM_FX_LEDGER) || fix->has(TM_FX_ENERGY), own);
  force_internal.make_room(fix->has(TM_FX_LEDGER), own * 3);
  rec.main = rec_main.loop_write();
  rec.stress = rec_stress.loop_write();
  rec.heat = rec_heat.loop_write();
  rec.correction = rec_correction.loop_write();
  rec.size = rec_size.loop_write();
}

tm_records PairSPHTM::host_records()
{
  tm_records r;
  r.main = const_cast<tm_real *>(rec_main.host_read());
  r.stress = const_cast<tm_real *>(rec_stress.host_read());
  r.heat = const_cast<tm_real *>(rec_heat.host_read());
  r.correction = const_cast<tm_real *>(rec_correction.host_read());
  r.size = const_cast<tm_real *>(rec_size.host_read());
  return r;
}

tm_rows PairSPHTM::host_rows()
{
  if (row_source) return row_source->host_others();
  return {row_index.host_read(),   row_first.host_read(),   row_mechanical.host_read(),
          row_thermal.host_read(), row_contact.host_read(), row_stride};
}

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
  args.surface = surface.loop_write();
  args.artificial = artificial.loop_write();
}

/* ---------------------------------------------------------------------- */

tm_predict_args PairSPHTM::predict_args(const tm_state &s)
{
  tm_predict_args a;
  a.state = s;
  a.rec = rec;
  a.dt_ahead = fix->time_ahead();
  a.art_eps = set.art_eps;
  a.art_component = set.art_component;
  a.share = tensile_shares();
  a.ratio = set.ratio;
  a.gradient = tables.gradient.loop_read();
  return a;
}

void PairSPHTM::predict(const tm_state &s)
{
  const auto timed = fix->run_clock.timed(RunClock::PREDICT);
  backend.predict(atom->nlocal, predict_args(s), fix->effects());
}

int PairSPHTM::forward_columns() const
{
  return TM_REC - 3 + (rec.stress ? TM_REC_STRESS : 0) + (rec.heat ? TM_REC_HEAT : 0) +
      (rec.size ? TM_REC_SIZE : 0);
}

void PairSPHTM::forward_records()
{
  const auto timed = fix->run_clock.timed(RunClock::COMMUNICATION);
  comm->forward_comm(this, forward_columns());
  take_ghost_positions();
}

void PairSPHTM::take_ghost_positions()
{
  double **x = atom->x;
  for (int i = atom->nlocal; i < atom->nlocal + atom->nghost; i++)
    std::copy_n(x[i], 3, rec.main + (size_t) i * TM_REC);
}

// needs the positions of all neighbours; what it makes of the stress, the ghosts need
void PairSPHTM::correct_gradients(int n, tm_rates_args &search)
{
  const auto timed = fix->run_clock.timed(RunClock::MOMENTS);
  backend.moments(n, search, fix->effects());
  forward(rec_correction, TM_REC_CORRECTION);
  search.rec.correction = args.rec.correction = rec.correction = rec_correction.loop_write();
}

void PairSPHTM::forward(LoopArray<tm_real> &values, int columns)
{
  forwarded = &values;
  forwarded_columns = columns;
  comm->forward_comm(this, columns);
  forwarded = nullptr;
}

// only what travels is brought to the host and back
int PairSPHTM::pack_forward_comm(int n, int *sendlist, double *buf, int, int *)
{
  double *start = buf;
  auto put = [&](const tm_real *from, size_t j, int columns) {
    if (from) buf = std::copy_n(from + j * columns, columns, buf);
  };
  if (forwarded) {
    const tm_real *from = forwarded->host_read();
    for (int k = 0; k < n; k++) put(from, sendlist[k], forwarded_columns);
    return (int) (buf - start);
  }
  const tm_real *main = rec_main.host_read(), *stress = rec_stress.host_read(), *heat = rec_heat.host_read();
  const tm_real *size = rec_size.host_read();
  for (int k = 0; k < n; k++) {
    buf = std::copy_n(main + (size_t) sendlist[k] * TM_REC + 3, TM_REC - 3, buf);
    put(stress, sendlist[k], TM_REC_STRESS);
    put(heat, sendlist[k], TM_REC_HEAT);
    put(size, sendlist[k], TM_REC_SIZE);
  }
  return (int) (buf - start);
}

void PairSPHTM::unpack_forward_comm(int n, int first, double *buf)
{
  auto get = [&](tm_real *to, size_t j, int columns) {
    if (!to) return;
    std::copy_n(buf, columns, to + j * columns);
    buf += columns;
  };
  if (forwarded) {
    tm_real *to = forwarded->host_write();
    for (int j = first; j < first + n; j++) get(to, j, forwarded_columns);
    return;
  }
  tm_real *main = rec_main.host_write(), *stress = rec_stress.host_write(), *heat = rec_heat.host_write();
  tm_real *size = rec_size.host_write();
  for (int j = first; j < first + n; j++) {
    std::copy_n(buf, TM_REC - 3, main + (size_t) j * TM_REC + 3);
    buf += TM_REC - 3;
    get(stress, j, TM_REC_STRESS);
    get(heat, j, TM_REC_HEAT);
    get(size, j, TM_REC_SIZE);
  }
}

/* ---------------------------------------------------------------------- */

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
  if (row_source) row_source->show(rec);
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
    backend.rates(searched, search, fx);
    if (row_source) row_source->kept_rates(args, fx);
  }
  if (meter) audit(apart);
  args.force = s.force;
  if (internal) backend.add(s.force, internal, 3 * (size_t) nlocal);
  tm_rates_args others = args;
  if (row_source) others.rows = row_source->others();
  if (meets_thermal) {
    const auto timed = clock.timed(RunClock::THERMAL);
    backend.thermal(nlocal, others, fx);
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
  const tm_body_contact_result r = backend.body_contact(atom->nlocal, others, b, fix->effects());
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
  const tm_tally_result sum = backend.tally(atom->nlocal, a, fix->effects());
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

/* ---------------------------------------------------------------------- */

const int *PairSPHTM::loop_tags() { return (const int *) atom->tag; }

tm_near_args PairSPHTM::near_args(bool of_each)
{
  near_count.make_room(of_each, (size_t) atom->nlocal + 1);
  tm_near_args a;
  a.rows = args.rows;
  a.main = rec.main;
  a.reach2 = rec.size ? args.support2 : args.reach2;
  a.size = rec.size;
  a.count = near_count.loop_write();
  return a;
}

double PairSPHTM::neighbors(bool of_each)
{
  const bool rows = args.reach2 && args.rows.first;
  return backend.near_count(rows ? atom->nlocal : 0, near_args(of_each));
}

const tm_real *PairSPHTM::loop_neighbors()
{
  neighbors(true);
  return near_count.loop_read();
}

tm_nearest PairSPHTM::nearest() { return backend.nearest(atom->nlocal, near_args(false)); }

bool PairSPHTM::has_contact_pairs() const
{
  return std::any_of(laws.begin(), laws.end(),
                     [](const PairLaw &l) { return l.meeting == CONTACT; });
}

double PairSPHTM::largest_conductivity() const
{
  double k = 0.0;
  for (const tm_material &m : material) {
    const tm_table &t = m.conductivity;
    k = std::max(k, t.n ? *std::max_element(t.y, t.y + t.n) : t.value);
  }
  return k;
}

// largest stable step of body contact for a type: 0.2 of the period of the stiffest pair
double PairSPHTM::contact_stiffness_limit(int t) const
{
  double limit = 0.0;
  for (int u = 1; u <= atom_types; u++) {
    const PairLaw &l = law(t, u);
    if (l.meeting != CONTACT) continue;
    const double e1 = material[t].young, e2 = material[u].young;
    const double k = l.contact.penalty * e1 * e2 / (e1 + e2) *
        (domain->dimension == 3 ? least_spacing : 1.0);
    const double mass = pow(least_spacing, domain->dimension) *
        std::min(material[t].rho0, material[u].rho0) * 0.5;
    const double dt = sqrt(mass / k);
    limit = limit > 0.0 ? std::min(limit, dt) : dt;
  }
  return limit;
}

void *PairSPHTM::extract(const char *what, int &dim)
{
  dim = 0;
  if (strcmp(what, "spacing") == 0) return &set.spacing;
  if (strcmp(what, "h") == 0) return &set.h;
  return nullptr;
}

std::map<unsigned, double> PairSPHTM::bytes_by_effect() const
{
  std::map<unsigned, double> bytes;
  bytes[0] = rec_main.bytes() + gradient.bytes();
  for (auto *a : {&single_main, &single_more, &single_correction, &single_size}) bytes[0] += a->bytes();
  bytes[TM_FX_ARTSTRESS] = rec_stress.bytes();
  bytes[TM_FX_HEAT] = rec_heat.bytes();
  bytes[TM_FX_CONDUCTION] = heat.bytes();
  bytes[TM_FX_CORRECTION] = rec_correction.bytes() + correction.bytes();
  bytes[TM_FX_SMOOTHING] = rec_size.bytes();
  bytes[TM_FX_XSPH] = xsph_v.bytes();
  bytes[TM_FX_SURFACE] = surface.bytes();
  bytes[TM_FX_LEDGER] = force_internal.bytes();
  bytes[fix->has(TM_FX_LEDGER) ? TM_FX_LEDGER : TM_FX_ENERGY] += artificial.bytes();
  return bytes;
}

double PairSPHTM::bytes_of_rows() const
{
  double bytes = row_index.bytes() + row_first.bytes();
  for (auto *a : {&row_mechanical, &row_thermal, &row_contact}) bytes += a->bytes();
  return bytes;
}

double PairSPHTM::memory_usage()
{
  double bytes = Pair::memory_usage() + bytes_of_rows();
  for (const auto &b : bytes_by_effect()) bytes += b.second;
  return bytes;
}
