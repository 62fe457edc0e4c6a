/* -*- c++ -*- ----------------------------------------------------------
   SPH-TM: pair style sph/tm. Owns materials, neighbour rows, records and the
   rate pass; the state of the particles belongs to fix sph/tm.
------------------------------------------------------------------------- */
#ifndef LMP_PAIR_SPH_TM_H
#define LMP_PAIR_SPH_TM_H

#include "pair.h"
#include "loop_array.h"
#include "pair_loops.h"
#include "row_source.h"
#include "tm_material.h"
#include "tm_surface.h"
#include "unit_scale.h"

#include <map>
#include <memory>
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
    bool art_component = false, art_balanced = false;
    double xsph = 0.0;
    double hourglass = 0.0;    // stiffness over that of longitudinal waves
    bool form_f14 = false, correction = false, balsara = false, plane_stress = false;
    bool mixed = false;    // pair arithmetic in single
  };

  PairSPHTM(class LAMMPS *, SPHTM_NS::Backend & = SPHTM_NS::Backend::host());
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
  std::map<unsigned, double> bytes_by_effect() const;    // but for the rows; 0: what every scene has
  double bytes_of_rows() const;

  // for fix sph/tm, fix contact/tri and the computes
  void steps() { stepped = true; }
  bool has_stepped() const { return stepped; }    // a fix sph/tm has taken steps with it
  // distance of particles that each have the volume (in 2d the area) of one on the lattice in use; 0: there is none
  double lattice_spacing() const;
  bool has_fix() const;    // the one of the last init is still there
  bool belongs_to(const FixSPHTM *f) const { return fix == f; }    // since the last init
  const std::string &restart_file() const { return restart_name; }    // that was read, or empty
  const Settings &settings_in_use() const { return set; }
  const tm_material *materials() const { return material.data(); }
  const PairLaw &law(int i, int j) const { return laws[i * (atom_types + 1) + j]; }
  const char *material_name(int type) const { return names[type].c_str(); }
  static const char *kernel_name(int kernel);
  // where the loops run; valid from one force computation to the next reneighbouring
  const tm_material *loop_materials() { return tables.material.loop_read(); }
  const tm_rates_args &rate_args() const { return args; }
  tm_predict_args predict_args(const tm_state &);
  void give_masses();    // of particles that have none
  const tm_real *tensile_shares() { return tables.share.empty() ? nullptr : tables.share.loop_read(); }
  virtual const int *loop_tags();
  void forward(SPHTM_NS::LoopArray<tm_real> &, int columns);    // brings values of particles to their ghosts
  const double *internal_force() { return force_internal.loop_read(); }
  // the same on the host
  tm_records host_records();
  tm_rows host_rows();
  const tm_real *host_heat() { return heat.host_read(); }    // conduction, power per volume, or nullptr
  bool keeps_rows() const { return row_source && row_source->keeps(); }
  bool has_surface(int n) const { return surface.size() > 3 * (size_t) n; }    // of n particles
  // of the particles of this rank: neighbors within reach, the closest mechanical neighbors
  double neighbors(bool of_each = false);
  const tm_real *loop_neighbors();    // number of neighbors of each
  tm_nearest nearest();
  bool has_contact_pairs() const;
  double largest_conductivity() const;      // of all types at all temperatures
  double contact_stiffness_limit(int type) const;
  std::vector<unsigned char> segments_of_types();    // per type pair: where in a row they meet
  const SPHTM_NS::UnitScale &units() const { return unit; }
  // particles of different size (effect smoothing): smoothing lengths up to h are in the rows, the
  // smallest particle has the edge dp. Collective; from init() on, before LAMMPS makes its lists
  void cover_sizes(double h, double dp);
  void make_room_for(double share);    // in the lists, for spacings down to that share of the smallest
  double covered_h() const { return list_h; }
  double smallest_spacing() const { return least_spacing; }
  // valid from init_style on
  const tm_lattice &lattice_sums() const { return lattice; }
  double fastest_heat_rate() const { return heat_rate; }
  const tm_surface &surface_measure() const { return surface_scale; }

 protected:
  SPHTM_NS::Backend &backend;
  const SPHTM_NS::PairLoops &loops;
  Settings set;
  SPHTM_NS::UnitScale unit;
  tm_lattice lattice = {};
  double heat_rate = 0.0;               // the fastest of the sizes in use, see tm_lattice.h
  double list_h = 0.0, least_spacing = 0.0;
  tm_surface surface_scale = {};
  int atom_types = 0;
  std::vector<tm_material> material;    // by type
  std::vector<std::string> names;
  std::vector<PairLaw> laws;            // by type pair
  // by type or type pair, for the loops
  struct Tables {
    SPHTM_NS::LoopArray<tm_material> material;
    SPHTM_NS::LoopArray<tm_real> conductance, young, effusivity;
    SPHTM_NS::LoopArray<tm_real> gradient;    // tm_gradient_table, with particles of different size
    SPHTM_NS::LoopArray<tm_real> share;       // tm_tensile_table, where the artificial stress is balanced
    SPHTM_NS::LoopArray<tm_body_law> law;
    SPHTM_NS::LoopArray<int> touch;
    void live_in(SPHTM_NS::Backend &);
  } tables;
  FixSPHTM *fix = nullptr;
  bool stepped = false;
  std::string restart_fix;              // the fix whose state the restart file holds
  std::string restart_name;             // of that file
  struct Written {                      // what the run had that wrote it
    Settings set;
    std::vector<tm_material> material;
    std::vector<PairLaw> laws;
  };
  std::unique_ptr<Written> written;

  SPHTM_NS::RowSource *row_source = nullptr;    // or the rows below
  // rows of the owned particles, rebuilt with the host's list
  SPHTM_NS::LoopArray<int> row_index, row_mechanical, row_thermal, row_contact;
  SPHTM_NS::LoopArray<ptrdiff_t> row_first;
  ptrdiff_t row_stride = 1;

  // records of owned and ghost particles; results of owned ones
  SPHTM_NS::LoopArray<tm_real> rec_main, rec_stress, rec_heat, rec_correction, rec_size, rec_hourglass;
  SPHTM_NS::LoopArray<float> single_main, single_more, single_correction, single_size;    // mixed precision
  SPHTM_NS::LoopArray<tm_real> gradient, heat, correction, xsph_v, hourglass_rate, surface, artificial;
  SPHTM_NS::LoopArray<tm_real> near_count, tally;
  SPHTM_NS::LoopArray<double> force_internal;
  tm_records rec = {};
  tm_rates_args args = {};
  // what forward_comm carries: columns of this array, or the records
  SPHTM_NS::LoopArray<tm_real> *forwarded = nullptr;
  int forwarded_columns = 0;
  bool meets_thermal = false;         // some types exchange heat only

  void allocate();
  void find_row_source();
  virtual void build_rows();
  void make_room_for_rows();
  void check_volume();
  void check_masses();
  void check_bins();
  void check_list_size(double dp);
  void make_tables();
  void resize_arrays();
  void fill_args(const tm_state &);
  void check_mixed() const;
  tm_records_single single_records();
  void round_records();    // to single
  void predict(const tm_state &);
  void forward_records();
  int forward_columns() const;        // of one ghost: the records in use but for the position
  virtual void take_ghost_positions();    // into their records
  tm_near_args near_args(bool of_each);
  void correct_gradients(int, tm_rates_args &);
  void resist_hourglass(const tm_rates_args &);
  void body_contact(const tm_rates_args &);
  void audit(SPHTM_NS::LoopArray<double> &);
  void tally_virial_energy();
  void parse_meeting(int, char **);
  double particle_mass(int) const;
  void set_law(int, int, const PairLaw &);
  void complete_laws();
  void refuse_damaged(const std::string &fault);
  void compare_with_restart();
  std::string name_of_parts() const;
};

}    // namespace LAMMPS_NS

#endif
