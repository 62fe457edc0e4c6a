/* SPH-TM: the end of a step of adaptive lists: which particles are searched in the next one, what their
   pairs keep, and how kept gradients follow the particles. See tm_kept.h. */
#ifndef TM_SETTLE_H
#define TM_SETTLE_H

#include "tm_kept.h"
#include "tm_search.h"
#include "tm_state.h"

/* What a particle tells before pairs are kept: E row major, and whether it is searched next. */
enum { TM_TOLD_SEARCHED = 9, TM_TOLD = 10 };

typedef struct {
  tm_kept_rows rows;
  tm_records rec;              /* of this step's force point */
  tm_state state;
  const tm_real *gradient, *stretch;
  tm_real *memory;             /* TM_K */
  tm_real *told;               /* TM_TOLD, owned and ghost */
  int corrected;               /* gradients are: Q = 1 */
  tm_real threshold, strain;   /* of plastic strain, of any strain since the search; infinite: never */
  tm_real dt, h, slope_norm, art_inv_w;
  int art_n, first;            /* first: the pairs of the first search of all, without artificial stress */
} tm_settle_args;

TM_FN tm_mat3 tm_mat_transposed(tm_mat3 a)
{
  tm_real t = a.xy; a.xy = a.yx; a.yx = t;
  t = a.xz; a.xz = a.zx; a.zx = t;
  t = a.yz; a.yz = a.zy; a.zy = t;
  return a;
}

/* Inverse; *good is 0 where the matrix is close to one that has none. In two dimensions that of the
   upper left block, with zz = 1. */
TM_FN tm_mat3 tm_mat_inverse(tm_mat3 a, int dim3, int *good)
{
  tm_mat3 b = tm_mat_identity();
  const tm_real size = a.xx * a.xx + a.xy * a.xy + a.yx * a.yx + a.yy * a.yy;
  if (!dim3) {
    const tm_real det = a.xx * a.yy - a.xy * a.yx;
    *good = fabs(det) > 0.05 * 0.5 * size;
    if (!*good) return b;
    b.xx = a.yy / det; b.xy = -a.xy / det; b.yx = -a.yx / det; b.yy = a.xx / det;
    return b;
  }
  const tm_real all = (size + a.xz * a.xz + a.yz * a.yz + a.zx * a.zx + a.zy * a.zy + a.zz * a.zz) / 3.0;
  const tm_real cxx = a.yy * a.zz - a.yz * a.zy, cyx = a.yz * a.zx - a.yx * a.zz, czx = a.yx * a.zy - a.yy * a.zx;
  const tm_real det = a.xx * cxx + a.xy * cyx + a.xz * czx;
  *good = fabs(det) > 0.05 * all * sqrt(all);
  if (!*good) return b;
  b.xx = cxx / det; b.yx = cyx / det; b.zx = czx / det;
  b.xy = (a.xz * a.zy - a.xy * a.zz) / det;
  b.yy = (a.xx * a.zz - a.xz * a.zx) / det;
  b.zy = (a.xy * a.zx - a.xx * a.zy) / det;
  b.xz = (a.xy * a.yz - a.xz * a.yy) / det;
  b.yz = (a.xz * a.yx - a.xx * a.yz) / det;
  b.zz = (a.xx * a.yy - a.xy * a.yx) / det;
  return b;
}

/* Is the particle with memory k searched in this step? New ones are. */
TM_FN int tm_is_searched(const tm_real *k) { return k[TM_K_SEARCHED] > 0.5 || k[TM_K_SEARCHES] < 0.5; }

/* B of this step: of a particle that was searched in it, 1/rho. */
TM_FN tm_mat3 tm_settle_map(int i, const tm_settle_args *a)
{
  const tm_real *k = a->memory + (ptrdiff_t) i * TM_K;
  if (tm_is_searched(k))
    return tm_mat_scale(1.0 / tm_main_record(&a->rec, i)[tm_part(TM_REC_RHO)], tm_mat_identity());
  return tm_mat_load(k + TM_K_B);
}

