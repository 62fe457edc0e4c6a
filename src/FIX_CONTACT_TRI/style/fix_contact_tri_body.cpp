/* SPH-TM: particles around and inside the tool, for fix contact/tri: where they overlap at the
   start, and a tool whose inside is made of particles that conduct heat. */
#include "fix_contact_tri.h"

#include "fix_sph_tm.h"
#include "pair_sph_tm.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "tm_winding.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace SPHTM_NS;

// in spacings: how closely a way out is found
static constexpr double WAY_STEP = 0.01;

tm_contact_args FixContactTri::host_args(const tm_pose &pose)
{
  tm_contact_args a = {};
  a.mesh = tool.view();
  a.grid = tool.grid();
  a.pose = pose;
  a.deep = pair->settings_in_use().spacing;
  a.law = laws.data();
  a.mask = atom->mask;
  a.group = groupbit;
  a.type = atom->type;
  a.x = atom->nmax ? &atom->x[0][0] : nullptr;
  a.x_stride = 3;
  return a;
}

void FixContactTri::touched(int i, double radius, std::vector<Surface> &found)
{
  if (!laws[atom->type[i]].active || !(atom->mask[i] & groupbit)) return;
  const tm_contact_args a = host_args(pose_now());
  const tm_vec3 p = tm_pose_to_local(&a.pose, tm_load3(atom->x[i]));
  tm_touch touch[TM_TOUCH_MAX];
  const int n = tm_touch_find(&a.mesh, &a.grid, p, std::min(radius, indexed_reach), a.deep, request.two_sided, touch);
  for (int k = 0; k < n; k++) {
    tm_vec3 normal = tm_mat_mul_vec(a.pose.turn, touch[k].normal);
    if (domain->dimension == 2) normal.z = 0.0;
    const double length = tm_vec_norm(normal);
    if (length > 0.0) found.push_back({tm_vec_scale(1.0 / length, normal), touch[k].distance});
  }
}

// does a particle of any rank overlap the tool, moved by a shift? *worst: the deepest, on its rank
bool FixContactTri::overlaps(const tm_contact_args &args, tm_vec3 shift, int *worst) const
{
  const double mine = contact_overlap(atom->nlocal, args, effects(false), shift, worst);
  double all;
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_MAX, world);
  if (mine < all) *worst = -1;
  return all > overlap_passes * pair->settings_in_use().spacing;
}

/* Shortest move along one direction that clears all particles, by doubling and bisection; at least
   `limit` when there is none shorter. */
double FixContactTri::way_out(const tm_contact_args &args, tm_vec3 direction, double limit) const
{
  const double step = WAY_STEP * pair->settings_in_use().spacing;
  int worst;
  double hi = step, lo = 0.0;
  while (hi < limit && overlaps(args, tm_vec_scale(hi, direction), &worst)) {
    lo = hi;
    hi *= 2.0;
  }
  if (lo >= limit) return limit;
  while (hi - lo > step) {
    const double mid = 0.5 * (lo + hi);
    (overlaps(args, tm_vec_scale(mid, direction), &worst) ? lo : hi) = mid;
  }
  return hi + step;
}

/* A tool that starts inside the work would throw its particles away: say where, and the shortest
   way along an axis that clears all of them. */
void FixContactTri::check_overlap(double passes)
{
  overlap_passes = passes;
  const tm_contact_args args = host_args(pose_now());
  int where;
  const bool touching = overlaps(args, tm_vec(0, 0, 0), &where);
  if (!touching) where = sample_inside(args);
  int any = where >= 0, all_any;
  MPI_Allreduce(&any, &all_any, 1, MPI_INT, MPI_MAX, world);
  if (!all_any) return;

  const double far = tm_vec_norm(tm_vec_sub(tm_load3(domain->boxhi), tm_load3(domain->boxlo)));
  double best = far;
  int way = -1;
  for (int k = 0; k < 2 * domain->dimension && touching; k++) {
    const double sign = k % 2 ? -1.0 : 1.0;
    const tm_vec3 d =
        tm_vec(k / 2 == 0 ? sign : 0.0, k / 2 == 1 ? sign : 0.0, k / 2 == 2 ? sign : 0.0);
    const double length = way_out(args, d, best);
    if (length >= best) continue;
    best = length;
    way = k;
  }
  const std::string remedy = way >= 0
      ? fmt::format("by {:.3g} along {}: move it by that along {}{}", best, "xyz"[way / 2],
                    way % 2 ? '-' : '+', "xyz"[way / 2])
      : std::string("deeper than the contact sees: move it away, or use 'flip yes' where the "
                    "particles belong inside it");
  if (where >= 0)
    error->one(FLERR,
               "Fix contact/tri {}: at the start the tool overlaps particles, {}; for instance "
               "particle {} at {:.6g} {:.6g} {:.6g}; or accept it with 'overlap allow'",
               id, remedy, atom->tag[where], atom->x[where][0], atom->x[where][1],
               atom->x[where][2]);
  MPI_Barrier(world);
}

