/* SPH-TM: rows that are kept from one step to the next, and the rates of their pairs.

   A pair keeps the gradient of the kernel at its last search, w0 = grad W(x_i - x_j), pulled back to
   each of its ends:
     a_i = E_i w0,  a_j = E_j w0,  E = D^-1,  D_i = F_i^-T / det F_i
   F_i is the deformation of particle i since it was searched itself. The gradient that i sees now is
   D_i a_i: it turns and stretches with i, so a rigid rotation makes no strain rate, and there is no
   tensile instability. With B = D/rho (rho det F stays: total-Lagrangian volumes follow from it)
     L_i = [sum_j m_j (v_j - v_i) (x) a_i] B_i^T
     m_i a_i = m_i sum_j m_j (A_i a_i + A_j a_j),   A = rho P B,  P = sigma/rho^2      F15 (4)
   Both ends of a pair hold the same numbers with opposite sign: linear momentum stays. L is the work
   conjugate of the forces.

   F follows from the positions of the neighbours,
     G_i = sum_j m_j (x_j - x_i) (x) a_i,   B_i = G_i^-T Q_i
   where Q holds B as it was when the row last changed; with corrected gradients that are never searched Q = 1 and the
   gradient of a linear field is exact. Those that are searched again have tm_kept_moment.h. G is measured when the row
   changes and every few steps; between it goes on with its rate, the sum with v_j - v_i that L is made of, which costs
   nothing.

   Viscosity and conduction take the frozen W'/r and the current x_i - x_j, viscosity also the distance,
   densities and speeds of sound of the search. Kept pairs need no artificial stress and have none.

   A step fetches all weights of all rows from memory, which takes as long as to compute with them: they are 16 bits wide.
   Gradients, slope(q) x/r in place of grad W, are whole multiples of a unit that is 6e-5 of the steepest slope; those of
   the viscosity are the upper half of a float. Both ends of a pair hold the same numbers, and the products are in double:
   momentum and energy do not notice. */
#ifndef TM_KEPT_H
#define TM_KEPT_H

#include "tm_rates.h"

#if TM_SINGLE
#error "double only: both ends of a kept pair hold the same products in double"
#endif

enum {
  TM_W_OWN = 0,        /* a_i */
  TM_W_BULK = 3,       /* alpha c/rho slope(q)/q / (q^2 + 0.01), c and rho means of the pair */
  TM_W_SHOCK,          /* beta/rho slope(q)/q / (q^2 + 0.01)^2 */
  TM_W_OTHER,          /* a_j */
  TM_W_SLOPE = 8,      /* slope(q)/q of conduction, a float: upper and lower half */
  TM_W_DISTANCE = 10,  /* q = r/h at the search, over TM_DISTANCE_UNIT */
  TM_WEIGHTS
};
#define TM_DISTANCE_UNIT (1.0 / 8192.0)
/* Gradients may be so many times the steepest slope: E of a particle that was not searched, and above it is. */
#define TM_KEPT_MOST 2.0

/* Entry k of row i is index[first[i] + k stride]; kept ones come first, filled up with weights of 0, then
   those pairs of a particle that is not searched whose other end is. Weight c: see tm_weight(). kept, and the memory of
   particles, have room for one more: what comes next is fetched ahead. */
typedef struct {
  int *index, *kept, *fresh;
  const ptrdiff_t *first;
  ptrdiff_t *fresh_first;      /* where those searched in this step begin */
  ptrdiff_t stride;
  int capacity;
  tm_real unit;                /* of gradients */
  short *weight;
} tm_kept_rows;

/* The unit of gradients of a kernel. */
TM_HOST_FN tm_real tm_kept_unit(int kernel)
{
  tm_real most = 0.0;
  for (int k = 0; k <= 3000; k++) most = tm_max(most, fabs(tm_kernel_slope(kernel, 1e-3 * k)));
  return TM_KEPT_MOST * most / 32767.0;
}

