#include "neighbor_check.h"

#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix.h"
#include "modify.h"
#include "neighbor.h"
#include "utils.h"

#include <algorithm>
#include <climits>
#include <cmath>
#include <limits>
#include <string>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

namespace {
constexpr double UNKNOWN = std::numeric_limits<double>::infinity();
constexpr double ROUNDING = 1e-9;    // of the way, summed over the steps

// how the styles begin that move particles only as fix sph/tm and fix contact/tri say here, and those that act on forces
// or on nothing
const char *const OURS[] = {"sph/tm", "contact/tri"};
const char *const HARMLESS[] = {"adapt/neigh", "setforce", "addforce",  "aveforce",  "freeze",    "gravity", "viscous",
                                "drag",        "spring",   "indent",    "enforce2d", "ave/",      "print",   "halt",
                                "vector",      "store/",   "property/", "balance",   "controller"};

template <int N> bool is_among(const Fix &f, const char *const (&begins)[N])
{
  return std::any_of(begins, begins + N,
                     [&f](const char *b) { return utils::strmatch(f.style, std::string("^") + b); });
}
}    // namespace

// another fix that may change positions or velocities
bool NeighborCheck::others_move() const
{
  for (const auto &f : modify->get_fix_list())
    if (!is_among(*f, OURS) && (f->time_integrate || !is_among(*f, HARMLESS))) return true;
  return false;
}

void NeighborCheck::begin_run(double speed2, bool shifted)
{
  end_run();
  watching = !shifted && neighbor->dist_check && !domain->box_change && !domain->triclinic && !others_move();
  blind = !neighbor->dist_check && (neighbor->every > 1 || neighbor->delay > 1) && !domain->box_change && !told;
  delay_of_user = neighbor->delay;
  particles = tools = 0.0;
  set_speed(speed2);
}

void NeighborCheck::set_speed(double speed2)
{
  const double mine = sqrt(speed2);
  if (watching || blind) MPI_Allreduce(&mine, &speed, 1, MPI_DOUBLE, MPI_MAX, world);
}

void NeighborCheck::end_run()
{
  if (watching && neighbor && neighbor->delay == INT_MAX) neighbor->delay = delay_of_user;    // none where LAMMPS ends
  particles = tools = UNKNOWN;
}

void NeighborCheck::before_lists(double time)
{
  particles += speed * time;
  decide();
}

void NeighborCheck::of_tool(double way)
{
  tools += way;
  decide();
}

void NeighborCheck::decide()
{
  if (blind && !told && (particles > neighbor->skin || tools > neighbor->skin)) {
    told = true;
    if (comm->me == 0)
      error->warning(
          FLERR,
          "Pair sph/tm: lists of neighbors are renewed too late: particles may have moved by more than the skin, {:.4g}, "
          "since the last time, and 'neigh_modify check no' keeps LAMMPS from looking; write 'check yes'",
          neighbor->skin);
  }
  if (!watching) return;
  const bool none =
      particles < 0.5 * (1.0 - ROUNDING) * neighbor->skin && tools < 0.5 * (1.0 - ROUNDING) * neighbor->skin;
  neighbor->delay = none ? INT_MAX : delay_of_user;
}

void NeighborCheck::lists_renewed() { particles = tools = 0.0; }

void NeighborCheck::after_lists(double speed2, double time)
{
  set_speed(speed2);
  particles += speed * time;
}

}    // namespace SPHTM_NS
