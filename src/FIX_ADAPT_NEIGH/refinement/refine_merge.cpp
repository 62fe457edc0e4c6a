/* SPH-TM: refinement, a family back into one particle.

   Who merges is found on the rank of the child that has kept the parent's tag: it sees the others, its own or
   ghosts. A second communication tells the others, who then leave. */
#include "fix_adapt_neigh.h"
#include "fix_sph_tm.h"
#include "pair_sph_tm.h"
#include "refinement.h"

#include "atom.h"
#include "atom_vec.h"
#include "error.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

// the nearest image of every other member of the family of owned particle i, which has its parent's tag; only those
// that may merge and that are as near as neighbors
std::vector<int> Refinement::members(int i, const std::vector<int> &by_family)
{
  const Atom *atom = lmp()->atom;
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
  // sums do not depend on who is a ghost
  std::sort(found.begin(), found.end(), [&](int a, int b) { return atom->tag[a] < atom->tag[b]; });
  return found;
}

void Refinement::plan_merges()
{
  const Atom *atom = lmp()->atom;
  const int nlocal = atom->nlocal, nall = nlocal + atom->nghost, stress = cloud.column(TM_F_STRESS);
  const int width = cloud.view().width;
  std::vector<int> by_family;
  for (int i = 0; i < nall; i++)
    if (cloud.row(i)[TM_CLOUD_MARK] == FALLEN_BACK) by_family.push_back(i);
  std::sort(by_family.begin(), by_family.end(), [&](int a, int b) {
    const double *p = cloud.row(a), *q = cloud.row(b);
    if (p[TM_CLOUD_LEVEL] != q[TM_CLOUD_LEVEL]) return p[TM_CLOUD_LEVEL] < q[TM_CLOUD_LEVEL];
    if (p[TM_CLOUD_FAMILY] != q[TM_CLOUD_FAMILY]) return p[TM_CLOUD_FAMILY] < q[TM_CLOUD_FAMILY];
    return a < b;
  });
  for (int i = 0; i < nlocal; i++) {
    double *own = cloud.row(i);
    if (own[TM_CLOUD_MARK] != FALLEN_BACK || own[TM_CLOUD_FAMILY] != (double) atom->tag[i]) continue;
    const std::vector<int> others = members(i, by_family);
    if ((int) others.size() != pattern.n - 1) continue;
    std::vector<const double *> rows(1, own);
    for (int j : others) rows.push_back(cloud.row(j));
    Merge m;
    m.i = i;
    m.tag = atom->tag[i];
    std::copy_n(own + TM_CLOUD_X, 3, m.x);
    m.row.resize(width);
    m.heat = tm_cloud_merge(rows.data(), pattern.n, width, m.row.data());
    tm_cloud_volume_mean(rows.data(), pattern.n, stress, 6, m.row.data());
    m.row[cloud.column(TM_F_RHO)] = m.row[TM_CLOUD_MASS] / m.row[TM_CLOUD_VOLUME];
    double *size = m.row.data() + cloud.column(TM_F_SIZE);
    // h and target are the means; spacing and ratio, which differ from child to child, those of the one that stays
    const double *first = own + cloud.column(TM_F_SIZE);
    size[TM_S_DP] = first[TM_S_DP];
    size[TM_S_RATIO] = first[TM_S_RATIO];
    tm_size_of_parent(size, pattern.mass[0], alpha, pattern.n, pattern.dim);
    m.change = tm_content_nothing();
    const int type = atom->type[i];
    add_content(m.change, 1.0, m.row.data(), m.row.data(), type);
    for (const double *r : rows) add_content(m.change, -1.0, r, m.row.data(), type);
    merges.push_back(m);
  }
}

// tells ghosts who is split and who stays of a family; finds who leaves, and whose neighbors change
void Refinement::plan_leaving()
{
  const Atom *atom = lmp()->atom;
  const int nlocal = atom->nlocal, nall = nlocal + atom->nghost;
  const int size = cloud.column(TM_F_SIZE) + TM_S_H;
  const double support = tm_kernel_support(cloud.view().kernel);
  for (const Merge &m : merges) cloud.row(m.i)[TM_CLOUD_MARK] = STAYS;
  cloud.forward();
  std::vector<std::pair<double, int>> staying;    // family, particle
  for (int i = 0; i < nall; i++)
    if (cloud.row(i)[TM_CLOUD_MARK] == STAYS) staying.push_back({cloud.row(i)[TM_CLOUD_FAMILY], i});
  std::sort(staying.begin(), staying.end());
  for (int i = 0; i < nlocal; i++) {
    const double *own = cloud.row(i);
    if (own[TM_CLOUD_MARK] == FALLEN_BACK) {
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
      if ((r[TM_CLOUD_MARK] == SPLIT || r[TM_CLOUD_MARK] == STAYS) &&
          tm_vec_norm(tm_cloud_link(&cloud.view(), i, j, 1.0, &w)) < support * sqrt(own[size] * r[size])) {
        touched.push_back(i);
        break;
      }
    }
  }
  double mine[2] = {(double) merges.size() * (pattern.n - 1), (double) leaving.size()}, all[2];
  MPI_Allreduce(mine, all, 2, MPI_DOUBLE, MPI_SUM, lmp()->world);
  if (all[0] != all[1])
    lmp()->error->all(FLERR, "Fix adapt/neigh coarsen: {} particles were to leave, {} do: ghosts do not reach a "
                             "smoothing length; make the neighbor skin larger", all[0], all[1]);
}

void Refinement::make_merged()
{
  const Atom *atom = lmp()->atom;
  FixSPHTM &body = fix.body();
  const double ahead = body.time_ahead();
  const int temperature = cloud.column(TM_F_TEMP);
  for (Merge &m : merges) {
    double *x = atom->x[m.i];
    const double *v = atom->v[m.i];
    // the others have moved since, too: by the mean velocity
    for (int d = 0; d < 3; d++)
      x[d] += m.row[TM_CLOUD_X + d] - m.x[d] + (x[d] != m.x[d] ? ahead * (m.row[TM_CLOUD_V + d] - v[d]) : 0.0);
    if (temperature >= 0) {
      double *T = m.row.data() + temperature;
      T[0] += tm_heat_rise(fix.pair().materials() + atom->type[m.i], T[0], m.heat / m.row[TM_CLOUD_MASS]);
    }
    write_row(m.i, m.row.data());
    family_at(m.i, (int) level[m.i]) = 0.0;
    level[m.i] -= 1.0;
    tm_content_sum(&error, &m.change);
    body.book_remap(m.change.kinetic, m.change.elastic, temperature >= 0 ? m.heat : 0.0);
    fresh[m.i] = 1.0;
    fix.remade(m.i, 1.0 / alpha);
    n_merges += 1.0;
  }
}

void Refinement::remove_leaving()
{
  Atom *atom = lmp()->atom;
  std::sort(leaving.begin(), leaving.end());
  for (auto k = leaving.rbegin(); k != leaving.rend(); ++k) {
    atom->avec->copy(atom->nlocal - 1, k->first, 1);
    atom->nlocal--;
  }
}

}    // namespace SPHTM_NS
