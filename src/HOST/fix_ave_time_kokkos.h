/* -*- c++ -*- ----------------------------------------------------------
   SPH-TM: LAMMPS's fix ave/time with Kokkos. LAMMPS brings all particles to the
   host and back whenever the fix looks at its values; values that no particle on
   the host has a part in, such as forces on a tool, are taken without that.
------------------------------------------------------------------------- */
#ifndef LMP_FIX_AVE_TIME_KOKKOS_H
#define LMP_FIX_AVE_TIME_KOKKOS_H

#include "fix_ave_time.h"

#include <string>
#include <vector>

namespace LAMMPS_NS {

class FixAveTimeKokkos : public FixAveTime {
 public:
  FixAveTimeKokkos(class LAMMPS *, int, char **);
  void init() override;

 private:
  std::vector<std::string> inputs;    // c_ID, f_ID, v_name
  bool needs_host(const std::string &input) const;
};

}    // namespace LAMMPS_NS

#endif
