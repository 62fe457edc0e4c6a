#include "relaxation.h"

#include "atom.h"
#include "domain.h"
#include "lammps.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

// displacements of the particles of this rank; those at a free surface, which lack neighbors, stay
std::vector<tm_vec3> Relaxation::displacements(std::vector<char> &moves)
{
  const Atom *atom = parts.host()->atom;
  const int n = atom->nlocal;
  std::vector<double> h(n);
  for (int i = 0; i < n; i++) h[i] = cloud.size(i);
  cloud.take_values(h);
  cloud.forward();
  const double farthest = 0.2, at_surface = 0.15;
  std::vector<tm_vec3> shift(n, tm_vec(0, 0, 0));
  for (int sweep = 0; sweep < in.sweeps; sweep++) {
    std::vector<tm_vec3> step(n);
    for (int i = 0; i < n; i++) {
      if (!moves[i]) continue;
      const std::vector<int> &near = cloud.neighbors(i);
      const tm_vec3 gap = tm_cloud_unevenness(&cloud.view(), i, near.data(), (int) near.size());
      const double dp = tm_edge(cloud.row(i)[TM_CLOUD_VOLUME], cloud.view().dim == 3);
      if (sweep == 0 && tm_vec_norm(gap) * dp > at_surface) moves[i] = 0;
      step[i] = tm_vec_axpy(shift[i], -0.3 * h[i] * h[i], gap);
      const double length = tm_vec_norm(step[i]), most = farthest * dp;
      if (length > most) step[i] = tm_vec_scale(most / length, step[i]);
    }
    for (int i = 0; i < n; i++) {
      if (!moves[i]) continue;
      double *x = cloud.row(i) + TM_CLOUD_X;
      x[0] += step[i].x - shift[i].x;
      x[1] += step[i].y - shift[i].y;
      x[2] += step[i].z - shift[i].z;
      shift[i] = step[i];
    }
    cloud.forward();
  }
  return shift;
}

// about the center of the moved particles, on all ranks: mass, center, spin that the moves add, inertia
struct Relaxation::Moved {
  double mass = 0.0;
  tm_vec3 center = {0, 0, 0}, mean = {0, 0, 0}, spin = {0, 0, 0};
  tm_sym3 inertia = {0, 0, 0, 0, 0, 0};
};

static tm_vec3 from(const double *x) { return tm_vec(x[0], x[1], x[2]); }

// sums of the columns over all particles of all ranks, whose last bits do not depend on the order
static std::vector<double> sum_in_any_order(const std::vector<double> &values, int columns, MPI_Comm world)
{
  std::vector<double> mine(columns, 0.0), most(columns), sums(columns);
  for (size_t k = 0; k < values.size(); k++) mine[k % columns] = std::max(mine[k % columns], fabs(values[k]));
  MPI_Allreduce(mine.data(), most.data(), columns, MPI_DOUBLE, MPI_MAX, world);
  const double parts = 1099511627776.0;    // 2^40 of the largest; room for 2^22 of it
  std::vector<long long> whole(columns, 0), all(columns);
  for (size_t k = 0; k < values.size(); k++)
    if (most[k % columns] > 0.0) whole[k % columns] += llround(values[k] / most[k % columns] * parts);
  MPI_Allreduce(whole.data(), all.data(), columns, MPI_LONG_LONG, MPI_SUM, world);
  for (int k = 0; k < columns; k++) sums[k] = (double) all[k] / parts * most[k];
  return sums;
}

