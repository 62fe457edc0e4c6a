/* Numerical fracture: lattices that are stretched, sheared, turned and slip past each other are whole; a crack is seen on
   both of its faces, and where a neighbor has failed it is not. */
#include "tm_fracture.h"
#include "ut_state.h"

enum { SIDE = 12, MOST = SIDE * SIDE * SIDE };

static double x0[3 * MOST], rho[MOST], field[TM_R_COLUMNS * MOST], damage[2 * MOST], main_record[TM_REC * MOST];
static double known[TM_FRACTURE_KNOWN * MOST];
static int type[MOST], tag[MOST], mechanical[MOST], none[MOST], *rows;
static ptrdiff_t first[MOST];
static int n;
static const double H = 1.2;

static tm_fracture_args make(int dim)
{
  tm_fracture_args a;
  memset(&a, 0, sizeof a);
  memset(field, 0, sizeof field);
  memset(damage, 0, sizeof damage);
  n = 0;
  for (int i = 0; i < SIDE; i++)
    for (int j = 0; j < SIDE; j++)
      for (int k = 0; k < (dim == 3 ? SIDE : 1); k++, n++) {
        x0[3 * n] = i; x0[3 * n + 1] = j; x0[3 * n + 2] = k;
        tag[n] = n + 1;
        type[n] = 1;
      }
  a.state.field[TM_F_FRACTURE] = field;
  a.state.field[TM_F_DAMAGE] = damage;
  a.state.field[TM_F_RHO] = rho;
  a.state.type = type;
  a.rec.main = main_record;
  a.tag = tag;
  a.known = known;
  a.spacing = 1.0;
  a.h = H;
  a.support = 2.0;
  a.dim3 = dim == 3;
  a.rows.mechanical = mechanical;
  a.rows.thermal = a.rows.contact = none;
  a.rows.first = first;
  a.rows.stride = 1;
  return a;
}

/* rows of all that are within 1.2 support radii, and the records */
static void place(tm_fracture_args *a, const double *x)
{
  static int index[MOST * 400];
  ptrdiff_t used = 0;
  for (int i = 0; i < n; i++) {
    for (int d = 0; d < 3; d++) main_record[TM_REC * i + d] = x[3 * i + d];
    first[i] = used;
    mechanical[i] = 0;
    for (int j = 0; j < n; j++) {
      double r2 = 0.0;
      for (int d = 0; d < 3; d++) r2 += (x[3 * i + d] - x[3 * j + d]) * (x[3 * i + d] - x[3 * j + d]);
      if (j == i || r2 > 1.44 * 4.0 * H * H) continue;
      index[used++] = j;
      mechanical[i]++;
    }
  }
  rows = index;
  a->rows.index = rows;
}

static void refer(tm_fracture_args *a)
{
  place(a, x0);
  for (int i = 0; i < n; i++) {
    UT_TRUE(tm_fracture_is_unknown(i, a) == 1.0);
    tm_fracture_refer(i, a);
  }
  for (int i = 0; i < n; i++) tm_fracture_tell(i, a);
  for (int i = 0; i < n; i++) tm_fracture_bonds(i, a);
}

static tm_fracture_result look(tm_fracture_args *a)
{
  tm_fracture_result sum = tm_fracture_nothing();
  for (int i = 0; i < n; i++) tm_fracture_tell(i, a);
  for (int i = 0; i < n; i++) tm_fracture_normal(i, a);
  for (int i = 0; i < n; i++) {
    const tm_fracture_result r = tm_fracture_look(i, a);
    tm_fracture_sum(&sum, &r);
  }
  return sum;
}

/* positions by a matrix and a displacement of those above a plane, with disorder */
static tm_fracture_result moved(int dim, const double *F, double above, double dx, double dy, double disorder)
{
  static double x[3 * MOST];
  tm_fracture_args a = make(dim);
  refer(&a);
  for (int i = 0; i < n; i++) {
    for (int d = 0; d < dim; d++) {
      x[3 * i + d] = disorder * ut_random(-1, 1);
      for (int e = 0; e < 3; e++) x[3 * i + d] += F[3 * d + e] * x0[3 * i + e];
    }
    if (x0[3 * i + 1] > above) {
      x[3 * i] += dx;
      x[3 * i + 1] += dy;
    }
  }
  place(&a, x);
  return look(&a);
}

