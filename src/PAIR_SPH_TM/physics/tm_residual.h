/* SPH-TM: by how much the velocity of a particle differs from the linear field around it.

   With d = x_i - x_j, v = v_i - v_j, the corrected velocity gradient L and weights w = -m_j W'/r > 0 the neighbors are
   off the linear field through particle i by

     v_j - v_i - L (x_j - x_i)     on the mean  (L sum w d - sum w v)/sum w

   and particle i is off its neighbors by the opposite of that. A linear field has none, whatever the neighborhood, where
   L is the corrected gradient (tm_moment.h). It is largest for velocities that alternate from particle to particle,
   which the gradient does not see (zero-energy modes), and falls with the square of the spacing for smooth fields. */
#ifndef TM_RESIDUAL_H
#define TM_RESIDUAL_H

#include "tm_tensor.h"

/* Eigenvalues of the moment matrix below this count as this. */
#define TM_MOMENT_LOW 0.1

/* What the rate pass leaves of the moments: K. */
enum { TM_MOMENT_COLUMNS = 6 };

/* face: |K sum_j V_j gradW|, 1/length, is 0 inside a lattice, 1.15/h at a face and 1.31/h at a corner (hyperbolic, h = 1.2
   spacings). Where it is larger, neighbors lie on one side and close: the particle swings against them faster than any wave
   of a lattice, by 5 in h/c at 2.4/h. At this over h it turns by what the safety of courant 0.4 allows. */
#define TM_FACE_OF_TURN 1.9

/* A particle that hangs loose would set the time step of all (a cut made half as long by some in the chip). Its K is reduced
   to a face of TM_FACE_OF_TURN/h: L, with which its stress follows, and the force of its own stress are made with the same
   K, so energy and momenta stay exact, a rotation still makes no strain and the stress no torque; the particle is softer. */
TM_FN tm_sym3 tm_correction_of_loose(tm_sym3 K, tm_real h, tm_real *face)
{
  const tm_real most = TM_FACE_OF_TURN / h;
  if (!(*face > most)) return K;
  const tm_real share = most / *face;
  *face = most;
  return tm_sym_scale(share, K);
}

/* v_i minus the linear field, from the sums of g, g d and g v, g = m_j W'/r < 0; 0 without neighbors. */
TM_FN tm_vec3 tm_residual_velocity(tm_real weights, tm_vec3 gd, tm_vec3 gv, tm_mat3 L)
{
  if (!(weights < 0.0)) return tm_vec(0, 0, 0);
  const tm_real s = 1.0 / weights;
  return tm_vec(s * (gv.x - (L.xx * gd.x + L.xy * gd.y + L.xz * gd.z)),
                s * (gv.y - (L.yx * gd.x + L.yy * gd.y + L.yz * gd.z)),
                s * (gv.z - (L.zx * gd.x + L.zy * gd.y + L.zz * gd.z)));
}

#endif
