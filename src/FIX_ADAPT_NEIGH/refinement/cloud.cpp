#include "cloud.h"

#include "atom.h"
#include "domain.h"

#include <algorithm>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

void Cloud::begin(int columns)
{
  const Atom *atom = parts.host()->atom;
  const int n = atom->nlocal;
  ParticleState &state = parts.state();
  table.width = TM_CLOUD_STATE + columns;
  table.kernel = parts.model().settings_in_use().kernel;
  table.dim = parts.host()->domain->dimension;
  rows.assign((size_t) (n + atom->nghost) * table.width, 0.0);
  table.row = rows.data();
  links = parts.rows().host_rows();
  std::fill(at, at + TM_F_COUNT, -1);
  const double *rho = state.field(TM_F_RHO);
  for (int i = 0; i < n; i++) {
    double *r = row(i);
    std::copy_n(atom->x[i], 3, r + TM_CLOUD_X);
    std::copy_n(atom->v[i], 3, r + TM_CLOUD_V);
    r[TM_CLOUD_MASS] = atom->rmass_flag ? atom->rmass[i] : atom->mass[atom->type[i]];
    r[TM_CLOUD_VOLUME] = r[TM_CLOUD_MASS] / rho[i];
  }
}

void Cloud::take_state()
{
  ParticleState &state = parts.state();
  int columns = 0;
  for (int id = 0; id < TM_F_COUNT; id++)
    if (state.field(id)) columns += tm_field_table[id].columns;
  begin(columns);
  columns = TM_CLOUD_STATE;
  for (int id = 0; id < TM_F_COUNT; id++) {
    const double *from = state.field(id);
    if (!from) continue;
    at[id] = columns;
    const int width = tm_field_table[id].columns;
    for (int i = 0; i < parts.owned(); i++) std::copy_n(from + (size_t) i * width, width, row(i) + columns);
    columns += width;
  }
}

void Cloud::take_values(const std::vector<double> &values)
{
  begin(1);
  for (int i = 0; i < parts.host()->atom->nlocal; i++) row(i)[TM_CLOUD_STATE] = values[i];
}

void Cloud::forward() { parts.forward(rows.data(), table.width); }

double Cloud::size(int i) const { return parts.state().field(TM_F_SIZE)[(size_t) i * TM_S_COLUMNS + TM_S_H]; }

const std::vector<int> &Cloud::neighbors(int i)
{
  near.resize(links.mechanical[i]);
  for (int k = 0; k < links.mechanical[i]; k++) near[k] = links.index[links.first[i] + k * links.stride];
  return near;
}

int Cloud::count_within_support(int i)
{
  int count = 0;
  const double reach = tm_kernel_support(table.kernel) * size(i);
  for (int j : neighbors(i)) {
    tm_real w;
    count += tm_vec_norm(tm_cloud_link(&table, i, j, 1.0, &w)) < reach;
  }
  return count;
}

}    // namespace SPHTM_NS
