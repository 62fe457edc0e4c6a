#include "refine_split.h"

#include "all_ranks.h"
#include "contact_probe.h"
#include "tm_split_place.h"

#include "atom.h"
#include "atom_vec.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "lammps.h"
#include "modify.h"
#include "update.h"
#include "utils.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

void RefineSplit::restore(double next, int reported_levels)
{
  next_tag = next;
  levels_reported = reported_levels;
}

void RefineSplit::restore_counts(double splits_made, double outside)
{
  n_splits = splits_made;
  n_outside = outside;
}

// about particle i, in its h: those of the pattern; next to tools so that no child reaches farther than i does
std::vector<double> RefineSplit::places(int i)
{
  const int n = in.pattern.n;
  std::vector<double> place(&in.pattern.x[0][0], &in.pattern.x[0][0] + 3 * n), radius(n);
  const double h = cloud.size(i), reach = 0.5 * cloud.row(i)[cloud.column(TM_F_SIZE) + TM_S_DP] / h;
  double farthest = reach;
  for (int k = 0; k < n; k++) {
    radius[k] = reach * pow(in.pattern.mass[k], 1.0 / in.pattern.dim);
    farthest = std::max(farthest, radius[k] + tm_vec_norm(tm_split_place(place.data(), k)));
  }
  // the surface of the nearest tool is where the layer of the parent has it, and those of the children have the same strain
  tm_real layer = 1.0, slope;
  const int of_layer = cloud.column(TM_F_LAYER);
  if (of_layer >= 0 && cloud.row(i)[of_layer + TM_L_NEAR] > 0.0)
    layer = tm_layer_stretch(cloud.row(i)[of_layer + TM_L_STRAIN], &slope);
  std::vector<ContactProbe::Surface> surface;
  for (ContactProbe *tool : parts.scene().contact_probes()) tool->touched(i, h * farthest, surface);
  std::sort(surface.begin(), surface.end(), [](const auto &a, const auto &b) { return a.distance < b.distance; });
  for (size_t s = 0; s < surface.size(); s++) {
    const tm_vec3 normal = surface[s].normal;
    if (s == 0) tm_split_turn(place.data(), n, normal);
    std::vector<double> out(radius);
    for (double &r : out) r *= s == 0 ? layer : 1.0;
    const double factor = tm_split_factor(place.data(), out.data(), n, normal, s == 0 ? reach * layer : reach);
    // the nearest surface keeps its distance from the outermost children; others are not to be reached by more
    if (s == 0 || factor < 1.0) tm_split_scale(place.data(), n, normal, factor);
  }
  return place;
}

void RefineSplit::plan(int i)
{
  const Atom *atom = parts.host()->atom;
  const int n = in.pattern.n, type = atom->type[i];
  const tm_cloud &table = cloud.view();
  const double *parent = cloud.row(i), h = cloud.size(i);
  Split s;
  s.i = i;
  s.tag = atom->tag[i];
  s.place = places(i);
  s.change = tm_content_nothing();
  for (int k = 0; k < n; k++) s.children.insert(s.children.end(), parent, parent + table.width);
  remap.spread(i, s.place.data(), n, h, s.children.data());
  const std::vector<int> near = remap.kin(i);
  tm_sym3 inverse;
  tm_cloud_moments(&table, i, near.data(), (int) near.size(), h, &inverse);
  tm_slope velocity[3];
  for (int d = 0; in.linear && d < 3; d++)
    velocity[d] = tm_cloud_slope(&table, i, near.data(), (int) near.size(), h, &inverse, TM_CLOUD_V + d);
  for (int k = 0; k < n; k++) {
    double *r = s.children.data() + (size_t) k * table.width;
    const tm_vec3 at = tm_vec_scale(h, tm_split_place(s.place.data(), k));
    r[TM_CLOUD_X] += at.x;
    r[TM_CLOUD_X + 1] += at.y;
    r[TM_CLOUD_X + 2] += at.z;
    for (int d = 0; in.linear && d < 3; d++) r[TM_CLOUD_V + d] += tm_vec_dot(velocity[d].gradient, at);
    r[TM_CLOUD_MASS] *= in.pattern.mass[k];
    tm_size_of_child(r + cloud.column(TM_F_SIZE), in.pattern.mass[k], in.alpha, n, in.pattern.dim);
    r[TM_CLOUD_VOLUME] = r[TM_CLOUD_MASS] / r[cloud.column(TM_F_RHO)];
    remap.add_content(s.change, 1.0, r, parent, type);
  }
  remap.add_content(s.change, -1.0, parent, parent, type);
  splits.push_back(s);
}

// the children's own limits hold from the step in which they are made
void RefineSplit::foresee_time_step()
{
  double mine = 1e300, limit;
  for (const Split &s : splits)
    mine = std::min(mine, parts.state().time_step().of_size(s.i, in.alpha * cloud.size(s.i)));
  MPI_Allreduce(&mine, &limit, 1, MPI_DOUBLE, MPI_MIN, parts.host()->world);
  parts.state().time_step().lower_next(limit);
}

