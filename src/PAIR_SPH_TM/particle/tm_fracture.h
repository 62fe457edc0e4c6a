/* SPH-TM: whether a particle has lost its neighbors on one side though nothing has failed: numerical fracture.

   Each particle keeps where it was, X, and the sum of the bonds to its nearest neighbors there,
     B = sum of X_j - X_i over |X_j - X_i| < 1.5 spacings.
   Of the bonds whose neighbors are within the support radius still, F maps reference to present positions best (where it
   tells less than all but TM_FRACTURE_ROUGH of their square the neighborhood has flowed, and nothing can be said),
     F = (sum (x_j - x_i)(X_j - X_i)) (sum (X_j - X_i)(X_j - X_i))^-1,
   and B less their sum is the side on which neighbors were lost, direction u. The particle has come loose where
     |B - sum| is that of half a face of the lattice: flow loses neighbors on both sides, and then the sum is small;
     no particle is near in a cone about F u, where those lost should be: past a slip plane there are others;
     the spacing there, |F u|, is neither so large that neighbors no longer meet nor pressed together: a surface that
     grows takes particles in from below, and there the body is compressed across the surface.
   One whose kept bonds do not tell F is loose where there is none at all within the length of a bond.
   Particles that have failed, and those that ever had a failed neighbor, are left out: there fracture is physical. So are
   those without bonds in the reference.

   The other way round, faces of one body that meet act on each other as its inside does: they weld. A particle is of a face where
   |B| is at least that of half a face, and the sum of X_j - X_i over the support radius TM_FRACTURE_ASIDE of that of half a
   ball: the inside of a bar that is made of rings has holes in its bonds. Particle i of a face has met another where a neighbor j within the support radius is of a
   face too and was no bond, the two lie outward of each other, each within a cone of TM_FRACTURE_CONE about the other's
   outward normal, the normals oppose each other as much, and no third particle is within TM_FRACTURE_BETWEEN spacings of the
   middle between them. A normal is that of the sum of x_j - x_i over the neighbors that are of no face, where that is
   TM_FRACTURE_CLEAR of that of half a ball: the face of a chip or of a die's cavity that becomes shorter, and rough, has normals
   that agree. A body of two rows has none, and is not told. Fewer than TM_FRACTURE_MEETINGS particles tell nothing. */
#ifndef TM_FRACTURE_H
#define TM_FRACTURE_H

#include "tm_chunk.h"
#include "tm_eigen.h"
#include "tm_state.h"

#include <limits.h>

/* Length of bonds over the spacing: 8 neighbors of a square lattice, 18 of a cubic one. */
#define TM_FRACTURE_BOND 1.5
/* Least loss of bonds over the spacing; a face of the square lattice has 3, of the cubic one 5. */
#define TM_FRACTURE_LOSS_2D 1.5
#define TM_FRACTURE_LOSS_3D 2.5
/* The cone in which there is none, cosine of half its angle, and its length over the support radius. */
#define TM_FRACTURE_CONE 0.5
#define TM_FRACTURE_EMPTY 0.85
/* Largest share of the square of the kept bonds that F does not tell. */
#define TM_FRACTURE_ROUGH 0.03
#define TM_FRACTURE_BETWEEN 0.6
#define TM_FRACTURE_ASIDE 0.3
#define TM_FRACTURE_CLEAR 0.3
#define TM_FRACTURE_MEETINGS 4
/* |F u|: pressed together below the first; above the second, over the support radius, neighbors hardly meet. */
#define TM_FRACTURE_PRESSED 0.8
#define TM_FRACTURE_STRETCHED 0.8
/* Least determinant of the kept bonds over that of even ones, to know F. */
#define TM_FRACTURE_LEAST 0.02

/* what is known of a particle, last column of the field */
enum {
  TM_FRACTURE_UNKNOWN = 0,
  TM_FRACTURE_WHOLE = 1,
  TM_FRACTURE_LEFT_OUT = 2,
  TM_FRACTURE_TORN = 3,
  TM_FRACTURE_FACE = 4 /* whole, and of a face of the reference */
};
/* what neighbors know of a particle: X; 1 where it has failed, -1 where it has not and is of a face; the inward normal of a
   face, 0 elsewhere */
enum { TM_FRACTURE_FLAG = 3, TM_FRACTURE_NORMAL = 4, TM_FRACTURE_KNOWN = 7 };

