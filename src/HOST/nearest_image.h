/* SPH-TM: the shortest of a difference of positions and its periodic images. Newer versions of LAMMPS want to know who
   asks, for a message. */
#ifndef SPHTM_NEAREST_IMAGE_H
#define SPHTM_NEAREST_IMAGE_H

#include "domain.h"
#include "pointers.h"

namespace SPHTM_NS {

// the last argument prefers the first of these where both compile
template <class DOMAIN_OF_HOST>
auto to_nearest_image(const DOMAIN_OF_HOST &d, double *v, int) -> decltype(d.minimum_image(FLERR, v))
{
  d.minimum_image(FLERR, v);
}
template <class DOMAIN_OF_HOST>
auto to_nearest_image(const DOMAIN_OF_HOST &d, double *v, long) -> decltype(d.minimum_image(v))
{
  d.minimum_image(v);
}

inline void to_nearest_image(const LAMMPS_NS::Domain &d, double *v) { to_nearest_image(d, v, 0); }

}    // namespace SPHTM_NS

#endif
