/* The gradient correction and the normals of free faces in time: they turn with the particle and are predicted; loose particles
   have less of them. */
#include "tm_correction_step.h"
#include "tm_moment.h"
#include "ut.h"

#include <string.h>

/* K turns with the particle; unknown it is 1. */
static void test_correction_turned(void)
{
  const double angle = 1e-3, since = 0.25, ahead = 0.15;
  tm_real field[TM_K_COLUMNS] = {2, 1, 3, 0.5, 0.25, -0.125, 0, 0, 2 * angle / (since + ahead), since, 0};
  const tm_mat3 R = {cos(angle), -sin(angle), 0, sin(angle), cos(angle), 0, 0, 0, 1};
  const tm_sym3 K = tm_sym_load(field), got = tm_turned_correction(field, ahead, 1);
  const tm_mat3 want = tm_mat_mul(R, tm_mat_mul(tm_mat_from_sym(K), tm_mat_transposed(R)));
  UT_WITHIN(got.xx, want.xx, 1e-9);
  UT_WITHIN(got.yy, want.yy, 1e-9);
  UT_WITHIN(got.xy, want.xy, 1e-9);
  UT_WITHIN(got.xz, want.xz, 1e-9);
  UT_WITHIN(got.yz, want.yz, 1e-9);
  UT_NEAR(tm_sym_det(got), tm_sym_det(K), 1e-14); /* a rotation to round-off */
  field[TM_K_RATE] = 0.05;                        /* and it goes on as before, up to a limit */
  field[TM_K_RATE + 3] = -0.02;
  const tm_sym3 later =
      tm_sym_turned(tm_sym(2 + 0.4 * 0.05, 1, 3, 0.5 - 0.4 * 0.02, 0.25, -0.125), tm_vec(0, 0, angle));
  UT_NEAR(tm_turned_correction(field, ahead, 1).xx, later.xx, 1e-6);
  UT_NEAR(tm_turned_correction(field, ahead, 1).xy, later.xy, 1e-6);
  field[TM_K_RATE] = 1e6;
  UT_NEAR(tm_turned_correction(field, ahead, 1).xx, 2.0 + TM_CORRECTION_STEP, 1e-3);
  field[0] = 0.0;
  UT_TRUE(tm_turned_correction(field, ahead, 1).xx == 1.0 && tm_turned_correction(field, ahead, 1).xy == 0.0);
}

/* K that changes evenly is met from the second step on. */
static void test_correction_step(void)
{
  const double dt = 0.1;
  tm_real field[TM_K_COLUMNS] = {0};
  tm_mat3 L = tm_mat_scale(0.0, tm_mat_identity());
  L.zz = 1.0;
  const tm_sym3 one = tm_sym(1, 1, 1, 0, 0, 0);
  tm_correction_step(field, NULL, one, NULL, L, 0.0, 0.0, 1); /* at t = 0 */
  for (int n = 0; n < 4; n++) {
    const double t = (n + 0.5) * dt;
    const tm_sym3 K = tm_sym(1 + 0.3 * t, 1, 1 - 0.1 * t, 0.2 * t, 0, 0),
                  used = tm_turned_correction(field, 0.5 * dt, 1);
    const tm_correction_last last = tm_correction_last_of(field, 1);
    UT_WITHIN(used.xx - K.xx, n ? 0.0 : -0.3 * t, 1e-14);
    UT_WITHIN(used.xy - K.xy, n ? 0.0 : -0.2 * t, 1e-14);
    UT_NEAR(last.since, n ? 0.5 * dt : 0.0, 1e-15);
    tm_correction_step(field, &last, K, &used, L, n ? dt : 0.5 * dt, 0.5 * dt, 1);
    UT_NEAR(field[TM_K_RATE], 0.3, 1e-12);
  }
  tm_correction_step(field, NULL, one, NULL, L, 0.0, 0.0, 1);
  UT_TRUE(field[TM_K_RATE] == 0.0);
}

/* The normal of a face points inward; its length grows from nothing inside a body to 1 at a face, without jumps; edges have
   less, corners none. */