/* To the nearest whole number, alike on both sides of 0. */
TM_FN short tm_weight_whole(tm_real v)
{
  return (short) tm_clamp(v < 0.0 ? v - 0.5 : v + 0.5, -32767.0, 32767.0);
}

/* The halves of a float. */
TM_FN unsigned tm_weight_bits(float v)
{
  unsigned bits;
  memcpy(&bits, &v, sizeof bits);
  return bits;
}
TM_FN float tm_weight_float(unsigned bits)
{
  float v;
  memcpy(&v, &bits, sizeof v);
  return v;
}
TM_FN short tm_weight_upper(tm_real v) { return (short) ((tm_weight_bits((float) v) + 0x8000u) >> 16); }

/* The weights of row i, and where weight c of entry k lies there: eight entries together, apart those weights that
   all rows need, those of rows with TM_K_MIXED, and the others. */
TM_FN short *tm_weight(const tm_kept_rows *r, int i)
{
  const ptrdiff_t lane = i % r->stride;
  return r->weight + (r->first[i] - lane) * TM_WEIGHTS + lane;
}
TM_FN ptrdiff_t tm_weight_place(const tm_kept_rows *r, int c, int k)
{
  const int begin = c < TM_W_OTHER ? 0 : c < TM_W_SLOPE ? TM_W_OTHER : TM_W_SLOPE;
  const int width = c < TM_W_OTHER ? TM_W_OTHER : c < TM_W_SLOPE ? TM_W_SLOPE - TM_W_OTHER : TM_WEIGHTS - TM_W_SLOPE;
  return ((ptrdiff_t) begin * r->capacity + (k / 8 * width + c - begin) * 8 + k % 8) * r->stride;
}

/* Places that n kept entries take: whole vectors. */
TM_FN int tm_kept_places(int n) { return (n + 7) / 8 * 8; }

/* What a particle shows of itself to kept pairs, besides position and mass: the velocity, A_zz, and the other entries of
   A row major. */
enum { TM_KEPT_V = 0, TM_KEPT_A = 4, TM_KEPT = 12 };
TM_FN int tm_kept_column(int c) { return c == 8 ? TM_KEPT_A - 1 : TM_KEPT_A + c; }

enum { TM_NEAR_HOLD = 10 };

/* Memory of a particle. */
enum {
  TM_K_B = 0,          /* B at the next force point */
  TM_K_Q = 9,
  TM_K_G = 18,         /* G at the next force point */
  TM_K_PSTRAIN = 27,   /* plastic strain when it was searched last */
  TM_K_SEARCHED = 28,  /* to be searched in the coming step: 1 */
  TM_K_MARK = 29,      /* was searched in the last step: 1 */
  TM_K_SEARCHES = 30,  /* how often */
  TM_K_NEAR = 31,      /* above 0: something came near, slid or went; for how long to go on searching */
  TM_K_MIXED = 32,     /* 1: a_i and a_j of a pair of the row differ */
  TM_K_SUM = 33,       /* sum over the row of m_j a_i, in units of its weights */
  TM_K = 36
};

/* Is the particle with memory k searched in this step? New ones are. */
TM_FN int tm_is_searched(const tm_real *k) { return k[TM_K_SEARCHED] > 0.5 || k[TM_K_SEARCHES] < 0.5; }

typedef struct {
  tm_kept_rows rows;
  tm_records rec;
  const tm_real *shown;        /* TM_KEPT, owned and ghost */
  tm_real *memory;             /* TM_K, owned; B and G go on to the next force point */
  tm_real dt;                  /* to that */
  tm_real h, slope_norm;       /* as in tm_rates_args */
  const tm_real *correction;   /* K, 9 in rows: see tm_kept_moment.h. NULL: 1 */
  tm_real force_unit;
  int force_begins;            /* as in tm_rates_args */
  /* results; added to those of the pairs searched in this step */
  double *force;
  tm_real *gradient;           /* L, 9 in rows of tm_layout.h */
  tm_real *heat, *artificial;
} tm_kept_args;