Relaxation::Moved Relaxation::measure(const std::vector<char> &moves, const std::vector<tm_vec3> &shift)
{
  const Atom *atom = parts.host()->atom;
  auto unwrapped = [&](int i) {
    double x[3];
    parts.host()->domain->unmap(atom->x[i], atom->image[i], x);
    return from(x);
  };
  std::vector<double> values;
  for (int i = 0; i < atom->nlocal; i++) {
    if (!moves[i]) continue;
    const tm_vec3 x = unwrapped(i), d = shift[i];
    const double m = atom->rmass[i];
    values.insert(values.end(), {m, m * x.x, m * x.y, m * x.z, m * d.x, m * d.y, m * d.z});
  }
  std::vector<double> all = sum_in_any_order(values, 7, parts.host()->world);
  Moved s;
  s.mass = all[0];
  if (s.mass == 0.0) return s;
  s.center = tm_vec_scale(1.0 / s.mass, from(&all[1]));
  s.mean = tm_vec_scale(1.0 / s.mass, from(&all[4]));
  values.clear();
  for (int i = 0; i < atom->nlocal; i++) {
    if (!moves[i]) continue;
    const tm_vec3 d = tm_vec_sub(shift[i], s.mean), r = tm_vec_add(tm_vec_sub(unwrapped(i), s.center), d);
    const double m = atom->rmass[i], r2 = tm_vec_dot(r, r);
    const tm_vec3 spin = tm_vec_cross(d, tm_vec_scale(m, from(atom->v[i])));
    values.insert(values.end(), {spin.x, spin.y, spin.z, m * (r2 - r.x * r.x), m * (r2 - r.y * r.y),
                                 m * (r2 - r.z * r.z), -m * r.x * r.y, -m * r.x * r.z, -m * r.y * r.z});
  }
  all = sum_in_any_order(values, 9, parts.host()->world);
  s.spin = from(&all[0]);
  s.inertia = tm_sym_load(&all[3]);
  return s;
}

void Relaxation::run()
{
  Atom *atom = parts.host()->atom;
  const int n = atom->nlocal, dim = parts.host()->domain->dimension;
  parts.state().atoms().to_host();
  std::vector<char> moves(n);
  for (int i = 0; i < n; i++) {
    moves[i] = levels.is_fresh(i);
    levels.set_fresh(i, false);
  }
  const std::vector<tm_vec3> shift = displacements(moves);
  const Moved s = measure(moves, shift);
  if (s.mass == 0.0) return;
  // spin = inertia turn
  tm_vec3 turn = tm_vec(0, 0, 0);
  tm_sym3 inverse;
  if (dim == 2) turn.z = s.inertia.zz > 0.0 ? s.spin.z / s.inertia.zz : 0.0;
  else if (tm_sym_inverse(s.inertia, 1e-6, &inverse)) turn = tm_sym_mul_vec(inverse, s.spin);

  cloud.take_state();
  cloud.forward();
  const int width = cloud.view().width;
  std::vector<std::vector<double>> rows(n);
  for (int i = 0; i < n; i++) {
    if (!moves[i]) continue;
    const tm_vec3 d = tm_vec_sub(shift[i], s.mean);
    const double place[3] = {d.x, d.y, d.z};
    rows[i].assign(cloud.row(i), cloud.row(i) + width);
    remap.spread(i, place, 1, 1.0, rows[i].data());
    const double *c = cloud.row(i) + TM_CLOUD_X;
    double x[3];
    parts.host()->domain->unmap(atom->x[i], atom->image[i], x);
    const tm_vec3 r = tm_vec_add(tm_vec_sub(from(x), s.center), d), dv = tm_vec_scale(-1.0, tm_vec_cross(turn, r));
    rows[i][TM_CLOUD_V] += dv.x;
    rows[i][TM_CLOUD_V + 1] += dv.y;
    rows[i][TM_CLOUD_V + 2] += dv.z;
    rows[i][TM_CLOUD_X] = c[0] + d.x;
    rows[i][TM_CLOUD_X + 1] = c[1] + d.y;
    rows[i][TM_CLOUD_X + 2] = c[2] + d.z;
    rows[i][TM_CLOUD_VOLUME] = rows[i][TM_CLOUD_MASS] / rows[i][cloud.column(TM_F_RHO)];
    const double at[3] = {c[0] - r.x + d.x, c[1] - r.y + d.y, c[2] - r.z + d.z};    // the center, among the images of i
    tm_content change = tm_content_nothing();
    remap.add_content(change, 1.0, rows[i].data(), at, atom->type[i]);
    remap.add_content(change, -1.0, cloud.row(i), at, atom->type[i]);
    remap.tally(change, 0.0);
  }
  for (int i = 0; i < n; i++) {
    if (!moves[i]) continue;
    std::copy_n(rows[i].data() + TM_CLOUD_X, 3, atom->x[i]);
    remap.write_row(i, rows[i].data());
  }
  parts.state().atoms().host_changed();
}

}    // namespace SPHTM_NS