/* Contact sees one spacing deep. Some of the particles are asked whether they lie deeper than that
   in a closed tool: as many as some tenths of a second allow. */
int FixContactTri::sample_inside(const tm_contact_args &args) const
{
  const int n = atom->nlocal;
  if (!tool.mesh().closed || request.two_sided || n == 0) return -1;
  const int samples = std::min(n, 20 + 10000000 / std::max(tool.mesh().nt, 1));
  for (int k = 0; k < samples; k++) {
    const int i = (int) ((double) k / samples * n);
    if (!laws[atom->type[i]].active || !(atom->mask[i] & groupbit)) continue;
    const tm_vec3 p = tm_pose_to_local(&args.pose, tm_load3(atom->x[i]));
    if (tm_winding_inside(&args.mesh, tool.mesh().volume, p)) return i;
  }
  return -1;
}

/* -------------------------------------------------------------- the tool's own particles */

void FixContactTri::run_carry(const tm_carry_args &a)
{
  state->loops().blocks(atom->nlocal, [&](int begin, int end) {
    for (int i = begin; i < end; i++) tm_carry(i, &a);
  });
}

void FixContactTri::place_body(const tm_pose &from, const tm_pose &to)
{
  run_carry({state->state(), groupbit, request.body_type, domain->dimension == 3, from, to});
}

// the first particle whose heat nobody takes, or n
int FixContactTri::run_divide(const tm_spread_args &a)
{
  const int n = atom->nlocal;
  return state->loops().sum_blocks(
      n, n,
      [&](int begin, int end) {
        for (int i = begin; i < end; i++)
          if (tm_spread_divide(i, &a)) return i;
        return n;
      },
      [](int *first, const int *i) { *first = std::min(*first, *i); });
}

void FixContactTri::run_collect(const tm_spread_args &a)
{
  state->loops().blocks(atom->nlocal, [&](int begin, int end) {
    for (int i = begin; i < end; i++) tm_spread_collect(i, &a);
  });
}

// friction heat for the tool goes to its particles; what finds none is lost, and said
void FixContactTri::heat_body()
{
  const tm_rates_args &rates = pair->rate_args();
  const PairSPHTM::Settings &set = pair->settings_in_use();
  tm_spread_args a;
  a.rows = rates.rows;
  a.main = rates.rec.main;
  a.type = rates.type;
  a.body_type = request.body_type;
  a.kernel = set.kernel;
  a.h = set.h;
  a.heat = tool_heat.loop_write();
  a.source = state->heat_source();
  const int i = run_divide(a);
  if (i < atom->nlocal) {
    const tm_real *x = pair->host_records().main + (size_t) i * TM_REC;
    error->one(FLERR,
               "Fix contact/tri {} particles: no particle of type {} near the contact at "
               "{:.6g} {:.6g} {:.6g} takes up the friction heat; fill the tool with "
               "particles up to its surface",
               id, request.body_type, x[0], x[1], x[2]);
  }
  comm->forward_comm(this);
  a.heat = tool_heat.loop_write();
  run_collect(a);
}

int FixContactTri::pack_forward_comm(int n, int *list, double *buf, int, int *)
{
  const double *lost = tool_heat.host_read();
  for (int k = 0; k < n; k++) buf[k] = lost[list[k]];
  return n;
}

void FixContactTri::unpack_forward_comm(int n, int first, double *buf)
{
  std::copy_n(buf, n, tool_heat.host_write() + first);
}
