/* SPH-TM: pair style sph/tm. See doc/pair_sph_tm.rst. No physics here: tm_rates.h and its kin. */
#include "pair_sph_tm.h"

#include "argument.h"
#include "fix_sph_tm.h"
#include "material_input.h"
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

static const char *const KERNEL_NAMES[TM_KERNEL_COUNT] = {"hyperbolic", "cubic", "quintic",
                                                          "wendland/c2", "wendland/c4"};

PairSPHTM::PairSPHTM(LAMMPS *lmp) : Pair(lmp)
{
  restartinfo = 1;
  single_enable = 0;
  one_coeff = 0;
  manybody_flag = 1;    // forces depend on the state, not on pair distance alone
  no_virial_fdotr_compute = 1;
  centroidstressflag = CENTROID_NOTAVAIL;
  // the most a record can hold: Comm::init() sizes its buffers by it, before the effects are known
  comm_forward = TM_REC - 3 + TM_REC_STRESS + TM_REC_HEAT + TM_REC_CORRECTION;
}

PairSPHTM::~PairSPHTM()
{
  if (allocated) {
    memory->destroy(setflag);
    memory->destroy(cutsq);
  }
}

void PairSPHTM::allocate()
{
  allocated = 1;
  atom_types = atom->ntypes;
  const int n = atom_types + 1;
  memory->create(setflag, n, n, "pair:setflag");
  memory->create(cutsq, n, n, "pair:cutsq");
  for (int i = 1; i < n; i++)
    for (int j = 1; j < n; j++) setflag[i][j] = 1;    // init_style names the type without material
  material.assign(n, tm_material{});
  names.assign(n, "");
  laws.assign((size_t) n * n, PairLaw());
}

/* ---------------------------------------------------------------------- */

void PairSPHTM::settings(int narg, char **arg)
{
  if (narg < 4)
    error->all(FLERR, "Illegal pair_style sph/tm: expected 'sph/tm <kernel> <h/spacing> spacing "
                      "<dp> ...', got {} arguments", narg);
  set = Settings();
  const std::string style = "Pair style sph/tm ";
  int kernel = -1;
  for (int k = 0; k < TM_KERNEL_COUNT; k++)
    if (strcmp(arg[0], KERNEL_NAMES[k]) == 0) kernel = k;
  if (kernel < 0)
    error->all(FLERR, "Unknown pair style sph/tm kernel {}: choose hyperbolic, cubic, quintic, "
                      "wendland/c2 or wendland/c4", arg[0]);
  set.kernel = kernel;
  set.ratio = positive(lmp, style + "ratio of smoothing length to spacing", arg[1]);
  if (set.ratio < 0.8 || set.ratio > 4.0)
    error->all(FLERR, "Pair style sph/tm ratio of smoothing length to spacing must be between 0.8 "
                      "and 4, got {}", arg[1]);

  for (int iarg = 2; iarg < narg;) {
    const std::string key = arg[iarg];
    auto args = [&](int n) {
      if (iarg + n >= narg)
        error->all(FLERR, "Pair style sph/tm keyword {} needs {} value{}", key, n,
                   n == 1 ? "" : "s");
    };
    if (key == "spacing") {
      args(1);
      set.spacing = positive(lmp, style + "spacing", arg[iarg + 1]);
      iarg += 2;
    } else if (key == "viscosity") {
      args(2);
      set.visc_alpha = not_negative(lmp, style + "viscosity alpha", arg[iarg + 1]);
      set.visc_beta = not_negative(lmp, style + "viscosity beta", arg[iarg + 2]);
      iarg += 3;
    } else if (key == "balsara") {
      args(1);
      set.balsara = yes_no(lmp, style + key, arg[iarg + 1]);
      iarg += 2;
    } else if (key == "artstress") {
      args(2);
      set.art_eps = not_negative(lmp, style + "artstress epsilon", arg[iarg + 1]);
      set.art_n = integer_within(lmp, style + "artstress exponent", arg[iarg + 2], 1, 8);
      if (set.art_eps > 1.0)
        error->all(FLERR, "Pair style sph/tm artstress epsilon must be 0 to 1, got {}",
                   arg[iarg + 1]);
      iarg += 3;
      if (iarg < narg && (strcmp(arg[iarg], "component") == 0 || strcmp(arg[iarg], "principal") == 0)) {
        set.art_component = arg[iarg][0] == 'c';
        iarg++;
      }
    } else if (key == "xsph") {
      args(1);
      set.xsph = not_negative(lmp, style + "xsph epsilon", arg[iarg + 1]);
      if (set.xsph > 1.0)
        error->all(FLERR, "Pair style sph/tm xsph epsilon must be 0 to 1, got {}", arg[iarg + 1]);
      iarg += 2;
    } else if (key == "form") {
      args(1);
      if (strcmp(arg[iarg + 1], "f15") == 0) set.form_f14 = false;
      else if (strcmp(arg[iarg + 1], "f14") == 0) set.form_f14 = true;
      else error->all(FLERR, "Pair style sph/tm form must be f15 or f14, got {}", arg[iarg + 1]);
      iarg += 2;
    } else if (key == "correction") {
      args(1);
      set.correction = yes_no(lmp, style + key, arg[iarg + 1]);
      iarg += 2;
    } else if (key == "plane") {
      args(1);
      if (strcmp(arg[iarg + 1], "stress") == 0) set.plane_stress = true;
      else if (strcmp(arg[iarg + 1], "strain") == 0) set.plane_stress = false;
      else error->all(FLERR, "Pair style sph/tm plane must be strain or stress, got {}", arg[iarg + 1]);
      iarg += 2;
    } else
      error->all(FLERR, "Unknown pair style sph/tm keyword {}: known are spacing, viscosity, "
                        "balsara, artstress, xsph, form, correction, plane", key);
  }
  if (set.spacing <= 0.0)
    error->all(FLERR, "Pair style sph/tm needs the keyword spacing with the particle spacing");
  if (set.correction && set.form_f14)
    error->all(FLERR, "Pair style sph/tm correction yes needs form f15");
  set.h = set.ratio * set.spacing;
}

