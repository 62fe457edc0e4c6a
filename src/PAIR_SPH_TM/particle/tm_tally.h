/* SPH-TM: what one particle adds to the sums that are printed. */
#ifndef TM_TALLY_H
#define TM_TALLY_H

#include "tm_state.h"
#include "tm_stored_energy.h"

TM_FN tm_real tm_kinetic_energy(int i, const tm_state *s)
{
  const double *v = s->v + 3 * (ptrdiff_t) i;
  return 0.5 * tm_particle_mass(s, i) * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

TM_FN int tm_has_failed(const tm_state *s, int i)
{
  return s->field[TM_F_DAMAGE] && tm_field_row(s, TM_F_DAMAGE, i)[tm_column(1)] > 0.5;
}

/* Elastic energy of particle i at the end of the step, for the balance: its density counts with the thermal strain, whose
   work is summed beside it (tm_update.h). */
TM_FN tm_real tm_stored_in(int i, const tm_state *s)
{
  const tm_material *m = s->material + s->type[i];
  if (m->body != TM_BODY_SOLID) return 0.0;
  return tm_particle_mass(s, i) * tm_stored_energy(m, *tm_field_row(s, TM_F_RHO, i), 1.0,
                                                   tm_sym_from_row(tm_field_row(s, TM_F_STRESS, i)),
                                                   tm_has_failed(s, i));
}

/* Both, for sums; the elastic energy with the ledger. */
typedef struct {
  tm_real kinetic, stored;
} tm_energies;
TM_FN tm_energies tm_energies_of(int i, const tm_state *s, unsigned effects)
{
  const tm_energies e = {tm_kinetic_energy(i, s), (effects & TM_FX_LEDGER) ? tm_stored_in(i, s) : 0.0};
  return e;
}
TM_FN tm_energies tm_energies_nothing(void)
{
  const tm_energies none = {0.0, 0.0};
  return none;
}
TM_FN void tm_energies_sum(tm_energies *sum, const tm_energies *e)
{
  sum->kinetic += e->kinetic;
  sum->stored += e->stored;
}

typedef struct {
  tm_records rec;
  tm_state state;
  tm_real to_energy;    /* mass length^2/time^2 -> energy of the unit style */
  double *per_particle; /* TM_TALLY per particle: energy, virial; or NULL */
} tm_tally_args;

enum { TM_TALLY = 7 };

typedef struct {
  tm_real value[TM_TALLY];
} tm_tally_result;

/* At the force point: elastic energy stored in the stress, and its virial -V sigma (xx yy zz xy xz yz). In plane stress
   density and stress of the record count times the thickness. */
TM_FN tm_tally_result tm_tally(int i, const tm_tally_args *a, unsigned effects)
{
  tm_tally_result out;
  for (int k = 0; k < TM_TALLY; k++) out.value[k] = 0.0;
  const tm_material *m = a->state.material + a->state.type[i];
  if (m->body == TM_BODY_SOLID) {
    const tm_real *r = tm_main_record(&a->rec, i);
    const tm_real rho = r[tm_part(TM_REC_RHO)], volume = r[tm_part(TM_REC_M)] / rho;
    const tm_sym3 sigma = tm_sym_scale((effects & TM_FX_FORM_F14) ? 1.0 : rho * rho, tm_sym_from_record(r, TM_REC_P));
    const tm_real per_lz = (effects & TM_FX_PLANE_STRESS) ? 1.0 / *tm_field_row(&a->state, TM_F_THICKNESS, i) : 1.0;
    const tm_sym3 s = tm_sym_scale(per_lz, tm_sym_deviator(sigma));
    const tm_real T = (effects & TM_FX_EXPANSION) ? tm_heat_record(&a->rec, i)[tm_part(TM_REC_T)] : 0.0;
    out.value[0] = r[tm_part(TM_REC_M)] * a->to_energy *
                   tm_stored_energy(m, rho * per_lz, tm_particle_growth(&a->state, i, m, T, effects), s,
                                    tm_has_failed(&a->state, i));
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
