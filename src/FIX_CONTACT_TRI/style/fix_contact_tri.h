/* -*- c++ -*- ----------------------------------------------------------
   SPH-TM: fix contact/tri. A rigid tool of triangles: contact, friction and
   heat with the particles of pair sph/tm, motion, forces on the tool, files.
------------------------------------------------------------------------- */
#ifndef LMP_FIX_CONTACT_TRI_H
#define LMP_FIX_CONTACT_TRI_H

#include "fix.h"

#include "contact_loop.h"
#include "contact_probe.h"
#include "loop_tool.h"
#include "tm_carry.h"
#include "tm_spread.h"
#include "tool_motion.h"
#include "tri_tool.h"

#include <cstdint>
#include <string>
#include <vector>

namespace SPHTM_NS {
class Keywords;
}

namespace LAMMPS_NS {

class FixSPHTM;

class FixContactTri : public Fix, public SPHTM_NS::ContactProbe {
 public:
  FixContactTri(class LAMMPS *, int, char **);
  ~FixContactTri() override;
  int setmask() override;
  void init() override;
  void setup(int) override;
  void initial_integrate(int) override;
  void post_force(int) override;
  void final_integrate() override;
  void end_of_step() override;
  int modify_param(int, char **) override;
  double compute_scalar() override;
  double compute_vector(int) override;
  int image(int *&, double **&) override;
  void *extract(const char *, int &) override;
  void touched(int i, double radius, std::vector<Surface> &) override;
  int pack_forward_comm(int, int *, double *, int, int *) override;
  void unpack_forward_comm(int, int, double *) override;
  void write_restart(FILE *) override;
  void restart(char *) override;
  double memory_usage() override;

  // for compute cutting/force: force on the tool and its velocity now, in the unit style
  void tool_force(double *force);
  tm_vec3 tool_velocity() const { return pose_now().velocity; }

 protected:
  // what the user asked for, in the unit style
  struct Request {
    tm_table friction = {};
    double shear = 0.0, penalty = 1.0, damping = 0.1;
    double share = -1.0, effusivity = -1.0, conductance = 0.0;
    bool approach = false, f15 = false, two_sided = false, overlap_allowed = false;
    int body_type = 0;    // heat-only particles inside the tool
    bool reference_given = false;
    double reference[3] = {0, 0, 0};
    double lumped_capacity = 0.0;    // mass c_p of the tool, 0: temperature is given
    double temperature = 0.0;        // the number given, or 0
  } request;

  SPHTM_NS::TriTool tool;
  SPHTM_NS::TriTool::Shape shape;
  SPHTM_NS::ToolMotion motion;
  FixSPHTM *state = nullptr;
  class PairSPHTM *pair = nullptr;
  double clock = 0.0;          // time since the fix was made
  double temperature = 0.0;    // of the tool; 0: not known yet
  std::string temperature_variable;
  bool temperature_given = false, heat_given = false;
  tm_vec3 reference_local;             // reference point in the tool's frame
  std::vector<tm_contact_law> laws;    // by type
  SPHTM_NS::LoopArray<tm_contact_law> loop_laws;
  SPHTM_NS::LoopTool loop_tool;
  double dt_limit = 0.0;               // of the contact springs
  double sound_speed = 0.0;            // of the fastest solid, 0: there is none
  double indexed_reach = 0.0;
  bool restored = false, checked = false, warned_deep = false, warned_empty = false, warned_heat = false;
  tm_vec3 last_corner[8];              // of the mesh's box after the last step, here or before a restart
  bool seen = false;                   // there was one

  tm_contact_result sums;    // of this rank, this step
  bool unfinished = false;   // not yet there
  double totals[14];         // over ranks
  bigint totals_step = -1;
  SPHTM_NS::LoopArray<double> tool_heat;    // per particle: heat for the tool's own particles

  // files and values per triangle
  struct File {
    int every = 0;
    std::string name;
  } vtk, stl;
  int local_every = 0;
  SPHTM_NS::LoopArray<double> tri_force, tri_heat;
  SPHTM_NS::LoopArray<int> tri_count;
  double **local_rows = nullptr;
  std::vector<int> image_kind;
  double **image_rows = nullptr;

  void parse(int, char **);
  bool parse_mesh(SPHTM_NS::Keywords &);
  bool parse_placement(SPHTM_NS::Keywords &);
  bool parse_friction(SPHTM_NS::Keywords &);
  bool parse_heat(SPHTM_NS::Keywords &);
  bool parse_output(SPHTM_NS::Keywords &);
  void evaluate_variables(double dt);
  void report();
  std::string heat_in_words(int type) const;
  void make_laws();
  void limit_time_step();
  tm_contact_law make_law(int type);
  void check_dimension();
  void check_speed(double speed) const;
  void check_jump(const tm_pose &end);
  void note_corners(const tm_pose &, tm_vec3 *corner) const;
  void warn_of_empty_group();
  bool rubs() const { return request.friction.n || request.friction.value > 0.0; }
  void ask_for_heat();
  int type_without_heat(const std::vector<int> &types) const;
  std::vector<int> types_in_reach() const;
  void check_overlap(double passes);    // so many spacings pass
  double overlap_passes = 0.0;
  bool overlaps(const tm_contact_args &, tm_vec3 shift, int *worst) const;
  double way_out(const tm_contact_args &, tm_vec3 direction, double limit) const;
  int sample_inside(const tm_contact_args &) const;
  unsigned effects(bool output) const;
  tm_contact_args make_args(const tm_pose &, bool output);
  tm_contact_args host_args(const tm_pose &);    // positions only
  // the loops over the particles of this rank; the sums of contact are there when it is finished
  virtual void start_contact(const tm_contact_args &, unsigned effects);
  virtual void wait_for_contact() {}
  void finish_contact();
  virtual void run_carry(const tm_carry_args &);
  virtual int run_divide(const tm_spread_args &);
  virtual void run_collect(const tm_spread_args &);
  tm_pose pose_now() const { return motion.pose(clock, 0.0, 0.0); }
  FixSPHTM *current_state() const;    // or an error: there are no values
  std::vector<uint64_t> keyword_hashes() const;
  void warn_of_other_input(const std::vector<double> &written);
  void book(double dt);
  void update_temperature();
  void place_body(const tm_pose &from, const tm_pose &to);
  void heat_body();
  void sum_up();

  bool output_due() const;
  void clear_triangles();
  void gather_triangles();
  void write_files();
  void write_vtk(const std::string &, const std::vector<double> &vertices);
  void fill_local(const std::vector<double> &vertices);
  std::vector<double> world_vertices() const;
};

}    // namespace LAMMPS_NS

#endif
