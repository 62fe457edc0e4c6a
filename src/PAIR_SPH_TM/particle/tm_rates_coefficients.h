/* SPH-TM: the pairs of a chunk of neighbors, before they are summed: records into columns, and what each pair contributes as
   a number. The formulas are at the head of tm_rates.h; the sums are taken there. */
#ifndef TM_RATES_COEFFICIENTS_H
#define TM_RATES_COEFFICIENTS_H

#include "tm_artificial.h"
#include "tm_chunk.h"
#include "tm_heat.h"

/* Columns of a chunk: first the records, then what the pair functions make of them. */
enum {
  TM_COL_STRESS = TM_REC,
  TM_COL_HEAT = (int) TM_COL_STRESS + TM_REC_STRESS,
  TM_COL_CORRECTION = TM_COL_HEAT + TM_REC_HEAT,
  TM_COL_SIZE = TM_COL_CORRECTION + TM_REC_CORRECTION,
  TM_COL_STAB = TM_COL_SIZE + TM_REC_SIZE,
  TM_COL_SLOPE = TM_COL_STAB + TM_REC_STAB, /* m_j W'/r */
  TM_COL_HOURGLASS,                         /* m_j min(k_i, k_j)/rho_mean^2 W'/r^3 */
  TM_COL_TENSILE,                           /* f^n of the artificial stress */
  TM_COL_VISCOUS,                           /* Pi */
  TM_COL_CONDUCTED,                         /* power per volume into i */
  TM_COL_PER_RHO,                           /* 1/rho_j */
  TM_COL_SMOOTH,                            /* m_j/rho_mean W */
  TM_COL_SOUND, /* as in tm_rates_own, with one pass in the extended instantiation or with faces */
  TM_COL_Q,     /* r/h, and W'/r: of loops that test effects at run time */
  TM_COL_G,
  TM_COLUMNS
};

/* Which particles a call of the rate pass is for: all, those that are not at a free face, those that are. A literal. */
enum tm_rates_whose { TM_RATES_ALL = 0, TM_RATES_INSIDE, TM_RATES_AT_FACE };

/* Terms of the rates: literals, but in the extended instantiation, where kernel, dim3 and one_pass are. */
typedef struct {
  int kernel, dim3, viscosity, artstress, conduction, form_f14, correction, balsara, xsph, surface, sizes, one_pass,
      faces;
  int extended;
  int whose; /* enum tm_rates_whose, with faces */
} tm_rates_terms;

TM_FN tm_rates_terms tm_rates_terms_of(unsigned effects, unsigned run_time)
{
  const unsigned all = TM_FX_PRESENT & ((effects & TM_FX_EXTENDED) ? (effects & TM_FX_3D) | run_time : effects);
  tm_rates_terms t;
  t.extended = (effects & TM_FX_EXTENDED) != 0;
  t.whose = 0;
  t.kernel = tm_fx_kernel(effects);
  t.dim3 = (effects & TM_FX_3D) != 0;
  t.viscosity = (all & TM_FX_VISCOSITY) != 0;
  t.artstress = !(effects & TM_FX_ONE_PASS) && (all & TM_FX_ARTSTRESS) != 0;
  t.conduction = (all & TM_FX_CONDUCTION) != 0;
  t.form_f14 = (all & TM_FX_FORM_F14) != 0;
  t.one_pass = (effects & TM_FX_ONE_PASS) != 0;
  t.faces = t.one_pass && (all & TM_FX_FACES) != 0;
  t.correction = !t.one_pass && (all & TM_FX_CORRECTION) != 0;
  t.balsara = (all & TM_FX_BALSARA) != 0;
  t.xsph = (all & TM_FX_XSPH) != 0;
  t.surface = (all & TM_FX_SURFACE) != 0;
  t.sizes = (all & TM_FX_SMOOTHING) != 0;
  return t;
}

