/* SPH-TM: hourglass control: stiffness against zero-energy modes.

   Positions that alternate from particle to particle make no strain in sums over gradients, so no stress acts against
   them; under tension the momentum sum makes them grow (tensile instability). Each particle therefore has a displacement
   u against its neighborhood, the integral of the velocity by which it is off the linear field of its neighbors, weighted
   by the root of the stiffness xi of the moment, so that k u^2/2 is the energy that was put in, however xi changes,

     du_i/dt = sqrt(xi) r_i + Omega_i u_i - (d eps_p/dt)/e u_i

   with the spin Omega and the plastic strain eps_p; r is tm_residual_velocity(), or without corrected gradients in the
   same pass what a fit of a linear field leaves (tm_hourglass_rate()). A linear field, and so every homogeneous strain and
   rotation, makes none, at free surfaces too. A force along the line between two particles opposes the difference,

     a_i = sum_j m_j min(k_i, k_j)/rho_ij^2 (W_i - W_j).x/r^2 gradW,   k = rho c^2,   W = sqrt(xi) u + delta h/c r

   central and equal and opposite: both momenta stay to round-off.

   xi is the stiffness over that of longitudinal waves. What it has to withstand is the tension itself, so it follows the
   stress of the particle, xi = zeta (sigma_Mises + <-p>)/(rho c^2): nothing has to be chosen for rubber or for metal.
   Displacements are forgotten with plastic strain, over e = TM_HOURGLASS_STRAIN in uniaxial tension and less where
   pressure keeps particles together (tm_hourglass_memory()), and what they resist with stays below a tenth of the flow stress
   (tm_hourglass_limit()), so that flow that few particles resolve is hardly hindered. Where metal is drawn its rows come apart, and
   neighbors that are further away resist less, while the instability is driven as before: from a stretch of 1.3 to 1.4 on it is the
   stronger (bench/stability/stretched_lattice.py). So with plastic strain under tension (tm_hourglass_drawn()) xi rises to three
   times as much: a neck then forms and fails by damage (case_weldox.py).

   A face that is cut from a lattice obliquely has steps of a spacing, each a notch. Under tension the corner of a step hangs back
   by some hundredths of h from the first strain on. With the limit of a tenth nothing holds it: rows part there, and
   a strip parted at a strain of 0.1 (bench/stability/turned_strip.py). So with tension the limit rises to the flow stress itself. What
   is forgotten lets such steps creep; where neighbors are uneven along the stretch, as told by P g of tm_shift.h, which is 0 at
   faces along it and inside, e rises to TM_HOURGLASS_LONGEST. Both fade with the plastic strain (tm_hourglass_early()): later
   shifting closes rows up, metal that parts before an edge should part, and a limit of 0.3 is enough for necks. The limit is the same
   for pairs that are kept, which do not come apart; xi and e do not rise with them, nor else without TM_FX_ONE_PASS.
   delta damps what alternates in time as well; both vanish with the square of the spacing where fields are smooth.

   Own construction; the idea of a penalty on what differs from the linear field is that of Ganzenmueller 2015
   (doi 10.1016/j.cma.2014.12.005), there with positions of the reference state, and of Zhang et al. 2024
   (arXiv 2409.11474), there of velocities of a pair.

   With TM_FX_ONE_PASS the sums are taken in the rate pass (tm_rates.h), together with those of the gradient correction
   of the next step; else in passes of their own, as total-Lagrangian pairs need it. */
#ifndef TM_HOURGLASS_H
#define TM_HOURGLASS_H

#include "tm_chunk.h"
#include "tm_correction_step.h"
#include "tm_pair.h"
#include "tm_strength.h"

#if TM_SINGLE
#error "double only: displacements are small differences of velocities"
#endif

