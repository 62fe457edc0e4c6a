/* SPH-TM: pair style sph/tm. See doc/pair_sph_tm.rst. No physics here: tm_rates.h and its kin. */
#include "pair_sph_tm.h"

#include "fix_sph_tm.h"
#include "tm_thermal.h"

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

PairSPHTM::PairSPHTM(LAMMPS *lmp) : Pair(lmp)
{
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
  make_room();
  neighbor->add_request(this, NeighConst::REQ_FULL);
}

void PairSPHTM::init_list(int, NeighList *ptr) { list = ptr; }

double PairSPHTM::init_one(int i, int j)
{
  if (setflag[i][j] == 0) error->all(FLERR, "Pair sph/tm: no law for types {} and {}", i, j);
  return tm_kernel_support(set.kernel) * set.h;
}

void PairSPHTM::resize_arrays()
{
  const size_t all = (size_t) atom->nlocal + atom->nghost + 1, own = (size_t) atom->nlocal + 1;
  auto fit = [](auto &v, bool on, size_t n) {
    if (!on) {
      if (!v.empty()) typename std::decay<decltype(v)>::type().swap(v);
    } else if (v.size() < n)
      v.resize(n + n / 8);
  };
  fit(rec_main, true, all * TM_REC);
  fit(rec_stress, fix->has(TM_FX_ARTSTRESS), all * TM_REC_STRESS);
  fit(rec_heat, fix->has(TM_FX_HEAT), all * TM_REC_HEAT);
  fit(rec_correction, fix->has(TM_FX_CORRECTION), all * TM_REC_CORRECTION);
  fit(gradient, true, own * 9);
  fit(heat, fix->has(TM_FX_CONDUCTION), own);
  fit(correction, fix->has(TM_FX_CORRECTION), own * 6);
  fit(xsph_v, fix->has(TM_FX_XSPH), own * 3);
  fit(surface, fix->has(TM_FX_SURFACE), own * 3);
  fit(artificial, fix->has(TM_FX_LEDGER) || fix->has(TM_FX_ENERGY), own);
  fit(force_internal, fix->has(TM_FX_LEDGER), own * 3);
  rec.main = rec_main.data();
  rec.stress = rec_stress.empty() ? nullptr : rec_stress.data();
  rec.heat = rec_heat.empty() ? nullptr : rec_heat.data();
  rec.correction = rec_correction.empty() ? nullptr : rec_correction.data();
}

void PairSPHTM::fill_args()
{
  auto ptr = [](auto &v) { return v.empty() ? nullptr : v.data(); };
  args.rows.index = row_index.data();
  args.rows.first = row_first.data();
  args.rows.mechanical = row_mechanical.data();
  args.rows.thermal = row_thermal.data();
  args.rows.contact = row_contact.data();
  args.rows.stride = 1;
  args.rec = rec;
  args.effects = fix->effects();
  args.h = set.h;
  const double reach = tm_kernel_support(set.kernel) * set.h;
  args.reach2 = reach * reach;
  args.norm = tm_kernel_norm(set.kernel, domain->dimension, set.h);
  args.slope_norm = args.norm / (set.h * lattice.gradient);
  args.visc_alpha = set.visc_alpha;
  args.visc_beta = set.visc_beta;
  args.art_n = set.art_n;
  args.art_inv_w = 1.0 / tm_kernel_shape(set.kernel, set.spacing / set.h);
  args.xsph = set.xsph;
  args.force_unit = 1.0 / unit.force;
  args.conductance = ptr(conductance_table);
  args.type = atom->type;
  args.ntypes = atom_types;
  args.force = atom->nlocal ? &atom->f[0][0] : nullptr;
  args.gradient = gradient.data();
  args.heat = ptr(heat);
  args.correction = ptr(correction);
  args.xsph_v = ptr(xsph_v);
  args.surface = ptr(surface);
  args.artificial = ptr(artificial);
}

/* ---------------------------------------------------------------------- */

void PairSPHTM::predict()
{
  tm_predict_args a;
  a.state = fix->state();
  a.rec = rec;
  a.dt_ahead = fix->time_ahead();
  a.art_eps = set.art_eps;
  a.art_component = set.art_component;
  predict_loop()(atom->nlocal, &a, fix->effects());
}

