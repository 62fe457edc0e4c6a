/* SPH-TM: refinement, one particle into several. */
#include "all_ranks.h"
#include "fix_adapt_neigh.h"
#include "fix_sph_tm.h"
#include "pair_sph_tm.h"
#include "refinement.h"
#include "tm_split_place.h"

#include "atom.h"
#include "atom_vec.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "modify.h"
#include "update.h"
#include "utils.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

// elastic energy of a row, in mass length^2/time^2
double Refinement::elastic_energy(const double *row, int type) const
{
  const tm_material *m = fix.pair().materials() + type;
  const int stress = cloud.column(TM_F_STRESS), energy = cloud.column(TM_F_ENERGY);
  const tm_sym3 s = tm_sym_load(row + stress);
  const double p = tm_eos_pressure(m, row[cloud.column(TM_F_RHO)], energy < 0 ? 0.0 : row[energy]);
  return row[TM_CLOUD_VOLUME] * (tm_sym_ddot(s, s) / (4.0 * m->shear) + p * p / (2.0 * m->bulk));
}

// angular momentum about a point near: the sums of the changes keep their digits, and a change of the momentum
// itself is counted on its own
void Refinement::add_content(tm_content &c, double sign, const double *row, const double *about, int type) const
{
  const double *x = row + TM_CLOUD_X, *v = row + TM_CLOUD_V;
  tm_content_add(&c, sign, row[TM_CLOUD_MASS], tm_vec(x[0] - about[0], x[1] - about[1], x[2] - about[2]),
                 tm_vec(v[0], v[1], v[2]), elastic_energy(row, type));
}

// which columns of a field follow the gradient together (width columns each); the others are the parent's
struct Spread {
  int field, first, groups, width;
};
static const Spread SPREADS[] = {{TM_F_RHO, 0, 1, 1},  {TM_F_STRESS, 0, 1, 6}, {TM_F_PSTRAIN, 0, 3, 1},
                                 {TM_F_TEMP, 0, 1, 1}, {TM_F_ENERGY, 0, 1, 1}, {TM_F_DAMAGE, 0, 1, 1},
                                 {TM_F_THICKNESS, 0, 1, 1}};

// of the same material, torn or not as i
std::vector<int> Refinement::kin(int i)
{
  const Atom *atom = lmp()->atom;
  const int damage = cloud.column(TM_F_DAMAGE);
  std::vector<int> near;
  for (int j : cloud.neighbors(i))
    if (atom->type[j] == atom->type[i] && (damage < 0 || cloud.row(j)[damage + 1] == cloud.row(i)[damage + 1]))
      near.push_back(j);
  return near;
}

// adds to n rows, which hold the state of i, what their places (times size) from it give
void Refinement::spread(int i, const double *place, int n, double size, double *rows)
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
}

// about particle i, in its h: those of the pattern; next to tools so that no child reaches farther than i does
std::vector<double> Refinement::places(int i)
{
  const int n = pattern.n;
  std::vector<double> place(&pattern.x[0][0], &pattern.x[0][0] + 3 * n), radius(n);
  const double h = cloud.size(i), reach = 0.5 * cloud.row(i)[cloud.column(TM_F_SIZE) + TM_S_DP] / h;
  double farthest = reach;
  for (int k = 0; k < n; k++) {
    radius[k] = reach * pow(pattern.mass[k], 1.0 / pattern.dim);
    farthest = std::max(farthest, radius[k] + tm_vec_norm(tm_split_place(place.data(), k)));
  }
  std::vector<ContactProbe::Surface> surface;
  for (ContactProbe *tool : tools) tool->touched(i, h * farthest, surface);
  std::sort(surface.begin(), surface.end(), [](const auto &a, const auto &b) { return a.distance < b.distance; });
  for (size_t s = 0; s < surface.size(); s++) {
    const tm_vec3 normal = surface[s].normal;
    if (s == 0) tm_split_turn(place.data(), n, normal);
    const double factor = tm_split_factor(place.data(), radius.data(), n, normal, reach);
    // the nearest surface keeps its distance from the outermost children; others are not to be reached by more
    if (s == 0 || factor < 1.0) tm_split_scale(place.data(), n, normal, factor);
  }
  return place;
}

