/* SPH-TM: point functions of the physics headers with a sweep of inputs each, for the test that compares a GPU with the
   host. Compiled as C for the host and as CUDA for the device.

   A case is a function from random inputs, uniform in its ranges, to outputs. Two values count as equal when they differ
   by the tolerance times the larger of the value and the case's scale: where terms of opposite sign cancel, the scale is
   their size, not that of what is left; a case without scale of its own has 0. */
#ifndef POINTS_H
#define POINTS_H

#include "tm_contact_tri.h"
#include "tm_damage.h"
#include "tm_eos.h"
#include "tm_surface.h"
#include "tm_update.h"

#include <string.h>

#define POINTS_MOST 24                        /* inputs or outputs of a case */
#define POINTS_LAST_BITS 4.5e-16              /* two of them */
#define POINTS_ARITHMETIC 1e-12
#define POINTS_TRANSCENDENTAL 1e-10           /* exp, log, pow, sin, ... or an iteration that ends at a tolerance */

/* --- materials: elastic-plastic with a tabled conductivity, Johnson-Cook with damage and shock, tait */

enum { POINTS_PLASTIC, POINTS_JOHNSON_COOK, POINTS_TAIT, POINTS_MATERIALS };

static inline void points_material(int kind, tm_material *m)
{
  memset(m, 0, sizeof *m);
  m->rho0 = 7800; m->young = 200e9; m->poisson = 0.3;
  m->shear = m->young / 2.6; m->bulk = m->young / 1.2;
  m->strength = kind == POINTS_JOHNSON_COOK ? TM_STRENGTH_JOHNSON_COOK : TM_STRENGTH_PLASTIC;
  m->eos = kind == POINTS_JOHNSON_COOK ? TM_EOS_SHOCK : kind == POINTS_TAIT ? TM_EOS_TAIT : TM_EOS_LINEAR;
  m->eos_c0 = 4600; m->eos_s = 1.5; m->eos_gamma = 1.9; m->eos_n = 7;
  m->yield = 300e6; m->hardening = 1e9;
  m->jc_a = 553e6; m->jc_b = 601e6; m->jc_n = 0.234; m->jc_c = 0.0134; m->jc_m = 1.1; m->jc_rate0 = 1;
  m->t_ref = 300; m->t_melt = 1733;
  m->damage = kind == POINTS_JOHNSON_COOK ? TM_DAMAGE_JOHNSON_COOK : TM_DAMAGE_NONE;
  m->d1 = 0.06; m->d2 = 3.31; m->d3 = -1.96; m->d4 = 0.0018; m->d5 = 0.58;
  m->heat = 1;
  m->conductivity.value = 50; m->capacity.value = 480;
  if (kind == POINTS_PLASTIC)
    for (int k = 0; k < 5; k++) {
      m->conductivity.n = m->capacity.n = k + 1;
      m->conductivity.t[k] = m->capacity.t[k] = 300 + 300 * k;
      m->conductivity.y[k] = 55 - 6 * k;
      m->capacity.y[k] = 450 + 40 * k * k;
    }
  m->taylor_quinney = 0.9; m->emissivity = 0.3;
}

/* --- cases */

#define POINT(name) TM_FN double point_##name(const double *in, const tm_material *m, double *out)
#define SYM(k) tm_sym_load(in + (k))
#define VEC(k) tm_load3(in + (k))

TM_FN void point_put(double *out, tm_vec3 v) { out[0] = v.x; out[1] = v.y; out[2] = v.z; }

