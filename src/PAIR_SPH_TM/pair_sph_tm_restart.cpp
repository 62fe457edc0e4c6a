/* SPH-TM: pair style sph/tm, restart. See doc/pair_sph_tm.rst. */
#include "pair_sph_tm.h"

#include "fix_sph_tm.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "utils.h"

#include <algorithm>
#include <cstring>

using namespace LAMMPS_NS;
using namespace SPHTM_NS;

void PairSPHTM::write_restart(FILE *fp)
{
  write_restart_settings(fp);
  char id[64] = {};
  if (has_fix()) strncpy(id, fix->id, sizeof(id) - 1);
  fwrite(id, sizeof(id), 1, fp);
  const int n = atom_types + 1;
  fwrite(&atom_types, sizeof(int), 1, fp);
  for (int i = 1; i < n; i++) {
    fwrite(&material[i], sizeof(tm_material), 1, fp);
    char title[64] = {};
    strncpy(title, names[i].c_str(), sizeof(title) - 1);
    fwrite(title, sizeof(title), 1, fp);
    for (int j = 1; j < n; j++) {
      fwrite(&setflag[std::min(i, j)][std::max(i, j)], sizeof(int), 1, fp);
      fwrite(&law(i, j), sizeof(PairLaw), 1, fp);
    }
  }
}

void PairSPHTM::read_restart(FILE *fp)
{
  read_restart_settings(fp);
  allocate();
  unit = unit_scale(lmp);
  auto read = [&](void *p, size_t bytes) {
    if (comm->me == 0) utils::sfread(FLERR, p, 1, bytes, fp, nullptr, error);
    MPI_Bcast(p, (int) bytes, MPI_BYTE, 0, world);
  };
  char id[64];
  read(id, sizeof(id));
  restart_fix = id;
  int types = 0;
  read(&types, sizeof(int));
  if (types != atom->ntypes)
    error->all(FLERR, "Pair sph/tm: restart file has {} types, simulation {}", types, atom->ntypes);
  for (int i = 1; i <= types; i++) {
    read(&material[i], sizeof(tm_material));
    char title[64];
    read(title, sizeof(title));
    names[i] = title;
    for (int j = 1; j <= types; j++) {
      int flag;
      read(&flag, sizeof(int));
      setflag[std::min(i, j)][std::max(i, j)] = flag;
      read(&laws[i * (atom_types + 1) + j], sizeof(PairLaw));
    }
  }
}

void PairSPHTM::write_restart_settings(FILE *fp) { fwrite(&set, sizeof(Settings), 1, fp); }

void PairSPHTM::read_restart_settings(FILE *fp)
{
  if (comm->me == 0) utils::sfread(FLERR, &set, sizeof(Settings), 1, fp, nullptr, error);
  MPI_Bcast(&set, sizeof(Settings), MPI_BYTE, 0, world);
}