typedef struct {
  tm_state state;
  tm_rows rows;
  tm_records rec; /* positions of owned and ghost particles */
  const int *tag;
  tm_real *known;              /* TM_FRACTURE_KNOWN per particle, owned and ghost */
  tm_real period[3];           /* lengths of the box where the references were taken, 0: not periodic */
  tm_real spacing, h, support; /* of all, where particles have no size of their own; radius over h */
  int dim3;
} tm_fracture_args;

/* Of a look at all particles: how many are torn; of those that were not yet, the least tag; how many are of faces that meet,
   the least tag of them, and that of whom it met. */
typedef struct {
  tm_real torn, met;
  int first, first_met, other;
} tm_fracture_result;

TM_FN tm_fracture_result tm_fracture_nothing(void)
{
  tm_fracture_result r;
  r.torn = r.met = 0.0;
  r.first = r.first_met = r.other = INT_MAX;
  return r;
}
TM_FN void tm_fracture_sum(tm_fracture_result *sum, const tm_fracture_result *r)
{
  sum->torn += r->torn;
  sum->met += r->met;
  if (r->first < sum->first) sum->first = r->first;
  if (r->first_met < sum->first_met) {
    sum->first_met = r->first_met;
    sum->other = r->other;
  }
}

TM_FN int tm_fracture_state(const tm_state *s, int i)
{
  return (int) tm_field_row(s, TM_F_FRACTURE, i)[tm_column(TM_R_STATE)];
}
TM_FN int tm_fracture_is_whole(tm_real state)
{
  return state == (tm_real) TM_FRACTURE_WHOLE || state == (tm_real) TM_FRACTURE_FACE;
}
TM_FN tm_real tm_fracture_is_unknown(int i, const tm_fracture_args *a)
{
  return tm_fracture_state(&a->state, i) == (tm_real) TM_FRACTURE_UNKNOWN ? 1.0 : 0.0;
}
TM_FN tm_real tm_fracture_is_torn(int i, const tm_fracture_args *a)
{
  return tm_fracture_state(&a->state, i) == TM_FRACTURE_TORN ? 1.0 : 0.0;
}

/* The present place as reference. */
TM_FN void tm_fracture_refer(int i, const tm_fracture_args *a)
{
  const tm_real *r = tm_main_record(&a->rec, i);
  tm_real *f = tm_field_row(&a->state, TM_F_FRACTURE, i);
  for (int k = 0; k < 3; k++) f[tm_column(TM_R_X + k)] = r[tm_part(TM_REC_X + k)];
  if (f[tm_column(TM_R_STATE)] == (tm_real) TM_FRACTURE_UNKNOWN) f[tm_column(TM_R_STATE)] = TM_FRACTURE_WHOLE;
}

/* Spacing of particle i. */
TM_FN tm_real tm_fracture_spacing(int i, const tm_fracture_args *a)
{
  return a->state.field[TM_F_SIZE] ? tm_field_row(&a->state, TM_F_SIZE, i)[tm_column(TM_S_DP)] : a->spacing;
}

/* The sum B of the reference. */
TM_FN tm_vec3 tm_fracture_inward(int i, const tm_fracture_args *a)
{
  const tm_real *f = tm_field_row(&a->state, TM_F_FRACTURE, i);
  return tm_vec(f[tm_column(TM_R_B)], f[tm_column(TM_R_B + 1)], f[tm_column(TM_R_B + 2)]);
}

/* What neighbors are told. */
TM_FN void tm_fracture_tell(int i, const tm_fracture_args *a)
{
  const tm_real *f = tm_field_row(&a->state, TM_F_FRACTURE, i);
  tm_real *k = a->known + (ptrdiff_t) i * TM_FRACTURE_KNOWN;
  for (int d = 0; d < 3; d++) k[d] = f[tm_column(TM_R_X + d)];
  const int failed = a->state.field[TM_F_DAMAGE] && tm_field_row(&a->state, TM_F_DAMAGE, i)[tm_column(1)] > 0.5;
  k[TM_FRACTURE_FLAG] = failed ? 1.0 : tm_fracture_state(&a->state, i) == TM_FRACTURE_FACE ? -1.0 : 0.0;
  for (int d = 0; d < 3; d++) k[TM_FRACTURE_NORMAL + d] = 0.0;
}

