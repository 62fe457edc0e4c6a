/* SPH-TM: all rates of one particle in one pass over its neighbors.

   velocity gradient   L_i  = 1/rho_i  sum_j m_j (v_j - v_i) (x) gradW        conjugate of F15 (4)
                       L_i  = sum_j m_j/rho_j (v_j - v_i) (x) gradW           conjugate of F14 (6)
   density             drho_i/dt = -rho_i tr L_i                              F15 (2), F14 (4)
   acceleration        a_i = sum_j m_j (P_i + P_j + f^n (R_i + R_j) - Pi I) gradW   F15 (4), F14 (15)
   heat                rho c_p dT_i/dt = sum_j m_j/rho_j 4 k_i k_j/(k_i + k_j) (T_i - T_j) W'/r
                                                                              F15 (6)
   XSPH                dx_i = eps sum_j m_j/rho_mean (v_j - v_i) W
   surface             n_i = sum_j m_j/rho_j gradW; area of the surface = 2 V_i |n_i|; with one pass, where bonded
                       materials have one density, m_j/rho_i, of the moment's sums

   With gradient correction (F15 form only) gradW is gradW K_i in L and in the term of P_i, and
   gradW K_j in that of P_j; K comes from tm_moment.h. With one pass the term of P_i is P_i K_i times the sum of
   m_j gradW. With TM_FX_FACES x_i - x_j is replaced in gradW by what tm_face.h makes of it with the normal of i, and of j.

   Each velocity gradient is the work conjugate of its momentum form: the power of the pair forces
   equals minus sum V sigma:L minus the artificial heating, to round-off.

   A loop over columns makes the coefficients of each pair of a chunk (tm_rates_coefficients.h); a second one, without a branch or a
   function call, sums (tm_pair.h).

   In a file that defines TM_PAIR_SINGLE pairs are computed in single (tm_single.h). What a pair gives
   one particle is then opposite to what it gives the other to the last bit (the stress with one pass: to round-off): weights
   are symmetric in both, and the particle's own share is divided out of the sum. */
#ifndef TM_RATES_H
#define TM_RATES_H

#include "tm_pair.h"
#include "tm_rates_coefficients.h"
#include "tm_face.h"
#include "tm_tensor.h"

typedef struct {
  tm_sum_mat gradient;
  tm_sum_vec acceleration, xsph, surface;
  tm_sum artificial, heat;
  tm_sum_sym moment; /* with one pass: sums of -d (x) g, g, g d and g v, g = m_j W'/r */
  tm_sum weights;
  tm_sum_vec gd, gv;
  tm_sum_vec gi;   /* with faces: sum of m_j gradW as i has it */
  tm_sum_vec tilt; /* what normals of faces add to the moment, tilt (x) b */
  tm_sum less;     /* and what they take from the trace of the sums of -d (x) g */
} tm_rates_sums;

TM_FN tm_rates_sums tm_rates_sums_zero(void)
{
  tm_rates_sums s;
  s.gradient = tm_sum_mat_zero();
  s.acceleration = s.xsph = s.surface = tm_sum_vec_zero();
  s.artificial = s.heat = s.weights = s.less = tm_lanes_zero();
  s.moment = tm_sum_sym_zero();
  s.gd = s.gv = s.gi = s.tilt = tm_sum_vec_zero();
  return s;
}

TM_FN tm_sum_vec tm_group_sum_vec(tm_sum_vec v, int dim3, tm_group group)
{
  v.x = tm_group_sum(v.x, group);
  v.y = tm_group_sum(v.y, group);
  if (dim3) v.z = tm_group_sum(v.z, group);
  return v;
}

