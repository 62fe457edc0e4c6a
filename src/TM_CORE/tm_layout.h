/* SPH-TM: where the values of a particle lie in memory.

   On the host the values of one particle lie together, a row: what one neighbor delivers is one or
   two cache lines, and vector loops transpose the rows they need. On a GPU the threads of a warp
   stand for particles side by side, and a load costs a pass for every cache line it touches: there
   the same value of TM_BLOCK particles lies together. Records, which neighbors fetch 16 bytes at a
   time, keep two values side by side, or four in single. Rows of one value, and records of two (four), are alike in
   both. */
#ifndef TM_LAYOUT_H
#define TM_LAYOUT_H

#include "tm_real.h"

#if !defined(TM_BLOCK) /* particles; who shares arrays with the host says 1 */
#if defined(__CUDACC__)
#define TM_BLOCK 32
#else
#define TM_BLOCK 1
#endif
#endif

/* Row of particle i, of so many columns, and column c in it. */
TM_FN ptrdiff_t tm_row(int i, int columns)
{
  return (ptrdiff_t) ((unsigned) i / TM_BLOCK) * (TM_BLOCK * columns) + (unsigned) i % TM_BLOCK;
}
TM_FN int tm_column(int c) { return c * TM_BLOCK; }

/* The same of a record, whose columns are a multiple of those that stay together: 16 bytes. */
TM_FN ptrdiff_t tm_packed(int i, int columns, int together)
{
  return (ptrdiff_t) ((unsigned) i / TM_BLOCK) * (TM_BLOCK * columns) + (unsigned) i % TM_BLOCK * together;
}
TM_FN int tm_packed_part(int c, int together) { return c / together * (together * TM_BLOCK) + c % together; }
TM_FN ptrdiff_t tm_record(int i, int columns) { return tm_packed(i, columns, 2); }
TM_FN int tm_part(int c) { return tm_packed_part(c, 2); }

/* Of a record in the precision of pair arithmetic. */
enum { TM_TOGETHER = 16 / sizeof(tm_pair) };
TM_FN ptrdiff_t tm_pair_record(int i, int columns) { return tm_packed(i, columns, TM_TOGETHER); }
TM_FN int tm_pair_part(int c) { return tm_packed_part(c, TM_TOGETHER); }

#endif
