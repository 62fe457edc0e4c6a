/* SPH-TM: particle shifting: positions of metal that flows are kept even.

   Metal that is stretched by more than half has rows of particles that are near each other one way and have lost each other the
   other way: a gap opens though nothing has failed. A fluid's particles are spread evenly by shifting them down the gradient
   of their concentration C = sum V_j W (Lind et al. 2012, doi 10.1016/j.jcp.2011.10.027). Here the plastic strain of the
   step stands for the time, so that what does not flow is never moved:

     dx_i = -h d eps_p t(eps_p) [((1 - s)(1 - F))^3 beta_0 c_0 h g + ((1 - s)/(1 + |r|/b_0) + s/(1 + |r|/b_1)) r],
     r = beta F h (c A g + TM_SHIFT_SKIN w c' P g),   g = grad C = sum V_j gradW_ij,   F = max(0, 1 - W:W/D:D)^3,   w = s F^9,
     A = (1 + E)/2,   P = (1 + E)(1/2 + E)/3, in two dimensions A,
     c = max(0, 1 - h |g|/TM_SHIFT_FACE),   c_0 = max(0, 1 - h |g|/TM_SHIFT_SHEARED_FACE),
     c' = max(0, 1 - h |P g|/TM_SHIFT_FACE - c).

   g is 0 in a regular lattice, stretched too. t rises from 0 to 1 between the plastic strains TM_SHIFT_BEGINS and
   TM_SHIFT_WHOLE: below, spacings are near enough to what they were. Not so where metal is drawn: there hourglass control no longer
   holds rows that have come apart by a fifth, and a strip parted at 1.4 times its length before shifting was whole. So with w, which
   is 1 in a bar and 0.4 where the square of spin is a thirtieth of that of the strain, the two become TM_SHIFT_DRAWN_BEGINS and
   TM_SHIFT_DRAWN_WHOLE. With s F^3 in place of w this begins early also in a block that turns while it is drawn and in a neck near
   its surface: angular momentum changes, and patterns like a chessboard grow, by more than is borne.

   c falls to 0 towards surfaces, where h |g| is 0.57 to 0.66 (tm_face.h): what is at a surface stays there. But at the sides of metal
   that is drawn g points across the stretch, and what lies along it, P g, is about neighbors along the surface. That is what c' lets
   pass, so rows at the surface of a neck close up too; at an end, where g points along the stretch, it is 0. What a tool
   touches, what is in range of another body, and what other fixes move is not shifted: springs of contacts keep their energy.

   F tells metal that is pressed or drawn from metal that is sheared, with the spin W and the rate of strain D: it is 1 without spin, and
   0 in simple shear, where rows pass each other and meet new neighbors, and where what is shifted far takes the momentum and the
   strength of one side of a shear zone to the other. There the first term acts, all ways, but not in tension, s =
   tm_tension_share(): a pattern in the positions grows there, and a lattice that stays as it is holds longest. A lattice along the
   shear finds itself again after a shear of 1, one that lies obliquely is stretched until it breaks up: with beta_0 = 6 the shear
   stress fell by a tenth to a half from shears of 1.5 on, while particles bore the flow stress, and a cut along a lattice had four
   fifths of the force of one across it (bench/stability/sheared_lattice.py). 25 is just enough, 60 and 100 are no better than 40.
   The third power of 1 - F leaves metal that is pressed or drawn while it turns a little with what it had. That of 1 - s leaves a neck:
   with the first, rows beneath its surface, where s is below 1, went outward, and the bar of Weldox 460E was torn in its core. c_0 in place of c: with c the
   foot of a Taylor bar had a radius larger by 1.7 % (6 rings) to 4 % (225 m/s), as particles of a surface that has been stretched,
   where h |g| is 0.3 to 0.4, went outward.

   The second term is strong, and A lets it act along the stretch, which is where rows lose each other, and little across it. E is the
   deviator of D, over what makes it 1, -1/2, -1/2 in uniaxial tension, in two dimensions 1, -1: A is 1 and 1/4, in compression 3/4
   and 0, in two dimensions 1 and 0. The second row beneath a surface that is stretched, whose g points outward in a regular lattice
   too, hardly moves: with E = 1 the angular momentum of a block that turns changes three times as much. P in place of A, with
   nothing across the stretch of a bar, was tried: a neck then fails numerically. b_0 bounds it to a few h over a strain of 1, in tension
   b_1 to more, which necks need.

   Velocities and the state of a particle go along with it: momentum and the sum of energies are exact as without. Positions move
   by O(h) over a strain of 1, so with refinement this vanishes. The angular momentum changes by sum m dx x v (test_shifting.py).
   g is a sum that the rate pass has anyway, so this costs 3 numbers per particle.

   In a step no particle moves further than TM_SHIFT_SPEED times the way of sound. Slow flow is far below; behind a strong shock, where
   a strain of 1 takes as long as sound needs for a few h, what sprays off a surface would lose its neighbors without.

   What else was tried for beta, F and b, on necks, pressed blocks and cuts, is in doc/stability.rst. Own construction but for C. */
#ifndef TM_SHIFT_H
#define TM_SHIFT_H

#include "tm_strength.h"
#include "tm_tensor.h"

