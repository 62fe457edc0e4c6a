#include "drive_turn.h"

#include "nearest_image.h"

#include "atom.h"
#include "domain.h"
#include "error.h"
#include "lammps.h"
#include "utils.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

void DriveTurn::set(LAMMPS *host, const std::string &who, int words, char **word, const bool *given)
{
  lmp = host;
  if (words != 7)
    lmp->error->all(
        FLERR, "{} rotate must read: rotate Px Py Pz Rx Ry Rz omega, with omega a number or v_name; got {} value{}",
        who, words, words == 1 ? "" : "s");
  double n[6];
  for (int k = 0; k < 6; k++) n[k] = utils::numeric(FLERR, word[k], false, lmp);
  const double length = sqrt(n[3] * n[3] + n[4] * n[4] + n[5] * n[5]);
  if (!(length > 0.0))
    lmp->error->all(FLERR, "{} rotate: the axis {} {} {} has no direction", who, word[3], word[4], word[5]);
  to.turns = 1;
  to.point = tm_vec(n[0], n[1], n[2]);
  to.axis = tm_vec(n[3] / length, n[4] / length, n[5] / length);
  if (lmp->domain->dimension == 2 && (n[3] != 0.0 || n[4] != 0.0))
    lmp->error->all(FLERR, "{} rotate: in 2d the axis is z, got {} {} {}", who, word[3], word[4], word[5]);
  const double along[3] = {to.axis.x, to.axis.y, to.axis.z};
  for (int k = 0; k < lmp->domain->dimension; k++)
    if (!given[k] && fabs(along[k]) < 1.0 - 1e-12)
      lmp->error->all(
          FLERR,
          "{}: v{} is NULL, but rotate about {} {} {} turns the group across {}; only the direction of the axis can be free",
          who, "xyz"[k], word[3], word[4], word[5], "xyz"[k]);
  if (lmp->domain->triclinic) lmp->error->all(FLERR, "{} rotate: the box must not be tilted", who);
  rate.set(lmp, who + " rotate omega", word[6]);
}

double DriveTurn::radius(int groupbit) const
{
  double mine = 0.0, all = 0.0;
  const double from[3] = {to.point.x + path[0], to.point.y + path[1], to.point.z + path[2]};
  const Atom &atom = *lmp->atom;
  for (int i = 0; i < atom.nlocal; i++) {
    if (!(atom.mask[i] & groupbit)) continue;
    double d[3];
    for (int k = 0; k < 3; k++) d[k] = atom.x[i][k] - from[k];
    to_nearest_image(*lmp->domain, d);
    mine = std::max(mine, tm_vec_norm(tm_vec_cross(to.axis, tm_vec(d[0], d[1], d[2]))));
  }
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_MAX, lmp->world);
  return all;
}

tm_drive_turn DriveTurn::at_start() const
{
  tm_drive_turn t = to;
  if (!turns()) return t;
  t.point = tm_vec_add(to.point, tm_vec(path[0], path[1], path[2]));
  t.rate = 0.0;
  for (int k = 0; k < 3; k++) t.period[k] = lmp->domain->periodicity[k] ? lmp->domain->prd[k] : 0.0;
  return t;
}

// by the trapezoidal rule, as positions are
tm_drive_turn DriveTurn::step(double dt, const double *velocity, double omega)
{
  if (!turns()) return to;
  for (int k = 0; k < 3; k++) path[k] += 0.5 * dt * (last[k] + velocity[k]);
  turned += 0.5 * dt * (last[3] + omega);
  std::copy_n(velocity, 3, last);
  last[3] = omega;
  tm_drive_turn t = at_start();
  t.rate = omega;
  return t;
}

void DriveTurn::append_to(std::vector<double> &values) const
{
  values.push_back(turned);
  values.insert(values.end(), path, path + 3);
  values.insert(values.end(), last, last + 4);
}

void DriveTurn::take_from(const double *values)
{
  turned = values[0];
  std::copy_n(values + 1, 3, path);
  std::copy_n(values + 4, 4, last);
}

}    // namespace SPHTM_NS