/* Over the threads of a GPU that share the row. */
TM_FN void tm_rates_sums_of_group(tm_rates_sums *s, const tm_rates_terms *t, tm_group group)
{
  tm_sum_mat *G = &s->gradient;
  tm_sum_sym *M = &s->moment;
  const int dim3 = t->dim3;
  G->xx = tm_group_sum(G->xx, group);
  G->xy = tm_group_sum(G->xy, group);
  G->yx = tm_group_sum(G->yx, group);
  G->yy = tm_group_sum(G->yy, group);
  if (dim3) {
    G->xz = tm_group_sum(G->xz, group);
    G->yz = tm_group_sum(G->yz, group);
    G->zx = tm_group_sum(G->zx, group);
    G->zy = tm_group_sum(G->zy, group);
    G->zz = tm_group_sum(G->zz, group);
  }
  s->acceleration = tm_group_sum_vec(s->acceleration, dim3, group);
  if (t->artstress || t->viscosity || t->one_pass) s->artificial = tm_group_sum(s->artificial, group);
  if (t->conduction) s->heat = tm_group_sum(s->heat, group);
  if (t->xsph) s->xsph = tm_group_sum_vec(s->xsph, dim3, group);
  if (t->surface) s->surface = tm_group_sum_vec(s->surface, dim3, group);
  if (!t->one_pass) return;
  M->xx = tm_group_sum(M->xx, group);
  M->yy = tm_group_sum(M->yy, group);
  M->xy = tm_group_sum(M->xy, group);
  if (dim3) {
    M->zz = tm_group_sum(M->zz, group);
    M->xz = tm_group_sum(M->xz, group);
    M->yz = tm_group_sum(M->yz, group);
  }
  s->weights = tm_group_sum(s->weights, group);
  s->gd = tm_group_sum_vec(s->gd, dim3, group);
  s->gv = tm_group_sum_vec(s->gv, dim3, group);
  if (!t->faces || t->whose == TM_RATES_INSIDE) return;
  s->gi = tm_group_sum_vec(s->gi, dim3, group);
  s->tilt = tm_group_sum_vec(s->tilt, dim3, group);
  s->less = tm_group_sum(s->less, group);
}

/* Of a pair, or of those of a chunk, which are at a free face. */
enum { TM_FACE_NONE = 0, TM_FACE_OTHER, TM_FACE_BOTH };

TM_FN int tm_rates_own_at_face(const tm_rates_own *own, int dim3)
{
  const tm_pair *b = own->stab + TM_STAB_FACE;
  return tm_face_is_there(b[0], b[1], dim3 ? b[2] : 0);
}

/* Whether one of the neighbors in a chunk is at a free face. */
TM_FN int tm_rates_other_at_face(const tm_chunk *c, const tm_rates_terms *t, tm_values *col)
{
  tm_values *bj = col + TM_COL_STAB + TM_STAB_FACE;
#if TM_COLUMN == 1
  (void) c;
  return tm_face_is_there(bj[0][0], bj[1][0], t->dim3 ? bj[2][0] : 0);
#else
  const tm_lanes zero = {0};
  tm_sum sum = tm_lanes_zero();
  for (int l = 0; l < c->lanes; l += TM_LANES) {
    const tm_lanes_vec other = {tm_values_load(bj[0], l), tm_values_load(bj[1], l),
                                t->dim3 ? tm_values_load(bj[2], l) : zero};
    sum += tm_lanes_dot(other, other, t->dim3);
  }
  return tm_lanes_sum(sum) > 0;
#endif
}

/* D of tm_face.h times the slope of the kernel, from e toward the particle's neighbor: kept e + added b. Both particles of a
   pair come here with the same bits. */
typedef struct {
  tm_lanes kept, added, less; /* less: slope - kept */
} tm_rates_tilted;
TM_FN tm_rates_tilted tm_rates_tilt(tm_lanes slope, tm_lanes kappa, tm_lanes_vec b, tm_lanes s, int dim3)
{
  tm_rates_tilted t;
  t.less = slope * kappa * s;
  t.kept = slope - t.less;
  t.added = t.less * s * tm_lanes_inverse(tm_lanes_dot(b, b, dim3) + TM_PAIR(1e-30));
  return t;
}

