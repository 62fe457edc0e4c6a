/* -*- c++ -*- ----------------------------------------------------------
   SPH-TM: compute sph/tm/atom. Named per-particle values, in the units of the run.
------------------------------------------------------------------------- */
#ifndef LMP_COMPUTE_SPH_TM_ATOM_H
#define LMP_COMPUTE_SPH_TM_ATOM_H

#include "compute.h"
#include "scene.h"
#include "tm_output.h"

#include <memory>
#include <string>
#include <vector>

namespace LAMMPS_NS {

class ComputeSPHTMAtom : public Compute {
 public:
  ComputeSPHTMAtom(class LAMMPS *, int, char **);
  ~ComputeSPHTMAtom() override;
  void init() override;
  void compute_peratom() override;
  double memory_usage() override;
  const char *attribute(int column) const;    // its name

 protected:
  std::shared_ptr<SPHTM_NS::Scene> scene;
  SPHTM_NS::ParticleState *state = nullptr;    // from init on
  std::vector<int> wanted;                     // enum tm_output_id

  void check_current();
  bool wants(int attribute) const;
  tm_output_args output_args();
  virtual void run_output(double *value);    // the rows of all particles

 private:
  int nmax = 0;

  void put_level(double *value);
};

}    // namespace LAMMPS_NS

#endif
