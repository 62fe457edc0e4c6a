/* SPH-TM: powers of contacts that were taken before all forces on the particle were known: of several tools, and of fixes
   that act behind them. */
#ifndef TM_CONTACT_LATE_H
#define TM_CONTACT_LATE_H

#include "tm_contact_body.h"
#include "tm_contact_sums.h"

/* Earlier tools of the step have taken powers with a mean velocity that lacks what forces have come to since; with all
   forces of now the mean is higher by dt/(2 m) times the difference. What that changes, into r. */
TM_FN void tm_contact_correct(const tm_contact_args *a, const tm_real *e, tm_vec3 all_forces, tm_real mass,
                              tm_contact_result *r)
{
  const tm_vec3 more = tm_vec_scale(0.5 * a->dt / mass, tm_vec_sub(all_forces, tm_load3(e + TM_EARLIER_ALL)));
  const tm_vec3 force = tm_load3(e + TM_EARLIER_FORCE), friction = tm_load3(e + TM_EARLIER_FRICTION);
  const tm_vec3 spring = tm_load3(e + TM_EARLIER_SPRING);
  r->particle_power += tm_vec_dot(force, more);
  r->late_friction -= tm_vec_dot(friction, more);
  r->damping_power += tm_vec_dot(tm_vec_add(tm_vec_sub(spring, force), friction), more);
  r->spring -= 2.0 * a->after * tm_vec_dot(spring, more);
}

/* Corrects what earlier tools have taken, and adds this one to them. */
TM_FN void tm_contact_settle(int i, const tm_contact_args *a, const tm_contact_body *b, const tm_contact_point *c,
                             int n, tm_contact_result *r)
{
  tm_real *e = a->earlier + (ptrdiff_t) i * TM_EARLIER;
  tm_contact_correct(a, e, b->force, b->mass, r);
  tm_store3(e + TM_EARLIER_ALL, b->force);
  for (int k = 0; k < n; k++) {
    const tm_vec3 F = tm_vec_add(c[k].normal_force, c[k].friction), T = c[k].friction;
    const tm_vec3 S = tm_vec_scale(b->law->stiffness * c[k].delta, c[k].normal);
    const tm_real add[TM_EARLIER_ALL] = {F.x, F.y, F.z, T.x, T.y, T.z, S.x, S.y, S.z};
    for (int d = 0; d < TM_EARLIER_ALL; d++) e[d] += add[d];
  }
}

/* At the end of the step, behind all forces: what fixes behind the tools have changed of the contacts' work. */
TM_FN tm_contact_result tm_contact_late(int i, const tm_contact_args *a, unsigned effects)
{
  tm_contact_result r = tm_contact_nothing();
  const tm_real *e = a->earlier + (ptrdiff_t) i * TM_EARLIER;
  if (e[TM_EARLIER_FORCE] == 0.0 && e[TM_EARLIER_FORCE + 1] == 0.0 && e[TM_EARLIER_FORCE + 2] == 0.0) return r;
  tm_vec3 f = tm_vec_scale(1.0 / a->force_unit, tm_load3(a->f + i * a->f_stride));
  if (!(effects & TM_CT_3D)) f.z = 0.0;
  tm_contact_correct(a, e, f, a->rmass ? a->rmass[i] : a->mass[a->type[i]], &r);
  return r;
}

#endif