/* gradW as the neighbors have it, TM_LANES of them from neighbor l on. */
TM_FN tm_lanes_vec tm_rates_face_of_other(const tm_chunk *c, const tm_rates_terms *t, tm_values *col, int l,
                                          tm_lanes_vec d)
{
  const tm_lanes zero = {0};
  tm_values *b = col + TM_COL_STAB + TM_STAB_FACE;
  const tm_lanes_vec other = {tm_values_load(b[0], l), tm_values_load(b[1], l),
                              t->dim3 ? tm_values_load(b[2], l) : zero};
  const tm_lanes kappa = t->sizes
                             ? zero + TM_PAIR(TM_FACE_TILT) * tm_values_load(col[(int) TM_COL_SIZE + TM_SIZE_INV_H], l)
                             : zero + TM_PAIR(TM_FACE_TILT) * c->own.inv_h;
  const tm_rates_tilted j =
      tm_rates_tilt(tm_values_load(col[TM_COL_SLOPE], l), kappa, other, tm_lanes_dot(other, d, t->dim3), t->dim3);
  return tm_lanes_add(tm_lanes_scale(j.kept, d), tm_lanes_scale(j.added, other));
}

/* The sums at free faces, of TM_LANES pairs from neighbor l on: gradW as i has it. The moment of i takes the part
   along d, kept, and tilt (x) b. */
TM_FN void tm_rates_add_face(const tm_chunk *c, const tm_rates_terms *t, const tm_rates_own *own, tm_values *col, int l,
                             tm_lanes_vec d, tm_lanes_vec *gi, tm_lanes_vec *kept, tm_rates_sums *s)
{
  const tm_lanes zero = {0}, kappa = zero + TM_PAIR(TM_FACE_TILT) * c->own.inv_h;
  const int dim3 = t->dim3;
  const tm_pair *b = own->stab + TM_STAB_FACE;
  const tm_lanes_vec mine = {zero + b[0], zero + b[1], dim3 ? zero + b[2] : zero};
  const tm_rates_tilted i =
      tm_rates_tilt(tm_values_load(col[TM_COL_SLOPE], l), kappa, mine, zero - tm_lanes_dot(mine, d, dim3), dim3);
  *kept = tm_lanes_scale(i.kept, d);
  *gi = tm_lanes_add(*kept, tm_lanes_scale(zero - i.added, mine));
  tm_sum_vec_add(&s->gi, *gi);
  tm_sum_vec_add(&s->tilt, tm_lanes_scale(i.added, d));
  s->less -= i.less * tm_lanes_dot(d, d, dim3);
}

/* The pairs with TM_LANES neighbors of a chunk, from neighbor l on, into the sums of motion. faces, a literal: which may be
   at a free face. */