void Refinement::plan_split(int i)
{
  const Atom *atom = lmp()->atom;
  const int n = pattern.n, type = atom->type[i];
  const tm_cloud &table = cloud.view();
  const double *parent = cloud.row(i), h = cloud.size(i);
  Split s;
  s.i = i;
  s.tag = atom->tag[i];
  s.place = places(i);
  s.change = tm_content_nothing();
  for (int k = 0; k < n; k++) s.children.insert(s.children.end(), parent, parent + table.width);
  spread(i, s.place.data(), n, h, s.children.data());
  const std::vector<int> near = kin(i);
  tm_sym3 inverse;
  tm_cloud_moments(&table, i, near.data(), (int) near.size(), h, &inverse);
  tm_slope velocity[3];
  for (int d = 0; linear && d < 3; d++)
    velocity[d] = tm_cloud_slope(&table, i, near.data(), (int) near.size(), h, &inverse, TM_CLOUD_V + d);
  for (int k = 0; k < n; k++) {
    double *r = s.children.data() + (size_t) k * table.width;
    const tm_vec3 at = tm_vec_scale(h, tm_split_place(s.place.data(), k));
    r[TM_CLOUD_X] += at.x;
    r[TM_CLOUD_X + 1] += at.y;
    r[TM_CLOUD_X + 2] += at.z;
    for (int d = 0; linear && d < 3; d++) r[TM_CLOUD_V + d] += tm_vec_dot(velocity[d].gradient, at);
    r[TM_CLOUD_MASS] *= pattern.mass[k];
    tm_size_of_child(r + cloud.column(TM_F_SIZE), pattern.mass[k], alpha, n, pattern.dim);
    r[TM_CLOUD_VOLUME] = r[TM_CLOUD_MASS] / r[cloud.column(TM_F_RHO)];
    add_content(s.change, 1.0, r, parent, type);
  }
  add_content(s.change, -1.0, parent, parent, type);
  splits.push_back(s);
}

// the children's own limits hold from the step in which they are made
void Refinement::foresee_time_step()
{
  double mine = 1e300, limit;
  for (const Split &s : splits) mine = std::min(mine, fix.body().dt_of_size(s.i, alpha * cloud.size(s.i)));
  MPI_Allreduce(&mine, &limit, 1, MPI_DOUBLE, MPI_MIN, lmp()->world);
  fix.body().lower_next_dt(limit);
}

// a child beyond a fixed boundary would be deleted: the particle stays as it is
bool Refinement::inside_box(const Split &s) const
{
  enum { FIXED = 1 };    // of Domain
  const Domain *domain = lmp()->domain;
  if (domain->triclinic) return true;
  const double *x = lmp()->atom->x[s.i];
  for (int k = 0; k < pattern.n; k++)
    for (int d = 0; d < lmp()->domain->dimension; d++) {
      const double at = x[d] + cloud.size(s.i) * s.place[3 * k + d];
      if (domain->boundary[d][0] == FIXED && at < domain->boxlo[d]) return false;
      if (domain->boundary[d][1] == FIXED && at > domain->boxhi[d]) return false;
    }
  return true;
}

void Refinement::drop_outside()
{
  const size_t before = splits.size();
  const auto outside = [&](const Split &s) { return !inside_box(s); };
  splits.erase(std::remove_if(splits.begin(), splits.end(), outside), splits.end());
  n_outside += (double) (before - splits.size());
}

