/* SPH-TM: which of a processor's particles have ghosts among their mechanical neighbors.

   The rates of the others, the interior, need nothing of other processors. They are told apart by blocks of TM_BLOCK
   particles (tm_layout.h), so that the threads of a warp stay side by side in memory. */
#ifndef TM_BOUNDARY_H
#define TM_BOUNDARY_H

#include "tm_chunk.h"

typedef struct {
  tm_rows rows;
  int owned;            /* particles of this processor; ghosts are behind them */
  unsigned char *marks; /* per block: 1 at the boundary, 0 in the interior */
  int wanted;           /* which of these a list takes */
} tm_boundary_args;

/* Marks the block of particle i, where marks were 0. */
TM_FN void tm_boundary_mark(int i, const tm_boundary_args *a)
{
  const int *row = a->rows.index + a->rows.first[i];
  for (int m = 0; m < a->rows.mechanical[i]; m++)
    if (row[m * a->rows.stride] >= a->owned) {
      a->marks[i / TM_BLOCK] = 1;
      return;
    }
}

TM_FN int tm_boundary_wanted(int i, const tm_boundary_args *a) { return a->marks[i / TM_BLOCK] == a->wanted; }

#endif