/* Plastic strain over which displacements are forgotten in uniaxial tension, and the least share of it. */
#define TM_HOURGLASS_STRAIN 0.02
#define TM_HOURGLASS_MEMORY 0.05
/* That strain where h |P g| is TM_HOURGLASS_UNEVEN or more. */
#define TM_HOURGLASS_LONGEST 0.4
#define TM_HOURGLASS_UNEVEN 0.3
/* Largest stress of hourglass control, over the flow stress, of a displacement of h; in the tension of a bar, early and late. */
#define TM_HOURGLASS_YIELD 0.1
#define TM_HOURGLASS_YIELD_EARLY 1.0
#define TM_HOURGLASS_YIELD_LATE 0.3
/* Plastic strains between which the one turns into the other. */
#define TM_HOURGLASS_EARLY 0.2
#define TM_HOURGLASS_LATE 0.4
/* zeta, the largest xi that follows from it, and delta. */
#define TM_HOURGLASS_ZETA 12.0
#define TM_HOURGLASS_MOST 4.0
#define TM_HOURGLASS_DAMPING 0.1
/* By what xi rises where metal is drawn, and the plastic strains between which. */
#define TM_HOURGLASS_DRAWN 2.0
#define TM_HOURGLASS_DRAWN_BEGINS 0.15
#define TM_HOURGLASS_DRAWN_WHOLE 0.4

/* How far metal has been drawn, 0..1: rises with the plastic strain, and with tension to 1 at that of a bar. */
TM_FN tm_real tm_hourglass_drawn(tm_real flow, tm_real p, tm_real eps_p)
{
  if (!(eps_p > TM_HOURGLASS_DRAWN_BEGINS)) return 0.0;
  const tm_real strain = (eps_p - TM_HOURGLASS_DRAWN_BEGINS) / (TM_HOURGLASS_DRAWN_WHOLE - TM_HOURGLASS_DRAWN_BEGINS);
  return tm_min(strain, 1.0) * tm_tension_share(flow, p);
}

/* 1 at small plastic strains, 0 at large ones. */
TM_FN tm_real tm_hourglass_early(tm_real eps_p)
{
  return tm_max(0.0, tm_min(1.0, (TM_HOURGLASS_LATE - eps_p) / (TM_HOURGLASS_LATE - TM_HOURGLASS_EARLY)));
}

/* Displacement u of a material that flows: stiffness |u|, which is sqrt(xi) k |u|, stays below TM_HOURGLASS_YIELD Y h, with the
   share of tension that tm_tension_share() gives up to TM_HOURGLASS_YIELD_EARLY Y h, or _LATE; early: 0..1. */
TM_FN tm_vec3 tm_hourglass_limit(tm_vec3 u, tm_real stiffness, tm_real yield, tm_real tension, tm_real early, tm_real h)
{
  const tm_real most = TM_HOURGLASS_YIELD_LATE + (TM_HOURGLASS_YIELD_EARLY - TM_HOURGLASS_YIELD_LATE) * early;
  const tm_real share = TM_HOURGLASS_YIELD + (most - TM_HOURGLASS_YIELD) * tension;
  const tm_real resists = stiffness * tm_vec_norm(u), limit = share * yield * h;
  return !(yield > 0.0) || resists <= limit ? u : tm_vec_scale(limit / resists, u);
}

/* Least determinant of the second moment of the neighbors, over that of an even neighborhood: with less
   no linear field can be told. */
#define TM_HOURGLASS_LEAST 0.02

/* Stiffness over rho c^2 of a particle, >= 0: xi where it is given (>= 0), else from the deviator and the pressure. */
TM_FN tm_real tm_hourglass_stiffness(tm_real xi, tm_sym3 s, tm_real p, tm_real rho_c2, tm_real eps_p)
{
  if (xi >= 0.0) return xi;
  const tm_real mises = tm_sym_mises(s),
                zeta = TM_HOURGLASS_ZETA * (1.0 + TM_HOURGLASS_DRAWN * tm_hourglass_drawn(mises, p, eps_p));
  return tm_min(TM_HOURGLASS_MOST, zeta * (mises + tm_max(-p, 0.0)) / rho_c2);
}

/* How uneven neighbors are along a stretch, 0..1, times the share of tension; axis: P g, 1/length. */
TM_FN tm_real tm_hourglass_uneven(tm_vec3 axis, tm_real h, tm_real tension)
{
  return tension * tm_min(h * tm_vec_norm(axis) / TM_HOURGLASS_UNEVEN, 1.0);
}

/* Plastic strain over which displacements are forgotten, at flow stress and pressure: TM_HOURGLASS_STRAIN times an upper
   bound of the largest principal stress over the flow stress, between TM_HOURGLASS_MEMORY and 1; with uneven, 0..1, up to
   TM_HOURGLASS_LONGEST in its place. */
