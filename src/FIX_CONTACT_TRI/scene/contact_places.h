/* SPH-TM: where particles touch a tool, between the look for it and the forces of a step (tm_contact_look()). */
#ifndef SPHTM_CONTACT_PLACES_H
#define SPHTM_CONTACT_PLACES_H

#include "loop_array.h"
#include "tm_contact_tri.h"

#include <algorithm>
#include <climits>

namespace SPHTM_NS {

class ContactPlaces {
 public:
  void live_in(Backend &b)
  {
    place.live_in(b);
    taken.live_in(b);
    touch.live_in(b);
    for (auto *a : {&place, &taken}) a->call("places of contact");
    touch.call("places of contact");
  }

  // for a look among n particles: a quarter of them has room to touch; the others look when the forces are made
  tm_contact_found begin(int n)
  {
    const int room = std::min(n / 4 + 1024, INT_MAX / TM_FOUND);
    place.make_room(true, n + 1);
    taken.make_room(true, 1);
    touch.make_room(true, room);
    found = {place.loop_write(), touch.loop_write(), taken.loop_write(), room};
    return found;
  }
  // for the forces: what the look of this step has found, once
  tm_contact_found take()
  {
    const tm_contact_found looked = found;
    found = {};
    return looked;
  }
  double bytes() const { return (double) (place.bytes() + taken.bytes() + touch.bytes()); }

 private:
  LoopArray<int> place, taken;
  LoopArray<tm_touch> touch;
  tm_contact_found found = {};
};

}    // namespace SPHTM_NS

#endif
