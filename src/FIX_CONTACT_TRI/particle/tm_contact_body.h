/* SPH-TM: one particle while its contacts with a tool are evaluated, and the layer between its center and the surface
   (tm_contact_layer.h). */
#ifndef TM_CONTACT_BODY_H
#define TM_CONTACT_BODY_H

#include "tm_contact_args.h"
#include "tm_contact_layer.h"
#include "tm_fields.h"
#include "tm_record.h"

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
  b->thickness = tm_layer_advance(start, r, a->layer_dt, &b->rate, &b->strain, &b->arm);
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
  tm_layer_store(b->layer, now * per_force, next * per_force, b->direction, b->strain + 0.5 * a->layer_dt * b->rate,
                 b->side * a->tool);
}

#endif
