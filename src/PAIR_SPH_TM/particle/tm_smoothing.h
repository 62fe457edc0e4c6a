/* SPH-TM: the smoothing length of one particle follows its neighborhood (tm_asph.h), or its density.

   Positions are those of the records, at the half step: owned and ghost particles are then at the same
   time, whatever rank they are on. The density is that of the material, also in plane stress. */
#ifndef TM_SMOOTHING_H
#define TM_SMOOTHING_H

#include "tm_asph.h"
#include "tm_rates.h"
#include "tm_size.h"

typedef struct {
  tm_state state;
  tm_records rec;
  tm_rows rows;               /* all mechanical neighbors below support * h of the particle */
  const tm_asph_table *table; /* NULL: h follows the density */
  int first;                  /* nonzero: only finds targets that are not known yet */
  tm_real least, most;        /* limits of h, in units of that the particle was made with */
} tm_smoothing_args;

/* sum over j != i of shape(|x_ij|/h), of Psi in S13 (1) */
TM_FN tm_real tm_smoothing_sum(int i, const tm_smoothing_args *a, tm_real h, int kernel)
{
  const int *row = a->rows.index + a->rows.first[i];
  const tm_real *x = tm_main_record(&a->rec, i);
  const tm_real inv_h = 1.0 / h;
  tm_real sum = 0.0;
  for (int k = 0; k < a->rows.mechanical[i]; k++) {
    const tm_real *y = tm_main_record(&a->rec, row[k * a->rows.stride]);
    const tm_real dx = x[0] - y[0], dy = x[1] - y[1], dz = x[tm_part(2)] - y[tm_part(2)];
    sum += tm_kernel_shape(kernel, sqrt(dx * dx + dy * dy + dz * dz) * inv_h);
  }
  return sum;
}

/* Sets h of particle i, and its target where that is 0; returns its sizes. */
TM_FN tm_size_range tm_smoothing(int i, const tm_smoothing_args *a, unsigned effects)
{
  const tm_state *s = &a->state;
  const tm_material *m = s->material + s->type[i];
  const int kernel = tm_fx_kernel(effects), dim = (effects & TM_FX_3D) ? 3 : 2;
  tm_real *size = tm_field_row(s, TM_F_SIZE, i), h = size[tm_column(TM_S_H)];
  const tm_real made = size[tm_column(TM_S_RATIO)] * size[tm_column(TM_S_DP)];
  if (m->body == TM_BODY_SOLID) {
    if (!a->table) {
      if (!a->first) h = tm_density_h(made, dim, m->rho0, *tm_field_row(s, TM_F_RHO, i));
    } else if (!a->first || size[tm_column(TM_S_TARGET)] == 0.0) {
      const tm_real n = tm_asph_nodes(a->table, tm_asph_psi(kernel, dim, tm_smoothing_sum(i, a, h, kernel)));
      if (size[tm_column(TM_S_TARGET)] == 0.0) size[tm_column(TM_S_TARGET)] = n;
      else h = tm_asph_next(h, size[tm_column(TM_S_TARGET)], n);
    }
    size[tm_column(TM_S_H)] = tm_clamp(h, a->least * made, a->most * made);
  }
  return tm_size_of(i, s);
}

#endif