TM_FN tm_mat3 tm_mat_transposed(tm_mat3 a)
{
  tm_real t = a.xy; a.xy = a.yx; a.yx = t;
  t = a.xz; a.xz = a.zx; a.zx = t;
  t = a.yz; a.yz = a.zy; a.zy = t;
  return a;
}

TM_FN tm_mat3 tm_mat_add(tm_mat3 a, tm_mat3 b)
{
  a.xx += b.xx; a.xy += b.xy; a.xz += b.xz;
  a.yx += b.yx; a.yy += b.yy; a.yz += b.yz;
  a.zx += b.zx; a.zy += b.zy; a.zz += b.zz;
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
  *good = det * det > 0.0025 * all * all * all;
  if (!*good) return b;
  const tm_real per = 1.0 / det;
  b.xx = cxx * per; b.yx = cyx * per; b.zx = czx * per;
  b.xy = (a.xz * a.zy - a.xy * a.zz) * per;
  b.yy = (a.xx * a.zz - a.xz * a.zx) * per;
  b.zy = (a.xy * a.zx - a.xx * a.zy) * per;
  b.xz = (a.xy * a.yz - a.xz * a.yy) * per;
  b.yz = (a.xz * a.yx - a.xx * a.yz) * per;
  b.zz = (a.xx * a.yy - a.xy * a.yx) * per;
  return b;
}

/* Weights of TM_LANES entries of a row: whole numbers, and upper halves of floats. */
#if TM_VECTOR
typedef short tm_shorts __attribute__((vector_size(2 * TM_LANES)));
typedef short tm_shorts_mem __attribute__((vector_size(2 * TM_LANES), aligned(2), may_alias));
TM_FN tm_lanes_ints tm_weight_int_lanes(const short *w, ptrdiff_t stride)
{
  short TM_ALIGNED t[TM_LANES];
  for (int l = 0; stride != 1 && l < TM_LANES; l++) t[l] = w[l * stride];
  const tm_shorts v = *(const tm_shorts_mem *) (stride != 1 ? t : w);
#if TM_VECTOR == 64 && !defined(__clang__)
  return __builtin_ia32_pmovsxwd256(v);
#else
  return __builtin_convertvector(v, tm_lanes_ints);
#endif
}
TM_FN tm_lanes tm_weight_lanes(const short *w, ptrdiff_t stride)
{
  return tm_lanes_of_ints(tm_weight_int_lanes(w, stride));
}
TM_FN tm_lanes tm_weight_upper_lanes(const short *w, ptrdiff_t stride)
{
  return tm_lanes_of_floats((tm_lanes_floats) (tm_weight_int_lanes(w, stride) << 16));
}
#else
TM_FN tm_lanes tm_weight_lanes(const short *w, ptrdiff_t stride)
{
  (void) stride;
  return *w;
}
TM_FN tm_lanes tm_weight_upper_lanes(const short *w, ptrdiff_t stride)
{
  (void) stride;
  return tm_weight_float((unsigned) (unsigned short) *w << 16);
}
#endif

