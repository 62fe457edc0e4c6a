/* SPH-TM: what other styles ask a fix that is a tool for: the surface that a particle is about to touch, a picture of it. */
#ifndef SPHTM_CONTACT_PROBE_H
#define SPHTM_CONTACT_PROBE_H

#include "tm_active.h"

#include <string>
#include <vector>

namespace SPHTM_NS {

class ContactProbe {
 public:
  const std::string tool_name;
  struct Surface {
    tm_vec3 normal;     // unit, from the surface to the particle
    double distance;    // of the particle's center, negative behind the surface
  };
  // adds the surfaces that a sphere about owned particle i touches, now; on the host
  virtual void touched(int i, double radius, std::vector<Surface> &) = 0;
  // a VTK XML file of the tool where it is now; what went wrong, or an empty text
  virtual std::string write_surface(const std::string &path, double time) = 0;

  virtual tm_tool_box box() const = 0;
  // in a step, when particles and tools are where the forces find them and no force is there yet
  virtual void before_forces() {}

 protected:
  explicit ContactProbe(const std::string &name) : tool_name(name) {}
  ~ContactProbe() = default;    // owned as a Fix
};

}    // namespace SPHTM_NS

#endif
