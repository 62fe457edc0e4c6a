#include "model_input.h"

#include "argument.h"
#include "friction_table.h"
#include "material_input.h"
#include "model.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "lammps.h"
#include "utils.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

Settings read_settings(LAMMPS *lmp, int narg, char **arg)
{
  Error *error = lmp->error;
  if (narg < 4)
    error->all(FLERR,
               "Illegal pair_style sph/tm: expected 'sph/tm <kernel> <h/spacing> spacing "
               "<dp> ...', got {} arguments",
               narg);
  Settings set;
  int kernel = -1;
  for (int k = 0; k < TM_KERNEL_COUNT; k++)
    if (strcmp(arg[0], kernel_name(k)) == 0) kernel = k;
  if (kernel < 0)
    error->all(FLERR,
               "Unknown pair style sph/tm kernel {}: choose hyperbolic, cubic, quintic, "
               "wendland/c2 or wendland/c4",
               arg[0]);
  set.kernel = kernel;
  set.ratio = positive(lmp, "Pair style sph/tm ratio of smoothing length to spacing", arg[1]);
  if (set.ratio < 0.8 || set.ratio > 4.0)
    error->all(FLERR,
               "Pair style sph/tm ratio of smoothing length to spacing must be between 0.8 "
               "and 4, got {}",
               arg[1]);

  bool viscosity = false, artstress = false, hourglass = false, correction = false,
       tensile = false;    // given
  Keywords k(lmp, "Pair style sph/tm", narg - 2, arg + 2);
  while (k.next()) {
    if (k.is("spacing")) {
      if (k.take("lattice")) set.spacing = Model::lattice_spacing(lmp);
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
      viscosity = true;
      set.visc_alpha = k.not_negative("alpha");
      set.visc_beta = k.not_negative("beta");
    } else if (k.is("shock")) {
      if (k.take("auto")) set.shock = -1.0;
      else set.shock = k.share("coefficient");
    } else if (k.is("balsara")) set.balsara = k.yes();
    else if (k.is("artstress")) {
      k.need(2);
      artstress = true;
      set.art_eps = k.share("epsilon");
      set.art_n = k.integer(1, 8, "exponent");
      if (k.take("component")) set.art_component = true;
      else if (k.take("principal")) set.art_component = false;
      if (k.take("balanced")) set.art_balanced = true;
    } else if (k.is("xsph")) set.xsph = k.share("epsilon");
    else if (k.is("stabilize")) {
      tensile = k.second("hourglass", "artstress");
    } else if (k.is("hourglass")) {
      hourglass = true;
      if (k.take("auto")) set.hourglass = -1.0;
      else {
        set.hourglass = k.share("xi");
        continue;
      }
    } else if (k.is("form")) set.form_f14 = k.second("f15", "f14");
    else if (k.is("correction")) {
      correction = set.correction = true;
      if (k.take("linear")) set.faces = FACES_NEVER;
      else if (k.take("second")) set.faces = FACES_ALWAYS;
      else set.correction = k.yes();
    } else if (k.is("plane")) set.plane_stress = k.second("strain", "stress");
    else if (k.is("precision")) set.mixed = k.second("double", "mixed");
    else
      error->all(FLERR,
                 "Unknown pair style sph/tm keyword {}: known are spacing, viscosity, shock, "
                 "balsara, stabilize, artstress, hourglass, xsph, form, correction, plane, precision",
                 k.name());
  }
  // artificial stress takes the place of hourglass control and corrected gradients, as in Fraser 2014
  tensile = tensile || set.form_f14 || set.art_eps > 0.0;
  if (tensile && !viscosity) set.visc_alpha = set.visc_beta = 1.0;
  if (tensile && !artstress) set.art_eps = 0.3;
  if (tensile && !hourglass) set.hourglass = 0.0;
  if (tensile && !correction) set.correction = false;
  const bool one_pass = set.correction && set.hourglass != 0.0 && set.art_eps == 0.0 && set.faces != FACES_ALWAYS;
  if (set.shock > 0.0 && !one_pass)
    error->all(
        FLERR,
        "Pair style sph/tm shock {:.8g} needs hourglass control and gradient correction without artificial stress, as "
        "they are by default, and no correction second; else give viscosity a first value",
        set.shock);
  if (set.shock > 0.0 && set.plane_stress)
    error->all(FLERR, "Pair style sph/tm shock {:.8g} has no effect with plane stress, where there is no such pressure",
               set.shock);
  if (set.spacing <= 0.0) error->all(FLERR, "Pair style sph/tm needs the keyword spacing with the particle spacing");
  if (set.correction && set.form_f14) error->all(FLERR, "Pair style sph/tm correction yes needs form f15");
  set.h = set.ratio * set.spacing;
  return set;
}

