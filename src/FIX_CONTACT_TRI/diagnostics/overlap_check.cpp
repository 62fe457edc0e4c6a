#include "overlap_check.h"

#include "domain.h"
#include "error.h"
#include "lammps.h"
#include "tm_closest.h"
#include "tm_winding.h"

#include "fmt/format.h"

#include <algorithm>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

static constexpr double WAY_STEP = 0.01;    // in spacings: how closely a way out is found

OverlapCheck::OverlapCheck(LAMMPS *l, const ToolQuery &q, double spacing_, double allowed_) :
    lmp(l), query(q), spacing(spacing_), allowed(allowed_)
{
}

// does a particle of any rank overlap the tool, moved by a shift? *worst: the deepest of this rank, or -1
bool OverlapCheck::overlaps(tm_vec3 shift, int *worst) const
{
  const Atom &atom = *lmp->atom;
  tm_touch touch[TM_TOUCH_MAX];
  double deepest = 0.0, all;
  *worst = -1;
  for (int i = 0; i < atom.nlocal; i++) {
    if (!query.in_contact(i)) continue;
    const double radius = query.radius(i);
    const int found = query.touch(tm_vec_sub(tm_load3(atom.x[i]), shift), radius, touch);
    for (int k = 0; k < found; k++)
      if (radius - touch[k].distance > deepest) {
        deepest = radius - touch[k].distance;
        *worst = i;
      }
  }
  MPI_Allreduce(&deepest, &all, 1, MPI_DOUBLE, MPI_MAX, lmp->world);
  if (deepest < all) *worst = -1;
  return all > allowed * spacing;
}

/* Shortest move along one direction that clears all particles, by doubling and bisection; at least `limit` when there
   is none shorter. */
double OverlapCheck::way_out(tm_vec3 direction, double limit) const
{
  const double step = WAY_STEP * spacing;
  int worst;
  double hi = step, lo = 0.0;
  while (hi < limit && overlaps(tm_vec_scale(hi, direction), &worst)) {
    lo = hi;
    hi *= 2.0;
  }
  if (lo >= limit) return limit;
  while (hi - lo > step) {
    const double mid = 0.5 * (lo + hi);
    (overlaps(tm_vec_scale(mid, direction), &worst) ? lo : hi) = mid;
  }
  return hi + step;
}

// the shortest way out along an axis, in words, or what else may help
std::string OverlapCheck::remedy() const
{
  const Domain &box = *lmp->domain;
  double best = tm_vec_norm(tm_vec_sub(tm_load3(box.boxhi), tm_load3(box.boxlo)));
  int way = -1;
  for (int k = 0; k < 2 * box.dimension; k++) {
    const double sign = k % 2 ? -1.0 : 1.0;
    const tm_vec3 d = tm_vec(k / 2 == 0 ? sign : 0.0, k / 2 == 1 ? sign : 0.0, k / 2 == 2 ? sign : 0.0);
    const double length = way_out(d, best);
    if (length >= best) continue;
    best = length;
    way = k;
  }
  if (way < 0) return "";
  return fmt::format("by {:.3g} along {}: move it by that along {}{}", best, "xyz"[way / 2], way % 2 ? '-' : '+',
                     "xyz"[way / 2]);
}

void OverlapCheck::stop(const std::string &who, const tm_mesh *closed, bool flipped) const
{
  int where;
  const bool touching = overlaps(tm_vec(0, 0, 0), &where);
  if (!touching) where = closed ? sample_inside(*closed) : -1;
  int any = where >= 0, all_any;
  MPI_Allreduce(&any, &all_any, 1, MPI_INT, MPI_MAX, lmp->world);
  if (!all_any) return;
  std::string words = touching ? remedy() : "";
  if (words.empty())
    words = fmt::format("deeper than the contact sees: move it away, or {}",
                        flipped ? "leave out 'flip yes', which turns its inside out"
                                : "use 'flip yes' where the particles belong inside it");
  const Atom &atom = *lmp->atom;
  if (where >= 0)
    lmp->error->one(FLERR,
                    "{}: at the start the tool overlaps particles, {}; for instance particle {} at {:.6g} {:.6g} "
                    "{:.6g}; or accept it with 'overlap allow'",
                    who, words, atom.tag[where], atom.x[where][0], atom.x[where][1], atom.x[where][2]);
  MPI_Barrier(lmp->world);
}

int OverlapCheck::samples() const { return std::min(lmp->atom->nlocal, 20 + 10000000 / std::max(query.mesh.nt, 1)); }

// in the frame of the mesh: is x in front of the triangle that is nearest?
static bool in_front(const tm_tri_view &mesh, tm_vec3 x)
{
  double least = 1e300;
  bool front = false;
  for (int t = 0; t < mesh.nt; t++) {
    const double *corner = mesh.corner + 9 * t;
    const tm_vec3 n = tm_load3(mesh.normal + 3 * t);
    const tm_closest c = tm_closest_on_triangle(x, tm_load3(corner), tm_load3(corner + 3), tm_load3(corner + 6), n);
    const bool ahead = tm_vec_dot(tm_vec_sub(x, c.point), n) > 0.0;
    if (c.dist2 < least * (1.0 - 1e-9)) front = ahead;
    else if (c.dist2 <= least * (1.0 + 1e-9)) front = front || ahead;    // an edge of two triangles
    least = std::min(least, c.dist2);
  }
  return front;
}

bool OverlapCheck::faces_away() const
{
  const Atom &atom = *lmp->atom;
  int mine[2] = {0, 0}, all[2];    // asked, in front
  for (int k = 0; k < samples() && !mine[1]; k++) {
    const int i = (int) ((double) k / samples() * atom.nlocal);
    if (!query.in_contact(i)) continue;
    mine[0] = 1;
    mine[1] = in_front(query.mesh, query.local(tm_load3(atom.x[i])));
  }
  MPI_Allreduce(mine, all, 2, MPI_INT, MPI_MAX, lmp->world);
  return all[0] && !all[1];
}

/* Contact finds particles up to one spacing deep. Some of the particles are tested for lying deeper than that in a
   closed tool. */
int OverlapCheck::sample_inside(const tm_mesh &mesh) const
{
  const Atom &atom = *lmp->atom;
  const tm_tri_view view = tm_mesh_view(&mesh);
  for (int k = 0; k < samples(); k++) {
    const int i = (int) ((double) k / samples() * atom.nlocal);
    if (query.in_contact(i) && tm_winding_inside(&view, mesh.volume, query.local(tm_load3(atom.x[i])))) return i;
  }
  return -1;
}

}    // namespace SPHTM_NS