/* Values of the particle itself. */
typedef struct {
  tm_pair r[TM_REC];       /* main record */
  tm_pair stress[TM_MORE]; /* artificial stress */
  tm_pair correction[TM_REC_CORRECTION];
  tm_pair stab[TM_REC_STAB];
  tm_pair T, k;                         /* temperature, conductivity */
  tm_pair inv_rho, sound, sound_factor; /* alpha c of a pair is sound_factor times the sum of both sounds */
  tm_pair mass, density;                /* in single, where weights are symmetric; else 1 */
  tm_pair visc_alpha, visc_beta, norm_of_one;
  int art_n;
} tm_rates_own;

/* With faces, sound speed from rho c^2, where the linear part of the viscosity needs it. */
TM_FN tm_pair tm_rates_sound(const tm_rates_own *own, tm_pair rho_c2, tm_pair rho)
{
  const tm_pair tiny = TM_PAIR(TM_SINGLE ? 1e-36 : 1e-300);
  return own->visc_alpha > 0 ? tm_pair_root(rho_c2 * tm_pair_inverse(rho) + tiny) : 0;
}

/* Columns of the particle's own record of one pass that are read behind its pairs: most of P K. */
enum { TM_STAB_LATE = 8 };

/* Columns of the record of one pass that a loop reads. */
TM_FN int tm_rates_stab_fetched(const tm_rates_terms *t)
{
  return t->extended || t->faces ? (int) TM_REC_STAB : (int) TM_STAB_FETCHED;
}

TM_FN void tm_rates_load(int i, const tm_rates_args *a, const tm_rates_terms *t, const tm_pair_records *rec,
                         tm_rates_own *own)
{
  tm_fetch(rec->main + tm_pair_record(i, TM_REC), TM_REC, own->r);
  own->inv_rho = 1 / own->r[TM_REC_RHO];
  own->mass = TM_SINGLE ? own->r[TM_REC_M] : 1;
  own->density = TM_SINGLE ? own->r[TM_REC_RHO] : 1;
  own->T = own->k = 0;
  for (int c = 0; c < TM_MORE; c++) own->stress[c] = 0;
  for (int c = 0; c < TM_REC_CORRECTION; c++) own->correction[c] = 0;
  if (t->artstress) tm_fetch(rec->stress + tm_pair_record(i, TM_STRESS_COLUMNS), TM_STRESS_COLUMNS, own->stress);
  if (t->conduction) {
    const tm_pair *heat = rec->heat + tm_pair_record(i, TM_HEAT_COLUMNS);
    own->T = heat[TM_REC_T];
    own->k = heat[TM_REC_K];
  }
  if (t->correction)
    for (int c = 0; c < TM_REC_CORRECTION; c++)
      own->correction[c] = rec->correction[(ptrdiff_t) i * TM_REC_CORRECTION + c];
  if (t->one_pass)
    tm_fetch(rec->stab + tm_pair_record(i, TM_REC_STAB) + tm_pair_part(TM_STAB_LATE),
             tm_rates_stab_fetched(t) - TM_STAB_LATE, own->stab + TM_STAB_LATE);
  own->visc_alpha = !t->viscosity ? 0 : TM_SINGLE ? (tm_pair) a->single.visc_alpha : (tm_pair) a->visc_alpha;
  own->visc_beta = !t->viscosity ? 0 : TM_SINGLE ? (tm_pair) a->single.visc_beta : (tm_pair) a->visc_beta;
  /* one rounding of the product, so that both particles have the same bits where products are fused with sums */
  own->sound_factor = TM_PAIR(0.5) * (t->one_pass && !t->faces ? 1 : own->visc_alpha);
  own->sound = t->faces      ? tm_rates_sound(own, own->stab[TM_STAB_K], own->r[TM_REC_RHO])
               : t->one_pass ? own->stab[TM_STAB_C]
                             : own->r[TM_REC_C];
  own->norm_of_one = (tm_pair) a->norm_of_one;
  own->art_n = a->art_n;
}

