/* SPH-TM: records of particles: what their neighbors read of them, packed for the gather.

   The main record is 16 reals. The others exist only with their effect. tm_layout.h says where the
   columns of a record lie; P K is a plain row everywhere.

   P is what the momentum sum needs of one particle: sigma / rho^2 in the form F15 (4), sigma in
   the form F14 (6). With gradient correction the sums use the nine components of P K instead, K
   the correction of tm_moment.h, so that pair forces stay equal and opposite. */
#ifndef TM_RECORD_H
#define TM_RECORD_H

#include "tm_effects.h"
#include "tm_layout.h"

enum {
  TM_REC_X = 0,        /* position x y z */
  TM_REC_M = 3,        /* mass */
  TM_REC_V = 4,        /* velocity x y z */
  TM_REC_RHO = 7,      /* density (plane stress: density times relative thickness) */
  TM_REC_P = 8,        /* xx yy zz xy xz yz */
  TM_REC_C = 14,       /* longitudinal sound speed */
  TM_REC_BALSARA = 15, /* shear switch 0..1 */
  TM_REC = 16
};
enum { TM_REC_STRESS = 6 };                           /* artificial stress, xx yy zz xy xz yz */
enum { TM_REC_T = 0, TM_REC_K = 1, TM_REC_HEAT = 2 }; /* temperature, conductivity */
enum { TM_REC_CORRECTION = 9 };                       /* P K, row major */
/* 1/h, correction of sums over gradW (tm_lattice.h), 1/W of the reference spacing of the artificial
   stress over W(0)'s norm, edge of the particle; see tm_size.h */
enum { TM_SIZE_INV_H = 0, TM_SIZE_FACTOR = 1, TM_SIZE_TENSILE = 2, TM_SIZE_DP = 3, TM_REC_SIZE = 4 };

/* displacement against the neighborhood x y z, stiffness against it (pressure); see tm_hourglass.h */
enum { TM_HOURGLASS_K = 3, TM_REC_HOURGLASS = 4 };

/* With both in the rate pass (TM_FX_ONE_PASS): P K row major, the displacement of hourglass control with the share of its
   rate that damps, rho c^2, alpha c of the linear viscosity; the rest is not used. With TM_FX_FACES P K^T, and b of tm_face.h in
   place of alpha c. */
enum { TM_STAB_PK = 0, TM_STAB_W = 9, TM_STAB_K = 12, TM_STAB_C = 13, TM_STAB_USED = 14, TM_REC_STAB = 16 };
enum { TM_STAB_FACE = 13 };
enum { TM_STAB_FETCHED = TM_SINGLE ? (int) TM_REC_STAB : (int) TM_STAB_USED }; /* columns that come together */

typedef struct {
  tm_real *main;       /* TM_REC per particle, owned and ghost */
  tm_real *stress;     /* TM_REC_STRESS, or NULL */
  tm_real *heat;       /* TM_REC_HEAT, or NULL */
  tm_real *correction; /* TM_REC_CORRECTION, or NULL */
  tm_real *size;       /* TM_REC_SIZE, or NULL: all particles have the size of the pair style */
  tm_real *hourglass;  /* TM_REC_HOURGLASS, or NULL */
  tm_real *stab;       /* TM_REC_STAB, or NULL */
  int faces;           /* stab has normals of faces */
} tm_records;

/* Columns of stab that are in use. */
TM_FN int tm_stab_used(const tm_records *rec) { return rec->faces ? (int) TM_REC_STAB : (int) TM_STAB_USED; }

/* The same for pair arithmetic in single, see tm_single.h. */
enum { TM_MORE = 8, TM_MORE_HEAT = 6 }; /* artificial stress, temperature, conductivity */

typedef struct {
  float *main;       /* TM_REC per particle; the position is three whole numbers; 4 columns together */
  float *more;       /* TM_MORE, or NULL; 4 columns together */
  float *correction; /* TM_REC_CORRECTION, or NULL */
  float *size;       /* TM_REC_SIZE, or NULL */
  float *stab;       /* TM_REC_STAB, or NULL; 4 columns together */
  tm_real length;    /* lengths are in units of this */
  tm_real volume;    /* masses in density times this, length^dim */
  float position;    /* unit of positions, in units of length: a power of two */
  float visc_alpha, visc_beta;
} tm_records_single;

/* Record of particle i; column c is its entry tm_part(c). */
TM_FN tm_real *tm_main_record(const tm_records *rec, int i) { return rec->main + tm_record(i, TM_REC); }
TM_FN tm_real *tm_stress_record(const tm_records *rec, int i) { return rec->stress + tm_record(i, TM_REC_STRESS); }
TM_FN tm_real *tm_stab_record(const tm_records *rec, int i) { return rec->stab + tm_record(i, TM_REC_STAB); }
TM_FN tm_real *tm_heat_record(const tm_records *rec, int i) { return rec->heat + tm_record(i, TM_REC_HEAT); }

#endif
