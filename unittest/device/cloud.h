/* SPH-TM: a cloud of particles with every state field, and what is done to it in a step, for the test that compares a GPU
   with the host. All of it is one struct that is copied to the device as it is; the loops' arguments point into it. */
#ifndef CLOUD_H
#define CLOUD_H

#include "points.h"
#include "tm_body_contact.h"
#include "tm_tool_move.h"
#include "tm_drift.h"
#include "tm_surface_flux.h"
#include "tm_dirichlet.h"
#include "tm_hourglass.h"
#include "tm_initial.h"
#include "tm_moment.h"
#include "tm_neighbors.h"
#include "tm_predict.h"
#include "tm_rates.h"
#include "tm_tally.h"
#include "tm_thermal.h"

enum { SIDE = 10, CLOUD = SIDE * SIDE * SIDE, ROOM = 160, TYPES = 2 };

typedef struct {
  /* not compared */
  unsigned effects;
  int n, kernel, dim, slice;
  double h, spacing, dt;
  tm_material material[TYPES + 1];
  tm_contact_law law[TYPES + 1];
  tm_body_law touch_law[(TYPES + 1) * (TYPES + 1)];
  int touch_side[(TYPES + 1) * (TYPES + 1)], touch_strains[TYPES + 1];
  tm_body_surface body_surface;
  double conductance[(TYPES + 1) * (TYPES + 1)], effusivity[TYPES + 1], mass[TYPES + 1];
  unsigned char meets[(TYPES + 1) * (TYPES + 1)];
  int type[CLOUD], mask[CLOUD], tag[CLOUD];
  int list[CLOUD * ROOM], length[CLOUD];              /* the host's list */
  tm_tri_view mesh;
  tm_grid_view grid;
  tm_pose from, to;
  double factor[TM_GRADIENT_ENTRIES];                 /* tm_gradient_table */
  /* rows */
  int count[TM_SEGMENTS][CLOUD], index[CLOUD * ROOM];
  ptrdiff_t first[CLOUD];
  /* compared, all of one kind */
  double x[3 * CLOUD], v[3 * CLOUD], force[3 * CLOUD], force_internal[3 * CLOUD], source[CLOUD];
  double rho[CLOUD], stress[6 * CLOUD], history[TM_H_COLUMNS * CLOUD], pstrain[3 * CLOUD], temperature[3 * CLOUD];
  double size[TM_S_COLUMNS * CLOUD], energy[3 * CLOUD], damage[2 * CLOUD], balsara[CLOUD], xsph[3 * CLOUD], thickness[CLOUD];
  double hourglass[TM_G_COLUMNS * CLOUD], rec_hourglass[TM_REC_HOURGLASS * CLOUD], hourglass_rate[3 * CLOUD];
  __attribute__((aligned(16))) double rec_main[TM_REC * CLOUD], rec_stress[TM_REC_STRESS * CLOUD], rec_heat[TM_REC_HEAT * CLOUD];
  __attribute__((aligned(16))) double rec_stab[TM_REC_STAB * CLOUD];
  double rec_correction[TM_REC_CORRECTION * CLOUD], rec_size[TM_REC_SIZE * CLOUD];
  double reference[TM_R_COLUMNS * CLOUD], unstrained[CLOUD], turned[TM_K_COLUMNS * CLOUD], moment[TM_MOMENT_COLUMNS * CLOUD];
  double face[TM_FACE_COLUMNS * CLOUD], turn[3 * CLOUD], face_next[TM_FACE_COLUMNS * CLOUD];
  double gradient[9 * CLOUD], heat[CLOUD], correction[6 * CLOUD], xsph_v[3 * CLOUD], surface[3 * CLOUD], uneven[3 * CLOUD];
  double artificial[CLOUD], near[CLOUD], body_sides[TM_BODY_SIDE * CLOUD], body_ahead[TM_AHEAD * CLOUD];
  double body_layer[TM_L_COLUMNS * CLOUD], body_thin[TM_THIN * CLOUD], tally[TM_TALLY * CLOUD], tool_heat[CLOUD];
  double result[POINTS_MOST * CLOUD];                 /* what the function returned */
} cloud;

