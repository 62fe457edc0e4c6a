/* SPH-TM: the energy balance: what each effect has taken or given since the first run, on this rank, in
   mass length^2/time^2. */
#ifndef SPHTM_ENERGY_BALANCE_H
#define SPHTM_ENERGY_BALANCE_H

#include "tm_body_contact.h"
#include "tm_update.h"

#include <algorithm>

namespace SPHTM_NS {

class EnergyBalance {
 public:
  enum Term {
    STRESS_WORK,    // of the stress; what is stored of it is a function of the state, tm_stored_in
    PLASTIC,
    PLASTIC_HEAT,
    FAILURE,             // stored in particles when they failed
    THERMAL_PRESSURE,    // work of the pressure that the internal energy makes (shock equation of state)
    COMPRESSION,         // what compression turned from stored energy into heat
    ARTIFICIAL,
    HEAT,
    KINETIC_WORK,
    INTERNAL_WORK,
    CONTACT_DAMPING,    // dissipated by contact damping
    FRICTION,           // friction work that did not go into particles
    FRICTION_HEAT,      // friction work given to particles as heat
    HEAT_EXCHANGED,     // other heat given to particles (conduction from tools, fluxes)
    CONTACT_WORK,       // work of contact forces on particles
    TOOL_WORK,          // work of the tool drives on the particles and contacts
    SHOCK,              // of ARTIFICIAL, the bulk viscosity of shocks
    LEFT_KINETIC,       // of particles that left the box
    LEFT_STORED,
    TERMS
  };

  double of(Term t) const { return sum[t]; }
  void add(Term t, double energy) { sum[t] += energy; }
  void add_step(const tm_update_result &r)
  {
    add(STRESS_WORK, r.stress_work);
    add(PLASTIC, r.plastic);
    add(PLASTIC_HEAT, r.plastic_heat);
    add(FAILURE, r.failure);
    add(THERMAL_PRESSURE, r.thermal_pressure);
    add(COMPRESSION, r.compression);
    add(ARTIFICIAL, r.artificial);
    add(KINETIC_WORK, r.kinetic_work);
    add(INTERNAL_WORK, r.internal_work);
    add(HEAT, r.heat);
    add(SHOCK, r.shock);
  }
  void add_body_contact(const tm_body_contact_result &r, double dt)
  {
    add_spring(r.spring);
    add(CONTACT_DAMPING, dt * r.damping_power);
    add(FRICTION, dt * (r.friction_power - r.heat_power));
    add(FRICTION_HEAT, dt * r.heat_power);
    add(CONTACT_WORK, dt * r.work_power);
    deepest = std::max(deepest, r.depth);
  }
  // The sum of the balance stays: what motion and stress lose in a split or merge is artificial, or heat
  void add_remap(double kinetic, double elastic, double heat)
  {
    remaps++;
    add(STRESS_WORK, elastic);    // stored without work
    add(HEAT, heat);
    add(ARTIFICIAL, -(kinetic + elastic + heat));
  }

  long remapped() const { return remaps; }    // splits and merges of this rank

  // energy stored in contact springs in this step
  double spring() const { return contact_spring; }
  void begin_step() { contact_spring = deepest = 0.0; }
  void add_spring(double energy) { contact_spring += energy; }
  // how deep bodies of particles are in each other in this step, in spacings
  double deepest_of_bodies() const { return deepest; }

  // of restart files
  const double *values() const { return sum; }
  void restore(const double *v)
  {
    for (int t = 0; t < TERMS; t++) sum[t] = v[t];
  }

 private:
  double sum[TERMS] = {};
  double contact_spring = 0.0;
  double deepest = 0.0;
  long remaps = 0;
};

}    // namespace SPHTM_NS

#endif