TM_FN tm_real tm_hourglass_memory(tm_real yield, tm_real p, tm_real uneven)
{
  const tm_real tension = yield > 0.0 ? (2.0 / 3.0) - p / yield : 1.0;
  const tm_real strain = TM_HOURGLASS_STRAIN + (TM_HOURGLASS_LONGEST - TM_HOURGLASS_STRAIN) * uneven;
  return strain * tm_max(tm_min(tension, 1.0), TM_HOURGLASS_MEMORY);
}

/* W at the force point, a length: stiffness xi, delay = delta h/c. */
TM_FN tm_vec3 tm_hourglass_displacement(const tm_real *field, tm_real ahead, tm_real stiffness, tm_real delay, int dim3)
{
  const tm_vec3 u = tm_vec_from_row_in(field + tm_column(TM_G_U), dim3);
  const tm_vec3 rate = tm_vec_from_row_in(field + tm_column(TM_G_RATE), dim3);
  const tm_real root = sqrt(stiffness), r = stiffness * ahead + delay;
  return tm_vec(root * u.x + r * rate.x, root * u.y + r * rate.y, root * u.z + r * rate.z);
}

/* u after a step with velocity gradient L, rate r and stiffness xi; forgotten: plastic strain of the step over
   tm_hourglass_memory(). */
TM_FN tm_vec3 tm_hourglass_step(tm_vec3 u, tm_vec3 rate, tm_real stiffness, tm_mat3 L, tm_real dt, tm_real forgotten,
                                int forget)
{
  const tm_real keep = forget ? 0.0 : 1.0 / (1.0 + forgotten), root = sqrt(stiffness);
  const tm_real sx = 0.5 * (L.zy - L.yz), sy = 0.5 * (L.xz - L.zx), sz = 0.5 * (L.yx - L.xy);
  const tm_vec3 turn = tm_vec(sy * u.z - sz * u.y, sz * u.x - sx * u.z, sx * u.y - sy * u.x);
  return tm_vec(keep * (u.x + dt * (turn.x + root * rate.x)), keep * (u.y + dt * (turn.y + root * rate.y)),
                keep * (u.z + dt * (turn.z + root * rate.z)));
}
TM_FN void tm_hourglass_store(tm_real *field, tm_vec3 u, tm_vec3 rate, int dim3)
{
  tm_vec_to_row_in(field + tm_column(TM_G_U), u, dim3);
  tm_vec_to_row_in(field + tm_column(TM_G_RATE), rate, dim3);
}

/* v_i - a of the fit, from the sums over the neighbors: weights, x, v, x (x) x, v (x) x; relative to particle i. */
TM_FN tm_vec3 tm_hourglass_rate(tm_real weights, tm_vec3 x, tm_vec3 v, tm_sym3 xx, tm_mat3 vx, int dim3)
{
  const tm_vec3 none = tm_vec(0, 0, 0);
  if (!(weights > 0.0)) return none;
  const tm_real s = 1.0 / weights;
  x = tm_vec_scale(s, x);
  v = tm_vec_scale(s, v);
  tm_sym3 M = tm_sym(s * xx.xx - x.x * x.x, s * xx.yy - x.y * x.y, s * xx.zz - x.z * x.z, s * xx.xy - x.x * x.y,
                     s * xx.xz - x.x * x.z, s * xx.yz - x.y * x.z);
  const tm_real mean = (M.xx + M.yy + (dim3 ? M.zz : 0.0)) / (dim3 ? 3.0 : 2.0);
  if (!(mean > 1e-6 * s * (xx.xx + xx.yy + xx.zz))) return none; /* all in one place */
  M = tm_sym_scale(1.0 / mean, M);
  if (!dim3) {
    M.zz = 1.0;
    M.xz = M.yz = 0.0;
  }
  const tm_real det = tm_sym_det(M);
  if (!(det > TM_HOURGLASS_LEAST)) return none;
  const tm_sym3 inverse = tm_sym_inverse_bounded(M, dim3, 0.0);
  const tm_vec3 b = tm_vec_scale(1.0 / mean, tm_sym_mul_vec(inverse, x)); /* B x = C b, C of the centered v (x) x */
  const tm_real bx = tm_vec_dot(b, x);
  return tm_vec(s * (vx.xx * b.x + vx.xy * b.y + vx.xz * b.z) - v.x * bx - v.x,
                s * (vx.yx * b.x + vx.yy * b.y + vx.yz * b.z) - v.y * bx - v.y,
                s * (vx.zx * b.x + vx.zy * b.y + vx.zz * b.z) - v.z * bx - v.z);
}

