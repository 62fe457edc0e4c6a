/* SPH-TM: friction heat for a tool that is filled with particles (F15's NeibContTherm).

   The heat of a particle in contact goes to the tool's particles within its kernel, in parts that add up to all of it:
   the particle divides its heat by the sum of its weights W(r)/norm, then each tool particle collects its parts. */
#ifndef TM_SPREAD_H
#define TM_SPREAD_H

#include "tm_group.h"
#include "tm_kernel.h"
#include "tm_rates.h"

typedef struct {
  tm_rows rows;        /* the pairs that exchange heat are those that share it */
  const tm_real *main; /* records */
  const int *type;     /* LAMMPS types, owned and ghost */
  int body_type;       /* of the tool's particles */
  int kernel;
  tm_real h;
  tm_real *heat;   /* for the tool, of each particle in contact (power); then over the sum of its weights */
  tm_real *source; /* power into particles, added to */
} tm_spread_args;

TM_FN tm_real tm_spread_weight(int i, int j, const tm_spread_args *a)
{
  const tm_real *p = a->main + tm_record(i, TM_REC), *q = a->main + tm_record(j, TM_REC);
  const tm_real dx = p[0] - q[0], dy = p[1] - q[1], dz = p[tm_part(2)] - q[tm_part(2)];
  return tm_kernel_shape(a->kernel, sqrt(dx * dx + dy * dy + dz * dz) / a->h);
}

/* Divides the heat of particle i by the sum of its weights; nonzero: there is no tool particle in its kernel. */
TM_FN int tm_spread_divide(int i, const tm_spread_args *a)
{
  if (a->heat[i] == 0.0) return 0;
  const int *row = a->rows.index + a->rows.first[i] + a->rows.mechanical[i] * a->rows.stride;
  tm_real sum = 0.0;
  for (int k = 0; k < a->rows.thermal[i]; k++) {
    const int j = row[k * a->rows.stride];
    if (a->type[j] == a->body_type) sum += tm_spread_weight(i, j, a);
  }
  if (sum == 0.0) return 1;
  a->heat[i] /= sum;
  return 0;
}

/* What tool particle j takes up; after the heat of ghosts is known. On a GPU by several threads. */
TM_FN void tm_spread_collect(int j, tm_group group, const tm_spread_args *a)
{
  if (a->type[j] != a->body_type) return;
  const int *row = a->rows.index + a->rows.first[j] + a->rows.mechanical[j] * a->rows.stride;
  tm_real heat = 0.0;
  for (int k = group.lane; k < a->rows.thermal[j]; k += group.size) {
    const int i = row[k * a->rows.stride];
    if (a->heat[i] != 0.0) heat += a->heat[i] * tm_spread_weight(i, j, a);
  }
  heat = tm_group_sum_real(heat, group);
  if (group.lane == 0) a->source[j] += heat;
}

#endif