TM_FN void tm_rates_add(const tm_chunk *c, const tm_rates_terms *t, const tm_rates_own *own, tm_values *col, int l,
                        int faces, tm_rates_sums *s)
{
  const tm_lanes zero = {0};
  const int dim3 = t->dim3;
  const tm_lanes_vec d = {tm_chunk_lanes_apart(c->x, col[0], l), tm_chunk_lanes_apart(c->y, col[1], l),
                          dim3 ? tm_chunk_lanes_apart(c->z, col[2], l) : zero}; /* x_i - x_j */
  const tm_lanes_vec v = tm_pair_difference(own->r + TM_REC_V, col + TM_REC_V, l, dim3);
  const tm_lanes_vec m_gradw = tm_lanes_scale(tm_values_load(col[TM_COL_SLOPE], l), d);
  const tm_lanes per_rho = t->form_f14 ? tm_values_load(col[TM_COL_PER_RHO], l) : zero;
  tm_lanes_vec gi = m_gradw, gj = m_gradw, kept = m_gradw;
  if (faces == TM_FACE_BOTH) tm_rates_add_face(c, t, own, col, l, d, &gi, &kept, s);
  if (faces != TM_FACE_NONE) gj = tm_rates_face_of_other(c, t, col, l, d);

  /* velocity gradient, conjugate of F15 (4), and of F14 (6) with the volume m_j/rho_j; its trace: F15 (2), F14 (4) */
  const tm_lanes_vec g = t->form_f14 ? tm_lanes_scale(per_rho, m_gradw) : gi;
  tm_pair_gradient(&s->gradient, v, g, dim3);

  /* momentum F15 (4), F14 (6) and (15); corrected: P K for P */
  tm_sum_vec *a = &s->acceleration;
  const tm_lanes_vec g_momentum = t->form_f14 ? tm_lanes_scale(own->inv_rho + zero, g) : m_gradw;
  if (t->one_pass) { /* of the neighbor; tm_rates_store() has that of the particle itself */
    tm_pair_momentum_of_other(a, col + TM_COL_STAB + TM_STAB_PK, l, gj, dim3);
  } else if (t->correction)
    tm_pair_momentum(a, tm_pair_tensor_sum(own->correction, col + TM_COL_CORRECTION, l), g_momentum, dim3);
  else tm_pair_momentum(a, tm_pair_symmetric_sum(own->r + TM_REC_P, col + TM_REC_P, l), g_momentum, dim3);

  /* artificial terms F14 (15): their heating apart, for the energy balance */
  if (t->one_pass) { /* hourglass control and viscosity, both along the line between the particles */
    const tm_lanes slope = tm_values_load(col[TM_COL_SLOPE], l);
    const tm_lanes_vec across = tm_pair_difference(own->stab + TM_STAB_W, col + TM_COL_STAB + TM_STAB_W, l, dim3);
    tm_lanes along = tm_lanes_dot(across, d, dim3) * tm_values_load(col[TM_COL_HOURGLASS], l);
    if (t->viscosity) along -= tm_values_load(col[TM_COL_VISCOUS], l) * slope;
    tm_pair_along(a, &s->artificial, along, d, v, dim3);
    tm_pair_moment(&s->moment, d, kept, dim3);
    s->weights += slope;
    tm_sum_vec_add(&s->gd, m_gradw);
    tm_sum_vec_add(&s->gv, tm_lanes_scale(slope, v));
    if (t->conduction && !t->extended) s->heat += tm_values_load(col[TM_COL_CONDUCTED], l); /* F15 (6) */
    if (t->xsph && !t->extended) tm_pair_xsph(&s->xsph, tm_values_load(col[TM_COL_SMOOTH], l), v);
    return;
  }
  tm_lanes_vec artificial = {zero, zero, zero};
  if (t->artstress)
    artificial = tm_pair_artificial_stress(tm_pair_symmetric_sum(own->stress, col + TM_COL_STRESS, l),
                                           tm_values_load(col[TM_COL_TENSILE], l), m_gradw, dim3);
  if (t->viscosity) tm_pair_viscosity(&artificial, tm_values_load(col[TM_COL_VISCOUS], l), m_gradw);
  if (t->artstress || t->viscosity) tm_pair_artificial(a, &s->artificial, artificial, v);
  if (t->conduction && !t->extended) s->heat += tm_values_load(col[TM_COL_CONDUCTED], l); /* F15 (6) */
}
/* The pairs of a chunk. Where neither is at a free face all ways give the same bits, and where the particle is not, both of the
   other two. */
