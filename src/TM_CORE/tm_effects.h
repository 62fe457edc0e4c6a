/* SPH-TM: the effects a scene can ask for, as bits of one unsigned.

   Particle functions take these bits as their last argument. The launchers pass literals, so
   that an effect which is off leaves no branch, no load and no array in the machine code. The
   bits of TM_FX_RATE_MASK are literal in every rate loop; those of TM_FX_EXTENDED_MASK are
   tested at run time inside the one "extended" instantiation per kernel and dimension, and are
   absent from all the others. With viscosity, smoothing alone, faces alone, Balsara's switch and XSPH have loops of their
   own (effect_sets.h). */
#ifndef TM_EFFECTS_H
#define TM_EFFECTS_H

#include "tm_real.h"

enum tm_effect {
  TM_FX_3D = 1 << 0,         /* three dimensions */
  TM_FX_VISCOSITY = 1 << 1,  /* Monaghan artificial viscosity */
  TM_FX_ARTSTRESS = 1 << 2,  /* artificial stress against the tensile instability */
  TM_FX_CONDUCTION = 1 << 3, /* heat conduction between particles */
  TM_FX_EXTENDED = 1 << 4,   /* this instantiation reads the bits below at run time */

  TM_FX_FORM_F14 = 1 << 5,   /* momentum form F14 (6) instead of F15 (4) */
  TM_FX_CORRECTION = 1 << 6, /* kernel-gradient correction */
  TM_FX_BALSARA = 1 << 7,    /* shear switch of the artificial viscosity */
  TM_FX_XSPH = 1 << 8,       /* positions move with a smoothed velocity */
  TM_FX_SURFACE = 1 << 9,    /* free surface area and normal per particle */

  TM_FX_HEAT = 1 << 10,         /* temperature is a state */
  TM_FX_PLASTICITY = 1 << 11,   /* plastic strain is a state */
  TM_FX_DAMAGE = 1 << 12,       /* damage is a state */
  TM_FX_ENERGY = 1 << 13,       /* specific internal energy is a state (shock equation of state) */
  TM_FX_PLANE_STRESS = 1 << 14, /* 2D with free thickness */
  TM_FX_BODIES = 1 << 15,       /* contact between particle bodies */
  TM_FX_LEDGER = 1 << 16,       /* energy bookkeeping */
  TM_FX_SMOOTHING = 1 << 17,    /* smoothing length and size of each particle of its own */
  TM_FX_MIXED = 1 << 18,        /* pair arithmetic in single */
  TM_FX_HOURGLASS = 1 << 19,    /* hourglass control (zero-energy modes) */

  TM_FX_KERNEL_SHIFT = 20,          /* three bits of enum tm_kernel */
  TM_FX_ONE_PASS = 1 << 23,         /* correction and hourglass control within the rate pass, see tm_hourglass.h */
  TM_FX_FRACTURE = 1 << 24,         /* count of particles that lose neighbors without damage */
  TM_FX_ACTIVE = 1 << 25,           /* particles at rest away from the active region sleep: tm_active.h */
  TM_FX_FACES = 1 << 26,            /* gradients of second order at free faces, with TM_FX_ONE_PASS: tm_face.h */
  TM_FX_LAYER = 1 << 27,            /* the half spacing beneath a tool takes part in the strain: tm_contact_layer.h */
  TM_FX_EXPANSION = 1 << 28,        /* thermal expansion; the temperature without thermal strain is a state */
  TM_FX_COMPRESSION_HEAT = 1 << 29, /* compression changes the temperature */
  TM_FX_ARTIFICIAL_HEAT = 1 << 30,  /* what artificial terms take out of the motion heats */
  TM_FX_SHIFTING = -2147483647 - 1  /* 1 << 31 as an int: positions of what flows are kept even, tm_shift.h */
};

#define TM_FX_RATE_MASK ((unsigned) (TM_FX_3D | TM_FX_VISCOSITY | TM_FX_ARTSTRESS | TM_FX_CONDUCTION | TM_FX_ONE_PASS))
#define TM_FX_EXTENDED_MASK                                                                                       \
  ((unsigned) (TM_FX_FORM_F14 | TM_FX_CORRECTION | TM_FX_BALSARA | TM_FX_XSPH | TM_FX_SURFACE | TM_FX_SMOOTHING | \
               TM_FX_FACES))
#define TM_FX_KERNEL_MASK (7u << TM_FX_KERNEL_SHIFT)

/* Effects a build has: all, or of those that a scene may call for only TM_FX_MINIMAL, and the others
   are not in its machine code (CMake: SPHTM_MINIMAL_EFFECTS). */
#ifdef TM_FX_MINIMAL
#define TM_FX_PRESENT                                                                                       \
  ((unsigned) (TM_FX_MINIMAL) |                                                                             \
   ~((unsigned) (TM_FX_VISCOSITY | TM_FX_ARTSTRESS | TM_FX_CONDUCTION | TM_FX_CORRECTION | TM_FX_BALSARA |  \
                 TM_FX_XSPH | TM_FX_SURFACE | TM_FX_HEAT | TM_FX_PLASTICITY | TM_FX_DAMAGE | TM_FX_ENERGY | \
                 TM_FX_BODIES | TM_FX_LEDGER | TM_FX_SMOOTHING | TM_FX_HOURGLASS | TM_FX_EXPANSION |        \
                 TM_FX_COMPRESSION_HEAT | TM_FX_ARTIFICIAL_HEAT | TM_FX_FACES)))
#else
#define TM_FX_PRESENT (~0u)
#endif

TM_FN int tm_fx_kernel(unsigned fx) { return (int) ((fx >> TM_FX_KERNEL_SHIFT) & 7u); }

#endif