void check_spacing_kept(LAMMPS *lmp, const Settings &before, const Settings &now)
{
  if (before.spacing > 0.0 && fabs(now.spacing - before.spacing) > 1e-9 * before.spacing)
    lmp->error->all(FLERR,
                    "Pair style sph/tm spacing changed from {:.8g} to {:.8g} after a run; masses and sizes of the "
                    "particles belong to the old one",
                    before.spacing, now.spacing);
}

// how two types meet: bond | none | heat [conductance hc] | contact [friction mu] [friction/table T1 mu1 ...]
// [friction/shear m] [penalty PFAC] [layer rigid | strains] [damping DFAC] [conductance hc]
static void read_meeting(LAMMPS *lmp, int narg, char **arg, Model &model)
{
  Error *error = lmp->error;
  int ilo, ihi, jlo, jhi;
  utils::bounds(FLERR, arg[0], 1, model.types(), ilo, ihi, error);
  utils::bounds(FLERR, arg[1], 1, model.types(), jlo, jhi, error);
  const std::string what = arg[2];
  PairLaw law;
  law.meeting = what == "bond" ? BOND : what == "none" ? NONE : what == "heat" ? HEAT_ONLY : CONTACT;
  law.contact.damping = 0.2;
  law.conductance = what == "contact" ? -1.0 : 0.0;    // contact: no heat unless asked
  bool rubs = false, limited = false;
  for (int iarg = 3; iarg < narg; iarg += 2) {    // friction/table takes more
    const std::string key = arg[iarg];
    if (iarg + 1 >= narg) error->all(FLERR, "Pair sph/tm coeff {} keyword {} needs a value", what, key);
    const char *val = arg[iarg + 1];
    if (rubs && (key == "friction" || key == "friction/table"))
      error->all(FLERR,
                 "Pair sph/tm coeff contact {}: the friction of types {} {} has been given before; give it once, by "
                 "friction or by friction/table",
                 key, arg[0], arg[1]);
    if (key == "conductance" && (law.meeting == HEAT_ONLY || law.meeting == CONTACT)) {
      law.conductance = strcmp(val, "perfect") == 0
                            ? 0.0
                            : positive(lmp, "Pair sph/tm coeff " + what + " conductance", val) * unit_scale(lmp).energy;
    } else if (key == "friction" && law.meeting == CONTACT) {
      law.contact.friction = {0, not_negative(lmp, "Pair sph/tm coeff contact friction", val), {}, {}};
      rubs = true;
    } else if ((key == "friction/table" || key == "friction/shear") && law.meeting == CONTACT) {
      Keywords k(lmp, "Pair sph/tm coeff contact", narg - iarg, arg + iarg);
      k.next();
      if (key == "friction/table") law.contact.friction = read_friction_table(lmp, k);
      else law.contact.shear = k.share();
      (key == "friction/table" ? rubs : limited) = true;
      iarg = narg - k.rest() - 2;
    } else if (key == "penalty" && law.meeting == CONTACT)
      law.penalty = strcmp(val, "material") == 0 ? TM_PENALTY_MATERIAL
                                                 : positive(lmp, "Pair sph/tm coeff contact penalty", val);
    else if (key == "layer" && law.meeting == CONTACT) {
      const bool strains = strcmp(val, "strains") == 0;
      if (!strains && strcmp(val, "rigid") != 0)
        error->all(FLERR, "Pair sph/tm coeff contact layer must be rigid or strains, got {}", val);
      law.layer = strains ? LAYER_OF_BODIES_STRAINS : LAYER_OF_BODIES_RIGID;
    } else if (key == "damping" && law.meeting == CONTACT)
      law.contact.damping = not_negative(lmp, "Pair sph/tm coeff contact damping", val);
    else
      error->all(FLERR, "Unknown pair sph/tm coeff {} keyword {}: known {}", what, key,
                 law.meeting == CONTACT ? "are friction, friction/table, friction/shear, penalty, layer, damping and "
                                          "conductance"
                 : law.meeting == HEAT_ONLY ? "is conductance"
                                            : "is none");
  }
  if (limited && !rubs)
    error->all(FLERR, "Pair sph/tm coeff contact friction/shear {:.6g} {}", law.contact.shear, FRICTION_SHEAR_ALONE);
  if (law.contact.friction.n == 0 && law.contact.friction.value > HIGH_FRICTION && !limited && lmp->comm->me == 0)
    error->warning(FLERR, "Pair sph/tm coeff contact of types {} {}: friction {:.4g} {}", arg[0], arg[1],
                   law.contact.friction.value, FRICTION_HIGH);
  int count = 0;
  for (int i = ilo; i <= ihi; i++)
    for (int j = jlo; j <= jhi; j++) {
      if (i == j) continue;
      model.pair_laws().set(i, j, law);
      count++;
    }
  if (count == 0) error->all(FLERR, "Pair sph/tm coeff {} needs two different types, got {} {}", what, arg[0], arg[1]);
}

