/* SPH-TM: how particles of two types meet, for all pairs of types: bonded, in contact, by heat alone or not at all.
   Pair style sph/tm fills it from its pair_coeff commands; Model keeps it. */
#ifndef SPHTM_PAIR_LAWS_H
#define SPHTM_PAIR_LAWS_H

#include "tm_body_contact.h"
#include "tm_material.h"

#include <utility>
#include <vector>

namespace SPHTM_NS {

// how particles of two types meet
enum Meeting { UNSET = 0, BOND, NONE, CONTACT, HEAT_ONLY };
// whether half a spacing at a contact strains; usual: of materials that flow
enum Layer { LAYER_OF_BODIES_USUAL = 0, LAYER_OF_BODIES_RIGID, LAYER_OF_BODIES_STRAINS };
struct PairLaw {
  Meeting meeting = UNSET;
  double conductance = 0.0;             // heat across the interface; 0: perfect
  double penalty = TM_PENALTY_USUAL;    // PFAC, see tm_contact_modulus()
  Layer layer = LAYER_OF_BODIES_USUAL;
  tm_body_law contact = {};    // Model::make_tables() sets the modulus
  bool has_friction() const { return contact.friction.n || contact.friction.value > 0.0; }
};

class PairLaws {
 public:
  void resize(int types);
  void set(int i, int j, const PairLaw &);    // and of j and i
  const PairLaw &operator()(int i, int j) const { return laws[i * n + j]; }
  // what the script left open: solids are one continuum, a conduction-only material meets all by perfect conduction;
  // returns the pairs that became one body so
  std::vector<std::pair<int, int>> complete(const tm_material *);

  // solids that the script lets pass through each other (none, heat)
  std::vector<std::pair<int, int>> that_pass(const tm_material *) const;
  bool has_contact() const;
  bool has_friction() const;                         // of bodies
  bool has_thermal() const;                          // that exchange heat and take no part in mechanics together
  bool of_one_density(const tm_material *) const;    // solids that are bonded
  // of types that may touch others: which side of i meets j, by type pair, from 1 on (0: no contact). Types that are
  // bonded are one body and meet on one side; returns the most sides of a type
  int contact_sides(std::vector<int> &) const;
  // per type pair: where in a row they meet; a contact pair that also conducts stands in two segments
  std::vector<unsigned char> segments(const tm_material *, bool conduction) const;

 private:
  int n = 0;    // types, and one
  std::vector<PairLaw> laws;
};

}    // namespace SPHTM_NS

#endif
