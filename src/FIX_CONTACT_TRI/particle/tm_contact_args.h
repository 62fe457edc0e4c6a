/* SPH-TM: what a contact loop of one tool works on: the tool, the particles, and where sums per triangle go. */
#ifndef TM_CONTACT_ARGS_H
#define TM_CONTACT_ARGS_H

#include "tm_contact.h"
#include "tm_material.h"
#include "tm_motion.h"
#include "tm_start_temperature.h"
#include "tm_touch.h"

/* Effects of the contact loop. */
enum tm_contact_effect {
  TM_CT_3D = 1 << 0,   /* z moves */
  TM_CT_HEAT = 1 << 1, /* friction heat and conduction into the particles */
  TM_CT_FRICTION = 1 << 2,
  TM_CT_APPROACH = 1 << 3,  /* no force while separating (F15's test) */
  TM_CT_F15 = 1 << 4,       /* F15's inside-outside test per triangle */
  TM_CT_TWO_SIDED = 1 << 5, /* the surface has no inside */
  TM_CT_OUTPUT = 1 << 6     /* add to the per-triangle arrays */
};

/* Where particles touch, for a contact loop that comes later in the step: of particle i place[i], 0 where it touches
   nothing, -1 where there was no room, else its number of places n, 1 to TM_TOUCH_MAX, and where they begin in touch:
   first * TM_FOUND + n. */
enum { TM_FOUND = 8 };
typedef struct {
  int *place; /* NULL: nobody has looked */
  tm_touch *touch;
  int *taken; /* entries of touch in use; 0 before the look */
  int room;   /* entries of touch, at most INT_MAX / TM_FOUND */
} tm_contact_found;

typedef struct tm_contact_args {
  tm_tri_view mesh;
  tm_grid_view grid;
  tm_pose pose;
  tm_vec3 reference; /* torques are about this point */
  tm_real deep;      /* how far behind the surface a center is still pushed out */
  tm_real dt;
  tm_real after;      /* from the force point to the end of the step: dt/2, or 0 */
  tm_real force_unit; /* mass times acceleration -> force of the unit style */
  tm_real tool_temperature;
  const tm_contact_law *law; /* per type, index type */
  const tm_real *size;       /* records of size (tm_record.h), or NULL: the law's */

  const int *mask; /* particles with (mask & group) are in contact; NULL: all */
  int group;
  const int *type;
  const double *x, *v;   /* position, velocity at the start */
  const tm_real *record; /* tm_record.h's, with the velocity at the force point; NULL: v */
  double *f;             /* forces so far in, contact added */
  ptrdiff_t x_stride, v_stride, f_stride;
  const double *mass, *rmass; /* per type; per particle or NULL */

  tm_start_temperatures start; /* of the particles, without TM_CT_HEAT */

  /* with TM_CT_HEAT */
  const tm_material *material; /* per type, for conductivity and capacity */
  const tm_real *temperature;
  ptrdiff_t temperature_stride;
  tm_real *source; /* power into the particle, added to */

  /* of the layer between centers and surface (tm_contact_layer.h): rows of TM_F_LAYER, or NULL; velocity gradients, in rows of
     9; from this force point to the next, 0 at set-up, which changes no rows. Needs records */
  tm_real *layer;
  const tm_real *gradient;
  tm_real layer_dt;
  tm_real tool; /* a number of this tool's own, not 0 */

  /* 3 each, what moves a particle apart from its velocity: tm_shift.h and XSPH. Those that the tool touches it leaves where the
     work of the tool is that of their velocity; or NULL */
  tm_real *uneven, *xsph_v;

  const tm_real *pstrain; /* rows of TM_F_PSTRAIN, for the flow stress, or NULL */
  tm_real *tool_heat;     /* power into the tool through each particle, set; or NULL */

  tm_real *
      earlier; /* TM_EARLIER per particle: contacts of tools that acted on it earlier in this step; or NULL. Where there
                       is an energy balance and another tool or a force of another fix comes later */
  int first;   /* this tool is the first of the step */

  tm_contact_found found; /* by tm_contact_look() with these positions and this pose */

  /* with TM_CT_OUTPUT, added to; each may be NULL */
  double *tri_force; /* 3 nt, on the tool, world frame, unit style */
  double *tri_heat;  /* nt, power into the tool */
  int *tri_count;    /* nt */
} tm_contact_args;

/* Columns of what earlier tools did to a particle: force, friction alone, force of the springs alone; all forces on the
   particle behind the last of these tools. */
enum { TM_EARLIER_FORCE = 0, TM_EARLIER_FRICTION = 3, TM_EARLIER_SPRING = 6, TM_EARLIER_ALL = 9, TM_EARLIER = 12 };

#endif
