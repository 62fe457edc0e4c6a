/* SPH-TM: the TL/UL interface: rows of total-Lagrangian particles with pairs whose other end is updated-Lagrangian. A
   pair is total-Lagrangian where both its ends are. See tm_tl_rates.h, tm_freeze.h. */
#ifndef TM_TL_INTERFACE_H
#define TM_TL_INTERFACE_H

#include "tm_freeze.h"

typedef struct {
  tm_tl_rows rows;
  tm_rows candidates;
  const tm_real *next_ul;                /* as in tm_freeze_args */
  unsigned char *was_ul, *is_ul, *dirty; /* as there */
  int own, ghosts;                       /* particles */
} tm_interface_args;

/* The kinds of the next step; returns whether that of particle i changes. */
TM_FN int tm_interface_switch(int i, const tm_interface_args *a)
{
  a->was_ul[i] = a->is_ul[i];
  a->is_ul[i] = a->next_ul[i] > 0.5;
  return a->was_ul[i] != a->is_ul[i];
}

/* Marks the rows that hold a particle that changed kind: an owned particle marks those of its neighbors, ghosts have no
   row and are found from the other end. */
TM_FN void tm_interface_mark(int i, const tm_interface_args *a)
{
  const int change = a->was_ul[i] != a->is_ul[i];
  if (!change && !a->ghosts) return;
  const int lengths[2] = {a->candidates.mechanical[i], a->rows.tl[i]};
  const int *rows[2] = {a->candidates.index + a->candidates.first[i], a->rows.index + a->rows.first[i]};
  if (change) a->dirty[i] = 1;
  for (int r = 0; r < 2; r++)
    for (int e = 0; e < lengths[r]; e++) {
      const int j = rows[r][e * a->rows.stride];
      if (j < a->own) {
        if (change) a->dirty[j] = 1;
      } else if (a->was_ul[j] != a->is_ul[j]) a->dirty[i] = 1;
    }
}

/* Behind the total-Lagrangian pairs of a row: those whose other end is updated-Lagrangian, in the order of the
   candidate row. */
TM_FN void tm_interface_row(int i, const tm_interface_args *a)
{
  if (!a->dirty[i]) return;
  const tm_tl_rows *r = &a->rows;
  const int places = tm_tl_padded(r->tl[i]);
  const int *candidate = a->candidates.index + a->candidates.first[i];
  int *row = r->index + r->first[i] + places * r->stride, n = 0;
  for (int e = 0; e < a->candidates.mechanical[i] && !a->is_ul[i]; e++) {
    const int j = candidate[e * a->candidates.stride];
    if (a->is_ul[j]) row[n++ * r->stride] = j;
  }
  r->ul[i] = n;
  r->ul_first[i] = r->first[i] + places * r->stride;
}

typedef struct {
  tm_interface_args interface;
  int updated; /* updated-Lagrangian particles; 0: the others that have such neighbors, or no pairs */
} tm_kind_args;

TM_FN int tm_is_of_kind(int i, const tm_kind_args *a)
{
  const tm_interface_args *n = &a->interface;
  if (a->updated) return n->is_ul[i];
  return !n->is_ul[i] && (n->rows.ul[i] > 0 || n->rows.tl[i] == 0);
}

#endif
