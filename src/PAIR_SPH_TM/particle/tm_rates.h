/* SPH-TM: all rates of one particle in one pass over its neighbours.

   velocity gradient   L_i  = 1/rho_i  sum_j m_j (v_j - v_i) (x) gradW        conjugate of F15 (4)
                       L_i  = sum_j m_j/rho_j (v_j - v_i) (x) gradW           conjugate of F14 (6)
   density             drho_i/dt = -rho_i tr L_i                              F15 (2), F14 (4)
   acceleration        a_i = sum_j m_j (P_i + P_j + f^n (R_i + R_j) - Pi I) gradW   F15 (4), F14 (15)
   heat                rho c_p dT_i/dt = sum_j m_j/rho_j 4 k_i k_j/(k_i + k_j) (T_i - T_j) W'/r
                                                                              F15 (6)
   XSPH                dx_i = eps sum_j m_j/rho_mean (v_j - v_i) W
   surface             n_i = sum_j m_j/rho_j gradW; area of the surface = 2 V_i |n_i|

   With gradient correction (F15 form only) gradW is gradW K_i in L and in the term of P_i, and
   gradW K_j in that of P_j; K comes from tm_moment.h.

   Each velocity gradient is the work conjugate of its momentum form: the power of the pair forces
   equals minus sum V sigma:L minus the artificial heating, to round-off.

   The row is walked in chunks. Neighbours within reach are compacted in row order and their
   records transposed into columns (tm_lanes.h); a loop over columns makes the coefficients of each
   pair; a second one, without a branch or a function call, sums. Neighbour number n of those within
   reach always goes to lane n mod TM_LANES, and rows are sorted by tag: so the sum does not depend
   on where a particle sits in memory, on the skin, the size of a chunk or the number of ranks. On a
   GPU a chunk is one entry of the row, and one out of reach is passed over: so the threads of a warp,
   whose particles are side by side, stay at the same entry and fetch records that are side by side.

   In a file that defines TM_PAIR_SINGLE pairs are computed in single (tm_single.h). What a pair gives
   one particle is then opposite to what it gives the other to the last bit: weights are symmetric in
   both, and the particle's own share is divided out of the sum. */
#ifndef TM_RATES_H
#define TM_RATES_H

#include "tm_artificial.h"
#include "tm_heat.h"
#include "tm_kernel.h"
#include "tm_record.h"
#include "tm_size.h"
#include "tm_tensor.h"
#include "tm_transpose.h"

/* Neighbour rows: entry k of particle i is index[first[i] + k * stride]. Mechanical neighbours
   come first, then those that only exchange heat, then those of other bodies in contact. */
typedef struct {
  const int *index;
  const ptrdiff_t *first;
  const int *mechanical;   /* number of mechanical neighbours */
  const int *thermal;      /* number of neighbours that only exchange heat */
  const int *contact;      /* number of neighbours of other bodies */
  ptrdiff_t stride;
} tm_rows;

typedef struct {
  tm_rows rows;
  tm_records rec;
  tm_records_single single;
  unsigned effects;        /* run-time bits for the extended instantiation */

  tm_real h;               /* smoothing length */
  tm_real reach2;          /* (support * h)^2 */
  tm_real norm;            /* kernel constant, 1/h^dim included */
  tm_real slope_norm;      /* of its slope: norm/h over the lattice's gradient, see tm_lattice.h */
  tm_real support2, norm_of_one;   /* of h = 1, for particles with an h of their own */
  tm_real visc_alpha, visc_beta;
  int art_n;               /* exponent of the artificial stress */
  tm_real art_inv_w;       /* 1 / shape(dp/h) */
  tm_real xsph;            /* XSPH epsilon, 0..1 */
  tm_real force_unit;      /* mass times acceleration -> force of the unit style */
  const tm_real *conductance;  /* interface conductance per type pair (0: bonded), or NULL */
  const int *which;        /* the particles, or NULL: all */
  const int *type;         /* LAMMPS types, owned and ghost; only with conductance */
  int ntypes;

  /* results, rows of owned particles; added to where said so */
  double *force;           /* 3, added to what is there unless force_begins */
  int force_begins;
  tm_real *gradient;       /* 9, L row major, in rows of tm_layout.h */
  tm_real *heat;           /* conduction, power per volume, or NULL */
  tm_real *correction;     /* 6, K of tm_moment.h, with correction; read by the rate pass */
  tm_real *xsph_v;         /* 3, with XSPH */
  tm_real *hourglass_rate; /* 3, with the hourglass resistance: tm_hourglass.h */
  tm_real *surface;        /* 3, with surface */
  tm_real *artificial;     /* heating by artificial terms, power, or NULL */
} tm_rates_args;

