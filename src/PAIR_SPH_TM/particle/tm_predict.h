/* SPH-TM: prediction of one particle to the half step, written into its record.

   The state itself stays at the full step; only the record, which the rates read, is ahead. The
   artificial stress follows from the record alone, for many particles at once. */
#ifndef TM_PREDICT_H
#define TM_PREDICT_H

#include "tm_balance.h"
#include "tm_contact_layer.h"
#include "tm_damage.h"
#include "tm_eos.h"
#include "tm_heat.h"
#include "tm_hourglass.h"
#include "tm_shocked.h"
#include "tm_single.h"
#include "tm_size.h"
#include "tm_state.h"
#include "tm_transpose.h"

#if TM_SINGLE
#error "double only: prediction has the precision of the state"
#endif

typedef struct {
  tm_state state;
  tm_records rec;
  tm_real dt_ahead;         /* time from the state to the force point: dt/2, or 0 at set-up */
  tm_real art_eps;          /* artificial stress epsilon, 0..1 */
  const tm_real *gradient;  /* tm_gradient_table, with particles of their own size */
  int art_component;        /* nonzero: F14 (18) per component instead of principal axes */
  const tm_real *share;     /* tm_tensile_table where the artificial stress is balanced, else NULL */
  tm_real hourglass;        /* xi of hourglass control, below 0: from the stress */
  tm_real visc_alpha;       /* linear viscosity of pairs */
  tm_real shock;            /* bulk viscosity in shocks */
  tm_real h;                /* smallest smoothing length: the time of damping by hourglass control is that over c */
  tm_real *correction;      /* 6, K at the force point, with one pass */
  tm_real *turn;            /* 3, its antisymmetric part, with TM_FX_FACES */
  tm_real ratio;            /* h over spacing, of particles without a size of their own */
  tm_records_single single; /* the record is rounded into these too, where there is a main one */
} tm_predict_args;

/* Velocity of particle i at the force point. */
TM_FN tm_vec3 tm_predict_velocity(int i, const tm_predict_args *a, int dim3)
{
  const tm_predict_weights w = tm_predict_weights_at(a->dt_ahead);
  const tm_real *h1 = tm_field_row(&a->state, TM_F_HISTORY, i), *h2 = h1 + tm_column(TM_H_STEP);
  const tm_vec3 last = tm_vec_from_row_in(h1 + tm_column(TM_H_V), dim3);
  const tm_vec3 older = tm_vec_from_row_in(h2 + tm_column(TM_H_V), dim3);
  return tm_vec_axpy(tm_vec_axpy(tm_load3(a->state.v + 3 * (ptrdiff_t) i), w.last, last), w.older, older);
}

/* What hourglass control exports; dev and p: stress of the material. Failed particles and those without strength have no
   stiffness, only damping. */
TM_FN void tm_predict_hourglass(int i, const tm_predict_args *a, tm_sym3 dev, tm_real p, unsigned effects)
{
  const tm_state *s = &a->state;
  const tm_material *m = s->material + s->type[i];
  const tm_real *r = tm_main_record(&a->rec, i), c = r[tm_part(TM_REC_C)];
  const tm_real k = r[tm_part(TM_REC_RHO)] * c * c; /* in plane stress times the thickness */
  const tm_real lz = (effects & TM_FX_PLANE_STRESS) ? *tm_field_row(s, TM_F_THICKNESS, i) : 1.0;
  const int failed = (effects & TM_FX_DAMAGE) && tm_field_row(s, TM_F_DAMAGE, i)[tm_column(1)] > 0.5;
  const int drawn = (effects & TM_FX_ONE_PASS) && (effects & TM_FX_PLASTICITY);
  const tm_real eps_p = drawn ? *tm_field_row(s, TM_F_PSTRAIN, i) : 0.0;
  const tm_real xi = k > 0.0 && m->strength != TM_STRENGTH_NONE && !failed
                         ? tm_hourglass_stiffness(a->hourglass, dev, p, k / lz, eps_p)
                         : 0.0;
  const tm_real delay = k > 0.0 ? TM_HOURGLASS_DAMPING * a->h / c : 0.0;
  const tm_vec3 W =
      tm_hourglass_displacement(tm_field_row(s, TM_F_HOURGLASS, i), a->dt_ahead, xi, delay, (effects & TM_FX_3D) != 0);
  if (effects & TM_FX_ONE_PASS) {
    tm_real *out = tm_stab_record(&a->rec, i);
    out[tm_part(TM_STAB_W)] = W.x;
    out[tm_part(TM_STAB_W + 1)] = W.y;
    out[tm_part(TM_STAB_W + 2)] = W.z;
    out[tm_part(TM_STAB_K)] = k;
  } else {
    tm_real *out = a->rec.hourglass + (ptrdiff_t) i * TM_REC_HOURGLASS;
    out[0] = W.x;
    out[1] = W.y;
    out[2] = W.z;
    out[TM_HOURGLASS_K] = k;
  }
}

