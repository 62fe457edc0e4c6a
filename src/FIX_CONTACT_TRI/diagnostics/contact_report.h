/* SPH-TM: what the log says of the contact laws of a tool: stiffness, damping, friction and its heat, for each type. */
#ifndef SPHTM_CONTACT_REPORT_H
#define SPHTM_CONTACT_REPORT_H

#include "contact_laws.h"
#include "contact_settings.h"

#include <string>

namespace SPHTM_NS {

class ParticleState;

// on one rank
void report_contact_laws(LAMMPS_NS::LAMMPS *, const std::string &id, const ContactSettings &, const ContactLaws &,
                         ParticleState &);

}    // namespace SPHTM_NS

#endif
