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

#include "tm_contact.h"
#include "tm_contact_layer.h"
#include "tm_fields.h"
#include "tm_material.h"
#include "tm_motion.h"
#include "tm_record.h"
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

/* Sums over particles, but for the depth; all in mass-length-time units. */
typedef struct {
  tm_vec3 force, torque;  /* on the tool */
  tm_real friction_power; /* dissipated by friction */
  tm_real friction_heat;  /* of it, into the particles */
  tm_real conducted;      /* heat from the tool into the particles besides */
  tm_real heat_tool;      /* into the tool: friction_power - friction_heat - conducted */
  tm_real spring;         /* energy of the contact springs */
  tm_real damping_power;  /* dissipated by damping */
  tm_real particle_power; /* work of contact forces on particles, per time */
  tm_real tool_power;     /* work done by the tool's motion, per time */
  tm_real late_friction;  /* what this tool changes in the friction power of earlier ones */
  tm_real depth;          /* deepest penetration */
  tm_real inner;          /* deepest center behind the surface, 0: none */
  tm_real within;         /* deepest center within half a spacing of the surface, where the layer is thinner */
  int contacts;
  int faced; /* particles that are pressed from two opposite sides: one row, which has no strain across */
} tm_contact_result;

TM_FN tm_contact_result tm_contact_nothing(void)
{
  tm_contact_result r;
  r.force = r.torque = tm_vec(0, 0, 0);
  r.friction_power = r.friction_heat = r.conducted = r.heat_tool = r.spring = 0.0;
  r.damping_power = r.particle_power = r.tool_power = r.late_friction = r.depth = r.inner = r.within = 0.0;
  r.contacts = r.faced = 0;
  return r;
}

TM_FN void tm_contact_sum(tm_contact_result *a, const tm_contact_result *b)
{
  a->force = tm_vec_add(a->force, b->force);
  a->torque = tm_vec_add(a->torque, b->torque);
  a->friction_power += b->friction_power;
  a->friction_heat += b->friction_heat;
  a->conducted += b->conducted;
  a->heat_tool += b->heat_tool;
  a->spring += b->spring;
  a->damping_power += b->damping_power;
  a->particle_power += b->particle_power;
  a->tool_power += b->tool_power;
  a->late_friction += b->late_friction;
  a->depth = tm_max(a->depth, b->depth);
  a->inner = tm_max(a->inner, b->inner);
  a->within = tm_max(a->within, b->within);
  a->contacts += b->contacts;
  a->faced += b->faced;
}

/* Sums of several threads into one place. */
TM_FN void tm_contact_add(double *sum, double value)
{
#if defined(__CUDA_ARCH__)
  atomicAdd(sum, value);
#else
#if defined(_OPENMP)
#pragma omp atomic
#endif
  *sum += value;
#endif
}
TM_FN void tm_contact_count(int *sum)
{
#if defined(__CUDA_ARCH__)
  atomicAdd(sum, 1);
#else
#if defined(_OPENMP)
#pragma omp atomic
#endif
  *sum += 1;
#endif
}

/* The sum before n is added. */
TM_FN int tm_contact_take(int *sum, int n)
{
#if defined(__CUDA_ARCH__)
  return atomicAdd(sum, n);
#else
  int before;
#if defined(_OPENMP)
#pragma omp atomic capture
#endif
  {
    before = *sum;
    *sum += n;
  }
  return before;
#endif
}

/* One contact of one particle, in the world frame. */
typedef struct {
  tm_vec3 point, normal;          /* on the surface; unit, towards the particle */
  tm_vec3 tool_v;                 /* velocity of the tool there */
  tm_vec3 normal_force, friction; /* on the particle */
  tm_real fn, delta, closing;     /* normal force, penetration, its rate */
} tm_contact_point;

