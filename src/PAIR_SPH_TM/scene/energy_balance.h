/* SPH-TM: the energy balance: what each effect has taken or given since the first run, on this rank, in
   mass length^2/time^2. */
#ifndef SPHTM_ENERGY_BALANCE_H
#define SPHTM_ENERGY_BALANCE_H

#include "tm_body_contact.h"
#include "tm_update.h"

namespace SPHTM_NS {

class EnergyBalance {
 public:
  enum Term {
    ELASTIC,
    PLASTIC,
    PLASTIC_HEAT,
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
    TERMS
  };

  double of(Term t) const { return sum[t]; }
  void add(Term t, double energy) { sum[t] += energy; }
  void add_step(const tm_update_result &r)
  {
    add(ELASTIC, r.elastic);
    add(PLASTIC, r.plastic);
    add(PLASTIC_HEAT, r.plastic_heat);
    add(ARTIFICIAL, r.artificial);
    add(KINETIC_WORK, r.kinetic_work);
    add(INTERNAL_WORK, r.internal_work);
    add(HEAT, r.heat);
  }
  void add_body_contact(const tm_body_contact_result &r, double dt)
  {
    add_spring(r.spring);
    add(CONTACT_DAMPING, dt * r.damping_power);
    add(FRICTION, dt * (r.friction_power - r.heat_power));
    add(FRICTION_HEAT, dt * r.heat_power);
    add(CONTACT_WORK, dt * r.work_power);
  }
  // The sum of the balance stays: what motion and stress lose in a split or merge is artificial, or heat
  void add_remap(double kinetic, double elastic, double heat)
  {
    add(ELASTIC, elastic);
    add(HEAT, heat);
    add(ARTIFICIAL, -(kinetic + elastic + heat));
  }

  // energy stored in contact springs in this step
  double spring() const { return contact_spring; }
  void begin_step() { contact_spring = 0.0; }
  void add_spring(double energy) { contact_spring += energy; }

  // of restart files
  const double *values() const { return sum; }
  void restore(const double *v)
  {
    for (int t = 0; t < TERMS; t++) sum[t] = v[t];
  }

 private:
  double sum[TERMS] = {};
  double contact_spring = 0.0;
};

}    // namespace SPHTM_NS

#endif
