/* SPH-TM: particle shifting: positions of metal that flows are kept even.

   Metal that is stretched by more than half has rows of particles that are near each other one way and have lost each other the
   other way: a gap opens though nothing has failed. A fluid's particles are spread evenly by shifting them down the gradient
   of their concentration C = sum V_j W (Lind et al. 2012, doi 10.1016/j.jcp.2011.10.027). Here the plastic strain of the
   step stands for the time, so that what does not flow is never moved:

     dx_i = -beta h^2 d eps_p  t(eps_p) c(h |g|) s(p) g,   g = grad C = sum V_j gradW_ij

   g is 0 in a regular lattice, stretched too. t rises from 0 to 1 between the plastic strains TM_SHIFT_BEGINS and
   TM_SHIFT_WHOLE: below, spacings are near enough to what they were. c = 1 - h |g|/TM_SHIFT_FACE falls to 0 towards surfaces,
   where h |g| is 0.57 to 0.66 (tm_face.h): what is at a surface stays there. What a tool or another body touches, and what other
   fixes move, is not shifted: springs of contacts keep their energy.

   s = 1 + 3 p/Y, between 0 and 1, is 0 from uniaxial tension on, p = -Y/3: there a pattern in the positions grows (tensile instability),
   and a lattice that stays as it is holds longest: a strip that is drawn through a die parted after two thirds of the way with s = 1.

   Velocities and the state of a particle go along with it: momentum and the sum of energies are exact as without. Positions move
   by O(h) over a strain of 1, so with refinement this vanishes. The angular momentum changes by sum m dx x v: by 0.2 % in a block
   of 20 spacings that turns while it is strained by 0.5, by 0.04 % with 40 (test_shifting.py). g is a sum that the rate pass has
   anyway, so this costs 3 numbers per particle.

   beta from 4 to 10 was tried: gaps in a pressed block close from 4 on, and less artificial work is done in chips with 10
   than with 4. From 25 on blocks can be pressed to 0.38 of their height, force within 3 %, where with 6 half of it is lost beyond half of
   the height. But what is shifted across a shear zone takes its momentum and its strength there: with 25 a milling cutter needs 16 %
   more force (examples/peripheral_milling, 20 um), a slip-line cut 4 % more. Own construction but for C. */
#ifndef TM_SHIFT_H
#define TM_SHIFT_H

#include "tm_tensor.h"

/* beta */
#define TM_SHIFT_RATE 6.0
/* Plastic strain where shifting begins, and from where on it is whole. */
#define TM_SHIFT_BEGINS 0.2
#define TM_SHIFT_WHOLE 0.4
/* h |g| from where on there is none. */
#define TM_SHIFT_FACE 0.4
/* Most in one step, over h. */
#define TM_SHIFT_MOST 0.02

/* s of flow stress and pressure; without a flow stress (molten) 1 under pressure, 0 in tension. */
TM_FN tm_real tm_shift_share(tm_real yield, tm_real p)
{
  if (!(yield > 0.0)) return p < 0.0 ? 0.0 : 1.0;
  return tm_max(0.0, tm_min(1.0, 1.0 + 3.0 * p / yield));
}

/* dx of a particle with g (1/length) and smoothing length h, in a step in which the plastic strain grew by d_eps from eps_p; share:
   s. */
TM_FN tm_vec3 tm_shift(tm_vec3 g, tm_real h, tm_real eps_p, tm_real d_eps, tm_real share)
{
  const tm_real size = h * tm_vec_norm(g);
  if (!(eps_p > TM_SHIFT_BEGINS && size > 0.0 && size < TM_SHIFT_FACE)) return tm_vec(0, 0, 0);
  const tm_real strained = tm_min((eps_p - TM_SHIFT_BEGINS) / (TM_SHIFT_WHOLE - TM_SHIFT_BEGINS), 1.0);
  const tm_real way = TM_SHIFT_RATE * share * d_eps * strained * (1.0 - size / TM_SHIFT_FACE) * size;
  return tm_vec_scale(-tm_min(way, TM_SHIFT_MOST) * h * h / size, g);
}

#endif
