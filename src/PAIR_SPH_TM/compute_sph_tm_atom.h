/* -*- c++ -*- ----------------------------------------------------------
   SPH-TM: compute sph/tm/atom. Named per-particle values, in the units of the run.
------------------------------------------------------------------------- */
#ifndef LMP_COMPUTE_SPH_TM_ATOM_H
#define LMP_COMPUTE_SPH_TM_ATOM_H

#include "compute.h"

#include <vector>

namespace LAMMPS_NS {

class ComputeSPHTMAtom : public Compute {
 public:
  ComputeSPHTMAtom(class LAMMPS *, int, char **);
  ~ComputeSPHTMAtom() override;
  void init() override;
  void compute_peratom() override;
  double memory_usage() override;

 private:
  class FixSPHTM *fix = nullptr;
  std::vector<int> wanted;    // index into the table of attributes
  int nmax = 0;

  void find_fix();
};

}    // namespace LAMMPS_NS

#endif
