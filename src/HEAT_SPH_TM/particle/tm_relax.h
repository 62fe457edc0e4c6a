/* SPH-TM: dynamic relaxation: damping -c m v towards equilibrium, and how far from it the particles are.

   The velocity in the force is the mean of the step, v_mean = (v(n) + v(n+1))/2 with
     m (v(n+1) - v(n))/dt = f - c m v_mean,  so  v_mean = (v(n) + dt f/(2 m))/(1 + c dt/2):
   stable for every c, and what it takes out of the motion is c m v_mean^2 dt to round-off.

   c = 2 w damps the mode of frequency w critically (Underwood 1983, dynamic relaxation). The Rayleigh quotient of the
   motion itself is w^2 = v.K v/(v.M v). As df/dt = -K v,
     v.K v = -d/dt (f.v) + f.(f - c m v)/m,
   so that sums over the particles are enough: no stiffness, no force of the last step. High modes are damped first, and
   w falls to that of the slowest one that still moves. */
#ifndef TM_RELAX_H
#define TM_RELAX_H

#include "tm_record.h"
#include "tm_state.h"

typedef struct {
  tm_state state;
  tm_records rec;
  int group;
  int driven[3];   /* groups whose velocity in x, y, z is prescribed: neither damped there nor summed */
  int act;         /* 0: only sum */
  tm_real damping; /* c, 1/time */
  tm_real dt;
  tm_real accel_unit; /* force of the unit style / mass -> acceleration */
} tm_relax_args;

/* Mass, length and time are the units. */
typedef struct {
  tm_real power;      /* sum f.v_mean, f without the damping */
  tm_real force2;     /* sum f.f/m */
  tm_real momentum2;  /* sum m v_mean.v_mean */
  tm_real unbalanced; /* largest |f| */
  tm_real carried;    /* largest |sigma| V^((d-1)/d), what a particle carries */
} tm_relax_result;

TM_FN tm_relax_result tm_relax_nothing(void)
{
  tm_relax_result r;
  r.power = r.force2 = r.momentum2 = r.unbalanced = r.carried = 0.0;
  return r;
}
TM_FN void tm_relax_sum(tm_relax_result *sum, const tm_relax_result *r)
{
  sum->power += r->power;
  sum->force2 += r->force2;
  sum->momentum2 += r->momentum2;
  sum->unbalanced = tm_max(sum->unbalanced, r->unbalanced);
  sum->carried = tm_max(sum->carried, r->carried);
}

/* Adds the damping to the force on particle i. */
TM_FN tm_relax_result tm_relax(int i, const tm_relax_args *a, unsigned effects)
{
  const tm_state *s = &a->state;
  tm_relax_result out = tm_relax_nothing();
  if (!(s->mask[i] & a->group) || s->material[s->type[i]].body != TM_BODY_SOLID) return out;
  const int dim3 = (effects & TM_FX_3D) != 0;
  double *f = s->force + 3 * (ptrdiff_t) i;
  const double *v = s->v + 3 * (ptrdiff_t) i;
  const tm_real mass = tm_particle_mass(s, i), per_mass = a->accel_unit / mass, half = 0.5 * a->dt;
  const int mask = s->mask[i];
  const tm_real x = mask & a->driven[0] ? 0.0 : 1.0, y = mask & a->driven[1] ? 0.0 : 1.0;
  const tm_real z = !dim3 || mask & a->driven[2] ? 0.0 : 1.0;
  const tm_vec3 acc = tm_vec(x * per_mass * f[0], y * per_mass * f[1], z * per_mass * f[2]);
  const tm_vec3 free = tm_vec(x * v[0], y * v[1], dim3 ? z * v[2] : v[2]);
  const tm_vec3 mean = tm_vec_scale(1.0 / (1.0 + half * a->damping), tm_vec_axpy(free, half, acc));
  out.power = mass * tm_vec_dot(acc, mean);
  out.force2 = mass * tm_vec_dot(acc, acc);
  out.momentum2 = mass * tm_vec_dot(mean, mean);
  out.unbalanced = mass * tm_vec_norm(acc);
  const tm_real *r = tm_main_record(&a->rec, i), rho = r[tm_part(TM_REC_RHO)];
  const tm_sym3 P = tm_sym_from_record(r, TM_REC_P);
  const tm_real volume = r[tm_part(TM_REC_M)] / rho;
  out.carried = sqrt(tm_sym_ddot(P, P)) * ((effects & TM_FX_FORM_F14) ? 1.0 : rho * rho) *
                (dim3 ? cbrt(volume * volume) : sqrt(volume));
  if (a->act) {
    const tm_real back = a->damping / per_mass;
    f[0] -= back * mean.x;
    f[1] -= back * mean.y;
    if (dim3) f[2] -= back * mean.z;
  }
  return out;
}

/* The estimate of w: sums that forget, with the terms of one step before. */
enum { TM_RELAX_MEMORY = 100 }; /* steps */
typedef struct {
  tm_real stiffness, mass; /* v.K v and v.M v */
  tm_real power, rest;     /* of the last step: f.v, f.(f - c m v)/m */
  tm_real dt;              /* of the last step; 0: there is none */
} tm_relax_mode;

/* Takes the sums of a step; returns the damping of the next one, 2 w. */
TM_FN tm_real tm_relax_damping(tm_relax_mode *q, const tm_relax_result *r, tm_real damping, tm_real dt)
{
  const tm_real rest = r->force2 - damping * r->power, keep = 1.0 - 1.0 / (tm_real) TM_RELAX_MEMORY;
  if (q->dt > 0.0) {
    const tm_real rate = (r->power - q->power) / (0.5 * (dt + q->dt));
    q->stiffness = keep * q->stiffness + 0.5 * (rest + q->rest) - rate;
    q->mass = keep * q->mass + r->momentum2;
  }
  q->power = r->power;
  q->rest = rest;
  q->dt = dt;
  if (!(q->stiffness > 0.0) || !(q->mass > 0.0)) return 0.0;
  return tm_min(2.0 * sqrt(q->stiffness / q->mass), 1.0 / dt);
}

#endif
