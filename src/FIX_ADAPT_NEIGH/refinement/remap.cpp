#include "remap.h"

#include "atom.h"
#include "lammps.h"

#include <algorithm>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

// elastic energy of a row, in mass length^2/time^2
double Remap::elastic_energy(const double *row, int type) const
{
  const tm_material *m = parts.model().materials() + type;
  const int damage = cloud.column(TM_F_DAMAGE);
  return row[TM_CLOUD_MASS] * tm_stored_energy(m, row[cloud.column(TM_F_RHO)], 1.0,
                                               tm_sym_load(row + cloud.column(TM_F_STRESS)),
                                               damage >= 0 && row[damage + 1] > 0.5);
}

// angular momentum about a point near: the sums of the changes keep their digits, and a change of the momentum
// itself is counted on its own
void Remap::add_content(tm_content &c, double sign, const double *row, const double *about, int type) const
{
  const double *x = row + TM_CLOUD_X, *v = row + TM_CLOUD_V;
  tm_content_add(&c, sign, row[TM_CLOUD_MASS], tm_vec(x[0] - about[0], x[1] - about[1], x[2] - about[2]),
                 tm_vec(v[0], v[1], v[2]), elastic_energy(row, type));
}

// which columns of a field follow the gradient together (width columns each); the others are the parent's
struct Spread {
  int field, first, groups, width;
};
static const Spread SPREADS[] = {{TM_F_RHO, 0, 1, 1},       {TM_F_STRESS, 0, 1, 6},    {TM_F_PSTRAIN, 0, 3, 1},
                                 {TM_F_TEMP, 0, 1, 1},      {TM_F_ENERGY, 0, 1, 1},    {TM_F_DAMAGE, 0, 1, 1},
                                 {TM_F_THICKNESS, 0, 1, 1}, {TM_F_UNSTRAINED, 0, 1, 1}};

static const Spread BEGIN_AT_0[] = {{TM_F_HOURGLASS, TM_G_U, 1, TM_G_COLUMNS},
                                    {TM_F_CORRECTION, TM_K_RATE, 1, TM_K_COLUMNS - TM_K_RATE}};

// of the same material, torn or not as i
std::vector<int> Remap::kin(int i)
{
  const Atom *atom = parts.host()->atom;
  const int damage = cloud.column(TM_F_DAMAGE);
  std::vector<int> near;
  for (int j : cloud.neighbors(i))
    if (atom->type[j] == atom->type[i] && (damage < 0 || cloud.row(j)[damage + 1] == cloud.row(i)[damage + 1]))
      near.push_back(j);
  return near;
}

// adds to n rows, which hold the state of i, what their places (times size) from it give
void Remap::spread(int i, const double *place, int n, double size, double *rows)
{
  const std::vector<int> near = kin(i);
  const double h = cloud.size(i);
  tm_sym3 inverse;
  tm_cloud_moments(&cloud.view(), i, near.data(), (int) near.size(), h, &inverse);
  for (const Spread &f : SPREADS) {
    if (cloud.column(f.field) < 0) continue;
    for (int g = 0; g < f.groups; g++)
      tm_cloud_spread(&cloud.view(), i, near.data(), (int) near.size(), h, &inverse,
                      cloud.column(f.field) + f.first + g * f.width, f.width, place, n, size, rows);
  }
  // measured against a neighborhood that is no longer there
  for (const Spread &f : BEGIN_AT_0)
    if (cloud.column(f.field) >= 0)
      for (int k = 0; k < n; k++)
        std::fill_n(rows + (size_t) k * cloud.view().width + cloud.column(f.field) + f.first, f.width, 0.0);
}

// velocity, mass and state; where it is, the caller says
void Remap::write_row(int i, const double *row)
{
  Atom *atom = parts.host()->atom;
  std::copy_n(row + TM_CLOUD_V, 3, atom->v[i]);
  atom->rmass[i] = row[TM_CLOUD_MASS];
  const tm_state s = parts.state().host_arrays();
  for (int id = 0; id < TM_F_COUNT; id++)
    if (cloud.column(id) >= 0) std::copy_n(row + cloud.column(id), tm_field_table[id].columns, tm_field_row(&s, id, i));
}

void Remap::tally(const tm_content &change, double heat)
{
  tm_content_sum(&error, &change);
  parts.state().energy().add_remap(change.kinetic, change.elastic, heat);
}

}    // namespace SPHTM_NS
