/* SPH-TM: fix sph/tm, storage, migration and restart of the particle state. See doc/fix_sph_tm.rst. */
#include "fix_sph_tm.h"

#include "pair_sph_tm.h"
#include "restart_block.h"
#include "restart_scan.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "modify.h"
#include "update.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

using namespace LAMMPS_NS;
using namespace SPHTM_NS;

// of the values of a particle in a restart file: their number and its ID
static constexpr int RESTART_HEAD = 2;

void FixSPHTM::grow_arrays(int nmax) { fields.grow(nmax); }
void FixSPHTM::copy_arrays(int i, int j, int) { fields.copy(i, j); }
void FixSPHTM::set_arrays(int i) { fields.zero(i); }
int FixSPHTM::pack_exchange(int i, double *buf) { return fields.pack(i, buf); }
int FixSPHTM::unpack_exchange(int nlocal, double *buf) { return fields.unpack(nlocal, buf); }

int FixSPHTM::pack_restart(int i, double *buf)
{
  buf[0] = fields.columns() + RESTART_HEAD;
  buf[1] = (double) atom->tag[i];
  return RESTART_HEAD + fields.pack(i, buf + RESTART_HEAD);
}

void FixSPHTM::unpack_restart(int nlocal, int nth)
{
  const double *extra = atom->extra[nlocal];
  int m = 0;
  for (int i = 0; i < nth; i++) m += static_cast<int>(extra[m]);
  if (static_cast<int>(extra[m]) != fields.columns() + RESTART_HEAD)
    error->one(FLERR, "Fix sph/tm {}: the {} holds {} values per particle, {} expected", id, restart_file_name(lmp),
               static_cast<int>(extra[m]) - RESTART_HEAD, fields.columns());
  if (extra[m + 1] != (double) atom->tag[nlocal])    // LAMMPS does not move these values with the particles
    error->one(FLERR, "Fix sph/tm {}: particle {} stands where the {} has the state of particle {}: the file is damaged, or "
                      "particles were deleted, sorted or given other IDs after read_restart; write the fixes first", id,
               atom->tag[nlocal], restart_file_name(lmp), extra[m + 1]);
  const double *row = extra + m + RESTART_HEAD;
  for (int k = 0; k < fields.columns(); k++)
    if (!std::isfinite(row[k]))
      error->one(FLERR, "Fix sph/tm {}: the {} is damaged, or was written after a fault: value {} of the state of "
                        "particle {} is not a finite number", id, restart_file_name(lmp), k + 1, atom->tag[nlocal]);
  fields.unpack(nlocal, row);
  read.rows++;
  read.hash += hash_bytes(row, fields.columns() * sizeof(double));
}

// the rows that were written have been read, as they were written
void FixSPHTM::check_restart()
{
  uint64_t mine[2] = {read.rows, read.hash}, all[2];
  MPI_Allreduce(mine, all, 2, MPI_UINT64_T, MPI_SUM, world);
  if (read.rows_written > 0 && all[0] == 0)
    error->all(FLERR, "Fix sph/tm {}: the {} does not hold the state of its particles", id, restart_file_name(lmp));
  if (all[0] > 0 && all[0] == read.rows_written && all[1] != read.hash_written)
    error->all(FLERR, "Fix sph/tm {}: the {} is damaged: the state of its particles does not have the checksum written "
                      "with it", id, restart_file_name(lmp));
  read = {};
}

int FixSPHTM::size_restart(int) { return fields.columns() + RESTART_HEAD; }
int FixSPHTM::maxsize_restart() { return fields.columns() + RESTART_HEAD; }

// global state: the rows of all particles, which fields they hold, who made their sizes, the time step, the energies
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
  BOOK
};
constexpr int BOOK_VALUES = sizeof(FixSPHTM::Ledger) / sizeof(double), WATCH = BOOK + BOOK_VALUES,
              VALUES = WATCH + EnergyWatch::VALUES;
constexpr double THIS_VERSION = 3.0;
}    // namespace

