#include "tri_tool.h"

#include "restart_block.h"
#include "tm_mesh_read.h"
#include "tm_mesh_transform.h"
#include "tool_file.h"

#include "fmt/format.h"

#include <algorithm>
#include <cstring>

namespace SPHTM_NS {

TriTool::TriTool() : origin_(tm_vec(0, 0, 0))
{
  memset(&mesh_, 0, sizeof(mesh_));
  memset(&grid_, 0, sizeof(grid_));
}

TriTool::~TriTool()
{
  tm_tri_grid_free(&grid_);
  tm_mesh_free(&mesh_);
}

static void place(tm_soup *soup, tm_vec3 *origin, const TriTool::Placement &p)
{
  const double *a = p.value;
  switch (p.kind) {
    case TriTool::Placement::SCALE:
      tm_soup_scale(soup, a[0], a[1], a[2]);
      *origin = tm_vec(origin->x * a[0], origin->y * a[1], origin->z * a[2]);
      break;
    case TriTool::Placement::MOVE:
      tm_soup_move(soup, tm_vec(a[0], a[1], a[2]));
      *origin = tm_vec_add(*origin, tm_vec(a[0], a[1], a[2]));
      break;
    case TriTool::Placement::ROTATE: {
      const tm_vec3 axis = tm_vec(a[0], a[1], a[2]);
      tm_soup_rotate(soup, axis, a[3]);
      *origin = tm_mat_mul_vec(tm_rotation_about(axis, a[3] * TM_PI / 180.0), *origin);
      break;
    }
  }
}

uint64_t TriTool::Shape::hash() const
{
  std::vector<double> all = {flip == 1 ? 1.0 : 0.0, options.tolerance, options.smooth_angle};
  for (const Placement &p : placement) {
    all.push_back(p.kind);
    all.insert(all.end(), p.value, p.value + (p.kind == Placement::ROTATE ? 4 : 3));
  }
  return hash_bytes(all.data(), all.size() * sizeof(double));
}

std::string TriTool::build(const Shape &shape, const unsigned char *data, size_t size)
{
  char msg[256];
  tm_soup soup;
  int status = tm_mesh_read_buffer(data, size, &soup, msg, sizeof msg);
  if (status == TM_MESH_OK) {
    for (const auto &p : shape.placement) place(&soup, &origin_, p);
    if (shape.flip == 1) tm_soup_flip(&soup);
    status = tm_mesh_build(&soup, &shape.options, &mesh_, msg, sizeof msg);
    tm_soup_free(&soup);
  }
  if (status == TM_MESH_OK) return "";
  return fmt::format("mesh file {} ({}): {}", shape.file, tm_mesh_status_name(status), msg);
}

std::string TriTool::load(MPI_Comm world, const Shape &shape, bool two_sided)
{
  ToolFile file;
  std::string wrong = file.read(world, shape.file, shape.max_bytes);
  if (!wrong.empty()) return wrong;
  content_ = hash_bytes(file.data(), file.size());
  wrong = first_message(world, build(shape, file.data(), file.size()));
  if (!wrong.empty() || two_sided) return wrong;
  if (mesh_.inconsistent_edges)
    return fmt::format("mesh file {}: the triangles at {} edges disagree about which side is out; "
                       "repair it (admesh, MeshLab), or use 'sides two'",
                       shape.file, mesh_.inconsistent_edges);
  if (!mesh_.closed || shape.flip >= 0) return "";
  const int in = tm_mesh_inside_out(&mesh_, 0);
  if (in >= 0 && tm_mesh_inside_out(&mesh_, 1) < 0)
    return fmt::format("the normals of mesh file {} point into the body; add 'flip yes', or 'flip "
                       "no' where the particles belong inside it",
                       shape.file);
  if (in >= 0) {
    const double *x = mesh_.corner + 9 * (size_t) in;
    return fmt::format("the normals of some bodies in mesh file {} point into them, of others out of them; into that "
                       "with a corner at {:.6g} {:.6g} {:.6g}; turn those round (admesh, MeshLab), or add 'flip no' "
                       "where particles belong inside",
                       shape.file, x[0], x[1], x[2]);
  }
  return "";
}

std::string TriTool::index(MPI_Comm world, double radius)
{
  tm_tri_grid_free(&grid_);
  const bool built = tm_tri_grid_build(&grid_, &mesh_, radius, TM_GRID_BUDGET) == TM_MESH_OK;
  return first_message(world, built ? ""
                                    : fmt::format("no memory for the search grid of {} triangles with radius {}",
                                                  mesh_.nt, radius));
}

double TriTool::thickness(int dimension) const
{
  const tm_mesh &m = mesh();
  double least = m.hi[0] - m.lo[0];
  for (int k = 1; k < dimension; k++) least = std::min(least, m.hi[k] - m.lo[k]);
  return least;
}

std::string TriTool::summary() const
{
  const tm_mesh &m = mesh_;
  std::string text =
      fmt::format("{} triangles, {} vertices, {} smooth patch{}, box {:.6g} {:.6g} {:.6g} to {:.6g} {:.6g} "
                  "{:.6g}, ",
                  m.nt, m.nv, m.npatch, m.npatch == 1 ? "" : "es", m.lo[0], m.lo[1], m.lo[2], m.hi[0], m.hi[1],
                  m.hi[2]);
  text += m.closed ? fmt::format("closed, volume {:.6g}", m.volume) : fmt::format("area {:.6g}", m.total_area);
  if (m.dropped_degenerate) text += fmt::format(", {} degenerate dropped", m.dropped_degenerate);
  if (m.dropped_duplicate) text += fmt::format(", {} duplicate dropped", m.dropped_duplicate);
  return text;
}

std::vector<std::string> TriTool::flaws(bool two_sided) const
{
  std::vector<std::string> lines;
  if (mesh_.open_edges && !two_sided)
    lines.push_back(fmt::format("the mesh has {} open edges: particles are pushed towards the side "
                                "its normals point to; use 'sides two' for a sheet that has no "
                                "inside",
                                mesh_.open_edges));
  if (mesh_.nonmanifold_edges)
    lines.push_back(fmt::format("more than two triangles meet at {} edges", mesh_.nonmanifold_edges));
  if (mesh_.flipped_normals)
    lines.push_back(fmt::format("{} facet normals in the file oppose the order of the vertices; "
                                "the order of the vertices counts",
                                mesh_.flipped_normals));
  return lines;
}

double TriTool::bytes() const
{
  const double nt = mesh_.nt, nv = mesh_.nv;
  return nt * (26 * sizeof(double) + 8 * sizeof(int)) + nv * (6 * sizeof(double) + sizeof(int)) +
         2 * sizeof(int) * (double) grid_.entries + sizeof(int) * ((double) grid_.nblocks * (TM_GRID_CELLS + 1));
}

}    // namespace SPHTM_NS
