/* SPH-TM: neighbor lists of LAMMPS that reach further from now on. LAMMPS reads the cutoffs of the pair style once
   per run. What Neighbor::init() makes of them is set here again; the bins, stencils and lists that hold copies
   take them anew. */
#include "neighbor_cutoff.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "force.h"
#include "lammps.h"
#include "nbin.h"
#include "neighbor.h"
#include "npair.h"
#include "nstencil.h"
#include "pair.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

namespace {

// reaches the protected members
struct Copies : Neighbor {
  static void renew(Neighbor &n)
  {
    NBin **bins = n.*&Copies::neigh_bin;
    NStencil **stencils = n.*&Copies::neigh_stencil;
    NPair **pairs = n.*&Copies::neigh_pair;
    for (int i = 0; i < n.*&Copies::nbin; i++) bins[i]->copy_neighbor_info();
    for (int i = 0; i < n.*&Copies::nstencil; i++) stencils[i]->copy_neighbor_info();
    for (int i = 0; i < n.nlist; i++)
      if (pairs[i]) pairs[i]->copy_neighbor_info();
  }
};

}    // namespace

namespace SPHTM_NS {

void widen_neighbor_lists(LAMMPS *lmp)
{
  Neighbor &n = *lmp->neighbor;
  if (n.style != Neighbor::BIN && n.style != Neighbor::NSQ)
    lmp->error->all(FLERR, "Smoothing lengths that grow need neighbor style bin or nsq");
  const int types = lmp->atom->ntypes;
  n.cutneighmax = 0.0;
  n.cutneighmin = 1e300;
  for (int i = 1; i <= types; i++) {
    n.cuttype[i] = n.cuttypesq[i] = 0.0;
    for (int j = 1; j <= types; j++) {
      const double cut = std::sqrt(lmp->force->pair->cutsq[i][j]) + n.skin;
      n.cutneighsq[i][j] = n.cutneighghostsq[i][j] = cut * cut;
      n.cuttype[i] = std::max(n.cuttype[i], cut);
      n.cuttypesq[i] = std::max(n.cuttypesq[i], cut * cut);
      n.cutneighmin = std::min(n.cutneighmin, cut);
      n.cutneighmax = std::max(n.cutneighmax, cut);
    }
  }
  n.cutneighmaxsq = n.cutneighmax * n.cutneighmax;
  Copies::renew(n);
  lmp->comm->setup();
  n.setup_bins();
}

}    // namespace SPHTM_NS
