/* SPH-TM: what a run computes with and does not change: numerical settings, materials, how types meet, units, the
   lattice's sums and, for the loops, tables of these. Pair style sph/tm fills it from its commands. */
#ifndef SPHTM_MODEL_H
#define SPHTM_MODEL_H

#include "loop_array.h"
#include "pair_laws.h"
#include "pair_loops.h"
#include "tm_surface.h"
#include "unit_scale.h"

#include "pointers.h"

#include <string>
#include <vector>

namespace SPHTM_NS {

// where gradients are of second order at free faces, tm_face.h
enum { FACES_NEVER, FACES_OF_ELASTIC, FACES_ALWAYS };

// numerical settings of the pair_style line
struct Settings {
  int kernel = TM_KERNEL_HYPERBOLIC;
  double ratio = 1.2;    // h / spacing
  double spacing = 0.0;
  double h = 0.0;
  double visc_alpha = 0.0, visc_beta = 1.0;
  double shock = -1.0;    // bulk viscosity in shocks; below 0: 1 where a material has a shock equation of state
  double art_eps = 0.0;
  int art_n = 4;
  bool art_component = false, art_balanced = false;
  int faces = FACES_OF_ELASTIC;
  double xsph = 0.0;
  double hourglass = -1.0;    // stiffness over that of longitudinal waves; below 0: from the stress
  bool form_f14 = false, correction = true, balsara = false, plane_stress = false;
  bool mixed = false;    // pair arithmetic in single
};

const char *kernel_name(int kernel);

class Model : protected LAMMPS_NS::Pointers {
 public:
  Model(LAMMPS_NS::LAMMPS *, Backend &);

  // what the pair style reads
  void set(const Settings &s) { settings = s; }
  void resize(int types);
  void set_material(int type, const tm_material &, const std::string &name);
  PairLaws &pair_laws() { return laws; }
  void complete_laws();    // of pairs of types that the script left open
  void set_restart_file(const std::string &name) { file = name; }
  // before a run: units, sums of the lattice, surface measure; then, with the fix known, tables of the loops
  void prepare();
  void make_tables(double temperature);
  // the run is so many times as fast as the process: conductivities, conductances and reference rates of strain are
  // those of its time
  void set_time_scale(double s);
  double time_scale() const { return times_as_fast; }
  // where compression heats: what is left of the heat capacity at constant volume, at this temperature
  void set_compression_heat(bool heats, double temperature);
  // particles of different size (effect smoothing): smoothing lengths up to h are in the rows, the smallest particle
  // has the edge dp
  void cover_sizes(double h, double dp);

  const Settings &settings_in_use() const { return settings; }
  int types() const { return atom_types; }
  const tm_material *materials() const { return material.data(); }
  const tm_material *given_materials() const { return given.data(); }    // without the time scale
  const char *material_name(int type) const { return names[type].c_str(); }
  const PairLaws &pair_laws() const { return laws; }
  const UnitScale &units() const { return unit; }
  double support() const { return tm_kernel_support(settings.kernel) * settings.h; }    // radius of the kernel
  double covered_h() const { return list_h; }
  double smallest_spacing() const { return least_spacing; }
  const tm_lattice &lattice_sums() const { return lattice; }
  double fastest_heat_rate() const { return heat_rate; }    // of the sizes in use, see tm_lattice.h
  const tm_surface &surface_measure() const { return surface; }
  const std::string &restart_file() const { return file; }    // that was read, or empty
  double particle_mass(int type) const;    // from density and spacing; in 2D of a plate of unit thickness
  double contact_modulus(int type, double penalty) const;    // tm_contact_modulus()
  double largest_conductivity() const;                       // of all types at all temperatures
  double contact_time_step(int type) const;                  // the largest stable one of the stiffest pair in contact

  // distance of particles that each have the volume (in 2d the area) of one on the lattice in use; 0: there is none
  static double lattice_spacing(LAMMPS_NS::LAMMPS *);

  // by type or type pair, where the loops run
  struct Tables {
    LoopArray<tm_material> material;
    LoopArray<tm_real> conductance, effusivity;
    LoopArray<tm_real> gradient;    // tm_gradient_table, with particles of different size
    LoopArray<tm_real> share;       // tm_tensile_table, where the artificial stress is balanced
    LoopArray<tm_body_law> law;
    LoopArray<int> side,
        strains;    // strains: of types in contact whose layers do, per type and side; empty: none does
    explicit Tables(Backend &);
  };
  Tables &loop_tables() { return tables; }
  int sides() const { return most_sides; }    // of a particle in contact with other bodies
  const tm_body_surface &body_surface() const { return of_bodies; }

 private:
  Settings settings;
  UnitScale unit;
  tm_lattice lattice = {};
  double heat_rate = 0.0, list_h = 0.0, least_spacing = 0.0;
  tm_surface surface = {};
  tm_body_surface of_bodies = {};
  int most_sides = 0;
  int atom_types = 0;
  std::vector<tm_material> material, given;    // by type
  double times_as_fast = 1.0;
  std::vector<std::string> names;
  PairLaws laws;
  std::string file;
  Tables tables;
  bool said_soft_contact = false;
};

}    // namespace SPHTM_NS

#endif