/* Records of the neighbors of a chunk into columns. */
TM_FN void tm_rates_fetch(const tm_chunk *c, const int *jj, const tm_rates_terms *t, const tm_pair_records *rec,
                          tm_values *col)
{
  if (t->one_pass) { /* P and c are in the other record */
    tm_chunk_fetch_main(c, jj, TM_REC_P, t->dim3, col);
    if (t->balsara)
      tm_fetch_records(c->main, TM_REC, (int) TM_REC - TM_TOGETHER, TM_TOGETHER, jj, c->lanes,
                       col[(int) TM_REC - TM_TOGETHER]);
  } else if (TM_COLUMN > 1 || TM_SINGLE || t->viscosity || t->extended)
    tm_chunk_fetch_main(c, jj, TM_REC, t->dim3, col);
  else tm_chunk_fetch_main(c, jj, TM_REC_C, t->dim3, col);
  if (t->one_pass)
    tm_fetch_records(rec->stab, TM_REC_STAB, 0, tm_rates_stab_fetched(t), jj, c->lanes, col[TM_COL_STAB]);
  if (t->artstress) /* in single with heat behind it, whose columns begin within a group of four */
    tm_fetch_records(rec->stress, TM_STRESS_COLUMNS, 0, TM_STRESS_COLUMNS, jj, c->lanes, col[TM_COL_STRESS]);
  else if (TM_SINGLE && t->conduction)
    tm_fetch_records(rec->stress, TM_MORE, 4, TM_MORE - 4, jj, c->lanes, col[TM_COL_STRESS + 4]);
  if (t->conduction && !TM_SINGLE)
    tm_fetch_records(rec->heat, TM_REC_HEAT, 0, TM_REC_HEAT, jj, c->lanes, col[TM_COL_HEAT]);
  if (t->sizes) tm_fetch_rows(rec->size, TM_REC_SIZE, jj, c->lanes, col[TM_COL_SIZE]);
  if (t->correction) tm_fetch_rows(rec->correction, TM_REC_CORRECTION, jj, c->lanes, col[TM_COL_CORRECTION]);
}

/* Power per volume that neighbor l conducts into the particle, F15 (6). */
TM_FN tm_pair tm_rates_conducted(const tm_rates_own *own, tm_values *col, int l, tm_pair g)
{
  return tm_conduction_pair(own->k, col[(int) TM_COL_HEAT + TM_REC_K][tm_at(l)], own->T,
                            col[(int) TM_COL_HEAT + TM_REC_T][tm_at(l)], col[TM_REC_M][tm_at(l)] * own->mass,
                            col[TM_REC_RHO][tm_at(l)] * own->density, g);
}

