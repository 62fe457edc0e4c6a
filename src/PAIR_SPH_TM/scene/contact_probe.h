/* SPH-TM: what other styles ask a fix that is a tool for: the surface that a particle is about to touch, a picture of it. */
#ifndef SPHTM_CONTACT_PROBE_H
#define SPHTM_CONTACT_PROBE_H

#include "tm_tensor.h"

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

  // the box about the tool, which turns with it, now
  struct Box {
    tm_vec3 origin, axis[3];    // of the frame of lo and hi
    double lo[3], hi[3];
    double top_speed;    // of the points of the tool
    // is a point within a distance of the box? In two dimensions of its section
    bool is_near(const double *x, double distance, int dimension) const
    {
      double away2 = 0.0;
      for (int d = 0; d < dimension; d++) {
        const double at = tm_vec_dot(axis[d], tm_vec_sub(tm_load3(x), origin));
        const double away = tm_max(tm_max(lo[d] - at, at - hi[d]), 0.0);
        away2 += away * away;
      }
      return away2 < distance * distance;
    }
  };
  virtual Box box() const = 0;

 protected:
  explicit ContactProbe(const std::string &name) : tool_name(name) {}
  ~ContactProbe() = default;    // owned as a Fix
};

}    // namespace SPHTM_NS

#endif
