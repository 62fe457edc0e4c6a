/* SPH-TM: times and memory of the parts of a run: the table at its end, and values of it while it goes on. */
#ifndef SPHTM_RUN_TABLE_H
#define SPHTM_RUN_TABLE_H

#include "lmptype.h"
#include "pointers.h"

#include <map>

namespace LAMMPS_NS {
class Fix;
}

namespace SPHTM_NS {

class AccuracyMeter;
class EnergyWatch;
class ParticleState;
class Scene;

class RunTable : protected LAMMPS_NS::Pointers {
 public:
  RunTable(LAMMPS_NS::LAMMPS *, const LAMMPS_NS::Fix &, ParticleState &, const Scene &);

  void want(bool table, bool waits);    // waits: for the loops at the end of each part
  void set_meter(AccuracyMeter *m) { meter = m; }
  void stop_clock() { timing = false; }    // the run's time begins with its first step
  bool start_clock();                      // false: it runs already
  bool is_timing() const { return timing; }
  LAMMPS_NS::bigint steps() const;    // since the clock was started
  void print(const EnergyWatch &, const std::string &fracture, const std::string &failed);
  // rows: all, rates, prediction and update, neighbor rows; columns: seconds, ns per particle and step
  double value(int row, int column);

 private:
  const LAMMPS_NS::Fix &fix;    // fix sph/tm
  ParticleState &state;
  const Scene &scene;
  AccuracyMeter *meter = nullptr;
  bool wanted = true, timing = false;
  LAMMPS_NS::bigint clock_step = 0;    // when the clock was set to 0

  std::map<unsigned, double> bytes_by_effect();
  std::map<unsigned, double> probe_effects(double seconds, LAMMPS_NS::bigint steps);
};

}    // namespace SPHTM_NS

#endif
