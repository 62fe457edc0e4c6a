/* SPH-TM: which particles move, and which are at rest outside of the active region and sleep (tm_active.h): keyword
   active of fix sph/tm. Sorted anew every so many steps, in which LAMMPS renews its lists. */
#ifndef SPHTM_ACTIVE_REGION_H
#define SPHTM_ACTIVE_REGION_H

#include "active_loops.h"
#include "loop_array.h"
#include "row_search.h"
#include "tm_active.h"

#include "pointers.h"

#include <memory>
#include <string>

namespace LAMMPS_NS {
class Pair;
class Region;
}    // namespace LAMMPS_NS

namespace SPHTM_NS {

class Keywords;
class ParticleState;
class Scene;

class ActiveRegion : protected LAMMPS_NS::Pointers {
 public:
  ActiveRegion(LAMMPS_NS::LAMMPS *, ParticleState &, Backend &);

  void read(Keywords &);    // of fix sph/tm
  bool on() const { return every > 0; }
  void check(const Scene &, bool audits);    // before a run: what it does not work with
  // particles are sorted in this step, at the renewed lists
  bool due(LAMMPS_NS::bigint step) const { return on() && (!known || step % every == 0); }

  // the loops of a step: over all particles, or over those that do not sleep
  Backend &stepping() { return on() ? (Backend &) active : loops; }

  // in this order, where lists were renewed: who sleeps, and the rows of the others; once all have records
  void renew(const Scene &, LAMMPS_NS::Pair *);
  void insulate(const tm_records &);    // no heat is conducted into those that sleep
  // in each step: before the update, so that the edge stays; behind it
  void hold(double *force);
  void moved(const Scene &, double speed2, double dt);

  std::string in_words();    // mean shares of particles, for the table of a run; collective
  void restart_clock() { steps = sum_moving = sum_edge = at_rest = 0.0; }
  double bytes() const;

 private:
  ParticleState &state;
  Backend &loops;
  ActiveLoops active;
  std::unique_ptr<RowSearch> finder;
  // of the script
  std::string region_id;    // or empty: near a tool
  bool warned_speed = false;
  double distance = 0.0, still = 0.0;
  int every = 0;
  // of a run
  bool known = false;                  // particles were sorted once, here or before a restart
  double way = 0.0, tool_way = 0.0;    // of the fastest particle and tool since then, at most
  LoopArray<int> which, edge;          // those that do not sleep; of these those at the edge
  int awake = 0, at_edge = 0;          // so many
  LoopArray<tm_real> flag;
  LoopArray<unsigned char> marks;
  LoopArray<tm_tool_box> tools;
  double steps = 0.0, sum_moving = 0.0, sum_edge = 0.0, at_rest = 0.0;

  double reach() const;
  void check_way();
  const tm_real *kinds();
  void take_up_known();
  void look_for(tm_active_args &, const Scene &, LAMMPS_NS::Pair *, tm_real least);
  void decide(const Scene &, LAMMPS_NS::Pair *);
  void list();
};

}    // namespace SPHTM_NS

#endif
