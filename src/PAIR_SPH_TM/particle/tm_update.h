/* SPH-TM: one particle from step n to n+1, from its rates at the half step.

     v(n+1)   = v(n) + dt a(n+1/2)
     x(n+1)   = x(n+1/2) + dt/2 v(n+1),  x(n+1/2) = x(n) + dt/2 v(n)
     rho(n+1) = rho(n) - dt rho(n+1/2) tr L                                   F15 (2)
     s        : Jaumann rate (F14 (9)) to the trial stress, radial return (F14 (11)-(14))
     T        : rho c dT/dt = conduction + chi Y deps_p/dt + sources           F15 (5)
                              + artificial heating - Gamma rho c T tr L        tm_thermoelastic.h
     e        : rho de/dt = sigma : L + artificial heating + conduction + sources (shock equation of state only)

   The rates of this step and the last are kept for the prediction of the next half step. */
#ifndef TM_UPDATE_H
#define TM_UPDATE_H

#include "tm_balance.h"
#include "tm_contact_layer.h"
#include "tm_damage.h"
#include "tm_eigen.h"
#include "tm_eos.h"
#include "tm_heat.h"
#include "tm_residual.h"
#include "tm_shift.h"
#include "tm_shocked.h"
#include "tm_stored_energy.h"
#include "tm_strength.h"
#include "tm_update_args.h"

typedef struct {
  tm_sym3 s;
  tm_real p, rho, d_eps, yield;
} tm_point;

/* Density, pressure and deviator at the end of a step with velocity gradient L; growth: see tm_particle_growth. */
TM_FN tm_point tm_constitutive(const tm_material *m, tm_real rho, tm_real rho_half, tm_sym3 s, tm_sym3 s_half,
                               tm_mat3 L, tm_real e, tm_real growth, tm_real eps_p, tm_real T, tm_real dt, int plastic)
{
  tm_point out;
  out.rho = rho - dt * rho_half * tm_mat_trace(L);
  out.p = tm_eos_pressure(m, growth * out.rho, e);
  out.d_eps = 0.0;
  out.yield = 0.0;
  if (m->strength == TM_STRENGTH_NONE) {
    out.s = tm_sym(0, 0, 0, 0, 0, 0);
    return out;
  }
  out.s = tm_sym_axpy(s, dt, tm_deviator_rate(s_half, L, m->shear));
  if (plastic) {
    const tm_return_result r = tm_radial_return(m, out.s, eps_p, T, dt);
    out.s = r.s;
    out.d_eps = r.d_eps;
    out.yield = r.yield;
  }
  return out;
}

/* Plane stress: the thickness rate L.zz for which sigma_zz vanishes at the end of the step. */
TM_FN tm_real tm_plane_stress_rate(const tm_material *m, tm_real rho, tm_real rho_half, tm_sym3 s, tm_sym3 s_half,
                                   tm_mat3 L, tm_real e, tm_real growth, tm_real eps_p, tm_real T, tm_real dt,
                                   int plastic)
{
  const tm_real stiff = dt * (m->bulk + 4.0 / 3.0 * m->shear);
  const tm_real tol =
      1e-15 * m->young; /* of strain: rates of small strains want it, and another turn squares the error */
  tm_real l0 = -(L.xx + L.yy) * m->poisson / (1.0 - m->poisson), f0, l1, f1;
  L.zz = l0;
  tm_point q = tm_constitutive(m, rho, rho_half, s, s_half, L, e, growth, eps_p, T, dt, plastic);
  f0 = q.s.zz - q.p;
  l1 = l0 - f0 / stiff;
  for (int it = 0; it < 25; it++) {
    L.zz = l1;
    q = tm_constitutive(m, rho, rho_half, s, s_half, L, e, growth, eps_p, T, dt, plastic);
    f1 = q.s.zz - q.p;
    if (fabs(f1) < tol || f1 == f0) break;
    const tm_real next = l1 - f1 * (l1 - l0) / (f1 - f0);
    l0 = l1;
    f0 = f1;
    l1 = next;
  }
  return l1;
}

