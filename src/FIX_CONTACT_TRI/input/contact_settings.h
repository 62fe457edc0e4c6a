/* SPH-TM: the arguments of fix contact/tri, in the unit style; they do not change after it is made. */
#ifndef SPHTM_CONTACT_SETTINGS_H
#define SPHTM_CONTACT_SETTINGS_H

#include "tm_contact_law.h"
#include "tm_heat.h"
#include "tri_tool.h"

#include <cstdint>
#include <string>
#include <vector>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace SPHTM_NS {

class Keywords;

struct ContactSettings {
  ContactSettings(LAMMPS_NS::LAMMPS *, int narg, char **arg);

  TriTool::Shape shape;
  int surface = 1;    // its number, where a script gives one
  // contact law
  tm_table friction = {};    // mu(T)
  bool friction_given = false;
  double shear = 0.0, damping = 0.1;
  double penalty = TM_PENALTY_USUAL;                                       // PFAC, see tm_contact_modulus()
  enum { LAYER_USUAL, LAYER_RIGID, LAYER_STRAINS } layer = LAYER_USUAL;    // tm_contact_layer.h; usual: of what flows
  bool approach = false, f15 = false, two_sided = false, overlap_allowed = false;
  bool conducts() const { return conductance != 0.0; }
  bool has_friction() const { return friction.n || friction.value > 0.0; }
  // heat
  bool heat_given = false;
  double share = -1.0, effusivity = -1.0;    // negative: not given
  double conductance = 0.0;                  // 0: none, negative: perfect
  int body_type = 0;                         // of the conduction-only particles inside the tool, 0: there are none
  double temperature = 0.0;                  // the number given, or 0
  std::string temperature_variable;          // or that of an equal-style variable
  bool temperature_given = false;
  double lumped_capacity = 0.0;    // mass c_p of the tool, 0: its temperature is given
  // output
  struct File {
    int every = 0;
    std::string name;
  } vtk, stl;
  static bool is_xml(const std::string &name);    // ending in .vtp
  int local_every = 0;
  bool reference_given = false;
  double reference[3] = {0, 0, 0};    // point of the torques

  // of the values of the keywords of contact and heat, which a restart compares; those of the tool's temperature last
  struct Hash {
    const char *keyword;
    uint64_t value;
  };
  std::vector<Hash> hashes() const;

 private:
  LAMMPS_NS::LAMMPS *lmp;
  // each returns whether the keyword is its own
  void read_input(Keywords &);
  void read_file(Keywords &);
  bool read_mesh(Keywords &);
  bool read_placement(Keywords &);
  bool read_law(Keywords &);
  bool read_heat(Keywords &);
  bool read_output(Keywords &);
  void check() const;
};

}    // namespace SPHTM_NS

#endif