/* The pressure in shocks, but not at the set-up, which knows no rates or those of another set-up. */
TM_FN_APART tm_real tm_predict_shock(int i, const tm_predict_args *a, tm_real rho_rate, tm_real rho, tm_real c,
                                     unsigned effects)
{
  const tm_real h = tm_particle_h(&a->state, i, a->h, effects);
  if (!tm_shock_reaches(i, &a->state, a->shock, rho_rate, rho, c, h, effects)) return 0.0;
  const tm_sym3 K =
      tm_turned_correction(tm_field_row(&a->state, TM_F_CORRECTION, i), a->dt_ahead, (effects & TM_FX_3D) != 0);
  return tm_shocked(i, &a->state, a->shock, rho_rate, rho, c, h, 2.0 * a->dt_ahead, K, effects);
}

/* The record of particle i, all but the artificial stress. */
TM_FN void tm_predict(int i, const tm_predict_args *a, unsigned effects)
{
  effects &= TM_FX_PRESENT;
  const tm_state *s = &a->state;
  const tm_material *m = s->material + s->type[i];
  const tm_predict_weights w = tm_predict_weights_at(a->dt_ahead);
  const tm_real *h1 = tm_field_row(s, TM_F_HISTORY, i), *h2 = h1 + tm_column(TM_H_STEP);

  const int dim3 = (effects & TM_FX_3D) != 0;
  const tm_vec3 v = tm_predict_velocity(i, a, dim3);
  const tm_real rho =
      *tm_field_row(s, TM_F_RHO, i) + w.last * h1[tm_column(TM_H_RHO)] + w.older * h2[tm_column(TM_H_RHO)];
  tm_sym3 dev = tm_sym_from_row_in(tm_field_row(s, TM_F_STRESS, i), dim3);
  dev = tm_sym_axpy(dev, w.last, tm_sym_from_row_in(h1 + tm_column(TM_H_S), dim3));
  dev = tm_sym_axpy(dev, w.older, tm_sym_from_row_in(h2 + tm_column(TM_H_S), dim3));

  tm_real e = 0.0, p = 0.0, c = 0.0;
  if (effects & TM_FX_ENERGY) e = tm_predict_value(tm_field_row(s, TM_F_ENERGY, i), w);
  const tm_real T = (effects & TM_FX_HEAT) ? tm_predict_value(tm_field_row(s, TM_F_TEMP, i), w) : 0.0;
  if (m->body == TM_BODY_SOLID) {
    p = tm_eos_pressure(m, rho * tm_particle_growth(s, i, m, T, effects), e);
    c = tm_eos_sound_speed(m, rho, e);
  }
  const int failed = (effects & TM_FX_DAMAGE) && tm_field_row(s, TM_F_DAMAGE, i)[tm_column(1)] > 0.5;
  p = tm_damage_pressure(p, failed);
  if (failed) dev = tm_sym(0, 0, 0, 0, 0, 0);
  else if (effects & TM_FX_PLANE_STRESS) p = dev.zz; /* sigma_zz = s_zz - p = 0 */

  /* plane stress: sums run over areas, so density and stress count times the thickness */
  const tm_real lz = (effects & TM_FX_PLANE_STRESS) ? *tm_field_row(s, TM_F_THICKNESS, i) : 1.0;
  const tm_real rho_sum = rho * lz;
  const tm_real scale = (effects & TM_FX_FORM_F14) ? lz : lz / (rho_sum * rho_sum);
  const tm_real q = a->shock > 0.0 && m->body == TM_BODY_SOLID
                        ? tm_predict_shock(i, a, h1[tm_column(TM_H_RHO)], rho, c, effects)
                        : 0.0;
  const tm_sym3 sigma = tm_sym_add_iso(dev, -p - q);
  tm_sym3 P = tm_sym_scale(scale, sigma);
  if (s->field[TM_F_LAYER]) /* not thicker in plane stress: the force is that on the whole thickness */
    P = tm_sym_axpy(P, scale / lz, tm_layer_stress(tm_field_row(s, TM_F_LAYER, i)));

  tm_real *r = tm_main_record(&a->rec, i);
  const double *x = s->x + 3 * (ptrdiff_t) i;
  for (int k = 0; k < 3; k++) r[tm_part(TM_REC_X + k)] = x[k];
  r[tm_part(TM_REC_M)] = tm_particle_mass(s, i);
  r[tm_part(TM_REC_V)] = v.x;
  r[tm_part(TM_REC_V + 1)] = v.y;
  r[tm_part(TM_REC_V + 2)] = v.z;
  r[tm_part(TM_REC_RHO)] = rho_sum;
  tm_sym_to_record(r, TM_REC_P, P);
  r[tm_part(TM_REC_C)] = c;
  r[tm_part(TM_REC_BALSARA)] = (effects & TM_FX_BALSARA) ? *tm_field_row(s, TM_F_BALSARA, i) : 1.0;

  if (effects & TM_FX_SMOOTHING)
    tm_size_record(tm_field_row(s, TM_F_SIZE, i), r[tm_part(TM_REC_M)] / rho_sum, a->gradient, tm_fx_kernel(effects),
                   dim3, a->rec.size + (ptrdiff_t) i * TM_REC_SIZE);
  if (effects & TM_FX_HOURGLASS) tm_predict_hourglass(i, a, dev, p, effects);
  if ((effects & TM_FX_ONE_PASS) && !(effects & TM_FX_FACES))
    tm_stab_record(&a->rec, i)[tm_part(TM_STAB_C)] = a->visc_alpha * c;
  if (effects & TM_FX_ONE_PASS) {
    const tm_sym3 K = tm_turned_correction(tm_field_row(s, TM_F_CORRECTION, i), a->dt_ahead, dim3);
    tm_sym_to_row(a->correction + tm_row(i, 6), K);
    if (effects & TM_FX_FACES) {
      const tm_face f =
          tm_turned_face(tm_field_row(s, TM_F_FACE, i), tm_field_row(s, TM_F_CORRECTION, i), a->dt_ahead, dim3);
      tm_vec_to_row(a->turn + tm_row(i, 3), f.turn);
      tm_vec_to_record(tm_stab_record(&a->rec, i), TM_STAB_FACE, f.normal);
      tm_mat_to_record(tm_stab_record(&a->rec, i), TM_STAB_PK,
                       tm_mat_mul(tm_mat_from_sym(P), tm_mat_transposed(tm_face_matrix(K, f.turn))));
    } else tm_mat_to_record(tm_stab_record(&a->rec, i), TM_STAB_PK, tm_sym_mul(P, K));
  }
  if (effects & TM_FX_HEAT) {
    tm_real *rt = tm_heat_record(&a->rec, i);
    rt[tm_part(TM_REC_T)] = T;
    rt[tm_part(TM_REC_K)] = tm_conductivity(m, T);
  }
}