/* ---------------------------------------------------------------------- */

void PairSPHTM::coeff(int narg, char **arg)
{
  if (set.spacing <= 0.0) error->all(FLERR, "Pair_coeff of sph/tm before pair_style sph/tm");
  if (!allocated) allocate();
  if (narg < 3) error->all(FLERR, "Pair sph/tm coeff needs two types and a material or a law");
  unit = unit_scale(lmp);

  int ilo, ihi, jlo, jhi;
  utils::bounds(FLERR, arg[0], 1, atom->ntypes, ilo, ihi, error);
  utils::bounds(FLERR, arg[1], 1, atom->ntypes, jlo, jhi, error);

  static const char *const meetings[] = {"bond", "none", "contact", "heat"};
  const bool meeting = std::any_of(std::begin(meetings), std::end(meetings),
                                   [&](const char *m) { return strcmp(arg[2], m) == 0; }) &&
      !(strcmp(arg[2], "heat") == 0 && ilo == jlo && ihi == jhi && ilo == ihi);
  if (meeting) {
    parse_meeting(narg, arg);
    return;
  }
  if (std::max(ilo, jlo) > std::min(ihi, jhi))
    error->all(FLERR, "Pair sph/tm coeff {0} {1}: a material belongs to one type; write 'pair_coeff {1} {1} ...', "
                      "and for two types bond, none, heat or contact", arg[0], arg[1]);
  const tm_material m = read_material(lmp, "Pair sph/tm coeff", narg - 2, arg + 2);
  int count = 0;
  for (int i = ilo; i <= ihi; i++)
    for (int j = std::max(jlo, i); j <= jhi; j++) {
      setflag[i][j] = 1;
      count++;
      if (i != j) continue;
      material[i] = m;
      scale_material(material[i], unit);
      names[i] = material_title(narg - 2, arg + 2);
      if (!atom->rmass_flag && !atom->mass_setflag[i]) atom->set_mass(FLERR, i, particle_mass(i));
    }
  if (count == 0) error->all(FLERR, "Pair sph/tm coeff: no type pair in {} {}", arg[0], arg[1]);
}

// from density and spacing; in 2D of a plate of unit thickness
double PairSPHTM::particle_mass(int type) const
{
  return material[type].rho0 * pow(set.spacing, domain->dimension);
}