/* name, columns of the arrays that are compared */
#define CLOUD_ARRAYS(ARRAY)                                                                                         \
  ARRAY(x, 3) ARRAY(v, 3) ARRAY(force, 3) ARRAY(source, 1) ARRAY(rho, 1) ARRAY(stress, 6) ARRAY(history, 20)         \
  ARRAY(pstrain, 3) ARRAY(temperature, 3) ARRAY(energy, 3) ARRAY(damage, 2) ARRAY(balsara, 1) ARRAY(xsph, 3)         \
  ARRAY(thickness, 1) ARRAY(rec_main, TM_REC) ARRAY(rec_stress, 6) ARRAY(rec_heat, 2) ARRAY(rec_correction, 9)       \
  ARRAY(size, TM_S_COLUMNS) ARRAY(rec_size, TM_REC_SIZE) ARRAY(hourglass, TM_G_COLUMNS)                              \
  ARRAY(rec_hourglass, TM_REC_HOURGLASS) ARRAY(hourglass_rate, 3) ARRAY(rec_stab, TM_REC_STAB)                       \
  ARRAY(reference, TM_R_COLUMNS) ARRAY(unstrained, 1) ARRAY(turned, TM_K_COLUMNS) ARRAY(moment, TM_MOMENT_COLUMNS)                   \
  ARRAY(face, TM_FACE_COLUMNS) ARRAY(turn, 3) ARRAY(face_next, TM_FACE_COLUMNS)                                       \
  ARRAY(gradient, 9) ARRAY(heat, 1) ARRAY(correction, 6) ARRAY(xsph_v, 3) ARRAY(uneven, 3) ARRAY(surface, 3) ARRAY(artificial, 1)     \
  ARRAY(near, 1) ARRAY(tally, TM_TALLY) ARRAY(tool_heat, 1) ARRAY(body_sides, TM_BODY_SIDE) ARRAY(body_ahead, TM_AHEAD) \
  ARRAY(body_layer, TM_L_COLUMNS) ARRAY(body_thin, TM_THIN)                                                          \
  ARRAY(result, POINTS_MOST)

