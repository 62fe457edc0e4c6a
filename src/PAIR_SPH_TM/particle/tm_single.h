/* SPH-TM: records of particles for pair arithmetic in single. The state, the sums over neighbors and everything outside
   the rate pass stay in double.

   Lengths are in units of one length (the particle spacing), masses in density times a power of it,
   all else in the units of the run: so no power of a length leaves the range of single.

   Positions are whole numbers of a unit, modulo 2^32. The difference of two is exact as long as it is
   below 2^31 units, wherever the body is. The period of 2^32 units is at least four times the cutoff
   of neighbor rows: neighbors are told from their copies a period away unless they move three times
   the cutoff without new rows. The unit is below 2^-29 cutoffs of a row, 1/50 of what single resolves
   of the distance itself.

   Stress, velocity and temperature are rounded once, here, to 2^-24 of their value: the two
   particles of a pair see the same numbers. The prediction rounds the records it makes (tm_predict_args.single); those
   that change behind it, and those of ghosts, are rounded in a pass of their own. */
#ifndef TM_SINGLE_H
#define TM_SINGLE_H

#include "tm_record.h"

#include <string.h>

typedef struct {
  tm_records rec; /* in double, owned and ghost */
  tm_records_single single;
  int first; /* particle number 0 of the loop */
} tm_single_args;

/* Unit of positions for rows that hold neighbors up to cutoff away, in units of length. */
TM_FN tm_real tm_single_position_unit(tm_real cutoff, tm_real length)
{
  int bits;
  frexp(4.0 * cutoff / length, &bits);
  return ldexp(1.0, bits - 32);
}

/* Largest coordinate, in units of length, that double resolves to half a unit of position. */
TM_FN tm_real tm_single_farthest(tm_real position) { return ldexp(position, 52); }

TM_FN float tm_single_position(tm_real x, tm_real units)
{
  const unsigned whole = (unsigned) (long long) (x * units);
  float out;
  memcpy(&out, &whole, sizeof(out));
  return out;
}

/* The records of particle i. */
TM_FN void tm_single(int i, const tm_single_args *a, unsigned effects)
{
  const tm_records_single *s = &a->single;
  const tm_real *r = tm_main_record(&a->rec, i);
  const tm_real units = 1.0 / (s->length * s->position);
  float *out = s->main + tm_packed(i, TM_REC, 4);
  for (int c = 0; c < 3; c++) out[c] = tm_single_position(r[tm_part(c)], units);
  out[TM_REC_M] = (float) (r[tm_part(TM_REC_M)] / s->volume);
  const int whole = !s->stab || (effects & TM_FX_BALSARA); /* else the rates find stress and sound speed elsewhere */
  for (int c = TM_REC_V; c < (whole ? (int) TM_REC : (int) TM_REC_P); c++)
    out[tm_packed_part(c, 4)] = (float) r[tm_part(c)];
  if (s->more) {
    float *more = s->more + tm_packed(i, TM_MORE, 4);
    const tm_real *q = a->rec.stress + tm_record(i, TM_REC_STRESS);
    const tm_real *t = a->rec.heat + tm_record(i, TM_REC_HEAT);
    for (int c = 0; c < TM_REC_STRESS; c++)
      more[tm_packed_part(c, 4)] = (effects & TM_FX_ARTSTRESS) ? (float) q[tm_part(c)] : 0;
    for (int c = 0; c < TM_REC_HEAT; c++)
      more[tm_packed_part(TM_MORE_HEAT + c, 4)] = (effects & TM_FX_CONDUCTION) ? (float) t[tm_part(c)] : 0;
  }
  if (s->correction)
    for (int c = 0; c < TM_REC_CORRECTION; c++)
      s->correction[(ptrdiff_t) i * TM_REC_CORRECTION + c] =
          (float) a->rec.correction[(ptrdiff_t) i * TM_REC_CORRECTION + c];
  if (s->stab) {
    const tm_real *q = tm_stab_record(&a->rec, i);
    float *out_stab = s->stab + tm_packed(i, TM_REC_STAB, 4);
    for (int c = 0; c < TM_REC_STAB; c++)
      out_stab[tm_packed_part(c, 4)] =
          c < tm_stab_used(&a->rec)
              ? (float) (c >= TM_STAB_W && c < TM_STAB_K ? q[tm_part(c)] / s->length : q[tm_part(c)])
              : 0.0f;
  }
  if (effects & TM_FX_SMOOTHING) {
    const tm_real *z = a->rec.size + (ptrdiff_t) i * TM_REC_SIZE;
    float *size = s->size + (ptrdiff_t) i * TM_REC_SIZE;
    size[TM_SIZE_INV_H] = (float) (z[TM_SIZE_INV_H] * s->length);
    size[TM_SIZE_FACTOR] = (float) z[TM_SIZE_FACTOR]; /* without a unit */
    size[TM_SIZE_TENSILE] = (float) z[TM_SIZE_TENSILE];
    size[TM_SIZE_DP] = (float) (z[TM_SIZE_DP] / s->length);
  }
}

#endif
