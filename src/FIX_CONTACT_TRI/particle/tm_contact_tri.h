/* SPH-TM: contact of one particle with a rigid triangle mesh, F15 (9)-(17).

   The particle is taken into the mesh's frame (tm_motion.h), its contacts are found there
   (tm_touch.h), and the laws of tm_contact.h act between its velocity and that of the tool's
   material point it touches. Normal forces of all contacts are added first, so that the friction of
   each is computed with all forces that act on the particle in this step.

   Positions and velocities are those at the time of the forces (x, record); `v` is the velocity at the
   start of the step, from which the step ends at v + dt F/m. Powers use the mean of both ends, as
   the integrator's kinetic energy does, and the spring's energy is that of the end of the step, so
   that over a run
     work of the tool = work on the particles + damping + friction + energy of the springs
   with an error of the integrator's order.

   Units are mass, length and time of the style; forces leave through force_unit. */
#ifndef TM_CONTACT_TRI_H
#define TM_CONTACT_TRI_H

#include "tm_contact_body.h"
#include "tm_contact_late.h"
#include "tm_contact_places.h"

/* Normal force of a contact, added to the body's force. */
TM_FN tm_contact_point tm_contact_add_normal(tm_contact_body *b, const tm_touch *t, const tm_pose *pose,
                                             unsigned effects)
{
  const tm_contact_law *w = b->law;
  tm_contact_point c;
  c.point = tm_pose_to_world(pose, t->point);
  c.normal = tm_mat_mul_vec(pose->turn, t->normal);
  if (!(effects & TM_CT_3D)) c.normal.z = 0.0;
  c.tool_v = tm_pose_velocity_at(pose, c.point);
  c.delta = b->thickness - t->distance; /* F15 (9) */
  const tm_real closing = tm_vec_dot(tm_vec_sub(c.tool_v, b->rate_v), c.normal) + b->arm * b->rate;
  c.closing = closing;
  c.fn = tm_contact_normal(w->stiffness, c.delta, tm_contact_damping(w->damping, w->stiffness, b->mass), closing,
                           (effects & TM_CT_APPROACH) != 0);
  c.normal_force = tm_vec_scale(c.fn, c.normal); /* F15 (12) */
  c.friction = tm_vec(0, 0, 0);
  b->force = tm_vec_add(b->force, c.normal_force);
  return c;
}

/* Friction of a contact, added to the body's force: against the sliding that the step would end with. */
TM_FN void tm_contact_add_friction(tm_contact_body *b, tm_contact_point *c)
{
  const tm_vec3 end = tm_vec_sub(tm_vec_axpy(b->v, b->dt / b->mass, b->force), c->tool_v);
  const tm_vec3 slide = tm_contact_tangential(end, c->normal);
  const tm_vec3 start = tm_contact_tangential(tm_vec_sub(b->v, c->tool_v), c->normal);
  const tm_real limit = tm_contact_friction_limit(b->law, c->fn, b->temperature, b->yield);
  c->friction =
      tm_contact_friction(slide, b->mass, b->dt, limit, tm_contact_most_braking(start, slide)); /* F15 (13) (15) */
  b->force = tm_vec_add(b->force, c->friction);
}

/* Heat of one contact: into the particle from friction and, through the contact, from the tool. */
TM_FN void tm_contact_add_heat(int i, const tm_contact_args *a, const tm_contact_body *b, tm_real friction_power,
                               tm_real fn, tm_contact_result *r)
{
  const tm_material *m = a->material + a->type[i];
  const tm_real T = b->temperature, k = tm_conductivity(m, T), cp = tm_capacity(m, T);
  r->friction_heat += friction_power * tm_contact_share(b->law, tm_effusivity(k, m->rho0, cp));
  if (fn > 0.0 && b->law->conductance != 0.0)
    r->conducted +=
        tm_contact_heat(tm_contact_conductance(b->law, k) * b->law->area, a->tool_temperature, T, b->mass * cp, b->dt);
}

/* Powers, torque and energy of a contact once all forces on the particle are known. */
TM_FN void tm_contact_tally(int i, const tm_contact_args *a, const tm_contact_body *b, const tm_contact_point *c,
                            unsigned effects, tm_contact_result *r)
{
  const tm_vec3 mean = tm_vec_axpy(b->v, 0.5 * b->dt / b->mass, b->force);
  const tm_vec3 slip = tm_vec_sub(mean, c->tool_v);
  const tm_vec3 F = tm_vec_add(c->normal_force, c->friction); /* F15 (16) */
  const tm_real friction_power = -tm_vec_dot(c->friction, slip);
  const tm_real spring_force = b->law->stiffness * c->delta;
  r->force = tm_vec_sub(r->force, F);
  r->torque = tm_vec_sub(r->torque, tm_vec_cross(tm_vec_sub(c->point, a->reference), F));
  r->friction_power += friction_power;
  r->damping_power += (spring_force - c->fn) * (tm_vec_dot(c->normal, slip) - b->arm * b->rate);
  r->particle_power += tm_vec_dot(F, mean);
  r->tool_power += tm_vec_dot(F, c->tool_v);
  const tm_vec3 end = tm_vec_sub(tm_vec_axpy(b->v, b->dt / b->mass, b->force), c->tool_v);
  const tm_real left = tm_max(c->delta - a->after * (tm_vec_dot(c->normal, end) - b->arm * b->rate), 0.0);
  r->spring += 0.5 * b->law->stiffness * left * left;
  r->depth = tm_max(r->depth, c->delta);
  r->inner = tm_max(r->inner, c->delta - b->thickness);
  r->within = tm_max(r->within, c->delta - b->thickness + b->law->radius);
  r->contacts += c->fn > 0.0;
  if (effects & TM_CT_HEAT) tm_contact_add_heat(i, a, b, friction_power, c->fn, r);
}