TM_FN tm_state cloud_state(cloud *w)
{
  tm_state s;
  s.field[TM_F_RHO] = w->rho; s.field[TM_F_STRESS] = w->stress; s.field[TM_F_HISTORY] = w->history;
  s.field[TM_F_PSTRAIN] = w->pstrain; s.field[TM_F_TEMP] = w->temperature; s.field[TM_F_ENERGY] = w->energy;
  s.field[TM_F_DAMAGE] = w->damage; s.field[TM_F_BALSARA] = w->balsara; s.field[TM_F_XSPH] = w->xsph;
  s.field[TM_F_THICKNESS] = w->thickness; s.field[TM_F_SIZE] = w->size; s.field[TM_F_HOURGLASS] = w->hourglass;
  s.field[TM_F_FRACTURE] = w->reference; s.field[TM_F_UNSTRAINED] = w->unstrained;
  s.field[TM_F_CORRECTION] = w->turned; s.field[TM_F_FACE] = w->face; s.field[TM_F_LAYER] = NULL;
  s.x = w->x; s.v = w->v; s.force = w->force;
  s.type = w->type; s.mask = w->mask;
  s.material = w->material;
  s.mass = w->mass;
  s.rmass = NULL;
  return s;
}
TM_FN tm_records cloud_records(cloud *w)
{
  tm_records r;
  r.main = w->rec_main; r.stress = w->rec_stress; r.heat = w->rec_heat; r.correction = w->rec_correction;
  r.size = (w->effects & TM_FX_SMOOTHING) ? w->rec_size : NULL;
  r.hourglass = w->rec_hourglass;
  r.stab = (w->effects & TM_FX_ONE_PASS) ? w->rec_stab : NULL;
  r.faces = (w->effects & TM_FX_FACES) != 0;
  return r;
}
TM_FN tm_row_args cloud_row_args(cloud *w)
{
  tm_row_args a;
  a.list = w->list; a.length = w->length;
  a.row_step = ROOM; a.step = 1;
  a.bits = 0x3fffffff;
  a.meets = w->meets;
  a.type = w->type; a.tag = w->tag;
  a.ntypes = TYPES;
  a.index = w->index;
  for (int s = 0; s < TM_SEGMENTS; s++) a.count[s] = w->count[s];
  a.first = w->first;
  a.stride = TM_ROW_SLICE; a.in_place = 0;
  return a;
}
TM_FN tm_rates_args cloud_rates(cloud *w)
{
  tm_rates_args a;
  const tm_real support = tm_kernel_support(w->kernel), radius = support * w->h;
  memset(&a, 0, sizeof a);
  a.support2 = support * support;
  a.norm_of_one = tm_kernel_norm(w->kernel, w->dim, 1.0);
  a.rows.index = w->index; a.rows.first = w->first; a.rows.stride = w->slice;
  a.rows.mechanical = w->count[0]; a.rows.thermal = w->count[1]; a.rows.contact = w->count[2];
  a.rec = cloud_records(w);
  a.effects = w->effects;
  a.h = w->h;
  a.support_radius2 = radius * radius;
  a.norm = tm_kernel_norm(w->kernel, w->dim, w->h);
  a.slope_norm = a.norm / w->h;
  a.visc_alpha = 0.7; a.visc_beta = 1.3;
  a.art_n = 4;
  a.art_inv_w = 1.0 / tm_kernel_shape(w->kernel, w->spacing / w->h);
  a.xsph = 0.3;
  a.force_unit = 1.0;
  a.conductance = w->conductance;
  a.type = w->type;
  a.ntypes = TYPES;
  a.force = w->force; a.force_begins = 0;
  a.gradient = w->gradient; a.heat = w->heat; a.correction = w->correction;
  a.hourglass_rate = w->hourglass_rate; a.moment = w->moment; a.which = NULL;
  a.turn = w->turn; a.face_next = w->face_next;
  a.uneven = (w->effects & TM_FX_ONE_PASS) ? w->uneven : NULL;
  a.xsph_v = w->xsph_v; a.surface = w->surface; a.artificial = w->artificial;
  a.surface_of_pass = (w->effects & (TM_FX_ONE_PASS | TM_FX_SURFACE)) == TM_FX_ONE_PASS;
  return a;
}
TM_FN tm_update_args cloud_update(cloud *w)
{
  tm_update_args a;
  a.state = cloud_state(w);
  a.rec = cloud_records(w);
  a.gradient = w->gradient; a.heat = w->heat; a.xsph_v = w->xsph_v; a.artificial = w->artificial;
  a.hourglass_rate = w->hourglass_rate; a.hourglass = (w->effects & TM_FX_ONE_PASS) ? -1.0 : 0.1;
  a.moment = w->moment; a.correction = w->correction; a.face_next = w->face_next;
  a.uneven = (w->effects & TM_FX_ONE_PASS) ? w->uneven : NULL; a.held = 2;
  a.force_internal = w->force_internal;
  a.source = w->source;
  a.group = 1;
  a.dt = w->dt; a.h = w->h; a.visc_alpha = 0.7; a.shock = 0.6;
  a.accel_unit = 1.0;
  a.temperature = 300.0;
  a.heat_rate = 3.0; a.k_max = 60.0;
  a.hottest = 1450.0; a.densest = 1.02; a.watch_melt = 1;    /* some of each beyond */
  a.share = NULL; a.ratio = w->h / w->spacing;
  return a;
}
TM_FN void cloud_put_limits(double *out, const tm_update_result *r)
{
  for (int k = 0; k < 3; k++) out[k] = 1.0 / r->dt[k];
  out[3] = r->stress_work; out[4] = r->plastic; out[5] = r->plastic_heat; out[6] = r->artificial;
  out[7] = r->kinetic_work; out[8] = r->internal_work; out[9] = r->heat; out[10] = r->status;
  out[11] = r->melted < INT_MAX;
}

