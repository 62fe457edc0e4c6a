/* SPH-TM: what fix contact/tri writes and draws: values per triangle, VTK, STL, dump image. */
#include "fix_contact_tri.h"

#include "fix_sph_tm.h"
#include "pair_sph_tm.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "memory.h"
#include "tm_mesh_write.h"
#include "update.h"
#include "utils.h"

#include <algorithm>
#include <cstring>

using namespace LAMMPS_NS;
using namespace SPHTM_NS;

static bool due(int every, bigint step)
{
  return every > 0 && step % every == 0;
}

bool FixContactTri::output_due() const
{
  return due(vtk.every, update->ntimestep) || due(local_every, update->ntimestep);
}

void FixContactTri::clear_triangles()
{
  if (!vtk.every && !local_every) return;
  const size_t nt = tool.mesh().nt;
  tri_force.resize(3 * nt);
  tri_heat.resize(nt);
  tri_count.resize(nt);
  Backend &loops = state->loops();
  loops.zero(tri_force.loop_write(), tri_force.bytes());
  loops.zero(tri_heat.loop_write(), tri_heat.bytes());
  loops.zero(tri_count.loop_write(), tri_count.bytes());
}

// sums over ranks, on the first one
void FixContactTri::gather_triangles()
{
  auto reduce = [&](void *data, int n, MPI_Datatype type) {
    MPI_Reduce(comm->me ? data : MPI_IN_PLACE, data, n, type, MPI_SUM, 0, world);
  };
  double *heat = tri_heat.host_write();
  reduce(tri_force.host_write(), (int) tri_force.size(), MPI_DOUBLE);
  reduce(heat, (int) tri_heat.size(), MPI_DOUBLE);
  reduce(tri_count.host_write(), (int) tri_count.size(), MPI_INT);
  const double power = 1.0 / pair->units().energy;
  for (size_t t = 0; t < tri_heat.size(); t++) heat[t] *= power;
}

std::vector<double> FixContactTri::world_vertices() const
{
  const tm_mesh &m = tool.mesh();
  const tm_pose p = pose_now();
  std::vector<double> x(3 * (size_t) m.nv);
  for (size_t v = 0; v < (size_t) m.nv; v++) {
    const tm_vec3 w = tm_pose_to_world(&p, tm_load3(m.vertex + 3 * v));
    x[3 * v] = w.x;
    x[3 * v + 1] = w.y;
    x[3 * v + 2] = w.z;
  }
  return x;
}

void FixContactTri::write_files()
{
  const bigint step = update->ntimestep;
  const bool values = output_due();
  if (values) gather_triangles();
  if ((!values && !due(stl.every, step)) || comm->me) return;
  const std::vector<double> x = world_vertices();
  const tm_mesh &m = tool.mesh();
  if (due(vtk.every, step)) write_vtk(utils::star_subst(vtk.name, step, 0), x);
  if (due(local_every, step)) fill_local(x);
  if (due(stl.every, step)) {
    char msg[256];
    const tm_facets s = {m.nv, m.nt, x.data(), m.tri};
    if (tm_write_stl(utils::star_subst(stl.name, step, 0).c_str(), &s, id, 1, msg, sizeof msg))
      error->one(FLERR, "Fix contact/tri {}: {}", id, msg);
  }
}