// how two types meet: bond | none | heat [conductance hc] | contact [friction mu] [penalty PFAC]
// [damping DFAC] [conductance hc]
void PairSPHTM::parse_meeting(int narg, char **arg)
{
  int ilo, ihi, jlo, jhi;
  utils::bounds(FLERR, arg[0], 1, atom->ntypes, ilo, ihi, error);
  utils::bounds(FLERR, arg[1], 1, atom->ntypes, jlo, jhi, error);
  const std::string what = arg[2];
  PairLaw law;
  law.meeting = what == "bond" ? BOND : what == "none" ? NONE : what == "heat" ? HEAT_ONLY : CONTACT;
  law.contact.friction = 0.0;
  law.contact.penalty = 1.0;
  law.contact.damping = 0.2;
  law.conductance = what == "contact" ? -1.0 : 0.0;    // contact: no heat unless asked
  for (int iarg = 3; iarg < narg; iarg += 2) {
    const std::string key = arg[iarg];
    if (iarg + 1 >= narg)
      error->all(FLERR, "Pair sph/tm coeff {} keyword {} needs a value", what, key);
    const char *val = arg[iarg + 1];
    if (key == "conductance" && (law.meeting == HEAT_ONLY || law.meeting == CONTACT)) {
      law.conductance = strcmp(val, "perfect") == 0 ? 0.0
          : positive(lmp, "Pair sph/tm coeff " + what + " conductance", val) * unit.energy;
    } else if (key == "friction" && law.meeting == CONTACT)
      law.contact.friction = not_negative(lmp, "Pair sph/tm coeff contact friction", val);
    else if (key == "penalty" && law.meeting == CONTACT)
      law.contact.penalty = positive(lmp, "Pair sph/tm coeff contact penalty", val);
    else if (key == "damping" && law.meeting == CONTACT)
      law.contact.damping = not_negative(lmp, "Pair sph/tm coeff contact damping", val);
    else
      error->all(FLERR, "Unknown pair sph/tm coeff {} keyword {}: known {}", what, key,
                 law.meeting == CONTACT ? "are friction, penalty, damping and conductance"
                     : law.meeting == HEAT_ONLY ? "is conductance" : "is none");
  }
  int count = 0;
  for (int i = ilo; i <= ihi; i++)
    for (int j = jlo; j <= jhi; j++) {
      if (i == j) continue;
      set_law(i, j, law);
      count++;
    }
  if (count == 0)
    error->all(FLERR, "Pair sph/tm coeff {} needs two different types, got {} {}", what, arg[0],
               arg[1]);
}

void PairSPHTM::set_law(int i, int j, const PairLaw &law)
{
  laws[i * (atom_types + 1) + j] = law;
  laws[j * (atom_types + 1) + i] = law;
  setflag[std::min(i, j)][std::max(i, j)] = 1;
}

// what the script left open: solids are one continuum, a heat body meets all by perfect conduction
void PairSPHTM::complete_laws()
{
  for (int i = 1; i <= atom_types; i++)
    for (int j = i; j <= atom_types; j++) {
      PairLaw l = law(i, j);
      const bool heat_i = material[i].body == TM_BODY_HEAT, heat_j = material[j].body == TM_BODY_HEAT;
      if (l.meeting == UNSET) l.meeting = (heat_i || heat_j) ? HEAT_ONLY : BOND;
      if ((heat_i || heat_j) && (l.meeting == BOND || l.meeting == CONTACT))
        error->all(FLERR, "Pair sph/tm coeff {} {}: a heat body takes no part in mechanics; use "
                          "'heat' or 'none'", i, j);
      set_law(i, j, l);
    }
  const int n = atom_types + 1;
  conductance_table.assign((size_t) n * n, 0.0);
  bool any = false;
  for (int k = 0; k < n * n; k++) {
    conductance_table[k] = laws[k].conductance > 0.0 ? laws[k].conductance * lattice.interface : 0.0;
    any = any || conductance_table[k] > 0.0;
  }
  if (!any) conductance_table.clear();
}

/* ---------------------------------------------------------------------- */

void PairSPHTM::init_style()
{
  for (int i = 1; i <= atom->ntypes; i++)
    if (material[i].rho0 <= 0.0)
      error->all(FLERR, "Pair sph/tm: no material for atom type {}; write 'pair_coeff {} {} "
                        "<file> <card>' or the constants inline", i, i, i);
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
  neighbor->add_request(this, NeighConst::REQ_FULL);
}

void PairSPHTM::check_masses()
{
  auto differs = [&](double mass, int type) {
    return fabs(mass - particle_mass(type)) > 1e-6 * particle_mass(type);
  };
  std::vector<bigint> wrong(atom->ntypes + 1, 0), all(atom->ntypes + 1, 0);
  if (atom->rmass_flag) {
    for (int i = 0; i < atom->nlocal; i++) wrong[atom->type[i]] += differs(atom->rmass[i], atom->type[i]);
    MPI_Allreduce(wrong.data(), all.data(), atom->ntypes + 1, MPI_LMP_BIGINT, MPI_SUM, world);
  }
  if (comm->me) return;
  for (int t = 1; t <= atom->ntypes; t++)
    if (all[t])
      error->warning(FLERR, "Pair sph/tm: {} particles of type {} have a mass of their own, density times spacing "
                            "gives {:.8g}; 'set type {} mass {:.8g}' sets it", all[t], t, particle_mass(t), t,
                     particle_mass(t));
    else if (!atom->rmass_flag && differs(atom->mass[t], t))
      error->warning(FLERR, "Pair sph/tm: mass of type {} is {:.8g}, density times spacing gives "
                            "{:.8g}; the mass is kept. Without a mass command it follows from the material", t, atom->mass[t], particle_mass(t));
}

