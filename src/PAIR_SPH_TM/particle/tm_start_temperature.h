/* SPH-TM: the temperature that a particle starts with, and keeps where temperature is not a state: that of all, or of the
   last group of the particle that was given one. */
#ifndef TM_START_TEMPERATURE_H
#define TM_START_TEMPERATURE_H

#include "tm_real.h"

enum { TM_START_GROUPS = 32 }; /* LAMMPS has no more */

typedef struct {
  tm_real of_all;              /* K */
  int n;                       /* groups with a temperature of their own */
  int bit[TM_START_GROUPS];    /* of the mask of a particle */
  tm_real of[TM_START_GROUPS]; /* K */
} tm_start_temperatures;

TM_FN tm_real tm_start_temperature(const tm_start_temperatures *s, int mask)
{
  for (int g = s->n - 1; g >= 0; g--)
    if (mask & s->bit[g]) return s->of[g];
  return s->of_all;
}

#endif
