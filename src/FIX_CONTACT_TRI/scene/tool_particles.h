/* SPH-TM: a tool that is filled with conduction-only particles: they move with it, and take its share of the friction
   heat. */
#ifndef SPHTM_TOOL_PARTICLES_H
#define SPHTM_TOOL_PARTICLES_H

#include "contact_loops.h"
#include "loop_array.h"

namespace LAMMPS_NS {
class Fix;
class LAMMPS;
}    // namespace LAMMPS_NS

namespace SPHTM_NS {

class Scene;

class ToolParticles {
 public:
  // of a type; of the particles of the fix, which sends their heat to ghosts by pack() and unpack()
  ToolParticles(LAMMPS_NS::Fix *f, int t) : fix(f), type(t) {}
  ~ToolParticles();
  ToolParticles(const ToolParticles &) = delete;
  ToolParticles &operator=(const ToolParticles &) = delete;
  void live_in(LAMMPS_NS::LAMMPS *, const Scene &);
  void move(const tm_pose &from, const tm_pose &to) const;
  // power into the tool, of each rubbing particle, set by the contact loop; what takes none of it is an error
  tm_real *heat_of_contact();
  void take_heat();
  void check_heat();    // once its loops have been waited for
  void pack(int n, const int *list, double *buf);
  void unpack(int n, int first, const double *buf);
  // the same where the loops run
  void send(int n, const int *list, double *buf);
  void receive(int n, int first, double *buf);
  double bytes() const { return (double) heat.bytes(); }

 private:
  LAMMPS_NS::Fix *fix;
  int type;
  LAMMPS_NS::LAMMPS *lmp = nullptr;
  const Scene *scene = nullptr;
  Backend *loops = nullptr;
  LoopArray<double> heat;
  int *untaken = nullptr;    // the first particle whose heat no other takes, of so many
  int untaken_of = 0;
};

}    // namespace SPHTM_NS

#endif