/* x and v, also of what was read; returns the acceleration. */
TM_FN tm_vec3 tm_update_motion(int i, const tm_update_args *a, tm_update_read *in, unsigned effects,
                               tm_update_result *out)
{
  const tm_state *s = &a->state;
  double *x = s->x + 3 * (ptrdiff_t) i, *v = s->v + 3 * (ptrdiff_t) i;
  const tm_real mass = in->mass, c = a->accel_unit / mass, half = 0.5 * a->dt;
  const tm_vec3 acc = tm_vec_scale(c, in->force), v0 = in->v;
  in->v.x += a->dt * acc.x;
  in->v.y += a->dt * acc.y;
  in->x.x += half * in->v.x;
  in->x.y += half * in->v.y;
  if (effects & TM_FX_3D) {
    in->v.z += a->dt * acc.z;
    in->x.z += half * in->v.z;
    v[2] = in->v.z;
    x[2] = in->x.z;
  }
  v[0] = in->v.x;
  v[1] = in->v.y;
  x[0] = in->x.x;
  x[1] = in->x.y;
  if (effects & TM_FX_XSPH) {
    tm_real *u = tm_field_row(s, TM_F_XSPH, i);
    const tm_real *n = a->xsph_v + 3 * (ptrdiff_t) i;
    for (int d = 0; d < 3; d++) {
      x[d] += half * n[d];
      u[tm_column(d)] = n[d];
    }
  }
  if (effects & TM_FX_LEDGER) {
    const tm_vec3 mean = tm_vec(0.5 * (v0.x + in->v.x), 0.5 * (v0.y + in->v.y), 0.5 * (v0.z + in->v.z));
    const double *fi = a->force_internal + 3 * (ptrdiff_t) i;
    out->kinetic_work = mass * a->dt * tm_vec_dot(acc, mean);
    out->internal_work = a->dt * a->accel_unit * (fi[0] * mean.x + fi[1] * mean.y + fi[2] * mean.z);
  }
  return acc;
}

/* The part of the energy that artificial terms give to a particle which heats it. Artificial stress is no dissipation: it
   gives as well as it takes, in tension. With it only what is taken under pressure counts. */
TM_FN tm_real tm_artificial_heat(tm_real energy, tm_real p, unsigned effects)
{
  if (!(effects & TM_FX_ARTIFICIAL_HEAT)) return 0.0;
  if (!(effects & TM_FX_ARTSTRESS)) return energy;
  return p > 0.0 ? tm_max(energy, 0.0) : 0.0;
}

/* Energies that a particle takes up as heat in a step. */
typedef struct {
  tm_real heat;        /* all but that of the artificial terms */
  tm_real compression; /* of this, by compression */
  tm_real given;       /* of this, by conduction and sources */
} tm_heat_taken;

/* Temperature at the end of the step, also of what was read. compression: ratio of temperatures by compression; artificial: energy given by the
   artificial terms. */
TM_FN tm_heat_taken tm_update_temperature(int i, const tm_update_args *a, tm_update_read *in, const tm_material *m,
                                          tm_real rho, tm_real plastic_power, tm_real compression, tm_real artificial,
                                          unsigned effects)
{
  tm_heat_taken out;
  tm_real *t = tm_field_row(&a->state, TM_F_TEMP, i);
  const tm_real mass = in->mass;
  const tm_real plastic = plastic_power * m->taylor_quinney * mass / rho;
  tm_real power = 0.0;
  if (effects & TM_FX_CONDUCTION) power += in->heat * mass / in->rec_rho;
  if (a->source) {
    power += in->source;
    a->source[i] = 0.0;
  }
  out.given = a->dt * power;
  out.compression = 0.0;
  tm_real rise = 0.0;
  if (effects & TM_FX_COMPRESSION_HEAT) {
    rise = (compression - 1.0) * in->T;
    out.compression = mass * tm_capacity(m, in->T + 0.5 * rise) * rise;
  }
  rise += tm_heat_rise(m, in->T + rise, (a->dt * (plastic + power) + artificial) / mass);
  in->T += rise;
  t[0] = in->T;
  t[tm_column(2)] = in->T_rate;
  t[tm_column(1)] = rise / a->dt;
  out.heat = a->dt * (plastic + power) + out.compression;
  return out;
}

/* The internal energy e takes up a gain per mass; its rates of the last two steps follow. */
TM_FN void tm_update_energy(tm_real *e, tm_real gain, tm_real dt)
{
  e[0] += gain;
  e[tm_column(2)] = e[tm_column(1)];
  e[tm_column(1)] = gain / dt;
}

