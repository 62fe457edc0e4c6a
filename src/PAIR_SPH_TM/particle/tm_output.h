/* SPH-TM: values of a particle for output, in the units of the run. */
#ifndef TM_OUTPUT_H
#define TM_OUTPUT_H

#include "tm_active.h"
#include "tm_damage.h"
#include "tm_eos.h"
#include "tm_fracture.h"
#include "tm_state.h"
#include "tm_surface.h"

/* what there is, and its name in compute sph/tm/atom */
#define TM_OUTPUT_TABLE(VALUE)             \
  VALUE(TM_OUT_DENSITY, "density")         \
  VALUE(TM_OUT_TEMPERATURE, "temperature") \
  VALUE(TM_OUT_PSTRAIN, "pstrain")         \
  VALUE(TM_OUT_RATE, "pstrain/rate")       \
  VALUE(TM_OUT_FLOW, "flowstress")         \
  VALUE(TM_OUT_MISES, "vonmises")          \
  VALUE(TM_OUT_PRESSURE, "pressure")       \
  VALUE(TM_OUT_TRIAXIALITY, "triaxiality") \
  VALUE(TM_OUT_XX, "stress/xx")            \
  VALUE(TM_OUT_YY, "stress/yy")            \
  VALUE(TM_OUT_ZZ, "stress/zz")            \
  VALUE(TM_OUT_XY, "stress/xy")            \
  VALUE(TM_OUT_XZ, "stress/xz")            \
  VALUE(TM_OUT_YZ, "stress/yz")            \
  VALUE(TM_OUT_DAMAGE, "damage")           \
  VALUE(TM_OUT_FAILED, "failed")           \
  VALUE(TM_OUT_ENERGY, "energy")           \
  VALUE(TM_OUT_THICKNESS, "thickness")     \
  VALUE(TM_OUT_SOUND, "soundspeed")        \
  VALUE(TM_OUT_H, "h")                     \
  VALUE(TM_OUT_LEVEL, "level")             \
  VALUE(TM_OUT_NEIGHBORS, "neighbors")     \
  VALUE(TM_OUT_ADAPTNODE, "adaptnode")     \
  VALUE(TM_OUT_SEARCHES, "searches")       \
  VALUE(TM_OUT_AREA, "surface/area")       \
  VALUE(TM_OUT_HOURGLASS, "hourglass")     \
  VALUE(TM_OUT_FRACTURE, "fracture")       \
  VALUE(TM_OUT_ACTIVE, "active")

#define TM_OUTPUT_ID(id, name) id,
enum tm_output_id { TM_OUTPUT_TABLE(TM_OUTPUT_ID) TM_OUT_COUNT };
#undef TM_OUTPUT_ID

typedef struct {
  tm_state state;
  unsigned effects;
  int group;                /* 0 for all others */
  const tm_real *main;      /* records, with surface */
  const tm_real *surface;   /* 3 per particle, or NULL */
  const tm_real *neighbors; /* number of neighbors of each, or NULL */
  const tm_real *lists;     /* history of total-Lagrangian lists, or NULL: all particles are updated-Lagrangian */
  int lists_columns, was_ul, ul_steps; /* columns of the history, and which are shown */
  tm_surface measure;
  tm_real temperature, h;          /* of all, where they are no state */
  tm_real stress, density, energy; /* unit of the run -> mass, length, time */
  int columns;
  const int *wanted; /* enum tm_output_id of each column */
  double *value;     /* results, columns per particle */
} tm_output_args;

TM_FN tm_real tm_output_state(int i, const tm_output_args *a, int id, int column, tm_real otherwise)
{
  return a->state.field[id] ? tm_field_row(&a->state, id, i)[tm_column(column)] : otherwise;
}

TM_FN tm_real tm_output_pressure(int i, const tm_output_args *a, const tm_material *m)
{
  if (m->body != TM_BODY_SOLID) return 0.0;
  const int failed = tm_output_state(i, a, TM_F_DAMAGE, 1, 0.0) > 0.5;
  if ((a->effects & TM_FX_PLANE_STRESS) && !failed) return tm_output_state(i, a, TM_F_STRESS, 2, 0.0);
  const tm_real e = tm_output_state(i, a, TM_F_ENERGY, 0, 0.0);
  const tm_real growth = tm_particle_growth(&a->state, i, m, tm_output_state(i, a, TM_F_TEMP, 0, 0.0), a->effects);
  return tm_damage_pressure(tm_eos_pressure(m, growth * tm_output_state(i, a, TM_F_RHO, 0, 0.0), e), failed);
}

TM_FN tm_real tm_output_area(int i, const tm_output_args *a)
{
  if (!a->surface) return 0.0;
  const tm_real *g = a->surface + 3 * (ptrdiff_t) i, *r = a->main + tm_record(i, TM_REC);
  return tm_surface_area(&a->measure, tm_vec(g[0], g[1], g[2]), r[tm_part(TM_REC_M)] / r[tm_part(TM_REC_RHO)]);
}

