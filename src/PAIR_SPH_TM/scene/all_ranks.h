/* SPH-TM: the values of all ranks on each of them, one rank after the other. */
#ifndef SPHTM_ALL_RANKS_H
#define SPHTM_ALL_RANKS_H

#include <mpi.h>
#include <vector>

namespace SPHTM_NS {

template <class T> std::vector<T> of_all_ranks(const std::vector<T> &mine, MPI_Comm world)
{
  int ranks;
  MPI_Comm_size(world, &ranks);
  if (ranks == 1) return mine;
  std::vector<int> bytes(ranks), begin(ranks, 0);
  const int my_bytes = (int) (mine.size() * sizeof(T));
  MPI_Allgather(&my_bytes, 1, MPI_INT, bytes.data(), 1, MPI_INT, world);
  for (int r = 1; r < ranks; r++) begin[r] = begin[r - 1] + bytes[r - 1];
  std::vector<T> all((begin.back() + bytes.back()) / sizeof(T));
  MPI_Allgatherv(mine.data(), my_bytes, MPI_BYTE, all.data(), bytes.data(), begin.data(), MPI_BYTE, world);
  return all;
}

}    // namespace SPHTM_NS

#endif
