#include "state_restart.h"

#include "restart_block.h"
#include "restart_scan.h"
#include "scene.h"

#include "atom.h"
#include "comm.h"
#include "error.h"

#include <cmath>
#include <cstdint>
#include <vector>

using namespace LAMMPS_NS;

namespace SPHTM_NS {

// of the values of a particle in a restart file: their number and its ID
static constexpr int RESTART_HEAD = 2;

StateRestart::StateRestart(LAMMPS *lmp, ParticleState &s, const Scene &sc) : Pointers(lmp), state(s), scene(sc) {}

int StateRestart::size() const { return state.fields().columns() + RESTART_HEAD; }

int StateRestart::pack(int i, double *buf)
{
  buf[0] = state.fields().columns() + RESTART_HEAD;
  buf[1] = (double) atom->tag[i];
  return RESTART_HEAD + state.fields().pack(i, buf + RESTART_HEAD);
}

void StateRestart::unpack(int nlocal, int nth)
{
  const double *extra = atom->extra[nlocal];
  int m = 0;
  for (int i = 0; i < nth; i++) m += static_cast<int>(extra[m]);
  if (static_cast<int>(extra[m]) != state.fields().columns() + RESTART_HEAD)
    error->one(FLERR, "Fix sph/tm {}: the {} holds {} values per particle, {} expected", state.id(),
               restart_file_name(lmp), static_cast<int>(extra[m]) - RESTART_HEAD, state.fields().columns());
  if (extra[m + 1] != (double) atom->tag[nlocal])    // LAMMPS does not move these values with the particles
    error->one(FLERR,
               "Fix sph/tm {}: particle {} stands where the {} has the state of particle {}: the file is damaged, or "
               "particles were deleted, sorted or given other IDs after read_restart; write the fixes first",
               state.id(), atom->tag[nlocal], restart_file_name(lmp), extra[m + 1]);
  const double *row = extra + m + RESTART_HEAD;
  for (int k = 0; k < state.fields().columns(); k++)
    if (!std::isfinite(row[k]))
      error->one(FLERR,
                 "Fix sph/tm {}: the {} is damaged, or was written after a fault: value {} of the state of "
                 "particle {} is not a finite number",
                 state.id(), restart_file_name(lmp), k + 1, atom->tag[nlocal]);
  state.fields().unpack(nlocal, row);
  read_.rows++;
  read_.hash += hash_bytes(row, state.fields().columns() * sizeof(double));
}

// the rows that were written have been read, as they were written
void StateRestart::check_rows()
{
  uint64_t mine[2] = {read_.rows, read_.hash}, all[2];
  MPI_Allreduce(mine, all, 2, MPI_UINT64_T, MPI_SUM, world);
  if (read_.rows_written > 0 && all[0] == 0)
    error->all(FLERR, "Fix sph/tm {}: the {} does not hold the state of its particles", state.id(),
               restart_file_name(lmp));
  if (all[0] > 0 && all[0] == read_.rows_written && all[1] != read_.hash_written)
    error->all(FLERR,
               "Fix sph/tm {}: the {} is damaged: the state of its particles does not have the checksum written "
               "with it",
               state.id(), restart_file_name(lmp));
  read_ = {};
}

// global state: the rows of all particles, which fields they hold, what made their sizes, the time step, the energies
namespace {
enum {
  VERSION = ROWS_HASH_VALUES,
  ROWS,
  HASH = ROWS + 2,
  FIELDS = HASH + 2,
  STARTED,
  SIZED_BY,
  CAUSE,
  DT,
  DT_NEXT,
  TIME_SCALE,
  BALANCE
};
constexpr int BALANCE_VALUES = EnergyBalance::TERMS, WATCH = BALANCE + BALANCE_VALUES,
              VALUES = WATCH + EnergyWatch::VALUES;
constexpr double THIS_VERSION = 6.0;
}    // namespace

void StateRestart::write(FILE *fp, EnergyWatch &energy_watch)
{
  state.atoms().to_host();
  const RowsHash whole = rows_hash(lmp);
  std::vector<double> row(state.fields().columns());
  uint64_t mine[2] = {(uint64_t) atom->nlocal, 0}, all[2];
  for (int i = 0; i < atom->nlocal; i++) {
    state.fields().pack(i, row.data());
    mine[1] += hash_bytes(row.data(), state.fields().columns() * sizeof(double));
  }
  MPI_Reduce(mine, all, 2, MPI_UINT64_T, MPI_SUM, 0, world);
  double sums[EnergyBalance::TERMS];
  MPI_Reduce(state.energy().values(), sums, BALANCE_VALUES, MPI_DOUBLE, MPI_SUM, 0, world);
  if (comm->me) return;
  const TimeStep &step = state.time_step();
  std::vector<double> value;
  append_rows_hash(value, whole);
  value.push_back(THIS_VERSION);
  append_bits(value, all[0]);
  append_bits(value, all[1]);
  value.insert(value.end(), {(double) state.fields().mask(), (double) state.history().begun(), (double) sized_by(),
                             (double) step.cause(), step.now(), step.next(), scene.time_scale()});
  value.insert(value.end(), sums, sums + BALANCE_VALUES);
  const std::vector<double> watched = energy_watch.state();
  value.insert(value.end(), watched.begin(), watched.end());
  const tm_start_temperatures &start = state.start_temperatures().all();    // that wait for the next run
  if (start.n) value.push_back(start.n);
  for (int g = 0; g < start.n; g++) value.insert(value.end(), {(double) (unsigned) start.bit[g], start.of[g]});
  write_restart_block(fp, value);
}

void StateRestart::read(char *buf, EnergyWatch &energy_watch)
{
  const std::vector<double> v =
      read_restart_block(lmp, fmt::format("Fix sph/tm {}", state.id()), buf, VERSION + 1, 1000);
  const double waiting = v.size() > VALUES ? v[VALUES] : 0.0;    // groups whose temperature waits for a run
  const bool fits = v[VERSION] == THIS_VERSION && v.size() == VALUES + (waiting > 0.0 ? 1 + 2 * waiting : 0.0) &&
                    v[FIELDS] >= 0 && v[FIELDS] < (1u << TM_F_COUNT) && v[CAUSE] >= 0 &&
                    v[CAUSE] < (double) TM_DT_CAUSES;
  if (!fits)
    error->all(FLERR, "Fix sph/tm {}: the {} was written by another version of the plugin", state.id(),
               restart_file_name(lmp));
  read_.rows_written = take_bits(&v[ROWS]);
  read_.hash_written = take_bits(&v[HASH]);
  state.fields().enable_mask((unsigned) v[FIELDS], atom->nmax);
  state.history().restore(v[STARTED] != 0.0);
  sized_in_file = (int) v[SIZED_BY];
  state.time_step().restore(v[DT], v[DT_NEXT], (int) v[CAUSE]);
  energy_watch.restore(&v[WATCH]);
  if (v[TIME_SCALE] != scene.time_scale() && comm->me == 0)
    error->warning(
        FLERR,
        "Fix sph/tm {}: the {} was written with time/scale {:.8g}, this run has {:.8g}: heat passes at another "
        "rate",
        state.id(), restart_file_name(lmp), v[TIME_SCALE], scene.time_scale());
  for (int g = 0; g < (int) waiting; g++)
    state.start_temperatures().set_group((int) (unsigned) v[VALUES + 1 + 2 * g], v[VALUES + 2 + 2 * g]);
  if (waiting > 0.0) state.need(TM_FX_HEAT, "temperature of a group was set before the restart file was written");
  if (comm->me == 0) state.energy().restore(&v[BALANCE]);
}

// which parts of fix adapt/neigh give particles sizes of their own
int StateRestart::sized_by() const
{
  const Scene::Adaptation &a = scene.adaptation();
  return (a.smoothing ? SIZED_BY_ASPH : 0) | (a.levels ? SIZED_BY_REFINE : 0);
}

// a run that goes on without what made its sizes would have others
void StateRestart::check_sizes()
{
  const int missing = sized_in_file & ~sized_by();
  sized_in_file = 0;
  const bool frozen =
      state.effect_plan().is_forced_on(TM_FX_SMOOTHING);    // lengths may stay as they are; masses are the fix's
  const bool refined = (missing & SIZED_BY_REFINE) != 0;
  if (!refined && (!missing || frozen)) return;
  error->all(FLERR,
             "Fix sph/tm {}: the {} is of a run with fix adapt/neigh {}, which {}; write that fix too, with the "
             "same keywords{}",
             state.id(), restart_file_name(lmp), refined ? "refine" : "asph",
             refined ? "split its particles" : "set its smoothing lengths",
             refined ? "" : ", or 'effects smoothing on' to go on with the lengths as they are");
}

}    // namespace SPHTM_NS
