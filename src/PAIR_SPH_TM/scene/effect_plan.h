/* SPH-TM: which effects a scene calls for, and why. */
#ifndef SPHTM_EFFECT_PLAN_H
#define SPHTM_EFFECT_PLAN_H

#include "tm_effects.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace LAMMPS_NS {
class PairSPHTM;
}

namespace SPHTM_NS {

unsigned effect_by_name(const std::string &name);    // 0 when unknown
std::string effect_name(unsigned bits);              // of the first of these bits
std::string effect_names();                          // for messages
const std::vector<unsigned> &effects_by_name();      // all that have a name
const std::vector<unsigned> &effects_in_loops();     // those inside the loops of prediction, rates and update

struct EffectPlan {
  // in
  int dimension = 3;
  unsigned forced_on = 0, forced_off = 0;
  std::vector<std::pair<unsigned, std::string>> asked;    // by other fixes, with the reason
  // out
  unsigned effects = 0;
  std::vector<std::string> report;    // one line per effect: on or off, and why
  std::string heat_reason;            // why heat is on
  std::vector<std::string> warnings;
  std::string contradiction;          // what makes the set impossible, or empty

  void derive(const LAMMPS_NS::PairSPHTM &pair, int ntypes);

 private:
  void warn(const std::map<unsigned, std::string> &why, bool softens);
  void write_report(const std::map<unsigned, std::string> &why);
};

}    // namespace SPHTM_NS

#endif