/* Force, heat and count of one contact on its triangle; heat is what this contact added. */
TM_FN void tm_contact_output(const tm_contact_args *a, const tm_contact_point *c, int t, tm_real heat)
{
  const tm_vec3 F = tm_vec_scale(-a->force_unit, tm_vec_add(c->normal_force, c->friction));
  if (a->tri_force) {
    tm_contact_add(a->tri_force + 3 * (ptrdiff_t) t, F.x);
    tm_contact_add(a->tri_force + 3 * (ptrdiff_t) t + 1, F.y);
    tm_contact_add(a->tri_force + 3 * (ptrdiff_t) t + 2, F.z);
  }
  if (a->tri_heat) tm_contact_add(a->tri_heat + t, heat);
  if (a->tri_count && c->fn > 0.0) tm_contact_count(a->tri_count + t);
}

/* Contacts of particle i: adds to its force and to its heat source; what is summed over particles comes back. On a GPU
   several threads may look for the contacts; the first of them gets the sums. */
TM_FN tm_contact_result tm_contact_tri_shared(int i, tm_group group, const tm_contact_args *a, unsigned effects)
{
  tm_contact_result r = tm_contact_nothing();
  if (a->tool_heat && group.lane == 0) a->tool_heat[i] = 0.0;
  if (a->earlier && a->first && group.lane == 0)
    for (int d = 0; d < TM_EARLIER; d++) a->earlier[(ptrdiff_t) i * TM_EARLIER + d] = 0.0;
  tm_touch touch[TM_TOUCH_MAX];
  int n = tm_contact_found_places(i, group, a, effects, touch);
  if (n == 0 || group.lane > 0) return r;

  const tm_contact_law *w = a->law + a->type[i];
  const tm_real dp = tm_contact_size(i, a);
  const int layer = a->layer && w->layer;

  tm_contact_law own;
  if (a->size) {
    own = tm_contact_law_of_size(w, dp, (effects & TM_CT_3D) != 0);
    w = &own;
  }
  tm_contact_body b = tm_contact_load(i, a, w, effects);
  tm_contact_point c[TM_TOUCH_MAX];
  if (layer) {
    tm_contact_load_layer(i, a, touch, n, &b);
    if (touch[0].distance >= tm_max(b.thickness, w->radius)) return r; /* not even near */
    n = tm_contact_within(&b, n, touch);
  }
  if (a->uneven && n > 0) tm_vec_to_row(a->uneven + tm_row(i, 3), tm_vec(0, 0, 0));
  if (a->xsph_v && n > 0) tm_store3(a->xsph_v + 3 * (ptrdiff_t) i, tm_vec(0, 0, 0));
  for (int k = 0; k < n; k++) c[k] = tm_contact_add_normal(&b, touch + k, &a->pose, effects);
  if (b.layer && a->layer_dt > 0.0) tm_contact_store_layer(i, a, &b, c, n);
  if (n == 0) return r;
  if (effects & TM_CT_FRICTION)
    for (int k = 0; k < n; k++) tm_contact_add_friction(&b, c + k);

  for (int k = 0; k < n; k++) {
    const tm_real before = r.friction_power - r.friction_heat - r.conducted;
    tm_contact_tally(i, a, &b, c + k, effects, &r);
    r.heat_tool = (effects & TM_CT_HEAT) ? r.friction_power - r.friction_heat - r.conducted : 0.0;
    if (effects & TM_CT_OUTPUT)
      tm_contact_output(a, c + k, touch[k].triangle, (effects & TM_CT_HEAT) ? r.heat_tool - before : 0.0);
  }
  r.faced = b.faced && r.contacts > 0;
  if (a->earlier) tm_contact_settle(i, a, &b, c, n, &r);
  double *f = a->f + i * a->f_stride; /* F15 (17), times the mass */
  f[0] -= a->force_unit * r.force.x;
  f[1] -= a->force_unit * r.force.y;
  if (effects & TM_CT_3D) f[2] -= a->force_unit * r.force.z;
  if (effects & TM_CT_HEAT) {
    a->source[i] += r.friction_heat + r.conducted;
    if (a->tool_heat) a->tool_heat[i] = r.heat_tool;
  }
  return r;
}

TM_FN tm_contact_result tm_contact_tri(int i, const tm_contact_args *a, unsigned effects)
{
  return tm_contact_tri_shared(i, tm_group_alone(), a, effects);
}

#endif
