/* SPH-TM: heat that a particle exchanges with the outside: flux, source, convection, radiation.

   Flux, convection and radiation act on the free surface the particle carries (tm_surface.h), the
   source on its volume. Temperature and surface are those at the half step, so the exchange is of
   second order in time like all rates. Powers are positive into the particle. */
#ifndef TM_EXCHANGE_H
#define TM_EXCHANGE_H

#include "tm_heat.h"
#include "tm_record.h"
#include "tm_surface.h"

enum tm_exchange_mode {
  TM_EXCHANGE_FLUX = 0,
  TM_EXCHANGE_SOURCE = 1,
  TM_EXCHANGE_CONVECTION = 2,
  TM_EXCHANGE_RADIATION = 3
};

typedef struct {
  int mode;                  /* enum tm_exchange_mode */
  tm_real strength;          /* flux, source, convection coefficient, Stefan-Boltzmann constant */
  tm_real T_inf;             /* temperature of the surroundings */
  tm_real emissivity;        /* negative: the material's */
  tm_surface surface;
  int facing;                /* nonzero: only the area facing d */
  tm_vec3 d;
  tm_real area_factor;       /* on the area found, to reach a known total; 1 otherwise */

  tm_records rec;
  const tm_real *normal;        /* 3 per particle, NULL for a source */
  const int *type, *mask;       /* LAMMPS types and group bits */
  int group;                    /* particles with (mask & group) exchange heat */
  const tm_material *material;  /* indexed by type */
  tm_real *source;              /* power into the particles, added to */
} tm_exchange_args;

typedef struct {
  tm_real power, area;
  tm_real rate;              /* decay rate of the particle's temperature by the exchange */
} tm_exchange_result;

/* Area in use of particle i, without the factor. */
TM_FN tm_real tm_exchange_area(int i, const tm_exchange_args *a)
{
  const tm_real *r = tm_main_record(&a->rec, i), *p = a->normal + 3 * (ptrdiff_t) i;
  const tm_vec3 n = tm_vec(p[0], p[1], p[2]);
  const tm_real volume = r[tm_part(TM_REC_M)] / r[tm_part(TM_REC_RHO)];
  return a->facing ? tm_surface_area_facing(&a->surface, n, volume, a->d)
                   : tm_surface_area(&a->surface, n, volume);
}

TM_FN tm_exchange_result tm_exchange(int i, const tm_exchange_args *a)
{
  const tm_real *r = tm_main_record(&a->rec, i);
  const tm_real T = tm_heat_record(&a->rec, i)[tm_part(TM_REC_T)];
  const tm_material *m = a->material + a->type[i];
  tm_exchange_result out;
  out.rate = 0.0;
  if (a->mode == TM_EXCHANGE_SOURCE) {
    out.area = 0.0;
    out.power = a->strength * r[tm_part(TM_REC_M)] / r[tm_part(TM_REC_RHO)];
    return out;
  }
  out.area = a->area_factor * tm_exchange_area(i, a);
  const tm_real e = a->emissivity < 0.0 ? m->emissivity : a->emissivity;
  tm_real flux = a->strength, slope = 0.0;   /* slope = -d flux/dT */
  if (a->mode == TM_EXCHANGE_CONVECTION) {
    flux = tm_convection(a->strength, T, a->T_inf);
    slope = a->strength;
  } else if (a->mode == TM_EXCHANGE_RADIATION) {
    flux = tm_radiation(a->strength, e, T, a->T_inf);
    slope = 4.0 * a->strength * e * T * T * T;
  }
  out.power = out.area * flux;
  out.rate = out.area * slope / (r[tm_part(TM_REC_M)] * tm_capacity(m, T));
  return out;
}

TM_FN tm_exchange_result tm_exchange_nothing(void)
{
  tm_exchange_result r;
  r.power = r.area = r.rate = 0.0;
  return r;
}

TM_FN void tm_exchange_sum(tm_exchange_result *sum, const tm_exchange_result *r)
{
  sum->power += r->power;
  sum->area += r->area;
  sum->rate = tm_max(sum->rate, r->rate);
}

/* The same for particles of the group, into their source; or only their area without the factor. */
TM_FN tm_exchange_result tm_exchange_of_group(int i, const tm_exchange_args *a, int area_only)
{
  tm_exchange_result r = tm_exchange_nothing();
  if (!(a->mask[i] & a->group)) return r;
  if (area_only) {
    r.area = tm_exchange_area(i, a);
    return r;
  }
  r = tm_exchange(i, a);
  a->source[i] += r.power;
  return r;
}

#endif