/* --- stages, in the order of a step */

#define STAGE(name) TM_FN void stage_##name(int i, cloud *w, double *out)

STAGE(drift)
{
  tm_drift_args a;
  a.state = cloud_state(w);
  a.group = 1;
  a.half = 0.5 * w->dt;
  for (int d = 0; d < 3; d++) {
    a.closed[d][0] = a.closed[d][1] = 1;
    a.lo[d] = 0.02 * w->spacing; a.hi[d] = (SIDE - 1) * w->spacing;
  }
  out[0] = tm_drift(i, &a, w->effects);
}
STAGE(predict)
{
  tm_predict_args a;
  a.state = cloud_state(w);
  a.rec = cloud_records(w);
  a.dt_ahead = 0.5 * w->dt; a.visc_alpha = 0.7; a.shock = 0.6;
  a.art_eps = 0.3; a.hourglass = (w->effects & TM_FX_ONE_PASS) ? -1.0 : 0.1;
  a.h = w->h; a.correction = w->correction; a.turn = w->turn;
  a.art_component = w->dim == 2;
  a.gradient = w->factor;
  a.share = NULL; a.ratio = w->h / w->spacing;
  tm_predict(i, &a, w->effects);
  tm_predict_artstress(i, i + 1, &a, w->effects);
  (void) out;
}
STAGE(moment)
{
  const tm_rates_args a = cloud_rates(w);
  tm_moment(i, &a, w->effects);
  (void) out;
}
STAGE(rates)
{
  const tm_rates_args a = cloud_rates(w);
  tm_rates(i, &a, w->effects | (unsigned) TM_FX_EXTENDED);
  (void) out;
}
STAGE(hourglass)
{
  const tm_rates_args a = cloud_rates(w);
  tm_hourglass(i, &a, w->effects);
  (void) out;
}
STAGE(thermal)
{
  const tm_rates_args a = cloud_rates(w);
  if (a.rows.thermal[i]) tm_thermal(i, tm_group_alone(), &a, w->effects);
  (void) out;
}
TM_FN tm_body_contact_args cloud_bodies(cloud *w)
{
  tm_body_contact_args b;
  b.law = w->touch_law; b.side = w->touch_side; b.sides = 1; b.effusivity = w->effusivity;
  b.surface = w->body_surface;
  b.spacing = w->spacing;
  b.dt = w->dt; b.after = 0.5 * w->dt;
  b.sides_of = w->body_sides;
  b.ahead = w->body_ahead; b.mask = 0;
  b.start.of_all = 300.0; b.start.n = 0;
  b.layer = w->body_layer; b.thin = w->body_thin; b.strains = w->touch_strains;
  b.layer_dt = w->dt;
  b.source = w->source;
  return b;
}
TM_FN void cloud_body_result(const tm_body_contact_result *r, double *out)
{
  out[0] = r->spring; out[1] = r->damping_power; out[2] = r->friction_power; out[3] = r->heat_power; out[4] = r->work_power;
}
STAGE(body_ahead)
{
  tm_ahead_args a;
  a.state = cloud_state(w);
  a.dt = w->dt; a.force_unit = 1.0;
  a.ahead = w->body_ahead;
  tm_body_ahead(i, &a, w->effects);
  (void) out;
}
STAGE(body_thin)
{
  const tm_rates_args a = cloud_rates(w);
  const tm_body_contact_args b = cloud_bodies(w);
  tm_body_thin(i, &a, &b, w->effects);
  (void) out;
}
STAGE(body_touch)
{
  const tm_rates_args a = cloud_rates(w);
  const tm_body_contact_args b = cloud_bodies(w);
  const tm_body_contact_result r = tm_body_touch(i, &a, &b, w->effects);
  cloud_body_result(&r, out);
}
STAGE(body_contact)
{
  const tm_rates_args a = cloud_rates(w);
  const tm_body_contact_args b = cloud_bodies(w);
  const tm_body_contact_result r = tm_body_contact(i, &a, &b, w->effects);
  cloud_body_result(&r, out);
}
STAGE(contact_tri)
{
  tm_contact_args a;
  memset(&a, 0, sizeof a);
  a.mesh = w->mesh; a.grid = w->grid;
  a.pose = w->to;
  a.deep = w->spacing;
  a.dt = w->dt; a.after = 0.5 * w->dt;
  a.force_unit = 1.0;
  a.tool_temperature = 350.0;
  a.law = w->law;
  a.type = w->type;
  a.x = w->x; a.v = w->v; a.f = w->force;
  a.x_stride = a.v_stride = a.f_stride = 3;
  a.mass = w->mass;
  a.material = w->material;
  a.temperature = w->temperature; a.temperature_stride = 3;
  a.source = w->source;
  a.tool_heat = w->tool_heat;
  const unsigned common = TM_CT_HEAT | TM_CT_FRICTION | ((w->effects & TM_FX_3D) ? TM_CT_3D : 0);
  const tm_contact_result r = tm_contact_tri(i, &a, common);
  point_put(out, r.force);
  point_put(out + 3, r.torque);
  out[6] = r.friction_power; out[7] = r.friction_heat; out[8] = r.conducted; out[9] = r.heat_tool; out[10] = r.spring;
  out[11] = r.damping_power; out[12] = r.particle_power; out[13] = r.tool_power; out[14] = r.depth; out[15] = r.inner;
  out[16] = r.contacts;
}
STAGE(exchange)
{
  tm_surface_flux_args a;
  memset(&a, 0, sizeof a);
  a.mode = i % 4;
  a.strength = a.mode == TM_FLUX_RADIATION ? 5.67e-8 : 1e4;
  a.T_inf = 400.0;
  a.emissivity = -1.0;
  a.surface.least = 0.1 / w->spacing; a.surface.scale = 1.5; a.dim3 = w->dim == 3;
  a.area_factor = 1.0;
  a.rec = cloud_records(w); a.normal = w->surface;
  a.type = w->type; a.mask = w->mask; a.group = 1;
  a.material = w->material;
  a.source = w->source;
  const tm_surface_flux_result r = tm_surface_flux_of_group(i, &a, 0);
  out[0] = r.power; out[1] = r.area; out[2] = r.rate;
}
STAGE(hold)
{
  tm_dirichlet_args a;
  a.state = cloud_state(w);
  a.group = 2;
  a.temperature = 555.0;
  out[0] = tm_dirichlet(i, &a);
}
STAGE(drive)
{
  tm_drive_args a;
  a.state = cloud_state(w);
  a.group = 2;
  a.act = 1;
  a.turn.turns = i % 2;
  a.turn.point = tm_vec(0.1, -0.2, 0.3); a.turn.axis = tm_vec(0.6, 0.0, 0.8);
  a.turn.rate = 2.0;
  a.turn.period[0] = a.turn.period[1] = a.turn.period[2] = 0.0;
  a.given[0] = a.given[2] = 1; a.given[1] = 0;
  a.velocity[0] = 3.0; a.velocity[1] = 0.0; a.velocity[2] = -2.0;
  a.dt = w->dt;
  a.accel_unit = 1.0;
  const tm_drive_result r = tm_drive(i, &a);
  for (int k = 0; k < 3; k++) out[k] = r.force[k];
  out[3] = r.work; out[4] = r.torque;
}
STAGE(update)
{
  const tm_update_args a = cloud_update(w);
  const tm_update_result r = tm_update(i, &a, w->effects);
  cloud_put_limits(out, &r);
}
STAGE(initial_limits)
{
  const tm_update_args a = cloud_update(w);
  const tm_update_result r = tm_initial_limits(i, &a, w->effects, 1);
  cloud_put_limits(out, &r);
}
STAGE(tally)
{
  tm_tally_args a;
  const tm_state s = cloud_state(w);
  a.rec = cloud_records(w);
  a.state = s;
  a.to_energy = 1.0;
  a.per_particle = w->tally;
  const tm_tally_result r = tm_tally(i, &a, w->effects);
  for (int k = 0; k < TM_TALLY; k++) out[k] = r.value[k];
  out[TM_TALLY] = tm_kinetic_energy(i, &s);
}
STAGE(near)
{
  const tm_rates_args r = cloud_rates(w);
  tm_near_args a;
  a.rows = r.rows;
  a.main = r.rec.main;
  a.size = r.rec.size;
  a.support_radius2 = a.size ? r.support2 : r.support_radius2;
  a.count = w->near;
  out[0] = tm_near_count(i, &a);
  const tm_nearest c = tm_nearest_neighbor(i, &a);
  out[1] = c.distance; out[2] = c.j;
}
STAGE(carry)
{
  tm_tool_move_args a;
  a.state = cloud_state(w);
  a.group = 1;
  a.body_type = 2;
  a.dim3 = w->dim == 3;
  a.from = w->from; a.to = w->to;
  tm_tool_move(i, &a);
  (void) out;
}
STAGE(initial)
{
  tm_initial_args a;
  a.state = cloud_state(w);
  a.fields = (1u << TM_F_COUNT) - 1;
  a.temperature = 321.0;
  a.ratio = 1.2;
  a.dim3 = w->dim == 3;
  if (i % 2) w->rho[i] = 0.0;
  tm_initial_of_new(i, &a);
  (void) out;
}

