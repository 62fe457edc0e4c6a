/* SPH-TM: heat flux into a particle through its free surface (given, convection, radiation), and volume source.

   Flux, convection and radiation act on the free surface the particle carries (tm_surface.h), the
   source on its volume. Temperature and surface are those at the half step, so it is of
   second order in time like all rates. Powers are positive into the particle.

   A particle has the temperature of its center, half an edge e below the surface: heat for convection and radiation comes
   through k/(e/2) first, so that of a flux q(T) = q0 + q' (T_surface - T) only q0/(1 - q' e/(2k)) goes (for radiation one
   step of Newton's). */
#ifndef TM_SURFACE_FLUX_H
#define TM_SURFACE_FLUX_H

#include "tm_heat.h"
#include "tm_record.h"
#include "tm_surface.h"
#include "tm_time_step.h"

enum tm_flux_mode { TM_FLUX_GIVEN = 0, TM_FLUX_SOURCE = 1, TM_FLUX_CONVECTION = 2, TM_FLUX_RADIATION = 3 };

typedef struct {
  int mode;           /* enum tm_flux_mode */
  tm_real strength;   /* flux, source, convection coefficient, Stefan-Boltzmann constant */
  tm_real T_inf;      /* temperature of the surroundings */
  tm_real emissivity; /* negative: the material's */
  tm_surface surface;
  int dim3;
  int facing; /* nonzero: only the area facing d */
  tm_vec3 d;
  tm_real area_factor; /* on the area found, to reach a known total; 1 otherwise */
  tm_real dt;          /* of the step; 0 at set-up */

  tm_records rec;
  const tm_real *normal;       /* 3 per particle, NULL for a source */
  const int *type, *mask;      /* LAMMPS types and group bits */
  int group;                   /* particles with (mask & group) */
  const tm_material *material; /* indexed by type */
  tm_real *source;             /* power into the particles, added to */
} tm_surface_flux_args;

typedef struct {
  tm_real power, area;
  tm_real rate; /* decay rate of the particle's temperature by the flux */
} tm_surface_flux_result;

/* Area in use of particle i, without the factor. */
TM_FN tm_real tm_surface_flux_area(int i, const tm_surface_flux_args *a)
{
  const tm_real *r = tm_main_record(&a->rec, i), *p = a->normal + 3 * (ptrdiff_t) i;
  const tm_vec3 n = tm_vec(p[0], p[1], p[2]);
  const tm_real volume = r[tm_part(TM_REC_M)] / r[tm_part(TM_REC_RHO)];
  return a->facing ? tm_surface_area_facing(&a->surface, n, volume, a->d) : tm_surface_area(&a->surface, n, volume);
}

TM_FN tm_surface_flux_result tm_surface_flux(int i, const tm_surface_flux_args *a)
{
  const tm_real *r = tm_main_record(&a->rec, i);
  const tm_real T = tm_heat_record(&a->rec, i)[tm_part(TM_REC_T)];
  const tm_material *m = a->material + a->type[i];
  tm_surface_flux_result out;
  out.rate = 0.0;
  if (a->mode == TM_FLUX_SOURCE) {
    out.area = 0.0;
    out.power = a->strength * r[tm_part(TM_REC_M)] / r[tm_part(TM_REC_RHO)];
    return out;
  }
  out.area = a->area_factor * tm_surface_flux_area(i, a);
  const tm_real e = a->emissivity < 0.0 ? m->emissivity : a->emissivity;
  tm_real flux = a->strength, slope = 0.0; /* slope = -d flux/dT */
  if (a->mode == TM_FLUX_CONVECTION) {
    flux = tm_convection(a->strength, T, a->T_inf);
    slope = a->strength;
  } else if (a->mode == TM_FLUX_RADIATION) {
    flux = tm_radiation(a->strength, e, T, a->T_inf);
    slope = 4.0 * a->strength * e * T * T * T;
  }
  const tm_real volume = r[tm_part(TM_REC_M)] / r[tm_part(TM_REC_RHO)], edge = a->dim3 ? cbrt(volume) : sqrt(volume);
  const tm_real k = tm_heat_record(&a->rec, i)[tm_part(TM_REC_K)],
                part = k > 0.0 ? 1.0 / (1.0 + 0.5 * slope * edge / k) : 1.0;
  out.power = out.area * part * flux;
  out.rate = out.area * part * slope / (r[tm_part(TM_REC_M)] * tm_capacity(m, T));
  /* the coefficient has risen within a step that is too long for it: as much as an exponential decay takes, not beyond T_inf */
  const tm_real decay = a->dt * out.rate;
  if (decay > TM_DECAY_STABLE) out.power *= -expm1(-decay) / decay;
  return out;
}

TM_FN tm_surface_flux_result tm_surface_flux_nothing(void)
{
  tm_surface_flux_result r;
  r.power = r.area = r.rate = 0.0;
  return r;
}

TM_FN void tm_surface_flux_sum(tm_surface_flux_result *sum, const tm_surface_flux_result *r)
{
  sum->power += r->power;
  sum->area += r->area;
  sum->rate = tm_max(sum->rate, r->rate);
}

/* The same for particles of the group, into their source; or only their area without the factor. */
TM_FN tm_surface_flux_result tm_surface_flux_of_group(int i, const tm_surface_flux_args *a, int area_only)
{
  tm_surface_flux_result r = tm_surface_flux_nothing();
  if (!(a->mask[i] & a->group)) return r;
  if (area_only) {
    r.area = tm_surface_flux_area(i, a);
    return r;
  }
  r = tm_surface_flux(i, a);
  a->source[i] += r.power;
  return r;
}

#endif