/* Columns of a chunk: first the records, then what the pair functions make of them. */
enum {
  TM_COL_STRESS = TM_REC,
  TM_COL_HEAT = TM_COL_STRESS + TM_REC_STRESS,
  TM_COL_CORRECTION = TM_COL_HEAT + TM_REC_HEAT,
  TM_COL_SIZE = TM_COL_CORRECTION + TM_REC_CORRECTION,
  TM_COL_SLOPE = TM_COL_SIZE + TM_REC_SIZE, /* m_j W'/r */
  TM_COL_TENSILE,      /* f^n of the artificial stress */
  TM_COL_VISCOUS,      /* Pi */
  TM_COL_CONDUCTED,    /* power per volume into i */
  TM_COL_PER_RHO,      /* 1/rho_j */
  TM_COL_SMOOTH,       /* m_j/rho_mean W */
  TM_COLUMNS
};

/* Appends to jj, n long, the neighbours within reach from entry *k of a row on, until the row ends
   or jj is TM_CHUNK long; returns the new n. Room behind may be overwritten. unit: of positions in
   single. With size, the records of size of all particles, distances are over the pair's h; inv_h is
   the particle's own 1/h.

   On a GPU only entry *k is looked at, which jj[1] holds already, and position receives the first
   columns of its record (in single x_i minus the position); the next entry is fetched meanwhile. */
TM_FN int tm_within_reach(const tm_pair *rec, const tm_pair *size, tm_pair inv_h, const int *row,
                          ptrdiff_t stride, int *k, int end, tm_coord x, tm_coord y, tm_coord z, tm_pair unit,
                          tm_pair reach2, int dim3, int *jj, int n, tm_pair *position)
{
  (void) position;
#if TM_COLUMN == 1
  (void) n;
  jj[0] = jj[1];
  jj[1] = row[(*k + 1 < end ? *k + 1 : *k) * stride];
  tm_fetch(rec + tm_pair_record(jj[0], TM_REC), 4, position);
  const tm_pair dx = tm_apart(x, tm_coord_load(position), unit), dy = tm_apart(y, tm_coord_load(position + 1), unit);
  const tm_pair dz = dim3 ? tm_apart(z, tm_coord_load(position + 2), unit) : 0;
  const tm_pair r2 = dx * dx + dy * dy + dz * dz;
  n = (size ? r2 * (inv_h * size[(ptrdiff_t) jj[0] * TM_REC_SIZE + TM_SIZE_INV_H]) : r2) < reach2;
  if (TM_SINGLE) {
    position[0] = dx; position[1] = dy; position[2] = dz;
  }
#elif TM_VECTOR >= 32
  int block[TM_LANES];
  tm_pair TM_ALIGNED col[4][TM_COLUMN];
  const tm_lanes zero = {0};
  for (; *k < end && n < TM_CHUNK; *k += TM_LANES) {
    const int *r = row + *k, left = end - *k;
    if (left < TM_LANES || stride != 1) {
      for (int l = 0; l < TM_LANES; l++) block[l] = row[(l < left ? *k + l : *k) * stride];
      r = block;
    }
    tm_transpose(rec, TM_REC, r, dim3 || TM_SINGLE ? 4 : 2, col[0]);
    const tm_lanes dx = tm_lanes_apart(x, col[0], unit), dy = tm_lanes_apart(y, col[1], unit);
    const tm_lanes dz = dim3 ? tm_lanes_apart(z, col[2], unit) : zero;
    tm_lanes r2 = dx * dx + dy * dy + dz * dz;
    if (size) {
      tm_transpose(size, TM_REC_SIZE, r, TM_SINGLE ? 4 : 2, col[0]);
      r2 *= inv_h * tm_lanes_load(col[TM_SIZE_INV_H]);
    }
    const unsigned inside = tm_lanes_below(r2, reach2, (1u << (left < TM_LANES ? left : TM_LANES)) - 1u);
    n += tm_compress(r, inside, jj + n);
  }
#else
  for (; *k < end && n < TM_CHUNK; ++*k) {
    const int j = row[*k * stride];
    const tm_pair *r = rec + (ptrdiff_t) j * TM_REC;
    const tm_pair dx = tm_apart(x, tm_coord_load(r), unit), dy = tm_apart(y, tm_coord_load(r + 1), unit);
    const tm_pair dz = dim3 ? tm_apart(z, tm_coord_load(r + 2), unit) : 0;
    jj[tm_at(n)] = j;
    const tm_pair r2 = dx * dx + dy * dy + dz * dz;
    n += (size ? r2 * (inv_h * size[(ptrdiff_t) j * TM_REC_SIZE + TM_SIZE_INV_H]) : r2) < reach2;
  }
#endif
  return n;
}

