/* SPH-TM: what has happened to the particles so far. */
#ifndef SPHTM_RUN_HISTORY_H
#define SPHTM_RUN_HISTORY_H

namespace SPHTM_NS {

class RunHistory {
 public:
  bool begun() const { return started; }    // has taken a step, here or before a restart
  void begin() { started = true; }
  bool restored() const { return from_file; }    // from a restart file
  void restore(bool begun)
  {
    from_file = true;
    started = begun;
  }
  bool moved_since_last_run() const { return moved; }    // particles came, went or were moved between the runs
  void set_moved(bool m) { moved = m; }
  bool has_forces() const { return forces; }    // of a set-up or step
  void set_forces() { forces = true; }

 private:
  bool started = false, from_file = false, moved = false, forces = false;
};

}    // namespace SPHTM_NS

#endif
