/* SPH-TM: heat conduction of one particle over a step in stages (tm_rkl.h), at the positions of the half step.

   Conduction F15 (6) and through interfaces (tm_heat.h) is linear once the conductivities are those of the half step:
     C_i dT_i/dt = sum_j g_ij (T_j - T_i) + P_i,  C = m c_p,
     g_ij = V_i V_j 4 k_i k_j/(k_i + k_j) |W'|/r  (power/temperature), symmetric to the last bit.
   tm_conduct_row() finds g once a step and keeps the pairs that conduct; a stage is then one product with them. The
   stages carry F, the heat that conduction has brought (energy), so that it is kept to round-off, and
     T = T(n) + (F + c_j dt P)/C,
   P the power of contact and surface fluxes and the plastic heat of the last step. Particles of prescribed temperature
   go straight from T(n) to that of the end of the step.

   By Gershgorin no mode decays faster than max_i 2/C_i sum_j g_ij; the number of stages follows from that bound. */
#ifndef TM_CONDUCT_H
#define TM_CONDUCT_H

#include "tm_chunk.h"
#include "tm_heat.h"
#include "tm_rkl.h"
#include "tm_state.h"

#if TM_SINGLE
#error "double only: stages have the precision of the state"
#endif

/* Prescribed temperatures, of groups of particles. */
enum { TM_HELD_MOST = 16 };
typedef struct {
  int n;
  int group[TM_HELD_MOST]; /* LAMMPS group bits */
  tm_real temperature[TM_HELD_MOST];
} tm_held;

/* Which of them a particle has, the last one; -1: none. */
TM_FN int tm_held_by(const tm_held *h, int mask)
{
  int by = -1;
  for (int k = 0; k < h->n; k++)
    if (mask & h->group[k]) by = k;
  return by;
}

/* Rows of pairs that conduct: entry k of particle i is number i * width + k, or on a GPU i + k * width. */
typedef struct {
  int *index, *count;
  tm_real *g; /* conductance, power/temperature */
  ptrdiff_t width;
  int by_column; /* of a GPU */
} tm_conduct_rows;

typedef struct {
  tm_rates_args rates; /* records, kernel, mechanical rows */
  tm_rows others;      /* rows whose second segment only exchanges heat */
  tm_state state;
  tm_held held;
  tm_conduct_rows rows;
  /* of owned particles */
  tm_real *capacity;     /* m c_p */
  const tm_real *source; /* power, or NULL */
  tm_real *power;        /* P */
  tm_real *first;        /* conducted power at the start of the step, sum_j g_ij (T_j - T_i) */
  tm_real *F, *older;    /* F of the last stage; of the one before it, and then of this one */
  /* owned and ghost: of the last stage, and of this one (owned) */
  const tm_real *T;
  tm_real *T_new;
  /* the step and the stage */
  tm_real dt, c; /* c: its time over the step */
  tm_rkl stage;
  int is_first;
} tm_conduct_args;

TM_FN ptrdiff_t tm_conduct_entry(const tm_conduct_rows *r, int i, int k)
{
  return r->by_column ? i + k * r->width : i * r->width + k;
}

/* Entries that the row of particle i may have. */
TM_FN int tm_conduct_room(int i, const tm_conduct_args *a)
{
  return a->rates.rows.mechanical[i] + a->others.thermal[i];
}
TM_FN int tm_conduct_room_nothing(void) { return 0; }
TM_FN void tm_conduct_room_sum(int *most, const int *n)
{
  if (*n > *most) *most = *n;
}