/* Energy that artificial terms give to the particle in the step: those of the pairs, what the balance of the artificial stress takes
   out of the motion, -m rho share R : L, and the pressure q of shocks, -m/rho q tr L, also in *shock. rho: of the force point; before
   the flow stress is written. */
TM_FN tm_real tm_update_artificial(int i, const tm_update_args *a, const tm_update_read *in, tm_real rho, tm_real h,
                                   tm_mat3 L, unsigned effects, tm_real *shock)
{
  if (!a->artificial) return 0.0;
  tm_real power = in->artificial;
  if (tm_shock_reaches(i, &a->state, a->shock, in->rate[TM_H_RHO], rho, in->sound, h, effects)) {
    const tm_real q =
        tm_shocked(i, &a->state, a->shock, in->rate[TM_H_RHO], rho, in->sound, h, a->dt, in->predicted, effects);
    const tm_real taken = in->rec_mass / rho * tm_mat_trace(L) * q;
    power -= taken;
    *shock = -a->dt * taken;
  }
  if ((effects & TM_FX_ARTSTRESS) && a->share) {
    const tm_real *r = tm_main_record(&a->rec, i), *R = tm_stress_record(&a->rec, i);
    const tm_real *size = (effects & TM_FX_SMOOTHING) ? tm_field_row(&a->state, TM_F_SIZE, i) : NULL;
    power -= r[tm_part(TM_REC_M)] * r[tm_part(TM_REC_RHO)] * tm_share_of(a->share, size, a->ratio) *
             tm_sym_ddot(tm_sym_from_record(R, 0), tm_mat_symmetric(L));
  }
  return a->dt * power;
}

/* The rates of the last step become the older history and those of this step the newer: first what is known before the
   material, then its own. */
TM_FN void tm_update_history(tm_real *h1, const tm_real *last, tm_vec3 acc, int dim3)
{
  tm_real *h2 = h1 + tm_column(TM_H_STEP);
  for (int k = 0; k < TM_H_STEP; k++)
    if (dim3 || !tm_history_across(k)) h2[tm_column(k)] = last[k];
  tm_vec_to_row_in(h1 + tm_column(TM_H_V), acc, dim3);
}
TM_FN void tm_update_material_history(tm_real *h1, tm_real rho_rate, tm_sym3 stress_rate, int dim3)
{
  h1[tm_column(TM_H_RHO)] = rho_rate;
  tm_sym_to_row_in(h1 + tm_column(TM_H_S), stress_rate, dim3);
}

/* The shear switch of the viscosity, Balsara 1995, for the next step. */
TM_FN void tm_update_balsara(int i, const tm_state *s, tm_mat3 L, tm_real sound, tm_real h)
{
  const tm_vec3 curl = tm_vec(L.zy - L.yz, L.xz - L.zx, L.yx - L.xy);
  *tm_field_row(s, TM_F_BALSARA, i) = tm_balsara(tm_mat_trace(L), tm_vec_norm(curl), sound, h);
}

/* Position of a particle that has flowed in this step; returns the square of the speed with which it has come there in the
   second half of the step, v2 without. */
TM_FN tm_real tm_update_shift(int i, const tm_update_args *a, const tm_point *q, tm_mat3 L, tm_real v2, tm_real h,
                              tm_real eps_p, tm_real sound, int dim3)
{
  const tm_state *s = &a->state;
  if (!(q->d_eps > 0.0 && eps_p > TM_SHIFT_DRAWN_BEGINS)) return v2;
  if (!(s->mask[i] & a->group) || s->mask[i] & a->held) return v2;
  const tm_vec3 g = tm_vec_from_row_in(a->uneven + tm_row(i, 3), dim3);
  const tm_vec3 dx =
      tm_shift(g, tm_shift_along(L, g, dim3), h, eps_p, q->d_eps, tm_tension_share(q->yield, q->p), sound * a->dt);
  double *x = s->x + 3 * (ptrdiff_t) i;
  x[0] += dx.x;
  x[1] += dx.y;
  if (dim3) x[2] += dx.z;
  const tm_real speed = sqrt(v2) + 2.0 / a->dt * tm_vec_norm(dx);
  return speed * speed;
}