int main(void)
{
  const double one[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, stretch[9] = {1.6, 0, 0, 0, 0.7, 0, 0, 0, 0.8};
  const double far[9] = {2.3, 0, 0, 0, 0.45, 0, 0, 0, 1}, shear[9] = {1, 1.5, 0, 0, 1, 0, 0, 0, 1};
  const double turn[9] = {0, -1.1, 0, 0.9, 0, 0, 0, 0, 1}, flat[9] = {1.8, 0, 0, 0, 0.31, 0, 0, 0, 1.8};
  for (int dim = 2; dim <= 3; dim++) {
    const double *whole[6] = {one, stretch, far, shear, turn, flat};
    for (int k = 0; k < 6; k++) {
      const tm_fracture_result r = moved(dim, whole[k], 1e9, 0, 0, k == 2 ? 0.03 : 0.08);    /* 2.3: the support ends at 2.4 */
      UT_TRUE(r.torn == 0.0 && r.first == INT_MAX && r.met == 0.0 && r.first_met == INT_MAX);
    }
    for (double slip = 0.5; slip < 6; slip += 0.5) UT_TRUE(moved(dim, one, 5.5, slip, 0, 0.05).torn <= 2.0 * (dim == 3 ? SIDE : 1) * ceil(slip));
    const double face = dim == 3 ? SIDE * SIDE : SIDE;
    UT_TRUE(moved(dim, one, 5.5, 0, 1.0, 0.05).torn == 0.0);               /* neighbors still meet across it */
    UT_NEAR(moved(dim, one, 5.5, 0, 1.7, 0.0).torn, 2.0 * face, 1e-15);    /* they do not */
    UT_NEAR(moved(dim, one, 5.5, 0.3, 3.0, 0.02).torn, 2.0 * face, 1e-15);
    UT_TRUE(moved(dim, one, 5.5, 0.3, 3.0, 0.1).torn > 1.8 * face);
    const double longer[9] = {1, 0, 0, 0, 1.3, 0, 0, 0, 1};
    UT_NEAR(moved(dim, longer, 5.5, 0, 3.0, 0.0).torn, 2.0 * face, 1e-15);
  }
  /* two parts of one body that come together, or begin so near that they act on each other */
  for (int dim = 2; dim <= 3; dim++) {
    static double apart[3 * MOST], x[3 * MOST];
    const double face = dim == 3 ? SIDE * SIDE : SIDE;
    for (double way = 0.1; way < 9.0; way += 2.0)
      for (double gap = 1.0; gap < 3.1; gap += 0.5) {
        tm_fracture_args a = make(dim);
        memcpy(apart, x0, sizeof apart);
        memcpy(x, x0, sizeof x);
        for (int i = 0; i < n; i++) {
          apart[3 * i + 1] += x0[3 * i + 1] > 5.5 ? gap - 1.0 + way : 0.0;
          x[3 * i + 1] += x0[3 * i + 1] > 5.5 ? gap - 1.0 : 0.0;
        }
        memcpy(x0, apart, sizeof apart);
        refer(&a);
        for (int t = 0; t < 2; t++) { /* turned, too */
          if (t)
            for (int i = 0; i < n; i++) {
              const double s = x[3 * i];
              x[3 * i] = -x[3 * i + 1];
              x[3 * i + 1] = s;
            }
          place(&a, x);
          const tm_fracture_result r = look(&a);
          const int meets = gap + way > 1.5 && gap < 2.0 * H;
          const double inner = dim == 3 ? (SIDE - 4) * (SIDE - 4) : SIDE - 4; /* without edges: normals beside them are askew */
          UT_TRUE(meets ? r.met >= 2.0 * inner && r.met <= 2.0 * face : r.met == 0.0);
          UT_TRUE((r.first_met < INT_MAX) == meets);
        }
      }
  }
  /* a row of holes inside has no faces, though as many bonds are missing there */
  {
    tm_fracture_args a = make(3);
    const double y = SIDE / 2, z = SIDE / 2;
    double lost = 0.0;
    for (int i = 0; i < n; i++)
      if (x0[3 * i + 1] == y && x0[3 * i + 2] == z) x0[3 * i + 1] += 40.0;
    refer(&a);
    for (int i = 0; i < n; i++)
      if (x0[3 * i + 1] == y + 1.0 && x0[3 * i + 2] == z) lost = fmax(lost, tm_vec_norm(tm_fracture_inward(i, &a)));
    UT_TRUE(lost >= TM_FRACTURE_LOSS_3D);
    UT_TRUE(look(&a).met == 0.0);
  }
  /* failed neighbors, said once, one alone, across a periodic boundary */
  tm_fracture_args a = make(2);
  double x[3 * MOST];
  refer(&a);
  for (int i = 0; i < n; i++)
    for (int d = 0; d < 3; d++) x[3 * i + d] = x0[3 * i + d] + (d == 1 && x0[3 * i + 1] > 5.5 ? 3.0 : 0.0);
  for (int i = 0; i < n; i++)
    if (x0[3 * i + 1] == 6.0) damage[2 * i + 1] = 1.0;
  place(&a, x0);
  UT_TRUE(look(&a).torn == 0.0);
  place(&a, x);
  tm_fracture_result r = look(&a);
  UT_TRUE(r.torn == 0.0);                              /* all at the crack had failed neighbors before it opened */
  a = make(2);
  refer(&a);
  place(&a, x);
  r = look(&a);
  UT_TRUE(r.torn == 2.0 * SIDE && r.first == 6);
  r = look(&a);
  UT_TRUE(r.torn == 2.0 * SIDE && r.first == INT_MAX); /* known by now */
  a = make(2);
  refer(&a);
  memcpy(x, x0, sizeof x);
  x[3 * 77] += 40.0;
  place(&a, x);
  look(&a);
  UT_TRUE(tm_fracture_is_torn(77, &a) == 1.0);
  a = make(2);
  a.period[1] = SIDE;
  refer(&a);
  memcpy(x, x0, sizeof x);
  for (int i = 0; i < n; i++) x[3 * i + 1] += SIDE;
  place(&a, x);
  UT_TRUE(look(&a).torn == 0.0);
  known[1] = 0.0;
  known[TM_FRACTURE_KNOWN + 1] = SIDE - 1.0;
  UT_NEAR(tm_fracture_bond(0, 1, &a).y, -1.0, 1e-15);
  return ut_summary();
}