/* Support radius of particle i. */
TM_FN tm_real tm_fracture_reach(int i, const tm_fracture_args *a)
{
  return a->support * (a->state.field[TM_F_SIZE] ? tm_field_row(&a->state, TM_F_SIZE, i)[tm_column(TM_S_H)] : a->h);
}

/* The length of the sum of x_j - x_i over the neighbors of a plane face of an even lattice. */
TM_FN tm_real tm_fracture_half_ball(tm_real reach, tm_real dp, int dim3)
{
  const tm_real r = reach / dp;
  return dp * (dim3 ? TM_PI / 4.0 * r * r * r * r : 2.0 / 3.0 * r * r * r);
}

/* X_j - X_i, to the nearest image. */
TM_FN tm_vec3 tm_fracture_bond(int i, int j, const tm_fracture_args *a)
{
  const tm_real *p = a->known + (ptrdiff_t) i * TM_FRACTURE_KNOWN, *q = a->known + (ptrdiff_t) j * TM_FRACTURE_KNOWN;
  tm_real d[3];
  for (int k = 0; k < 3; k++) {
    d[k] = q[k] - p[k];
    if (a->period[k] > 0.0) d[k] -= a->period[k] * floor(d[k] / a->period[k] + 0.5);
  }
  return tm_vec(d[0], d[1], a->dim3 ? d[2] : 0.0);
}

TM_FN tm_vec3 tm_fracture_apart(int i, int j, const tm_fracture_args *a)
{
  const tm_real *p = tm_main_record(&a->rec, i), *q = tm_main_record(&a->rec, j);
  return tm_vec(q[tm_part(0)] - p[tm_part(0)], q[tm_part(1)] - p[tm_part(1)],
                a->dim3 ? q[tm_part(2)] - p[tm_part(2)] : 0.0);
}

/* The sum B of a reference that was just taken, and whether it is that of a face. */
TM_FN void tm_fracture_bonds(int i, const tm_fracture_args *a)
{
  const tm_real dp = tm_fracture_spacing(i, a), most = TM_FRACTURE_BOND * dp, reach = tm_fracture_reach(i, a);
  tm_vec3 sum = tm_vec(0, 0, 0), wide = sum;
  int bonds = 0;
  for (int k = 0; k < a->rows.mechanical[i]; k++) {
    const tm_vec3 X = tm_fracture_bond(i, a->rows.index[a->rows.first[i] + k * a->rows.stride], a);
    const tm_real r2 = tm_vec_dot(X, X);
    if (r2 < reach * reach) wide = tm_vec_add(wide, X);
    if (!(r2 < most * most)) continue;
    sum = tm_vec_add(sum, X);
    bonds++;
  }
  tm_real *f = tm_field_row(&a->state, TM_F_FRACTURE, i), *state = f + tm_column(TM_R_STATE);
  f[tm_column(TM_R_B)] = sum.x;
  f[tm_column(TM_R_B + 1)] = sum.y;
  f[tm_column(TM_R_B + 2)] = sum.z;
  if (!tm_fracture_is_whole(*state)) return;
  const int face = tm_vec_norm(sum) >= (a->dim3 ? TM_FRACTURE_LOSS_3D : TM_FRACTURE_LOSS_2D) * dp &&
                   tm_vec_norm(wide) >= TM_FRACTURE_ASIDE * tm_fracture_half_ball(reach, dp, a->dim3);
  *state = !bonds ? TM_FRACTURE_LEFT_OUT : face ? TM_FRACTURE_FACE : TM_FRACTURE_WHOLE;
}

/* No neighbor of i within a distance and, where cosine > -1, within a cone about the unit vector e. */
TM_FN int tm_fracture_is_empty(int i, const tm_fracture_args *a, tm_vec3 e, tm_real cosine, tm_real distance)
{
  for (int k = 0; k < a->rows.mechanical[i]; k++) {
    const tm_vec3 d = tm_fracture_apart(i, a->rows.index[a->rows.first[i] + k * a->rows.stride], a);
    const tm_real r = tm_vec_norm(d);
    if (r < distance && tm_vec_dot(d, e) >= cosine * r) return 0;
  }
  return 1;
}

/* The kept bonds of particle i. */
typedef struct {
  tm_vec3 sum;   /* of X_j - X_i */
  tm_vec3 inner; /* of x_j - x_i, over all neighbors of no face that have not failed */
  tm_sym3 XX;
  tm_mat3 xX;
  tm_real xx;
  int near_failed;
} tm_fracture_kept;

