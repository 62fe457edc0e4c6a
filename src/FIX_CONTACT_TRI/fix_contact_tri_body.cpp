/* SPH-TM: particles around and inside the tool, for fix contact/tri: where they overlap at the
   start, and a tool whose inside is made of particles that conduct heat. */
#include "fix_contact_tri.h"

#include "fix_sph_tm.h"
#include "pair_sph_tm.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "tm_kernel.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace SPHTM_NS;

/* A tool that starts inside the work would throw its particles away. Say where, how deep, and the
   shortest way along an axis that clears all of them: doubling, then bisection. */
void FixContactTri::check_overlap()
{
  const double dp = pair->settings_in_use().spacing, allowed = 0.01 * dp;
  const tm_contact_args args = make_args(pose_now(), false);
  auto deepest = [&](tm_vec3 shift, int *worst) {
    const double mine = contact_overlap(atom->nlocal, args, effects(false), shift, worst);
    double all;
    MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_MAX, world);
    if (mine < all) *worst = -1;
    return all;
  };
  int worst, other;
  const double depth = deepest(tm_vec(0, 0, 0), &worst);
  if (!(depth > allowed)) return;

  const double far = 2.0 * tm_vec_norm(tm_vec_sub(tm_load3(domain->boxhi), tm_load3(domain->boxlo)));
  double best = 1e300;
  int best_axis = 0;
  for (int axis = 0; axis < 2 * domain->dimension; axis++) {
    const double sign = axis % 2 ? -1.0 : 1.0;
    auto shift = [&](double s) {
      return tm_vec(axis / 2 == 0 ? sign * s : 0.0, axis / 2 == 1 ? sign * s : 0.0,
                    axis / 2 == 2 ? sign * s : 0.0);
    };
    double hi = depth, lo = 0.0;
    while (hi < std::min(far, best) && deepest(shift(hi), &other) > allowed) {
      lo = hi;
      hi *= 2.0;
    }
    if (hi >= std::min(far, best)) continue;
    while (hi - lo > 0.05 * dp) {
      const double mid = 0.5 * (lo + hi);
      (deepest(shift(mid), &other) > allowed ? lo : hi) = mid;
    }
    if (hi < best) {
      best = hi;
      best_axis = axis;
    }
  }
  const std::string way = best < 1e300
      ? fmt::format("move the tool by {:.4g} along {}{}", best, best_axis % 2 ? '-' : '+',
                    "xyz"[best_axis / 2])
      : std::string("move the tool away");
  if (worst >= 0)
    error->one(FLERR, "Fix contact/tri {}: the tool overlaps particles at the start, by {:.4g} "
                      "({:.2f} spacings) at particle {} at {:.6g} {:.6g} {:.6g}; {}, or use "
                      "'overlap allow'", id, depth, depth / dp, atom->tag[worst],
               atom->x[worst][0], atom->x[worst][1], atom->x[worst][2], way);
  MPI_Barrier(world);
}

/* ---------------------------------------------------------------------- the tool's own particles */

// carried with the tool, exactly; their velocity stays zero, so that nothing else moves them
void FixContactTri::place_body(const tm_pose &from, const tm_pose &to)
{
  for (int i = 0; i < atom->nlocal; i++) {
    if (atom->type[i] != request.body_type || !(atom->mask[i] & groupbit)) continue;
    double *x = atom->x[i], *v = atom->v[i];
    const tm_vec3 local = tm_pose_to_local(&from, tm_load3(x));
    const tm_vec3 w = tm_pose_to_world(&to, local);
    x[0] = w.x;
    x[1] = w.y;
    if (domain->dimension == 3) x[2] = w.z;
    v[0] = v[1] = v[2] = 0.0;
  }
}

double FixContactTri::heat_weight(int i, int j) const
{
  const PairSPHTM::Settings &set = pair->settings_in_use();
  const double *a = pair->records().main + (size_t) i * TM_REC;
  const double *b = pair->records().main + (size_t) j * TM_REC;
  const double dx = a[0] - b[0], dy = a[1] - b[1], dz = a[2] - b[2];
  return tm_kernel_shape(set.kernel, sqrt(dx * dx + dy * dy + dz * dz) / set.h);
}

/* Friction heat for the tool goes to its particles within the kernel of the rubbing one (F15's
   NeibContTherm), in parts that add up to all of it: the rubbing particle divides its heat by the
   sum of its weights, then each tool particle collects. What finds no tool particle is lost, and
   said. */
void FixContactTri::heat_body()
{
  const tm_rows &rows = pair->rate_args().rows;
  const int *type = atom->type;
  double *source = state->heat_source();
  auto each_neighbor = [&](int i, auto &&use) {
    const int *row = rows.index + rows.first[i];
    for (int k = 0; k < rows.thermal[i]; k++) use(row[(rows.mechanical[i] + k) * rows.stride]);
  };
  for (int i = 0; i < atom->nlocal; i++) {
    if (tool_heat[i] == 0.0) continue;
    double sum = 0.0;
    each_neighbor(i, [&](int j) { if (type[j] == request.body_type) sum += heat_weight(i, j); });
    if (sum == 0.0)
      error->one(FLERR, "Fix contact/tri {} particles: no particle of type {} near the contact at "
                        "{:.6g} {:.6g} {:.6g} takes up the friction heat; fill the tool with "
                        "particles up to its surface", id, request.body_type, atom->x[i][0],
                 atom->x[i][1], atom->x[i][2]);
    tool_heat[i] /= sum;
  }
  comm->forward_comm(this);
  for (int j = 0; j < atom->nlocal; j++) {
    if (type[j] != request.body_type) continue;
    double heat = 0.0;
    each_neighbor(j, [&](int i) {
      if (tool_heat[i] != 0.0) heat += tool_heat[i] * heat_weight(i, j);
    });
    source[j] += heat;
  }
}

int FixContactTri::pack_forward_comm(int n, int *list, double *buf, int, int *)
{
  for (int k = 0; k < n; k++) buf[k] = tool_heat[list[k]];
  return n;
}

void FixContactTri::unpack_forward_comm(int n, int first, double *buf)
{
  std::copy_n(buf, n, &tool_heat[first]);
}
