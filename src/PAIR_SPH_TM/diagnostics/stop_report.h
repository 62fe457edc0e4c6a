/* SPH-TM: states that cannot go on: which particle, where, what is wrong, and the likely cause. */
#ifndef SPHTM_STOP_REPORT_H
#define SPHTM_STOP_REPORT_H

#include "tm_update.h"

#include "pointers.h"

#include <string>

namespace SPHTM_NS {

class ParticleState;
class Scene;

class StopReport : protected LAMMPS_NS::Pointers {
 public:
  StopReport(LAMMPS_NS::LAMMPS *, ParticleState &, const Scene &);

  // of the script: the largest temperature and ratio of densities that go on
  void set_hottest(double T) { hottest_given = T; }
  void set_densest(double ratio) { densest = ratio; }
  void temperatures_were_set() { temperature_set = true; }    // by fix_modify

  void init();
  void limit(tm_update_args &) const;       // what goes on
  void stop_on_lost(int i, double gone);    // a particle beyond a fixed boundary
  void warn_of_melting(int i);              // once a rank
  void stop_on(const tm_update_result &);

 private:
  ParticleState &state;
  const Scene &scene;
  double hottest_given = 0.0, hottest = 1e300;
  double densest = 3.0;    // over the reference density or under it by more stops the run
  bool temperature_set = false, melt_reported = false;

  bool scene_has(const char *fix_style) const;
  std::string surroundings(int i, bool &torn);
  bool most_by_conduction(int i);
  std::string likely_cause(int i, int status);
};

}    // namespace SPHTM_NS

#endif
