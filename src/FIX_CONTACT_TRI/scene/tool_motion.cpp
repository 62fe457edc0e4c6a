#include "tool_motion.h"

#include "error.h"
#include "input.h"
#include "lammps.h"
#include "variable.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

ToolMotion::ToolMotion(LAMMPS *lmp) : lmp(lmp)
{
  memset(&motion, 0, sizeof(motion));
  motion.period = 1.0;
  base = tm_pose_rest();
  moved = moved_next = rate = tm_vec(0, 0, 0);
  std::fill(variable, variable + 6, -1);
}

bool ToolMotion::goes_on(const tm_motion &given) const
{
  auto same = [](tm_vec3 a, tm_vec3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; };
  return restarted && given.kind == motion.kind && same(given.v, motion.v) && same(given.point, motion.point) &&
         same(given.axis, motion.axis) && given.period == motion.period && given.ramp == motion.ramp;
}

// a motion that a restart file holds goes on when the same one is given again
void ToolMotion::keep_if_restarted(const tm_motion &given)
{
  const bool again = goes_on(given);
  restarted = false;
  if (again) return;
  base = pose_now();
  start = time;
  moved = moved_next = rate = tm_vec(0, 0, 0);
}

void ToolMotion::set(const MotionCommand &c)
{
  keep_if_restarted(c.motion);
  restarted_variable = false;
  motion = c.motion;
  names = c.variables;
}

void ToolMotion::init()
{
  if (names.empty() && restarted_variable)
    lmp->error->all(FLERR, "Fix contact/tri: the restart file holds a motion by variables; repeat "
                           "its fix_modify move variable");
  restarted_variable = false;
  for (size_t k = 0; k < names.size(); k++) {
    variable[k] = -1;
    if (names[k].empty()) continue;
    variable[k] = lmp->input->variable->find(names[k].c_str());
    if (variable[k] < 0) lmp->error->all(FLERR, "Fix contact/tri move: no variable {}", names[k]);
    if (!lmp->input->variable->equalstyle(variable[k]))
      lmp->error->all(FLERR, "Fix contact/tri move: variable {} is not equal-style", names[k]);
  }
}

double ToolMotion::value(int k) const { return lmp->input->variable->compute_equal(variable[k]); }

// where a displacement variable is given it rules, else what was reached
tm_vec3 ToolMotion::displacement(tm_vec3 otherwise) const
{
  return tm_vec(variable[0] >= 0 ? value(0) : otherwise.x, variable[1] >= 0 ? value(1) : otherwise.y,
                variable[2] >= 0 ? value(2) : otherwise.z);
}

void ToolMotion::evaluate(double dt)
{
  if (names.empty()) return;
  if (dt > 0.0) evaluate_next(dt);
  else evaluate_now();
}

void ToolMotion::evaluate_now()
{
  moved = moved_next = displacement(moved);
  rate =
      tm_vec(variable[3] >= 0 ? value(3) : 0.0, variable[4] >= 0 ? value(4) : 0.0, variable[5] >= 0 ? value(5) : 0.0);
}

void ToolMotion::evaluate_next(double dt)
{
  double v[3];
  for (int k = 0; k < 3; k++) v[k] = variable[3 + k] >= 0 ? value(3 + k) : 0.0;
  moved_next = displacement(tm_vec_axpy(moved, dt, tm_vec(v[0], v[1], v[2])));
  const double d[3] = {moved_next.x - moved.x, moved_next.y - moved.y, moved_next.z - moved.z};
  for (int k = 0; k < 3; k++)
    if (variable[3 + k] < 0) v[k] = d[k] / dt;
    else if (variable[k] >= 0) {
      apart += fabs(d[k] - v[k] * dt);
      travelled += std::max(fabs(d[k]), fabs(v[k] * dt));
    }
  rate = tm_vec(v[0], v[1], v[2]);
}

bool ToolMotion::contradicts(double length)
{
  constexpr double PART = 0.1;
  if (contradicted || travelled < length || apart <= PART * travelled) return false;
  return contradicted = true;
}

void ToolMotion::end_of_step(double dt)
{
  time += dt;
  moved = moved_next;
}