/* Adds the pairs of a row, entries begin to end - 1, from entry k of the row on; returns the next entry. */
TM_FN int tm_conduct_pairs(int i, const tm_conduct_args *a, const tm_rows *rows, ptrdiff_t begin, ptrdiff_t end,
                           const tm_real *conductance, int k, tm_real *sum, unsigned effects)
{
  const tm_rates_args *q = &a->rates;
  const int kernel = tm_fx_kernel(effects), dim3 = (effects & TM_FX_3D) != 0;
  const int sizes = (effects & TM_FX_SMOOTHING) != 0;
  const int *row = rows->index + rows->first[i];
  const tm_real *ri = tm_main_record(&q->rec, i), *hi = tm_heat_record(&q->rec, i);
  const tm_real mi = ri[tm_part(TM_REC_M)], rhoi = ri[tm_part(TM_REC_RHO)], ki = hi[tm_part(TM_REC_K)];
  const tm_pair_size of_all = tm_size_of_all(q, 1.0, 1.0);
  const tm_pair_size own = tm_own_size(sizes ? q->rec.size + (ptrdiff_t) i * TM_REC_SIZE : NULL, of_all);
  tm_pair_size p = of_all;
  for (ptrdiff_t e = begin; e < end; e++) {
    const int j = row[e * rows->stride];
    const tm_real *rj = tm_main_record(&q->rec, j);
    const tm_real dx = ri[0] - rj[0], dy = ri[tm_part(1)] - rj[tm_part(1)];
    const tm_real dz = dim3 ? ri[tm_part(2)] - rj[tm_part(2)] : 0.0;
    const tm_real r2 = dx * dx + dy * dy + dz * dz;
    if (sizes) {
      const tm_real *z = q->rec.size + (ptrdiff_t) j * TM_REC_SIZE;
      p = tm_pair_of_sizes(&own, z[TM_SIZE_INV_H], z[TM_SIZE_FACTOR], 1.0, q->norm_of_one, dim3);
    }
    if (sizes ? r2 * p.inv_h * p.inv_h >= q->support2 : r2 >= q->support_radius2) continue;
    const tm_real r = sqrt(r2), x = r / p.h, kj = tm_heat_record(&q->rec, j)[tm_part(TM_REC_K)];
    const tm_real slope = p.slope_norm * tm_kernel_slope(kernel, x) / r;
    const tm_real mass = mi * rj[tm_part(TM_REC_M)], rho = rhoi * rj[tm_part(TM_REC_RHO)];
    const tm_real hc = conductance ? conductance[q->type[i] * (q->ntypes + 1) + q->type[j]] : 0.0;
    const tm_real g = hc > 0.0 ? tm_conduction_pair_interface(ki, kj, 0.0, 1.0, mass / rho, slope, r, hc)
                               : tm_conduction_pair(ki, kj, 0.0, 1.0, mass, rho, slope);
    if (!(g > 0.0)) continue;
    const ptrdiff_t at = tm_conduct_entry(&a->rows, i, k++);
    a->rows.index[at] = j;
    a->rows.g[at] = g;
    *sum += g;
  }
  return k;
}

/* The row of particle i, its capacity and source; returns the bound of its decay rate (1/time). */
TM_FN tm_real tm_conduct_row(int i, const tm_conduct_args *a, unsigned effects)
{
  const tm_state *s = &a->state;
  const tm_material *m = s->material + s->type[i];
  const tm_real *rec = tm_main_record(&a->rates.rec, i);
  const tm_real mass = rec[tm_part(TM_REC_M)], T = tm_heat_record(&a->rates.rec, i)[tm_part(TM_REC_T)];
  const ptrdiff_t mechanical = a->others.mechanical[i];
  tm_real sum = 0.0;
  int k = tm_conduct_pairs(i, a, &a->rates.rows, 0, a->rates.rows.mechanical[i], NULL, 0, &sum, effects);
  k = tm_conduct_pairs(i, a, &a->others, mechanical, mechanical + a->others.thermal[i], a->rates.conductance, k, &sum,
                       effects);
  a->rows.count[i] = k;
  tm_real power = a->source ? a->source[i] : 0.0;
  if ((effects & TM_FX_PLASTICITY) && m->body == TM_BODY_SOLID) {
    const tm_real *pl = tm_field_row(s, TM_F_PSTRAIN, i);
    power += m->taylor_quinney * pl[tm_column(1)] * pl[tm_column(2)] * mass / rec[tm_part(TM_REC_RHO)];
  }
  a->power[i] = power;
  a->capacity[i] = mass * tm_capacity(m, T);
  a->F[i] = a->older[i] = 0.0;
  a->T_new[i] = tm_field_row(s, TM_F_TEMP, i)[0];
  return 2.0 * sum / a->capacity[i];
}
TM_FN tm_real tm_conduct_rate_nothing(void) { return 0.0; }
TM_FN void tm_conduct_rate_sum(tm_real *most, const tm_real *rate) { *most = tm_max(*most, *rate); }