/* Coefficients of the pair with neighbor l of a chunk, but those of tm_rates_rare_coefficients(). */
TM_FN void tm_rates_coefficients(const tm_chunk *c, const tm_rates_terms *t, const tm_rates_own *own, tm_values *col,
                                 int l)
{
  const tm_pair dx = tm_chunk_apart(c->x, col[0], l), dy = tm_chunk_apart(c->y, col[1], l);
  const tm_pair dz = t->dim3 ? tm_chunk_apart(c->z, col[2], l) : 0;
  const tm_pair_size p = tm_chunk_pair_size(c, t->sizes, col + TM_COL_SIZE, l, &own->norm_of_one, t->dim3);
  const tm_pair r2 = dx * dx + dy * dy + dz * dz, r = tm_pair_root(r2), q = r * p.inv_h;
  const tm_pair mj = col[TM_REC_M][tm_at(l)], rhoj = col[TM_REC_RHO][tm_at(l)];
  const tm_pair *c_of = !t->one_pass              ? col[TM_REC_C]
                        : t->extended || t->faces ? col[TM_COL_SOUND]
                                                  : col[(int) TM_COL_STAB + TM_STAB_C];
  tm_pair inv_r, inv_rho_sum;
  if (t->viscosity) {
    const tm_pair vx = own->r[4] - col[4][tm_at(l)], vy = own->r[5] - col[5][tm_at(l)];
    const tm_pair vz = t->dim3 ? own->r[6] - col[6][tm_at(l)] : 0;
    const tm_pair pi = tm_viscosity_pair(own->visc_beta, p.h, vx * dx + vy * dy + vz * dz, r2, r,
                                         own->sound_factor * (own->sound + c_of[tm_at(l)]), own->r[TM_REC_RHO] + rhoj,
                                         &inv_r, &inv_rho_sum);
    const tm_pair shear =
        t->balsara && !t->extended ? TM_PAIR(0.5) * (own->r[TM_REC_BALSARA] + col[TM_REC_BALSARA][tm_at(l)]) : 1;
    col[TM_COL_VISCOUS][tm_at(l)] = shear * pi;
  } else {
    inv_r = tm_pair_inverse(r);
    inv_rho_sum = t->one_pass ? tm_pair_inverse(own->r[TM_REC_RHO] + rhoj) : 0;
  }
  const tm_pair g = p.slope_norm * tm_kernel_slope(t->kernel, q) * inv_r; /* W'/r */
  if (t->extended) {
    col[TM_COL_Q][tm_at(l)] = q;
    col[TM_COL_G][tm_at(l)] = g;
  }
  col[TM_COL_SLOPE][tm_at(l)] = mj * own->mass * g;
  if (t->one_pass) {
    const tm_pair stiffness = tm_pair_min(own->stab[TM_STAB_K], col[(int) TM_COL_STAB + TM_STAB_K][tm_at(l)]);
    const tm_pair per = 2 * inv_rho_sum * inv_r;
    col[TM_COL_HOURGLASS][tm_at(l)] = mj * own->mass * g * stiffness * (per * per);
  }
  if (t->artstress) col[TM_COL_TENSILE][tm_at(l)] = tm_power_int(tm_kernel_shape(t->kernel, q) * p.inv_w, own->art_n);
  if (t->conduction) col[TM_COL_CONDUCTED][tm_at(l)] = tm_rates_conducted(own, col, l, g);
  if (t->xsph && !t->extended)
    col[TM_COL_SMOOTH][tm_at(l)] = tm_xsph_pair(mj, inv_rho_sum, p.norm * tm_kernel_shape(t->kernel, q));
}
TM_FN void tm_rates_sound_loop(const tm_chunk *c, const tm_rates_terms *t, const tm_rates_own *own, tm_values *col)
{
  const int lanes = c->lanes;
  if (t->faces) {
    TM_SIMD
    for (int l = 0; l < lanes; l++)
      col[TM_COL_SOUND][tm_at(l)] =
          tm_rates_sound(own, col[(int) TM_COL_STAB + TM_STAB_K][tm_at(l)], col[TM_REC_RHO][tm_at(l)]);
  } else {
    TM_SIMD
    for (int l = 0; l < lanes; l++) col[TM_COL_SOUND][tm_at(l)] = col[(int) TM_COL_STAB + TM_STAB_C][tm_at(l)];
  }
}
TM_FN void tm_rates_coefficient_loop(const tm_chunk *c, const tm_rates_terms *t, const tm_rates_own *own,
                                     tm_values *col)
{
  const int lanes = c->lanes;
  TM_SIMD
  for (int l = 0; l < lanes; l++) tm_rates_coefficients(c, t, own, col, l);
}

