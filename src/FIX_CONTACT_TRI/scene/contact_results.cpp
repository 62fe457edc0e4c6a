#include "contact_results.h"

#include <algorithm>

namespace SPHTM_NS {

ContactResults::~ContactResults()
{
  if (!loops) return;
  loops->release_result(result);
  loops->release_result(more);
}

void ContactResults::live_in(Backend &b)
{
  if (loops) return;
  loops = &b;
  for (auto *r : {&result, &more}) *r = (tm_contact_result *) loops->allocate_result(sizeof(tm_contact_result));
}

tm_contact_result *ContactResults::begin()
{
  pending = true;
  reduced = false;
  return result;
}

bool ContactResults::finish()
{
  if (!pending) return false;
  pending = false;
  loops->wait();
  sums = *result;
  has_pressed = has_pressed || sums.contacts > 0;
  return true;
}

bool ContactResults::pressed(MPI_Comm world)
{
  const bool some = over(world, has_pressed ? 1.0 : 0.0, MPI_MAX) > 0.0;
  has_pressed = false;
  return some;
}

double ContactResults::over(MPI_Comm world, double mine, MPI_Op op)
{
  double all;
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, op, world);
  return all;
}

void ContactResults::add_to(EnergyBalance &energy, double dt, bool tool_particles) const
{
  const double heat = sums.friction_heat + (tool_particles ? sums.heat_tool : 0.0);
  energy.add(EnergyBalance::CONTACT_DAMPING, dt * sums.damping_power);
  energy.add(EnergyBalance::FRICTION, dt * (sums.friction_power + sums.late_friction - heat));
  energy.add(EnergyBalance::FRICTION_HEAT, dt * heat);
  energy.add(EnergyBalance::HEAT_EXCHANGED, dt * sums.conducted);
  energy.add(EnergyBalance::CONTACT_WORK, dt * sums.particle_power);
  energy.add(EnergyBalance::TOOL_WORK, dt * sums.tool_power);
}

void ContactResults::take_springs(EnergyBalance &energy, double sign) const
{
  energy.add(EnergyBalance::TOOL_WORK, sign * sums.spring);
}

void ContactResults::add_late(EnergyBalance &energy, double dt)
{
  loops->wait();
  energy.add(EnergyBalance::CONTACT_DAMPING, dt * more->damping_power);
  energy.add(EnergyBalance::FRICTION, dt * more->late_friction);
  energy.add(EnergyBalance::CONTACT_WORK, dt * more->particle_power);
  energy.add_spring(more->spring);
}

const double *ContactResults::over_ranks(MPI_Comm world, const UnitScale &unit, double spacing)
{
  if (reduced) return totals;
  reduced = true;
  const double force = 1.0 / unit.force, power = 1.0 / unit.energy;
  const double mine[9] = {force * sums.force.x,        force * sums.force.y,   force * sums.force.z,
                          force * sums.torque.x,       force * sums.torque.y,  force * sums.torque.z,
                          power * sums.friction_power, power * sums.heat_tool, (double) sums.contacts};
  double all[9];
  MPI_Allreduce(mine, all, 9, MPI_DOUBLE, MPI_SUM, world);
  std::copy_n(all, 6, totals + FORCE);
  std::copy_n(all + 6, 3, totals + FRICTION_POWER);
  totals[DEPTH] = depth(world) / spacing;
  return totals;
}

}    // namespace SPHTM_NS
