/* Clouds and blocks of particles of several bodies for the tests of contact between bodies: state, rows by distance, one pass. */
#ifndef UT_BODIES_H
#define UT_BODIES_H

#include "tm_body_contact.h"
#include "ut.h"

#include <stdlib.h>
#include <string.h>

enum { MOST = 1400, TYPES = 3 };

static struct {
  int n, dim, type[MOST], mask[MOST], length[MOST], none[MOST];
  ptrdiff_t first[MOST];
  int *row;
  double main[MOST * TM_REC], heat[MOST * TM_REC_HEAT], size[MOST * TM_REC_SIZE], ahead[TM_AHEAD * MOST], source[MOST];
  double force[3 * MOST], sides[MOST * 2 * TM_BODY_SIDE];
  tm_body_law law[(TYPES + 1) * (TYPES + 1)];
  double layer[TM_L_COLUMNS * MOST], thin[TM_THIN * MOST], gradient[9 * MOST];
  int side[(TYPES + 1) * (TYPES + 1)], strains[TYPES + 1];
  double effusivity[TYPES + 1];
} s;
static tm_rates_args a;
static tm_body_contact_args b;

static double *rec(int i) { return s.main + (ptrdiff_t) i * TM_REC; }

static void begin(int dim)
{
  memset(&s, 0, sizeof s);
  memset(&a, 0, sizeof a);
  memset(&b, 0, sizeof b);
  s.dim = dim;
  a.rec.main = s.main;
  a.type = s.type;
  a.ntypes = TYPES;
  a.force = s.force;
  a.force_unit = 1.0;
  b.law = s.law;
  b.side = s.side;
  b.sides = 1;
  b.effusivity = s.effusivity;
  b.surface = tm_body_surface_make(dim, 2.4);
  b.spacing = 1.0;
  b.dt = 1e-9;
  b.sides_of = s.sides;
  b.ahead = s.ahead;
  b.mask = s.mask;
  for (int t = 1; t <= TYPES; t++) {
    s.effusivity[t] = t;
    for (int u = 1; u <= TYPES; u++) {
      s.law[t * (TYPES + 1) + u].modulus = tm_contact_modulus_of_two(100.0, 100.0);
      s.side[t * (TYPES + 1) + u] = t != u;
    }
  }
}

static void put(int type, double x, double y, double z)
{
  double *r = rec(s.n);
  r[0] = x;
  r[1] = y;
  r[2] = z;
  r[TM_REC_M] = 1.0;
  s.type[s.n++] = type;
}

static void all_rows(void)
{
  size_t room = 0;
  for (int pass = 0; pass < 2; pass++) {
    room = 0;
    for (int i = 0; i < s.n; i++) {
      s.first[i] = (ptrdiff_t) room;
      s.length[i] = 0;
      for (int j = 0; j < s.n; j++) {
        double r2 = 0;
        for (int d = 0; d < s.dim; d++) r2 += (rec(i)[d] - rec(j)[d]) * (rec(i)[d] - rec(j)[d]);
        if (i == j || s.type[i] == s.type[j] || r2 > 9.0) continue;
        if (pass) s.row[room] = j;
        s.length[i]++;
        room++;
      }
    }
    if (!pass) {
      free(s.row);
      s.row = (int *) malloc((room + 1) * sizeof(int));
    }
  }
  a.rows.index = s.row;
  a.rows.first = s.first;
  a.rows.stride = 1;
  a.rows.mechanical = a.rows.thermal = s.none;
  a.rows.contact = s.length;
}

static tm_body_contact_result run(void)
{
  const unsigned fx = s.dim == 3 ? (unsigned) TM_FX_3D : 0u;
  tm_body_contact_result sum = tm_body_contact_nothing();
  memset(s.force, 0, sizeof s.force);
  memset(s.source, 0, sizeof s.source);
  for (int i = 0; i < s.n; i++)
    for (int d = 0; d < 3; d++) s.ahead[TM_AHEAD * i + d] = rec(i)[TM_REC_V + d];
  for (int i = 0; b.thin && i < s.n; i++) tm_body_thin(i, &a, &b, fx);
  for (int i = 0; i < s.n; i++) {
    const tm_body_contact_result r = tm_body_touch(i, &a, &b, fx);
    tm_body_contact_sum(&sum, &r);
  }
  for (int i = 0; i < s.n; i++) {
    const tm_body_contact_result r = tm_body_contact(i, &a, &b, fx);
    tm_body_contact_sum(&sum, &r);
  }
  return sum;
}
/* two blocks that touch and overlap, with noise, all moving */
static void cloud(int dim)
{
  const int side = dim == 3 ? 5 : 9;
  for (int t = 1; t <= 2; t++)
    for (int p = 0; p < side; p++)
      for (int q = 0; q < side; q++)
        for (int l = 0; l < (dim == 3 ? 3 : 1); l++) {
          const double y = t == 1 ? -q : q + 0.9;
          put(t, p + 0.3 * t + 0.1 * ut_random(-1, 1), y + 0.1 * ut_random(-1, 1),
              dim == 3 ? l + 0.05 * ut_random(-1, 1) : 0);
          double *r = rec(s.n - 1);
          for (int d = 0; d < dim; d++) r[TM_REC_V + d] = ut_random(-1, 1);
          r[TM_REC_M] = ut_random(0.5, 2.0);
          s.size[(s.n - 1) * TM_REC_SIZE + TM_SIZE_DP] = ut_random(0.8, 1.2);
        }
}

#endif