POINT(products)
{
  const tm_mat3 a = tm_sym_mul(SYM(0), SYM(6)), b = tm_mat_mul(a, tm_mat_load(in + 9));
  (void) m;
  tm_mat_store(out, a);
  tm_mat_store(out + 9, b);
  point_put(out + 18, tm_vec_cross(VEC(0), VEC(3)));
  out[21] = tm_sym_ddot(SYM(0), SYM(6));
  out[22] = tm_sym_mises(tm_sym_deviator(SYM(0)));
  return 1.0;
}
POINT(pair_numbers)    /* without a compiler's division and root: of all sizes */
{
  (void) m;
  for (int k = 0; k < 4; k++) {
    const double x = ldexp(in[k], (int) in[4 + k]);
    out[2 * k] = tm_pair_inverse(x);
    out[2 * k + 1] = tm_pair_root(x);
  }
  return 0.0;
}
POINT(kernels)
{
  (void) m;
  for (int k = 0; k < TM_KERNEL_COUNT; k++) {
    out[2 * k] = tm_kernel_norm(k, 3, 1.0) * tm_kernel_shape(k, in[0]);
    out[2 * k + 1] = tm_kernel_norm(k, 2, 1.0) * tm_kernel_slope(k, in[0]);
  }
  return 1.0;
}
/* the tensor put together again: eigenvectors of near eigenvalues are free to turn */
POINT(eigen)
{
  const tm_eigen e = tm_sym_eigen(SYM(0));
  tm_sym3 again = tm_sym(0, 0, 0, 0, 0, 0);
  (void) m;
  for (int k = 0; k < 3; k++) again = tm_sym_add_dyad(again, e.value[k], e.vector[k]);
  tm_sym_store(out, again);
  out[6] = tm_min(e.value[0], tm_min(e.value[1], e.value[2]));
  out[7] = tm_max(e.value[0], tm_max(e.value[1], e.value[2]));
  return sqrt(tm_sym_ddot(SYM(0), SYM(0)));
}
POINT(positive_part)
{
  (void) m;
  tm_sym_store(out, tm_sym_positive_part(SYM(0)));
  tm_sym_store(out + 6, tm_sym_positive_part_2d(SYM(0)));
  return sqrt(tm_sym_ddot(SYM(0), SYM(0)));
}
POINT(inverse)
{
  const tm_mat3 s = tm_sym_mul(SYM(0), SYM(0));
  const tm_sym3 a = tm_sym(s.xx + 0.1, s.yy + 0.1, s.zz + 0.1, s.xy, s.xz, s.yz);
  (void) m;
  tm_sym_store(out, tm_sym_inverse_bounded(a, 1, 0.2));
  tm_sym_store(out + 6, tm_sym_inverse_bounded(a, 0, 0.2));
  return 10.0;
}
POINT(jaumann)
{
  tm_sym_store(out, tm_jaumann_rate(SYM(0), tm_mat_load(in + 6), m->shear * 1e-9));
  return m->shear * 1e-9;
}
POINT(flow_stress)
{
  out[0] = tm_flow_stress(m + POINTS_JOHNSON_COOK, in[0], exp(in[1]), in[2]);
  out[1] = tm_flow_stress(m + POINTS_PLASTIC, in[0], exp(in[1]), in[2]);
  out[2] = tm_log_rate(m + POINTS_JOHNSON_COOK, exp(in[1]));
  out[3] = tm_thermal_softening(m + POINTS_JOHNSON_COOK, in[2]);
  return 0.0;
}
/* the return ends when the flow stress is right to 1e-11, and so the strain to that of Y/3G */
POINT(radial_return)
{
  const tm_real dt = exp(in[8]);
  for (int kind = 0; kind < 2; kind++) {
    const tm_material *mat = m + (kind ? POINTS_JOHNSON_COOK : POINTS_PLASTIC);
    const tm_return_result r = tm_radial_return(mat, tm_sym_deviator(SYM(0)), in[6], in[7], dt);
    const tm_real yield = 1.0 / tm_max(r.yield, 1e6);
    double *o = out + 8 * kind;
    tm_sym_store(o, tm_sym_scale(yield, r.s));
    o[6] = r.d_eps * 3.0 * mat->shear * yield;
    o[7] = 1e-9 * r.yield;
  }
  return 1.0;
}
POINT(eos)
{
  for (int k = 0; k < POINTS_MATERIALS; k++) {
    const tm_material *mat = m + k;
    const tm_eos_point q = tm_eos_evaluate(mat, in[0], in[1]);
    out[3 * k] = q.p / mat->bulk;
    out[3 * k + 1] = q.dp_drho * mat->rho0 / mat->bulk;
    out[3 * k + 2] = 1e-4 * tm_eos_sound_speed(mat, in[0], in[1]);
  }
  return 1.0;
}
POINT(conduction)
{
  const tm_material *mat = m + POINTS_PLASTIC;
  const tm_real ki = tm_conductivity(mat, in[0]), kj = tm_conductivity(mat, in[1]);
  out[0] = tm_conduction_pair(ki, kj, in[0], in[1], in[2], in[4], -in[3]);
  out[1] = tm_conduction_pair_interface(ki, kj, in[0], in[1], in[2], -in[3], in[4], in[5]);
  out[2] = tm_heat_rise(mat, in[0], in[6]);
  out[3] = tm_convection(in[5], in[0], in[1]);
  out[4] = tm_radiation(5.67e-8, 0.7, in[0], in[1]);
  out[5] = tm_heat_time_step(7800, tm_capacity(mat, in[0]), 1e-3, ki, 55, 3.0);
  out[6] = 1e-5 * tm_effusivity(ki, 7800, tm_capacity(mat, in[0]));
  return 1500.0;    /* a difference of temperatures */
}
POINT(damage)
{
  const tm_material *mat = m + POINTS_JOHNSON_COOK;
  out[0] = tm_fracture_strain(mat, in[0], in[1], exp(in[2]), in[3]);
  out[1] = tm_damage_increment(mat, in[0], in[1], in[4], exp(in[2]), in[3]);
  return 0.0;
}
POINT(artificial)
{
  (void) m;
  tm_pair inv_r, inv_rho_sum;
  out[0] = tm_viscosity_pair(in[1], 1.2, in[2], in[3], sqrt(in[3]), in[0] * in[4], 2.0 * in[5], &inv_r, &inv_rho_sum);
  out[1] = tm_balsara(in[2], in[4], 40, 1.2);
  out[2] = tm_xsph_pair(in[0], in[5], in[3]);
  out[3] = tm_power_int(in[3], 4) + tm_power_int(in[3], 11);
  tm_sym_store(out + 4, tm_artificial_stress_principal(SYM(6), 0.3, 1.1, 1));
  tm_sym_store(out + 10, tm_artificial_stress_principal(SYM(6), 0.3, 1.1, 0));
  tm_sym_store(out + 16, tm_artificial_stress_component(SYM(6), 0.3, 1.1, 1));
  return 1.0;
}
POINT(contact_laws)
{
  tm_contact_law w;
  tm_surface s;
  memset(&w, 0, sizeof w);
  w.radius = 0.5; w.area = 1.0; w.shear = 1.0; w.share = -1.0;
  w.friction.value = 0.3;
  w.tool_effusivity = 2.0; w.conductance = in[9];
  out[0] = tm_contact_stiffness(0.1 * tm_contact_modulus_of_two(in[0], in[1]), 0.5, 0.5, 1);
  out[1] = tm_contact_damping(0.2, in[0], in[1]);
  out[2] = tm_contact_normal(in[0], in[2], in[1], in[3], 0);
  out[3] = tm_contact_friction_limit(&w, in[0], 300, in[1]);
  point_put(out + 4, tm_contact_friction(VEC(4), in[0], 1.0, in[1], tm_contact_most_braking(VEC(7), VEC(4))));
  out[7] = tm_contact_share(&w, in[0]);
  out[8] = tm_contact_conductance(&w, in[1]);
  out[9] = tm_contact_heat(in[0], in[7], in[8], in[1], 0.5);
  out[10] = tm_contact_time_step(in[0], in[1], 0.3);
  s.least = 0.2; s.scale = 1.3;
  out[11] = tm_surface_area(&s, VEC(4), in[0]);
  (void) m;
  return 1.0;
}
/* a point on the border of two features may fall to either: the place is the same */
POINT(closest)
{
  const tm_vec3 a = VEC(3), b = VEC(6), c = VEC(9);
  const tm_vec3 n = tm_vec_cross(tm_vec_sub(b, a), tm_vec_sub(c, a));
  const tm_real size = tm_vec_norm(n);
  const tm_closest q = tm_closest_on_triangle(VEC(0), a, b, c, tm_vec_scale(1.0 / size, n));
  (void) m;
  point_put(out, q.point);
  out[3] = sqrt(q.dist2);
  return 2.0 / tm_min(size, 1.0);    /* of a needle the normal is as sharp as its area */
}
POINT(motion)
{
  tm_pose base = tm_pose_rest();
  (void) m;
  base.turn = tm_rotation_about(VEC(0), in[3]);
  base.shift = VEC(4);
  for (int kind = 0; kind < 4; kind++) {
    tm_motion move;
    move.kind = TM_MOTION_LINEAR + kind;
    move.v = VEC(4);
    move.point = VEC(7);
    move.axis = VEC(0);
    move.period = 2.0 + in[10];
    move.ramp = 0.7;
    const tm_pose p = tm_motion_pose(&move, &base, 1.0 + in[11]);
    const tm_vec3 world = tm_pose_to_world(&p, VEC(7));
    point_put(out + 6 * kind, tm_vec_sub(world, tm_pose_to_local(&p, VEC(4))));
    point_put(out + 6 * kind + 3, tm_pose_velocity_at(&p, world));
  }
  return 10.0;
}