TM_FN void tm_rates_tensile_loop(const tm_chunk *c, const tm_rates_terms *t, const tm_rates_own *own, tm_values *col)
{
  const int lanes = c->lanes;
  TM_SIMD
  for (int l = 0; l < lanes; l++) {
    const tm_pair_size p = tm_chunk_pair_size(c, t->sizes, col + TM_COL_SIZE, l, &own->norm_of_one, t->dim3);
    const tm_pair shape = tm_kernel_shape(t->kernel, col[TM_COL_Q][tm_at(l)]);
    col[TM_COL_TENSILE][tm_at(l)] = tm_power_int(shape * p.inv_w, own->art_n);
  }
}
TM_FN void tm_rates_smooth_loop(const tm_chunk *c, const tm_rates_terms *t, const tm_rates_own *own, tm_values *col)
{
  const int lanes = c->lanes;
  TM_SIMD
  for (int l = 0; l < lanes; l++) {
    const tm_pair_size p = tm_chunk_pair_size(c, t->sizes, col + TM_COL_SIZE, l, &own->norm_of_one, t->dim3);
    const tm_pair shape = tm_kernel_shape(t->kernel, col[TM_COL_Q][tm_at(l)]), rhoj = col[TM_REC_RHO][tm_at(l)];
    col[TM_COL_SMOOTH][tm_at(l)] =
        tm_xsph_pair(col[TM_REC_M][tm_at(l)], tm_pair_inverse(own->r[TM_REC_RHO] + rhoj), p.norm * shape);
  }
}

/* With the extended instantiation: coefficients of the effects that it tests, each in a loop of its own. */
TM_FN void tm_rates_rare_coefficients(const tm_chunk *c, const tm_rates_terms *t, const tm_rates_own *own,
                                      tm_values *col)
{
  const int lanes = c->lanes;
  if (t->extended && t->balsara) {
    TM_SIMD
    for (int l = 0; l < lanes; l++)
      col[TM_COL_VISCOUS][tm_at(l)] *= TM_PAIR(0.5) * (own->r[TM_REC_BALSARA] + col[TM_REC_BALSARA][tm_at(l)]);
  }
  if (t->form_f14 || t->surface) {
    TM_SIMD
    for (int l = 0; l < lanes; l++) col[TM_COL_PER_RHO][tm_at(l)] = 1 / col[TM_REC_RHO][tm_at(l)];
  }
  if (t->extended && t->conduction) {
    TM_SIMD
    for (int l = 0; l < lanes; l++)
      col[TM_COL_CONDUCTED][tm_at(l)] = tm_rates_conducted(own, col, l, col[TM_COL_G][tm_at(l)]);
  }
  tm_rates_terms u = *t; /* sizes are a literal in each loop */
  if (t->sizes) {
    u.sizes = 1;
    if (t->extended && t->artstress) tm_rates_tensile_loop(c, &u, own, col);
    if (t->extended && t->xsph) tm_rates_smooth_loop(c, &u, own, col);
  } else {
    u.sizes = 0;
    if (t->extended && t->artstress) tm_rates_tensile_loop(c, &u, own, col);
    if (t->extended && t->xsph) tm_rates_smooth_loop(c, &u, own, col);
  }
}

/* Coefficients of the pairs of a chunk. Where effects are tested at run time that is done once per chunk, so that the loops
   over its neighbors are those of vectors, as with literals. */
TM_FN void tm_rates_all_coefficients(const tm_chunk *c, const tm_rates_terms *t, const tm_rates_own *own,
                                     tm_values *col)
{
  tm_rates_terms u = *t;
  if (t->one_pass && (t->extended || t->faces)) tm_rates_sound_loop(c, t, own, col);
  if (!t->extended) tm_rates_coefficient_loop(c, t, own, col);
  else {
    u.viscosity = 1; /* with factors of 0 where it is off */
    u.artstress = 0;
    u.conduction = 0;
    if (TM_COLUMN == 1) tm_rates_coefficient_loop(c, &u, own, col);
    else if (t->sizes) {
      u.sizes = 1;
      tm_rates_coefficient_loop(c, &u, own, col);
    } else {
      u.sizes = 0;
      tm_rates_coefficient_loop(c, &u, own, col);
    }
  }
  tm_rates_rare_coefficients(c, t, own, col);
}

#endif