void read_coefficients(LAMMPS *lmp, int narg, char **arg, Model &model)
{
  Atom *atom = lmp->atom;
  Error *error = lmp->error;
  if (narg < 3) error->all(FLERR, "Pair sph/tm coeff needs two types and a material or a law");

  int ilo, ihi, jlo, jhi;
  utils::bounds(FLERR, arg[0], 1, model.types(), ilo, ihi, error);
  utils::bounds(FLERR, arg[1], 1, model.types(), jlo, jhi, error);

  static const char *const meetings[] = {"bond", "none", "contact", "heat"};
  const bool meeting =
      std::any_of(std::begin(meetings), std::end(meetings), [&](const char *m) { return strcmp(arg[2], m) == 0; }) &&
      !(strcmp(arg[2], "heat") == 0 && ilo == jlo && ihi == jhi && ilo == ihi);
  if (meeting) {
    read_meeting(lmp, narg, arg, model);
    return;
  }
  if (std::max(ilo, jlo) > std::min(ihi, jhi))
    error->all(FLERR,
               "Pair sph/tm coeff {0} {1}: a material belongs to one type; write 'pair_coeff {1} {1} ...', "
               "and for two types bond, none, heat or contact",
               arg[0], arg[1]);
  tm_material m = read_material(lmp, "Pair sph/tm coeff", narg - 2, arg + 2);
  scale_material(m, unit_scale(lmp));
  int count = 0;
  for (int i = ilo; i <= ihi; i++)
    for (int j = std::max(jlo, i); j <= jhi; j++) {
      count++;
      if (i != j) continue;
      // a mass that follows from the material given before is not the script's own
      const bool own = atom->mass_setflag && atom->mass_setflag[i] && atom->mass[i] != model.particle_mass(i);
      model.set_material(i, m, material_title(narg - 2, arg + 2));
      if (!atom->rmass_flag && !own) atom->set_mass(FLERR, i, model.particle_mass(i));
    }
  if (count == 0) error->all(FLERR, "Pair sph/tm coeff: no type pair in {} {}", arg[0], arg[1]);
}

}    // namespace SPHTM_NS
