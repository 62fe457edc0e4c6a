/* SPH-TM: fix sph/tm, storage, migration and restart of the particle state. See doc/fix_sph_tm.rst. */
#include "fix_sph_tm.h"

#include "pair_sph_tm.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "update.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

using namespace LAMMPS_NS;

void FixSPHTM::grow_arrays(int nmax) { fields.grow(nmax); }
void FixSPHTM::copy_arrays(int i, int j, int) { fields.copy(i, j); }
void FixSPHTM::set_arrays(int i) { fields.zero(i); }
int FixSPHTM::pack_exchange(int i, double *buf) { return fields.pack(i, buf); }
int FixSPHTM::unpack_exchange(int nlocal, double *buf) { return fields.unpack(nlocal, buf); }

// of the bits of a particle's row; the sum over the particles goes into the restart file
static uint64_t row_hash(const double *row, int n)
{
  uint64_t h = 1469598103934665603u;
  for (int k = 0; k < n; k++) {
    uint64_t bits;
    memcpy(&bits, row + k, sizeof(bits));
    h = (h ^ bits) * 1099511628211u;
    h ^= h >> 32;
  }
  return h;
}

int FixSPHTM::pack_restart(int i, double *buf)
{
  buf[0] = fields.columns() + 1;
  return 1 + fields.pack(i, buf + 1);
}

void FixSPHTM::unpack_restart(int nlocal, int nth)
{
  const double *extra = atom->extra[nlocal];
  int m = 0;
  for (int i = 0; i < nth; i++) m += static_cast<int>(extra[m]);
  if (static_cast<int>(extra[m]) != fields.columns() + 1)
    error->one(FLERR, "Fix sph/tm: restart file holds {} values per particle, {} expected",
               static_cast<int>(extra[m]) - 1, fields.columns());
  const double *row = extra + m + 1;
  for (int k = 0; k < fields.columns(); k++)
    if (!std::isfinite(row[k]))
      error->one(FLERR, "Fix sph/tm: the restart file is damaged, or was written after a fault: value {} of the "
                        "state of particle {} is not a finite number", k + 1, atom->tag[nlocal]);
  fields.unpack(nlocal, row);
  read.rows++;
  read.hash += row_hash(row, fields.columns());
}

// all rows that were written have been read, and are not what was written
void FixSPHTM::check_restart()
{
  uint64_t mine[2] = {read.rows, read.hash}, all[2];
  MPI_Allreduce(mine, all, 2, MPI_UINT64_T, MPI_SUM, world);
  if (all[0] > 0 && all[0] == read.rows_written && all[1] != read.hash_written)
    error->all(FLERR, "Fix sph/tm: the restart file is damaged: the state of its particles does not have the "
                      "checksum written with it");
  read = {};
}

int FixSPHTM::size_restart(int) { return fields.columns() + 1; }
int FixSPHTM::maxsize_restart() { return fields.columns() + 1; }

// global state: which fields the rows hold, the time step, the energy book (of all ranks)
namespace {
struct GlobalState {
  int version, fields, started, cause;
  uint64_t rows, hash;    // of the particles that follow
  double dt, dt_next;
  double book[sizeof(FixSPHTM::Ledger) / sizeof(double)];
};
}    // namespace

void FixSPHTM::write_restart(FILE *fp)
{
  GlobalState g = {};
  std::vector<double> row(fields.columns());
  uint64_t mine[2] = {(uint64_t) atom->nlocal, 0}, all[2];
  for (int i = 0; i < atom->nlocal; i++) {
    fields.pack(i, row.data());
    mine[1] += row_hash(row.data(), fields.columns());
  }
  MPI_Reduce(mine, all, 2, MPI_UINT64_T, MPI_SUM, 0, world);
  constexpr int n = sizeof(Ledger) / sizeof(double);
  MPI_Reduce(&ledger, g.book, n, MPI_DOUBLE, MPI_SUM, 0, world);
  if (comm->me) return;
  g.version = 2;
  g.rows = all[0];
  g.hash = all[1];
  g.fields = (int) fields.mask();
  g.started = started;
  g.cause = dt_cause;
  g.dt = dt;
  g.dt_next = dt_next;
  const int size = sizeof(g);
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(&g, sizeof(g), 1, fp);
}

void FixSPHTM::restart(char *buf)
{
  GlobalState g;
  memcpy(&g, buf, sizeof(g));
  if (g.version != 2) error->all(FLERR, "Fix sph/tm: restart data of version {}, 2 expected", g.version);
  read.rows_written = g.rows;
  read.hash_written = g.hash;
  fields.enable_mask((unsigned) g.fields, atom->nmax);
  maxexchange = fields.columns();
  started = g.started != 0;
  dt_cause = g.cause;
  dt = g.dt;
  dt_next = g.dt_next;
  update->update_time();    // the file has the time of an earlier step, which init would take for now
  if (comm->me == 0) memcpy(&ledger, g.book, sizeof(Ledger));
}

double FixSPHTM::memory_usage() { return fields.bytes() + source.bytes(); }