TM_FN void tm_rates_add_loop(const tm_chunk *c, const tm_rates_terms *t, const tm_rates_own *own, tm_values *col,
                             tm_rates_sums *s)
{
  int faces = TM_FACE_NONE;
  if (t->faces) {
    const int mine = t->whose == TM_RATES_AT_FACE || (t->whose == TM_RATES_ALL && tm_rates_own_at_face(own, t->dim3));
    const int any = mine || tm_rates_other_at_face(c, t, col);
#if defined(__CUDA_ARCH__) /* threads that go on together would take one way after the other */
    if (t->whose == TM_RATES_AT_FACE || __any_sync(__activemask(), any))
      faces = t->whose == TM_RATES_INSIDE ? TM_FACE_OTHER : TM_FACE_BOTH;
#else
    faces = mine ? TM_FACE_BOTH : any ? TM_FACE_OTHER : TM_FACE_NONE;
#endif
  }
  if (faces == TM_FACE_BOTH && t->whose != TM_RATES_INSIDE)
    for (int l = 0; l < c->lanes; l += TM_LANES) tm_rates_add(c, t, own, col, l, TM_FACE_BOTH, s);
  else if (faces == TM_FACE_OTHER && (t->whose == TM_RATES_INSIDE || TM_COLUMN > 1))
    for (int l = 0; l < c->lanes; l += TM_LANES) tm_rates_add(c, t, own, col, l, TM_FACE_OTHER, s);
  else if (t->whose != TM_RATES_AT_FACE)
    for (int l = 0; l < c->lanes; l += TM_LANES) tm_rates_add(c, t, own, col, l, TM_FACE_NONE, s);
}

/* With the form of the momentum equation as a literal. */
TM_FN void tm_rates_add_forms(const tm_chunk *c, const tm_rates_terms *t, const tm_rates_own *own, tm_values *col,
                              tm_rates_sums *s)
{
  tm_rates_terms u = *t;
  u.form_f14 = u.correction = 0;
  if (t->one_pass) tm_rates_add_loop(c, &u, own, col, s);
  else if (t->form_f14) {
    u.form_f14 = 1;
    tm_rates_add_loop(c, &u, own, col, s);
  } else if (t->correction) {
    u.correction = 1;
    tm_rates_add_loop(c, &u, own, col, s);
  } else tm_rates_add_loop(c, &u, own, col, s);
}

/* With the extended instantiation: sums of the effects that it tests, each in a loop of its own. */
TM_FN void tm_rates_add_rare(const tm_chunk *c, const tm_rates_terms *t, const tm_rates_own *own, tm_values *col,
                             tm_rates_sums *s)
{
  const tm_lanes zero = {0};
  const int dim3 = t->dim3, lanes = c->lanes;
  if (t->extended && t->conduction) /* F15 (6) */
    for (int l = 0; l < lanes; l += TM_LANES) s->heat += tm_values_load(col[TM_COL_CONDUCTED], l);
  if (t->extended && t->xsph)
    for (int l = 0; l < lanes; l += TM_LANES)
      tm_pair_xsph(&s->xsph, tm_values_load(col[TM_COL_SMOOTH], l),
                   tm_pair_difference(own->r + TM_REC_V, col + TM_REC_V, l, dim3));
  if (t->surface)
    for (int l = 0; l < lanes; l += TM_LANES) {
      const tm_lanes_vec d = {tm_chunk_lanes_apart(c->x, col[0], l), tm_chunk_lanes_apart(c->y, col[1], l),
                              dim3 ? tm_chunk_lanes_apart(c->z, col[2], l) : zero};
      tm_sum_vec_add(&s->surface, tm_lanes_scale(tm_values_load(col[TM_COL_PER_RHO], l),
                                                 tm_lanes_scale(tm_values_load(col[TM_COL_SLOPE], l), d)));
    }
}

/* The pairs of a chunk into the sums; effects tested at run time once per chunk. */
TM_FN void tm_rates_add_all(const tm_chunk *c, const tm_rates_terms *t, const tm_rates_own *own, tm_values *col,
                            tm_rates_sums *s)
{
  tm_rates_terms u = *t;
  if (!t->extended) tm_rates_add_loop(c, t, own, col, s);
  else {
    u.viscosity = 1;
    if (TM_COLUMN == 1) tm_rates_add_loop(c, &u, own, col, s);
    else if (t->artstress) {
      u.artstress = 1;
      tm_rates_add_forms(c, &u, own, col, s);
    } else {
      u.artstress = 0;
      tm_rates_add_forms(c, &u, own, col, s);
    }
  }
  tm_rates_add_rare(c, t, own, col, s);
}