/* Columns of a chunk: x y z m v rho, W k, size, weight, factor of the force. */
enum {
  TM_GCOL_W = TM_REC_P,
  TM_GCOL_SIZE = (int) TM_GCOL_W + TM_REC_HOURGLASS,
  TM_GCOL_WEIGHT = TM_GCOL_SIZE + TM_REC_SIZE, /* m_j/rho_j W */
  TM_GCOL_FORCE,                               /* m_j min(k_i, k_j)/(rho_i rho_j) W'/r^3 */
  TM_GCOLUMNS
};

/* Coefficients of the pair with neighbor l of a chunk; own: W and k of the particle. */
TM_FN void tm_hourglass_coefficients(const tm_chunk *c, const tm_rates_args *a, int kernel, int dim3, int sizes,
                                     const tm_real *own, tm_real rhoi, tm_values *col, int l)
{
  const tm_real dx = tm_chunk_apart(c->x, col[0], l), dy = tm_chunk_apart(c->y, col[1], l);
  const tm_real dz = dim3 ? tm_chunk_apart(c->z, col[2], l) : 0.0;
  const tm_real r2 = dx * dx + dy * dy + dz * dz, r = sqrt(r2);
  const tm_pair_size p = tm_chunk_pair_size(c, sizes, col + TM_GCOL_SIZE, l, &a->norm_of_one, dim3);
  const tm_real q = r * p.inv_h, volume = col[TM_REC_M][tm_at(l)] / col[TM_REC_RHO][tm_at(l)];
  const tm_real ki = own[TM_HOURGLASS_K], kj = col[(int) TM_GCOL_W + TM_HOURGLASS_K][tm_at(l)];
  col[TM_GCOL_WEIGHT][tm_at(l)] = volume * p.norm * tm_kernel_shape(kernel, q);
  col[TM_GCOL_FORCE][tm_at(l)] = volume * p.slope_norm * tm_kernel_slope(kernel, q) / r * tm_min(ki, kj) / (r2 * rhoi);
}

/* Sums over the neighbors for tm_hourglass_rate() and the force. */
typedef struct {
  tm_sum weights, artificial;
  tm_sum_vec x, v, acceleration;
  tm_sum_mat xx, vx;
} tm_hourglass_sums;

TM_FN tm_hourglass_sums tm_hourglass_sums_zero(void)
{
  tm_hourglass_sums s;
  s.weights = s.artificial = tm_lanes_zero();
  s.x = s.v = s.acceleration = tm_sum_vec_zero();
  s.xx = s.vx = tm_sum_mat_zero();
  return s;
}

/* The pairs with TM_LANES neighbors of a chunk, from neighbor l on, into the sums. */
TM_FN void tm_hourglass_add(const tm_chunk *c, int dim3, const tm_real *own, const tm_real *velocity, tm_values *col,
                            int l, tm_hourglass_sums *s)
{
  const tm_lanes zero = {0}, w = tm_values_load(col[TM_GCOL_WEIGHT], l);
  const tm_lanes_vec d = {tm_chunk_lanes_apart(c->x, col[0], l), tm_chunk_lanes_apart(c->y, col[1], l),
                          dim3 ? tm_chunk_lanes_apart(c->z, col[2], l) : zero}; /* x_i - x_j */
  const tm_lanes_vec v = tm_pair_difference(velocity, col + TM_REC_V, l, dim3); /* v_i - v_j */
  const tm_lanes_vec wx = tm_lanes_scale(-w, d);                                /* m_j/rho_j W (x_j - x_i) */
  s->weights += w;
  tm_sum_vec_add(&s->x, wx);
  tm_pair_xsph(&s->v, w, v);
  tm_pair_gradient(&s->xx, d, wx, dim3);
  tm_pair_gradient(&s->vx, v, wx, dim3);

  const tm_lanes_vec across = tm_pair_difference(own, col + TM_GCOL_W, l, dim3); /* W_i - W_j */
  const tm_lanes along = tm_lanes_dot(across, d, dim3) * tm_values_load(col[TM_GCOL_FORCE], l);
  tm_pair_artificial(&s->acceleration, &s->artificial, tm_lanes_scale(along, d), v);
}

