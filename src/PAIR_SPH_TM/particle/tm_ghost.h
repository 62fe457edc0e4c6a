/* SPH-TM: what travels from a particle to its ghosts: columns of an array, or the records in use but for the position,
   which LAMMPS communicates. */
#ifndef TM_GHOST_H
#define TM_GHOST_H

#include "tm_record.h"

typedef struct {
  tm_records rec;
  tm_real *values; /* columns values per particle, or NULL: the records */
  int columns;
} tm_ghost_args;

/* Values of one ghost. */
TM_FN int tm_ghost_width(const tm_ghost_args *a)
{
  if (a->values) return a->columns;
  return TM_REC - TM_REC_M + (a->rec.stress ? (int) TM_REC_STRESS : 0) + (a->rec.heat ? (int) TM_REC_HEAT : 0) +
         (a->rec.size ? (int) TM_REC_SIZE : 0) + (a->rec.stab ? tm_stab_used(&a->rec) : 0);
}

/* Columns first to columns - 1 of a record into buf and back; what follows in buf. */
TM_FN tm_real *tm_ghost_take(tm_real *buf, const tm_real *record, int first, int columns)
{
  for (int c = first; c < columns; c++) *buf++ = record[tm_part(c)];
  return buf;
}
TM_FN const tm_real *tm_ghost_give(const tm_real *buf, tm_real *record, int first, int columns)
{
  for (int c = first; c < columns; c++) record[tm_part(c)] = *buf++;
  return buf;
}

TM_FN void tm_ghost_pack(int j, const tm_ghost_args *a, tm_real *buf)
{
  if (a->values) {
    for (int c = 0; c < a->columns; c++) buf[c] = a->values[(ptrdiff_t) j * a->columns + c];
    return;
  }
  buf = tm_ghost_take(buf, tm_main_record(&a->rec, j), TM_REC_M, TM_REC);
  if (a->rec.stress) buf = tm_ghost_take(buf, tm_stress_record(&a->rec, j), 0, TM_REC_STRESS);
  if (a->rec.heat) buf = tm_ghost_take(buf, tm_heat_record(&a->rec, j), 0, TM_REC_HEAT);
  for (int c = 0; a->rec.size && c < TM_REC_SIZE; c++) *buf++ = a->rec.size[(ptrdiff_t) j * TM_REC_SIZE + c];
  if (a->rec.stab) tm_ghost_take(buf, tm_stab_record(&a->rec, j), 0, tm_stab_used(&a->rec));
}

TM_FN void tm_ghost_unpack(int j, const tm_ghost_args *a, const tm_real *buf)
{
  if (a->values) {
    for (int c = 0; c < a->columns; c++) a->values[(ptrdiff_t) j * a->columns + c] = buf[c];
    return;
  }
  buf = tm_ghost_give(buf, tm_main_record(&a->rec, j), TM_REC_M, TM_REC);
  if (a->rec.stress) buf = tm_ghost_give(buf, tm_stress_record(&a->rec, j), 0, TM_REC_STRESS);
  if (a->rec.heat) buf = tm_ghost_give(buf, tm_heat_record(&a->rec, j), 0, TM_REC_HEAT);
  for (int c = 0; a->rec.size && c < TM_REC_SIZE; c++) a->rec.size[(ptrdiff_t) j * TM_REC_SIZE + c] = *buf++;
  if (a->rec.stab) tm_ghost_give(buf, tm_stab_record(&a->rec, j), 0, tm_stab_used(&a->rec));
}

#endif