/* The correction at this force point with the moment's sums of tm_rates_store_stabilized() at a free face, g = sum V_j gradW:
   its symmetric part, the rest into *turn, and the normal for the next step into *normal. */
TM_FN tm_sym3 tm_rates_face(const tm_rates_terms *t, const tm_rates_own *own, const tm_rates_sums *s, tm_sym3 M,
                            tm_real per_rho, tm_vec3 g, tm_real h, tm_real *face, tm_vec3 *turn, tm_vec3 *normal)
{
  const tm_pair *of = own->stab + TM_STAB_FACE;
  const tm_vec3 b = tm_vec(of[0], of[1], t->dim3 ? of[2] : 0.0);
  const tm_real trace = M.xx + M.yy + (t->dim3 ? M.zz : 0.0) + per_rho * tm_lanes_sum(s->less);
  *normal = tm_face_normal(g, h, (t->dim3 ? 3.0 : 2.0) - trace);
  const tm_real across[3] = {tm_lanes_sum(s->tilt.x), tm_lanes_sum(s->tilt.y), tm_lanes_sum(s->tilt.z)};
  const tm_mat3 tilt = tm_mat_outer(tm_vec_scale(per_rho, tm_load3(across)), b);
  const tm_mat3 K = tm_face_inverse(tm_mat_add(tm_mat_from_sym(M), tilt), b, t->dim3);
  const tm_real sum = tm_vec_norm(tm_mat_mul_vec(tm_mat_transposed(K), g));
  *face = sum;
  const tm_sym3 used = tm_correction_of_loose(tm_mat_symmetric(K), h, face);
  *turn = tm_vec_scale(sum > 0.0 ? *face / sum : 1.0, tm_face_turn(K));
  return used;
}

/* With one pass: its sums, in the order of the enumeration. */
enum { TM_SUM_MOMENT = 0, TM_SUM_WEIGHTS = 6, TM_SUM_GD = 7, TM_SUM_GV = 10, TM_SUM_GI = 13, TM_SUMS = 16 };
TM_FN void tm_rates_sums_stabilized(const tm_rates_sums *s, tm_real *sum)
{
  const tm_sum all[TM_SUMS] = {s->moment.xx, s->moment.yy, s->moment.zz, s->moment.xy, s->moment.xz, s->moment.yz,
                               s->weights,   s->gd.x,      s->gd.y,      s->gd.z,      s->gv.x,      s->gv.y,
                               s->gv.z,      s->gi.x,      s->gi.y,      s->gi.z};
  tm_lanes_sums(all, TM_SUMS, sum);
}

