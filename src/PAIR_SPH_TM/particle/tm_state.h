/* SPH-TM: the state of all particles as raw pointers, and what the point functions share. */
#ifndef TM_STATE_H
#define TM_STATE_H

#include "tm_fields.h"
#include "tm_material.h"
#include "tm_record.h"
#include "tm_tensor.h"
#include "tm_thermoelastic.h"

/* Weight of the older rate in the prediction of the half step,
     y(n+1/2) = y(n) + dt ((1/2 + beta) r1 - beta r2),  r1, r2 = rates of the last two steps.
   Second order for every beta. beta = 0 is the modified Euler scheme that takes the last rate; on
   the imaginary axis (elastic waves) it grows by (omega dt)^4/4 a step whatever dt is. beta = 1/4
   decays by (omega dt)^4/8 and is stable up to omega dt = 0.78; on the negative real axis
   (viscosity, conduction) up to 2/3. */
#define TM_PREDICT_BETA 0.25

/* The same for a time dt_ahead from the state, dt/2: y + last r1 + older r2. */
typedef struct {
  tm_real last, older;
} tm_predict_weights;

TM_FN tm_predict_weights tm_predict_weights_at(tm_real dt_ahead)
{
  tm_predict_weights w;
  w.last = (1.0 + 2.0 * TM_PREDICT_BETA) * dt_ahead;
  w.older = -2.0 * TM_PREDICT_BETA * dt_ahead;
  return w;
}

/* Of a field of three columns: a value and its rates of the last two steps. */
TM_FN tm_real tm_predict_value(const tm_real *y, tm_predict_weights w)
{
  return y[0] + w.last * y[tm_column(1)] + w.older * y[tm_column(2)];
}

typedef struct {
  /* per particle, see tm_fields.h; NULL when the field is off */
  tm_real *field[TM_F_COUNT];
  double *x, *v, *force;
  const int *type, *mask;      /* LAMMPS types and group bits */
  const tm_material *material; /* indexed by type */
  const double *mass;          /* per type (index type), or NULL */
  const double *rmass;         /* per particle, or NULL */
} tm_state;

/* Row of particle i; column c is its entry tm_column(c). */
TM_FN tm_real *tm_field_row(const tm_state *s, int id, int i) { return s->field[id] + tm_row(i, tm_field_columns(id)); }
TM_FN tm_real tm_particle_mass(const tm_state *s, int i) { return s->rmass ? s->rmass[i] : s->mass[s->type[i]]; }
/* Volume of particle i at T over that without thermal strain; its pressure is that of its density times this. */
TM_FN tm_real tm_particle_growth(const tm_state *s, int i, const tm_material *m, tm_real T, unsigned effects)
{
  return (effects & TM_FX_EXPANSION) ? tm_thermal_growth(m, *tm_field_row(s, TM_F_UNSTRAINED, i), T) : 1.0;
}
/* Smoothing length of particle i; h is that of all where they do not differ. */
TM_FN tm_real tm_particle_h(const tm_state *s, int i, tm_real h, unsigned effects)
{
  return (effects & TM_FX_SMOOTHING) ? tm_field_row(s, TM_F_SIZE, i)[tm_column(TM_S_H)] : h;
}

#endif
