#include "refine_merge.h"

#include "atom.h"
#include "atom_vec.h"
#include "error.h"
#include "lammps.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

void RefineMerge::clear()
{
  merges.clear();
  leaving.clear();
}

// the nearest image of every other member of the family of owned particle i, which has its parent's tag; only those
// that may merge and that are as near as neighbors
std::vector<int> RefineMerge::members(int i, const std::vector<int> &by_family)
{
  const Atom *atom = parts.host()->atom;
  const double *own = cloud.row(i), reach = tm_kernel_support(cloud.view().kernel) * cloud.size(i);
  const int damage = cloud.column(TM_F_DAMAGE);
  auto before = [&](int j, const double *r) {
    const double *q = cloud.row(j);
    return q[TM_CLOUD_LEVEL] != r[TM_CLOUD_LEVEL] ? q[TM_CLOUD_LEVEL] < r[TM_CLOUD_LEVEL]
                                                  : q[TM_CLOUD_FAMILY] < r[TM_CLOUD_FAMILY];
  };
  auto k = std::lower_bound(by_family.begin(), by_family.end(), own, before);
  std::vector<int> found;
  std::vector<double> away;
  for (; k != by_family.end(); ++k) {
    const double *r = cloud.row(*k);
    if (r[TM_CLOUD_LEVEL] != own[TM_CLOUD_LEVEL] || r[TM_CLOUD_FAMILY] != own[TM_CLOUD_FAMILY]) break;
    tm_real w;
    const double d = tm_vec_norm(tm_cloud_link(&cloud.view(), i, *k, 1.0, &w));
    if (atom->tag[*k] == atom->tag[i] || d >= reach || atom->type[*k] != atom->type[i]) continue;
    if (damage >= 0 && r[damage + 1] != own[damage + 1]) continue;
    size_t m = 0;
    while (m < found.size() && atom->tag[found[m]] != atom->tag[*k]) m++;
    if (m == found.size()) {
      found.push_back(*k);
      away.push_back(d);
    } else if (d < away[m]) {
      found[m] = *k;
      away[m] = d;
    }
  }
  // sums do not depend on which of them are ghosts
  std::sort(found.begin(), found.end(), [&](int a, int b) { return atom->tag[a] < atom->tag[b]; });
  return found;
}

void RefineMerge::plan()
{
  const Atom *atom = parts.host()->atom;
  const int nlocal = atom->nlocal, nall = nlocal + atom->nghost, stress = cloud.column(TM_F_STRESS);
  const int width = cloud.view().width;
  std::vector<int> by_family;
  for (int i = 0; i < nall; i++)
    if (cloud.row(i)[TM_CLOUD_MARK] == (double) REFINE_BACK) by_family.push_back(i);
  std::sort(by_family.begin(), by_family.end(), [&](int a, int b) {
    const double *p = cloud.row(a), *q = cloud.row(b);
    if (p[TM_CLOUD_LEVEL] != q[TM_CLOUD_LEVEL]) return p[TM_CLOUD_LEVEL] < q[TM_CLOUD_LEVEL];
    if (p[TM_CLOUD_FAMILY] != q[TM_CLOUD_FAMILY]) return p[TM_CLOUD_FAMILY] < q[TM_CLOUD_FAMILY];
    return a < b;
  });
  for (int i = 0; i < nlocal; i++) {
    double *own = cloud.row(i);
    if (own[TM_CLOUD_MARK] != (double) REFINE_BACK || own[TM_CLOUD_FAMILY] != (double) atom->tag[i]) continue;
    const std::vector<int> others = members(i, by_family);
    if ((int) others.size() != in.pattern.n - 1) continue;
    std::vector<const double *> rows(1, own);
    for (int j : others) rows.push_back(cloud.row(j));
    Merge m;
    m.i = i;
    std::copy_n(own + TM_CLOUD_X, 3, m.x);
    m.row.resize(width);
    m.heat = tm_cloud_merge(rows.data(), in.pattern.n, width, m.row.data());
    tm_cloud_volume_mean(rows.data(), in.pattern.n, stress, 6, m.row.data());
    m.row[cloud.column(TM_F_RHO)] = m.row[TM_CLOUD_MASS] / m.row[TM_CLOUD_VOLUME];
    double *size = m.row.data() + cloud.column(TM_F_SIZE);
    // h and target are the means; spacing and ratio, which differ from child to child, those of the one that stays
    const double *first = own + cloud.column(TM_F_SIZE);
    size[TM_S_DP] = first[TM_S_DP];
    size[TM_S_RATIO] = first[TM_S_RATIO];
    tm_size_of_parent(size, in.pattern.mass[0], in.alpha, in.pattern.n, in.pattern.dim);
    m.change = tm_content_nothing();
    const int type = atom->type[i];
    remap.add_content(m.change, 1.0, m.row.data(), m.row.data(), type);
    for (const double *r : rows) remap.add_content(m.change, -1.0, r, m.row.data(), type);
    merges.push_back(m);
  }
}

