/* -*- c++ -*- ----------------------------------------------------------
   SPH-TM: fix sph/tm/heat. Heat between the particles of a group and the
   outside: fixed temperature, flux, source, convection, radiation.
------------------------------------------------------------------------- */
#ifndef LMP_FIX_SPH_TM_HEAT_H
#define LMP_FIX_SPH_TM_HEAT_H

#include "fix.h"

#include "equal_value.h"
#include "scene.h"
#include "tm_surface_flux.h"

namespace SPHTM_NS {
class Keywords;
}

namespace LAMMPS_NS {

class FixSPHTMHeat : public Fix {
 public:
  FixSPHTMHeat(class LAMMPS *, int, char **);
  int setmask() override;
  void init() override;
  void setup(int) override;
  void post_force(int) override;
  void end_of_step() override;
  double compute_scalar() override;
  double compute_vector(int) override;
  void write_restart(FILE *) override;
  void restart(char *) override;

 private:
  enum Mode { TEMPERATURE, FLUX, SOURCE, CONVECTION, RADIATION } mode;
  std::shared_ptr<SPHTM_NS::Scene> scene;
  SPHTM_NS::ParticleState *state = nullptr;    // of fix sph/tm
  SPHTM_NS::EqualValue strength, T_inf;        // strength: also the fixed temperature
  double emissivity = -1.0;                    // negative: the material's
  double threshold = TM_SURFACE_THRESHOLD;
  tm_surface surface = {0.0, 0.0};
  double known_area = 0.0;    // > 0: scale the surface found to this total
  double area_found = 0.0;    // on this rank, without the keyword area
  bool facing = false;
  int held = -1;    // number of the prescribed temperature in a step with stages of conduction
  tm_vec3 direction = {0.0, 0.0, 0.0};

  // of this rank
  double power = 0.0, energy = 0.0, area = 0.0;

  bool on_surface() const { return mode == FLUX || mode == CONVECTION || mode == RADIATION; }
  void read(SPHTM_NS::EqualValue &, const char *which, SPHTM_NS::Keywords &);
  void read_keywords(SPHTM_NS::Keywords &);
  void ask();
  void check_group();
  double temperature_now();
  double set_temperature(double);
  tm_surface_flux_args flux_args();
  void add_flux();
  void check_area();
};

}    // namespace LAMMPS_NS

#endif