void PairSPHTM::forward_records()
{
  const int width = TM_REC - 3 + (rec.stress ? TM_REC_STRESS : 0) + (rec.heat ? TM_REC_HEAT : 0);
  comm->forward_comm(this, width);
  double **x = atom->x;
  for (int i = atom->nlocal; i < atom->nlocal + atom->nghost; i++)
    std::copy_n(x[i], 3, rec.main + (size_t) i * TM_REC);
}

// needs the positions of all neighbours; what it makes of the stress, the ghosts need
void PairSPHTM::correct_gradients()
{
  if (atom->nlocal) moment_loop(fix->effects())(atom->nlocal, &args);
  forward_correction = true;
  comm->forward_comm(this, TM_REC_CORRECTION);
  forward_correction = false;
}

int PairSPHTM::pack_forward_comm(int n, int *sendlist, double *buf, int, int *)
{
  int m = 0;
  auto put = [&](const tm_real *row, int count) {
    std::copy_n(row, count, buf + m);
    m += count;
  };
  for (int k = 0; k < n; k++) {
    const size_t j = sendlist[k];
    if (forward_correction) {
      put(rec.correction + j * TM_REC_CORRECTION, TM_REC_CORRECTION);
      continue;
    }
    put(rec.main + j * TM_REC + 3, TM_REC - 3);
    if (rec.stress) put(rec.stress + j * TM_REC_STRESS, TM_REC_STRESS);
    if (rec.heat) put(rec.heat + j * TM_REC_HEAT, TM_REC_HEAT);
  }
  return m;
}

void PairSPHTM::unpack_forward_comm(int n, int first, double *buf)
{
  int m = 0;
  auto get = [&](tm_real *row, int count) {
    std::copy_n(buf + m, count, row);
    m += count;
  };
  for (size_t j = first; j < (size_t) first + n; j++) {
    if (forward_correction) {
      get(rec.correction + j * TM_REC_CORRECTION, TM_REC_CORRECTION);
      continue;
    }
    get(rec.main + j * TM_REC + 3, TM_REC - 3);
    if (rec.stress) get(rec.stress + j * TM_REC_STRESS, TM_REC_STRESS);
    if (rec.heat) get(rec.heat + j * TM_REC_HEAT, TM_REC_HEAT);
  }
}

/* ---------------------------------------------------------------------- */

void PairSPHTM::compute(int eflag, int vflag)
{
  ev_init(eflag, vflag);
  const int nlocal = atom->nlocal;
  const unsigned fx = fix->effects();
  if (neighbor->ago == 0 || (int) row_first.size() < nlocal) build_rows();
  resize_arrays();
  predict();
  forward_records();
  fill_args();
  if (loop_effects != fx) {
    loop_effects = fx;
    loop = rate_loop(fx);
  }
  if (fx & TM_FX_CORRECTION) correct_gradients();
  if (!artificial.empty()) std::fill_n(artificial.begin(), nlocal, 0.0);
  if (fx & TM_FX_LEDGER)
    for (int i = 0; i < 3 * nlocal; i++) force_internal[i] = -(&atom->f[0][0])[i];
  if (nlocal) loop(nlocal, &args);
  if (fx & TM_FX_LEDGER)
    for (int i = 0; i < 3 * nlocal; i++) force_internal[i] += (&atom->f[0][0])[i];
  if (fx & TM_FX_CONDUCTION)
    for (int i = 0; i < nlocal; i++)
      if (row_thermal[i]) tm_thermal(i, &args, fx);
  if (fx & TM_FX_BODIES) body_contact();
  if (eflag || vflag) tally_virial_energy(eflag, vflag);
}