// tells ghosts which particles are split and which stays of a family; finds those that leave, and those whose neighbors
// change
std::vector<int> RefineMerge::plan_leaving()
{
  const Atom *atom = parts.host()->atom;
  const int nlocal = atom->nlocal, nall = nlocal + atom->nghost;
  std::vector<int> touched;
  const int size = cloud.column(TM_F_SIZE) + TM_S_H;
  const double support = tm_kernel_support(cloud.view().kernel);
  for (const Merge &m : merges) cloud.row(m.i)[TM_CLOUD_MARK] = REFINE_STAYS;
  cloud.forward();
  std::vector<std::pair<double, int>> staying;    // family, particle
  for (int i = 0; i < nall; i++)
    if (cloud.row(i)[TM_CLOUD_MARK] == (double) REFINE_STAYS) staying.push_back({cloud.row(i)[TM_CLOUD_FAMILY], i});
  std::sort(staying.begin(), staying.end());
  for (int i = 0; i < nlocal; i++) {
    const double *own = cloud.row(i);
    if (own[TM_CLOUD_MARK] == (double) REFINE_BACK) {
      auto k = std::lower_bound(staying.begin(), staying.end(), std::make_pair(own[TM_CLOUD_FAMILY], -1));
      for (; k != staying.end() && k->first == own[TM_CLOUD_FAMILY]; ++k)
        if (cloud.row(k->second)[TM_CLOUD_LEVEL] == own[TM_CLOUD_LEVEL]) {
          leaving.push_back({i, atom->tag[i]});
          break;
        }
    }
    for (int j : cloud.neighbors(i)) {
      const double *r = cloud.row(j);
      tm_real w;
      // within reach: not by the list, whose skin depends on when it was made
      if ((r[TM_CLOUD_MARK] == (double) REFINE_SPLIT || r[TM_CLOUD_MARK] == (double) REFINE_STAYS) &&
          tm_vec_norm(tm_cloud_link(&cloud.view(), i, j, 1.0, &w)) < support * sqrt(own[size] * r[size])) {
        touched.push_back(i);
        break;
      }
    }
  }
  double mine[2] = {(double) merges.size() * (in.pattern.n - 1), (double) leaving.size()}, all[2];
  MPI_Allreduce(mine, all, 2, MPI_DOUBLE, MPI_SUM, parts.host()->world);
  if (all[0] != all[1])
    parts.host()->error->all(FLERR,
                             "Fix adapt/neigh coarsen: {} particles were to leave, {} do: ghosts do not reach a "
                             "smoothing length; make the neighbor skin larger",
                             all[0], all[1]);
  return touched;
}

void RefineMerge::make()
{
  const Atom *atom = parts.host()->atom;
  const double ahead = parts.state().time_step().ahead();
  const int temperature = cloud.column(TM_F_TEMP), energy = cloud.column(TM_F_ENERGY);
  for (Merge &m : merges) {
    double *x = atom->x[m.i];
    const double *v = atom->v[m.i];
    // the others have moved since, too: by the mean velocity
    for (int d = 0; d < 3; d++)
      x[d] += m.row[TM_CLOUD_X + d] - m.x[d] + (x[d] != m.x[d] ? ahead * (m.row[TM_CLOUD_V + d] - v[d]) : 0.0);
    if (temperature >= 0) {
      double *T = m.row.data() + temperature;
      T[0] += tm_heat_rise(parts.model().materials() + atom->type[m.i], T[0], m.heat / m.row[TM_CLOUD_MASS]);
      if (energy >= 0) m.row[energy] += m.heat / m.row[TM_CLOUD_MASS];
    }
    remap.write_row(m.i, m.row.data());
    levels.merged(m.i);
    remap.tally(m.change, temperature >= 0 ? m.heat : 0.0);
    levels.set_fresh(m.i, true);
    n_merges += 1.0;
  }
}

void RefineMerge::remove_leaving()
{
  Atom *atom = parts.host()->atom;
  std::sort(leaving.begin(), leaving.end());
  for (auto k = leaving.rbegin(); k != leaving.rend(); ++k) {
    atom->avec->copy(atom->nlocal - 1, k->first, 1);
    atom->nlocal--;
  }
}

}    // namespace SPHTM_NS
