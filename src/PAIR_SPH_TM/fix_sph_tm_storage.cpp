/* SPH-TM: fix sph/tm, storage, migration and restart of the particle state. See doc/fix_sph_tm.rst. */
#include "fix_sph_tm.h"

#include "pair_sph_tm.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "update.h"

#include <cstring>

using namespace LAMMPS_NS;

void FixSPHTM::grow_arrays(int nmax) { fields.grow(nmax); }
void FixSPHTM::copy_arrays(int i, int j, int) { fields.copy(i, j); }
void FixSPHTM::set_arrays(int i) { fields.zero(i); }
int FixSPHTM::pack_exchange(int i, double *buf) { return fields.pack(i, buf); }
int FixSPHTM::unpack_exchange(int nlocal, double *buf) { return fields.unpack(nlocal, buf); }

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
  fields.unpack(nlocal, extra + m + 1);
}

int FixSPHTM::size_restart(int) { return fields.columns() + 1; }
int FixSPHTM::maxsize_restart() { return fields.columns() + 1; }

// global state: which fields the rows hold, the time step, the energy book (of all ranks)
namespace {
struct GlobalState {
  int version, fields, started, cause;
  double dt, dt_next;
  double book[sizeof(FixSPHTM::Ledger) / sizeof(double)];
};
}    // namespace

void FixSPHTM::write_restart(FILE *fp)
{
  GlobalState g = {};
  constexpr int n = sizeof(Ledger) / sizeof(double);
  MPI_Reduce(&ledger, g.book, n, MPI_DOUBLE, MPI_SUM, 0, world);
  if (comm->me) return;
  g.version = 1;
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
  if (g.version != 1) error->all(FLERR, "Fix sph/tm: restart data of version {}, 1 expected", g.version);
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