// a child beyond a fixed boundary would be deleted: the particle stays as it is
bool RefineSplit::inside_box(const Split &s) const
{
  enum { FIXED = 1 };    // of Domain
  const Domain *domain = parts.host()->domain;
  if (domain->triclinic) return true;
  const double *x = parts.host()->atom->x[s.i];
  for (int k = 0; k < in.pattern.n; k++)
    for (int d = 0; d < parts.host()->domain->dimension; d++) {
      const double at = x[d] + cloud.size(s.i) * s.place[3 * k + d];
      if (domain->boundary[d][0] == FIXED && at < domain->boxlo[d]) return false;
      if (domain->boundary[d][1] == FIXED && at > domain->boxhi[d]) return false;
    }
  return true;
}

void RefineSplit::drop_outside()
{
  const size_t before = splits.size();
  const auto outside = [&](const Split &s) { return !inside_box(s); };
  splits.erase(std::remove_if(splits.begin(), splits.end(), outside), splits.end());
  n_outside += (double) (before - splits.size());
}

// The first tag of the new children of every split of this rank. A child takes the parent's tag; the others get
// tags above all others in order of the parents' tags, which does not depend on the ranks.
std::vector<tagint> RefineSplit::new_tags()
{
  LAMMPS *lmp = parts.host();
  const Atom *atom = lmp->atom;
  tagint mine = 0, most = 0;
  for (int i = 0; i < atom->nlocal; i++) mine = std::max(mine, atom->tag[i]);
  MPI_Allreduce(&mine, &most, 1, MPI_LMP_TAGINT, MPI_MAX, lmp->world);
  next_tag = std::max(next_tag, (double) most + 1.0);

  std::vector<tagint> tags, first;
  for (const Split &s : splits) tags.push_back(s.tag);
  std::vector<tagint> all = of_all_ranks(tags, lmp->world);
  std::sort(all.begin(), all.end());
  const int extra = in.pattern.n - 1;
  if (next_tag + (double) all.size() * extra >= (double) MAXTAGINT)
    lmp->error->all(FLERR, "Fix adapt/neigh refine: the IDs of new particles pass {}; use reset_atoms id between runs",
                    MAXTAGINT);
  for (tagint t : tags)
    first.push_back((tagint) next_tag + (tagint) (std::lower_bound(all.begin(), all.end(), t) - all.begin()) * extra);
  next_tag += (double) all.size() * extra;
  return first;
}

void RefineSplit::make()
{
  LAMMPS *lmp = parts.host();
  Atom *atom = lmp->atom;
  const std::vector<tagint> tags = new_tags();
  while (atom->nmax < atom->nlocal + (int) splits.size() * (in.pattern.n - 1)) atom->avec->grow(0);
  parts.state().atoms().to_host();    // growing may have been done where the loops run
  for (size_t m = 0; m < splits.size(); m++) {
    const Split &s = splits[m];
    const int parent = s.i, width = cloud.view().width;
    const double h = cloud.size(parent), x[3] = {atom->x[parent][0], atom->x[parent][1], atom->x[parent][2]};
    levels.split(parent, (double) s.tag);
    for (int k = 0; k < in.pattern.n; k++) {
      int i = parent;
      if (k) {
        i = atom->nlocal;
        double at[3] = {x[0], x[1], x[2]};
        atom->avec->create_atom(atom->type[parent], at);
        lmp->modify->create_attribute(i);
        atom->avec->copy(parent, i, 0);    // groups, image, and what all fixes keep of the parent
        atom->tag[i] = tags[m] + k - 1;
      }
      remap.write_row(i, s.children.data() + (size_t) k * width);
      for (int d = 0; d < 3; d++) atom->x[i][d] = x[d] + h * s.place[3 * k + d];
      levels.set_fresh(i, true);
    }
    remap.tally(s.change, 0.0);
    n_splits += 1.0;
  }
}

// the first split to a level: what it does to the time step
void RefineSplit::report_levels()
{
  double mine[2] = {0.0, -1e300}, all[2];
  for (const Split &s : splits) {
    mine[0] = std::max(mine[0], levels.level(s.i) + 1.0);
    mine[1] = std::max(mine[1], -in.alpha * cloud.size(s.i));
  }
  MPI_Allreduce(mine, all, 2, MPI_DOUBLE, MPI_MAX, parts.host()->world);
  const double before = parts.state().sizes().smallest_h, after = std::min(before, -all[1]);
  if ((int) all[0] <= levels_reported) return;
  levels_reported = (int) all[0];
  if (parts.host()->comm->me == 0)
    utils::logmesg(parts.host(),
                   "adapt/neigh: first split to level {} at step {}: smallest h from {:.6g} to {:.6g}; "
                   "where sound limits the time step, {:.3g} times as many steps for the same time\n",
                   levels_reported, parts.host()->update->ntimestep, before, after, before / after);
}

}    // namespace SPHTM_NS
