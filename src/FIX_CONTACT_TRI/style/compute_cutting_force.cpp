/* SPH-TM: compute cutting/force. See doc/compute_cutting_force.rst. */
#include "compute_cutting_force.h"

#include "argument.h"
#include "fix_contact_tri.h"

#include "comm.h"
#include "error.h"
#include "modify.h"
#include "update.h"

#include <cmath>

using namespace LAMMPS_NS;
using namespace SPHTM_NS;

ComputeCuttingForce::ComputeCuttingForce(LAMMPS *lmp, int narg, char **arg) : Compute(lmp, narg, arg)
{
  scalar_flag = 1;
  vector_flag = 1;
  size_vector = 5;
  extscalar = 0;
  extvector = 0;
  if (narg < 4) error->all(FLERR, "Compute cutting/force needs the ID of a fix contact/tri");
  tool_id = arg[3];
  Keywords k(lmp, "Compute cutting/force", narg - 4, arg + 4);
  auto unit_vector = [&](double *to) {
    k.need(3);
    for (int d = 0; d < 3; d++) to[d] = k.number();
    const double n = sqrt(to[0] * to[0] + to[1] * to[1] + to[2] * to[2]);
    if (!(n > 0.0)) error->all(FLERR, "{} must not be zero", k.what());
    for (int d = 0; d < 3; d++) to[d] /= n;
  };
  while (k.next()) {
    if (k.is("direction")) {
      direction_given = true;
      unit_vector(direction);
    } else if (k.is("away")) unit_vector(away);
    else if (k.is("width")) width = k.positive();
    else k.unknown("direction, away, width");
  }
  if (direction_given && is_along(direction))
    error->all(
        FLERR,
        "Compute cutting/force {}: away {:.6g} {:.6g} {:.6g} is along direction {:.6g} {:.6g} {:.6g}: there is no "
        "thrust force across it; give away another direction",
        id, away[0], away[1], away[2], direction[0], direction[1], direction[2]);
  vector = new double[size_vector];
}

ComputeCuttingForce::~ComputeCuttingForce() { delete[] vector; }

bool ComputeCuttingForce::is_along(const double *u) const
{
  const tm_vec3 across = tm_vec_cross(tm_load3(u), tm_load3(away));
  return tm_vec_norm(across) < 1e-6;
}

FixContactTri *ComputeCuttingForce::tool() const
{
  auto *found = dynamic_cast<FixContactTri *>(modify->get_fix_by_id(tool_id));
  if (!found) error->all(FLERR, "Compute cutting/force {}: {} is not the ID of a fix contact/tri", id, tool_id);
  return found;
}

void ComputeCuttingForce::init() { tool(); }

/* cutting force against the motion, thrust out of the work, side force, their resultant (per
   width), cutting power; all as the tool feels them */
void ComputeCuttingForce::compute_vector()
{
  invoked_vector = update->ntimestep;
  FixContactTri *t = tool();
  double of[ContactResults::FRICTION_POWER];    // force, torque, point of the torque
  for (int n = 0; n < ContactResults::FRICTION_POWER; n++) of[n] = t->compute_vector(n);
  const tm_vec3 F = tm_load3(of + ContactResults::FORCE), torque = tm_load3(of + ContactResults::TORQUE);
  const tm_pose pose = t->tool_pose();
  const tm_vec3 v = pose.velocity;
  const double speed = tm_vec_norm(v);
  tm_vec3 u = tm_load3(direction);
  if (!direction_given && speed > 0.0) u = tm_vec_scale(1.0 / speed, v);
  const double along[3] = {u.x, u.y, u.z};
  if (!warned && is_along(along)) {
    warned = true;
    if (comm->me == 0)
      error->warning(FLERR,
                     "Compute cutting/force {}: the tool moves along away, {:.6g} {:.6g} {:.6g}: thrust and side force "
                     "are 0; give away another direction",
                     id, away[0], away[1], away[2]);
  }
  tm_vec3 n = tm_load3(away);
  n = tm_vec_axpy(n, -tm_vec_dot(n, u), u);
  if (tm_vec_norm(n) > 0.0) n = tm_vec_scale(1.0 / tm_vec_norm(n), n);
  vector[0] = -tm_vec_dot(F, u) / width;
  vector[1] = tm_vec_dot(F, n) / width;
  vector[2] = tm_vec_dot(F, tm_vec_cross(u, n)) / width;
  vector[3] = tm_vec_norm(F) / width;
  vector[4] = -tm_vec_dot(F, tm_pose_velocity_at(&pose, tm_load3(of + ContactResults::REFERENCE))) -
              tm_vec_dot(torque, pose.omega);
}

double ComputeCuttingForce::compute_scalar()
{
  if (invoked_vector != update->ntimestep) compute_vector();
  invoked_scalar = update->ntimestep;
  scalar = vector[0];
  return scalar;
}