/* G of a row as it is now; S: TM_K_SUM of it. */
TM_FN tm_mat3 tm_kept_stretch(int i, const tm_kept_rows *r, const tm_records *rec, tm_real slope_norm, int dim3,
                              tm_real *S)
{
  const tm_real *ri = tm_main_record(rec, i);
  const tm_real xi = ri[tm_part(0)], yi = ri[tm_part(1)], zi = ri[tm_part(2)];
  const int *row = r->index + r->first[i];
  const short *w = tm_weight(r, i);
  tm_sum sum[12];
  for (int c = 0; c < 12; c++) sum[c] = tm_lanes_zero();
  int jj[TM_COLUMN];
  tm_pair TM_ALIGNED col[4][TM_COLUMN];
  for (int k = 0; k < r->kept[i]; k += TM_LANES) {    /* filled up with weights of 0 */
    for (int l = 0; l < TM_LANES; l++) jj[tm_at(l)] = row[(k + l) * r->stride];
    if (TM_COLUMN > 1) tm_transpose_rows(rec->main, TM_REC, jj, TM_LANES, 4, col[0]);
    else tm_fetch(tm_main_record(rec, jj[0]), 4, col[0]);
    const tm_lanes m = tm_lanes_load(col[TM_REC_M]);
    const tm_lanes d[3] = {tm_lanes_load(col[0]) - xi, tm_lanes_load(col[1]) - yi, tm_lanes_load(col[2]) - zi};
    for (int c = 0; c < (dim3 ? 3 : 2); c++) {
      const tm_lanes mw = m * tm_weight_lanes(w + tm_weight_place(r, TM_W_OWN + c, k), r->stride);
      for (int e = 0; e < (dim3 ? 3 : 2); e++) sum[3 * e + c] += d[e] * mw;
      sum[9 + c] += mw;
    }
  }
  tm_real G[12];
  tm_lanes_sums(sum, 12, G);
  for (int c = 0; c < 3; c++) S[c] = G[9 + c];
  return tm_mat_scale(slope_norm * r->unit, tm_mat_load(G));
}

/* A symmetric tensor from columns c on of a record. */
TM_FN tm_sym3 tm_kept_sym(const tm_real *r, int c)
{
  return tm_sym(r[tm_part(c)], r[tm_part(c + 1)], r[tm_part(c + 2)], r[tm_part(c + 3)], r[tm_part(c + 4)],
                r[tm_part(c + 5)]);
}

/* What particle i shows, from its record. */
TM_FN void tm_kept_show(int i, const tm_kept_args *a, tm_real *shown)
{
  const tm_real *r = tm_main_record(&a->rec, i), rho = r[tm_part(TM_REC_RHO)];
  const tm_sym3 P = tm_kept_sym(r, TM_REC_P);
  tm_mat3 map = tm_mat_load(a->memory + (ptrdiff_t) i * TM_K + TM_K_B);
  if (a->correction) map = tm_mat_mul(tm_mat_transposed(tm_mat_load(a->correction + (ptrdiff_t) i * 9)), map);
  tm_real B[9], *out = shown + (ptrdiff_t) i * TM_KEPT;
  tm_mat_store(B, map);
  for (int c = 0; c < 3; c++) {
    const tm_vec3 p = tm_sym_mul_vec(P, tm_vec(B[c], B[3 + c], B[6 + c]));
    out[tm_kept_column(c)] = rho * p.x;
    out[tm_kept_column(3 + c)] = rho * p.y;
    out[tm_kept_column(6 + c)] = rho * p.z;
    out[TM_KEPT_V + c] = r[tm_part(TM_REC_V + c)];
  }
}

/* B of the next force point, from G there; with too few neighbours to tell it follows L. */
TM_FN void tm_kept_turn(tm_real *memory, tm_mat3 L, tm_real dt, int dim3)
{
  int good;
  tm_mat3 B = tm_mat_load(memory + TM_K_B);
  const tm_mat3 inverse = tm_mat_inverse(tm_mat_load(memory + TM_K_G), dim3, &good);
  if (good) B = tm_mat_mul(tm_mat_transposed(inverse), tm_mat_load(memory + TM_K_Q));
  else {
    tm_mat3 step = tm_mat_scale(dt, L);
    step.xx += 1.0; step.yy += 1.0; step.zz += 1.0;
    const tm_mat3 back = tm_mat_inverse(step, dim3, &good);
    if (good) B = tm_mat_mul(tm_mat_transposed(back), B);
  }
  if (!dim3) B.xz = B.yz = B.zx = B.zy = 0.0;
  tm_mat_store(memory + TM_K_B, B);
}