void PairSPHTM::body_contact()
{
  const int n1 = atom_types + 1;
  std::vector<tm_body_law> law_table((size_t) n1 * n1);
  std::vector<int> meets((size_t) n1 * n1);
  std::vector<double> young(n1), effusivity(n1);
  for (int k = 0; k < n1 * n1; k++) {
    law_table[k] = laws[k].contact;
    meets[k] = laws[k].meeting == CONTACT;
  }
  for (int t = 1; t < n1; t++) {
    const tm_material &m = material[t];
    young[t] = m.young;
    const double T = fix->start_temperature();
    effusivity[t] = m.heat ? sqrt(tm_conductivity(&m, T) * tm_capacity(&m, T) * m.rho0) : 0.0;
  }
  tm_body_contact_args b;
  b.law = law_table.data();
  b.contact = meets.data();
  b.young = young.data();
  b.effusivity = effusivity.data();
  b.spacing = set.spacing;
  b.dt = fix->step_dt();
  b.source = fix->heat_source();
  double spring = 0.0;
  for (int i = 0; i < atom->nlocal; i++) {
    if (!row_contact[i]) continue;
    double *f = atom->f[i];
    const double f0[3] = {f[0], f[1], f[2]};
    const double q0 = b.source ? b.source[i] : 0.0;
    const tm_body_contact_result r = tm_body_contact(i, &args, &b, fix->effects());
    if (!r.contacts) continue;
    const double *v = rec.main + (size_t) i * TM_REC + 4;
    const double heat_in = b.source ? b.source[i] - q0 : 0.0;
    spring += r.spring;
    fix->ledger.contact_damping += b.dt * r.damping_power;
    fix->ledger.friction += b.dt * (r.friction_power - heat_in);
    fix->ledger.friction_heat += b.dt * heat_in;
    fix->ledger.contact_work += b.dt * unit.force *
        ((f[0] - f0[0]) * v[0] + (f[1] - f0[1]) * v[1] + (f[2] - f0[2]) * v[2]);
  }
  fix->contact_spring += spring;
}

// virial of the stress, -V sigma, and the elastic energy stored in it; both in the units of the run
void PairSPHTM::tally_virial_energy(int, int)
{
  const bool per_atom = vflag_atom || eflag_atom;
  const double to_energy = 1.0 / unit.energy;
  for (int i = 0; i < atom->nlocal; i++) {
    const tm_material &m = material[atom->type[i]];
    if (m.body != TM_BODY_SOLID) continue;
    const tm_real *r = rec.main + (size_t) i * TM_REC, *p = r + TM_REC_P;
    const double rho = r[TM_REC_RHO];
    const double scale = (fix->has(TM_FX_FORM_F14) ? 1.0 : rho * rho) * r[TM_REC_M] / rho;
    double w[6];
    for (int k = 0; k < 6; k++) w[k] = -scale * p[k] * to_energy;
    const tm_sym3 sigma = tm_sym_scale(rho / r[TM_REC_M] * scale, tm_sym_load(p));
    const tm_sym3 s = tm_sym_deviator(sigma);
    const double pressure = -tm_sym_trace(sigma) / 3.0;
    const double e = r[TM_REC_M] / rho * to_energy *
        (tm_sym_ddot(s, s) / (4.0 * m.shear) + pressure * pressure / (2.0 * m.bulk));
    if (eflag_global) eng_vdwl += e;
    if (vflag_global)
      for (int k = 0; k < 6; k++) virial[k] += w[k];
    if (per_atom && eflag_atom) eatom[i] += e;
    if (per_atom && vflag_atom)
      for (int k = 0; k < 6; k++) vatom[i][k] += w[k];
  }
}

/* ---------------------------------------------------------------------- */

double PairSPHTM::neighbors_per_particle() const
{
  double sum = 0.0;
  for (int i = 0; i < atom->nlocal; i++) sum += count_neighbors(i);
  return atom->nlocal ? sum / atom->nlocal : 0.0;
}

int PairSPHTM::count_neighbors(int i) const
{
  if ((int) row_first.size() <= i || !args.reach2) return 0;
  int count = 0;
  double **x = atom->x;
  for (int k = 0; k < row_mechanical[i]; k++) {
    const int j = row_index[row_first[i] + k];
    const double dx = x[i][0] - x[j][0], dy = x[i][1] - x[j][1], dz = x[i][2] - x[j][2];
    count += dx * dx + dy * dy + dz * dz < args.reach2;
  }
  return count;
}

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
        (domain->dimension == 3 ? set.spacing : 1.0);
    const double mass = pow(set.spacing, domain->dimension) *
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

double PairSPHTM::memory_usage()
{
  double bytes = Pair::memory_usage();
  bytes += row_index.capacity() * sizeof(int);
  for (auto *v : {&rec_main, &rec_stress, &rec_heat, &rec_correction, &gradient, &heat, &correction,
                  &xsph_v, &surface, &artificial})
    bytes += v->capacity() * sizeof(double);
  return bytes;
}