/* Is particle i to be searched in the next step? */
TM_FN int tm_settle_wanted(int i, const tm_settle_args *a, tm_mat3 E, unsigned effects)
{
  const tm_real *k = a->memory + (ptrdiff_t) i * TM_K;
  if (k[TM_K_NEAR] > 0.5) return 1;
  if ((effects & TM_FX_PLASTICITY) &&
      tm_field_row(&a->state, TM_F_PSTRAIN, i)[0] - k[TM_K_PSTRAIN] > a->threshold)
    return 1;
  if (!(a->threshold < 1e300)) return 0;
  if ((effects & TM_FX_DAMAGE) && tm_field_row(&a->state, TM_F_DAMAGE, i)[tm_column(1)] > 0.5) return 1;
  if (!(a->strain < 1e300)) return 0;
  /* E = J F^T, J = det F */
  const int dim3 = (effects & TM_FX_3D) != 0;
  const tm_mat3 C = tm_mat_mul(E, tm_mat_transposed(E));
  const tm_real det = dim3 ? E.xx * (E.yy * E.zz - E.yz * E.zy) - E.xy * (E.yx * E.zz - E.yz * E.zx)
                                 + E.xz * (E.yx * E.zy - E.yy * E.zx)
                           : E.xx * E.yy - E.xy * E.yx;
  const tm_real J = dim3 ? sqrt(sqrt(fabs(det))) : cbrt(fabs(det)), s = 1.0 / (J * J);
  const tm_real xx = s * C.xx - 1.0, yy = s * C.yy - 1.0, zz = dim3 ? s * C.zz - 1.0 : 0.0;
  const tm_real shear = C.xy * C.xy + (dim3 ? C.xz * C.xz + C.yz * C.yz : 0.0);
  const tm_real strain2 = 0.25 * (xx * xx + yy * yy + zz * zz + 2.0 * s * s * shear);
  return !(strain2 <= a->strain * a->strain);
}

/* First pass: what particle i tells. Returns 1 when it is searched next. */
TM_FN int tm_settle_tell(int i, const tm_settle_args *a, unsigned effects)
{
  const int dim3 = (effects & TM_FX_3D) != 0;
  const tm_real rho = tm_main_record(&a->rec, i)[tm_part(TM_REC_RHO)];
  int good;
  const tm_mat3 E = tm_mat_inverse(tm_mat_scale(rho, tm_settle_map(i, a)), dim3, &good);
  tm_real *out = a->told + (ptrdiff_t) i * TM_TOLD;
  const int searched = !good || tm_settle_wanted(i, a, E, effects);
  tm_mat_store(out, E);
  out[TM_TOLD_SEARCHED] = searched;
  return searched;
}

/* Weights of the pair in entry `from` of the row, as it is now, into entry `to`. */
TM_FN void tm_settle_pair(int i, int j, int to, const tm_settle_args *a, int kernel, int dim3)
{
  const tm_real *ri = tm_main_record(&a->rec, i), *rj = tm_main_record(&a->rec, j);
  const tm_vec3 d = tm_vec(ri[tm_part(0)] - rj[tm_part(0)], ri[tm_part(1)] - rj[tm_part(1)],
                           dim3 ? ri[tm_part(2)] - rj[tm_part(2)] : 0.0);
  const tm_real r = tm_vec_norm(d), q = r / a->h, slope = tm_kernel_slope(kernel, q);
  const tm_vec3 w = tm_vec_scale(slope / r, d);
  const tm_real *ei = a->told + (ptrdiff_t) i * TM_TOLD, *ej = a->told + (ptrdiff_t) j * TM_TOLD;
  const ptrdiff_t next = a->rows.capacity * a->rows.stride;
  float *out = tm_weight(&a->rows, i) + to * a->rows.stride;
  for (int c = 0; c < 3; c++) {
    out[(TM_W_OWN + c) * next] = (float) (ei[3 * c] * w.x + ei[3 * c + 1] * w.y + ei[3 * c + 2] * w.z);
    out[(TM_W_OTHER + c) * next] = (float) (ej[3 * c] * w.x + ej[3 * c + 1] * w.y + ej[3 * c + 2] * w.z);
  }
  out[TM_W_SLOPE * next] = (float) (slope / q);
  out[TM_W_TENSILE * next] =
      a->first ? 0.0f : (float) tm_power_int(tm_kernel_shape(kernel, q) * a->art_inv_w, a->art_n);
  out[TM_W_DISTANCE * next] = (float) q;
}