static void test_face_normal(void)
{
  const double h = 1.2;
  double before = 0.0, most = 0.0;
  for (double x = 0.0; x < 2.0; x += 1e-3) {
    const tm_vec3 b = tm_face_normal(tm_vec(0.6 * x / h, 0.0, -0.8 * x / h), h, 0.5);
    const double length = tm_vec_norm(b);
    UT_WITHIN(b.x, 0.6 * length, 1e-14);
    UT_WITHIN(b.z, -0.8 * length, 1e-14);
    UT_WITHIN(length, before, 0.01);
    if (x < 0.05) UT_TRUE(tm_face_none(b));
    most = length > most ? length : most;
    before = length;
  }
  UT_NEAR(most, TM_FACE_MOST / TM_FACE_TILT, 1e-3);
  /* what the lattice with h = 1.2 spacings in two and three dimensions needs, over kappa h = 1.18 */
  UT_NEAR(tm_vec_norm(tm_face_normal(tm_vec(0.566 / h, 0, 0), h, 0.5)), 1.163 / 1.18, 0.02);
  UT_NEAR(tm_vec_norm(tm_face_normal(tm_vec(0.576 / h, 0, 0), h, 0.5)), 1.178 / 1.18, 0.02);
  before = 2.0;
  for (double lacks = 0.0; lacks < 2.5; lacks += 1e-3) {
    const double length = tm_vec_norm(tm_face_normal(tm_vec(0.5, 0, 0), h, lacks));
    UT_TRUE(length <= before + 1e-15 && (before > 1.9 || length > before - 0.01) && (lacks <= 1.5 || length == 0.0));
    before = length;
  }
  UT_TRUE(tm_face_kept(0.0) == 1.0 && tm_face_kept(TM_FACE_STRAIN) == 0.0 && tm_face_kept(9.0) == 0.0);
  UT_NEAR(tm_face_kept(0.25 * TM_FACE_STRAIN), 0.75, 1e-14);
}

/* The normal and the antisymmetric part of K turn with the particle; what the rate pass leaves goes into the field. */
static void test_face_turned(void)
{
  const double angle = 1e-3, since = 0.25, ahead = 0.15, next[TM_FACE_COLUMNS] = {0.6, -0.8, 0.5, 0.01, 0.02, -0.03};
  tm_real K[TM_K_COLUMNS] = {0}, field[TM_FACE_COLUMNS];
  K[TM_K_SPIN + 2] = 2 * angle / (since + ahead);
  K[TM_K_SINCE] = since;
  tm_face_step(field, next, 0.5);
  UT_TRUE(field[TM_FACE_NORMAL] == 0.3 && field[TM_FACE_NORMAL + 2] == 0.25 && field[TM_FACE_TURN + 1] == 0.02);
  tm_face_step(field, next, 1.0);
  const tm_face f = tm_turned_face(field, K, ahead, 1);
  UT_WITHIN(f.normal.x, 0.6 * cos(angle) + 0.8 * sin(angle), 1e-9);
  UT_WITHIN(f.normal.y, 0.6 * sin(angle) - 0.8 * cos(angle), 1e-9);
  UT_NEAR(f.normal.z, 0.5, 1e-15);
  UT_WITHIN(f.turn.x, 0.01 * cos(angle) - 0.02 * sin(angle), 1e-9);
  UT_NEAR(f.turn.z, -0.03, 1e-14);
  /* a matrix from its parts and back */
  const tm_mat3 m = {1, 2, 3, 4, 5, 6, 7, 8, 10};
  const tm_mat3 same = tm_face_matrix(tm_mat_symmetric(m), tm_face_turn(m));
  UT_NEAR(same.xy, 2.0, 1e-15);
  UT_NEAR(same.zx, 7.0, 1e-15);
  UT_NEAR(same.yz, 6.0, 1e-15);
}

/* Less correction for a particle that would set the time step of all; none less for faces and corners of a lattice. */
static void test_loose(void)
{
  const double h = 2.0;
  const tm_sym3 K = tm_sym(2.0, 3.0, 4.0, 0.5, -0.25, 0.125);
  for (double f = 0.0; f < 4.0; f += 0.1) {
    double face = f / h;
    const tm_sym3 used = tm_correction_of_loose(K, h, &face);
    const double share = f > TM_FACE_OF_TURN ? TM_FACE_OF_TURN / f : 1.0;
    UT_NEAR(face, share * f / h, 1e-15);
    UT_NEAR(used.xx, share * K.xx, 1e-15);
    UT_NEAR(used.yz, share * K.yz, 1e-15);
    if (f <= 1.31) UT_TRUE(face == f / h && used.xx == K.xx && used.xy == K.xy);
  }
}

int main(void)
{
  test_correction_turned();
  test_correction_step();
  test_loose();
  test_face_normal();
  test_face_turned();
  return ut_summary();
}
