#include "fracture_watch.h"

#include "scene.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "update.h"

#include <algorithm>
#include <climits>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

FractureWatch::FractureWatch(LAMMPS *lmp, ParticleState &s, const Scene &sc) :
    Pointers(lmp), state(s), scene(sc), known(s.loops())
{
}

tm_fracture_args FractureWatch::args()
{
  const Settings &set = state.model().settings_in_use();
  tm_fracture_args a;
  a.state = state.arrays();
  a.rows = scene.results().rate_args().rows;
  a.rec = scene.results().records();
  a.tag = scene.rows().loop_tags();
  a.known = known.loop_write();
  std::copy_n(period, 3, a.period);
  a.spacing = set.spacing;
  a.h = set.h;
  a.support = tm_kernel_support(set.kernel);
  a.dim3 = domain->dimension == 3;
  return a;
}

// references and failure to the ghosts
void FractureWatch::tell(Pair *pair)
{
  known.make_room(true, TM_FRACTURE_KNOWN * ((size_t) atom->nlocal + atom->nghost + 1));
  PairLoops::of(state.loops()).fracture_tell(state.loops(), atom->nlocal, args(), state.effects());
  scene.results().communicate(pair, known, TM_FRACTURE_KNOWN);
}

// The present places are the reference of all, where one has none, or particles were added, removed, split or merged.
bool FractureWatch::refer(Pair *pair)
{
  const PairLoops &loops = PairLoops::of(state.loops());
  const double unknown = loops.fracture_unknown(state.loops(), atom->nlocal, args(), state.effects());
  const long remaps = state.energy().remapped();
  double mine[2] = {unknown, (double) (remaps - remapped)}, all[2];
  MPI_Allreduce(mine, all, 2, MPI_DOUBLE, MPI_SUM, world);
  const bool other = particles >= 0 && particles != atom->natoms;
  remapped = remaps;
  particles = atom->natoms;
  const double *length = domain->prd;
  const int periodic[3] = {domain->xperiodic, domain->yperiodic, domain->zperiodic};
  const bool anew = all[0] > 0.0 || all[1] > 0.0 || other;
  if (anew || period[0] + period[1] + period[2] == 0.0)
    for (int d = 0; d < 3; d++) period[d] = periodic[d] ? length[d] : 0.0;
  if (!anew) return false;
  loops.fracture_refer(state.loops(), atom->nlocal, args(), state.effects());
  tell(pair);
  loops.fracture_bonds(state.active().stepping(), atom->nlocal, args(), state.effects());
  return true;
}

void FractureWatch::begin(Pair *pair)
{
  if (!state.has(TM_FX_FRACTURE)) return;
  refer(pair);
  reported = reported || torn() > 0.0;    // before this run
}

void FractureWatch::look(Pair *pair)
{
  if (!state.has(TM_FX_FRACTURE) || scene.rows().keeps_all()) return;    // pairs that are kept hold at any distance
  const auto timed = state.clock().timed_rarely(RunClock::FRACTURE);
  if (refer(pair)) return;
  tell(pair);
  if (!meeting_reported) {
    PairLoops::of(state.loops()).fracture_normal(state.active().stepping(), atom->nlocal, args(), state.effects());
    scene.results().communicate(pair, known, TM_FRACTURE_KNOWN);
  }
  const tm_fracture_result mine =
      PairLoops::of(state.loops()).fracture_look(state.active().stepping(), atom->nlocal, args(), state.effects());
  if (reported && meeting_reported) return;
  const int tags[2] = {mine.first, mine.first_met};
  int least[2];
  MPI_Allreduce(tags, least, 2, MPI_INT, MPI_MIN, world);
  if (least[0] < INT_MAX && !reported) report(least[0]);
  if (least[1] == INT_MAX || meeting_reported) return;
  double met;
  MPI_Allreduce(&mine.met, &met, 1, MPI_DOUBLE, MPI_SUM, world);
  if (met < TM_FRACTURE_MEETINGS) return;
  int other = mine.first_met == least[1] ? mine.other : INT_MAX;
  MPI_Allreduce(MPI_IN_PLACE, &other, 1, MPI_INT, MPI_MIN, world);
  report_meeting(least[1], other);
}

// the particle of this tag, from the rank that owns it
std::string FractureWatch::particle(int tag)
{
  enum { TYPE, X, DAMAGE = X + 3, STRAIN, VALUES };
  double mine[VALUES] = {}, all[VALUES];
  state.atoms().to_host_in_step();
  for (int i = 0; i < atom->nlocal; i++) {
    if (atom->tag[i] != tag) continue;
    const double *damage = state.field(TM_F_DAMAGE), *strain = state.field(TM_F_PSTRAIN);
    mine[TYPE] = atom->type[i];
    std::copy_n(atom->x[i], 3, mine + X);
    mine[DAMAGE] = damage ? damage[2 * (size_t) i] : 0.0;
    mine[STRAIN] = strain ? strain[3 * (size_t) i] : 0.0;
  }
  MPI_Allreduce(mine, all, VALUES, MPI_DOUBLE, MPI_SUM, world);
  return fmt::format("at step {}, time {:.6g}: particle {} (type {}) at {:.6g} {:.6g} {:.6g}, damage {:.3g}, plastic "
                     "strain {:.3g}",
                     update->ntimestep, update->atime + (update->ntimestep - update->atimestep) * update->dt, tag,
                     (int) all[TYPE], all[X], all[X + 1], all[X + 2], all[DAMAGE], all[STRAIN]);
}

void FractureWatch::report(int tag)
{
  first = particle(tag);
  reported = true;
  if (comm->me == 0)
    error->warning(
        FLERR,
        "Fix sph/tm {}: numerical fracture: a particle has lost its neighbors on one side, and none of them "
        "has failed by damage; {}. What is pulled, not cut, keeps them with 'fix ID all adapt/neigh threshold "
        "inf'",
        state.id(), first);
}

void FractureWatch::report_meeting(int tag, int other)
{
  const std::string where = particle(tag);
  meeting_reported = true;
  if (comm->me == 0)
    error->warning(
        FLERR,
        "Fix sph/tm {}: two faces of one body are within reach of each other, {}, before particle {}. There is no contact inside of "
        "a body: from {:.2g} spacings of free space on they drag each other, and weld. Parts that meet and part again "
        "want types of their own, with 'pair_coeff I J contact'",
        state.id(), where, other,
        tm_kernel_support(state.model().settings_in_use().kernel) * state.model().settings_in_use().ratio - 1.0);
}

double FractureWatch::torn()
{
  if (!state.has(TM_FX_FRACTURE)) return 0.0;
  double all, mine = PairLoops::of(state.loops()).fracture_torn(state.loops(), atom->nlocal, args(), state.effects());
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return all;
}

std::string FractureWatch::failed_in_words()
{
  if (!state.has(TM_FX_DAMAGE)) return "";
  const double *damage = state.field(TM_F_DAMAGE);
  bigint mine = 0, all;
  for (int i = 0; i < atom->nlocal; i++) mine += damage[2 * (size_t) i + 1] > 0.5;
  MPI_Allreduce(&mine, &all, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  return all ? fmt::format("{} of {} particles", all, atom->natoms) : "no particle";
}

std::string FractureWatch::in_words()
{
  if (!state.has(TM_FX_FRACTURE)) return "";
  const double number = torn();
  if (number == 0.0) return "none (no particle has lost its neighbors on one side)";
  return fmt::format("{:.0f} of {} particles; {}", number, atom->natoms,
                     first.empty() ? "the first before this run" : "the first " + first);
}

}    // namespace SPHTM_NS
