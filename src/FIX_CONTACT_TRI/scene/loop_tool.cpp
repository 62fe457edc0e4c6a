#include "loop_tool.h"

namespace SPHTM_NS {

void LoopTool::copy(Backend &loops, const TriTool &tool)
{
  mesh_ = tool.view();
  grid_ = tool.grid();
  if (loops.shared()) return;
  auto there = [&](auto &array, auto *&values, size_t n) {
    array.live_in(loops);
    array.assign(values, n);
    values = array.loop_read();
  };
  const size_t nt = mesh_.nt, nv = mesh_.nv, spokes = mesh_.spoke_first[nv];
  there(vertex, mesh_.vertex, 3 * nv);
  there(corner, mesh_.corner, 9 * nt);
  there(normal, mesh_.normal, 3 * nt);
  there(ball, mesh_.ball, 4 * nt);
  there(tri, mesh_.tri, 3 * nt);
  there(twin, mesh_.twin, 3 * nt);
  there(patch, mesh_.patch, nt);
  there(edge_normal, mesh_.edge_normal, 9 * nt);
  there(vertex_normal, mesh_.vertex_normal, 3 * nv);
  there(spoke_first, mesh_.spoke_first, nv + 1);
  there(spoke, mesh_.spoke, spokes);
  const size_t cells = (size_t) tool.grid_blocks() * TM_GRID_CELLS, segments = grid_.first[cells];
  const size_t entries = grid_.segment[segments];
  there(block, grid_.block, (size_t) grid_.blocks[0] * grid_.blocks[1] * grid_.blocks[2]);
  there(first, grid_.first, cells + 1);
  there(segment, grid_.segment, segments + 1);
  there(list, grid_.list, entries);
  there(near, grid_.near, entries);
}

}    // namespace SPHTM_NS
