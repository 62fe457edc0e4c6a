/* -*- c++ -*- ----------------------------------------------------------
   SPH-TM: fix contact/tri. A rigid tool of triangles: contact, friction and
   heat with the particles of pair sph/tm, motion, forces on the tool, files.
------------------------------------------------------------------------- */
#ifndef LMP_FIX_CONTACT_TRI_H
#define LMP_FIX_CONTACT_TRI_H

#include "fix.h"

#include "contact_places.h"
#include "contact_probe.h"
#include "contact_results.h"
#include "loop_tool.h"
#include "tool_checks.h"
#include "tool_motion.h"
#include "tool_output.h"
#include "tool_particles.h"
#include "tool_query.h"
#include "tool_temperature.h"

#include <memory>
#include <vector>

namespace SPHTM_NS {
class Model;
class ParticleState;
class Scene;
}    // namespace SPHTM_NS

namespace LAMMPS_NS {

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
  void post_run() override;
  int modify_param(int, char **) override;
  double compute_scalar() override;
  double compute_vector(int) override;
  int image(int *&, double **&) override;
  void touched(int i, double radius, std::vector<Surface> &) override;
  std::string write_surface(const std::string &path, double time) override;
  tm_tool_box box() const override;
  void before_forces() override;
  int pack_forward_comm(int, int *, double *, int, int *) override;
  void unpack_forward_comm(int, int, double *) override;
  void write_restart(FILE *) override;
  void restart(char *) override;
  double memory_usage() override;

  // for compute cutting/force: where the tool is and how it moves now
  tm_pose tool_pose() const { return motion.pose_now(); }

 protected:
  const SPHTM_NS::ContactSettings set;
  SPHTM_NS::ToolParticles particles;

 private:
  const std::shared_ptr<SPHTM_NS::Scene> scene;
  SPHTM_NS::TriTool tool;
  SPHTM_NS::ToolMotion motion;
  SPHTM_NS::ToolTemperature temperature;
  SPHTM_NS::LoopTool loop_tool;
  SPHTM_NS::ContactLaws laws;
  SPHTM_NS::ContactResults results;
  SPHTM_NS::TriangleValues triangles;
  SPHTM_NS::LoopArray<double> earlier;    // of the first of several tools: what those before did to each particle
  SPHTM_NS::ContactPlaces places;
  FixContactTri *first_tool = nullptr;    // with an energy balance, where forces come behind it
  bool corrects_late = false;             // the last of these tools, with forces of other fixes behind one of them
  SPHTM_NS::ToolOutput output;
  SPHTM_NS::ToolChecks checks;
  SPHTM_NS::ParticleState *state = nullptr;
  const SPHTM_NS::Model *model = nullptr;
  tm_vec3 reference;       // point of the torques, in the tool's frame
  double spacing = 0.0;    // of the particles, with which the search grid was built
  bool restored = false, motion_given = false, overlap_checked = false;

  void find_first_tool();
  void report_tool() const;
  void limit_time_step();
  void check_overlap();
  void evaluate_variables(double dt);
  tm_contact_args contact_args(bool of_triangles);
  void finish_contact();
  void write_output();
  const double *results_now();
  SPHTM_NS::ToolQuery query() const;
  void warn_of_other_input(const std::vector<double> &) const;
};

}    // namespace LAMMPS_NS

#endif
