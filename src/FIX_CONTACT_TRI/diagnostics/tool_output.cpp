#include "tool_output.h"

#include "comm.h"
#include "domain.h"
#include "dump_shapes.h"
#include "error.h"
#include "force.h"
#include "memory.h"
#include "update.h"
#include "utils.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

ToolOutput::ToolOutput(LAMMPS *l, const std::string &fix_id, const ContactSettings &s, const TriTool &t) :
    lmp(l), id(fix_id), set(s), tool(t)
{
  if (!ContactSettings::is_xml(set.vtk.name)) return;
  const std::string wrong = ParaviewSeries::wrong_name(set.vtk.name);
  if (!wrong.empty()) lmp->error->all(FLERR, "Fix contact/tri {}: vtk: file name {} {}", id, set.vtk.name, wrong);
  series = std::make_unique<ParaviewSeries>(set.vtk.name, id);
}

ToolOutput::~ToolOutput()
{
  lmp->memory->destroy(local);
  lmp->memory->destroy(image_rows);
}

bool ToolOutput::due(int every) const { return every > 0 && lmp->update->ntimestep % every == 0; }

bool ToolOutput::needs_values() const { return due(set.vtk.every) || due(set.local_every); }

std::string ToolOutput::file_name(const ContactSettings::File &file) const
{
  return utils::star_subst(file.name, lmp->update->ntimestep, 0);
}

// 3 of each, in the world frame
std::vector<double> ToolOutput::world_vertices(const tm_pose &p) const
{
  const tm_mesh &m = tool.mesh();
  std::vector<double> x(3 * (size_t) m.nv);
  for (size_t v = 0; v < (size_t) m.nv; v++) {
    const tm_vec3 w = tm_pose_to_world(&p, tm_load3(m.vertex + 3 * v));
    x[3 * v] = w.x;
    x[3 * v + 1] = w.y;
    x[3 * v + 2] = w.z;
  }
  return x;
}

void ToolOutput::write(const tm_pose &p, double temperature, TriangleValues &values, bool go_on)
{
  if ((!needs_values() && !due(set.stl.every)) || lmp->comm->me) return;
  const std::vector<double> x = world_vertices(p);
  if (due(set.vtk.every)) write_vtk(x, p, temperature, values, go_on);
  if (due(set.local_every)) fill_local(x, p, values);
  if (due(set.stl.every)) write_stl(x);
}

void ToolOutput::write_stl(const std::vector<double> &x) const
{
  char msg[256];
  const tm_mesh &m = tool.mesh();
  const tm_facets s = {m.nv, m.nt, x.data(), m.tri};
  if (tm_write_stl(file_name(set.stl).c_str(), &s, id.c_str(), 1, msg, sizeof msg))
    lmp->error->one(FLERR, "Fix contact/tri {}: {}", id, msg);
}

// Where the plane z = 0 cuts the triangle: false where it does not. A corner in the plane counts as above, so that an
// edge in the plane belongs to the triangle below.
static bool cut_by_plane(const double *const corner[3], double *line)
{
  int found = 0;
  for (int k = 0; k < 3; k++) {
    const double *a = corner[k], *b = corner[(k + 1) % 3];
    if ((a[2] < 0.0) == (b[2] < 0.0)) continue;
    const double along = a[2] / (a[2] - b[2]);
    for (int d = 0; d < 2; d++) line[3 * found + d] = a[d] + along * (b[d] - a[d]);
    line[3 * found + 2] = 0.0;
    found++;
  }
  return found == 2;
}

// Of each triangle its area, in two dimensions that per thickness: the length in which the plane of the particles cuts it, so
// that forces and powers, which are per thickness too, give stresses and fluxes. An edge in the plane counts for both of its
// triangles, since either may take the contacts.
std::vector<double> ToolOutput::areas(const std::vector<double> &x) const
{
  const tm_mesh &m = tool.mesh();
  std::vector<double> area(m.area, m.area + m.nt);
  if (lmp->domain->dimension == 3) return area;
  for (int t = 0; t < m.nt; t++) {
    const double *corner[3];
    for (int k = 0; k < 3; k++) corner[k] = &x[3 * (size_t) m.tri[3 * (size_t) t + k]];
    double line[6];
    area[t] = cut_by_plane(corner, line) ? hypot(line[3] - line[0], line[4] - line[1]) : 0.0;
    for (int k = 0; k < 3; k++) {
      const double *p = corner[k], *q = corner[(k + 1) % 3];
      if (p[2] == 0.0 && q[2] == 0.0) area[t] = std::max(area[t], hypot(q[0] - p[0], q[1] - p[1]));
    }
  }
  return area;
}