// a spacing in another unit than the box: before LAMMPS complains about its bins
void PairSPHTM::check_volume()
{
  const int dim = domain->dimension;
  double box = 1.0;
  for (int d = 0; d < dim; d++) box *= domain->prd[d];
  const double needed = (double) atom->natoms * pow(set.spacing, dim);
  if (needed > 3.0 * box)
    error->all(FLERR, "Pair style sph/tm spacing {:.8g}: {} particles would need {} of {:.6g}, the box has {:.6g}; "
                      "give the spacing of the particles in the length unit of the run", set.spacing, atom->natoms,
               dim == 3 ? "a volume" : "an area", needed, box);
}

// what the set-up tells about spacing and overlaps: the closest mechanical neighbours
PairSPHTM::Closest PairSPHTM::closest() const
{
  Closest c;
  double **x = atom->x;
  for (int i = 0; i < atom->nlocal; i++) {
    double least = 1e300;
    for (int k = 0; k < row_mechanical[i]; k++) {
      const int j = row_index[row_first[i] + k];
      const double dx = x[i][0] - x[j][0], dy = x[i][1] - x[j][1], dz = x[i][2] - x[j][2];
      const double r = sqrt(dx * dx + dy * dy + dz * dz);
      if (r < c.distance) {
        c.distance = r;
        c.i = i;
        c.j = j;
      }
      least = std::min(least, r);
    }
    if (least < 1e300) {
      c.sum += least;
      c.count++;
    }
  }
  return c;
}

void PairSPHTM::init_list(int, NeighList *ptr) { list = ptr; }

double PairSPHTM::init_one(int i, int j)
{
  if (setflag[i][j] == 0) error->all(FLERR, "Pair sph/tm: no law for types {} and {}", i, j);
  return tm_kernel_support(set.kernel) * set.h;
}

/* ----------------------------------------------------------------------
   rows: mechanical neighbours, heat-only ones, contact candidates; each
   segment sorted by tag, so that sums do not depend on the order in memory
------------------------------------------------------------------------- */

void PairSPHTM::build_rows()
{
  const int nlocal = atom->nlocal, *type = atom->type;
  const tagint *tag = atom->tag;
  const bool heat_on = fix->has(TM_FX_CONDUCTION);
  const int n1 = atom_types + 1;
  row_first.resize(nlocal + 1);
  row_mechanical.resize(nlocal + 1);
  row_thermal.resize(nlocal + 1);
  row_contact.resize(nlocal + 1);
  row_index.clear();

  struct Entry {
    tagint tag;
    int j;
  };
  std::vector<Entry> part[3];
  auto by_tag = [](const Entry &a, const Entry &b) {
    return a.tag != b.tag ? a.tag < b.tag : a.j < b.j;
  };
  std::vector<int> order(nlocal, -1);
  for (int ii = 0; ii < list->inum; ii++) order[list->ilist[ii]] = ii;

  double **x = atom->x;
  const double cut = tm_kernel_support(set.kernel) * set.h + neighbor->skin;
  const double cut2 = cut * cut;
  for (int i = 0; i < nlocal; i++) {
    for (auto &p : part) p.clear();
    row_first[i] = (ptrdiff_t) row_index.size();
    if (order[i] >= 0) {
      const int *jlist = list->firstneigh[i], jnum = list->numneigh[i];
      for (int jj = 0; jj < jnum; jj++) {
        const int j = jlist[jj] & NEIGHMASK;
        const double dx = x[i][0] - x[j][0], dy = x[i][1] - x[j][1], dz = x[i][2] - x[j][2];
        if (dx * dx + dy * dy + dz * dz > cut2) continue;
        const PairLaw &l = laws[type[i] * n1 + type[j]];
        const bool conducts = heat_on &&
            (l.meeting == HEAT_ONLY || (l.meeting == CONTACT && l.conductance >= 0.0));
        // a contact pair that also conducts stands in both segments
        if (l.meeting == BOND && material[type[i]].body == TM_BODY_SOLID)
          part[0].push_back({tag[j], j});
        if (conducts) part[1].push_back({tag[j], j});
        if (l.meeting == CONTACT) part[2].push_back({tag[j], j});
      }
    }
    for (auto &p : part) {
      std::sort(p.begin(), p.end(), by_tag);
      for (const auto &e : p) row_index.push_back(e.j);
    }
    row_mechanical[i] = (int) part[0].size();
    row_thermal[i] = (int) part[1].size();
    row_contact[i] = (int) part[2].size();
  }
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
  fit(moment, fix->has(TM_FX_CORRECTION), own * 9);
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
  args.moment = ptr(moment);
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
  a.conduct = 1.0 / lattice.gradient;
  predict_loop()(atom->nlocal, &a, fix->effects());
}