/* G of a row as it is now. */
TM_FN tm_mat3 tm_settle_stretch(int i, const tm_settle_args *a, int dim3)
{
  const tm_real *ri = tm_main_record(&a->rec, i);
  const ptrdiff_t stride = a->rows.stride, next = a->rows.capacity * stride;
  const int *row = a->rows.index + a->rows.first[i];
  const float *w = tm_weight(&a->rows, i);
  tm_real G[9] = {0, 0, 0, 0, 0, 0, 0, 0, 0};
  for (int k = 0; k < a->rows.kept[i]; k++) {
    const tm_real *rj = tm_main_record(&a->rec, row[k * stride]);
    for (int r = 0; r < (dim3 ? 3 : 2); r++)
      for (int c = 0; c < 3; c++)
        G[3 * r + c] += rj[tm_part(TM_REC_M)] * (rj[tm_part(r)] - ri[tm_part(r)]) * (tm_real) w[c * next + k * stride];
  }
  return tm_mat_scale(a->slope_norm, tm_mat_load(G));
}

/* Second pass, when the ghosts have been told: the row and the memory of particle i. */
TM_FN void tm_settle(int i, const tm_settle_args *a, unsigned effects)
{
  const int kernel = tm_fx_kernel(effects), dim3 = (effects & TM_FX_3D) != 0;
  const tm_kept_rows *r = &a->rows;
  const ptrdiff_t stride = r->stride, next = r->capacity * stride;
  tm_real *k = a->memory + (ptrdiff_t) i * TM_K;
  const tm_real was = tm_is_searched(k);
  tm_mat3 B = tm_settle_map(i, a);
  k[TM_K_MARK] = was;
  k[TM_K_SEARCHES] += was;
  k[TM_K_SEARCHED] = a->told[(ptrdiff_t) i * TM_TOLD + TM_TOLD_SEARCHED];
  if (k[TM_K_SEARCHED] > 0.5) {
    r->kept[i] = r->fresh[i] = 0;
    r->fresh_first[i] = r->first[i];
    k[TM_K_PSTRAIN] = (effects & TM_FX_PLASTICITY) ? tm_field_row(&a->state, TM_F_PSTRAIN, i)[0] : 0.0;
    return;
  }
  int *row = r->index + r->first[i], n = 0;
  float *w = tm_weight(r, i);
  for (int e = 0; e < r->kept[i]; e++) {
    const int j = row[e * stride];
    if (a->told[(ptrdiff_t) j * TM_TOLD + TM_TOLD_SEARCHED] > 0.5) continue;
    if (n < e) {
      row[n * stride] = j;
      for (int c = 0; c < TM_WEIGHTS; c++) w[c * next + n * stride] = w[c * next + e * stride];
    }
    n++;
  }
  int changed = r->fresh[i] > 0 || n < r->kept[i];
  for (int e = r->kept[i]; e < r->kept[i] + r->fresh[i]; e++) {
    const int j = row[e * stride];
    if (a->told[(ptrdiff_t) j * TM_TOLD + TM_TOLD_SEARCHED] > 0.5) continue;
    row[n * stride] = j;
    tm_settle_pair(i, j, n++, a, kernel, dim3);
  }
  r->kept[i] = n;
  r->fresh[i] = 0;
  r->fresh_first[i] = r->first[i] + n * stride;

  const tm_mat3 L = tm_mat_from_row(a->gradient + tm_row(i, 9));
  tm_mat3 G = changed ? tm_settle_stretch(i, a, dim3) : tm_mat_load(a->stretch + (ptrdiff_t) i * 9);
  tm_mat3 Q = changed ? tm_mat_identity() : tm_mat_load(k + TM_K_Q);
  if (changed && !a->corrected) Q = tm_mat_mul(tm_mat_transposed(G), B);
  tm_mat_store(k + TM_K_Q, Q);
  /* the next force point is dt ahead */
  tm_mat3 step = tm_mat_scale(a->dt, L);
  step.xx += 1.0; step.yy += 1.0; step.zz += 1.0;
  int good;
  const tm_mat3 inverse = tm_mat_inverse(tm_mat_mul(step, G), dim3, &good);
  if (good) B = tm_mat_mul(tm_mat_transposed(inverse), Q);
  else {    /* too few neighbours to tell: B follows L */
    const tm_mat3 back = tm_mat_inverse(step, dim3, &good);
    if (good) B = tm_mat_mul(tm_mat_transposed(back), B);
  }
  if (!dim3) B.xz = B.yz = B.zx = B.zy = 0.0;
  tm_mat_store(k + TM_K_B, B);
}

