/* SPH-TM: the loops of fix contact/tri over particles. See loop_table.h. */
#ifndef SPHTM_CONTACT_LOOPS_H
#define SPHTM_CONTACT_LOOPS_H

#include "loop_table.h"
#include "tm_contact_tri.h"
#include "tm_spread.h"
#include "tm_tool_move.h"

namespace SPHTM_NS {

struct HeatMessage {    // of values heat, those in the list are sent, or n from the first on received
  tm_real *heat;
  const int *list;
  double *buf;
};

#define CONTACT_LOOPS(LOOP)                                                                       \
  /* tm_contact_look(), beside loops that move nothing, before the contact loop of a step */      \
  LOOP(OWN, look, void, int n, const tm_contact_args &, unsigned effects)                         \
  /* effects: of tm_contact_effect; the result is there once the loop is waited for */            \
  LOOP(OWN, contact, void, int n, const tm_contact_args &, unsigned effects, tm_contact_result *) \
  /* tm_contact_late(); the result is there once the loop is waited for */                        \
  LOOP(OWN, late, void, int n, const tm_contact_args &, unsigned effects, tm_contact_result *)    \
  LOOP(EACH, move, tm_tool_move_args, tm_tool_move(i, &a))                                        \
  /* the first particle whose heat no other takes, or n, once the loop is waited for */           \
  LOOP(OWN, divide_heat, void, int n, const tm_spread_args &, unsigned effects, int *first)       \
  LOOP(OWN, collect_heat, void, int n, const tm_spread_args &, unsigned effects)                  \
  LOOP(EACH, send_heat, HeatMessage, a.buf[i] = a.heat[a.list[i]])                                \
  LOOP(EACH, receive_heat, HeatMessage, a.heat[i] = a.buf[i])

struct ContactLoops {
  SPHTM_LOOP_POINTERS(CONTACT_LOOPS)

  static const ContactLoops &of(const Backend &);
  static const ContactLoops *kokkos;    // where this build has them
};

// The contact loop is compiled for the sets of effects that most scenes have: run.template with<SET>(). SET 0 stands
// for the others, whose effects are tested at run time.
template <class RUN> void for_contact_set(unsigned effects, const RUN &run)
{
  constexpr unsigned D = TM_CT_3D, H = TM_CT_HEAT, F = TM_CT_FRICTION;
  switch (effects) {
    case F: return run.template with<F>();
    case H | F: return run.template with<H | F>();
    case D | F: return run.template with<D | F>();
    case D | H | F: return run.template with<D | H | F>();
    default: return run.template with<0u>();
  }
}

}    // namespace SPHTM_NS

#endif
