/* Interpolation of a split and the sums of a merge: linear fields exactly, bounds, conservation, a family back into
   its parent. */
#include "tm_refine.h"
#include "tm_split_pattern.h"
#include "ut.h"

enum { A = TM_CLOUD_STATE, B, S, COLUMNS = S + 6, MOST = 400 };

static tm_real rows[MOST * COLUMNS];
static int near[MOST];

static double noise(unsigned *seed)
{
  *seed = *seed * 1664525u + 1013904223u;
  return (*seed >> 8) / 16777216.0 - 0.5;
}

/* a disturbed lattice about the origin, particle 0 in its middle; returns how many */
static int lattice(int dim, double amount, tm_cloud *c)
{
  unsigned seed = 7;
  int n = 1;
  const int nz = dim == 3 ? 2 : 0;
  for (int k = 0; k < MOST * COLUMNS; k++) rows[k] = 0.0;
  for (int x = -2; x <= 2; x++)
    for (int y = -2; y <= 2; y++)
      for (int z = -nz; z <= nz; z++) {
        if (!x && !y && !z) continue;
        tm_real *r = rows + (ptrdiff_t) n * COLUMNS;
        r[0] = x + amount * noise(&seed);
        r[1] = y + amount * noise(&seed);
        r[2] = dim == 3 ? z + amount * noise(&seed) : 0.0;
        r[TM_CLOUD_VOLUME] = 1.0 + 0.5 * noise(&seed);
        r[TM_CLOUD_MASS] = 2.0 * r[TM_CLOUD_VOLUME];
        near[n - 1] = n;
        n++;
      }
  rows[TM_CLOUD_VOLUME] = 1.0;
  rows[TM_CLOUD_MASS] = 2.0;
  c->row = rows;
  c->width = COLUMNS;
  c->kernel = TM_KERNEL_HYPERBOLIC;
  c->dim = dim;
  return n;
}

static double linear(const tm_real *r) { return 3.0 + 0.7 * r[0] - 0.4 * r[1] + 0.3 * r[2]; }

static void test_dimension(int dim, int kind)
{
  tm_cloud c;
  tm_split_pattern p;
  const int n = lattice(dim, 0.3, &c);
  const double h = 1.2;
  unsigned seed = 3;
  tm_sym3 inverse;
  UT_TRUE(tm_split_make(kind, c.kernel, 0.6, 0.9, &p) == TM_SPLIT_OK);
  UT_TRUE(tm_cloud_moments(&c, 0, near, n - 1, h, &inverse) == 1);
  for (int j = 0; j < n; j++) {
    tm_real *r = rows + (ptrdiff_t) j * COLUMNS;
    r[A] = linear(r);
    r[B] = noise(&seed);
    for (int k = 0; k < 6; k++) r[S + k] = noise(&seed);
    r[S + 2] = -r[S] - r[S + 1];
  }
  const tm_slope a = tm_cloud_slope(&c, 0, near, n - 1, h, &inverse, A);
  UT_NEAR(a.gradient.x, 0.7, 1e-12);
  UT_NEAR(a.gradient.y, -0.4, 1e-12);
  UT_WITHIN(a.gradient.z, dim == 3 ? 0.3 : 0.0, 1e-12);

  tm_real child[TM_SPLIT_MOST * COLUMNS];
  for (int k = 0; k < p.n; k++)
    for (int m = 0; m < COLUMNS; m++) child[k * COLUMNS + m] = rows[m];
  tm_cloud_spread(&c, 0, near, n - 1, h, &inverse, A, 1, &p.x[0][0], p.n, h, child);
  tm_cloud_spread(&c, 0, near, n - 1, h, &inverse, B, 1, &p.x[0][0], p.n, h, child);
  tm_cloud_spread(&c, 0, near, n - 1, h, &inverse, S, 6, &p.x[0][0], p.n, h, child);
  double mean_a = 0.0, mean_b = 0.0;
  const tm_slope b = tm_cloud_slope(&c, 0, near, n - 1, h, &inverse, B);
  for (int k = 0; k < p.n; k++) {
    tm_real *r = child + k * COLUMNS;
    for (int m = 0; m < 3; m++) r[m] = h * p.x[k][m];
    r[TM_CLOUD_MASS] *= p.mass[k];
    r[TM_CLOUD_VOLUME] *= p.mass[k];
    UT_NEAR(r[A], linear(r), 1e-12);       /* far enough from the bounds */
    UT_TRUE(r[B] >= b.least && r[B] <= b.most);
    UT_WITHIN(r[S] + r[S + 1] + r[S + 2], 0.0, 1e-14);    /* a deviator stays one */
    mean_a += p.mass[k] * r[A];
    mean_b += p.mass[k] * r[B];
  }
  UT_NEAR(mean_a, rows[A], 1e-13);
  UT_WITHIN(mean_b, rows[B], 1e-14);

  /* and back: mass, place, volume and means are the parent's; stress over volume, shares of which are those of mass */
  const tm_real *member[TM_SPLIT_MOST] = {child};
  tm_real back[COLUMNS];
  for (int k = 0; k < p.n; k++) member[k] = child + k * COLUMNS;
  UT_WITHIN(tm_cloud_merge(member, p.n, COLUMNS, back), 0.0, 1e-30);
  tm_cloud_volume_mean(member, p.n, S, 6, back);
  for (int m = 0; m < COLUMNS; m++)
    if (m < TM_CLOUD_MARK || m >= A) UT_WITHIN(back[m], rows[m], 1e-14);
}