TM_FN tm_fracture_kept tm_fracture_gather(int i, const tm_fracture_args *a, tm_real dp, tm_real reach)
{
  tm_fracture_kept s;
  s.sum = s.inner = tm_vec(0, 0, 0);
  s.XX = tm_sym(0, 0, 0, 0, 0, 0);
  s.xX = tm_mat_scale(0.0, tm_mat_identity());
  s.xx = 0.0;
  s.near_failed = a->known[(ptrdiff_t) i * TM_FRACTURE_KNOWN + TM_FRACTURE_FLAG] > 0.5;
  for (int k = 0; k < a->rows.mechanical[i]; k++) {
    const int j = a->rows.index[a->rows.first[i] + k * a->rows.stride];
    const tm_vec3 x = tm_fracture_apart(i, j, a), X = tm_fracture_bond(i, j, a);
    if (!(tm_vec_dot(x, x) < reach * reach)) continue;
    if (a->known[(ptrdiff_t) j * TM_FRACTURE_KNOWN + TM_FRACTURE_FLAG] > 0.5) s.near_failed = 1;
    if (a->known[(ptrdiff_t) j * TM_FRACTURE_KNOWN + TM_FRACTURE_FLAG] == 0.0) s.inner = tm_vec_add(s.inner, x);
    if (!(tm_vec_dot(X, X) < TM_FRACTURE_BOND * TM_FRACTURE_BOND * dp * dp)) continue;
    const tm_real c[9] = {x.x * X.x, x.x * X.y, x.x * X.z, x.y * X.x, x.y * X.y,
                          x.y * X.z, x.z * X.x, x.z * X.y, x.z * X.z};
    s.sum = tm_vec_add(s.sum, X);
    s.xx += tm_vec_dot(x, x);
    s.XX = tm_sym_add_dyad(s.XX, 1.0, X);
    s.xX = tm_mat_add(s.xX, tm_mat_load(c));
  }
  return s;
}

/* F : sum x X, the part of the square of the kept bonds that F tells. */
TM_FN tm_real tm_fracture_told(const tm_mat3 *F, const tm_mat3 *b)
{
  return F->xx * b->xx + F->xy * b->xy + F->xz * b->xz + F->yx * b->yx + F->yy * b->yy + F->yz * b->yz + F->zx * b->zx +
         F->zy * b->zy + F->zz * b->zz;
}

/* Whether particle i has come loose by now. */
TM_FN int tm_fracture_is_loose(int i, const tm_fracture_args *a, const tm_fracture_kept *kept, tm_real dp,
                               tm_real reach)
{
  const tm_vec3 lost = tm_vec_axpy(tm_fracture_inward(i, a), -1.0, kept->sum);
  const tm_real size = tm_vec_norm(lost);
  tm_sym3 M = tm_sym_scale(1.0 / (dp * dp), kept->XX);
  if (!a->dim3) M.zz = 1.0;
  if (!(tm_sym_det(M) > TM_FRACTURE_LEAST)) return tm_fracture_is_empty(i, a, lost, -1e300, TM_FRACTURE_BOND * dp);
  if (size < (a->dim3 ? TM_FRACTURE_LOSS_3D : TM_FRACTURE_LOSS_2D) * dp) return 0;
  const tm_vec3 u = tm_vec_scale(1.0 / size, lost);
  const tm_sym3 inverse = tm_sym_scale(1.0 / (dp * dp), tm_sym_inverse_bounded(M, a->dim3, 0.0));
  tm_mat3 F = tm_mat_mul(kept->xX, tm_mat_from_sym(inverse));
  if (!a->dim3) F.zz = 1.0;
  if (kept->xx - tm_fracture_told(&F, &kept->xX) > TM_FRACTURE_ROUGH * kept->xx) return 0;
  const tm_vec3 to = tm_vec(F.xx * u.x + F.xy * u.y + F.xz * u.z, F.yx * u.x + F.yy * u.y + F.yz * u.z,
                            F.zx * u.x + F.zy * u.y + F.zz * u.z);
  const tm_real stretch = tm_vec_norm(to);
  if (stretch < TM_FRACTURE_PRESSED || stretch * dp > TM_FRACTURE_STRETCHED * reach) return 0;
  return tm_fracture_is_empty(i, a, tm_vec_scale(1.0 / stretch, to), TM_FRACTURE_CONE, TM_FRACTURE_EMPTY * reach);
}