// names as LIGGGHTS writes them, where it has the value
void ToolOutput::write_vtk(const std::vector<double> &x, const tm_pose &p, double temperature, TriangleValues &values,
                           bool go_on)
{
  const tm_mesh &m = tool.mesh();
  const size_t nt = m.nt;
  const double *force = values.force(), *heat = values.heat();
  const int *contacts = values.contacts();
  std::vector<double> normal(nt), shear(nt), flux(nt), count(nt), T(nt, temperature), patch(nt);
  std::vector<double> stress(3 * nt), vel(3 * nt), area = areas(x);
  for (size_t t = 0; t < nt; t++) {
    const double per_area = area[t] > 0.0 ? 1.0 / area[t] : 0.0;
    const tm_vec3 f = tm_vec_scale(lmp->force->nktv2p * per_area, tm_load3(force + 3 * t));    // pressure units
    const tm_vec3 n = tm_mat_mul_vec(p.turn, tm_load3(m.normal + 3 * t));
    const double fn = tm_vec_dot(f, n);
    normal[t] = -fn;    // pressure is positive
    shear[t] = tm_vec_norm(tm_vec_axpy(f, -fn, n));
    flux[t] = heat[t] * per_area;
    count[t] = contacts[t];
    patch[t] = m.patch[t];
    const double *c = m.corner + 9 * t;
    const tm_vec3 mid = tm_vec((c[0] + c[3] + c[6]) / 3.0, (c[1] + c[4] + c[7]) / 3.0, (c[2] + c[5] + c[8]) / 3.0);
    const tm_vec3 v = tm_pose_velocity_at(&p, tm_pose_to_world(&p, mid));
    const double s[6] = {f.x, f.y, f.z, v.x, v.y, v.z};
    std::copy_n(s, 3, &stress[3 * t]);
    std::copy_n(s + 3, 3, &vel[3 * t]);
  }
  const tm_cell_array arrays[] = {{"normal_stress_average", 1, normal.data()},
                                  {"shear_stress_average", 1, shear.data()},
                                  {"stress", 3, stress.data()},
                                  {"area", 1, area.data()},
                                  {"vel", 3, vel.data()},
                                  {"temp", 1, T.data()},
                                  {"heat_flux", 1, flux.data()},
                                  {"contacts", 1, count.data()},
                                  {"patch", 1, patch.data()}};
  constexpr int COUNT = sizeof arrays / sizeof arrays[0];
  char msg[256];
  const tm_facets s = {m.nv, m.nt, x.data(), m.tri};
  if (series) return write_vtp(s, arrays, COUNT, go_on);
  const std::string title = fmt::format("SPH-TM tool {} step {}", id, lmp->update->ntimestep);
  if (tm_write_vtk(file_name(set.vtk).c_str(), &s, arrays, COUNT, title.c_str(), 1, msg, sizeof msg))
    lmp->error->one(FLERR, "Fix contact/tri {}: {}", id, msg);
}

namespace {

double time_now(const Update &u) { return u.atime + (u.ntimestep - u.atimestep) * u.dt; }

// triangles with values per point and per triangle, as the arrays say; what went wrong, or an empty text
std::string write_xml(const std::string &path, const tm_facets &s, const std::vector<VtpFile::Array> &arrays,
                      const std::vector<const double *> &values, double time)
{
  errno = 0;
  FILE *f = fopen(path.c_str(), "wb");
  if (!f) return fmt::format("cannot write {}: {}", path, strerror(errno));
  const std::vector<int> columns = {0, 1, 2};
  VtpFile file(f, s.nv, s.nt);
  file.begin(arrays, time);
  for (size_t a = 0; a < arrays.size(); a++) {
    const int wide = arrays[a].components;
    file.put(a, 0, arrays[a].place == VtpFile::CELL_DATA ? s.nt : s.nv, values[a], wide,
             {columns.begin(), columns.begin() + wide});
  }
  const std::vector<double> corners(s.tri, s.tri + 3 * (size_t) s.nt);
  file.put(file.triangle_corners(), 0, s.nt, corners.data(), 3, columns);
  file.end();
  const bool bad = ferror(f);
  if (fclose(f) == 0 && !bad) return "";
  return fmt::format("cannot write {}: {}", path, errno ? strerror(errno) : "write failed");
}

}    // namespace

