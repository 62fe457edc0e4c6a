/* SPH-TM: what the sum of the energies says while a run goes on: how far it has drifted, and how much of what went in
   artificial terms have taken, both over what went in: the kinetic energy of the start, the work from outside, and where
   heat strains bodies the heat too. */
#ifndef SPHTM_ENERGY_WATCH_H
#define SPHTM_ENERGY_WATCH_H

#include <string>
#include <vector>

namespace SPHTM_NS {

class EnergyWatch {
 public:
  struct Energies {
    // shock: of artificial, the bulk viscosity of shocks, which have to dissipate; external: work, and heat that strains,
    // of all outside, without sign
    // left: with particles
    double kinetic, artificial, shock, external, left, sum;
    // work of the stress less what became plastic work, was lost in failure or is stored; its start is subtracted here
    double unstored;
  };
  static constexpr double DRIFT_WARNED = 0.01, ARTIFICIAL_WARNED = 0.02, ARTIFICIAL_SAID_AT_ONCE = 0.1,
                          UNEXPLAINED_WARNED = 0.02;
  static constexpr int LASTING = 10, STOPPING = 3;    // looks in a row: at a first touch little went in

  // at a set-up: what a script has given to or taken from particles since the last look is no drift. least: energy of
  // which nothing can be said
  void begin(const Energies &, double least);
  void look(const Energies &);
  // the look counts; last: of a run, where one is enough
  void count(bool last);
  bool says() const { return into > least; }
  double drift() const { return into > 0.0 ? drifted / into : 0.0; }      // over what went in
  double artificial() const { return into > 0.0 ? made / into : 0.0; }    // but in shocks
  // work of the stress that is neither stored nor dissipated, of what was said to be unstored
  double unexplained(double unstored) const { return begun ? unstored - base_unstored : 0.0; }
  double went_in() const { return into; }
  // a warning that is due, each once, or ""
  std::string warning();
  bool stops(double drift_allowed);    // asked once after each count
  std::string in_words() const;

  // of restart files
  static constexpr int VALUES = 10;
  std::vector<double> state() const;
  void restore(const double *);

 private:
  bool begun = false;
  double least = 0.0;
  double base = 0.0, given = 0.0;    // sum without drift; energy given at starts
  double most_work = 0.0;            // largest of what came from outside so far
  double last_kinetic = 0.0, last_sum = 0.0;
  double base_unstored = 0.0, last_unstored = 0.0;
  double drifted = 0.0, made = 0.0, shocked = 0.0, left = 0.0, into = 0.0;
  double said_at = 0.0;    // what had gone in when artificial terms were last warned of
  bool said_drift = false, said_artificial = false, said_astray = false;
  bool astray = false;                         // at the end of a run
  int drifting = 0, making = 0, beyond = 0;    // looks in a row
};

}    // namespace SPHTM_NS

#endif