// names as LIGGGHTS writes them, where it has the value
void FixContactTri::write_vtk(const std::string &name, const std::vector<double> &x)
{
  const tm_mesh &m = tool.mesh();
  const tm_pose p = pose_now();
  const size_t nt = m.nt;
  const double *force = tri_force.host_read(), *heat = tri_heat.host_read();
  const int *contacts = tri_count.host_read();
  std::vector<double> normal(nt), shear(nt), flux(nt), count(nt), T(nt), patch(nt);
  std::vector<double> stress(3 * nt), vel(3 * nt);
  for (size_t t = 0; t < nt; t++) {
    const tm_vec3 f = tm_vec_scale(1.0 / m.area[t], tm_load3(force + 3 * t));
    const tm_vec3 n = tm_mat_mul_vec(p.turn, tm_load3(m.normal + 3 * t));
    const double fn = tm_vec_dot(f, n);
    normal[t] = -fn;    // pressure is positive
    shear[t] = tm_vec_norm(tm_vec_axpy(f, -fn, n));
    flux[t] = heat[t] / m.area[t];
    count[t] = contacts[t];
    T[t] = temperature;
    patch[t] = m.patch[t];
    const double *c = m.corner + 9 * t;
    const tm_vec3 mid =
        tm_vec((c[0] + c[3] + c[6]) / 3.0, (c[1] + c[4] + c[7]) / 3.0, (c[2] + c[5] + c[8]) / 3.0);
    const tm_vec3 v = tm_pose_velocity_at(&p, tm_pose_to_world(&p, mid));
    const double s[6] = {f.x, f.y, f.z, v.x, v.y, v.z};
    std::copy_n(s, 3, &stress[3 * t]);
    std::copy_n(s + 3, 3, &vel[3 * t]);
  }
  const tm_cell_array arrays[] = {{"normal_stress_average", 1, normal.data()},
                                  {"shear_stress_average", 1, shear.data()},
                                  {"stress", 3, stress.data()},
                                  {"area", 1, m.area},
                                  {"vel", 3, vel.data()},
                                  {"temp", 1, T.data()},
                                  {"heat_flux", 1, flux.data()},
                                  {"contacts", 1, count.data()},
                                  {"patch", 1, patch.data()}};
  char msg[256];
  const tm_facets s = {m.nv, m.nt, x.data(), m.tri};
  const std::string title = fmt::format("SPH-TM tool {} step {}", id, update->ntimestep);
  if (tm_write_vtk(name.c_str(), &s, arrays, sizeof arrays / sizeof arrays[0], title.c_str(), 1,
                   msg, sizeof msg))
    error->one(FLERR, "Fix contact/tri {}: {}", id, msg);
}

// rows of the first rank: corners(9), force(3), heat, contacts, area, normal(3)
void FixContactTri::fill_local(const std::vector<double> &x)
{
  const tm_mesh &m = tool.mesh();
  const tm_pose p = pose_now();
  const double *force = tri_force.host_read(), *heat = tri_heat.host_read();
  const int *contacts = tri_count.host_read();
  if (!local_rows) memory->create(local_rows, m.nt, size_local_cols, "contact/tri:local");
  for (int t = 0; t < m.nt; t++) {
    double *row = local_rows[t];
    const int *v = m.tri + 3 * (size_t) t;
    for (int k = 0; k < 3; k++) std::copy_n(&x[3 * (size_t) v[k]], 3, row + 3 * k);
    std::copy_n(force + 3 * (size_t) t, 3, row + 9);
    const tm_vec3 n = tm_mat_mul_vec(p.turn, tm_load3(m.normal + 3 * (size_t) t));
    row[12] = heat[t];
    row[13] = contacts[t];
    row[14] = m.area[t];
    row[15] = n.x;
    row[16] = n.y;
    row[17] = n.z;
  }
  array_local = local_rows;
  size_local_rows = m.nt;
}

int FixContactTri::image(int *&kinds, double **&rows)
{
  enum { SPHERE, LINE, TRI };    // of dump image
  const tm_mesh &m = tool.mesh();
  if (comm->me) return 0;
  const std::vector<double> x = world_vertices();
  image_kind.assign(m.nt, TRI);
  if (!image_rows) memory->create(image_rows, m.nt, 10, "contact/tri:image");
  for (int t = 0; t < m.nt; t++) {
    image_rows[t][0] = request.body_type ? request.body_type : 1;
    for (int k = 0; k < 3; k++)
      std::copy_n(&x[3 * (size_t) m.tri[3 * (size_t) t + k]], 3, image_rows[t] + 1 + 3 * k);
  }
  kinds = image_kind.data();
  rows = image_rows;
  return m.nt;
}