TM_FN tm_real tm_speed(int i, const tm_state *s)
{
  const double *v = s->v + 3 * (ptrdiff_t) i;
  return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/* ---- from time to time: is something near that is no neighbour, or has a neighbour moved? */

typedef struct {
  tm_search_args search;       /* cells and types; cells wide enough for what comes near until the next time */
  tm_kept_rows rows;
  tm_records rec;
  tm_real *memory;
  const unsigned char *searched;
  tm_real h, near, change;     /* the last two in units of h: see below */
  tm_real time;                /* since the last time, taken for that to the next one */
} tm_watch_args;

/* Distance of j from i in units of h, and what it will have become the next time if it goes on. */
TM_FN tm_real tm_watch_distance(int i, int j, const tm_watch_args *a, tm_real *then)
{
  const tm_real *ri = tm_main_record(&a->rec, i), *rj = tm_main_record(&a->rec, j);
  const tm_vec3 d = tm_vec(ri[tm_part(0)] - rj[tm_part(0)], ri[tm_part(1)] - rj[tm_part(1)],
                           ri[tm_part(2)] - rj[tm_part(2)]);
  const tm_vec3 v = tm_vec(ri[tm_part(4)] - rj[tm_part(4)], ri[tm_part(5)] - rj[tm_part(5)],
                           ri[tm_part(6)] - rj[tm_part(6)]);
  const tm_real r = tm_vec_norm(d);
  *then = (r + a->time * tm_vec_dot(v, d) / r) / a->h;
  return r / a->h;
}

/* Sets memory TM_K_NEAR: the particle is searched in every step until nothing has moved for
   TM_NEAR_HOLD times. So where bodies meet, slide and part the rates are those of the search in every
   step; kept pairs would hold bodies together that part. */
TM_FN void tm_watch(int i, const tm_watch_args *a)
{
  tm_real *k = a->memory + (ptrdiff_t) i * TM_K, then;
  const int was_near = k[TM_K_NEAR] > 0.5;
  if (!was_near && tm_is_searched(k)) return;
  const tm_kept_rows *r = &a->rows;
  const int *row = r->index + r->first[i];
  const float *w = tm_weight(r, i) + TM_W_DISTANCE * r->capacity * r->stride;
  int known = 0, all = 0, moves = 0;
  for (int e = 0; e < r->kept[i] && !was_near; e++) {
    const tm_real q = tm_watch_distance(i, row[e * r->stride], a, &then);
    known += q < a->near || then < a->near;
    moves += fabs(q - (tm_real) w[e * r->stride]) > a->change;
  }
  const double *x = a->search.cells.x + 3 * (ptrdiff_t) i;
  for (int c = 0; c < 9; c++) {
    int begin, end;
    tm_search_cells(&a->search.cells, x, c, &begin, &end);
    for (int e = begin; e < end; e++) {
      const int j = a->search.cells.index[e];
      if (!(tm_search_meets(i, j, &a->search) & TM_MEETS_MECHANICAL)) continue;
      const tm_real q = tm_watch_distance(i, j, a, &then);
      if (q < a->near || then < a->near) {
        all += !a->searched[j];
        moves += was_near && fabs(q - then) > a->change;
      }
    }
  }
  if (moves || (!was_near && all > known)) k[TM_K_NEAR] = TM_NEAR_HOLD;
  else if (was_near) k[TM_K_NEAR] -= 1.0;
}

#endif
