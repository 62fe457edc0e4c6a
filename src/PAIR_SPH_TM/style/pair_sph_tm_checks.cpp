/* SPH-TM: pair style sph/tm, checks of masses, spacing and overlaps. See doc/pair_sph_tm.rst. */
#include "pair_sph_tm.h"

#include "fix_sph_tm.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "neighbor.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace SPHTM_NS;

// particles without a mass of their own: it follows from the material, where that is known already
void PairSPHTM::give_masses()
{
  for (int i = 0; allocated && atom->rmass_flag && i < atom->nlocal; i++)
    if (atom->rmass[i] == 0.0) atom->rmass[i] = particle_mass(atom->type[i]);
}

void PairSPHTM::check_masses()
{
  give_masses();
  auto differs = [&](double mass, int type) {
    return fabs(mass - particle_mass(type)) > 1e-6 * particle_mass(type);
  };
  std::vector<bigint> wrong(atom->ntypes + 1, 0), all(atom->ntypes + 1, 0);
  if (atom->rmass_flag && !fix->wants(TM_FX_SMOOTHING)) {
    for (int i = 0; i < atom->nlocal; i++) wrong[atom->type[i]] += differs(atom->rmass[i], atom->type[i]);
    MPI_Allreduce(wrong.data(), all.data(), atom->ntypes + 1, MPI_LMP_BIGINT, MPI_SUM, world);
  }
  if (comm->me) return;
  for (int t = 1; t <= atom->ntypes; t++)
    if (all[t])
      error->warning(FLERR, "Pair sph/tm: {} particles of type {} have a mass of their own, density times spacing "
                            "gives {:.8g}; 'set type {} mass {:.8g}' sets it, 'effects smoothing on' of fix sph/tm "
                            "gives each the size of its mass", all[t], t, particle_mass(t), t,
                     particle_mass(t));
    else if (!atom->rmass_flag && differs(atom->mass[t], t))
      error->warning(FLERR, "Pair sph/tm: mass of type {} is {:.8g}, density times spacing gives "
                            "{:.8g}; the mass is kept. Without a mass command it follows from the material",
                     t, atom->mass[t], particle_mass(t));
}

// a spacing in another unit than the box: before LAMMPS complains about its bins
void PairSPHTM::check_volume()
{
  const int dim = domain->dimension;
  double box = 1.0;
  for (int d = 0; d < dim; d++) box *= domain->prd[d];
  double needed = (double) atom->natoms * pow(set.spacing, dim);
  if (atom->rmass_flag && fix->wants(TM_FX_SMOOTHING)) {
    double mine = 0.0;
    for (int i = 0; i < atom->nlocal; i++) mine += atom->rmass[i] / material[atom->type[i]].rho0;
    MPI_Allreduce(&mine, &needed, 1, MPI_DOUBLE, MPI_SUM, world);
  }
  if (needed > 3.0 * box)
    error->all(FLERR, "Pair style sph/tm spacing {:.8g}: {} particles would need {} of {:.6g}, the box has {:.6g}; "
                      "give the spacing of the particles in the length unit of the run", set.spacing, atom->natoms,
               dim == 3 ? "a volume" : "an area", needed, box);
}

// LAMMPS's bins are half of the cutoff wide, and at most a hundred times wider than the box
void PairSPHTM::check_bins()
{
  constexpr double MOST = 100.0;
  const double bin = 0.5 * (tm_kernel_support(set.kernel) * set.h + neighbor->skin);
  for (int d = 0; d < 3; d++)
    if (bin > MOST * domain->prd[d])
      error->all(FLERR,
                 "Pair style sph/tm spacing {:.8g}: the box is only {:.6g} long in {}; make it at "
                 "least {:.6g}, for "
                 "instance {:.6g}{}",
                 set.spacing, domain->prd[d], "xyz"[d], bin / MOST, set.spacing,
                 d == 2 && domain->dimension == 2 ? " (in 2d its thickness has no other meaning)"
                                                  : "");
}

// room for the neighbors of a body compressed to a third: LAMMPS's own is meant for molecules
void PairSPHTM::check_list_size(double dp)
{
  // smoothing lengths may double during a run
  const double h = (fix->has(TM_FX_SMOOTHING) ? 2.0 : 1.0) * list_h;
  const double cut = (tm_kernel_support(set.kernel) * h + neighbor->skin) / dp;
  const double in_reach = domain->dimension == 3 ? 4.0 / 3.0 * TM_PI * cut * cut * cut : TM_PI * cut * cut;
  const int need = (int) std::min(1e7, 3.0 * in_reach);
  if (neighbor->oneatom >= need) return;
  neighbor->oneatom = need;
  neighbor->pgsize = std::max(neighbor->pgsize, 10 * need);
  if (comm->me == 0)
    utils::logmesg(lmp, "sph/tm: neigh_modify one {} page {}, for the reach of the kernel\n", need, neighbor->pgsize);
}

void PairSPHTM::make_room_for(double share) { check_list_size(share * least_spacing); }