/* Columns of a chunk. */
enum {
  TM_KCOL_SHOWN = 4,
  TM_KCOL_RHO = TM_KCOL_SHOWN + TM_KEPT,    /* with heat conduction; the one before it is not needed */
  TM_KCOL_HEAT = TM_KCOL_RHO + 2,
  TM_KCOL_CONDUCTED = TM_KCOL_HEAT + TM_REC_HEAT,
  TM_KCOLS
};

/* W'/r of entry k for conduction, in units of slope_norm/h. */
TM_FN tm_real tm_weight_slope(const tm_kept_rows *r, const short *w, int k)
{
  const unsigned upper = (unsigned short) w[tm_weight_place(r, TM_W_SLOPE, k)];
  return tm_weight_float(upper << 16 | (unsigned short) w[tm_weight_place(r, TM_W_SLOPE + 1, k)]);
}

/* Three weights that follow each other, for TM_LANES entries. */
TM_FN tm_lanes_vec tm_weight_vec(const short *w, ptrdiff_t stride)
{
  const tm_lanes_vec v = {tm_weight_lanes(w, stride), tm_weight_lanes(w + 8 * stride, stride),
                          tm_weight_lanes(w + 16 * stride, stride)};
  return v;
}

/* Sums over the pairs of a row, in units of the weights; their order is that of tm_kept_results(). */
typedef struct {
  tm_sum_mat gradient;
  tm_sum_vec force, artificial_force;
  tm_sum artificial, heat;
} tm_kept_sums;

/* Columns of the neighbors jj, as many as `lanes`. */
TM_FN void tm_kept_fetch(const tm_kept_args *a, const int *jj, int lanes, int conduction, tm_values *col)
{
  tm_fetch_records(a->rec.main, TM_REC, 0, TM_KCOL_SHOWN, jj, lanes, col[0]);
  if (conduction) tm_fetch_records(a->rec.main, TM_REC, TM_REC_RHO - 1, 2, jj, lanes, col[TM_KCOL_RHO]);
  tm_fetch_rows(a->shown, TM_KEPT, jj, lanes, col[TM_KCOL_SHOWN]);
  if (conduction) tm_fetch_records(a->rec.heat, TM_REC_HEAT, 0, TM_REC_HEAT, jj, lanes, col[TM_KCOL_HEAT]);
}

/* Sums of particle i into the results: L = gradient B^T, times K of tm_kept_moment.h; the force F15 (4) of its own A,
   whose sum over a_i is stored, and of its neighbors' A. B and G go on to the next force point. */
