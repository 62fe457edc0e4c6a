/* SPH-TM: the state a new particle starts with, and the start of a run.

   Rows of new particles are zero, and no particle has density 0 later: so they are known by it. */
#ifndef TM_INITIAL_H
#define TM_INITIAL_H

#include "tm_size.h"
#include "tm_update.h"

typedef struct {
  tm_state state;
  unsigned fields; /* mask of the fields to be set, 1 << enum tm_field_id */
  tm_real temperature;
  tm_real ratio; /* smoothing length over spacing */
  int dim3;
} tm_initial_args;

/* The fields of particle i that do not start with 0. */
TM_FN void tm_initial(int i, const tm_initial_args *a)
{
  const tm_state *s = &a->state;
  if (a->fields & (1u << TM_F_TEMP)) {
    tm_real *t = tm_field_row(s, TM_F_TEMP, i);
    t[0] = a->temperature;
    t[tm_column(1)] = t[tm_column(2)] = 0.0;
  }
  if (a->fields & (1u << TM_F_UNSTRAINED)) *tm_field_row(s, TM_F_UNSTRAINED, i) = a->temperature;
  if (a->fields & (1u << TM_F_BALSARA)) *tm_field_row(s, TM_F_BALSARA, i) = 1.0;
  if (a->fields & (1u << TM_F_THICKNESS)) *tm_field_row(s, TM_F_THICKNESS, i) = 1.0;
  if (a->fields & (1u << TM_F_SIZE))
    tm_size_initial(tm_field_row(s, TM_F_SIZE, i), tm_particle_mass(s, i), s->material[s->type[i]].rho0, a->ratio,
                    a->dim3);
  if (a->fields & (1u << TM_F_RHO)) *tm_field_row(s, TM_F_RHO, i) = s->material[s->type[i]].rho0;
}

/* The same for particles that are new. */
TM_FN void tm_initial_of_new(int i, const tm_initial_args *a)
{
  if (*tm_field_row(&a->state, TM_F_RHO, i) == 0.0) tm_initial(i, a);
}

/* The rates at the set-up as history of the first prediction. */
TM_FN void tm_initial_history(int i, const tm_update_args *a, unsigned effects)
{
  const tm_state *s = &a->state;
  const tm_material *m = s->material + s->type[i];
  if (m->body != TM_BODY_SOLID) return;
  tm_real *h1 = tm_field_row(s, TM_F_HISTORY, i), *h2 = h1 + tm_column(TM_H_STEP);
  const double *f = s->force + 3 * (ptrdiff_t) i;
  const tm_real c = a->accel_unit / tm_particle_mass(s, i);
  if (s->mask[i] & a->group)
    for (int k = 0; k < ((effects & TM_FX_3D) ? 3 : 2); k++) h1[tm_column(TM_H_V + k)] = c * f[k];
  const tm_mat3 L = tm_mat_from_row(a->gradient + tm_row(i, 9));
  h1[tm_column(TM_H_RHO)] = -*tm_field_row(s, TM_F_RHO, i) * tm_mat_trace(L);
  if (m->strength != TM_STRENGTH_NONE)
    tm_sym_to_row(h1 + tm_column(TM_H_S),
                  tm_deviator_rate(tm_sym_from_row(tm_field_row(s, TM_F_STRESS, i)), L, m->shear));
  for (int k = 0; k < TM_H_STEP; k++) h2[tm_column(k)] = h1[tm_column(k)];
}

TM_FN tm_real tm_initial_speed2(const tm_state *s, int i)
{
  const tm_vec3 v = tm_load3(s->v + 3 * (ptrdiff_t) i);
  return tm_vec_dot(v, v);
}

/* Limits of the first time step, from the forces at the set-up; seeds the history where asked to. */
TM_FN tm_update_result tm_initial_limits(int i, const tm_update_args *a, unsigned effects, int seed)
{
  const tm_state *s = &a->state;
  const tm_material *m = s->material + s->type[i];
  const int dim3 = (effects & TM_FX_3D) != 0;
  const tm_real h = tm_particle_h(s, i, a->h, effects);
  tm_update_result out = tm_update_nothing();
  out.speed2 = tm_initial_speed2(s, i);
  if (seed) tm_initial_history(i, a, effects);
  const tm_real *moment = (effects & TM_FX_ONE_PASS) ? a->moment + tm_row(i, TM_MOMENT_COLUMNS) : NULL;
  if (moment && m->body == TM_BODY_SOLID) {
    tm_real *row = tm_field_row(s, TM_F_CORRECTION, i);
    if (row[0] == 0.0 && (effects & TM_FX_FACES))
      tm_face_step(tm_field_row(s, TM_F_FACE, i), a->face_next + tm_row(i, TM_FACE_COLUMNS), 1.0);
    if (row[0] == 0.0)
      tm_correction_step(row, NULL, tm_sym_from_row_in(moment, dim3), NULL, tm_mat_from_row(a->gradient + tm_row(i, 9)),
                         0.0, 0.0, dim3);
  }
  if (m->body == TM_BODY_SOLID) {
    const tm_real c = tm_main_record(&a->rec, i)[tm_part(TM_REC_C)];
    out.dt[TM_DT_SOUND] = tm_sound_time_step(tm_step_length(h, a->ratio), c, a->visc_alpha, a->hourglass, effects);
    const double *f = s->force + 3 * (ptrdiff_t) i;
    const tm_real acc = a->accel_unit / tm_particle_mass(s, i) * sqrt(f[0] * f[0] + f[1] * f[1] + f[2] * f[2]);
    if (s->mask[i] & a->group) out.dt[TM_DT_FORCE] = tm_force_time_step(h, acc);
  }
  if (effects & TM_FX_CONDUCTION)
    out.dt[TM_DT_CONDUCTION] = tm_conduction_time_step(m, *tm_field_row(s, TM_F_RHO, i),
                                                       tm_field_row(s, TM_F_TEMP, i)[0], h, a->k_max, a->heat_rate);
  return out;
}

#endif
