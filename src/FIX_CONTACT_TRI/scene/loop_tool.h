/* SPH-TM: mesh and broad phase of a tool where the particle loops run. They are in the tool's own
   frame, so they are copied once, whatever its motion. */
#ifndef SPHTM_LOOP_TOOL_H
#define SPHTM_LOOP_TOOL_H

#include "loop_array.h"
#include "tri_tool.h"

namespace SPHTM_NS {

class LoopTool {
 public:
  void copy(Backend &, const TriTool &);
  const tm_tri_view &mesh() const { return mesh_; }
  const tm_grid_view &grid() const { return grid_; }

 private:
  LoopArray<double> vertex, corner, normal, ball, edge_normal, vertex_normal;
  LoopArray<int> tri, twin, patch, spoke_first, spoke, block, first, segment, list;
  LoopArray<float> near;
  tm_tri_view mesh_ = {};
  tm_grid_view grid_ = {};
};

}    // namespace SPHTM_NS

#endif
