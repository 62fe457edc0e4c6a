/* SPH-TM: super time stepping of heat conduction by the Runge-Kutta-Legendre scheme of second order, RKL2.

   Meyer, Balsara, Aslam, J. Comput. Phys. 257 (2014) 594, eqs. (16) to (18). dT/dt = M(T) + P over dt in s stages:
     Y_0 = T,  Y_1 = Y_0 + mu~_1 dt M(Y_0),
     Y_j = mu_j Y_(j-1) + nu_j Y_(j-2) + (1 - mu_j - nu_j) Y_0 + mu~_j dt M(Y_(j-1)) + gamma~_j dt M(Y_0)
   with b_0 = b_1 = b_2 = 1/3, b_j = (j^2 + j - 2)/(2 j (j + 1)), a_j = 1 - b_j, w_1 = 4/(s^2 + s - 2).
   A mode that decays at the rate lambda is multiplied in each step by
     R_s(z) = a_s + b_s P_s(1 + w_1 z),  z = -lambda dt,  P_s the Legendre polynomial,
   which is positive and below 1 for lambda dt <= (s^2 + s - 2)/2: s stages take a step s/4 times as long as s steps of
   Euler's scheme would. c_j dt is the time of stage j. Stages are odd in number: with an even one R_s is small at the
   end of its range only. */
#ifndef TM_RKL_H
#define TM_RKL_H

#include "tm_real.h"

typedef struct {
  tm_real mu, nu;        /* of the last stage and the one before it */
  tm_real mu_t, gamma_t; /* of dt M(Y_(j-1)) and dt M(Y_0) */
} tm_rkl;

/* The least odd number of stages that is stable for z = lambda dt, at least 3. */
TM_FN int tm_rkl_stages(tm_real z)
{
  const int s = (int) ceil(0.5 * (sqrt(9.0 + 8.0 * z) - 1.0));
  return s < 3 ? 3 : s | 1;
}

/* The largest stable lambda dt of s stages. */
TM_FN tm_real tm_rkl_range(int s) { return 0.5 * ((tm_real) s * s + s - 2.0); }

TM_FN tm_real tm_rkl_b(int j) { return j < 2 ? 1.0 / 3.0 : ((tm_real) j * j + j - 2.0) / (2.0 * j * (j + 1.0)); }

/* Coefficients of stage j of s. */
TM_FN tm_rkl tm_rkl_stage(int j, int s)
{
  const tm_real w1 = 2.0 / tm_rkl_range(s), b = tm_rkl_b(j);
  tm_rkl c;
  c.mu = c.nu = c.gamma_t = 0.0;
  if (j < 2) {
    c.mu_t = b * w1;
    return c;
  }
  c.mu = (2.0 * j - 1.0) / j * b / tm_rkl_b(j - 1);
  c.nu = -(j - 1.0) / j * b / tm_rkl_b(j - 2);
  c.mu_t = c.mu * w1;
  c.gamma_t = -(1.0 - tm_rkl_b(j - 1)) * c.mu_t;
  return c;
}

/* Time of stage j of s, as a share of the step. */
TM_FN tm_real tm_rkl_time(int j, int s)
{
  if (j < 1) return 0.0;
  return j == 1 ? 2.0 / (3.0 * tm_rkl_range(s)) : tm_rkl_range(j) / tm_rkl_range(s);
}

#endif
