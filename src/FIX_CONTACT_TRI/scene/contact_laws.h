/* SPH-TM: the contact law of each particle type, and what follows from all of them. */
#ifndef SPHTM_CONTACT_LAWS_H
#define SPHTM_CONTACT_LAWS_H

#include "loop_array.h"
#include "tm_contact.h"

#include <vector>

namespace SPHTM_NS {

struct ContactSettings;
class Model;

// whether the half spacing between a tool and the centers of particles of a type takes part in their strain
bool layer_strains(const ContactSettings &, const Model &, int type);
// what takes the place of E in F15 (10) against a tool
double tool_modulus(const ContactSettings &, const Model &, int type, double penalty);

class ContactLaws {
 public:
  void live_in(Backend &loops) { loop_laws.live_in(loops); }
  void make(const ContactSettings &, const Model &, double T, int dimension);
  const tm_contact_law &of(int type) const { return laws[type]; }
  const tm_contact_law *host_read() const { return laws.data(); }    // index type
  const tm_contact_law *loop_read() { return loop_laws.loop_read(); }
  double stable_dt() const { return dt_limit; }     // of the contact springs
  double heat_dt() const { return heat_limit; }     // of the exchange of heat with the tool, for its accuracy
  double sound_speed() const { return fastest; }    // of the fastest solid, 0: there is none

 private:
  std::vector<tm_contact_law> laws;
  LoopArray<tm_contact_law> loop_laws;
  double dt_limit = 0.0, heat_limit = 1e300, fastest = 0.0;
};

}    // namespace SPHTM_NS

#endif
