/* SPH-TM: what fix adapt/neigh asks a fix that is a tool for: the surface that a particle is about to touch. */
#ifndef SPHTM_CONTACT_PROBE_H
#define SPHTM_CONTACT_PROBE_H

#include "tm_tensor.h"

#include <vector>

namespace SPHTM_NS {

class ContactProbe {
 public:
  struct Surface {
    tm_vec3 normal;     // unit, from the surface to the particle
    double distance;    // of the particle's center, negative behind the surface
  };
  // adds the surfaces that a sphere about owned particle i touches, now; on the host
  virtual void touched(int i, double radius, std::vector<Surface> &) = 0;

 protected:
  ~ContactProbe() = default;    // owned as a Fix
};

}    // namespace SPHTM_NS

#endif
