/* SPH-TM: the per-particle state, as one table.

   Every array that belongs to a particle stands here once: its name, its number of columns and
   the effects that call for it (0: always). What no effect of the scene calls for is not
   allocated. State fields travel with the particle (migration, sorting, restart files). */
#ifndef TM_FIELDS_H
#define TM_FIELDS_H

#include "tm_effects.h"

enum tm_field_id {
  TM_F_RHO = 0,    /* density */
  TM_F_STRESS,     /* deviatoric Cauchy stress xx yy zz xy xz yz */
  TM_F_HISTORY,    /* rates of the last two steps: v(3) rho(1) s(6), newer first */
  TM_F_PSTRAIN,    /* equivalent plastic strain, its rate, and the last flow stress */
  TM_F_TEMP,       /* temperature, its rates of the last two steps */
  TM_F_ENERGY,     /* specific internal energy */
  TM_F_DAMAGE,     /* damage 0..1, and 1 when failed */
  TM_F_BALSARA,    /* shear switch of the last step, 0..1 */
  TM_F_XSPH,       /* XSPH velocity of the last step */
  TM_F_THICKNESS,  /* plane stress: thickness over initial thickness */
  TM_F_COUNT
};

/* columns of TM_F_HISTORY: one step back, then two steps back */
enum { TM_H_V = 0, TM_H_RHO = 3, TM_H_S = 4, TM_H_STEP = 10, TM_H_COLUMNS = 20 };

typedef struct {
  const char *name;
  int columns;
  unsigned effects;   /* any of these bits allocates the field; 0: always */
} tm_field;

static const tm_field tm_field_table[TM_F_COUNT] = {
  {"density", 1, 0},
  {"stress", 6, 0},
  {"history", TM_H_COLUMNS, 0},
  {"plastic strain", 3, TM_FX_PLASTICITY},
  {"temperature", 3, TM_FX_HEAT},
  {"energy", 1, TM_FX_ENERGY},
  {"damage", 2, TM_FX_DAMAGE},
  {"balsara", 1, TM_FX_BALSARA},
  {"xsph", 3, TM_FX_XSPH},
  {"thickness", 1, TM_FX_PLANE_STRESS}
};

#endif
