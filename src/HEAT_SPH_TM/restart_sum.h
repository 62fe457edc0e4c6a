/* SPH-TM: a number of a fix in restart files: the sum over the ranks, which the first rank takes up again. */
#ifndef SPHTM_RESTART_SUM_H
#define SPHTM_RESTART_SUM_H

#include <cstdio>
#include <cstring>
#include <mpi.h>

namespace SPHTM_NS {

inline void write_restart_sum(double mine, MPI_Comm world, int me, FILE *fp)
{
  double all = 0.0;
  MPI_Reduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, 0, world);
  if (me) return;
  const int size = sizeof(double);
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(&all, sizeof(double), 1, fp);
}

inline void read_restart_sum(double &mine, int me, const char *buf)
{
  if (me == 0) memcpy(&mine, buf, sizeof(double));
}

}    // namespace SPHTM_NS

#endif
