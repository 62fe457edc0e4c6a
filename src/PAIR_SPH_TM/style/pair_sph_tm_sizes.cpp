/* SPH-TM: pair style sph/tm, particles with a smoothing length and a size of their own. See tm_size.h. */
#include "pair_sph_tm.h"

#include "domain.h"
#include "force.h"

#include <algorithm>

using namespace LAMMPS_NS;

void PairSPHTM::cover_sizes(double h, double dp)
{
  const int dim = domain->dimension;
  list_h = h;
  least_spacing = dp;
  // of a lattice that is fine within the kernel, the limit of large h/spacing
  heat_rate = std::max(lattice.heat_rate, tm_lattice_sums(set.kernel, dim, 3.0).heat_rate);
  comm_forward = TM_REC - 3 + TM_REC_STRESS + TM_REC_HEAT + TM_REC_SIZE;
  if (tables.gradient.empty()) {
    double table[TM_GRADIENT_ENTRIES];
    tm_gradient_table(set.kernel, dim, table);
    tables.gradient.assign(table, TM_GRADIENT_ENTRIES);
  }
  cutforce = tm_kernel_support(set.kernel) * h;
  for (int i = 1; i <= atom_types; i++)
    for (int j = 1; j <= atom_types; j++) {
      cutsq[i][j] = cutforce * cutforce;
      if (force->pair != this) force->pair->cutsq[i][j] = std::max(force->pair->cutsq[i][j], cutsq[i][j]);
    }
  if (force->pair != this) force->pair->cutforce = std::max(force->pair->cutforce, cutforce);
  check_list_size(least_spacing);
}
