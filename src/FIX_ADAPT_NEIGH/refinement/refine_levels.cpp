#include "refine_levels.h"

#include "atom.h"
#include "lammps.h"

#include <algorithm>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

void RefineLevels::grow(int nmax)
{
  level_of.resize(nmax, 0.0);
  fresh.resize(nmax, 0.0);
  family_of.resize((size_t) nmax * in.most_level, 0.0);
}

void RefineLevels::copy(int from, int to)
{
  level_of[to] = level_of[from];
  fresh[to] = fresh[from];
  for (int k = 1; k <= in.most_level; k++) family_of[at(to, k)] = family_of[at(from, k)];
}

void RefineLevels::set_new(int i)
{
  level_of[i] = fresh[i] = 0.0;
  for (int k = 1; k <= in.most_level; k++) family_of[at(i, k)] = 0.0;
}

int RefineLevels::pack(int i, double *buf)
{
  *buf++ = level_of[i];
  *buf++ = fresh[i];
  for (int k = 1; k <= in.most_level; k++) *buf++ = family_of[at(i, k)];
  return 2 + in.most_level;
}

int RefineLevels::unpack(int i, const double *buf)
{
  level_of[i] = *buf++;
  fresh[i] = *buf++;
  for (int k = 1; k <= in.most_level; k++) family_of[at(i, k)] = *buf++;
  return 2 + in.most_level;
}

// level, fresh or not, families
int RefineLevels::check(const double *row, int n, std::string &why) const
{
  if (n < 2 + in.most_level) why = fmt::format("{} values for refinement, {} expected", n, 2 + in.most_level);
  else if (!is_whole(row[0], 0, in.most_level)) why = fmt::format("level {}, 0 to {} expected", row[0], in.most_level);
  else if (!is_whole(row[1], 0, 1)) why = fmt::format("a mark of refinement {}, 0 or 1 expected", row[1]);
  for (int k = 1; why.empty() && k <= in.most_level; k++)
    if (!is_whole(row[1 + k], 0, MAXTAGINT)) why = fmt::format("family {} at level {}", row[1 + k], k);
  return why.empty() ? 2 + in.most_level : -1;
}

void RefineLevels::split(int parent, double family)
{
  level_of[parent] += 1.0;
  family_of[at(parent, (int) level_of[parent])] = family;
}

void RefineLevels::merged(int i)
{
  family_of[at(i, (int) level_of[i])] = 0.0;
  level_of[i] -= 1.0;
}

bool RefineLevels::any() const
{
  int mine = std::any_of(level_of.begin(), level_of.begin() + parts.owned(), [](double l) { return l > 0.0; }), some;
  MPI_Allreduce(&mine, &some, 1, MPI_INT, MPI_MAX, parts.host()->world);
  return some;
}

void RefineLevels::forget_families() { std::fill(family_of.begin(), family_of.end(), 0.0); }

}    // namespace SPHTM_NS