void FixSPHTM::write_restart(FILE *fp)
{
  host_particles();
  const RowsHash whole = rows_hash(lmp);
  std::vector<double> row(fields.columns());
  uint64_t mine[2] = {(uint64_t) atom->nlocal, 0}, all[2];
  for (int i = 0; i < atom->nlocal; i++) {
    fields.pack(i, row.data());
    mine[1] += hash_bytes(row.data(), fields.columns() * sizeof(double));
  }
  MPI_Reduce(mine, all, 2, MPI_UINT64_T, MPI_SUM, 0, world);
  Ledger book;
  MPI_Reduce(&ledger, &book, BOOK_VALUES, MPI_DOUBLE, MPI_SUM, 0, world);
  if (comm->me) return;
  std::vector<double> value;
  append_rows_hash(value, whole);
  value.push_back(THIS_VERSION);
  append_bits(value, all[0]);
  append_bits(value, all[1]);
  value.insert(value.end(),
               {(double) fields.mask(), (double) started, (double) sized_by(), (double) dt_cause,
                dt, dt_next});
  const auto *sums = (const double *) &book;
  value.insert(value.end(), sums, sums + BOOK_VALUES);
  const std::vector<double> watched = energy_watch.state();
  value.insert(value.end(), watched.begin(), watched.end());
  write_restart_block(fp, value);
}

void FixSPHTM::restart(char *buf)
{
  const std::vector<double> v = read_restart_block(lmp, fmt::format("Fix sph/tm {}", id), buf, VERSION + 1, 1000);
  const bool fits = v[VERSION] == THIS_VERSION && v.size() == VALUES && v[FIELDS] >= 0 &&
      v[FIELDS] < (1u << TM_F_COUNT) && v[CAUSE] >= 0 && v[CAUSE] < TM_DT_CAUSES;
  if (!fits)
    error->all(FLERR, "Fix sph/tm {}: the {} was written by another version of the plugin", id, restart_file_name(lmp));
  read.rows_written = take_bits(&v[ROWS]);
  read.hash_written = take_bits(&v[HASH]);
  fields.enable_mask((unsigned) v[FIELDS], atom->nmax);
  maxexchange = fields.columns();
  started = v[STARTED] != 0.0;
  in_file = true;
  sized_in_file = (int) v[SIZED_BY];
  dt_cause = (int) v[CAUSE];
  dt = v[DT];
  dt_next = v[DT_NEXT];
  update->update_time();    // the file has the time of an earlier step, which init would take for now
  energy_watch.restore(&v[WATCH]);
  if (comm->me == 0) memcpy((void *) &ledger, &v[BOOK], sizeof(Ledger));
}

// which parts of fix adapt/neigh give particles sizes of their own
int FixSPHTM::sized_by() const
{
  int parts = 0, dim;
  for (Fix *f : modify->get_fix_by_style("^adapt/neigh")) {
    if (f->extract(SmoothingRule::NAME, dim)) parts |= SIZED_BY_ASPH;
    if (f->extract("level", dim)) parts |= SIZED_BY_REFINE;
  }
  return parts;
}

// a run that goes on without what made its sizes would have others
void FixSPHTM::check_sizes_of_file()
{
  const int missing = sized_in_file & ~sized_by();
  sized_in_file = 0;
  const bool frozen = (forced_on & TM_FX_SMOOTHING) != 0;    // lengths may stay as they are; masses are the fix's
  const bool refined = (missing & SIZED_BY_REFINE) != 0;
  if (!refined && (!missing || frozen)) return;
  error->all(FLERR, "Fix sph/tm {}: the {} is of a run with fix adapt/neigh {}, which {}; write that fix too, with the "
                    "same keywords{}", id, restart_file_name(lmp), refined ? "refine" : "asph",
             refined ? "split its particles" : "set its smoothing lengths",
             refined ? "" : ", or 'effects smoothing on' to go on with the lengths as they are");
}

// called by write_data on the first rank
void FixSPHTM::write_data_header(FILE *, int)
{
  if (!started || data_warned) return;
  data_warned = true;
  error->warning(
      FLERR,
      "Fix sph/tm {}: write_data writes positions and velocities, not the state of the particles "
      "(stress, "
      "density, plastic strain, temperature): what reads the file starts from an unstressed body; "
      "write_restart writes all",
      id);
}

double FixSPHTM::memory_usage() { return fields.bytes() + source.bytes(); }
