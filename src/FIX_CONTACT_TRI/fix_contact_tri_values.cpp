/* SPH-TM: what fix contact/tri shows and keeps: forces on the tool, restart, memory. */
#include "fix_contact_tri.h"

#include "pair_sph_tm.h"

#include "comm.h"
#include "error.h"
#include "update.h"

#include <algorithm>
#include <cstring>

using namespace LAMMPS_NS;
using namespace SPHTM_NS;

/* ---------------------------------------------------------------------- values */

void FixContactTri::sum_up()
{
  if (totals_step == update->ntimestep) return;
  totals_step = update->ntimestep;
  finish_contact();
  const double force = 1.0 / pair->units().force, power = 1.0 / pair->units().energy;
  const double mine[10] = {force * sums.force.x,        force * sums.force.y,
                           force * sums.force.z,        force * sums.torque.x,
                           force * sums.torque.y,       force * sums.torque.z,
                           power * sums.friction_power, power * sums.heat_tool,
                           (double) sums.contacts,      0.0};
  double all[10], depth;
  MPI_Allreduce(mine, all, 10, MPI_DOUBLE, MPI_SUM, world);
  MPI_Allreduce(&sums.depth, &depth, 1, MPI_DOUBLE, MPI_MAX, world);
  std::copy_n(all, 6, totals);
  std::copy_n(all + 6, 3, totals + 9);
  totals[12] = depth / pair->settings_in_use().spacing;
}

double FixContactTri::compute_vector(int n)
{
  if (n >= 6 && n < 9) {
    const tm_pose p = pose_now();
    const tm_vec3 r = tm_pose_to_world(&p, reference_local);
    return n == 6 ? r.x : n == 7 ? r.y : r.z;
  }
  sum_up();
  return totals[n];
}

double FixContactTri::compute_scalar()
{
  return temperature;
}

void FixContactTri::tool_force(double *force)
{
  sum_up();
  std::copy_n(totals, 3, force);
}

void *FixContactTri::extract(const char *name, int &dim)
{
  dim = 0;
  return strcmp(name, ContactProbe::NAME) == 0 ? (ContactProbe *) this : nullptr;
}

/* ---------------------------------------------------------------------- restart */

void FixContactTri::write_restart(FILE *fp)
{
  if (comm->me) return;
  std::vector<double> v = {1.0, clock, temperature};
  const std::vector<double> m = motion.pack();
  v.insert(v.end(), m.begin(), m.end());
  const int size = v.size() * sizeof(double);
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(v.data(), sizeof(double), v.size(), fp);
}

void FixContactTri::restart(char *buf)
{
  double v[3 + ToolMotion::PACKED];
  memcpy(v, buf, sizeof(v));
  if (v[0] != 1.0)
    error->all(FLERR, "Fix contact/tri {}: restart data of version {:.0f}, 1 expected", id, v[0]);
  clock = v[1];
  temperature = v[2];
  temperature_given = true;
  motion.unpack(v + 3);
  restored = true;
}

double FixContactTri::memory_usage()
{
  return tool.bytes() + (double) (tool_heat.bytes() + tri_force.bytes() + tri_heat.bytes());
}