/* With one pass: the correction at this force point, and the rate of the displacement of hourglass control. */
TM_FN void tm_rates_store_stabilized(int i, const tm_rates_args *a, const tm_rates_terms *t, const tm_pair_records *rec,
                                     const tm_rates_own *own, const tm_rates_sums *s, const tm_real *sum, tm_mat3 L)
{
  const tm_real length = TM_SINGLE ? rec->length : 1.0;
  const tm_real per_rho = (TM_SINGLE ? 1.0 / own->r[TM_REC_M] : 1.0) / own->r[TM_REC_RHO];
  const tm_sym3 M = tm_sym_scale(per_rho, tm_sym_load(sum + TM_SUM_MOMENT));
  const tm_vec3 gd = tm_vec_scale(length, tm_load3(sum + TM_SUM_GD));
  tm_real *moment = a->moment + tm_row(i, TM_MOMENT_COLUMNS);
  const tm_vec3 g = tm_vec_scale(per_rho / (length * length), gd); /* sum V_j gradW */
  tm_real face;
  if (a->uneven) tm_vec_to_row_in(a->uneven + tm_row(i, 3), g, t->dim3);
  if (a->surface_of_pass && a->surface) tm_store3(a->surface + 3 * (ptrdiff_t) i, g);
  if (t->faces) {
    tm_vec3 turn, normal;
    tm_sym_to_row_in(moment, tm_rates_face(t, own, s, M, per_rho, g, tm_rates_h(i, a), &face, &turn, &normal), t->dim3);
    tm_real *next = a->face_next + tm_row(i, TM_FACE_COLUMNS);
    tm_vec_to_row(next + tm_column(TM_FACE_NORMAL), normal);
    tm_vec_to_row(next + tm_column(TM_FACE_TURN), turn);
  } else {
    const tm_sym3 K = tm_sym_inverse_bounded(M, t->dim3, TM_MOMENT_LOW);
    face = per_rho / (length * length) * tm_vec_norm(tm_sym_mul_vec(K, gd));
    tm_sym_to_row_in(moment, tm_correction_of_loose(K, tm_rates_h(i, a), &face), t->dim3);
  }
  const tm_vec3 rate = tm_residual_velocity(sum[TM_SUM_WEIGHTS], gd, tm_load3(sum + TM_SUM_GV), L);
  tm_vec_to_row_in(a->hourglass_rate + tm_row(i, 3), rate, t->dim3);
}

/* Sums of particle i, in the units of pair arithmetic, into the results. */
TM_FN void tm_rates_store(int i, const tm_rates_args *a, const tm_rates_terms *t, const tm_pair_records *rec,
                          const tm_rates_own *own, const tm_rates_sums *s)
{
  const tm_pair mi = own->r[TM_REC_M], rhoi = own->r[TM_REC_RHO];
  const tm_real per_length = TM_SINGLE ? 1.0 / rec->length : 1.0;
  const tm_real per_mass = TM_SINGLE ? per_length / mi : 1.0;
  const tm_real lscale = (t->form_f14 ? 1.0 : TM_SINGLE ? 1.0 / rhoi : own->inv_rho) * per_mass;
  const tm_sum none = tm_lanes_zero();
  const tm_sum_mat *G = &s->gradient;
  /* clang-format off */
  const tm_sum all[16] = {G->xx, G->xy, G->xz, G->yx, G->yy, G->yz, G->zx, G->zy, G->zz,
                          s->acceleration.x, s->acceleration.y, s->acceleration.z, s->artificial, s->heat, none, none};
  /* clang-format on */
  tm_real L[16], stabilized[TM_SUMS], *acceleration = L + 9;
  tm_lanes_sums(all, 16, L);
  if (t->one_pass) { /* P_i K_i times the sum of m_j gradW */
    tm_rates_sums_stabilized(s, stabilized);
    const int tilted = t->faces && t->whose != TM_RATES_INSIDE && tm_rates_own_at_face(own, t->dim3);
    const tm_real *g = stabilized + (tilted ? (int) TM_SUM_GI : (int) TM_SUM_GD);
    tm_pair PK[TM_STAB_LATE + 1];
    tm_fetch(rec->stab + tm_pair_record(i, TM_REC_STAB), TM_STAB_LATE, PK);
    PK[TM_STAB_LATE] = own->stab[TM_STAB_LATE];
    for (int d = 0; d < 3; d++) acceleration[d] += PK[3 * d] * g[0] + PK[3 * d + 1] * g[1] + PK[3 * d + 2] * g[2];
  }
  for (int k = 0; k < 9; k++) L[k] *= lscale;
  if (t->correction || t->one_pass) {
    const tm_sym3 K = tm_sym_from_row_in(a->correction + tm_row(i, 6), t->dim3);
    const tm_vec3 turn = t->faces ? tm_vec_from_row(a->turn + tm_row(i, 3)) : tm_vec(0, 0, 0);
    for (int r = 0; r < 9; r += 3) {
      const tm_vec3 row = tm_vec(L[r], L[r + 1], L[r + 2]);
      tm_vec3 l = tm_sym_mul_vec(K, row); /* the transpose of K = K_s + [turn] */
      if (t->faces) l = tm_vec_sub(l, tm_vec_cross(turn, row));
      L[r] = l.x;
      L[r + 1] = l.y;
      L[r + 2] = l.z;
    }
  }
  const tm_real per_force = TM_SINGLE ? rec->volume * per_length : mi, mf = per_force * a->force_unit;
  tm_real *gradient = a->gradient + tm_row(i, 9);
  for (int k = 0; k < 9; k++) gradient[tm_column(k)] = L[k];
  double *f = a->force + 3 * (ptrdiff_t) i;
  const int begins = a->force_begins;
  for (int d = 0; d < 3; d++) f[d] = (begins ? 0.0 : f[d]) + mf * acceleration[d];
  if (t->one_pass) tm_rates_store_stabilized(i, a, t, rec, own, s, stabilized, tm_mat_load(L));
  if ((t->artstress || t->viscosity || t->one_pass) && a->artificial) a->artificial[i] = 0.5 * per_force * L[12];
  if (t->conduction) a->heat[i] = TM_SINGLE ? L[13] * per_length * per_length * own->density / own->mass : L[13];
  if (t->xsph) {
    tm_real *u = a->xsph_v + 3 * (ptrdiff_t) i;
    u[0] = a->xsph * tm_lanes_sum(s->xsph.x);
    u[1] = a->xsph * tm_lanes_sum(s->xsph.y);
    u[2] = a->xsph * tm_lanes_sum(s->xsph.z);
  }
  if (t->surface) {
    tm_real *n = a->surface + 3 * (ptrdiff_t) i;
    n[0] = per_mass * tm_lanes_sum(s->surface.x);
    n[1] = per_mass * tm_lanes_sum(s->surface.y);
    n[2] = per_mass * tm_lanes_sum(s->surface.z);
  }
}

