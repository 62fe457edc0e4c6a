/* SPH-TM: particle shifting: positions of metal that flows are kept even.

   Metal that is stretched by more than half has rows of particles that are near each other one way and have lost each other the
   other way: a gap opens though nothing has failed. A fluid's particles are spread evenly by shifting them down the gradient
   of their concentration C = sum V_j W (Lind et al. 2012, doi 10.1016/j.jcp.2011.10.027). Here the plastic strain of the
   step stands for the time, so that what does not flow is never moved:

     dx_i = -h d eps_p t(eps_p) r/(1 + |r|/b),   r = beta c(h |g|) h M g,   g = grad C = sum V_j gradW_ij,   M = f (1 + E)/2

   g is 0 in a regular lattice, stretched too. t rises from 0 to 1 between the plastic strains TM_SHIFT_BEGINS and
   TM_SHIFT_WHOLE: below, spacings are near enough to what they were. c = 1 - h |g|/TM_SHIFT_FACE falls to 0 towards surfaces,
   where h |g| is 0.57 to 0.66 (tm_face.h): what is at a surface stays there. What a tool or another body touches, and what other
   fixes move, is not shifted: springs of contacts keep their energy.

   M lets pass what lies along the stretch, which is where rows lose each other, and little across it. E is the deviator of the
   rate of strain, over what makes it 1, -1/2, -1/2 in uniaxial tension, in two dimensions 1, -1: (1 + E)/2 is 1 and 1/4, in
   compression 3/4 and 0, in two dimensions 1 and 0. The second row beneath a surface that is stretched, whose g points outward
   in a regular lattice too, hardly moves: with E = 1 the angular momentum of a block that turns changes three times as much.
   (E + 1/2)(E + 1)/3, with nothing across the stretch of a bar, was tried: a neck then fails numerically.
   f = 1 - W:W/D:D, at least 0, with the spin W and the rate of strain D: in simple shear, where it is 0, rows pass each other and
   meet new neighbors, and what were moved across a shear zone would take its strength there.

   b bounds the way to a few h over a strain of 1, b = 2 (1 + 10 s) with s the share of tension (tm_tension_share()): a coarse cut loses
   the dependence of its force on the thickness of the chip without (test_peripheral_milling.py), and necks need more.

   Velocities and the state of a particle go along with it: momentum and the sum of energies are exact as without. Positions move
   by O(h) over a strain of 1, so with refinement this vanishes. The angular momentum changes by sum m dx x v (test_shifting.py).
   g is a sum that the rate pass has anyway, so this costs 3 numbers per particle.

   beta: without the bound a block of 20 rows that is pressed to 0.38 of its height (case_upset.py) holds its force within 5 % with 50,
   within 2 % with 100, and within 5.5 % with the bound; necks (case_weldox.py) fail numerically with 50, by damage with 100. Own
   construction but for C. */
#ifndef TM_SHIFT_H
#define TM_SHIFT_H

#include "tm_strength.h"
#include "tm_tensor.h"

/* beta */
#define TM_SHIFT_RATE 100.0
/* Plastic strain where shifting begins, and from where on it is whole. */
#define TM_SHIFT_BEGINS 0.2
#define TM_SHIFT_WHOLE 0.4
/* h |g| from where on there is none. */
#define TM_SHIFT_FACE 0.4
/* Most over a plastic strain of 1, over h, and how many times more in uniaxial tension. */
#define TM_SHIFT_MOST 2.0
#define TM_SHIFT_DRAWN 10.0

/* M g, of the velocity gradient L (1/time); none where nothing is strained. */
TM_FN tm_vec3 tm_shift_along(tm_mat3 L, tm_vec3 g, int dim3)
{
  const tm_sym3 D = tm_sym_deviator(tm_mat_symmetric(L));
  const tm_vec3 curl = tm_vec(L.zy - L.yz, L.xz - L.zx, L.yx - L.xy);
  const tm_real strain2 = tm_sym_ddot(D, D), spin2 = 0.5 * tm_vec_dot(curl, curl);
  if (!(strain2 > spin2)) return tm_vec(0, 0, 0);
  const tm_sym3 E = tm_sym_scale(sqrt((dim3 ? 1.5 : 2.0) / strain2), D);
  return tm_vec_scale(0.5 * (1.0 - spin2 / strain2), tm_vec_axpy(g, 1.0, tm_sym_mul_vec(E, g)));
}

/* dx of a particle with g (1/length) and smoothing length h, in a step in which the plastic strain grew by d_eps from eps_p; along:
   M g, tension: tm_tension_share(). */
TM_FN tm_vec3 tm_shift(tm_vec3 g, tm_vec3 along, tm_real h, tm_real eps_p, tm_real d_eps, tm_real tension)
{
  const tm_real size = h * tm_vec_norm(g);
  if (!(eps_p > TM_SHIFT_BEGINS && size < TM_SHIFT_FACE)) return tm_vec(0, 0, 0);
  const tm_real strained = tm_min((eps_p - TM_SHIFT_BEGINS) / (TM_SHIFT_WHOLE - TM_SHIFT_BEGINS), 1.0);
  const tm_real rate = TM_SHIFT_RATE * (1.0 - size / TM_SHIFT_FACE) * h;
  const tm_real bound = 1.0 + rate * tm_vec_norm(along) / (TM_SHIFT_MOST * (1.0 + TM_SHIFT_DRAWN * tension));
  return tm_vec_scale(-rate / bound * d_eps * strained * h, along);
}

#endif
