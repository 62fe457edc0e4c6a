/* SPH-TM: the loops of fix contact/tri over particles. */
#ifndef SPHTM_CONTACT_LOOPS_H
#define SPHTM_CONTACT_LOOPS_H

#include "backend.h"
#include "tm_contact_tri.h"
#include "tm_spread.h"
#include "tm_tool_move.h"

namespace SPHTM_NS {

struct ContactLoops {
  // effects: bits of tm_contact_effect; the sums are there once the backend has been waited for
  void (*contact)(Backend &, int n, const tm_contact_args &, unsigned effects, tm_contact_result *);
  void (*move)(Backend &, int n, const tm_tool_move_args &);
  int (*divide)(Backend &, int n, const tm_spread_args &);    // the first particle whose heat none takes, or n
  void (*collect)(Backend &, int n, const tm_spread_args &);

  static const ContactLoops &of(const Backend &);
  static const ContactLoops *kokkos;    // where this build has them
};

}    // namespace SPHTM_NS

#endif
