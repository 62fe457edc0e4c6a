/* SPH-TM: every constant of one material, as one plain struct that goes to the device as it is.

   All values are in the units of the running simulation (the LAMMPS `units` style); material
   cards are in SI and converted when read. Stress is positive in tension, pressure in
   compression. */
#ifndef TM_MATERIAL_H
#define TM_MATERIAL_H

#include "tm_real.h"

enum tm_eos { TM_EOS_LINEAR = 0, TM_EOS_SHOCK = 1, TM_EOS_TAIT = 2 };

/* The laws of strength: number, name in 'strength <name>', what the flow stress depends on, the constants that follow
   the name. A law stands here and in tm_flow_stress; parsing, cards, units, restart files, messages and the choice of
   effects follow. The numbers are in restart files. */
enum tm_flow_kind {
  TM_FLOW_NONE = 0,   /* no plastic flow */
  TM_FLOW_STRAIN = 1, /* on plastic strain */
  TM_FLOW_THERMAL = 2 /* on plastic strain, its rate and temperature, up to the constant t_melt */
};
#define TM_STRENGTH_LAWS(LAW)                                                                                         \
  LAW(TM_STRENGTH_ELASTIC, 0, "elastic", TM_FLOW_NONE, "")                                                            \
  LAW(TM_STRENGTH_PLASTIC, 1, "plastic", TM_FLOW_STRAIN, "yield hardening")                                           \
  LAW(TM_STRENGTH_JOHNSON_COOK, 2, "johnson/cook", TM_FLOW_THERMAL, "jc_a jc_b jc_n jc_c jc_m t_ref t_melt jc_rate0") \
  LAW(TM_STRENGTH_JOHNSON_COOK_TANH, 4, "johnson/cook/tanh", TM_FLOW_THERMAL,                                         \
      "jc_a jc_b jc_n jc_c jc_m t_ref t_melt jc_rate0 tanh_a tanh_b tanh_d tanh_r tanh_s")                            \
  LAW(TM_STRENGTH_ZERILLI_ARMSTRONG, 5, "zerilli/armstrong", TM_FLOW_THERMAL,                                         \
      "za_c0 za_c1 za_c2 za_c3 za_c4 za_c5 za_n za_rate0 t_melt")                                                     \
  LAW(TM_STRENGTH_NONE, 3, "none", TM_FLOW_NONE, "") /* no deviatoric stress: a fluid */

/* Their constants: name for 'set' and messages, unit and range (material_constants.h). Laws may share constants. */
#define TM_STRENGTH_CONSTANTS(CONSTANT)                                                                        \
  /* plastic: Y = yield + hardening eps_p, hardening = E Et/(E - Et) */                                        \
  CONSTANT(yield, STRESS, NOT_NEGATIVE)                                                                        \
  CONSTANT(hardening, STRESS, NOT_NEGATIVE)                                                                    \
  /* Johnson-Cook: Y = (A + B eps^n)(1 + C ln rate*)(1 - T*^m), T* = (T - t_ref)/(t_melt - t_ref) in [0, 1] */ \
  CONSTANT(jc_a, STRESS, NOT_NEGATIVE)                                                                         \
  CONSTANT(jc_b, STRESS, NOT_NEGATIVE)                                                                         \
  CONSTANT(jc_n, PLAIN, NOT_NEGATIVE)                                                                          \
  CONSTANT(jc_c, PLAIN, NOT_NEGATIVE)                                                                          \
  CONSTANT(jc_m, PLAIN, POSITIVE)                                                                              \
  CONSTANT(jc_rate0, RATE, POSITIVE)                                                                           \
  CONSTANT(t_ref, TEMPERATURE, NOT_NEGATIVE)                                                                   \
  CONSTANT(t_melt, TEMPERATURE, POSITIVE)                                                                      \
  /* Johnson-Cook TANH, exponents of the softening: tm_flow_tanh */                                            \
  CONSTANT(tanh_a, PLAIN, NOT_NEGATIVE)                                                                        \
  CONSTANT(tanh_b, PLAIN, NOT_NEGATIVE)                                                                        \
  CONSTANT(tanh_d, PLAIN, NOT_NEGATIVE)                                                                        \
  CONSTANT(tanh_r, PLAIN, NOT_NEGATIVE)                                                                        \
  CONSTANT(tanh_s, PLAIN, NOT_NEGATIVE)                                                                        \
  /* Zerilli-Armstrong: tm_flow_zerilli_armstrong */                                                           \
  CONSTANT(za_c0, STRESS, NOT_NEGATIVE)                                                                        \
  CONSTANT(za_c1, STRESS, NOT_NEGATIVE)                                                                        \
  CONSTANT(za_c2, STRESS, NOT_NEGATIVE)                                                                        \
  CONSTANT(za_c3, PER_TEMPERATURE, NOT_NEGATIVE)                                                               \
  CONSTANT(za_c4, PER_TEMPERATURE, NOT_NEGATIVE)                                                               \
  CONSTANT(za_c5, STRESS, NOT_NEGATIVE)                                                                        \
  CONSTANT(za_n, PLAIN, NOT_NEGATIVE)                                                                          \
  CONSTANT(za_rate0, RATE, POSITIVE)