/* A particle while its contacts are evaluated. */
typedef struct {
  const tm_contact_law *law;
  tm_vec3 v, rate_v; /* velocity at the start of the step, and at the time of the forces */
  tm_vec3 force;     /* all of this step so far */
  tm_real mass, dt, temperature;
  tm_real yield; /* flow stress, 0: not known */
  /* of the layer at the force point, where this tool has it (row, or NULL): its thickness and strain, the derivative of the
     thickness, the rate of the strain, and the direction N in which it is taken, N : D */
  tm_real *layer;
  tm_real thickness, strain, arm, rate;
  tm_sym3 direction;
  tm_real side; /* tm_layer_side() of this tool */
  int faced;    /* another surface presses from the opposite side */
} tm_contact_body;

TM_FN tm_contact_body tm_contact_load(int i, const tm_contact_args *a, const tm_contact_law *law, unsigned effects)
{
  tm_contact_body b;
  b.law = law;
  b.mass = a->rmass ? a->rmass[i] : a->mass[a->type[i]];
  b.dt = a->dt;
  b.v = tm_load3(a->v + i * a->v_stride);
  b.rate_v = a->record ? tm_vec_from_record(a->record + tm_record(i, TM_REC), TM_REC_V, 1) : b.v;
  b.force = tm_vec_scale(1.0 / a->force_unit, tm_load3(a->f + i * a->f_stride));
  if (!(effects & TM_CT_3D)) b.force.z = 0.0;
  b.temperature = (effects & TM_CT_HEAT) ? a->temperature[i * a->temperature_stride]
                                         : tm_start_temperature(&a->start, a->mask ? a->mask[i] : 0);
  b.yield = a->pstrain ? a->pstrain[tm_row(i, tm_field_columns(TM_F_PSTRAIN)) + tm_column(2)] : 0.0;
  b.layer = NULL;
  b.thickness = law->radius;
  b.strain = b.arm = b.rate = 0.0;
  b.direction = tm_sym(0, 0, 0, 0, 0, 0);
  b.side = 1.0;
  b.faced = 0;
  return b;
}

/* The layer of a particle with this tool near, at n places, the nearest first; the particle's other tools find half a spacing.
   The strain is that along the normals, by weight of the springs. */
TM_FN void tm_contact_load_layer(int i, const tm_contact_args *a, const tm_touch *touch, int n, tm_contact_body *b)
{
  tm_real *row = a->layer + tm_row(i, TM_L_COLUMNS);
  const tm_real near = row[tm_column(TM_L_NEAR)], r = b->law->radius;
  const tm_vec3 nearest = tm_mat_mul_vec(a->pose.turn, touch[0].normal);
  if (near > 0.0 && fabs(row[tm_column(TM_L_TOOL)]) != a->tool) {
    b->faced = tm_layer_faces(row, nearest);
    return;
  }
  b->layer = row;
  b->side = tm_layer_side(nearest);
  const tm_real start = near > 0.0 ? row[tm_column(TM_L_STRAIN)] : 0.0,
                thickness = r * tm_layer_stretch(start, &b->arm);
  tm_real sum = 0.0;
  for (int k = 0; k < n; k++) {
    const tm_real w = touch[0].distance < thickness ? tm_max(thickness - touch[k].distance, 0.0) : k == 0;
    const tm_vec3 normal = tm_mat_mul_vec(a->pose.turn, touch[k].normal);
    b->direction = tm_sym_axpy(b->direction, w, tm_mat_symmetric(tm_mat_outer(normal, normal)));
    sum += w;
    b->faced = b->faced || tm_vec_dot(normal, nearest) < -0.9;
  }
  b->direction = tm_sym_scale(1.0 / sum, b->direction);
  b->rate = tm_sym_ddot(b->direction, tm_mat_symmetric(tm_mat_from_row(a->gradient + tm_row(i, 9))));
  const int ends = !tm_layer_goes_on(start, a->layer_dt * b->rate);
  if (ends) b->rate = 0.0;
  b->strain = start + 0.5 * a->layer_dt * b->rate;
  b->thickness = r * tm_layer_stretch(b->strain, &b->arm);
  b->arm = ends ? 0.0 : r * b->arm; /* no work in a layer that stays as it is */
}

/* Those of n places whose distance is below the thickness of the layer, in front. */
TM_FN int tm_contact_within(const tm_contact_body *b, int n, tm_touch *touch)
{
  int within = 0;
  for (int k = 0; k < n; k++)
    if (touch[k].distance < b->thickness) touch[within++] = touch[k];
  return within;
}