/* beta_0 and beta */
#define TM_SHIFT_SHEARED 40.0
#define TM_SHIFT_RATE 100.0
/* Plastic strain where shifting begins, and from where on it is whole. */
#define TM_SHIFT_BEGINS 0.2
#define TM_SHIFT_WHOLE 0.4
/* The same in uniaxial tension without spin. */
#define TM_SHIFT_DRAWN_BEGINS 0.1
#define TM_SHIFT_DRAWN_WHOLE 0.2
/* h |g| from where on there is none. */
#define TM_SHIFT_FACE 0.4
/* The same of the first term. */
#define TM_SHIFT_SHEARED_FACE 0.3
/* Shifting along the surface of drawn metal, over that inside. */
#define TM_SHIFT_SKIN 0.3
/* b_0 and b_1: most of the second term over a plastic strain of 1, over h, under pressure and in uniaxial tension */
#define TM_SHIFT_MOST 2.0
#define TM_SHIFT_DRAWN 22.0

/* Fastest, over the speed of sound. */
#define TM_SHIFT_SPEED 0.05

/* What a velocity gradient does with g. */
typedef struct {
  tm_real pure;  /* F, 0..1 */
  tm_vec3 along; /* A g */
  tm_vec3 axis;  /* P g */
} tm_shift_flow;

/* Of the velocity gradient L (1/time); F = 0 where nothing is strained. */
TM_FN tm_shift_flow tm_shift_along(tm_mat3 L, tm_vec3 g, int dim3)
{
  const tm_sym3 D = tm_sym_deviator(tm_mat_symmetric(L));
  const tm_vec3 curl = tm_vec(L.zy - L.yz, L.xz - L.zx, L.yx - L.xy);
  const tm_real strain2 = tm_sym_ddot(D, D), spin2 = 0.5 * tm_vec_dot(curl, curl);
  tm_shift_flow flow = {0.0, tm_vec(0, 0, 0), tm_vec(0, 0, 0)};
  if (!(strain2 > spin2)) return flow;
  const tm_real pure = 1.0 - spin2 / strain2;
  flow.pure = pure * pure * pure;
  const tm_real unit = sqrt((dim3 ? 1.5 : 2.0) / strain2);
  flow.along = tm_vec_scale(0.5, tm_vec_axpy(g, unit, tm_sym_mul_vec(D, g)));
  flow.axis = flow.along;
  if (!dim3) return flow;
  const tm_vec3 stretched = tm_vec_scale(unit, tm_sym_mul_vec(D, flow.along)); /* E A g */
  flow.axis = tm_vec_scale(2.0 / 3.0, tm_vec_axpy(stretched, 0.5, flow.along));
  return flow;
}

/* w: 1 where metal is drawn without spin, 0 where it is not drawn; tension: s. */
TM_FN tm_real tm_shift_drawn(tm_shift_flow flow, tm_real tension)
{
  const tm_real cube = flow.pure * flow.pure * flow.pure;
  return tension * cube * cube * cube;
}

/* dx of a particle with g (1/length) and smoothing length h, in a step in which the plastic strain grew by d_eps from eps_p;
   tension: s; sound: way of sound in the step. */
TM_FN tm_vec3 tm_shift(tm_vec3 g, tm_shift_flow flow, tm_real h, tm_real eps_p, tm_real d_eps, tm_real tension,
                       tm_real sound)
{
  const tm_real drawn = tm_shift_drawn(flow, tension);
  const tm_real begins = (1.0 - drawn) * TM_SHIFT_BEGINS + drawn * TM_SHIFT_DRAWN_BEGINS;
  const tm_real whole = (1.0 - drawn) * TM_SHIFT_WHOLE + drawn * TM_SHIFT_DRAWN_WHOLE;
  if (!(eps_p > begins)) return tm_vec(0, 0, 0);
  const tm_real strained = tm_min((eps_p - begins) / (whole - begins), 1.0);
  const tm_real uneven = h * tm_vec_norm(g);
  const tm_real inside = tm_max(0.0, 1.0 - uneven / TM_SHIFT_FACE);
  const tm_real skin = tm_max(0.0, 1.0 - h * tm_vec_norm(flow.axis) / TM_SHIFT_FACE - inside);
  const tm_vec3 along = tm_vec_axpy(tm_vec_scale(inside, flow.along), TM_SHIFT_SKIN * drawn * skin, flow.axis);
  const tm_real spun = (1.0 - tension) * (1.0 - flow.pure), beneath = tm_max(0.0, 1.0 - uneven / TM_SHIFT_SHEARED_FACE);
  const tm_real sheared = TM_SHIFT_SHEARED * h * beneath * spun * spun * spun;
  const tm_real rate = TM_SHIFT_RATE * h * flow.pure, r = rate * tm_vec_norm(along);
  const tm_real stretched = rate * ((1.0 - tension) / (1.0 + r / TM_SHIFT_MOST) + tension / (1.0 + r / TM_SHIFT_DRAWN));
  const tm_vec3 way = tm_vec_axpy(tm_vec_scale(sheared, g), stretched, along);
  const tm_vec3 dx = tm_vec_scale(-d_eps * strained * h, way);
  const tm_real length = tm_vec_norm(dx), most = TM_SHIFT_SPEED * sound;
  return length > most ? tm_vec_scale(most / length, dx) : dx;
}

#endif
