/* SPH-TM: what one particle adds to the sums that are printed. */
#ifndef TM_TALLY_H
#define TM_TALLY_H

#include "tm_state.h"

TM_FN tm_real tm_kinetic_energy(int i, const tm_state *s)
{
  const double *v = s->v + 3 * (ptrdiff_t) i;
  return 0.5 * tm_particle_mass(s, i) * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

typedef struct {
  tm_records rec;
  const int *type;
  const tm_material *material;
  tm_real to_energy;    /* mass length^2/time^2 -> energy of the unit style */
  double *per_particle; /* TM_TALLY per particle: energy, virial; or NULL */
} tm_tally_args;

enum { TM_TALLY = 7 };

typedef struct {
  tm_real value[TM_TALLY];
} tm_tally_result;

/* Elastic energy stored in the stress, and its virial -V sigma (xx yy zz xy xz yz). */
TM_FN tm_tally_result tm_tally(int i, const tm_tally_args *a, unsigned effects)
{
  tm_tally_result out;
  for (int k = 0; k < TM_TALLY; k++) out.value[k] = 0.0;
  const tm_material *m = a->material + a->type[i];
  if (m->body == TM_BODY_SOLID) {
    const tm_real *r = tm_main_record(&a->rec, i);
    const tm_real rho = r[tm_part(TM_REC_RHO)], volume = r[tm_part(TM_REC_M)] / rho;
    const tm_sym3 sigma = tm_sym_scale((effects & TM_FX_FORM_F14) ? 1.0 : rho * rho, tm_sym_from_record(r, TM_REC_P));
    const tm_sym3 s = tm_sym_deviator(sigma);
    const tm_real p = -tm_sym_trace(sigma) / 3.0;
    out.value[0] = volume * a->to_energy * (tm_sym_ddot(s, s) / (4.0 * m->shear) + p * p / (2.0 * m->bulk));
    tm_sym_store(out.value + 1, tm_sym_scale(-volume * a->to_energy, sigma));
  }
  if (a->per_particle)
    for (int k = 0; k < TM_TALLY; k++) a->per_particle[(ptrdiff_t) i * TM_TALLY + k] = out.value[k];
  return out;
}

TM_FN void tm_tally_sum(tm_tally_result *sum, const tm_tally_result *r)
{
  for (int k = 0; k < TM_TALLY; k++) sum->value[k] += r->value[k];
}

#endif