/* name, inputs, outputs, tolerance; ranges below in the same order */
#define POINT_CASES(CASE)                                 \
  CASE(products, 18, 23, POINTS_ARITHMETIC)               \
  CASE(pair_numbers, 8, 8, POINTS_LAST_BITS)              \
  CASE(kernels, 1, 10, POINTS_ARITHMETIC)                 \
  CASE(eigen, 6, 8, POINTS_ARITHMETIC)                    \
  CASE(positive_part, 6, 12, POINTS_ARITHMETIC)           \
  CASE(inverse, 6, 12, POINTS_ARITHMETIC)                 \
  CASE(jaumann, 15, 6, POINTS_ARITHMETIC)                 \
  CASE(flow_stress, 3, 4, POINTS_TRANSCENDENTAL)          \
  CASE(radial_return, 9, 16, POINTS_TRANSCENDENTAL)       \
  CASE(eos, 2, 9, POINTS_TRANSCENDENTAL)                  \
  CASE(conduction, 7, 7, POINTS_ARITHMETIC)               \
  CASE(damage, 5, 2, POINTS_TRANSCENDENTAL)               \
  CASE(artificial, 12, 22, POINTS_ARITHMETIC)             \
  CASE(contact_laws, 10, 12, POINTS_TRANSCENDENTAL)       \
  CASE(closest, 12, 4, POINTS_ARITHMETIC)                 \
  CASE(motion, 12, 24, POINTS_TRANSCENDENTAL)

#define POINT_ID(name, n_in, n_out, tolerance) POINT_##name,
enum { POINT_CASES(POINT_ID) POINTS_CASES };
#undef POINT_ID

/* One case at one point; returns its scale. */
TM_FN double point_run(int which, const double *in, const tm_material *m, double *out)
{
#define POINT_CALL(name, n_in, n_out, tolerance) \
  case POINT_##name: return point_##name(in, m, out);
  switch (which) {
    POINT_CASES(POINT_CALL)
    default: return 0.0;
  }
#undef POINT_CALL
}

#endif