void PairSPHTM::forward_records()
{
  const int width = TM_REC - 3 + (rec.stress ? TM_REC_STRESS : 0) + (rec.heat ? TM_REC_HEAT : 0) +
      (rec.correction ? TM_REC_CORRECTION : 0);
  comm->forward_comm(this, width);
  double **x = atom->x;
  for (int i = atom->nlocal; i < atom->nlocal + atom->nghost; i++)
    std::copy_n(x[i], 3, rec.main + (size_t) i * TM_REC);
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
    put(rec.main + j * TM_REC + 3, TM_REC - 3);
    if (rec.stress) put(rec.stress + j * TM_REC_STRESS, TM_REC_STRESS);
    if (rec.heat) put(rec.heat + j * TM_REC_HEAT, TM_REC_HEAT);
    if (rec.correction) put(rec.correction + j * TM_REC_CORRECTION, TM_REC_CORRECTION);
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
    get(rec.main + j * TM_REC + 3, TM_REC - 3);
    if (rec.stress) get(rec.stress + j * TM_REC_STRESS, TM_REC_STRESS);
    if (rec.heat) get(rec.heat + j * TM_REC_HEAT, TM_REC_HEAT);
    if (rec.correction) get(rec.correction + j * TM_REC_CORRECTION, TM_REC_CORRECTION);
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

/* ---------------------------------------------------------------------- */

void PairSPHTM::write_restart(FILE *fp)
{
  write_restart_settings(fp);
  char id[64] = {};
  if (fix) strncpy(id, fix->id, sizeof(id) - 1);
  fwrite(id, sizeof(id), 1, fp);
  const int n = atom_types + 1;
  fwrite(&atom_types, sizeof(int), 1, fp);
  for (int i = 1; i < n; i++) {
    fwrite(&material[i], sizeof(tm_material), 1, fp);
    char title[64] = {};
    strncpy(title, names[i].c_str(), sizeof(title) - 1);
    fwrite(title, sizeof(title), 1, fp);
    for (int j = 1; j < n; j++) {
      fwrite(&setflag[std::min(i, j)][std::max(i, j)], sizeof(int), 1, fp);
      fwrite(&law(i, j), sizeof(PairLaw), 1, fp);
    }
  }
}

void PairSPHTM::read_restart(FILE *fp)
{
  read_restart_settings(fp);
  allocate();
  unit = unit_scale(lmp);
  auto read = [&](void *p, size_t bytes) {
    if (comm->me == 0) utils::sfread(FLERR, p, 1, bytes, fp, nullptr, error);
    MPI_Bcast(p, (int) bytes, MPI_BYTE, 0, world);
  };
  char id[64];
  read(id, sizeof(id));
  restart_fix = id;
  int types = 0;
  read(&types, sizeof(int));
  if (types != atom->ntypes)
    error->all(FLERR, "Pair sph/tm: restart file has {} types, simulation {}", types, atom->ntypes);
  for (int i = 1; i <= types; i++) {
    read(&material[i], sizeof(tm_material));
    char title[64];
    read(title, sizeof(title));
    names[i] = title;
    for (int j = 1; j <= types; j++) {
      int flag;
      read(&flag, sizeof(int));
      setflag[std::min(i, j)][std::max(i, j)] = flag;
      read(&laws[i * (atom_types + 1) + j], sizeof(PairLaw));
    }
  }
}

void PairSPHTM::write_restart_settings(FILE *fp) { fwrite(&set, sizeof(Settings), 1, fp); }

void PairSPHTM::read_restart_settings(FILE *fp)
{
  if (comm->me == 0) utils::sfread(FLERR, &set, sizeof(Settings), 1, fp, nullptr, error);
  MPI_Bcast(&set, sizeof(Settings), MPI_BYTE, 0, world);
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
  for (auto *v : {&rec_main, &rec_stress, &rec_heat, &rec_correction, &gradient, &heat, &moment,
                  &xsph_v, &surface, &artificial})
    bytes += v->capacity() * sizeof(double);
  return bytes;
}
