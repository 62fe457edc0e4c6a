/* SPH-TM: the layer between the center of a particle and the surface of a tool that touches it.

   A tool meets the surface of the material, half a spacing outside the centers of the outermost particles. Where that half
   spacing is rigid, all strain is that of the distance between centers: a body of n rows between two tools deforms by
   n/(n - 1) of what it should and resists with n/(n - 1) times the force (virtual work of a homogeneous strain). So the
   layer has the strain of its particle. With the normal n of the surface and x = the integral of n.L n since the particle
   came near,

     e = r f(x),   r = dp/2,     f(x) = exp(x/(1 + (x/x_0)^4)^(1/4))

   is the distance of the surface from the center, and the penetration is e - d with d that of the tool. f is exp(x), the
   stretch, until a strain where no row of particles is left as it was, and ends at exp(x_0). The force f_n n of the tool does
   work on the layer too, which is that of a stress

     T = f_n de/dx/V n (x) n

   added to that of the particle in the momentum sum, V its volume: the sums of the pair forces are the work conjugates of the
   velocity gradient L, so energy is exact as it is without, and momentum pair by pair. At a plane surface in equilibrium T is
   half of the stress, as only half of the particle lies between its center and the tool. The thickness is one number, not one
   for each direction: an edge or a rounding over which a particle slides turns n, and no work goes into that. In a corner
   of one tool n (x) n is the mean of the walls; of several tools the first has the layer, others find half a spacing.

   The pair forces of a step come before those of the tools: T is that of the next force point, ahead by its rate, and what the
   last prediction lacked. Friction acts at the center. Own construction. */
#ifndef TM_CONTACT_LAYER_H
#define TM_CONTACT_LAYER_H

#include "tm_fields.h"
#include "tm_layout.h"
#include "tm_tensor.h"

/* x_0 in compression and in extension; the thickest layer, over r; bound of x. */
#define TM_LAYER_LEAST 1.1
#define TM_LAYER_MOST 0.4
#define TM_LAYER_REACH 1.5 /* >= exp(TM_LAYER_MOST) */
#define TM_LAYER_BOUND 2.0

/* What takes the place of E in F15 (10) with penalty material, over 2 M: a spring that gives way like an eighth of a spacing,
   and limits the time step little. */
#define TM_LAYER_PENALTY 2.0
/* Acceleration of the surface by a force on it, over that of a particle: (3/2)^2 + (1/2)^2, the force and -1/2 of it act on the
   first and the second row of particles. */
#define TM_LAYER_MOBILITY 2.5
/* The force of damping c comes into T a step late: largest time step over m/c. Stable up to 0.25 was found, with springs of ten times the
   stiffness of the metal up to 0.18. */
#define TM_LAYER_DAMPED 0.15

/* Bodies of particles own layers too, by side: numbers above those of tools, which begin at 1. */
#define TM_LAYER_OF_BODIES 1e6

/* Of the column TM_L_NEAR: a tool was near in this step; counted down at its end, 0: forgotten. */
#define TM_LAYER_NOW 4.0

/* f at the normal strain x, and df/dx. */
TM_FN tm_real tm_layer_stretch(tm_real x, tm_real *slope)
{
  const tm_real q = x / (x < 0.0 ? TM_LAYER_LEAST : TM_LAYER_MOST), q4 = q * q * q * q;
  const tm_real root = 1.0 / sqrt(sqrt(1.0 + q4)), f = exp(x * root);
  *slope = f * root / (1.0 + q4);
  return f;
}

/* Whether x stays within its bound in a step. At the bound f is constant to a hundredth, and stays as it is until the strain
   turns. */
TM_FN int tm_layer_goes_on(tm_real x, tm_real step)
{
  const tm_real next = x + step;
  return next >= -TM_LAYER_BOUND && next <= TM_LAYER_BOUND;
}

/* The layer at a force point, half a step after `start`, of r between center and surface. In: *rate, that of the strain
   along the normal; 0 comes back where the layer is at its bound. */
TM_FN tm_real tm_layer_advance(tm_real start, tm_real r, tm_real dt, tm_real *rate, tm_real *strain, tm_real *arm)
{
  const int ends = !tm_layer_goes_on(start, dt * *rate);
  if (ends) *rate = 0.0;
  *strain = start + 0.5 * dt * *rate;
  const tm_real thickness = r * tm_layer_stretch(*strain, arm);
  *arm = ends ? 0.0 : r * *arm; /* no work in a layer that stays as it is */
  return thickness;
}

/* 1 or -1, by the side of an oblique plane on which the normal n lies; that of -n is the other. The layer keeps it as the
   sign of the number of its tool. */
TM_FN tm_real tm_layer_side(tm_vec3 n) { return n.x + 0.754877666 * n.y + 0.569840291 * n.z < 0.0 ? -1.0 : 1.0; }

/* Whether a surface of another tool, of normal n, lies on the other side of a particle that is pressed by the tool of its
   layer: no strain is between them. */
TM_FN int tm_layer_faces(const tm_real *row, tm_vec3 n)
{
  const tm_sym3 T = tm_sym_from_row(row + tm_column(TM_L_STRESS));
  const tm_real along = fabs(tm_vec_dot(n, tm_sym_mul_vec(T, n)));
  return tm_layer_side(n) * row[tm_column(TM_L_TOOL)] < 0.0 && along > 0.9 * fabs(tm_sym_trace(T));
}

/* T of the force point that comes, of a row of TM_F_LAYER; 0 where no tool was near in the last step. */
TM_FN tm_sym3 tm_layer_stress(const tm_real *row)
{
  return row[tm_column(TM_L_NEAR)] == TM_LAYER_NOW - 1.0 ? tm_sym_from_row(row + tm_column(TM_L_STRESS))
                                                         : tm_sym(0, 0, 0, 0, 0, 0);
}

/* The layer at the end of the step, and the stress of the next force point: now and next, f_n de/dx/V at this one and, as
   far as known, at that; in direction n (x) n; owner: number of its tool, with the sign of its side. What the last prediction
   lacks is given in the step that comes, so that nothing is missing in the sum. */
TM_FN void tm_layer_store(tm_real *row, tm_real now, tm_real next, tm_sym3 direction, tm_real strain, tm_real owner)
{
  tm_real *ahead = row + tm_column(TM_L_AHEAD);
  const tm_real owed = now - (row[tm_column(TM_L_NEAR)] == TM_LAYER_NOW - 1.0 ? *ahead : 0.0);
  *ahead = next;
  tm_sym_to_row(row + tm_column(TM_L_STRESS), tm_sym_scale(*ahead + owed, direction));
  row[tm_column(TM_L_STRAIN)] = strain;
  row[tm_column(TM_L_NEAR)] = TM_LAYER_NOW;
  row[tm_column(TM_L_TOOL)] = owner;
}

/* The end of a step: a tool that is no longer near is forgotten after some more. */
TM_FN void tm_layer_end_of_step(tm_real *row)
{
  tm_real *near = row + tm_column(TM_L_NEAR);
  if (*near > 0.0) *near -= 1.0;
}

#endif
