#include "model_checks.h"

#include "material_constants.h"
#include "model.h"
#include "particle_state.h"
#include "restart_block.h"
#include "step_results.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "force.h"
#include "lammps.h"
#include "modify.h"
#include "neighbor.h"
#include "update.h"
#include "utils.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

void check_materials(LAMMPS *lmp, const Model &model, const char *hybrid_style)
{
  for (int i = 1; i <= lmp->atom->ntypes; i++)
    if (model.materials()[i].rho0 <= 0.0)
      lmp->error->all(FLERR,
                      "Pair sph/tm: no material for atom type {0}; write 'pair_coeff {0} {0} {1}"
                      "<file> <card>' or the constants inline",
                      i, hybrid_style);
}

void check_styles(LAMMPS *lmp, const Model &model, const std::string &restart_fix, ParticleState &state)
{
  Error *error = lmp->error;
  if (lmp->modify->get_fix_by_style("^sph/tm$").size() > 1)
    error->all(FLERR, "More than one fix sph/tm: one owns the state of all particles of pair style sph/tm; remove "
                      "the others");
  if (!restart_fix.empty() && !state.history().restored())
    error->all(FLERR,
               "Fix {} sph/tm: the {} holds the state of the particles under the fix ID {}; write "
               "'fix {} ... sph/tm ...' once, after read_restart",
               state.id(), restart_file_name(lmp), restart_fix, restart_fix);
  if (model.settings_in_use().plane_stress && lmp->domain->dimension != 2)
    error->all(FLERR, "Pair style sph/tm plane stress needs dimension 2");
  if (utils::strmatch(lmp->force->pair_style, "^hybrid/scaled"))
    error->all(FLERR,
               "Pair style sph/tm does not work in hybrid/scaled: its forces belong to the stress that it keeps, which "
               "no factor scales; use hybrid or hybrid/overlay");
  const Neighbor *neighbor = lmp->neighbor;
  if ((neighbor->nex_type || neighbor->nex_group || neighbor->nex_mol) && lmp->comm->me == 0)
    error->warning(FLERR,
                   "Pair style sph/tm: 'neigh_modify exclude' takes neighbors out of its sums, of stress, heat and "
                   "contact; how two types meet is said by pair_coeff I J bond, none, contact or heat");
}

// particles without a mass of their own: it follows from the material, where that is known already
void give_masses(LAMMPS *lmp, const Model &model)
{
  Atom *atom = lmp->atom;
  for (int i = 0; model.types() && atom->rmass_flag && i < atom->nlocal; i++)
    if (atom->rmass[i] == 0.0) atom->rmass[i] = model.particle_mass(atom->type[i]);
}

void check_masses(LAMMPS *lmp, const Model &model, const ParticleState &state)
{
  Atom *atom = lmp->atom;
  give_masses(lmp, model);
  auto differs = [&](double mass, int type) {
    return fabs(mass - model.particle_mass(type)) > 1e-6 * model.particle_mass(type);
  };
  std::vector<bigint> wrong(atom->ntypes + 1, 0), all(atom->ntypes + 1, 0);
  if (atom->rmass_flag && !state.wants(TM_FX_SMOOTHING)) {
    for (int i = 0; i < atom->nlocal; i++) wrong[atom->type[i]] += differs(atom->rmass[i], atom->type[i]);
    MPI_Allreduce(wrong.data(), all.data(), atom->ntypes + 1, MPI_LMP_BIGINT, MPI_SUM, lmp->world);
  }
  if (lmp->comm->me) return;
  for (int t = 1; t <= atom->ntypes; t++)
    if (all[t])
      lmp->error->warning(FLERR,
                          "Pair sph/tm: {} particles of type {} have a mass of their own, density times spacing "
                          "gives {:.8g}; 'set type {} mass {:.8g}' sets it, 'effects smoothing on' of fix sph/tm "
                          "gives each the size of its mass",
                          all[t], t, model.particle_mass(t), t, model.particle_mass(t));
    else if (!atom->rmass_flag && differs(atom->mass[t], t))
      lmp->error->warning(FLERR,
                          "Pair sph/tm: mass of type {} is {:.8g}, density times spacing gives "
                          "{:.8g}; the mass is kept. Without a mass command it follows from the material",
                          t, atom->mass[t], model.particle_mass(t));
}

