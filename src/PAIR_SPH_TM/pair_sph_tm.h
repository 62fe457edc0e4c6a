/* -*- c++ -*- ----------------------------------------------------------
   SPH-TM: pair style sph/tm. Owns materials, neighbour rows, records and the
   rate pass; the state of the particles belongs to fix sph/tm.
------------------------------------------------------------------------- */
#ifndef LMP_PAIR_SPH_TM_H
#define LMP_PAIR_SPH_TM_H

#include "pair.h"
#include "rate_loops.h"
#include "tm_body_contact.h"
#include "tm_material.h"
#include "tm_surface.h"
#include "unit_scale.h"

#include <string>
#include <vector>

namespace LAMMPS_NS {

class FixSPHTM;

class PairSPHTM : public Pair {
 public:
  // how particles of two types meet
  enum Meeting { UNSET = 0, BOND, NONE, CONTACT, HEAT_ONLY };
  struct PairLaw {
    Meeting meeting = UNSET;
    double conductance = 0.0;    // heat across the interface; 0: perfect
    tm_body_law contact = {};
  };
  // numerical settings of the pair_style line
  struct Settings {
    int kernel = TM_KERNEL_HYPERBOLIC;
    double ratio = 1.2;     // h / spacing
    double spacing = 0.0;
    double h = 0.0;
    double visc_alpha = 1.0, visc_beta = 1.0;
    double art_eps = 0.3;
    int art_n = 4;
    bool art_component = false;
    double xsph = 0.0;
    bool form_f14 = false, correction = false, balsara = false, plane_stress = false;
  };

  PairSPHTM(class LAMMPS *);
  ~PairSPHTM() override;
  void compute(int, int) override;
  void settings(int, char **) override;
  void coeff(int, char **) override;
  void init_style() override;
  void init_list(int, class NeighList *) override;
  double init_one(int, int) override;
  int pack_forward_comm(int, int *, double *, int, int *) override;
  void unpack_forward_comm(int, int, double *) override;
  void write_restart(FILE *) override;
  void read_restart(FILE *) override;
  void write_restart_settings(FILE *) override;
  void read_restart_settings(FILE *) override;
  void *extract(const char *, int &) override;
  double memory_usage() override;

  // for fix sph/tm, fix contact/tri and the computes
  const Settings &settings_in_use() const { return set; }
  const tm_material *materials() const { return material.data(); }
  const PairLaw &law(int i, int j) const { return laws[i * (atom_types + 1) + j]; }
  const tm_records &records() const { return rec; }
  const tm_rates_args &rate_args() const { return args; }
  const std::vector<tm_real> &gradients() const { return gradient; }
  const std::vector<tm_real> &conduction() const { return heat; }
  const std::vector<tm_real> &surfaces() const { return surface; }
  const std::vector<tm_real> &artificial_heating() const { return artificial; }
  const std::vector<double> &internal_forces() const { return force_internal; }
  const std::vector<tm_real> &xsph_velocities() const { return xsph_v; }
  const char *material_name(int type) const { return names[type].c_str(); }
  struct Closest {
    double distance = 1e300;    // of the closest mechanical neighbours of this rank
    int i = -1, j = -1;
    double sum = 0.0;           // of the distances to the nearest neighbour
    int count = 0;              // of particles that have one
  };
  Closest closest() const;
  double neighbors_per_particle() const;    // mean over the owned particles of this rank
  int count_neighbors(int i) const;         // within reach now
  bool has_contact_pairs() const;
  double largest_conductivity() const;      // of all types at all temperatures
  double contact_stiffness_limit(int type) const;
  const SPHTM_NS::UnitScale &units() const { return unit; }
  // valid from init_style on
  const tm_lattice &lattice_sums() const { return lattice; }
  const tm_surface &surface_measure() const { return surface_scale; }

 protected:
  Settings set;
  SPHTM_NS::UnitScale unit;
  tm_lattice lattice = {};
  tm_surface surface_scale = {};
  int atom_types = 0;
  std::vector<tm_material> material;    // by type
  std::vector<std::string> names;
  std::vector<PairLaw> laws;            // by type pair
  std::vector<tm_real> conductance_table;
  FixSPHTM *fix = nullptr;
  std::string restart_fix;              // the fix whose state the restart file holds

  // rows of the owned particles, rebuilt with the host's list
  std::vector<int> row_index, row_mechanical, row_thermal, row_contact;
  std::vector<ptrdiff_t> row_first;

  // records of owned and ghost particles; results of owned ones
  std::vector<tm_real> rec_main, rec_stress, rec_heat, rec_correction;
  std::vector<tm_real> gradient, heat, correction, xsph_v, surface, artificial;
  std::vector<double> force_internal;
  tm_records rec = {};
  tm_rates_args args = {};
  SPHTM_NS::rate_loop_t loop = nullptr;
  unsigned loop_effects = ~0u;
  bool forward_correction = false;    // what forward_comm carries: P K, or the other records

  void allocate();
  std::vector<unsigned char> segments_of_types() const;
  void build_rows();
  void check_volume();
  void check_masses();
  void make_room();
  void resize_arrays();
  void fill_args();
  void predict();
  void forward_records();
  void correct_gradients();
  void body_contact();
  void tally_virial_energy(int, int);
  void parse_meeting(int, char **);
  double particle_mass(int) const;
  void set_law(int, int, const PairLaw &);
  void complete_laws();
};

}    // namespace LAMMPS_NS

#endif
