/* SPH-TM: the contact loop over particles, instantiated for the effects of a scene. */
#ifndef SPHTM_CONTACT_LOOP_H
#define SPHTM_CONTACT_LOOP_H

#include "backend.h"
#include "tm_contact_tri.h"

namespace SPHTM_NS {

// particles 0..n-1 on the host; effects: bits of tm_contact_effect
tm_contact_result contact_loop(Backend &, int n, const tm_contact_args &args, unsigned effects);

// deepest penetration among particles 0..n-1 with the mesh shifted; *worst: which, or -1
double contact_overlap(int n, const tm_contact_args &args, unsigned effects, tm_vec3 shift,
                       int *worst);

}    // namespace SPHTM_NS

#endif
