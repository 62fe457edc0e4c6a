/* SPH-TM: the shape of a tool: a mesh from a file, placed, checked, with its broad phase. */
#ifndef SPHTM_TRI_TOOL_H
#define SPHTM_TRI_TOOL_H

#include "tm_mesh.h"
#include "tm_tri_grid.h"

#include <cstdint>
#include <mpi.h>
#include <string>
#include <vector>

namespace SPHTM_NS {

class TriTool {
 public:
  TriTool();
  ~TriTool();
  TriTool(const TriTool &) = delete;
  TriTool &operator=(const TriTool &) = delete;

  // one placement, in the order written
  struct Placement {
    enum Kind { SCALE, MOVE, ROTATE } kind;
    double value[4];    // factors; distance; axis and angle (degrees)
  };
  struct Shape {
    std::string file;
    size_t max_bytes = 512000000;    // of the file
    std::vector<Placement> placement;
    tm_mesh_options options;
    int flip = -1;    // 1: turn facets round, 0: leave them, -1: not given

    uint64_t hash() const;    // of all that changes what is in the file
  };

  // empty, or what is wrong and how to mend it; the same on all ranks (collective)
  std::string load(MPI_Comm world, const Shape &shape, bool two_sided);
  std::string index(MPI_Comm world, double radius);
  // for the log, in one line
  std::string summary() const;
  double thickness(int dimension) const;    // the least extent, along an axis of the mesh's frame
  // less serious flaws, one line each
  std::vector<std::string> flaws(bool two_sided) const;

  const tm_mesh &mesh() const { return mesh_; }
  tm_tri_view view() const { return tm_mesh_view(&mesh_); }
  const tm_grid_view &grid() const { return grid_.view; }
  int grid_blocks() const { return grid_.nblocks; }
  tm_vec3 origin() const { return origin_; }       // where the file's origin came to lie
  uint64_t content() const { return content_; }    // hash of the file's bytes
  double bytes() const;

 private:
  std::string build(const Shape &shape, const unsigned char *data, size_t size);
  tm_mesh mesh_;
  tm_tri_grid grid_;
  tm_vec3 origin_;
  uint64_t content_ = 0;
};

}    // namespace SPHTM_NS

#endif
