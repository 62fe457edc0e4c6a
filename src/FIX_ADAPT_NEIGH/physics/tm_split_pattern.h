/* SPH-TM: how one particle becomes several, S13 section 4 (Feldman 2006; Vacondio et al. 2012).

   A pattern is a set of places around the parent, symmetric about it, so that a split with equal
   velocities keeps linear and angular momentum and kinetic energy. Masses lambda_j m, sum 1, are those
   that change the smoothed density least, S13 (6) to (9): least of C - 2 l.b + l.A l with
     C    = integral of W(x, h)^2
     b_s  = integral of W(x, h) W(x - d_s, alpha h)
     A_rs = integral of W(x - d_r, alpha h) W(x - d_s, alpha h)
   which gives A l = b + mu 1. All lengths are in h of the parent and the answer serves any m and h:
   solved once per pattern, on the host. */
#ifndef TM_SPLIT_PATTERN_H
#define TM_SPLIT_PATTERN_H

#include "tm_kernel.h"

enum tm_split_kind {
  TM_SPLIT_SQUARE = 0,  /* 2D: 4 on the corners of a square of edge epsilon */
  TM_SPLIT_HEXAGON,     /* 2D: 6 at distance epsilon and the center */
  TM_SPLIT_CUBE,        /* 3D: 8 on the corners of a cube of edge epsilon */
  TM_SPLIT_CUBE_CENTRE, /* the same and the center */
  TM_SPLIT_ICOSAHEDRON, /* 3D: 12 at distance epsilon and the center */
  TM_SPLIT_KINDS
};
enum { TM_SPLIT_MOST = 13 };
#define TM_SPLIT_LEAST 1e-6 /* a smaller share of the mass is none: alpha 1 leaves it all in the center */

enum tm_split_status {
  TM_SPLIT_OK = 0,
  TM_SPLIT_BAD_INPUT, /* unknown kind or kernel, epsilon or alpha not positive */
  TM_SPLIT_SINGULAR,  /* children so close that masses are not determined */
  TM_SPLIT_NEGATIVE   /* a child would get no or a negative mass */
};

typedef struct {
  int kind, dim, n;           /* n children; a center, where there is one, is the first */
  double epsilon, alpha;      /* edge or distance in h of the parent; h of a child over it */
  double x[TM_SPLIT_MOST][3]; /* places about the parent, in its h */
  double mass[TM_SPLIT_MOST]; /* shares of its mass, sum 1 */
  double error;               /* S13 (8): sqrt of the least value over C */
} tm_split_pattern;

#ifdef __cplusplus
extern "C" {
#endif

/* Name as written in input: square, hexagon, cube, cube/centre, icosahedron; NULL beyond. */
const char *tm_split_name(int kind);
int tm_split_dim(int kind); /* 2 or 3; 0 for an unknown kind */

/* Integral over space of W(x, 1) W(x - d, alpha), dim 2 or 3, to about 1e-11 of its value at d = 0. */
double tm_kernel_overlap(int kernel, int dim, double alpha, double d);

/* Fills *p. After TM_SPLIT_NEGATIVE the masses are those found, so that a message can name them. */
int tm_split_make(int kind, int kernel, double epsilon, double alpha, tm_split_pattern *p);

#ifdef __cplusplus
}
#endif
#endif