/* Conducted power into particle i. */
TM_FN tm_real tm_conduct_power(int i, const tm_conduct_args *a)
{
  const int n = a->rows.count[i];
  const tm_real Ti = a->T[i];
  tm_real sum = 0.0;
  for (int k = 0; k < n; k++) {
    const ptrdiff_t at = tm_conduct_entry(&a->rows, i, k);
    sum += a->rows.g[at] * (a->T[a->rows.index[at]] - Ti);
  }
  return sum;
}

/* One stage. */
TM_FN void tm_conduct_stage(int i, const tm_conduct_args *a)
{
  const tm_rkl c = a->stage;
  const tm_state *s = &a->state;
  const tm_real T0 = tm_field_row(s, TM_F_TEMP, i)[0], power = tm_conduct_power(i, a), last = a->F[i];
  if (a->is_first) a->first[i] = power;
  const tm_real F = c.mu * last + c.nu * a->older[i] + a->dt * (c.mu_t * power + c.gamma_t * a->first[i]);
  a->older[i] = F;
  tm_real T = T0 + (F + a->c * a->dt * a->power[i]) / a->capacity[i];
  const int held = tm_held_by(&a->held, s->mask[i]);
  if (held >= 0) T = T0 + a->c * (a->held.temperature[held] - T0);
  a->T_new[i] = T;
}

/* What the step says about the next one. */
typedef struct {
  tm_real lowest, highest;      /* temperature */
  tm_real change;               /* of the rise in this step, against the rate of the last one */
  tm_real supply[TM_HELD_MOST]; /* heat that the prescribed temperatures take */
} tm_conduct_result;

TM_FN tm_conduct_result tm_conduct_result_nothing(void)
{
  tm_conduct_result r;
  r.lowest = 1e300;
  r.highest = -1e300;
  r.change = 0.0;
  for (int k = 0; k < TM_HELD_MOST; k++) r.supply[k] = 0.0;
  return r;
}
TM_FN void tm_conduct_result_sum(tm_conduct_result *sum, const tm_conduct_result *r)
{
  sum->lowest = tm_min(sum->lowest, r->lowest);
  sum->highest = tm_max(sum->highest, r->highest);
  sum->change = tm_max(sum->change, r->change);
  for (int k = 0; k < TM_HELD_MOST; k++) sum->supply[k] += r->supply[k];
}

/* The mean of the conduction over the step, power per volume, for tm_update(). Of a particle of prescribed temperature
   what takes it there: far more may have passed through it. */
TM_FN tm_conduct_result tm_conduct_end(int i, const tm_conduct_args *a)
{
  const tm_state *s = &a->state;
  const tm_real *t = tm_field_row(s, TM_F_TEMP, i), *rec = tm_main_record(&a->rates.rec, i);
  const int held = tm_held_by(&a->held, s->mask[i]);
  tm_conduct_result r = tm_conduct_result_nothing();
  tm_real F = a->F[i];
  const tm_real rise = (F + a->dt * a->power[i]) / a->capacity[i];
  r.change = fabs(rise - a->dt * t[tm_column(1)]);
  if (held >= 0) {
    const tm_real all = a->capacity[i] * (a->held.temperature[held] - t[0]) - a->dt * a->power[i];
    r.supply[held] = all - F;
    r.change = 0.0;
    F = all;
  }
  a->rates.heat[i] = F / a->dt * rec[tm_part(TM_REC_RHO)] / rec[tm_part(TM_REC_M)];
  r.lowest = tm_min(t[0], a->T[i]);
  r.highest = tm_max(t[0], a->T[i]);
  return r;
}

#endif