tm_pose ToolMotion::pose(double ahead, double dt) const
{
  if (names.empty()) {
    tm_pose p = tm_motion_pose(&motion, &base, time - start + ahead);
    p.shift = tm_vec_add(p.shift, moved);    // by variables before a restart, else 0
    return p;
  }
  tm_pose p = base;
  const double part = dt > 0.0 ? ahead / dt : 0.0;
  p.shift = tm_vec_add(p.shift, tm_vec_axpy(moved, part, tm_vec_sub(moved_next, moved)));
  p.velocity = rate;
  p.omega = p.center = tm_vec(0, 0, 0);
  return p;
}

double ToolMotion::top_speed(const double *lo, const double *hi) const
{
  if (!names.empty()) return std::hypot(rate.x, rate.y, rate.z);
  const double w = 2.0 * TM_PI / fabs(motion.period);
  double speed = motion.kind == TM_MOTION_NONE ? 0.0 : std::hypot(motion.v.x, motion.v.y, motion.v.z);
  if (motion.kind == TM_MOTION_WIGGLE) speed *= w;
  if (motion.kind != TM_MOTION_ROTATE && motion.kind != TM_MOTION_TRANSROT) return speed;
  double far = 0.0;
  for (int c = 0; c < 8; c++) {
    const tm_vec3 corner = tm_vec(c & 1 ? hi[0] : lo[0], c & 2 ? hi[1] : lo[1], c & 4 ? hi[2] : lo[2]);
    const tm_vec3 d = tm_vec_sub(tm_pose_to_world(&base, corner), motion.point);
    far = std::max(far, tm_vec_norm(tm_vec_cross(motion.axis, d)) / tm_vec_norm(motion.axis));
  }
  return speed + w * far;
}

bool ToolMotion::under_way(const double *lo, const double *hi) const { return time > start && top_speed(lo, hi) > 0.0; }

// --- restart: motion, base pose, clock, what variables have moved

std::vector<double> ToolMotion::pack() const
{
  std::vector<double> v = {(double) motion.kind, motion.period, motion.ramp, start};
  for (const tm_vec3 &a : {motion.v, motion.point, motion.axis, base.shift, moved}) v.insert(v.end(), {a.x, a.y, a.z});
  const tm_mat3 &r = base.turn;
  v.insert(v.end(), {r.xx, r.xy, r.xz, r.yx, r.yy, r.yz, r.zx, r.zy, r.zz});
  v.push_back(names.empty() ? 0.0 : 1.0);
  v.resize(PACKED, 0.0);
  return v;
}

// a motion that its command could have given, in a frame that is turned only
static bool possible(const tm_motion &m, const tm_pose &base)
{
  const bool turns = m.kind == TM_MOTION_ROTATE || m.kind == TM_MOTION_TRANSROT;
  if (m.period == 0.0 || m.ramp < 0.0 || (turns && !(tm_vec_norm(m.axis) > 0.0))) return false;
  const tm_mat3 &r = base.turn;
  const tm_vec3 row[3] = {tm_vec(r.xx, r.xy, r.xz), tm_vec(r.yx, r.yy, r.yz), tm_vec(r.zx, r.zy, r.zz)};
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++)
      if (!(fabs(tm_vec_dot(row[i], row[j]) - (i == j)) < 1e-6)) return false;
  return true;
}

bool ToolMotion::unpack(double clock, const double *v)
{
  time = clock;
  if (!(v[0] >= (double) TM_MOTION_NONE && v[0] <= (double) TM_MOTION_TRANSROT && v[0] == floor(v[0]))) return false;
  memset(&motion, 0, sizeof(motion));
  motion.kind = (int) v[0];
  motion.period = v[1];
  motion.ramp = v[2];
  start = v[3];
  tm_vec3 *const vectors[5] = {&motion.v, &motion.point, &motion.axis, &base.shift, &moved};
  for (int k = 0; k < 5; k++) *vectors[k] = tm_vec(v[4 + 3 * k], v[5 + 3 * k], v[6 + 3 * k]);
  moved_next = moved;
  const double *r = v + 19;
  base.turn = {r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8]};
  restarted = true;
  restarted_variable = v[28] != 0.0;
  return possible(motion, base);
}

}    // namespace SPHTM_NS
