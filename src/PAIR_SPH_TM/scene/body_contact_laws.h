/* SPH-TM: what follows from the materials of two types for their contact as bodies. */
#ifndef SPHTM_BODY_CONTACT_LAWS_H
#define SPHTM_BODY_CONTACT_LAWS_H

#include "pair_laws.h"

namespace SPHTM_NS {

class Model;

bool layer_strains(const Model &, int type, const PairLaw &);    // half a spacing of the type where it meets another
double contact_modulus_of_two(const Model &, int t, int u);      // of types in contact, see tm_contact_modulus_of_two()

}    // namespace SPHTM_NS

#endif
