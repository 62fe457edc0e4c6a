/* SPH-TM: what a tool writes and draws: VTK and STL files, a local array, triangles or lines for dump image. */
#ifndef SPHTM_TOOL_OUTPUT_H
#define SPHTM_TOOL_OUTPUT_H

#include "contact_settings.h"
#include "paraview_series.h"
#include "tm_mesh_write.h"
#include "tm_motion.h"
#include "triangle_values.h"
#include "vtp_file.h"

#include <memory>
#include <vector>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace SPHTM_NS {

class ToolOutput {
 public:
  static constexpr int LOCAL_COLUMNS = 18;    // corners(9), force(3), heat, contacts, area, normal(3)

  ToolOutput(LAMMPS_NS::LAMMPS *, const std::string &id, const ContactSettings &, const TriTool &);
  ~ToolOutput();
  ToolOutput(const ToolOutput &) = delete;
  ToolOutput &operator=(const ToolOutput &) = delete;
  bool needs_values() const;    // per triangle, in this step
  // what is due in this step; values of all ranks. go_on: a list of files continues that of the run before a restart
  void write(const tm_pose &, double temperature, TriangleValues &, bool go_on);
  // a VTK XML file of places, velocity and temperature; what went wrong, or an empty text
  std::string write_surface(const std::string &path, const tm_pose &, double temperature, double time) const;
  double **local_rows() const { return local; }    // one per triangle on the first rank, or nullptr
  // triangles for dump image, in 2d lines where they cross z = 0; returns how many
  int image(const tm_pose &, int *&kinds, double **&rows);

 private:
  LAMMPS_NS::LAMMPS *lmp;
  std::string id;
  const ContactSettings &set;
  const TriTool &tool;
  double **local = nullptr, **image_rows = nullptr;
  std::vector<int> image_kind;
  std::unique_ptr<ParaviewSeries> series;    // of VTK XML files
  bool begun = false;                        // there is a list of them

  bool due(int every) const;
  std::string file_name(const ContactSettings::File &) const;
  std::vector<double> world_vertices(const tm_pose &) const;
  std::vector<double> areas(const std::vector<double> &vertices) const;
  void write_vtk(const std::vector<double> &vertices, const tm_pose &, double temperature, TriangleValues &,
                 bool go_on);
  void write_vtp(const tm_facets &, const tm_cell_array *, int arrays, bool go_on);
  void write_stl(const std::vector<double> &vertices) const;
  void fill_local(const std::vector<double> &vertices, const tm_pose &, TriangleValues &);
};

}    // namespace SPHTM_NS

#endif
