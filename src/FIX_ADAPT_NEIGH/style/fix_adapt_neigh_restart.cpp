/* SPH-TM: fix adapt/neigh, restart files. */
#include "fix_adapt_neigh.h"

#include "adapt_part.h"
#include "restart_block.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "modify.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace SPHTM_NS;

static constexpr size_t MOST_STATE = 128;    // values of all parts in a restart file
static constexpr int RESTART_HEAD = 5;       // of the values of a particle in a restart file

// number of values, ID and position of the particle, values
int FixAdaptNeigh::pack_restart(int i, double *buf)
{
  buf[1] = (double) atom->tag[i];
  std::copy_n(atom->x[i], 3, buf + 2);
  const int m = RESTART_HEAD + pack_exchange(i, buf + RESTART_HEAD);
  buf[0] = m;
  return m;
}
// the values of this fix, the nth of those that the file has for owned particle i: their number, then they
const double *FixAdaptNeigh::restart_row(int i, int nth)
{
  const double *extra = atom->extra[i];
  int m = 0;
  for (int k = 0;; k++) {
    const int left = atom->nextra_store - m;
    if (left < 1 || !is_whole(extra[m], 1, left))
      error->one(FLERR, "Fix adapt/neigh: the {} is damaged: the values of particle {} have no proper length",
                 restart_file_name(lmp), atom->tag[i]);
    if (k == nth) return extra + m;
    m += (int) extra[m];
  }
}

// of the values of particles in a restart file: LAMMPS's fixes, and those that parts add, rely on them
void FixAdaptNeigh::check_lengths()
{
  const int fixes = atom->nextra_store ? modify->nfix_restart_peratom : 0;
  for (int i = 0; fixes && i < atom->nlocal; i++) restart_row(i, fixes - 1);
}

void FixAdaptNeigh::unpack_restart(int i, int nth)
{
  const double *row = restart_row(i, nth), *at = row + RESTART_HEAD;
  const double *end = row + (int) *row;
  for (const ParticleValues *v : parts.values()) {
    std::string why;
    const int n = v->check(at, (int) (end - at), why);
    if (n < 0)
      error->one(FLERR,
                 "Fix adapt/neigh: particle {} in the {} has {}: it is damaged, or was written with other "
                 "keywords; write the same ones",
                 atom->tag[i], restart_file_name(lmp), why);
    at += n;
  }
  if (at > end || !is_whole(row[1], 1, MAXSMALLINT)) refuse_restart();
  if (at != end)
    error->one(FLERR,
               "Fix adapt/neigh: the {} was written with other keywords; write the same ones: particle {} has "
               "{} values, {} expected",
               restart_file_name(lmp), atom->tag[i], (int) *row - 1, at - row - 1);
  between.stop();
  unpack_exchange(i, const_cast<double *>(row) + RESTART_HEAD);
  between.begin_read(i, (int) row[1], row + 2);
  read.rows++;
  read.hash += hash_bytes(row, (int) *row * sizeof(double));
}

// LAMMPS writes as many values as this says
int FixAdaptNeigh::size_restart(int i)
{
  std::vector<double> values(maxexchange + RESTART_HEAD);
  return pack_restart(i, values.data());
}
int FixAdaptNeigh::maxsize_restart() { return RESTART_HEAD + maxexchange; }

// How many particles with what checksum; then for each part in use its number, the number of its values,
// and these. A block has room for MOST_STATE
void FixAdaptNeigh::write_restart(FILE *fp)
{
  if (between.is_on()) {    // the file knows nothing of commands that came after the last run
    between.end();
    between.begin();
  }
  std::vector<double> row(maxexchange + RESTART_HEAD), all;
  uint64_t mine[2] = {0, 0}, sum[2];
  for (int i = 0; !parts.values().empty() && i < atom->nlocal; i++) {
    const int n = pack_restart(i, row.data());
    mine[0]++;
    mine[1] += hash_bytes(row.data(), n * sizeof(double));
  }
  MPI_Reduce(mine, sum, 2, MPI_UINT64_T, MPI_SUM, 0, world);
  for (const uint64_t bits : sum) append_bits(all, bits);
  for (size_t k = 0; k < parts.all().size(); k++) {
    if (!parts.all()[k]->in_use()) continue;
    const std::vector<double> s = parts.all()[k]->state();
    all.insert(all.end(), {(double) k, (double) s.size()});
    all.insert(all.end(), s.begin(), s.end());
  }
  if (comm->me == 0) write_restart_block(fp, all);
}

void FixAdaptNeigh::restart(char *buf)
{
  const std::vector<double> all = read_restart_block(lmp, "Fix adapt/neigh", buf, 4, MOST_STATE);
  read.rows_written = take_bits(&all[0]);
  read.hash_written = take_bits(&all[2]);
  size_t at = 4;
  for (size_t k = 0; k < parts.all().size(); k++) {
    if (!parts.all()[k]->in_use()) continue;
    const bool fits = at + 2 <= all.size() && all[at] == (double) k && is_whole(all[at + 1], 0, all.size() - at - 2);
    const size_t n = fits ? (size_t) all[at + 1] : 0;
    if (!fits || !parts.all()[k]->restore(all.data() + at + 2, n)) refuse_restart();
    at += 2 + n;
  }
  if (at != all.size()) refuse_restart();
}

void FixAdaptNeigh::refuse_restart()
{
  error->all(FLERR, "Fix adapt/neigh: the {} was written with other keywords; write the same ones",
             restart_file_name(lmp));
}

// all rows that were written have been read, and are not what was written
void FixAdaptNeigh::check_restart()
{
  uint64_t mine[2] = {read.rows, read.hash}, all[2];
  MPI_Allreduce(mine, all, 2, MPI_UINT64_T, MPI_SUM, world);
  if (all[0] > 0 && all[0] == read.rows_written && all[1] != read.hash_written)
    error->all(FLERR,
               "Fix adapt/neigh: the {} is damaged: the values of its particles do not have the checksum "
               "written with them",
               restart_file_name(lmp));
  read = {};
}