TM_FN void tm_rates(int i, const tm_rates_args *a, unsigned effects)
{
  const int kernel = tm_fx_kernel(effects);
  const unsigned fx = TM_FX_PRESENT &
      ((effects & TM_FX_EXTENDED) ? (effects & (TM_FX_3D | TM_FX_KERNEL_MASK)) | a->effects : effects);
  const int dim3 = (effects & TM_FX_3D) != 0;
  const int viscosity = (fx & TM_FX_VISCOSITY) != 0, artstress = (fx & TM_FX_ARTSTRESS) != 0;
  const int conduction = (fx & TM_FX_CONDUCTION) != 0, form_f14 = (fx & TM_FX_FORM_F14) != 0;
  const int correction = (fx & TM_FX_CORRECTION) != 0, balsara = (fx & TM_FX_BALSARA) != 0;
  const int xsph = (fx & TM_FX_XSPH) != 0, surface = (fx & TM_FX_SURFACE) != 0;
  const int per_rho = form_f14 || surface, sizes = (fx & TM_FX_SMOOTHING) != 0;

  const int *row = a->rows.index + a->rows.first[i];
  const int n_mech = a->rows.mechanical[i];
#if TM_SINGLE
  const float *TM_RESTRICT rec = a->single.main;
  const float *TM_RESTRICT rec_s = a->single.more;
  const float *TM_RESTRICT rec_t = rec_s ? rec_s + tm_pair_part(TM_MORE_HEAT) : NULL;
  const float *TM_RESTRICT rec_c = a->single.correction;
  const float *TM_RESTRICT rec_z = sizes ? a->single.size : NULL;
  const int stride_s = TM_MORE, stride_t = TM_MORE;
  const tm_real length = a->single.length, volume = a->single.volume;
  const tm_pair unit = (tm_pair) a->single.position;
#else
  const tm_real *TM_RESTRICT rec = a->rec.main;
  const tm_real *TM_RESTRICT rec_s = a->rec.stress;
  const tm_real *TM_RESTRICT rec_t = a->rec.heat;
  const tm_real *TM_RESTRICT rec_c = a->rec.correction;
  const tm_real *TM_RESTRICT rec_z = sizes ? a->rec.size : NULL;
  const int stride_s = TM_REC_STRESS, stride_t = TM_REC_HEAT;
  const tm_real length = 1.0, volume = 1.0, unit = 1.0;
#endif

  tm_pair ri[TM_REC];
  tm_fetch(rec + tm_pair_record(i, TM_REC), TM_REC, ri);
  const tm_coord xi = tm_coord_load(ri), yi = tm_coord_load(ri + 1), zi = tm_coord_load(ri + 2);
  const tm_pair mi = ri[TM_REC_M];
  const tm_pair vxi = ri[4], vyi = ri[5], vzi = ri[6], rhoi = ri[TM_REC_RHO];
  const tm_pair pxx = ri[8], pyy = ri[9], pzz = ri[10], pxy = ri[11], pxz = ri[12], pyz = ri[13];
  const tm_pair ci = ri[TM_REC_C], bi = ri[TM_REC_BALSARA];
  const tm_pair inv_rhoi = 1 / rhoi;
  /* the particle's own mass and volume, where weights are symmetric */
  const tm_pair own_mass = TM_SINGLE ? mi : 1, own_volume = TM_SINGLE ? mi / rhoi : 1;
  tm_pair qxx = 0, qyy = 0, qzz = 0, qxy = 0, qxz = 0, qyz = 0, ti = 0, ki = 0;
  tm_pair cxx = 0, cxy = 0, cxz = 0, cyx = 0, cyy = 0, cyz = 0, czx = 0, czy = 0, czz = 0;
  if (artstress) {
    tm_pair q[TM_MORE];
    tm_fetch(rec_s + tm_pair_record(i, stride_s), stride_s, q);
    qxx = q[0]; qyy = q[1]; qzz = q[2]; qxy = q[3]; qxz = q[4]; qyz = q[5];
  }
  if (conduction) {
    ti = rec_t[tm_pair_record(i, stride_t) + TM_REC_T];
    ki = rec_t[tm_pair_record(i, stride_t) + TM_REC_K];
  }
  if (correction) {
    const tm_pair *c = rec_c + (ptrdiff_t) i * TM_REC_CORRECTION;
    cxx = c[0]; cxy = c[1]; cxz = c[2]; cyx = c[3]; cyy = c[4]; cyz = c[5];
    czx = c[6]; czy = c[7]; czz = c[8];
  }

  const tm_pair h = (tm_pair) (a->h / length);
  const tm_pair reach2 = (tm_pair) (sizes ? a->support2 : a->reach2 / (length * length));
  const tm_pair alpha = (tm_pair) a->visc_alpha, beta = (tm_pair) a->visc_beta;
  const tm_pair_size of_all = {h, 1 / h, (tm_pair) (a->norm * volume), (tm_pair) (a->slope_norm * (volume * length)),
                               (tm_pair) a->art_inv_w};
  const tm_pair_size own = tm_own_size(sizes ? rec_z + (ptrdiff_t) i * TM_REC_SIZE : NULL, of_all);
  const tm_pair norm_of_one = (tm_pair) a->norm_of_one, far = 4 * own.h;
  const int art_n = a->art_n;

  const tm_lanes zero = {0};
  const tm_sum none = tm_lanes_zero();
  tm_sum ax = none, ay = none, az = none, heat = none, art = none;
  tm_sum lxx = none, lxy = none, lxz = none, lyx = none, lyy = none, lyz = none;
  tm_sum lzx = none, lzy = none, lzz = none;
  tm_sum ux = none, uy = none, uz = none, nx = none, ny = none, nz = none;

  int jj[TM_COLUMN + TM_LANES];
  jj[0] = i;
  if (TM_COLUMN == 1) jj[1] = n_mech > 0 ? row[0] : i;
  tm_pair TM_ALIGNED col[TM_COLUMNS][TM_COLUMN];
  for (int k = 0, n = 0; TM_COLUMN > 1 || k < n_mech; k += TM_COLUMN == 1) {
    n = tm_within_reach(rec, rec_z, own.inv_h, row, a->rows.stride, &k, n_mech, xi, yi, zi, unit, reach2,
                        dim3, jj, n, col[TM_REC_X]);
    if (TM_COLUMN == 1 && n == 0) continue;
    if (n == 0) break;

    /* lanes left over wait for the next chunk, or are filled up with copies of i out of reach */
    const int last = TM_COLUMN > 1 && k >= n_mech;
    const int lanes =
        TM_COLUMN == 1 ? 1 : (last ? n + TM_LANES - 1 : n) / TM_LANES * TM_LANES;
    if (TM_COLUMN > 1) {
      for (int l = n; l < lanes; l++) jj[tm_at(l)] = i;
      tm_transpose_rows(rec, TM_REC, jj, lanes, TM_REC, col[0]);
#if TM_SINGLE
      for (int l = 0; l < lanes; l += TM_LANES) {
        tm_lanes_store(col[0] + tm_at(l), tm_lanes_apart(xi, col[0] + tm_at(l), unit));
        tm_lanes_store(col[1] + tm_at(l), tm_lanes_apart(yi, col[1] + tm_at(l), unit));
        if (dim3) tm_lanes_store(col[2] + tm_at(l), tm_lanes_apart(zi, col[2] + tm_at(l), unit));
      }
      for (int l = n; l < lanes; l++) col[TM_REC_X][tm_at(l)] = far;
      if (artstress) tm_transpose_rows(rec_s, TM_MORE, jj, lanes, TM_MORE, col[TM_COL_STRESS]);
      else if (conduction) tm_transpose_rows(rec_s + 4, TM_MORE, jj, lanes, 4, col[TM_COL_STRESS + 4]);
#else
      for (int l = n; l < lanes; l++) col[TM_REC_X][tm_at(l)] = xi + far;
      if (artstress)
        tm_transpose_rows(rec_s, TM_REC_STRESS, jj, lanes, TM_REC_STRESS, col[TM_COL_STRESS]);
      if (conduction)
        tm_transpose_rows(rec_t, TM_REC_HEAT, jj, lanes, TM_REC_HEAT, col[TM_COL_HEAT]);
#endif
      if (sizes) tm_transpose_rows(rec_z, TM_REC_SIZE, jj, lanes, TM_REC_SIZE, col[TM_COL_SIZE]);
      if (correction)
        for (int l = 0; l < lanes; l++)
          for (int c = 0; c < TM_REC_CORRECTION; c++)
            col[TM_COL_CORRECTION + c][tm_at(l)] =
                rec_c[jj[tm_at(l)] * (ptrdiff_t) TM_REC_CORRECTION + c];
    } else {
      const int j = jj[0], all = TM_SINGLE || viscosity;
      tm_fetch(rec + tm_pair_record(j, TM_REC) + tm_pair_part(TM_REC_V),
               (all ? TM_REC : TM_REC_C) - TM_REC_V, col[TM_REC_V]);
      if (artstress) tm_fetch(rec_s + tm_pair_record(j, stride_s), stride_s, col[TM_COL_STRESS]);
#if TM_SINGLE
      else if (conduction)
        tm_fetch(rec_s + tm_pair_record(j, stride_s) + tm_pair_part(4), 4, col[TM_COL_STRESS + 4]);
#else
      if (conduction) tm_fetch(rec_t + tm_pair_record(j, stride_t), TM_REC_HEAT, col[TM_COL_HEAT]);
#endif
      for (int c = 0; sizes && c < TM_REC_SIZE; c++)
        col[TM_COL_SIZE + c][0] = rec_z[j * (ptrdiff_t) TM_REC_SIZE + c];
      if (correction)
        for (int c = 0; c < TM_REC_CORRECTION; c++)
          col[TM_COL_CORRECTION + c][0] = rec_c[j * (ptrdiff_t) TM_REC_CORRECTION + c];
    }
    /* entry l of a column; x_i minus column c, which in single is that difference already */
#define TM_MAIN(c) TM_COL(c)
#define TM_STRESS(c) TM_COL(TM_COL_STRESS + (c))
#define TM_HEAT(c) TM_COL(TM_COL_HEAT + (c))
#define TM_CORR(c) TM_COL(TM_COL_CORRECTION + (c))
#define TM_SIZE(c) TM_COL(TM_COL_SIZE + (c))
#define TM_COL(c) col[c][tm_at(l)]
#define TM_LOAD(entry) tm_lanes_load(&entry)
#if TM_SINGLE
#define TM_APART(x, c) TM_COL(TM_REC_X + (c))
#define TM_LANES_APART(x, c) TM_LOAD(TM_APART(x, c))
#else
#define TM_APART(x, c) ((x) - TM_COL(TM_REC_X + (c)))
#define TM_LANES_APART(x, c) ((x) - TM_LOAD(TM_COL(TM_REC_X + (c))))
#endif

    /* coefficients of each pair */
#if !defined(__CUDACC__)
#pragma omp simd
#endif
    for (int l = 0; l < lanes; l++) {
      const tm_pair dx = TM_APART(xi, 0), dy = TM_APART(yi, 1), dz = dim3 ? TM_APART(zi, 2) : 0;
      const tm_pair_size p = sizes ? tm_pair_of_sizes(&own, TM_SIZE(TM_SIZE_INV_H), TM_SIZE(TM_SIZE_FACTOR),
                                                      TM_SIZE(TM_SIZE_TENSILE), norm_of_one, dim3)
                                   : of_all;
      const tm_pair r2 = dx * dx + dy * dy + dz * dz, r = tm_pair_sqrt(r2), q = r * p.inv_h;
      const tm_pair mj = TM_MAIN(TM_REC_M), rhoj = TM_MAIN(TM_REC_RHO);
      tm_pair inv_r;
      if (viscosity) {
        const tm_pair vx = vxi - TM_MAIN(4), vy = vyi - TM_MAIN(5);
        const tm_pair vz = dim3 ? vzi - TM_MAIN(6) : 0;
        const tm_pair rho2 = rhoi + rhoj, soft2 = tm_viscosity_soft2(p.h, r2);
        const tm_pair inv = 1 / (r2 * (soft2 * rho2));  /* one division for three */
        inv_r = r * (soft2 * rho2) * inv;
        const tm_pair mu = tm_viscosity_mu(p.h, vx * dx + vy * dy + vz * dz, r2 * rho2 * inv);
        tm_pair pi = tm_viscosity_pi(alpha, beta, mu, TM_PAIR(0.5) * (ci + TM_MAIN(TM_REC_C)),
                                     2 * (r2 * soft2) * inv);
        if (balsara) pi *= TM_PAIR(0.5) * (bi + TM_MAIN(TM_REC_BALSARA));
        TM_COL(TM_COL_VISCOUS) = pi;
      } else
        inv_r = 1 / r;
      const tm_pair g = p.slope_norm * tm_kernel_slope(kernel, q) * inv_r;  /* W'/r */
      TM_COL(TM_COL_SLOPE) = mj * own_mass * g;
      if (artstress)
        TM_COL(TM_COL_TENSILE) = tm_power_int(tm_kernel_shape(kernel, q) * p.inv_w, art_n);
      if (conduction)
        TM_COL(TM_COL_CONDUCTED) = tm_conduction_pair(ki, TM_HEAT(TM_REC_K), ti, TM_HEAT(TM_REC_T),
                                                      mj / rhoj * own_volume, tm_conduction_slope(kernel, q, g));
      if (per_rho) TM_COL(TM_COL_PER_RHO) = 1 / rhoj;
      if (xsph)
        TM_COL(TM_COL_SMOOTH) =
            tm_xsph_pair(mj, TM_PAIR(0.5) * (rhoi + rhoj), p.norm * tm_kernel_shape(kernel, q));
    }

    /* sums */
    for (int l = 0; l < lanes; l += TM_LANES) {
      const tm_lanes dx = TM_LANES_APART(xi, 0), dy = TM_LANES_APART(yi, 1);
      const tm_lanes dz = dim3 ? TM_LANES_APART(zi, 2) : zero;
      const tm_lanes vx = vxi - TM_LOAD(TM_MAIN(4)), vy = vyi - TM_LOAD(TM_MAIN(5));
      const tm_lanes vz = dim3 ? vzi - TM_LOAD(TM_MAIN(6)) : zero;
      const tm_lanes mg = TM_LOAD(TM_COL(TM_COL_SLOPE)), wx = mg * dx, wy = mg * dy, wz = mg * dz;
      const tm_lanes vol = per_rho ? TM_LOAD(TM_COL(TM_COL_PER_RHO)) : zero;

      /* velocity gradient, sum of -v_ij (x) gradW; volume m/rho_j, or m to be divided by rho_i */
      const tm_lanes gx = form_f14 ? vol * wx : wx, gy = form_f14 ? vol * wy : wy;
      const tm_lanes gz = form_f14 ? vol * wz : wz;
      lxx -= vx * gx; lxy -= vx * gy;
      lyx -= vy * gx; lyy -= vy * gy;
      if (dim3) {
        lxz -= vx * gz; lyz -= vy * gz;
        lzx -= vz * gx; lzy -= vz * gy; lzz -= vz * gz;
      }

      /* momentum */
      const tm_lanes mx = form_f14 ? inv_rhoi * gx : wx, my = form_f14 ? inv_rhoi * gy : wy;
      const tm_lanes mz = form_f14 ? inv_rhoi * gz : wz;
      if (correction) {
        ax += (cxx + TM_LOAD(TM_CORR(0))) * mx + (cxy + TM_LOAD(TM_CORR(1))) * my;
        ay += (cyx + TM_LOAD(TM_CORR(3))) * mx + (cyy + TM_LOAD(TM_CORR(4))) * my;
        if (dim3) {
          ax += (cxz + TM_LOAD(TM_CORR(2))) * mz;
          ay += (cyz + TM_LOAD(TM_CORR(5))) * mz;
          az += (czx + TM_LOAD(TM_CORR(6))) * mx + (czy + TM_LOAD(TM_CORR(7))) * my
              + (czz + TM_LOAD(TM_CORR(8))) * mz;
        }
      } else {
        const int P = TM_REC_P;
        const tm_lanes sxx = pxx + TM_LOAD(TM_MAIN(P)), syy = pyy + TM_LOAD(TM_MAIN(P + 1));
        const tm_lanes sxy = pxy + TM_LOAD(TM_MAIN(P + 3));
        ax += sxx * mx + sxy * my;
        ay += sxy * mx + syy * my;
        if (dim3) {
          const tm_lanes szz = pzz + TM_LOAD(TM_MAIN(P + 2)), sxz = pxz + TM_LOAD(TM_MAIN(P + 4));
          const tm_lanes syz = pyz + TM_LOAD(TM_MAIN(P + 5));
          ax += sxz * mz;
          ay += syz * mz;
          az += sxz * mx + syz * my + szz * mz;
        }
      }

      /* artificial terms, kept apart for the energy book: d = artificial acceleration */
      tm_lanes dxa = zero, dya = zero, dza = zero;
      if (artstress) {
        const tm_lanes f = TM_LOAD(TM_COL(TM_COL_TENSILE));
        const tm_lanes sxx = qxx + TM_LOAD(TM_STRESS(0)), syy = qyy + TM_LOAD(TM_STRESS(1));
        const tm_lanes sxy = qxy + TM_LOAD(TM_STRESS(3));
        dxa = sxx * wx + sxy * wy;
        dya = sxy * wx + syy * wy;
        if (dim3) {
          const tm_lanes szz = qzz + TM_LOAD(TM_STRESS(2)), sxz = qxz + TM_LOAD(TM_STRESS(4));
          const tm_lanes syz = qyz + TM_LOAD(TM_STRESS(5));
          dxa += sxz * wz;
          dya += syz * wz;
          dza = sxz * wx + syz * wy + szz * wz;
        }
        dxa *= f; dya *= f; dza *= f;
      }
      if (viscosity) {
        const tm_lanes pi = TM_LOAD(TM_COL(TM_COL_VISCOUS));
        dxa -= pi * wx; dya -= pi * wy; dza -= pi * wz;
      }
      if (artstress || viscosity) {
        art -= dxa * vx + dya * vy + dza * vz;
        ax += dxa; ay += dya; az += dza;
      }

      if (conduction) heat += TM_LOAD(TM_COL(TM_COL_CONDUCTED));
      if (xsph) {
        const tm_lanes w = TM_LOAD(TM_COL(TM_COL_SMOOTH));
        ux -= w * vx; uy -= w * vy; uz -= w * vz;
      }
      if (surface) {
        nx += vol * wx; ny += vol * wy; nz += vol * wz;
      }
    }
#undef TM_MAIN
#undef TM_STRESS
#undef TM_HEAT
#undef TM_CORR
#undef TM_SIZE
#undef TM_COL
#undef TM_APART
#undef TM_LANES_APART
#undef TM_LOAD
    if (last) break;
    for (int l = lanes; l < n; l++) jj[tm_at(l - lanes)] = jj[tm_at(l)];
    n -= lanes;
  }

  const tm_real per_length = TM_SINGLE ? 1.0 / length : 1.0;
  const tm_real per_mass = TM_SINGLE ? per_length / mi : 1.0;
  const tm_real lscale = (form_f14 ? 1.0 : TM_SINGLE ? 1.0 / rhoi : inv_rhoi) * per_mass;
  const tm_sum all[16] = {lxx, lxy, lxz, lyx, lyy, lyz, lzx, lzy, lzz, ax, ay, az, art, heat, none, none};
  tm_real L[16];
  const tm_real *acceleration = L + 9;
  tm_lanes_sums(all, 16, L);
  for (int k = 0; k < 9; k++) L[k] *= lscale;
  if (correction) {
    const tm_sym3 K = tm_sym_load(a->correction + (ptrdiff_t) i * 6);
    for (int r = 0; r < 9; r += 3) {
      const tm_vec3 l = tm_sym_mul_vec(K, tm_vec(L[r], L[r + 1], L[r + 2]));
      L[r] = l.x; L[r + 1] = l.y; L[r + 2] = l.z;
    }
  }
  const tm_real per_force = TM_SINGLE ? volume * per_length : mi, mf = per_force * a->force_unit;
  tm_real *gradient = a->gradient + tm_row(i, 9);
  for (int k = 0; k < 9; k++) gradient[tm_column(k)] = L[k];
  double *f = a->force + 3 * (ptrdiff_t) i;
  const int begins = a->force_begins;
  for (int d = 0; d < 3; d++) f[d] = (begins ? 0.0 : f[d]) + mf * acceleration[d];
  if ((artstress || viscosity) && a->artificial)
    a->artificial[i] = 0.5 * per_force * L[12];
  if (conduction)
    a->heat[i] = TM_SINGLE ? L[13] * per_length * per_length / own_volume : L[13];
  if (xsph) {
    tm_real *u = a->xsph_v + 3 * (ptrdiff_t) i;
    u[0] = a->xsph * tm_lanes_sum(ux);
    u[1] = a->xsph * tm_lanes_sum(uy);
    u[2] = a->xsph * tm_lanes_sum(uz);
  }
  if (surface) {
    tm_real *s = a->surface + 3 * (ptrdiff_t) i;
    s[0] = per_mass * tm_lanes_sum(nx);
    s[1] = per_mass * tm_lanes_sum(ny);
    s[2] = per_mass * tm_lanes_sum(nz);
  }
}

#endif