/* One particle of a chunk: col[c * TM_COLUMN] holds P, and receives the artificial stress. */
TM_FN void tm_predict_tensile(tm_real *col, tm_real eps, tm_real scale, int component, int dim3)
{
  const tm_sym3 P =
      tm_sym(col[0], col[TM_COLUMN], col[2 * TM_COLUMN], col[3 * TM_COLUMN], col[4 * TM_COLUMN], col[5 * TM_COLUMN]);
  const tm_sym3 q = component ? tm_artificial_stress_component(P, eps, scale, dim3)
                              : tm_artificial_stress_principal(P, eps, scale, dim3);
  col[0] = q.xx;
  col[TM_COLUMN] = q.yy;
  col[2 * TM_COLUMN] = q.zz;
  col[3 * TM_COLUMN] = q.xy;
  col[4 * TM_COLUMN] = q.xz;
  col[5 * TM_COLUMN] = q.yz;
}

/* P - share R for P, in the units of P. */
TM_FN void tm_predict_balance(int i, const tm_predict_args *a, unsigned effects)
{
  const tm_real *size = (effects & TM_FX_SMOOTHING) ? tm_field_row(&a->state, TM_F_SIZE, i) : NULL;
  const tm_real *q = tm_stress_record(&a->rec, i);
  tm_real *r = tm_main_record(&a->rec, i), rho = r[tm_part(TM_REC_RHO)];
  const tm_real share = tm_share_of(a->share, size, a->ratio) * ((effects & TM_FX_FORM_F14) ? rho * rho : 1.0);
  for (int c = 0; c < TM_REC_STRESS; c++) r[tm_part(TM_REC_P + c)] -= share * q[tm_part(c)];
}

