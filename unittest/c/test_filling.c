/* Spacing from the lattice sum of masses: lattices that are too wide or too dense, surfaces, bodies within the reach. */
#include "tm_filling.h"
#include "ut.h"

#include <string.h>

enum { SIDE = 15, ROOM = 2 * SIDE * SIDE * SIDE };
static double records[TM_REC * ROOM];
static int index_[ROOM], mechanical[1] = {0};
static ptrdiff_t first[1] = {0};

/* Particle 0 in the middle of n particles a side, s times the spacing of their masses apart; the others are its row. */
static tm_filling_args lattice(int kernel, int dim, double h, double s, int n)
{
  int count = 1;
  const int half = n / 2;
  memset(records, 0, sizeof records);
  for (int x = -half; x <= half; x++)
    for (int y = -half; y <= half; y++)
      for (int z = dim == 3 ? -half : 0; z <= (dim == 3 ? half : 0); z++) {
        const int i = x || y || z ? count++ : 0;
        double *r = records + TM_REC * (size_t) i;
        r[TM_REC_X] = s * x;
        r[TM_REC_X + 1] = s * y;
        r[TM_REC_X + 2] = s * z;
        r[TM_REC_M] = r[TM_REC_RHO] = 3.0;    /* volume 1 */
      }
  mechanical[0] = count - 1;
  for (int k = 0; k < count - 1; k++) index_[k] = k + 1;
  tm_filling_args a;
  memset(&a, 0, sizeof a);
  a.rows.index = index_;
  a.rows.first = first;
  a.rows.mechanical = mechanical;
  a.rows.stride = 1;
  a.rec.main = records;
  a.kernel = kernel;
  a.dim = dim;
  a.h = h;
  return a;
}

static void spacings(void)
{
  for (int kernel = 0; kernel < TM_KERNEL_COUNT; kernel++)
    for (int dim = 2; dim <= 3; dim++)
      for (int k = 0; k < 4; k++) {
        const double s[] = {0.8, 0.95, 1.0, 1.3};
        const tm_filling_args a = lattice(kernel, dim, 1.3, s[k], 11);
        const tm_filling f = tm_filling_around(0, &a);
        UT_NEAR(tm_filling_spacing(kernel, dim, 1.3, f.sum), s[k], 1e-9);
        UT_NEAR(f.sum, tm_filling_of_lattice(kernel, dim, 1.3, s[k]).sum, 1e-12);
        UT_NEAR(f.spread, tm_filling_of_lattice(kernel, dim, 1.3, s[k]).spread, 1e-12);
        UT_TRUE(f.inside);
      }
  /* the continuum */
  UT_NEAR(tm_filling_of_lattice(TM_KERNEL_QUINTIC, 3, 3.0, 1.0).sum, 1.0, 1e-6);
}

/* own size: the same sums at h of its record */
static void sizes(void)
{
  static double size[TM_REC_SIZE * ROOM];
  tm_filling_args a = lattice(TM_KERNEL_CUBIC, 2, 99.0, 1.0, 11);
  for (int i = 0; i < ROOM; i++) size[TM_REC_SIZE * i + TM_SIZE_INV_H] = 1.0 / 1.4;
  a.rec.size = size;
  UT_NEAR(tm_filling_around(0, &a).sum, tm_filling_of_lattice(TM_KERNEL_CUBIC, 2, 1.4, 1.0).sum, 1e-12);
}

/* without the half of the neighbors it is at a surface, with those of one direction alone it is in a thread */
static void surfaces(void)
{
  tm_filling_args a = lattice(TM_KERNEL_HYPERBOLIC, 2, 1.2, 1.0, 7);
  int n = 0;
  for (int k = 0; k < a.rows.mechanical[0]; k++)
    if (records[TM_REC * (size_t) index_[k]] <= 0.0) index_[n++] = index_[k];
  mechanical[0] = n;
  UT_TRUE(!tm_filling_around(0, &a).inside);
  a = lattice(TM_KERNEL_HYPERBOLIC, 2, 1.2, 1.0, 7);
  n = 0;
  for (int k = 0; k < a.rows.mechanical[0]; k++)
    if (records[TM_REC * (size_t) index_[k]] == 0.0) index_[n++] = index_[k];
  mechanical[0] = n;
  UT_TRUE(!tm_filling_around(0, &a).inside);
  /* a small body is even, but its spread is smaller than that of any lattice with its sum */
  a = lattice(TM_KERNEL_QUINTIC, 3, 2.2, 1.0, 5);
  const tm_filling f = tm_filling_around(0, &a);
  const double s = tm_filling_spacing(TM_KERNEL_QUINTIC, 3, 2.2, f.sum);
  UT_TRUE(f.inside && s > 1.05);
  UT_TRUE(f.spread < 0.9 * tm_filling_of_lattice(TM_KERNEL_QUINTIC, 3, 2.2, s).spread);
}

int main(void)
{
  spacings();
  sizes();
  surfaces();
  return ut_summary();
}