/* Of one particle, if it is one of those that the call is for. On a GPU its row may be shared by several threads. */
TM_FN void tm_rates_of(int i, tm_group group, const tm_rates_args *a, unsigned effects, int whose)
{
  tm_rates_terms t = tm_rates_terms_of(effects, a->effects);
  t.whose = whose;
  const tm_pair_records rec = tm_pair_records_of(a);
  tm_rates_sums sums = tm_rates_sums_zero();
  tm_rates_own own;
  tm_rates_load(i, a, &t, &rec, &own);
  if (whose == TM_RATES_INSIDE && t.faces && tm_rates_own_at_face(&own, t.dim3)) return;

  tm_chunk c;
  int jj[TM_CHUNK_ROOM];
  tm_pair TM_ALIGNED col[TM_COLUMNS][TM_COLUMN];
  tm_chunk_begin(&c, i, a, own.r, t.sizes, jj);
  if (group.size > 1) tm_chunk_share(&c, group, jj);
  for (; tm_chunk_gather(&c, jj, col[0], t.dim3); tm_chunk_carry(&c, jj)) {
    if (c.n == 0) continue;
    tm_rates_fetch(&c, jj, &t, &rec, col);
    tm_rates_all_coefficients(&c, &t, &own, col);
    tm_rates_add_all(&c, &t, &own, col, &sums);
  }
  if (group.size > 1) tm_rates_sums_of_group(&sums, &t, group);
  if (group.lane == 0) tm_rates_store(i, a, &t, &rec, &own, &sums);
}

TM_FN void tm_rates(int i, const tm_rates_args *a, unsigned effects)
{
  tm_rates_of(i, tm_group_alone(), a, effects, TM_RATES_ALL);
}

#endif