TM_FN tm_real tm_output_value(int which, int i, const tm_output_args *a)
{
  const tm_material *m = a->state.material + a->state.type[i];
  const tm_real to_stress = 1.0 / a->stress;
  switch (which) {
    case TM_OUT_DENSITY: return tm_output_state(i, a, TM_F_RHO, 0, 0.0) / a->density;
    case TM_OUT_TEMPERATURE:
      return (a->effects & TM_FX_HEAT) ? tm_output_state(i, a, TM_F_TEMP, 0, 0.0) : a->temperature;
    case TM_OUT_PSTRAIN: return tm_output_state(i, a, TM_F_PSTRAIN, 0, 0.0);
    case TM_OUT_RATE: return tm_output_state(i, a, TM_F_PSTRAIN, 1, 0.0);
    case TM_OUT_FLOW: return to_stress * tm_output_state(i, a, TM_F_PSTRAIN, 2, 0.0);
    case TM_OUT_MISES: return to_stress * tm_sym_mises(tm_sym_from_row(tm_field_row(&a->state, TM_F_STRESS, i)));
    case TM_OUT_PRESSURE: return to_stress * tm_output_pressure(i, a, m);
    case TM_OUT_TRIAXIALITY: { /* mean stress over von Mises stress */
      const tm_real mises = tm_sym_mises(tm_sym_from_row(tm_field_row(&a->state, TM_F_STRESS, i)));
      return mises > 0.0 ? -tm_output_pressure(i, a, m) / mises : 0.0;
    }
    case TM_OUT_XX:
    case TM_OUT_YY:
    case TM_OUT_ZZ:
    case TM_OUT_XY:
    case TM_OUT_XZ:
    case TM_OUT_YZ: {
      const int k = which - TM_OUT_XX;
      return to_stress *
             (tm_field_row(&a->state, TM_F_STRESS, i)[tm_column(k)] - (k < 3 ? tm_output_pressure(i, a, m) : 0.0));
    }
    case TM_OUT_DAMAGE: return tm_output_state(i, a, TM_F_DAMAGE, 0, 0.0);
    case TM_OUT_FAILED: return tm_output_state(i, a, TM_F_DAMAGE, 1, 0.0) > 0.5 ? 1.0 : 0.0;
    case TM_OUT_ENERGY: return tm_output_state(i, a, TM_F_ENERGY, 0, 0.0) / a->energy;
    case TM_OUT_THICKNESS: return tm_output_state(i, a, TM_F_THICKNESS, 0, 1.0);
    case TM_OUT_SOUND:
      return m->body == TM_BODY_SOLID ? tm_eos_sound_speed(m, tm_output_state(i, a, TM_F_RHO, 0, 0.0),
                                                           tm_output_state(i, a, TM_F_ENERGY, 0, 0.0))
                                      : 0.0;
    case TM_OUT_H: return tm_output_state(i, a, TM_F_SIZE, TM_S_H, a->h);
    case TM_OUT_NEIGHBORS: return a->neighbors ? a->neighbors[i] : 0.0;
    case TM_OUT_ADAPTNODE: return a->lists ? a->lists[(ptrdiff_t) i * a->lists_columns + a->was_ul] : 1.0;
    case TM_OUT_SEARCHES: return a->lists ? a->lists[(ptrdiff_t) i * a->lists_columns + a->ul_steps] : 0.0;
    case TM_OUT_AREA: return tm_output_area(i, a);
    case TM_OUT_FRACTURE:
      return tm_output_state(i, a, TM_F_FRACTURE, TM_R_STATE, 0.0) == (tm_real) TM_FRACTURE_TORN ? 1.0 : 0.0;
    case TM_OUT_ACTIVE: {
      const int kind = (int) tm_output_state(i, a, TM_F_ACTIVE, 0, (tm_real) TM_ACTIVE_MOVES);
      return kind == TM_ACTIVE_ASLEEP ? 0.0 : kind == TM_ACTIVE_EDGE ? 1.0 : 2.0;
    }
    case TM_OUT_HOURGLASS:
      return tm_vec_norm(tm_vec(tm_output_state(i, a, TM_F_HOURGLASS, TM_G_U, 0.0),
                                tm_output_state(i, a, TM_F_HOURGLASS, TM_G_U + 1, 0.0),
                                tm_output_state(i, a, TM_F_HOURGLASS, TM_G_U + 2, 0.0)));
    default: return 0.0; /* level: fix adapt/neigh knows it, on the host */
  }
}

/* The row of particle i. */
TM_FN void tm_output(int i, const tm_output_args *a)
{
  double *row = a->value + (ptrdiff_t) i * a->columns;
  const int in = a->state.mask[i] & a->group;
  for (int k = 0; k < a->columns; k++) row[k] = in ? tm_output_value(a->wanted[k], i, a) : 0.0;
}

#endif