void ToolOutput::write_vtp(const tm_facets &s, const tm_cell_array *array, int arrays, bool go_on)
{
  std::vector<VtpFile::Array> of_file = {{VtpFile::POINTS, "Points", VtpFile::FLOAT64, 3}};
  std::vector<const double *> values = {s.vertex};
  for (int a = 0; a < arrays; a++) {
    of_file.push_back({VtpFile::CELL_DATA, array[a].name, VtpFile::FLOAT64, array[a].columns});
    values.push_back(array[a].value);
  }
  const std::string path = file_name(set.vtk);
  const bigint step = lmp->update->ntimestep;
  const double time = time_now(*lmp->update);
  std::string wrong = write_xml(path, s, of_file, values, time);
  if (wrong.empty() && !begun) wrong = go_on ? series->go_on(step) : series->begin_anew();
  begun = true;
  if (wrong.empty()) wrong = series->enter(step, time, {path});
  if (!wrong.empty()) lmp->error->one(FLERR, "Fix contact/tri {}: {}", id, wrong);
}

std::string ToolOutput::write_surface(const std::string &path, const tm_pose &p, double temperature, double time) const
{
  const tm_mesh &m = tool.mesh();
  const std::vector<double> x = world_vertices(p), T(m.nv, temperature);
  std::vector<double> v(x.size());
  for (size_t k = 0; k < x.size(); k += 3) {
    const tm_vec3 of_point = tm_pose_velocity_at(&p, tm_load3(&x[k]));
    v[k] = of_point.x;
    v[k + 1] = of_point.y;
    v[k + 2] = of_point.z;
  }
  return write_xml(path, {m.nv, m.nt, x.data(), m.tri},
                   {{VtpFile::POINTS, "Points", VtpFile::FLOAT64, 3},
                    {VtpFile::POINT_DATA, "velocity", VtpFile::FLOAT64, 3},
                    {VtpFile::POINT_DATA, "temperature", VtpFile::FLOAT64, 1}},
                   {x.data(), v.data(), T.data()}, time);
}

void ToolOutput::fill_local(const std::vector<double> &x, const tm_pose &p, TriangleValues &values)
{
  const tm_mesh &m = tool.mesh();
  const double *force = values.force(), *heat = values.heat();
  const int *contacts = values.contacts();
  if (!local) lmp->memory->create(local, m.nt, LOCAL_COLUMNS, "contact/tri:local");
  const std::vector<double> area = areas(x);
  for (int t = 0; t < m.nt; t++) {
    double *row = local[t];
    const int *v = m.tri + 3 * (size_t) t;
    for (int k = 0; k < 3; k++) std::copy_n(&x[3 * (size_t) v[k]], 3, row + 3 * k);
    std::copy_n(force + 3 * (size_t) t, 3, row + 9);
    const tm_vec3 n = tm_mat_mul_vec(p.turn, tm_load3(m.normal + 3 * (size_t) t));
    const double rest[6] = {heat[t], (double) contacts[t], area[t], n.x, n.y, n.z};
    std::copy_n(rest, 6, row + 12);
  }
}

int ToolOutput::image(const tm_pose &p, int *&kinds, double **&rows)
{
  const tm_mesh &m = tool.mesh();
  if (lmp->comm->me) return 0;
  const bool flat = lmp->domain->dimension == 2;    // dump image draws no triangles there
  const std::vector<double> x = world_vertices(p);
  image_kind.assign(m.nt, flat ? DumpShapes::LINE : DumpShapes::TRIANGLE);
  if (!image_rows) lmp->memory->create(image_rows, m.nt, DumpShapes::COLUMNS, "contact/tri:image");
  int n = 0;
  for (int t = 0; t < m.nt; t++) {
    const double *corner[3];
    for (int k = 0; k < 3; k++) corner[k] = &x[3 * (size_t) m.tri[3 * (size_t) t + k]];
    double *row = image_rows[n];
    row[0] = set.body_type ? set.body_type : 1;
    if (flat) {
      if (!cut_by_plane(corner, row + 1)) continue;
    } else
      for (int k = 0; k < 3; k++) std::copy_n(corner[k], 3, row + 1 + 3 * k);
    n++;
  }
  kinds = image_kind.data();
  rows = image_rows;
  return n;
}

}    // namespace SPHTM_NS