TM_FN tm_vec3 tm_sum_vec_total(const tm_sum_vec *s)
{
  return tm_vec(tm_lanes_sum(s->x), tm_lanes_sum(s->y), tm_lanes_sum(s->z));
}

/* Rate of w and force of particle i from its mechanical neighbors, the force added to what is there, its
   power to the heating by artificial terms. None of particles without k. */
TM_FN void tm_hourglass(int i, const tm_rates_args *a, unsigned effects)
{
  const int kernel = tm_fx_kernel(effects), dim3 = (effects & TM_FX_3D) != 0;
  const int sizes = (a->effects & TM_FX_SMOOTHING) != 0;
  const tm_real *own = a->rec.hourglass + (ptrdiff_t) i * TM_REC_HOURGLASS;
  tm_real *out = a->hourglass_rate + tm_row(i, 3);
  tm_vec_to_row_in(out, tm_vec(0, 0, 0), dim3);
  if (!(own[TM_HOURGLASS_K] > 0.0)) return;
  tm_real ri[TM_REC];
  tm_fetch(a->rec.main + tm_record(i, TM_REC), TM_REC, ri);
  tm_hourglass_sums s = tm_hourglass_sums_zero();

  tm_chunk c;
  int jj[TM_CHUNK_ROOM];
  tm_real TM_ALIGNED col[TM_GCOLUMNS][TM_COLUMN];
  for (tm_chunk_begin(&c, i, a, ri, sizes, jj); tm_chunk_gather(&c, jj, col[0], dim3); tm_chunk_carry(&c, jj)) {
    if (c.n == 0) continue;
    const int lanes = c.lanes;
    tm_chunk_fetch_main(&c, jj, TM_REC_P, dim3, col);
    tm_fetch_rows(a->rec.hourglass, TM_REC_HOURGLASS, jj, lanes, col[TM_GCOL_W]);
    if (sizes) tm_fetch_rows(a->rec.size, TM_REC_SIZE, jj, lanes, col[TM_GCOL_SIZE]);
    if (sizes) {
      TM_SIMD
      for (int l = 0; l < lanes; l++) tm_hourglass_coefficients(&c, a, kernel, dim3, 1, own, ri[TM_REC_RHO], col, l);
    } else {
      TM_SIMD
      for (int l = 0; l < lanes; l++) tm_hourglass_coefficients(&c, a, kernel, dim3, 0, own, ri[TM_REC_RHO], col, l);
    }
    for (int l = 0; l < lanes; l += TM_LANES) tm_hourglass_add(&c, dim3, own, ri + TM_REC_V, col, l, &s);
  }

  const tm_real vx[9] = {tm_lanes_sum(s.vx.xx), tm_lanes_sum(s.vx.xy), tm_lanes_sum(s.vx.xz),
                         tm_lanes_sum(s.vx.yx), tm_lanes_sum(s.vx.yy), tm_lanes_sum(s.vx.yz),
                         tm_lanes_sum(s.vx.zx), tm_lanes_sum(s.vx.zy), tm_lanes_sum(s.vx.zz)};
  const tm_sym3 xx = tm_sym(tm_lanes_sum(s.xx.xx), tm_lanes_sum(s.xx.yy), tm_lanes_sum(s.xx.zz), tm_lanes_sum(s.xx.yx),
                            tm_lanes_sum(s.xx.zx), tm_lanes_sum(s.xx.zy));
  const tm_vec3 rate = tm_hourglass_rate(tm_lanes_sum(s.weights), tm_sum_vec_total(&s.x), tm_sum_vec_total(&s.v), xx,
                                         tm_mat_load(vx), dim3);
  const tm_vec3 acceleration = tm_sum_vec_total(&s.acceleration);
  const tm_real mf = ri[TM_REC_M] * a->force_unit;
  double *f = a->force + 3 * (ptrdiff_t) i;
  tm_vec_to_row_in(out, rate, dim3);
  f[0] += mf * acceleration.x;
  f[1] += mf * acceleration.y;
  f[2] += mf * acceleration.z;
  if (a->artificial) a->artificial[i] += 0.5 * ri[TM_REC_M] * tm_lanes_sum(s.artificial);
}

#endif
