/* SPH-TM: the per-particle state, as one table.

   Every array that belongs to a particle stands here once: its name, its number of columns and
   the effects that call for it (0: always). What no effect of the scene calls for is not
   allocated. State fields travel with the particle (migration, sorting, restart files). */
#ifndef TM_FIELDS_H
#define TM_FIELDS_H

#include "tm_effects.h"

/* columns of the history: one step back, then two steps back */
enum { TM_H_V = 0, TM_H_RHO = 3, TM_H_S = 4, TM_H_STEP = 10, TM_H_COLUMNS = 20 };
/* columns of the size */
enum { TM_S_H = 0, TM_S_DP = 1, TM_S_RATIO = 2, TM_S_TARGET = 3, TM_S_COLUMNS = 4 };

/* columns of the reference */
enum { TM_R_X = 0, TM_R_B = 3, TM_R_STATE = 6, TM_R_COLUMNS = 7 };
/* columns of the hourglass */
enum { TM_G_U = 0, TM_G_RATE = 3, TM_G_COLUMNS = 6 };
/* columns of the correction */
enum { TM_K_MATRIX = 0, TM_K_SPIN = 6, TM_K_SINCE = 9, TM_K_RATE = 10, TM_K_COLUMNS = 16 };

/* columns of the face */
enum { TM_FACE_NORMAL = 0, TM_FACE_TURN = 3, TM_FACE_COLUMNS = 6 };

/* columns of the layer */
enum { TM_L_STRESS = 0, TM_L_STRAIN = 6, TM_L_NEAR = 7, TM_L_TOOL = 8, TM_L_AHEAD = 9, TM_L_COLUMNS = 10 };

/*  stress       deviatoric Cauchy stress xx yy zz xy xz yz
    history      rates of the last two steps: v(3) rho(1) s(6), newer first
    pstrain      equivalent plastic strain, its rate, and the last flow stress
    temperature  and its rates of the last two steps
    energy       specific internal energy, and its rates of the last two steps
    damage       0..1, and 1 when failed
    balsara      shear switch of the last step, 0..1
    xsph         XSPH velocity of the last step
    thickness    plane stress: thickness over initial thickness
    size         smoothing length; edge (m/rho0)^(1/d) of the particle without stress; smoothing length
                 over spacing it was made with; target n_h of its neighborhood (0: not known yet)
    reference    place and sum of the bonds to its neighbors where they were taken as whole, and what has become of
                 it, see tm_fracture.h
    hourglass    displacement against the neighborhood, see tm_hourglass.h, and its rate in the last step
    correction   of the gradients at the last force point, xx yy zz xy xz yz, xx = 0: not known yet; twice the spin there,
             L.zy - L.yz, L.xz - L.zx, L.yx - L.xy; the time since then; and its rate but for the spin
    face         normal of a free face, and the antisymmetric part of the correction there, see tm_face.h
    unstrained   temperature at which there is no thermal strain
    layer        beneath the surface of a tool, see tm_contact_layer.h: stress of the tool's force at the next force
                 point; strain since the tool is near; whether it is near; which tool; what
                 was predicted of the stress along the normal
    active       enum tm_activity: moves, stands at the edge of the active region, or sleeps */
#define TM_FIELD_TABLE(FIELD)                                        \
  FIELD(TM_F_RHO, "density", 1, 0)                                   \
  FIELD(TM_F_STRESS, "stress", 6, 0)                                 \
  FIELD(TM_F_HISTORY, "history", TM_H_COLUMNS, 0)                    \
  FIELD(TM_F_PSTRAIN, "plastic strain", 3, TM_FX_PLASTICITY)         \
  FIELD(TM_F_TEMP, "temperature", 3, TM_FX_HEAT)                     \
  FIELD(TM_F_ENERGY, "energy", 3, TM_FX_ENERGY)                      \
  FIELD(TM_F_DAMAGE, "damage", 2, TM_FX_DAMAGE)                      \
  FIELD(TM_F_BALSARA, "balsara", 1, TM_FX_BALSARA)                   \
  FIELD(TM_F_XSPH, "xsph", 3, TM_FX_XSPH)                            \
  FIELD(TM_F_THICKNESS, "thickness", 1, TM_FX_PLANE_STRESS)          \
  FIELD(TM_F_SIZE, "size", TM_S_COLUMNS, TM_FX_SMOOTHING)            \
  FIELD(TM_F_HOURGLASS, "hourglass", TM_G_COLUMNS, TM_FX_HOURGLASS)  \
  FIELD(TM_F_FRACTURE, "reference", TM_R_COLUMNS, TM_FX_FRACTURE)    \
  FIELD(TM_F_CORRECTION, "correction", TM_K_COLUMNS, TM_FX_ONE_PASS) \
  FIELD(TM_F_FACE, "face", TM_FACE_COLUMNS, TM_FX_FACES)             \
  FIELD(TM_F_UNSTRAINED, "unstrained", 1, TM_FX_EXPANSION)           \
  FIELD(TM_F_LAYER, "layer", TM_L_COLUMNS, TM_FX_LAYER)              \
  FIELD(TM_F_ACTIVE, "active", 1, TM_FX_ACTIVE)

#define TM_FIELD(id, name, columns, effects) id,
enum tm_field_id { TM_FIELD_TABLE(TM_FIELD) TM_F_COUNT };
#undef TM_FIELD

/* columns of all fields */
#define TM_FIELD(id, name, columns, effects) +(columns)
enum { TM_FIELDS_COLUMNS = 0 TM_FIELD_TABLE(TM_FIELD) };
#undef TM_FIELD

typedef struct {
  const char *name;
  int columns;
  unsigned effects; /* any of these bits allocates the field; 0: always */
} tm_field;

#define TM_FIELD(id, name, columns, effects) {name, columns, effects},
static const tm_field tm_field_table[TM_F_COUNT] = {TM_FIELD_TABLE(TM_FIELD)};
#undef TM_FIELD

/* The same for device code, which cannot see the table. */
#define TM_FIELD(id, name, columns, effects) \
  case id: return columns;
TM_FN int tm_field_columns(int field)
{
  switch (field) {
    TM_FIELD_TABLE(TM_FIELD)
    default: return 0;
  }
}
#undef TM_FIELD

#endif