TM_FN void tm_kept_results(int i, const tm_kept_args *a, const tm_kept_sums *s, int viscosity, int conduction, int dim3)
{
  const int add = a->rows.fresh[i] > 0;
  const tm_real w = a->slope_norm * a->rows.unit, mi = tm_main_record(&a->rec, i)[tm_part(TM_REC_M)];
  tm_real *memory = a->memory + (ptrdiff_t) i * TM_K, *B = memory + TM_K_B, *G = memory + TM_K_G;
  const tm_real *S = memory + TM_K_SUM, *shown = a->shown + (ptrdiff_t) i * TM_KEPT;
  tm_real A[9], l[16];
  for (int c = 0; c < 9; c++) A[c] = shown[tm_kept_column(c)];
  const tm_sum_mat *g = &s->gradient;
  const tm_sum all[16] = {g->xx, g->xy, g->xz, g->yx, g->yy, g->yz, g->zx, g->zy, g->zz,
                          s->force.x, s->force.y, s->force.z, s->artificial_force.x, s->artificial_force.y,
                          s->artificial_force.z, s->artificial};
  const tm_real *other_force = l + 9, *artificial_force = l + 12;
  tm_lanes_sums(all, 16, l);
  tm_real *L = a->gradient + tm_row(i, 9);
  for (int r = 0; r < 3; r++) {
    for (int c = 0; c < 3; c++)
      L[tm_column(3 * r + c)] = (add ? L[tm_column(3 * r + c)] : 0.0)
                   + w * (l[3 * r] * B[3 * c] + l[3 * r + 1] * B[3 * c + 1] + l[3 * r + 2] * B[3 * c + 2]);
    if (!a->correction) continue;
    const tm_real *K = a->correction + (ptrdiff_t) i * 9;
    const tm_real x = L[tm_column(3 * r)], y = L[tm_column(3 * r + 1)], z = L[tm_column(3 * r + 2)];
    for (int c = 0; c < 3; c++) L[tm_column(3 * r + c)] = x * K[c] + y * K[3 + c] + z * K[6 + c];
  }
  const tm_real mf = mi * a->force_unit;
  double *f = a->force + 3 * (ptrdiff_t) i;
  if (a->force_begins && !add) f[0] = f[1] = f[2] = 0.0;
  for (int c = 0; c < 3; c++)
    f[c] += mf * (w * (A[3 * c] * S[0] + A[3 * c + 1] * S[1] + A[3 * c + 2] * S[2] + other_force[c])
                  + artificial_force[c]);
  if (viscosity && a->artificial)
    a->artificial[i] = (add ? a->artificial[i] : 0.0) + 0.5 * mi * l[15];
  if (conduction) a->heat[i] = (add ? a->heat[i] : 0.0) + tm_lanes_sum(s->heat);
  for (int c = 0; c < 9; c++) G[c] += a->dt * w * l[c];
  tm_kept_turn(memory, tm_mat_from_row(L), a->dt, dim3);
}