int main(void)
{
  test_dimension(2, TM_SPLIT_SQUARE);
  test_dimension(2, TM_SPLIT_HEXAGON);
  test_dimension(3, TM_SPLIT_CUBE);
  test_dimension(3, TM_SPLIT_ICOSAHEDRON);

  /* a peak stays where it is: no child is above it, and so none is below its mean */
  tm_cloud c;
  tm_sym3 inverse;
  int n = lattice(2, 0.3, &c);
  tm_split_pattern p;
  tm_split_make(TM_SPLIT_SQUARE, c.kernel, 0.4, 0.9, &p);
  rows[A] = 1.0;
  tm_real child[TM_SPLIT_MOST * COLUMNS];
  for (int k = 0; k < p.n; k++)
    for (int m = 0; m < COLUMNS; m++) child[k * COLUMNS + m] = rows[m];
  UT_TRUE(tm_cloud_moments(&c, 0, near, n - 1, 1.2, &inverse));
  tm_cloud_spread(&c, 0, near, n - 1, 1.2, &inverse, A, 1, &p.x[0][0], p.n, 1.2, child);
  for (int k = 0; k < p.n; k++) UT_TRUE(child[k * COLUMNS + A] == 1.0);

  /* alone, or in a row: the parent's value, no gradient */
  UT_TRUE(tm_cloud_moments(&c, 0, near, 0, 1.2, &inverse) == 0);
  UT_TRUE(tm_vec_norm(tm_cloud_slope(&c, 0, near, 0, 1.2, &inverse, A).gradient) == 0.0);
  for (int k = 0; k < 4; k++) {
    rows[(k + 1) * COLUMNS] = (k - 1.5) * 0.5;
    rows[(k + 1) * COLUMNS + 1] = (k - 1.5) * 0.25;
  }
  UT_TRUE(tm_cloud_moments(&c, 0, near, 4, 1.2, &inverse) == 0);
  UT_TRUE(tm_vec_norm(tm_cloud_slope(&c, 0, near, 4, 1.2, &inverse, A).gradient) == 0.0);

  /* two that collide: momentum stays, the energy of their motion is reported */
  for (int k = 0; k < 2 * COLUMNS; k++) rows[k] = 0.0;
  const tm_real *pair[2] = {rows, rows + COLUMNS};
  rows[TM_CLOUD_MASS] = 1.0;
  rows[COLUMNS + TM_CLOUD_MASS] = 3.0;
  rows[TM_CLOUD_VOLUME] = rows[COLUMNS + TM_CLOUD_VOLUME] = 1.0;
  rows[TM_CLOUD_V] = 4.0;
  rows[COLUMNS] = 2.0;
  rows[S] = 5.0;
  rows[A] = 5.0;
  tm_real out[COLUMNS];
  const double lost = tm_cloud_merge(pair, 2, COLUMNS, out);
  tm_cloud_volume_mean(pair, 2, S, 6, out);
  UT_NEAR(out[TM_CLOUD_MASS], 4.0, 1e-15);
  UT_NEAR(out[TM_CLOUD_VOLUME], 2.0, 1e-15);
  UT_NEAR(out[TM_CLOUD_X], 1.5, 1e-15);
  UT_NEAR(out[TM_CLOUD_V], 1.0, 1e-15);
  UT_NEAR(out[A], 1.25, 1e-15);
  UT_NEAR(out[S], 2.5, 1e-15);
  UT_NEAR(lost, 0.5 * 16.0 - 0.5 * 4.0, 1e-15);
  tm_content change = tm_content_nothing();
  tm_content_add(&change, 1.0, 4.0, tm_vec(1.5, 0, 0), tm_vec(1, 0, 0), 0.0);
  tm_content_add(&change, -1.0, 1.0, tm_vec(0, 0, 0), tm_vec(4, 0, 0), 1.0);
  tm_content_add(&change, -1.0, 3.0, tm_vec(2, 0, 0), tm_vec(0, 0, 0), 0.5);
  UT_WITHIN(change.mass, 0.0, 1e-15);
  UT_WITHIN(tm_vec_norm(change.momentum), 0.0, 1e-15);
  UT_NEAR(change.kinetic, -lost, 1e-15);
  UT_NEAR(change.elastic, -1.5, 1e-15);
  return ut_summary();
}