#define TM_LAW(id, number, name, flow, constants) id = number,
enum tm_strength { TM_STRENGTH_LAWS(TM_LAW) TM_STRENGTH_LAST };
#undef TM_LAW

/* enum tm_flow_kind of a law */
#define TM_LAW(id, number, name, flow, constants) \
  case id: return flow;
TM_FN int tm_strength_flow(int strength)
{
  switch (strength) {
    TM_STRENGTH_LAWS(TM_LAW)
    default: return TM_FLOW_NONE;
  }
}
#undef TM_LAW

enum tm_damage { TM_DAMAGE_NONE = 0, TM_DAMAGE_STRAIN = 1, TM_DAMAGE_JOHNSON_COOK = 2 };

/* What a body of this type takes part in. */
enum tm_body_kind {
  TM_BODY_SOLID = 0, /* mechanics, and heat where the scene has it */
  TM_BODY_HEAT = 1   /* conducts heat only: particles inside a rigid tool */
};

#define TM_TABLE_MAX 16

/* Piecewise linear table in temperature, constant outside; n = 0: use value. */
typedef struct {
  int n;
  tm_real value;           /* the constant when n = 0 */
  tm_real t[TM_TABLE_MAX]; /* temperature, strictly increasing */
  tm_real y[TM_TABLE_MAX];
} tm_table;

typedef struct {
  /* elastic */
  tm_real rho0;           /* reference density */
  tm_real young, poisson; /* Young's modulus (stress), Poisson's ratio (-1 < nu < 0.5) */
  tm_real shear, bulk;    /* derived: G = E/(2(1+nu)), K = E/(3(1-2nu)) */
  int body;               /* enum tm_body_kind */

  /* equation of state */
  int eos;           /* enum tm_eos */
  tm_real eos_c0;    /* shock: bulk sound speed at rho0; linear, tait: sqrt(K/rho0) */
  tm_real eos_s;     /* shock: slope of U_s = c0 + s u_p */
  tm_real eos_gamma; /* shock: Grueneisen coefficient at rho0 */
  tm_real eos_n;     /* tait: exponent */

  /* strength */
  int strength; /* enum tm_strength */
#define TM_MEMBER(name, unit, range) tm_real name;
  TM_STRENGTH_CONSTANTS(TM_MEMBER)
#undef TM_MEMBER

  /* damage */
  int damage;                 /* enum tm_damage */
  tm_real d1, d2, d3, d4, d5; /* Johnson-Cook eps_f = (D1+D2 exp(D3 s*))(1+D4 ln rate*)(1+D5 T*) */
  tm_real strain_max;         /* plastic strain at failure */

  /* heat */
  int heat;               /* nonzero when the thermal constants were given */
  tm_table conductivity;  /* k(T), power / (length temperature) */
  tm_table capacity;      /* c_p(T), energy / (mass temperature) */
  tm_real taylor_quinney; /* share of plastic work that becomes heat, 0..1 */
  tm_real emissivity;     /* for radiation, 0..1 */
  tm_table expansion;     /* alpha(T) = d(thermal strain)/dT, 1/temperature; not read with a shock equation of state */
  /* derived, 0 where compression does not heat; see tm_capacity */
  tm_real capacity_less;  /* shock: 1 - c_v/c_p */
  tm_real expansion_work; /* linear, tait: 9 K/rho0 */
} tm_material;

#endif
