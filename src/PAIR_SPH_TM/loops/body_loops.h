/* SPH-TM: the loops of contact between bodies over particles, in this order. See loop_table.h. */
#ifndef SPHTM_BODY_LOOPS_H
#define SPHTM_BODY_LOOPS_H

#include "loop_table.h"
#include "tm_body_contact.h"

namespace SPHTM_NS {

struct BodyContactLoop {
  tm_rates_args rates;
  tm_body_contact_args contact;
};

#define BODY_LOOPS(LOOP)                                                            \
  LOOP(EACH, ahead, tm_ahead_args, tm_body_ahead(i, &a, effects))                   \
  LOOP(EACH, thin, BodyContactLoop, tm_body_thin(i, &a.rates, &a.contact, effects)) \
  LOOP(SUM, touch, BodyContactLoop, tm_body_contact_result, tm_body_contact,        \
       tm_body_touch(i, &a.rates, &a.contact, effects))                             \
  LOOP(SUM, contact, BodyContactLoop, tm_body_contact_result, tm_body_contact,      \
       (a.rates.rows.contact[i] ? tm_body_contact(i, &a.rates, &a.contact, effects) : tm_body_contact_nothing()))

struct BodyLoops {
  SPHTM_LOOP_POINTERS(BODY_LOOPS)

  static const BodyLoops &of(const Backend &);
  static const BodyLoops *kokkos;    // where this build has them
};

}    // namespace SPHTM_NS

#endif
