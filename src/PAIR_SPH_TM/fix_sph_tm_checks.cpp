/* SPH-TM: fix sph/tm, states that cannot go on. See doc/fix_sph_tm.rst. */
#include "fix_sph_tm.h"

#include "pair_sph_tm.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

// a particle beyond a fixed boundary is deleted at the next reneighbouring
tm_drift_args FixSPHTM::drift_args()
{
  enum { FIXED = 1 };    // of Domain
  tm_drift_args a;
  a.state = state();
  a.group = groupbit;
  a.half = dt_ahead;
  for (int d = 0; d < 3; d++) {
    for (int side = 0; side < 2; side++)
      a.closed[d][side] = !domain->triclinic && domain->boundary[d][side] == FIXED;
    a.lo[d] = domain->boxlo[d];
    a.hi[d] = domain->boxhi[d];
  }
  return a;
}

// asked before LAMMPS would delete the particle, and before the forces; whether there is one that may go
bool FixSPHTM::check_lost()
{
  if (drifted == 0) return false;
  backend.wait();
  const bool some = *lost < drifted;
  if (some && stop_on_lost) stop_on_lost_particle(*lost);
  drifted = 0;
  return some;
}

void FixSPHTM::stop_on_lost_particle(int i)
{
  atoms_to_host();
  const tm_drift_args a = drift_args();
  const double *x = atom->x[i], *v = atom->v[i];
  int d = 0;
  while ((!a.closed[d][0] || x[d] >= a.lo[d]) && (!a.closed[d][1] || x[d] <= a.hi[d])) d++;
  error->one(FLERR, "Fix sph/tm stops at step {}: particle {} (type {}) at {:.6g} {:.6g} {:.6g} with "
                    "velocity {:.6g} {:.6g} {:.6g} leaves the box through its {} {} boundary. Likely "
                    "cause: a box too small for the motion, or a particle shot out by an unstable "
                    "contact. Make the box larger, use boundary m or s, or 'lost ignore' to let it go",
             update->ntimestep, atom->tag[i], atom->type[i], x[0], x[1], x[2], v[0], v[1], v[2],
             "xyz"[d], x[d] < a.lo[d] ? "lower" : "upper");
}

// a state that cannot go on: say where and why, leave the last restart file as it is
void FixSPHTM::stop_on(int i, const tm_update_result &r)
{
  atoms_to_host();
  const double *x = atom->x[i], *v = atom->v[i];
  if (!std::isfinite(x[0] + x[1] + x[2]))
    x = pair_sph->host_records().main + (size_t) i * TM_REC;    // half a step ago
  const double rho = field(TM_F_RHO)[i], T = temperature(i);
  std::string what, cause;
  switch (r.status) {
    case TM_BAD_NAN:
      what = "state is not a number";
      cause = "overlapping particles, a time step above the limit of another fix, or bad input values";
      break;
    case TM_BAD_DENSITY:
      what = fmt::format("density {:.6g} is not positive", rho);
      cause = "a particle torn out of the body in one step; lower courant, or check the contact stiffness";
      break;
    case TM_BAD_VELOCITY:
      what = fmt::format("velocity {:.6g} is above ten times the speed of sound",
                         sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]));
      cause = "overlapping particles or a tool that starts inside the body; lower the penalty factor or courant";
      break;
    default:
      what = fmt::format("temperature {:.6g} is not positive", T);
      cause = "a heat sink stronger than the particle can feed in one step";
      if (fixed_dt > 0.0) cause += ", or a constant dt that conduction has outgrown: use 'dt auto'";
  }
  error->one(FLERR, "Fix sph/tm stops at step {}: particle {} (type {}) at {:.6g} {:.6g} {:.6g}: {}. "
                    "Likely cause: {}. Restart files written before remain valid.",
             update->ntimestep, atom->tag[i], atom->type[i], x[0], x[1], x[2], what, cause);
}

// what a script gets wrong about particles: overlaps, a spacing that is not theirs, infinite values
void FixSPHTM::check_start()
{
  const double dp = has(TM_FX_SMOOTHING) ? pair_sph->smallest_spacing() : pair_sph->settings_in_use().spacing;
  const tm_nearest c = pair_sph->nearest();
  if (c.distance < 0.1 * dp) {
    double **x = atom->x;
    const auto pair = std::minmax(c.i, c.j, [&](int i, int j) { return atom->tag[i] < atom->tag[j]; });
    const int i = pair.first, j = pair.second;
    error->one(FLERR, "Pair style sph/tm: particles {} and {} are {} at {:.6g} {:.6g} {:.6g}; remove one of "
                      "them ('delete_atoms overlap {:.6g} all all')",
               atom->tag[i], atom->tag[j], c.distance == 0.0 ? "in the same place" :
               fmt::format("only {:.6g} of the spacing apart", c.distance / dp), x[i][0], x[i][1],
               x[i][2], 0.5 * dp);
  }
  for (int i = 0; i < atom->nlocal; i++) {
    const double *x = atom->x[i], *v = atom->v[i], *f = atom->f[i];
    const char *what = nullptr;
    for (int k = 0; k < 3; k++) {
      if (!std::isfinite(f[k])) what = "force";
      if (!std::isfinite(v[k])) what = "velocity";
    }
    if (what)
      error->one(FLERR, "Fix sph/tm: the {} of particle {} (type {}) at {:.6g} {:.6g} {:.6g} is not a finite "
                        "number at the start; its velocity is {:.6g} {:.6g} {:.6g}", what, atom->tag[i],
                 atom->type[i], x[0], x[1], x[2], v[0], v[1], v[2]);
  }
  double mine[2] = {c.sum, c.count}, all[2];
  MPI_Allreduce(mine, all, 2, MPI_DOUBLE, MPI_SUM, world);
  if (comm->me) return;
  bigint solids = 0;
  for (int t = 1; t <= atom->ntypes; t++) solids += pair_sph->materials()[t].body == TM_BODY_SOLID;
  if (all[1] == 0.0 && atom->natoms > 1 && solids)
    error->warning(FLERR, "Pair style sph/tm: no particle has a neighbor within reach; are the particles "
                          "{:.6g} (the keyword spacing) apart?", dp);
  else if (!has(TM_FX_SMOOTHING) && all[1] > 0.0 && (all[0] / all[1] > 1.4 * dp || all[0] / all[1] < 0.6 * dp))
    error->warning(FLERR, "Pair style sph/tm: the nearest neighbors are {:.6g} apart on the mean, the keyword "
                          "spacing says {:.6g}; masses, kernels and contact follow the keyword",
                   all[0] / all[1], dp);
}
