/* SPH-TM: pair style sph/tm, settings, materials and how types meet. See doc/pair_sph_tm.rst. */
#include "pair_sph_tm.h"

#include "argument.h"
#include "material_input.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "lattice.h"
#include "memory.h"
#include "utils.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;
using namespace SPHTM_NS;

const char *PairSPHTM::kernel_name(int kernel)
{
  static const char *const names[TM_KERNEL_COUNT] = {"hyperbolic", "cubic", "quintic", "wendland/c2", "wendland/c4"};
  return names[kernel];
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

double PairSPHTM::lattice_spacing() const
{
  Lattice *lattice = domain->lattice;
  if (!lattice || lattice->style == Lattice::NONE) return 0.0;
  tm_vec3 edge[3], origin = tm_vec(0, 0, 0);
  lattice->lattice2box(origin.x, origin.y, origin.z);
  for (int k = 0; k < 3; k++) {
    edge[k] = tm_vec(k == 0, k == 1, k == 2);
    lattice->lattice2box(edge[k].x, edge[k].y, edge[k].z);
    edge[k] = tm_vec_sub(edge[k], origin);
  }
  const tm_vec3 face = tm_vec_cross(edge[0], edge[1]);
  if (domain->dimension == 2) return sqrt(fabs(face.z) / lattice->nbasis);
  return cbrt(fabs(tm_vec_dot(face, edge[2])) / lattice->nbasis);
}

void PairSPHTM::settings(int narg, char **arg)
{
  if (narg < 4)
    error->all(FLERR, "Illegal pair_style sph/tm: expected 'sph/tm <kernel> <h/spacing> spacing "
                      "<dp> ...', got {} arguments", narg);
  const double spacing_before = stepped ? set.spacing : 0.0;
  set = Settings();
  int kernel = -1;
  for (int k = 0; k < TM_KERNEL_COUNT; k++)
    if (strcmp(arg[0], kernel_name(k)) == 0) kernel = k;
  if (kernel < 0)
    error->all(FLERR, "Unknown pair style sph/tm kernel {}: choose hyperbolic, cubic, quintic, "
                      "wendland/c2 or wendland/c4", arg[0]);
  set.kernel = kernel;
  set.ratio = positive(lmp, "Pair style sph/tm ratio of smoothing length to spacing", arg[1]);
  if (set.ratio < 0.8 || set.ratio > 4.0)
    error->all(FLERR, "Pair style sph/tm ratio of smoothing length to spacing must be between 0.8 "
                      "and 4, got {}", arg[1]);

  Keywords k(lmp, "Pair style sph/tm", narg - 2, arg + 2);
  while (k.next()) {
    if (k.is("spacing")) {
      if (k.take("lattice")) set.spacing = lattice_spacing();
      else {
        set.spacing = k.positive();
        continue;
      }
      if (set.spacing == 0.0)
        error->all(FLERR,
                   "{} lattice: there is no lattice in use; write a lattice command before it, or "
                   "the spacing as a "
                   "number",
                   k.what());
    } else if (k.is("viscosity")) {
      k.need(2);
      set.visc_alpha = k.not_negative("alpha");
      set.visc_beta = k.not_negative("beta");
    } else if (k.is("balsara")) set.balsara = k.yes();
    else if (k.is("artstress")) {
      k.need(2);
      set.art_eps = k.share("epsilon");
      set.art_n = k.integer(1, 8, "exponent");
      if (k.take("component")) set.art_component = true;
      else if (k.take("principal")) set.art_component = false;
      if (k.take("balanced")) set.art_balanced = true;
    } else if (k.is("xsph")) set.xsph = k.share("epsilon");
    else if (k.is("hourglass")) set.hourglass = k.share("xi");
    else if (k.is("form")) set.form_f14 = k.second("f15", "f14");
    else if (k.is("correction")) set.correction = k.yes();
    else if (k.is("plane")) set.plane_stress = k.second("strain", "stress");
    else if (k.is("precision")) set.mixed = k.second("double", "mixed");
    else
      error->all(FLERR, "Unknown pair style sph/tm keyword {}: known are spacing, viscosity, "
                        "balsara, artstress, hourglass, xsph, form, correction, plane, precision", k.name());
  }
  if (set.spacing <= 0.0)
    error->all(FLERR, "Pair style sph/tm needs the keyword spacing with the particle spacing");
  if (set.correction && set.form_f14)
    error->all(FLERR, "Pair style sph/tm correction yes needs form f15");
  if (spacing_before > 0.0 && fabs(set.spacing - spacing_before) > 1e-9 * spacing_before)
    error->all(FLERR, "Pair style sph/tm spacing changed from {:.8g} to {:.8g} after a run; masses and sizes of the particles "
                      "belong to the old one", spacing_before, set.spacing);
  set.h = set.ratio * set.spacing;
}

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
  std::string welded;
  for (int i = 1; i <= atom_types; i++)
    for (int j = i; j <= atom_types; j++) {
      PairLaw l = law(i, j);
      const bool heat_i = material[i].body == TM_BODY_HEAT, heat_j = material[j].body == TM_BODY_HEAT;
      if (l.meeting == UNSET) {
        l.meeting = (heat_i || heat_j) ? HEAT_ONLY : BOND;
        if (i != j && l.meeting == BOND) welded += fmt::format("{}{} and {}", welded.empty() ? "" : ", ", i, j);
      }
      if ((heat_i || heat_j) && (l.meeting == BOND || l.meeting == CONTACT))
        error->all(FLERR, "Pair sph/tm coeff {} {}: a heat body takes no part in mechanics; use "
                          "'heat' or 'none'", i, j);
      set_law(i, j, l);
    }
  if (!welded.empty() && comm->me == 0)
    utils::logmesg(lmp, "sph/tm: types {} are one body where they touch (bond, the default); 'pair_coeff i j contact' "
                        "makes two bodies of them\n", welded);
}