/* The layer at the end of the step, and the stress that n contacts will have at the next force point. */
TM_FN void tm_contact_store_layer(int i, const tm_contact_args *a, const tm_contact_body *b, const tm_contact_point *c,
                                  int n)
{
  const tm_real *r = a->record + tm_record(i, TM_REC), k = b->law->stiffness;
  const tm_real damping = tm_contact_damping(b->law->damping, k, b->mass);
  const tm_real per_force = b->arm * r[tm_part(TM_REC_RHO)] / r[tm_part(TM_REC_M)];
  tm_real next = 0.0, now = 0.0;
  for (int m = 0; m < n; m++) {
    now += c[m].fn;
    if (c[m].fn > 0.0) next += tm_max(k * (c[m].delta + a->layer_dt * c[m].closing) + damping * c[m].closing, 0.0);
  }
  /* what the last prediction lacks is given in the step that comes, so that nothing is missing in the sum */
  tm_real *ahead = b->layer + tm_column(TM_L_AHEAD);
  const tm_real owed = now * per_force - (b->layer[tm_column(TM_L_NEAR)] == TM_LAYER_NOW - 1.0 ? *ahead : 0.0);
  *ahead = next * per_force;
  tm_sym_to_row(b->layer + tm_column(TM_L_STRESS), tm_sym_scale(*ahead + owed, b->direction));
  b->layer[tm_column(TM_L_STRAIN)] = b->strain + 0.5 * a->layer_dt * b->rate;
  b->layer[tm_column(TM_L_NEAR)] = TM_LAYER_NOW;
  b->layer[tm_column(TM_L_TOOL)] = b->side * a->tool;
}

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

/* Diameter of particle i. */
TM_FN tm_real tm_contact_size(int i, const tm_contact_args *a)
{
  return a->size ? a->size[(ptrdiff_t) i * TM_REC_SIZE + TM_SIZE_DP] : 2.0 * a->law[a->type[i]].radius;
}

/* Where particle i touches the tool, or is near enough for a layer to reach it; the number of places. On a GPU several threads
   look, and all of them get the places. */
TM_FN int tm_contact_places(int i, tm_group group, const tm_contact_args *a, unsigned effects, tm_touch *touch)
{
  if (a->mask && !(a->mask[i] & a->group)) return 0;
  const tm_contact_law *w = a->law + a->type[i];
  if (!w->active) return 0;
  const tm_real radius = 0.5 * tm_contact_size(i, a), reach = a->layer && w->layer ? TM_LAYER_REACH : 1.0;
  const tm_vec3 p = tm_pose_to_local(&a->pose, tm_load3(a->x + i * a->x_stride));
  if (effects & TM_CT_F15) return tm_touch_find_f15(&a->mesh, &a->grid, p, radius, touch);
  return tm_touch_find(&a->mesh, &a->grid, p, reach * radius, a->deep, (effects & TM_CT_TWO_SIDED) != 0, group, touch);
}

/* The same, left in `found` for later in the step. */
TM_FN void tm_contact_look(int i, tm_group group, const tm_contact_args *a, unsigned effects)
{
  const tm_contact_found *found = &a->found;
  tm_touch touch[TM_TOUCH_MAX];
  const int n = tm_contact_places(i, group, a, effects, touch);
  if (group.lane > 0) return;
  int place = 0;
  if (n > 0) {
    const int first = tm_contact_take(found->taken, n);
    place = first <= found->room - n ? first * TM_FOUND + n : -1;
    if (place > 0)
      for (int k = 0; k < n; k++) found->touch[first + k] = touch[k];
  }
  found->place[i] = place;
}

/* What such a look has found, or finds now. */
TM_FN int tm_contact_found_places(int i, tm_group group, const tm_contact_args *a, unsigned effects, tm_touch *touch)
{
  const int place = a->found.place ? a->found.place[i] : -1;
  if (place < 0) return tm_contact_places(i, group, a, effects, touch);
  const int n = place % TM_FOUND;
  for (int k = 0; k < n; k++) touch[k] = a->found.touch[place / TM_FOUND + k];
  return n;
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