/* The normal of particle i of a face, for its neighbors; what they are told is known. */
TM_FN void tm_fracture_normal(int i, const tm_fracture_args *a)
{
  tm_real *known = a->known + (ptrdiff_t) i * TM_FRACTURE_KNOWN;
  if (known[TM_FRACTURE_FLAG] > -0.5) return;
  const tm_real dp = tm_fracture_spacing(i, a), reach = tm_fracture_reach(i, a);
  const tm_fracture_kept kept = tm_fracture_gather(i, a, dp, reach);
  const tm_real size = tm_vec_norm(kept.inner);
  if (size >= TM_FRACTURE_CLEAR * tm_fracture_half_ball(reach, dp, a->dim3))
    tm_store3(known + TM_FRACTURE_NORMAL, tm_vec_scale(1.0 / size, kept.inner));
}

/* Whether a neighbor of i other than j lies near the middle between them; x = x_j - x_i. */
TM_FN int tm_fracture_between(int i, int j, const tm_fracture_args *a, tm_vec3 x, tm_real dp)
{
  for (int k = 0; k < a->rows.mechanical[i]; k++) {
    const int m = a->rows.index[a->rows.first[i] + k * a->rows.stride];
    const tm_vec3 off = tm_vec_axpy(tm_fracture_apart(i, m, a), -0.5, x);
    if (m != j && tm_vec_dot(off, off) < TM_FRACTURE_BETWEEN * TM_FRACTURE_BETWEEN * dp * dp) return 1;
  }
  return 0;
}

/* The tag of a neighbor on another face of its body that particle i of a face has met; 0: none. */
TM_FN int tm_fracture_met(int i, const tm_fracture_args *a, tm_real dp, tm_real reach)
{
  const tm_vec3 n = tm_load3(a->known + (ptrdiff_t) i * TM_FRACTURE_KNOWN + TM_FRACTURE_NORMAL);
  for (int k = 0; k < a->rows.mechanical[i]; k++) {
    const int j = a->rows.index[a->rows.first[i] + k * a->rows.stride];
    const tm_real *known = a->known + (ptrdiff_t) j * TM_FRACTURE_KNOWN;
    if (known[TM_FRACTURE_FLAG] > -0.5) continue;
    const tm_vec3 x = tm_fracture_apart(i, j, a), X = tm_fracture_bond(i, j, a);
    const tm_vec3 m = tm_load3(known + TM_FRACTURE_NORMAL);
    const tm_real r = tm_vec_norm(x), most = -TM_FRACTURE_CONE;
    if (r < reach && tm_vec_dot(X, X) > TM_FRACTURE_BOND * TM_FRACTURE_BOND * dp * dp && tm_vec_dot(x, n) < most * r &&
        -tm_vec_dot(x, m) < most * r && tm_vec_dot(n, m) < most && !tm_fracture_between(i, j, a, x, dp))
      return a->tag[j];
  }
  return 0;
}

TM_FN tm_fracture_result tm_fracture_look(int i, const tm_fracture_args *a)
{
  tm_fracture_result out = tm_fracture_nothing();
  tm_real *state = tm_field_row(&a->state, TM_F_FRACTURE, i) + tm_column(TM_R_STATE);
  if (tm_fracture_is_whole(*state)) {
    const tm_real dp = tm_fracture_spacing(i, a), reach = tm_fracture_reach(i, a);
    const tm_fracture_kept kept = tm_fracture_gather(i, a, dp, reach);
    const int face = a->known[(ptrdiff_t) i * TM_FRACTURE_KNOWN + TM_FRACTURE_FLAG] < -0.5 && !kept.near_failed;
    const int other = face ? tm_fracture_met(i, a, dp, reach) : 0;
    if (other) {
      out.met = 1.0;
      out.first_met = a->tag[i];
      out.other = other;
    }
    if (kept.near_failed) *state = TM_FRACTURE_LEFT_OUT;
    else if (tm_fracture_is_loose(i, a, &kept, dp, reach)) {
      *state = TM_FRACTURE_TORN;
      out.first = a->tag[i];
    }
  }
  out.torn = *state == (tm_real) TM_FRACTURE_TORN ? 1.0 : 0.0;
  return out;
}

#endif
