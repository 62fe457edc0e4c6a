/* SPH-TM: every constant of one material, as one plain struct that goes to the device as it is.

   All values are in the units of the running simulation (the LAMMPS `units` style); material
   cards are in SI and converted when read. Stress is positive in tension, pressure in
   compression. */
#ifndef TM_MATERIAL_H
#define TM_MATERIAL_H

#include "tm_real.h"

enum tm_eos { TM_EOS_LINEAR = 0, TM_EOS_SHOCK = 1, TM_EOS_TAIT = 2 };
enum tm_strength {
  TM_STRENGTH_ELASTIC = 0,
  TM_STRENGTH_PLASTIC = 1,      /* perfectly plastic or bilinear isotropic hardening */
  TM_STRENGTH_JOHNSON_COOK = 2,
  TM_STRENGTH_NONE = 3          /* no deviatoric stress: a fluid */
};
enum tm_damage { TM_DAMAGE_NONE = 0, TM_DAMAGE_STRAIN = 1, TM_DAMAGE_JOHNSON_COOK = 2 };

/* What a body of this type takes part in. */
enum tm_body_kind {
  TM_BODY_SOLID = 0,            /* mechanics, and heat where the scene has it */
  TM_BODY_HEAT = 1              /* conducts heat only: particles inside a rigid tool */
};

#define TM_TABLE_MAX 16

/* Piecewise linear table in temperature, constant outside; n = 0: use value. */
typedef struct {
  int n;
  tm_real value;                /* the constant when n = 0 */
  tm_real t[TM_TABLE_MAX];      /* temperature, strictly increasing */
  tm_real y[TM_TABLE_MAX];
} tm_table;

typedef struct {
  /* elastic */
  tm_real rho0;                 /* reference density */
  tm_real young, poisson;       /* Young's modulus (stress), Poisson's ratio (-1 < nu < 0.5) */
  tm_real shear, bulk;          /* derived: G = E/(2(1+nu)), K = E/(3(1-2nu)) */
  int body;                     /* enum tm_body_kind */

  /* equation of state */
  int eos;                      /* enum tm_eos */
  tm_real eos_c0;               /* shock: bulk sound speed at rho0; linear, tait: sqrt(K/rho0) */
  tm_real eos_s;                /* shock: slope of U_s = c0 + s u_p */
  tm_real eos_gamma;            /* shock: Grueneisen coefficient at rho0 */
  tm_real eos_n;                /* tait: exponent */

  /* strength */
  int strength;                 /* enum tm_strength */
  tm_real yield, hardening;     /* plastic: Y = yield + hardening * eps_p, H = E Et/(E-Et) */
  tm_real jc_a, jc_b, jc_n;     /* Johnson-Cook Y = (A+B eps^n)(1+C ln rate*)(1-T*^m) */
  tm_real jc_c, jc_m;
  tm_real jc_rate0;             /* reference plastic strain rate (1/time) */
  tm_real t_ref, t_melt;        /* T* = (T-t_ref)/(t_melt-t_ref), clamped to [0,1] */

  /* damage */
  int damage;                   /* enum tm_damage */
  tm_real d1, d2, d3, d4, d5;   /* Johnson-Cook eps_f = (D1+D2 exp(D3 s*))(1+D4 ln rate*)(1+D5 T*) */
  tm_real strain_max;           /* plastic strain at failure */

  /* heat */
  int heat;                     /* nonzero when the thermal constants were given */
  tm_table conductivity;        /* k(T), power / (length temperature) */
  tm_table capacity;            /* c_p(T), energy / (mass temperature) */
  tm_real taylor_quinney;       /* share of plastic work that becomes heat, 0..1 */
  tm_real emissivity;           /* for radiation, 0..1 */
} tm_material;

#endif
