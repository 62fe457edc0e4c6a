/* SPH-TM: what the update of a particle (tm_update.h) takes, reads and returns. */
#ifndef TM_UPDATE_ARGS_H
#define TM_UPDATE_ARGS_H

#include "tm_hourglass.h"
#include "tm_residual.h"
#include "tm_state.h"
#include "tm_time_step.h"

#include <limits.h>

enum tm_status {
  TM_OK = 0,
  TM_BAD_NAN = 1,         /* a state value is not finite */
  TM_BAD_DENSITY = 2,     /* density not positive */
  TM_BAD_VELOCITY = 3,    /* faster than ten times the speed of sound */
  TM_BAD_TEMPERATURE = 4, /* temperature not positive */
  TM_BAD_HEAT = 5,        /* temperature above the largest that the run allows */
  TM_BAD_VOLUME = 6,      /* density over or under the reference by more than the run allows */
  TM_BAD_STRAIN = 7       /* more plastic strain in a step than TM_STRAIN_STEP */
};
#define TM_STRAIN_STEP 1.0

typedef struct {
  tm_state state;
  tm_records rec;
  const tm_real *gradient, *heat, *xsph_v, *hourglass_rate, *artificial;
  const tm_real *face_next;  /* TM_FACE_COLUMNS of the force point, with TM_FX_FACES */
  const tm_real *moment;     /* TM_MOMENT_COLUMNS of the force point, with one pass */
  const tm_real *correction; /* and the one that was predicted for it and used */
  const tm_real *uneven;     /* 3, sum V_j gradW of the force point with shifting, 0 of what is touched; else NULL */
  const tm_real *share;      /* of the balanced artificial stress, see tm_predict.h */
  tm_real ratio;
  const double *force_internal; /* force of the pair style alone, with the ledger */
  tm_real *source;              /* heat given to the particle by contact and fluxes (power); emptied */
  int group;                    /* x and v are integrated for these */
  int held;                     /* groups that other fixes move or hold: not shifted */
  tm_real dt, visc_alpha;
  tm_real shock;            /* bulk viscosity in shocks */
  tm_real hourglass;        /* xi of hourglass control, below 0: from the stress */
  tm_real h;                /* smoothing length of all, where particles have none of their own */
  tm_real accel_unit;       /* force of the unit style / mass -> acceleration */
  tm_real temperature;      /* of every particle where heat is off */
  tm_real heat_rate, k_max; /* see tm_heat_time_step */
  tm_real hottest;          /* largest temperature that goes on */
  tm_real densest;          /* largest ratio of density and reference density, either way, that goes on */
  int watch_melt;           /* look for particles above their melting temperature */
} tm_update_args;

typedef struct {
  int status;     /* enum tm_status */
  int particle;   /* whose status it is */
  int melted;     /* the first particle above its melting temperature, or INT_MAX */
  tm_real dt[3];  /* limits by sound, force, conduction (without safety factor) */
  tm_real speed2; /* square of the largest speed; a way in the second half of the step counts as one of that half */
  /* energies of the step, with the ledger. stress_work: of the stress that acted, sigma(n+1/2) : L; failure: what was
     stored in a particle that failed; thermal_pressure: work of the part of the pressure that heat makes; compression:
     stored energy that compression turns into heat;
     heat: thermal energy gained, without that of the artificial terms */
  tm_real stress_work, plastic, plastic_heat, failure, thermal_pressure, compression, artificial, kinetic_work,
      internal_work, heat;
  tm_real shock; /* of artificial, what the bulk viscosity of shocks gives */
} tm_update_result;

TM_FN tm_update_result tm_update_nothing(void)
{
  tm_update_result r;
  r.status = TM_OK;
  r.particle = r.melted = INT_MAX;
  r.dt[0] = r.dt[1] = r.dt[2] = TM_DT_NO_LIMIT;
  r.speed2 = 0.0;
  r.stress_work = r.plastic = r.plastic_heat = r.failure = r.thermal_pressure = r.compression = r.artificial = 0.0;
  r.kinetic_work = r.internal_work = r.heat = r.shock = 0.0;
  return r;
}

/* Adds to the sums over particles: limits are lowered, the first status stays. */
TM_FN void tm_update_sum(tm_update_result *sum, const tm_update_result *r, int ledger)
{
  for (int k = 0; k < 3; k++) sum->dt[k] = tm_min(sum->dt[k], r->dt[k]);
  if (r->status != TM_OK && r->particle < sum->particle) {
    sum->status = r->status;
    sum->particle = r->particle;
  }
  if (r->melted < sum->melted) sum->melted = r->melted;
  if (r->speed2 > sum->speed2) sum->speed2 = r->speed2;
  if (!ledger) return;
  sum->stress_work += r->stress_work;
  sum->plastic += r->plastic;
  sum->plastic_heat += r->plastic_heat;
  sum->failure += r->failure;
  sum->thermal_pressure += r->thermal_pressure;
  sum->compression += r->compression;
  sum->artificial += r->artificial;
  sum->kinetic_work += r->kinetic_work;
  sum->internal_work += r->internal_work;
  sum->heat += r->heat;
  sum->shock += r->shock;
}