// The first tag of the new children of every split of this rank. A child takes the parent's tag; the others get
// tags above all others in order of the parents' tags, which does not depend on the ranks.
std::vector<tagint> Refinement::new_tags()
{
  LAMMPS *lmp = this->lmp();
  const Atom *atom = lmp->atom;
  tagint mine = 0, most = 0;
  for (int i = 0; i < atom->nlocal; i++) mine = std::max(mine, atom->tag[i]);
  MPI_Allreduce(&mine, &most, 1, MPI_LMP_TAGINT, MPI_MAX, lmp->world);
  next_tag = std::max(next_tag, (double) most + 1.0);

  std::vector<tagint> tags, first;
  for (const Split &s : splits) tags.push_back(s.tag);
  std::vector<tagint> all = of_all_ranks(tags, lmp->world);
  std::sort(all.begin(), all.end());
  const int extra = pattern.n - 1;
  if (next_tag + (double) all.size() * extra >= (double) MAXTAGINT)
    lmp->error->all(FLERR, "Fix adapt/neigh refine: the IDs of new particles pass {}; use reset_atoms id between runs",
                    MAXTAGINT);
  for (tagint t : tags)
    first.push_back((tagint) next_tag + (tagint) (std::lower_bound(all.begin(), all.end(), t) - all.begin()) * extra);
  next_tag += (double) all.size() * extra;
  return first;
}

void Refinement::make_children()
{
  LAMMPS *lmp = this->lmp();
  Atom *atom = lmp->atom;
  const std::vector<tagint> tags = new_tags();
  while (atom->nmax < atom->nlocal + (int) splits.size() * (pattern.n - 1)) atom->avec->grow(0);
  fix.body().host_particles();    // growing may have been done where the loops run
  for (size_t m = 0; m < splits.size(); m++) {
    const Split &s = splits[m];
    const int parent = s.i, width = cloud.view().width;
    const double h = cloud.size(parent), x[3] = {atom->x[parent][0], atom->x[parent][1], atom->x[parent][2]};
    const int of_level = (int) level[parent] + 1;
    level[parent] = of_level;
    family_at(parent, of_level) = (double) s.tag;
    for (int k = 0; k < pattern.n; k++) {
      int i = parent;
      if (k) {
        i = atom->nlocal;
        double at[3] = {x[0], x[1], x[2]};
        atom->avec->create_atom(atom->type[parent], at);
        lmp->modify->create_attribute(i);
        atom->avec->copy(parent, i, 0);    // groups, image, and what all fixes keep of the parent
        atom->tag[i] = tags[m] + k - 1;
      }
      write_row(i, s.children.data() + (size_t) k * width);
      for (int d = 0; d < 3; d++) atom->x[i][d] = x[d] + h * s.place[3 * k + d];
      fresh[i] = 1.0;
      fix.remade(i, pattern.alpha);
    }
    tm_content_sum(&error, &s.change);
    fix.body().book_remap(s.change.kinetic, s.change.elastic, 0.0);
    n_splits += 1.0;
  }
}

// velocity, mass and state; where it is, the caller says
void Refinement::write_row(int i, const double *row)
{
  Atom *atom = lmp()->atom;
  std::copy_n(row + TM_CLOUD_V, 3, atom->v[i]);
  atom->rmass[i] = row[TM_CLOUD_MASS];
  const tm_state s = fix.body().host_state();
  for (int id = 0; id < TM_F_COUNT; id++)
    if (cloud.column(id) >= 0) std::copy_n(row + cloud.column(id), tm_field_table[id].columns, tm_field_row(&s, id, i));
}

// the first split to a level: what it does to the time step
void Refinement::report_levels()
{
  double mine[2] = {0.0, -1e300}, all[2];
  for (const Split &s : splits) {
    mine[0] = std::max(mine[0], level[s.i] + 1.0);
    mine[1] = std::max(mine[1], -alpha * cloud.size(s.i));
  }
  MPI_Allreduce(mine, all, 2, MPI_DOUBLE, MPI_MAX, lmp()->world);
  const double before = fix.body().sizes().smallest_h, after = std::min(before, -all[1]);
  if ((int) all[0] <= levels_told) return;
  levels_told = (int) all[0];
  if (lmp()->comm->me == 0)
    utils::logmesg(lmp(), "adapt/neigh: first split to level {} at step {}: smallest h from {:.6g} to {:.6g}; where "
                          "sound limits the time step, {:.3g} times as many steps for the same time\n",
                   levels_told, lmp()->update->ntimestep, before, after, before / after);
}

}    // namespace SPHTM_NS