#define CLOUD_STAGES(CASE)                                                                              \
  CASE(drift, POINTS_ARITHMETIC) CASE(predict, POINTS_TRANSCENDENTAL) CASE(moment, POINTS_ARITHMETIC)     \
  CASE(rates, POINTS_ARITHMETIC) CASE(hourglass, POINTS_ARITHMETIC) CASE(thermal, POINTS_ARITHMETIC)      \
  CASE(body_ahead, POINTS_ARITHMETIC) CASE(body_thin, POINTS_TRANSCENDENTAL)                              \
  CASE(body_touch, POINTS_TRANSCENDENTAL) CASE(body_contact, POINTS_TRANSCENDENTAL)                       \
  CASE(contact_tri, POINTS_TRANSCENDENTAL) CASE(exchange, POINTS_ARITHMETIC) CASE(drive, POINTS_ARITHMETIC) \
  CASE(update, POINTS_TRANSCENDENTAL) CASE(hold, POINTS_ARITHMETIC) CASE(tally, POINTS_ARITHMETIC)        \
  CASE(near, POINTS_ARITHMETIC) CASE(carry, POINTS_ARITHMETIC) CASE(initial_limits, POINTS_ARITHMETIC)    \
  CASE(initial, POINTS_ARITHMETIC)

#define STAGE_ID(name, tolerance) STAGE_##name,
enum { CLOUD_STAGES(STAGE_ID) CLOUD_STAGE_COUNT };
#undef STAGE_ID

TM_FN void cloud_run(int stage, int i, cloud *w)
{
  double *out = w->result + (ptrdiff_t) i * POINTS_MOST;
#define STAGE_CALL(name, tolerance) \
  case STAGE_##name: stage_##name(i, w, out); break;
  switch (stage) { CLOUD_STAGES(STAGE_CALL) }
#undef STAGE_CALL
}

#endif