/* How uneven the neighbors of a particle that flows are along a stretch, for tm_hourglass_memory(); tension: share of it, 0 where
   that does not matter. */
TM_FN tm_real tm_update_uneven(int i, const tm_update_args *a, const tm_point *q, tm_real tension, tm_mat3 L, tm_real h,
                               int dim3)
{
  if (!(a->uneven && tension > 0.0 && q->d_eps > 0.0)) return 0.0;
  const tm_vec3 g = tm_vec_from_row_in(a->uneven + tm_row(i, 3), dim3);
  return tm_hourglass_uneven(tm_shift_along(L, g, dim3).axis, h, tension);
}

/* Displacement of hourglass control for the next force point; xi: its stiffness, q: at the end of the step, rho_c2: at the
   force point. */
TM_FN void tm_update_hourglass(int i, const tm_update_args *a, const tm_update_read *in, tm_real xi, const tm_point *q,
                               tm_real rho_c2, tm_real eps_p, tm_mat3 L, tm_real h, int forget, int dim3)
{
  const tm_real tension = tm_tension_share(q->yield, q->p);
  const tm_real early = tm_hourglass_early(eps_p);
  const tm_real memory = tm_hourglass_memory(q->yield, q->p, tm_update_uneven(i, a, q, early * tension, L, h, dim3));
  const tm_vec3 u = tm_hourglass_step(in->u, in->u_rate, xi, L, a->dt, q->d_eps / memory, forget);
  tm_hourglass_store(tm_field_row(&a->state, TM_F_HOURGLASS, i),
                     tm_hourglass_limit(u, sqrt(xi) * rho_c2, q->yield, tension, early, h),
                     forget ? tm_vec(0, 0, 0) : in->u_rate, dim3);
}

/* What of a solid particle cannot go on, enum tm_status; v2: its speed squared, others: a sum of its other fields. */
TM_FN int tm_update_status(const tm_update_args *a, const tm_material *m, const tm_point *q, tm_real v2, tm_real sound,
                           tm_real others, int failed)
{
  const tm_real check = q->rho + q->s.xx + q->s.yy + q->s.xy + q->s.xz + q->s.yz + v2 + others;
  if (!(check - check == 0.0)) return TM_BAD_NAN;
  if (!(q->rho > 0.0)) return TM_BAD_DENSITY;
  if (q->d_eps > TM_STRAIN_STEP) return TM_BAD_STRAIN;
  if (q->rho > a->densest * m->rho0 || (!failed && q->rho * a->densest < m->rho0)) return TM_BAD_VOLUME;
  return v2 > 100.0 * sound * sound ? TM_BAD_VELOCITY : TM_OK;
}
TM_FN int tm_update_heat_status(const tm_update_args *a, tm_real T)
{
  if (!(T - T == 0.0)) return TM_BAD_NAN;
  if (!(T > 0.0)) return TM_BAD_TEMPERATURE;
  return T > a->hottest ? TM_BAD_HEAT : TM_OK;
}

/* Gradients of the next step: their correction, and free faces. */
TM_FN void tm_update_gradients(int i, const tm_update_args *a, const tm_update_read *in, const tm_material *m,
                               unsigned effects)
{
  const tm_state *s = &a->state;
  if (effects & TM_FX_ONE_PASS)
    tm_correction_step(tm_field_row(s, TM_F_CORRECTION, i), &in->last, in->K, &in->predicted, in->L,
                       0.5 * a->dt + in->last.since, 0.5 * a->dt, (effects & TM_FX_3D) != 0);
  if (effects & TM_FX_FACES)
    tm_face_step(tm_field_row(s, TM_F_FACE, i), a->face_next + tm_row(i, TM_FACE_COLUMNS),
                 tm_face_kept(in->eps_p + (m->shear > 0.0 ? tm_sym_mises(in->s) / (3.0 * m->shear) : 0.0)));
}

