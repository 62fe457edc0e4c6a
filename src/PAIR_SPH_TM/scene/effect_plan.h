/* SPH-TM: which effects a scene calls for, and why. */
#ifndef SPHTM_EFFECT_PLAN_H
#define SPHTM_EFFECT_PLAN_H

#include "tm_effects.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace SPHTM_NS {

class Model;

unsigned effect_by_name(const std::string &name);    // 0 when unknown
std::string effect_name(unsigned bits);              // of the first of these bits
std::string effect_names();                          // for messages
const std::vector<unsigned> &effects_by_name();      // all that have a name
const std::vector<unsigned> &effects_in_loops();     // those inside the loops of prediction, rates and update

class EffectPlan {
 public:
  // the script turns effects on and off; other fixes ask for what they need, and say why
  void force(unsigned effect, bool on) { (on ? forced_on : forced_off) |= effect; }
  bool is_forced_on(unsigned effect) const { return (forced_on & effect) != 0; }
  unsigned contradicting() const { return forced_on & forced_off; }
  bool ask(unsigned effect, const std::string &reason);    // false: it was asked for already
  bool wants(unsigned effect) const { return ((effects | forced_on | asked_for) & effect) != 0; }

  // gradient correction and hourglass control have passes of their own, as total-Lagrangian pairs need it
  // (all_stored: of all particles for good, which need no hourglass control unless it is asked for)
  bool separate(bool all_stored)
  {
    const bool changed = !separate_passes || every_pair_stored != all_stored;
    separate_passes = true;
    every_pair_stored = all_stored;
    return changed;
  }

  // a fix bears no bulk viscosity of shocks unless it is asked for; false: that was known
  bool go_without_shock(const std::string &reason)
  {
    if (!no_shock.empty()) return false;
    no_shock = reason;
    return true;
  }

  void derive(const Model &, int dimension);

  unsigned effects = 0;
  std::vector<std::string> report;    // one line per effect: on or off, and why
  std::string heat_reason;            // why heat is on
  std::vector<std::string> warnings;
  std::string contradiction;    // what makes the set impossible, or empty
  double shock = 0.0;           // coefficient of the bulk viscosity in shocks, tm_shock.h

 private:
  bool separate_passes = false, every_pair_stored = false;
  unsigned forced_on = 0, forced_off = 0, asked_for = 0;
  std::vector<std::pair<unsigned, std::string>> asked;
  std::string no_shock;    // why the bulk viscosity of shocks is not on by itself
  void warn(const std::map<unsigned, std::string> &why, bool softens);
  void bulk_viscosity(const Model &, const std::string &shocked, bool lasting);
  void write_report(const std::map<unsigned, std::string> &why, const std::map<unsigned, std::string> &why_not);
};

}    // namespace SPHTM_NS

#endif