/* What of a particle an update reads in scenes without rare effects, 0 where an effect is off: all of it before anything is
   written, so that a GPU waits for memory once. */
typedef struct {
  tm_vec3 x, v, force;
  tm_real mass;
  tm_real rec_mass, rec_rho, rho;  /* those of the record are at the force point */
  tm_real T, T_rate, heat, source; /* temperature, its last rate; power per volume conducted, power of sources */
  /* of solid particles */
  tm_real sound; /* of the record */
  tm_mat3 L;
  tm_sym3 s, older;        /* deviator; its rate two steps back */
  tm_real rate[TM_H_STEP]; /* history, one step back */
  tm_real eps_p;
  tm_real artificial;      /* power */
  tm_correction_last last; /* with one pass: of K; K and what was predicted for it */
  tm_sym3 K, predicted;
  tm_vec3 u, u_rate; /* of hourglass control */
} tm_update_read;

/* Of the columns of a step of the history (tm_fields.h) those that a plane has not, where they are 0. */
TM_FN int tm_history_across(int k) { return k == TM_H_V + 2 || k >= TM_H_S + 4; }

TM_FN tm_update_read tm_update_read_of(int i, const tm_update_args *a, int solid, unsigned effects)
{
  const tm_state *s = &a->state;
  const int dim3 = (effects & TM_FX_3D) != 0;
  const tm_vec3 none = tm_vec(0, 0, 0);
  const tm_real *rec = tm_main_record(&a->rec, i);
  tm_update_read r;
  r.x = tm_load3(s->x + 3 * (ptrdiff_t) i);
  r.v = tm_load3(s->v + 3 * (ptrdiff_t) i);
  r.force = s->mask[i] & a->group ? tm_load3(s->force + 3 * (ptrdiff_t) i) : none;
  r.mass = tm_particle_mass(s, i);
  r.rec_mass = rec[tm_part(TM_REC_M)];
  r.rec_rho = rec[tm_part(TM_REC_RHO)];
  const tm_real *T = (effects & TM_FX_HEAT) ? tm_field_row(s, TM_F_TEMP, i) : NULL;
  r.T = T ? T[0] : a->temperature;
  r.T_rate = T ? T[tm_column(1)] : 0.0;
  r.heat = (effects & TM_FX_CONDUCTION) ? a->heat[i] : 0.0;
  r.source = a->source ? a->source[i] : 0.0;
  r.rho = *tm_field_row(s, TM_F_RHO, i);
  r.sound = r.eps_p = r.artificial = 0.0;
  r.L = tm_mat_scale(0.0, tm_mat_identity());
  r.s = r.older = r.K = r.predicted = tm_sym(0, 0, 0, 0, 0, 0);
  for (int k = 0; k < TM_H_STEP; k++) r.rate[k] = 0.0;
  r.last.known = r.last.since = 0.0;
  r.last.rate = r.s;
  r.u = r.u_rate = none;
  if (!solid) return r;

  const tm_real *history = tm_field_row(s, TM_F_HISTORY, i);
  r.sound = rec[tm_part(TM_REC_C)];
  r.L = tm_mat_from_row_in(a->gradient + tm_row(i, 9), dim3);
  r.s = tm_sym_from_row_in(tm_field_row(s, TM_F_STRESS, i), dim3);
  r.older = tm_sym_from_row_in(history + tm_column(TM_H_STEP + TM_H_S), dim3);
  for (int k = 0; k < TM_H_STEP; k++)
    if (dim3 || !tm_history_across(k)) r.rate[k] = history[tm_column(k)];
  if (effects & TM_FX_PLASTICITY) r.eps_p = tm_field_row(s, TM_F_PSTRAIN, i)[0];
  if (a->artificial) r.artificial = a->artificial[i];
  if (effects & TM_FX_ONE_PASS) {
    r.last = tm_correction_last_of(tm_field_row(s, TM_F_CORRECTION, i), dim3);
    r.K = tm_sym_from_row_in(a->moment + tm_row(i, TM_MOMENT_COLUMNS), dim3);
    r.predicted = tm_sym_from_row_in(a->correction + tm_row(i, 6), dim3);
  }
  if (effects & TM_FX_HOURGLASS) {
    r.u = tm_vec_from_row_in(tm_field_row(s, TM_F_HOURGLASS, i) + tm_column(TM_G_U), dim3);
    r.u_rate = tm_vec_from_row_in(a->hourglass_rate + tm_row(i, 3), dim3);
  }
  return r;
}

#endif