TM_FN tm_update_result tm_update(int i, const tm_update_args *a, unsigned effects)
{
  effects &= TM_FX_PRESENT;
  const tm_state *s = &a->state;
  const tm_material *m = s->material + s->type[i];
  const int dim3 = (effects & TM_FX_3D) != 0, solid = m->body == TM_BODY_SOLID;
  const tm_real h = tm_particle_h(s, i, a->h, effects);
  tm_update_result out = tm_update_nothing();
  out.particle = i;
  tm_update_read in = tm_update_read_of(i, a, solid, effects);

  const tm_vec3 acc = s->mask[i] & a->group ? tm_update_motion(i, a, &in, effects, &out) : tm_vec(0, 0, 0);
  const tm_real v2 = tm_vec_dot(in.v, in.v);
  out.speed2 = v2;

  if (solid) {
    tm_real *lz = (effects & TM_FX_PLANE_STRESS) ? tm_field_row(s, TM_F_THICKNESS, i) : NULL;
    tm_real *pl = (effects & TM_FX_PLASTICITY) ? tm_field_row(s, TM_F_PSTRAIN, i) : NULL;
    tm_real *dmg = (effects & TM_FX_DAMAGE) ? tm_field_row(s, TM_F_DAMAGE, i) : NULL;
    tm_real *e = (effects & TM_FX_ENERGY) ? tm_field_row(s, TM_F_ENERGY, i) : NULL;
    const tm_real T = in.T, mass = in.rec_mass, sound = in.sound;
    const tm_sym3 s0 = in.s;
    tm_mat3 L = in.L;
    const tm_predict_weights w = tm_predict_weights_at(0.5 * a->dt);
    const tm_real rho_half = lz ? in.rec_rho / *lz : in.rec_rho;
    const tm_sym3 s_half = tm_sym_axpy(tm_sym_axpy(s0, w.last, tm_sym_load(in.rate + TM_H_S)), w.older, in.older);
    /* what is done with is written: the fewer values are waiting, the more particles a GPU has at once */
    tm_real *history = tm_field_row(s, TM_F_HISTORY, i);
    tm_update_history(history, in.rate, acc, dim3);
    out.dt[TM_DT_FORCE] = tm_force_time_step(h, sqrt(tm_vec_dot(acc, acc)));
    tm_update_gradients(i, a, &in, m, effects);
    const tm_real eps_p = in.eps_p, energy = e ? tm_predict_value(e, w) : 0.0;
    const int failed = dmg && dmg[tm_column(1)] > 0.5;
    const tm_real T_half = (effects & TM_FX_EXPANSION) ? tm_predict_value(tm_field_row(s, TM_F_TEMP, i), w) : T;
    const tm_real growth = tm_particle_growth(s, i, m, T_half, effects);
    const tm_real growth_end = tm_particle_growth(s, i, m, T + 2.0 * (T_half - T), effects);

    /* in plane stress what has failed keeps its thickness: with no deviator a free one would leave no pressure */
    if (lz)
      L.zz = failed ? 0.0
                    : tm_plane_stress_rate(m, in.rho, rho_half, s0, s_half, L, energy, growth_end, eps_p, T, a->dt,
                                           pl != NULL);
    /* of the force point: work of the stress that acted, per mass, sigma(n+1/2) : L; stiffness of hourglass control */
    const tm_real p_half = tm_eos_pressure(m, growth * rho_half, energy);
    const tm_sym3 s_acting = failed ? tm_sym(0, 0, 0, 0, 0, 0) : s_half;
    const tm_real work =
        a->dt / rho_half *
        tm_sym_ddot(tm_sym_add_iso(s_acting, -tm_damage_pressure(p_half, failed)), tm_mat_symmetric(L));
    const int forget = failed || m->strength == TM_STRENGTH_NONE, controls = (effects & TM_FX_HOURGLASS) != 0;
    const tm_real rho_c2 = rho_half * sound * sound; /* as in tm_predict_hourglass(), as is this: */
    const tm_real drawn = (effects & TM_FX_ONE_PASS) ? eps_p : 0.0;
    const tm_real xi = controls && !forget
                           ? tm_hourglass_stiffness(a->hourglass, s_half, lz ? s_half.zz : p_half, rho_c2, drawn)
                           : 0.0;

    tm_point q =
        tm_constitutive(m, in.rho, rho_half, s0, s_half, L, energy, growth, eps_p, T, a->dt, pl != NULL && !failed);
    if (failed) q.s = s_acting;
    const tm_real artificial = tm_update_artificial(i, a, &in, rho_half, h, L, effects, &out.shock);
    const tm_real plastic = q.yield * q.d_eps / q.rho;

    const tm_real inv_dt = 1.0 / a->dt;
    tm_update_material_history(history, (q.rho - in.rho) * inv_dt, tm_sym_scale(inv_dt, tm_sym_axpy(q.s, -1.0, s0)),
                               dim3);
    /* failed material that carries nothing opens and closes without heat */
    const int heats = (effects & TM_FX_COMPRESSION_HEAT) && !(failed && q.p <= 0.0);
    const tm_real compression = heats ? tm_compression_heat(tm_gruneisen_density(m, T), in.rho, q.rho) : 1.0;
    *tm_field_row(s, TM_F_RHO, i) = q.rho;
    tm_sym_to_row_in(tm_field_row(s, TM_F_STRESS, i), q.s, dim3);
    if (lz) *lz += a->dt * *lz * L.zz;
    if (pl) {
      pl[0] = eps_p + q.d_eps;
      pl[tm_column(1)] = q.d_eps * inv_dt;
      pl[tm_column(2)] = q.yield;
    }
    if (a->uneven && !failed) out.speed2 = tm_update_shift(i, a, &q, L, v2, h, eps_p, sound, dim3);
    if (s->field[TM_F_LAYER]) tm_layer_end_of_step(tm_field_row(s, TM_F_LAYER, i));
    if (dmg && !failed) {
      const tm_real p = tm_eos_pressure(m, growth * q.rho, energy);
      dmg[0] += tm_damage_increment(m, -p, tm_sym_mises(q.s), q.d_eps, q.d_eps * inv_dt, T);
      dmg[tm_column(1)] = tm_damage_failed(m, dmg[0], pl ? pl[0] : 0.0) ? 1.0 : 0.0;
    }
    if (effects & TM_FX_BALSARA) tm_update_balsara(i, s, L, sound, h);
    if (controls) tm_update_hourglass(i, a, &in, xi, &q, rho_c2, eps_p, L, h, forget, dim3);
    tm_heat_taken taken = {0.0, 0.0, 0.0};
    if (effects & TM_FX_HEAT)
      taken = tm_update_temperature(i, a, &in, m, q.rho, q.yield * q.d_eps * inv_dt, compression,
                                    tm_artificial_heat(artificial, p_half, effects), effects);
    if (e) tm_update_energy(e, work + (artificial + taken.given) / mass, a->dt);
    out.heat = taken.heat;
    if (effects & TM_FX_LEDGER) {
      out.plastic = mass * plastic;
      out.plastic_heat = (effects & TM_FX_HEAT) ? m->taylor_quinney * mass * plastic : 0.0;
      out.stress_work = mass * work;
      if (dmg && !failed && dmg[tm_column(1)] > 0.5)
        out.failure = mass * (tm_stored_energy(m, q.rho, 1.0, q.s, 0) - tm_stored_energy(m, q.rho, 1.0, q.s, 1));
      if (effects & (TM_FX_ENERGY | TM_FX_EXPANSION))
        out.thermal_pressure =
            -mass * a->dt / rho_half * tm_mat_trace(L) *
            (tm_damage_pressure(p_half, failed) - tm_damage_pressure(tm_eos_pressure(m, rho_half, 0.0), failed));
      out.compression = taken.compression;
      out.artificial = artificial;
    }

    out.dt[TM_DT_SOUND] = tm_sound_time_step(tm_step_length(h, a->ratio), sound, a->visc_alpha, xi, effects);
    const tm_real others = eps_p + q.d_eps + (e ? *e : 0.0) + (dmg ? dmg[0] + dmg[tm_column(1)] : 0.0);
    out.status = tm_update_status(a, m, &q, v2, sound, others, failed);
    in.rho = q.rho;
  } else if (effects & TM_FX_HEAT) {
    out.heat = tm_update_temperature(i, a, &in, m, m->rho0, 0.0, 1.0, 0.0, effects).heat;
  }
  if (effects & TM_FX_HEAT) {
    if (effects & TM_FX_CONDUCTION)
      out.dt[TM_DT_CONDUCTION] = tm_conduction_time_step(m, in.rho, in.T, h, a->k_max, a->heat_rate);
    if (out.status == TM_OK) out.status = tm_update_heat_status(a, in.T);
    if (a->watch_melt && tm_strength_flow(m->strength) == TM_FLOW_THERMAL && in.T > m->t_melt) out.melted = i;
  }
  return out;
}

#endif