/* Rates of particle i from its kept pairs; effects: TM_FX_3D, VISCOSITY, CONDUCTION. */
TM_FN void tm_kept_rates(int i, const tm_kept_args *a, unsigned effects)
{
  const int dim3 = (effects & TM_FX_3D) != 0, viscosity = (effects & TM_FX_VISCOSITY) != 0;
  const int conduction = (effects & TM_FX_CONDUCTION) != 0, n_row = a->rows.kept[i];
  const ptrdiff_t stride = TM_VECTOR >= 32 ? 1 : a->rows.stride;    /* no GPU */
  const int *row = a->rows.index + a->rows.first[i];
  const short *weight = tm_weight(&a->rows, i);
  const tm_real *memory = a->memory + (ptrdiff_t) i * TM_K;
  const int mixed = memory[TM_K_MIXED] > 0.5;
#if TM_VECTOR
  const int ahead = stride == 1 && a->rows.kept[i + 1] ? (memory[TM_K + TM_K_MIXED] > 0.5 ? 2 : 1) : 0;
#endif

  const tm_real *ri = tm_main_record(&a->rec, i);
  const tm_real x[3] = {ri[tm_part(0)], ri[tm_part(1)], ri[tm_part(2)]};
  const tm_real vi[3] = {ri[tm_part(4)], ri[tm_part(5)], ri[tm_part(6)]};
  const tm_real ti = conduction ? tm_heat_record(&a->rec, i)[tm_part(TM_REC_T)] : 0.0;
  const tm_real ki = conduction ? tm_heat_record(&a->rec, i)[tm_part(TM_REC_K)] : 0.0;
  /* units of the frozen W'/r, and of the factors of tm_viscosity_factors() */
  const tm_real per_r = a->slope_norm / a->h, bulk = per_r / a->h, shock = bulk / a->h;
  tm_kept_sums s;
  s.gradient = tm_sum_mat_zero();
  s.force = s.artificial_force = tm_sum_vec_zero();
  s.artificial = s.heat = tm_lanes_zero();

  int some[TM_COLUMN];
  tm_pair TM_ALIGNED col[TM_KCOLS][TM_COLUMN];
  for (int k = 0; k < n_row; k += TM_CHUNK) {
    const int n = n_row - k < TM_CHUNK ? n_row - k : TM_CHUNK;
    const int lanes = TM_COLUMN == 1 ? 1 : (n + TM_LANES - 1) / TM_LANES * TM_LANES;
    const int *entry = row + k * stride, *jj = entry;
    if (stride != 1) {
      for (int l = 0; l < lanes; l++) some[tm_at(l)] = entry[l * stride];
      jj = some;
    }
    tm_kept_fetch(a, jj, lanes, conduction, col);
    if (conduction)    /* F15 (6) */
      for (int l = 0; l < lanes; l++) {
        const int m = tm_at(l);
        col[TM_KCOL_CONDUCTED][m] =
            tm_conduction_pair(ki, col[TM_KCOL_HEAT + TM_REC_K][m], ti, col[TM_KCOL_HEAT + TM_REC_T][m],
                               col[TM_REC_M][m] / col[TM_KCOL_RHO + 1][m],
                               per_r * tm_weight_slope(&a->rows, weight, k + l));
      }

    for (int l = 0; l < lanes; l += TM_LANES) {
      /* those of the first entry; others of the eight follow, then the next weight: tm_weight_place() */
      const int at = (k + l) / 8 * 8, in = (k + l) % 8;
      const short *own = weight + ((ptrdiff_t) at * TM_W_OTHER + in) * stride;
      const short *other = weight +
          ((ptrdiff_t) TM_W_OTHER * a->rows.capacity + (ptrdiff_t) at * (TM_W_SLOPE - TM_W_OTHER) + in) * stride;
#if TM_VECTOR
      /* the next row lies far away, and memory is slow: it is asked for in good time, a part at a time */
      if (ahead && l % 8 == 0) {
        const short *w = own + a->rows.capacity * TM_WEIGHTS;
        __builtin_prefetch(w);
        __builtin_prefetch(w + 32);
        if (l % 16 == 0) __builtin_prefetch(row + a->rows.capacity + k + l);
        if (ahead > 1) __builtin_prefetch(other + a->rows.capacity * TM_WEIGHTS);
      }
#endif
      const tm_lanes m = tm_values_load(col[TM_REC_M], l);
      const tm_lanes_vec d = tm_pair_difference(x, col, l, dim3);                                 /* x_i - x_j */
      const tm_lanes_vec v = tm_pair_difference(vi, col + TM_KCOL_SHOWN + TM_KEPT_V, l, dim3);    /* v_i - v_j */
      const tm_lanes_vec ai = tm_lanes_scale(m, tm_weight_vec(own, stride));                      /* m_j a_i */
      const tm_lanes_vec aj = mixed ? tm_lanes_scale(m, tm_weight_vec(other, stride)) : ai;       /* m_j a_j */
#define TM_A(c) tm_values_load(col[TM_KCOL_SHOWN + tm_kept_column(c)], l)
      const tm_lanes_mat A = {TM_A(0), TM_A(1), TM_A(2), TM_A(3), TM_A(4), TM_A(5), TM_A(6), TM_A(7), TM_A(8)};
#undef TM_A
      tm_pair_gradient(&s.gradient, v, ai, dim3);     /* sum of m_j (v_j - v_i) (x) a_i */
      tm_pair_momentum(&s.force, A, aj, dim3);        /* F15 (4): sum of m_j A_j a_j */
      if (viscosity) {                                /* F14 (15) */
        const tm_lanes pi = tm_pair_viscosity_frozen(m, tm_lanes_dot(v, d, dim3), shock,
                                                     tm_weight_upper_lanes(own + TM_W_SHOCK * 8 * stride, stride), bulk,
                                                     tm_weight_upper_lanes(own + TM_W_BULK * 8 * stride, stride));
        const tm_lanes_vec artificial = {-pi * d.x, -pi * d.y, -pi * d.z};
        tm_pair_artificial(&s.artificial_force, &s.artificial, artificial, v);
      }
      if (conduction) s.heat += tm_values_load(col[TM_KCOL_CONDUCTED], l);
    }
  }
  tm_kept_results(i, a, &s, viscosity, conduction, dim3);
}

#endif