// a spacing in another unit than the box: before LAMMPS complains about its bins
void check_volume(LAMMPS *lmp, const Model &model, const ParticleState &state)
{
  Atom *atom = lmp->atom;
  const double spacing = model.settings_in_use().spacing;
  const int dim = lmp->domain->dimension;
  double box = 1.0;
  for (int d = 0; d < dim; d++) box *= lmp->domain->prd[d];
  double needed = (double) atom->natoms * pow(spacing, dim);
  if (atom->rmass_flag && state.wants(TM_FX_SMOOTHING)) {
    double mine = 0.0;
    for (int i = 0; i < atom->nlocal; i++) mine += atom->rmass[i] / model.materials()[atom->type[i]].rho0;
    MPI_Allreduce(&mine, &needed, 1, MPI_DOUBLE, MPI_SUM, lmp->world);
  }
  if (needed > 3.0 * box)
    lmp->error->all(FLERR,
                    "Pair style sph/tm spacing {:.8g}: {} particles would need {} of {:.6g}, the box has {:.6g}; "
                    "give the spacing of the particles in the length unit of the run",
                    spacing, atom->natoms, dim == 3 ? "a volume" : "an area", needed, box);
}

// LAMMPS's bins are half of the cutoff wide, and at most a hundred times wider than the box
void check_bins(LAMMPS *lmp, const Model &model)
{
  const double spacing = model.settings_in_use().spacing;
  constexpr double MOST = 100.0, ATOM = 1e-10;    // m
  const StyleUnits *unit = find_style_units(lmp->update->unit_style);
  if (unit && spacing * unit->length < ATOM && lmp->comm->me == 0)
    lmp->error->warning(FLERR,
                        "Pair style sph/tm spacing {:.8g} is {:.3g} m in units {}, less than an atom; are lengths in "
                        "another unit?",
                        spacing, spacing * unit->length, unit->style);
  const double bin = 0.5 * (model.support() + lmp->neighbor->skin);
  for (int d = 0; d < 3; d++)
    if (bin > MOST * lmp->domain->prd[d])
      lmp->error->all(FLERR,
                      "Pair style sph/tm spacing {:.8g}: the box is only {:.6g} long in {}; make it at "
                      "least {:.6g}, for "
                      "instance {:.6g}{}",
                      spacing, lmp->domain->prd[d], "xyz"[d], bin / MOST, spacing,
                      d == 2 && lmp->domain->dimension == 2 ? " (in 2d its thickness has no other meaning)" : "");
}

static bool is_default_skin(const char *unit_style, double skin)
{
  static const struct {
    const char *style;
    double skin;
  } defaults[] = {{"lj", 0.3},  {"real", 2.0},     {"metal", 2.0}, {"si", 0.001},
                  {"cgs", 0.1}, {"electron", 2.0}, {"micro", 0.1}, {"nano", 0.1}};
  return std::any_of(std::begin(defaults), std::end(defaults),
                     [&](const auto &d) { return strcmp(unit_style, d.style) == 0 && skin == d.skin; });
}

// the skin of the unit style's default is meant for molecules: take a tenth of the reach
void set_skin(LAMMPS *lmp, const Model &model)
{
  Neighbor *neighbor = lmp->neighbor;
  if (!is_default_skin(lmp->update->unit_style, neighbor->skin)) return;
  neighbor->skin = 0.1 * model.support();
  if (lmp->comm->me == 0) utils::logmesg(lmp, "sph/tm: neighbor skin {:.6g}, a tenth of the reach\n", neighbor->skin);
}

void check_mixed(LAMMPS *lmp, const Model &model, const Backend &loops)
{
  const Settings &set = model.settings_in_use();
  if (!PairLoops::has_single(loops, set.kernel))
    lmp->error->all(FLERR,
                    "Pair style sph/tm precision mixed on a GPU is for the kernel hyperbolic alone; write 'precision "
                    "double', or that kernel");
  const Domain &box = *lmp->domain;
  double far = 0.0;
  for (int d = 0; d < box.dimension; d++) far = std::max({far, fabs(box.boxlo[d]), fabs(box.boxhi[d])});
  const double farthest = tm_single_farthest(single_position_unit(model, lmp->neighbor->skin)) * set.spacing;
  if (far > farthest)
    lmp->error->all(FLERR,
                    "Pair style sph/tm precision mixed: the box reaches {:.3g} from the origin, and beyond {:.3g} "
                    "positions are too coarse for spacing {:.3g}; move the origin into the box",
                    far, farthest, set.spacing);
}

}    // namespace SPHTM_NS
