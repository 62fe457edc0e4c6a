/* SPH-TM: compute cutting/force. See doc/compute_cutting_force.rst. */
#include "compute_cutting_force.h"

#include "argument.h"
#include "fix_contact_tri.h"

#include "error.h"
#include "modify.h"
#include "update.h"
#include "utils.h"

#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;
using namespace SPHTM_NS;

ComputeCuttingForce::ComputeCuttingForce(LAMMPS *lmp, int narg, char **arg) :
    Compute(lmp, narg, arg)
{
  scalar_flag = 1;
  vector_flag = 1;
  size_vector = 5;
  extscalar = 0;
  extvector = 0;
  if (narg < 4) utils::missing_cmd_args(FLERR, "compute cutting/force", error);
  tool_id = arg[3];
  auto three = [&](int iarg, double *to) {
    if (iarg + 3 >= narg)
      error->all(FLERR, "Compute cutting/force keyword {} needs three numbers", arg[iarg]);
    double n = 0.0;
    for (int k = 0; k < 3; k++) {
      to[k] = number(lmp, std::string("Compute cutting/force ") + arg[iarg], arg[iarg + 1 + k]);
      n += to[k] * to[k];
    }
    if (!(n > 0.0)) error->all(FLERR, "Compute cutting/force {} must not be zero", arg[iarg]);
    for (int k = 0; k < 3; k++) to[k] /= sqrt(n);
    return iarg + 4;
  };
  for (int iarg = 4; iarg < narg;) {
    if (strcmp(arg[iarg], "direction") == 0) {
      direction_given = true;
      iarg = three(iarg, direction);
    } else if (strcmp(arg[iarg], "away") == 0) {
      iarg = three(iarg, away);
    } else if (strcmp(arg[iarg], "width") == 0) {
      if (iarg + 1 >= narg) utils::missing_cmd_args(FLERR, "compute cutting/force width", error);
      width = positive(lmp, "Compute cutting/force width", arg[iarg + 1]);
      iarg += 2;
    } else
      error->all(FLERR,
                 "Unknown compute cutting/force keyword {}: known are direction, away, width",
                 arg[iarg]);
  }
  vector = new double[size_vector];
}

ComputeCuttingForce::~ComputeCuttingForce()
{
  delete[] vector;
}

void ComputeCuttingForce::init()
{
  tool = dynamic_cast<FixContactTri *>(modify->get_fix_by_id(tool_id));
  if (!tool)
    error->all(FLERR, "Compute cutting/force: {} is not the ID of a fix contact/tri", tool_id);
}

/* cutting force against the motion, thrust out of the work, side force, their resultant (per
   width), cutting power; all as the tool feels them */
void ComputeCuttingForce::compute_vector()
{
  invoked_vector = update->ntimestep;
  double f[3];
  tool->tool_force(f);
  const tm_vec3 v = tool->tool_velocity(), F = tm_vec(f[0], f[1], f[2]);
  const double speed = tm_vec_norm(v);
  tm_vec3 u = tm_load3(direction);
  if (!direction_given && speed > 0.0) u = tm_vec_scale(1.0 / speed, v);
  tm_vec3 n = tm_load3(away);
  n = tm_vec_axpy(n, -tm_vec_dot(n, u), u);
  if (tm_vec_norm(n) > 0.0) n = tm_vec_scale(1.0 / tm_vec_norm(n), n);
  vector[0] = -tm_vec_dot(F, u) / width;
  vector[1] = tm_vec_dot(F, n) / width;
  vector[2] = tm_vec_dot(F, tm_vec_cross(u, n)) / width;
  vector[3] = tm_vec_norm(F) / width;
  vector[4] = -tm_vec_dot(F, v);
}

double ComputeCuttingForce::compute_scalar()
{
  if (invoked_vector != update->ntimestep) compute_vector();
  invoked_scalar = update->ntimestep;
  scalar = vector[0];
  return scalar;
}