/* The artificial stress of particles begin to end - 1, of sigma/rho^2, in chunks. */
TM_FN void tm_predict_artstress(int begin, int end, const tm_predict_args *a, unsigned effects)
{
  const int dim3 = (effects & TM_FX_3D) != 0, form_f14 = (effects & TM_FX_FORM_F14) != 0;
  const tm_real eps = a->art_eps;
  int jj[TM_COLUMN];
  tm_real TM_ALIGNED col[TM_REC_STRESS][TM_COLUMN], scale[TM_COLUMN];
  for (; begin < end; begin += TM_CHUNK) {
    const int n = end - begin < TM_CHUNK ? end - begin : TM_CHUNK;
    const int lanes = (n + TM_TURNS - 1) / TM_TURNS * TM_TURNS;
    for (int l = 0; l < lanes; l++) {
      const int j = begin + (l < n ? l : 0);
      const tm_real rho = tm_main_record(&a->rec, j)[tm_part(TM_REC_RHO)];
      jj[tm_at(l)] = j;
      scale[tm_at(l)] = form_f14 ? 1.0 / (rho * rho) : 1.0;
    }
    if (TM_COLUMN > 1) tm_transpose_rows(a->rec.main + TM_REC_P, TM_REC, jj, lanes, TM_REC_STRESS, col[0]);
    else
      for (int c = 0; c < TM_REC_STRESS; c++) col[c][0] = tm_main_record(&a->rec, begin)[tm_part(TM_REC_P + c)];
    if (a->art_component)
      for (int l = 0; l < lanes; l++) tm_predict_tensile(col[0] + tm_at(l), eps, scale[tm_at(l)], 1, dim3);
    else if (dim3) {
#if !defined(__CUDACC__)
#pragma omp simd
#endif
      for (int l = 0; l < lanes; l++) tm_predict_tensile(col[0] + tm_at(l), eps, scale[tm_at(l)], 0, 1);
    } else
      for (int l = 0; l < lanes; l++) tm_predict_tensile(col[0] + tm_at(l), eps, scale[tm_at(l)], 0, 0);
    for (int l = 0; l < n; l++) {
      tm_real *q = tm_stress_record(&a->rec, begin + l);
      for (int c = 0; c < TM_REC_STRESS; c++) q[tm_part(c)] = col[c][tm_at(l)];
      if (a->share) tm_predict_balance(begin + l, a, effects);
    }
  }
}

/* Behind prediction and artificial stress. */
TM_FN void tm_predict_single(int i, const tm_predict_args *a, unsigned effects)
{
  const tm_single_args of = {a->rec, a->single, 0};
  if (a->single.main) tm_single(i, &of, effects);
}

#endif
